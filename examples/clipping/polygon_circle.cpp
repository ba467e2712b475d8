// The part of a polygon that lies in a circle: its edges and arcs, as chords, and as a figure.
// Writes polygon_circle.svg into the current folder.

#include "clipping/polygon_circle/polygon_circle.hpp"

#include <fmt/core.h>

#include <fstream>
#include <vector>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::polygon_circle;
  const std::vector<dvec2> square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

  // A quarter of the disc: two edges and an arc
  const Region<double> region = arcs(square, {{0, 0}, 5});
  for (const Corner<double>& corner : region.rings.at(0)) {
    fmt::print("({}, {}) and on {}\n", corner.at.x, corner.at.y,
               corner.arc ? "along the circle" : "straight");
  }
  fmt::print("area {}\n", area(region));

  // For those who have no arcs: chords, nowhere more than 0.01 off
  fmt::print("{} corners\n", flatten(region, 0.01).at(0).size());

  // All crossings, in their order round the circle, as a figure
  const Trace trace = trace_of(*find_entry("polygon_circle"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {7, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/polygon_circle", ""};
  std::ofstream("polygon_circle.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
