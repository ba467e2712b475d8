// The part of a segment that lies in a circle: alone, decided exactly, and as a figure.
// Writes liang_barsky_circle.svg into the current folder.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::liang_barsky_circle;
  const Circle<double> circle{{0, 0}, 5};

  // What is left, by the textbook
  const auto kept = half_chord<double>({{-9, -3}, {-1, 3}}, circle);
  if (kept) fmt::print("({}, {}) to ({}, {})\n", kept->a.x, kept->a.y, kept->b.x, kept->b.y);

  // A tangent is one point, exactly
  const auto point = exact_decision<double>({{-1, 7}, {7, 1}}, circle);
  if (point) fmt::print("({}, {})\n", point->a.x, point->a.y);

  // Where the line enters and leaves, as a figure
  const Trace trace =
      trace_of(*find_entry("liang_barsky_circle"), {{"line", "-9,-3,-1,3"}, {"circle", "0,0,5"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/liang_barsky_circle", ""};
  std::ofstream("liang_barsky_circle.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
