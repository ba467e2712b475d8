// A circle three ways: its pixels alone, its steps watched by a lambda, one step as a figure.
// Writes bresenham_circle.svg into the current folder.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // The pixels alone
  bresenham_circle::decision_parameter({0, 0}, 8, [](ivec2 p) { fmt::print("({}, {}) ", p.x, p.y); });
  fmt::print("\n");

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, bresenham_circle::Stepped>) fmt::print("p = {}\n", step.p);
  };
  bresenham_circle::decision_parameter({0, 0}, 8, [](ivec2) {}, watch);

  // Step 4 as a figure
  const Trace trace = trace_of(*find_entry("bresenham_circle"), {{"center", "0,0"}, {"radius", "8"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/scan_conversion/bresenham_circle", ""};
  std::ofstream("bresenham_circle.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
