// A drilled plate three ways: whether points are inside, where a ray is inside, and the merging of its
// intervals as a figure. Writes csg_tree.svg into the current folder.

#include "modeling/csg_tree/csg_tree.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::csg_tree;
  Nodes<double> tree;
  const Index plate = add_leaf<double>(tree, csg_tree::Box<double>{{0, 0, 0}, {10, 4, 1}});
  const Index hole = add_leaf<double>(tree, Cylinder<double>{{6, 2, 0}, 1, 2});
  add_node(tree, Op::subtract, plate, hole);

  for (const double x : {3, 6})
    fmt::print("({}, 2, 0.5) is {}\n", x, contains<double>(tree, {x, 2, 0.5}) ? "inside" : "outside");

  const auto ends = along_ray<double>(tree, {{-1, 2, 0.5}, {1, 0, 0}, 20});
  for (Index k = 0; k < ends.size(); k += 2) fmt::print("inside from {} to {}\n", ends[k], ends[k + 1]);

  // The root's step of the topic's own example as a figure
  const Trace trace = trace_of(*find_entry("csg_tree"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/csg_tree", ""};
  std::ofstream file("csg_tree.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
