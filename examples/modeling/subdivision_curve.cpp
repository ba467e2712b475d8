// Corner cutting three ways: a smoothed polygon, its rounds watched, a step as a figure.
// Writes subdivision_curve.svg into the current folder.

#include "modeling/subdivision_curve/subdivision_curve.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::subdivision_curve;
  const std::vector<dvec2> polygon{{0, 0}, {4, 0}, {4, 4}};

  // The points after two rounds
  for (const dvec2 p : chaikin<double>(polygon, 2, Ends::open)) fmt::print("({}, {})\n", p.x, p.y);

  // What each round leaves
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, RoundDone>) fmt::print("round {}: {} points\n", step.round, step.points);
  };
  chaikin<double>(polygon, 4, Ends::closed, watch);

  // The end of the first round as a figure
  const Trace trace = trace_of(*find_entry("subdivision_curve"), {{"polygon", "0,0 4,0 4,4"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/subdivision_curve", ""};
  std::ofstream file("subdivision_curve.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
