// A Bézier patch three ways: a point with its normal, a second patch joined to it, the join as a figure.
// Writes bezier_patch.svg into the current folder.

#include "modeling/bezier_patch/bezier_patch.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::bezier_patch;
  const Patch<double> patch{
      3, {{0, 0, 4}, {2, 3, 4}, {4, 0, 4}, {0, 2, 2}, {2, 5, 2}, {4, 2, 2}, {0, 2, 0}, {2, 5, 0}, {4, 2, 0}}};

  const Frame<double> f = de_casteljau(patch, 0.5, 0.5);
  fmt::print("point ({}, {}, {}), normal ({}, {}, {})\n", f.point.x, f.point.y, f.point.z, f.normal.x,
             f.normal.y, f.normal.z);

  // The same patch, moved back by 4, and its first rows put so that it goes on smoothly
  Patch<double> second = patch;
  for (dvec3& p : second.points) p.z -= 4;
  for (const Continuity order : {Continuity::C0, Continuity::G1, Continuity::C1, Continuity::C2}) {
    const Seam<double> seam = measure(patch, join(patch, second, order, 0.5), 16);
    fmt::print("normals {:.3g} apart, first derivatives {:.3g}, curvature {:.3g}\n", seam.angle, seam.slope,
               seam.curvature);
  }

  // Four orders of continuity as a figure
  const Trace trace = trace_of(*find_entry("bezier_patch"), {{"method", "join"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/bezier_patch", ""};
  std::ofstream file("bezier_patch.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
