// The nearest points three ways: the points alone, a search watched, the step that cuts most off as a figure.
// Writes kd_tree.svg into the current folder.

#include "modeling/kd_tree/kd_tree.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::kd_tree;
  const std::vector<dvec2> points{{5, 6}, {10, 4}, {1, 7}, {9, 8}, {8, 10}, {6, 2}, {7, 12}, {7, 5}};
  const auto tree = build<2, double>(points);

  // The three nearest
  for (const auto& [square, point] : nearest<2, double>(tree, {2, 4}, 3))
    fmt::print("point {}, {} away, squared\n", point, square);

  // What a search leaves out
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (requires { step.cells; })
      fmt::print("{} distances of points, {} of cells\n", step.distances, step.cells);
  };
  nearest<2, double>(tree, {2, 4}, 1, watch);

  // The step that tells most as a figure
  const Trace trace = trace_of(*find_entry("kd_tree"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/kd_tree", ""};
  std::ofstream file("kd_tree.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
