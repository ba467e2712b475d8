// A segment in a window three ways: what is left of it, its steps watched by a lambda, one step as a figure.
// Writes cohen_sutherland_2d.svg into the current folder.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::cohen_sutherland_2d;
  const Rectangle<double> window{{0, 0}, {10, 10}};
  const Segment<2, double> line{{-3, -8}, {13, 16}};

  // What is left
  if (const auto left = correctly_rounded(line, window)) {
    fmt::print("({}, {}) to ({}, {})\n", left->a.x, left->a.y, left->b.x, left->b.y);
  }

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Cut<double>>) {
      fmt::print("{} moves to ({}, {})\n", step.of_a ? "a" : "b", step.to().x, step.to().y);
    }
  };
  cut_of_a_cut(line, window, usual_order<2>(), watch);

  // Step 2 as a figure
  const Trace trace =
      trace_of(*find_entry("cohen_sutherland_2d"), {{"line", "-3,-8,13,16"}, {"window", "0,0,10,10"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/cohen_sutherland_2d", ""};
  std::ofstream("cohen_sutherland_2d.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
