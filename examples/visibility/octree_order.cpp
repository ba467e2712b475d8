// An octree's order three ways: its cells alone, the walk watched, a step as a figure.
// Writes octree_order.svg into the current folder.

#include "visibility/octree_order/octree_order.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::octree_order;

  // Eight cells, the nearest first
  const Cell<double> root{{0, 0, 0}, 8};
  const Eye<double> eye(12, 10, 5, 1);
  const auto once = [](const Cell<double>& cell) { return cell.depth < 1; };
  front_to_back(root, eye, once, [](const Cell<double>& cell) {
    fmt::print("({}, {}, {})\n", cell.lower.x, cell.lower.y, cell.lower.z);
  });

  // What was decided on the way
  const auto watch = []<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Entered<double>>) fmt::print("nearest child: {}\n", s.nearest);
  };
  back_to_front(root, eye, once, [](const Cell<double>&) {}, watch);

  // The decision as a figure
  const TopicEntry& topic = *find_entry("octree_order");
  const Trace trace = trace_of(topic, {{"depth", "2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/octree_order", ""};
  std::ofstream file("octree_order.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
