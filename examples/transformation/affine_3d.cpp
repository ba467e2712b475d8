// A turn round an axis through a point: as one matrix, by parts, and one step as a figure.
// Writes affine_3d.svg into the current folder.

#include "transformation/affine_3d/affine_3d.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::affine_3d;

  // 30 degrees round the axis (0, 1, 1) through (1, 1, 0)
  const dvec3 axis{0, 1, 1}, through{1, 1, 0};
  const glm::dmat4 whole = rotate(axis, radians_from_degrees(30), through);
  const dvec3 to = transform(whole, dvec3{3, 1, 1});
  fmt::print("({}, {}, {})\n", to.x, to.y, to.z);

  // The same by parts, as the algorithm reports them
  int parts = 0;
  const auto watch = [&](const Decomposed<double>&) { ++parts; };
  const glm::dmat4 product = decomposition(through, alignment(axis), turn_degrees(30.0), watch);
  fmt::print("{} factors, column x = ({}, {}, {})\n", parts, product[0].x, product[0].y, product[0].z);

  // Its third step as a figure
  const Trace trace = trace_of(*find_entry("affine_3d"), {{"method", "decomposition"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/transformation/affine_3d", ""};
  std::ofstream("affine_3d.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
