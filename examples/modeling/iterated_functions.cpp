// FILL IN: what is shown three ways. Until then a walk: its pixels alone, its steps watched by a lambda, one
// step as a figure.
// Writes iterated_functions.svg into the current folder.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::iterated_functions;

  // The pixels alone
  walk({0, 0}, {5, 2}, [](ivec2 p) { fmt::print("({}, {}) ", p.x, p.y); });
  fmt::print("\n");

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Stepped>) fmt::print("column reached: {}\n", step.column_reached);
  };
  walk({0, 0}, {5, 2}, [](ivec2) {}, watch);

  // Step 4 as a figure
  const TopicEntry& topic = *find_entry("iterated_functions");
  const Trace trace = trace_of(topic, {{"columns", "5"}, {"rows", "2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const std::string source = "examples/modeling/iterated_functions";
  const Colophon colophon{figure.title, caption_of(figure), source, ""};
  std::ofstream file("iterated_functions.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
