// A segment in a window three ways: what is left of it, its values of t watched by a lambda, one step as a
// figure. Writes liang_barsky.svg into the current folder.

#include "clipping/liang_barsky/liang_barsky.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::liang_barsky;
  const Rectangle<double> window{{0, 0}, {10, 10}};
  const Segment<2, double> line{{-5, 5}, {15, 5}};

  // What is left
  if (const auto left = correctly_rounded(line, window)) {
    fmt::print("({}, {}) to ({}, {})\n", left->a.x, left->a.y, left->b.x, left->b.y);
  }

  // The values of t, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Tested<double>>) fmt::print("t from {} to {}\n", step.enter, step.leave);
  };
  parametric(line, window, usual_order<2>(), watch);

  // Step 2 as a figure
  const Trace trace = trace_of(*find_entry("liang_barsky"), {{"line", "-5,5,15,5"}, {"window", "0,0,10,10"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/liang_barsky", ""};
  std::ofstream("liang_barsky.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
