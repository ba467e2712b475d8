// Three bars, each over the next, three ways: their parts from back to front, the cuts watched by a lambda,
// one step as a figure. Writes bsp_tree.svg into the current folder.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::bsp_tree;
  const std::vector<Polygon<double>> bars{
      {{{-6.2, -3.6, -1.2}, {6.2, -3.6, 1.2}, {6.2, -1.6, 1.2}, {-6.2, -1.6, -1.2}}, 0},
      {{{6.2, -3.6, -1.2}, {0, 7.1, 1.2}, {-1.7, 6.1, 1.2}, {4.5, -4.6, -1.2}}, 1},
      {{{0, 7.2, -1.2}, {-6.2, -3.5, 1.2}, {-4.5, -4.5, 1.2}, {1.7, 6.2, -1.2}}, 2}};

  // The order for an eye at (1, 2, 30)
  const Tree<double> tree = build(bars);
  const auto print = [](const Polygon<double>& part) { fmt::print("{}", "ABC"[part.face]); };
  back_to_front(tree, Eye<double>{1, 2, 30, 1}, print);
  fmt::print("\n");

  // What is cut, as the algorithm reports it
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Split<double>>) fmt::print("{} is cut\n", "ABC"[step.behind.face]);
  };
  build(bars, ExactSide{}, watch);

  // Step 2 as a figure
  const Trace trace = trace_of(*find_entry("bsp_tree"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/bsp_tree", ""};
  std::ofstream("bsp_tree.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
