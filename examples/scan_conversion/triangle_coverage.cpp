// A triangle's pixels three ways: as text, with the values of its edge functions, a step as a figure.
// Writes triangle_coverage.svg into the current folder.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::triangle_coverage;

  // The pixels alone
  const Triangle triangle{snap({1, 3}), snap({4, 1}), snap({2, 5})};
  const Window window{{0, 0}, {5, 5}};
  std::string picture(36, '.');
  cover(triangle, window,
        [&](ivec2 p, const Weights&) { picture[static_cast<std::size_t>(6 * p.y + p.x)] = '#'; });
  for (std::size_t row = 0; row < 6; ++row) fmt::print("{}\n", picture.substr(6 * row, 6));

  // The edge functions where they decide, as the walk reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Tested>) {
      const dvec3 shares = barycentric(step.weights);
      fmt::print("({}, {}): {} {:.3f} {:.3f} {:.3f}\n", step.pixel.x, step.pixel.y,
                 step.covered ? "covered " : "left out", shares.x, shares.y, shares.z);
    }
  };
  cover(triangle, window, [](ivec2, const Weights&) {}, watch);

  // The step that covers the last pixel as a figure
  const TopicEntry& topic = *find_entry("triangle_coverage");
  const Trace trace = trace_of(topic, {{"triangles", "1,3 4,1 2,5"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/scan_conversion/triangle_coverage", ""};
  std::ofstream file("triangle_coverage.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
