// Points of a depth image and their normals three ways: the values alone, one watched, the step that decides
// its side as a figure. Writes point_cloud.svg into the current folder.

#include "modeling/point_cloud/point_cloud.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::point_cloud;
  // A wall that goes away to the right, seen by 8 x 6 pixels
  Raster<double> depth(8, 6);
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 8; ++i) depth[{i, j}] = 60.0 / (12 - i);
  }
  const auto points = back_project(depth, Pinhole<double>{6, {4, 3}});

  // Their normals, towards the camera
  const dvec3 eye{0, 0, 0};
  const auto n = normals<double>(points, 9, eye)[20].way;
  fmt::print("{} points; one of them faces ({:.3f}, {:.3f}, {:.3f})\n", points.size(), n.x, n.y, n.z);

  // How it is found
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (requires { step.variance; })
      fmt::print("variances {:.3g}, {:.3g}, {:.3g}\n", step.variance[0], step.variance[1], step.variance[2]);
  };
  normal(kd_tree::build<3, double>(points), 20, 9, eye, watch);

  // The step that tells most as a figure
  const Trace trace = trace_of(*find_entry("point_cloud"));
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/point_cloud", ""};
  std::ofstream file("point_cloud.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
