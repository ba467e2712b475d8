// A corner of a box three ways: projected alone, its steps watched by a lambda, the whole box as a figure.
// Writes parallel.svg into the current folder.

#include "projection/parallel/parallel.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // Cabinet: receding edges at 45 degrees, half as long
  const parallel::Slant<double> cabinet = parallel::slant_of(radians_from_degrees(45), 0.5);
  const dvec3 image = parallel::oblique(0.0, cabinet, dvec3{3, 1, 2});
  fmt::print("({:.4f}, {:.4f}, {})\n", image.x, image.y, image.z);

  // The steps, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, parallel::Cast<double>>) fmt::print("t = {}\n", step.t);
  };
  parallel::orthographic(parallel::Axis::y, 0.0, dvec3{3, 1, 2}, watch);

  // The box as a figure
  const Trace trace = trace_of(*find_entry("parallel"), {{"solid", "box"}, {"receding", "45,1"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {trace.last, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/projection/parallel", ""};
  std::ofstream("parallel.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
