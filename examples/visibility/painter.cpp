// Three bars, each over the next, three ways: their parts as the painter takes them, the moves and cuts
// watched by a lambda, one step as a figure. Writes painter.svg into the current folder.

#include "visibility/painter/painter.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::painter;
  const std::vector<Polygon<double>> bars{
      {{{-6.2, -3.6, -1.2}, {6.2, -3.6, 1.2}, {6.2, -1.6, 1.2}, {-6.2, -1.6, -1.2}}, 0},
      {{{6.2, -3.6, -1.2}, {0, 7.1, 1.2}, {-1.7, 6.1, 1.2}, {4.5, -4.6, -1.2}}, 1},
      {{{0, 7.2, -1.2}, {-6.2, -3.5, 1.2}, {-4.5, -4.5, 1.2}, {1.7, 6.2, -1.2}}, 2}};

  // The order for an eye at (1, 2, 30) that looks along -z
  const auto view = view_along(Eye<double>{1, 2, 30, 1}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
  const auto print = [](const Polygon<double>& part) { fmt::print("{}", "ABC"[part.face]); };
  newell(bars, view, print);
  fmt::print("\n");

  // What is moved and cut, as the algorithm reports it
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Moved<double>>) fmt::print("{} goes first\n", "ABC"[step.q.face]);
    if constexpr (std::same_as<Step, Cut<double>>) fmt::print("{} is cut\n", "ABC"[step.whole.face]);
  };
  newell(bars, view, [](const Polygon<double>&) {}, watch);

  // Step 2 as a figure
  const Trace trace = trace_of(*find_entry("painter"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/painter", ""};
  std::ofstream("painter.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
