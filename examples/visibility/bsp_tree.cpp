// Three walls, of which the first one's plane cuts the last, three ways: their parts from back to front,
// the cuts watched by a lambda, one step as a figure. Writes bsp_tree.svg into the current folder.

#include "visibility/bsp_tree/bsp_tree.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::bsp_tree;
  const std::vector<Polygon<double>> walls{{{{7, 0, 8}, {6, 0, 5}, {6, 3, 5}, {7, 3, 8}}, 0},
                                           {{{11, 0, 6}, {8, 0, 3}, {8, 3, 3}, {11, 3, 6}}, 1},
                                           {{{2, 0, 9}, {2, 3, 9}, {11, 3, 12}, {11, 0, 12}}, 2}};

  // The order for an eye at (12, 2, 20)
  const Tree<double> tree = build(walls);
  const auto print = [](const Polygon<double>& part) { fmt::print("{}", "ABC"[part.face]); };
  back_to_front(tree, Eye<double>{12, 2, 20, 1}, print);
  fmt::print("\n");

  // What is cut, as the algorithm reports it
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Split<double>>) fmt::print("{} is cut\n", "ABC"[step.behind.face]);
  };
  build(walls, ExactSide{}, watch);

  // Step 3 as a figure
  const Trace trace = trace_of(*find_entry("bsp_tree"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/bsp_tree", ""};
  std::ofstream("bsp_tree.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
