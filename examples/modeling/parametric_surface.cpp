// A sphere by two angles three ways: a point with its normal, patches as faces, a step as a figure.
// Writes parametric_surface.svg into the current folder.

#include "modeling/parametric_surface/parametric_surface.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::parametric_surface;

  // The point at 60 and 30 degrees on a sphere of radius 2
  const SurfacePoint<double> p = point(2.0, angle(60.0), angle(30.0));
  fmt::print("({:.3f}, {:.3f}, {:.3f})\n", p.point.x, p.point.y, p.point.z);

  // How many points and faces a mesh has, and how far it is off
  for (const int n : {12, 24, 48}) {
    const Patches<double> mesh = patches(2.0, n, n / 2);
    fmt::print("{} points, {} faces, {:.4f} off\n", mesh.points.size(), mesh.faces.size(),
               off_sphere(2, n, n / 2));
  }

  // Its tangents as a figure
  const Trace trace = trace_of(*find_entry("parametric_surface"), {{"angles", "60,30"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/parametric_surface", ""};
  std::ofstream file("parametric_surface.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
