// Koch's snowflake three ways: its corners on the lattice, a text that walks the same, a step as a figure.
// Writes fractal_curve.svg into the current folder.

#include "modeling/fractal_curve/fractal_curve.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "modeling/fractal_curve/l_system.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::fractal_curve;

  // What each level has
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, LevelDone>)
      fmt::print("level {}: {} segments, area {}/{}\n", step.level, step.segments, step.triangles,
                 power(9, step.level));
  };
  koch(base_of(fractal_curve::Shape::snowflake), 5, watch);

  // A side of it as a text
  fmt::print("{}\n", rewrite("F", koch_system.rules, 2));

  // The sixth segment of level 1 gives way: a figure
  const Trace trace = trace_of(*find_entry("fractal_curve"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {10, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/fractal_curve", ""};
  std::ofstream file("fractal_curve.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
