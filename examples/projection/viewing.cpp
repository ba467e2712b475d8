// A viewer three ways: the matrix alone, its rows watched by a lambda, one step as a figure.
// Writes viewing.svg into the current folder.

#include "projection/viewing/viewing.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // The matrix alone: the target lands on the axis, at its distance
  const dvec3 eye{2.8, 3.6, 3.2}, target{0.4, 0.6, 0};
  const Frame<double> frame = viewing::look_at(eye, target, dvec3{0, 1, 0});
  const glm::dvec4 seen = viewing::world_to_view(frame) * glm::dvec4(target, 1);
  fmt::print("target ({:.3f}, {:.3f}, {:.3f})\n", seen.x, seen.y, seen.z);

  // Its rows, as the algorithm reports them
  const auto watch = [](const viewing::RowWritten<double>& r) {
    fmt::print("{:7.3f} {:7.3f} {:7.3f} | {:7.3f}\n", r.axis.x, r.axis.y, r.axis.z, r.shift);
  };
  viewing::world_to_view(frame, watch);

  // Step 4 as a figure
  const Trace trace = trace_of(*find_entry("viewing"), {{"eye", "2.8,3.6,3.2"}, {"target", "0.4,0.6,0"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {4, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/projection/viewing", ""};
  std::ofstream("viewing.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
