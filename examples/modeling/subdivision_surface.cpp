// Subdivision three ways: a smoothed cube, its levels watched, a step as a figure.
// Writes subdivision_surface.svg into the current folder.

#include "modeling/subdivision_surface/subdivision_surface.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::subdivision_surface;
  const Surface<double> cube{
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}},
      faces_of({{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})};

  // The corner (1, 1, 1) after one level and after all
  const dvec3 moved = catmull_clark(cube, 1).points[7], end = limit(cube, 7).point;
  fmt::print("({}, {}, {}) tends to ({}, {}, {})\n", moved.x, moved.y, moved.z, end.x, end.y, end.z);

  // What each level has
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, LevelDone>) fmt::print("level {}: {} faces\n", step.level, step.faces);
  };
  catmull_clark(cube, 4, watch);

  // Where the corner goes, as a figure
  const Trace trace =
      trace_of(*find_entry("subdivision_surface"), {{"shape", "cube"}, {"vertex", "8"}, {"levels", "2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/modeling/subdivision_surface", ""};
  std::ofstream file("subdivision_surface.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
