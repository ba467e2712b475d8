// Perspective in four lines: a point's image, a vanishing point, a depth and how finely it is stored; then
// the three vanishing points of a box as a figure. Writes perspective.svg into the current folder.

#include "projection/perspective/perspective.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // A point in the plane z = 2; one behind the eye has no image
  const std::optional<dvec3> image = perspective::project(2.0, dvec3{2, 4, 8});
  fmt::print("({}, {}, {})\n", image->x, image->y, image->z);
  fmt::print("behind the eye: {}\n", perspective::project(2.0, dvec3{2, 4, -8}) ? "an image" : "none");

  // Where all lines of a direction seem to meet
  const std::optional<dvec2> point = perspective::vanishing_point(perspective::matrix_onto(2.0), {1, 0, 1});
  fmt::print("({}, {})\n", point->x, point->y);

  // The smallest step in depth that 24 bits tell apart at 1000, near 1 and far a million
  using perspective::DepthCurve, perspective::DepthFormat;
  fmt::print("{:.4f}\n",
             perspective::separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, 1000));

  // A box as a figure
  const Trace trace =
      trace_of(*find_entry("perspective"), {{"method", "vanishing_points"}, {"turn", "35,25"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {trace.last, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/projection/perspective", ""};
  std::ofstream("perspective.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
