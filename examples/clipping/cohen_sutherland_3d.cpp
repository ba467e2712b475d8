// A segment clipped to a box and one to the view volume, its cuts watched by a lambda, one step as a figure.
// Writes cohen_sutherland_3d.svg into the current folder.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  namespace clip = cohen_sutherland_3d;

  // The part in a box; none would be std::nullopt
  const AxisBox<3, double> box{{0, 0, 0}, {10, 8, 6}};
  const Segment<3, double> line{{-2, 1, 2}, {12, 11, 9}};
  if (const auto part = clip::correctly_rounded(line, box)) {
    fmt::print("from ({}, {}, {}) to ({}, {}, {})\n", part->a.x, part->a.y, part->a.z, part->b.x, part->b.y,
               part->b.z);
  }

  // A segment that passes the eye, cut before the division by w: watch which end is moved
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, clip::Cut<4, double>>) {
      fmt::print("{} moves to w = {}\n", step.of_a ? "a" : "b", step.to().w);
    }
  };
  const Segment<4, double> seen{{-2.2, 0.5, 1.5, 2}, {2, 1, -1.5, -1}};
  clip::correctly_rounded(seen, clip::ViewVolume{}, usual_order<3>(), watch);

  // Step 3 of the first as a figure
  const Trace trace = trace_of(*find_entry("cohen_sutherland_3d"), {{"line", "-2,1,2,12,11,9"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {3, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/clipping/cohen_sutherland_3d", ""};
  std::ofstream("cohen_sutherland_3d.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
