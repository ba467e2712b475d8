// A line without stairs three ways: its pixels alone, its steps watched by a lambda, one step as a figure.
// Writes antialiased_line.svg into the current folder.

#include "scan_conversion/antialiased_line/antialiased_line.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // The pixels alone, with their intensities
  antialiased_line::wu({0, 0}, {7, 3},
                       [](ivec2 p, int intensity) { fmt::print("({}, {}) {} ", p.x, p.y, intensity); });
  fmt::print("\n");

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, antialiased_line::Cut>)
      fmt::print("({}, {}) area {:.4f}\n", step.pixel.x, step.pixel.y, step.area);
  };
  antialiased_line::exact_area({0, 0}, {4, 3}, [](ivec2, double) {}, watch);

  // Step 3 as a figure
  const Trace trace = trace_of(*find_entry("antialiased_line"), {{"from", "0,0"}, {"to", "7,3"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/scan_conversion/antialiased_line", ""};
  std::ofstream("antialiased_line.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
