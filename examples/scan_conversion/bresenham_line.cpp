// A line three ways: its pixels alone, its steps watched by a lambda, one step as a figure.
// Writes bresenham_line.svg into the current folder.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // The pixels alone
  bresenham_line::decision_parameter({0, 0}, {7, 3}, [](ivec2 p) { fmt::print("({}, {}) ", p.x, p.y); });
  fmt::print("\n");

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, bresenham_line::Stepped>) fmt::print("p = {}\n", step.p);
  };
  bresenham_line::decision_parameter({0, 0}, {7, 3}, [](ivec2) {}, watch);

  // Step 4 as a figure
  const Trace trace = trace_of(*find_entry("bresenham_line"), {{"from", "0,0"}, {"to", "7,3"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/scan_conversion/bresenham_line", ""};
  std::ofstream("bresenham_line.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
