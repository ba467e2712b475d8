// Exact areas three ways: a triangle's pixels as bytes, what is seen of two triangles, a step as a figure.
// Writes area_sampling.svg into the current folder.

#include "antialiasing/area_sampling/area_sampling.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::area_sampling;
  using triangle_coverage::snap;

  // One triangle, pixel by pixel
  const std::vector<ivec2> corners{snap({1, 3}), snap({4, 1}), snap({2, 5})};
  pixel_areas(corners, {{0, 0}, {5, 5}},
              [](ivec2 p, double area) { fmt::print("({}, {}): {:.4f}\n", p.x, p.y, area); });

  // Two of them, the second before the first: grey 0.2 and 0.9, weighted by what is seen
  const std::vector<ScreenTriangle> triangles{{{snap({0, 0}), snap({3, 0}), snap({0, 3})}, dvec3(2)},
                                              {{snap({0.5, 0.5}), snap({3, 1}), snap({1, 3})}, dvec3(1)}};
  const auto grey = [](int triangle, ivec2, const Weights&) { return triangle == 0 ? 0.2 : 0.9; };
  visible_areas(triangles, {{0, 0}, {2, 2}}, grey, [](ivec2 p, double sum, double covered) {
    fmt::print("({}, {}): {:.4f} of {:.4f}\n", p.x, p.y, sum, covered);
  });

  // The pixel with most corners as a figure
  const TopicEntry& topic = *find_entry("area_sampling");
  const Trace trace = trace_of(topic, {});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/antialiasing/area_sampling", ""};
  std::ofstream file("area_sampling.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
