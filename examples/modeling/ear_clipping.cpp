// Ear clipping three ways: a polygon's triangles, its tests watched, one with a hole as a figure.
// Writes ear_clipping.svg into the current folder.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <fmt/core.h>

#include <fstream>
#include <span>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "core/geometry.hpp"
#include "figure/figure.hpp"
#include "modeling/ear_clipping/join_holes.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::ear_clipping;
  const auto print = [](const Triangle& t) { fmt::print("{} {} {}\n", t[0], t[1], t[2]); };

  // An arrowhead, and which of its corners are ears
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Tested>) fmt::print("corner {}: ear {}\n", step.corner, step.ear);
  };
  triangulate({{0, 0}, {4, 2}, {0, 4}, {1, 2}}, print, watch);

  // A square with a triangular hole
  const std::vector<dvec2> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {5, 4}, {3, 6}};
  triangulate_with_holes(std::span<const dvec2>(points), faces_of({{0, 1, 2, 3}, {4, 5, 6}}), print);

  // Its bridge as a figure
  const Trace trace = trace_of(*find_entry("ear_clipping"),
                               {{"method", "join_holes"}, {"rings", "0,0 8,0 8,8 0,8; 2,2 5,4 3,6"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/ear_clipping", ""};
  std::ofstream file("ear_clipping.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
