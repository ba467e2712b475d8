// The z-buffer three ways: its picture as text, what its walk compares, a step as a figure.
// Writes z_buffer.svg into the current folder.

#include "visibility/z_buffer/z_buffer.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::z_buffer;

  // Two faces that pierce each other, and the buffer that is drawn into
  const dvec3 falling[]{{0, 0, 0}, {8, 0, 4}, {8, 3, 4}, {0, 3, 0}};
  const dvec3 rising[]{{0, 1, 4}, {8, 1, 0}, {8, 4, 0}, {0, 4, 4}};
  const z_buffer::Face faces[]{{falling, {0, 0}}, {rising, {0, 1}}};
  Raster<Cell<double, Id>> buffer(8, 4);

  // The walk, watched
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, FaceDone>)
      fmt::print("face {}: {} of {} pixels kept\n", step.id.face, step.kept, step.compared);
  };
  per_polygon<double>(faces, buffer, Exactly{}, watch);

  // The picture
  for (int y = 0; y < buffer.height(); ++y) {
    for (const auto& cell : buffer.row(y))
      fmt::print("{}", !cell.taken ? '.' : cell.key.face == 0 ? 'f' : 'r');
    fmt::print("\n");
  }

  // A pixel that changes hands as a figure
  const TopicEntry& topic = *find_entry("z_buffer");
  const Trace trace = trace_of(topic, {{"order", "3,1,2"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/visibility/z_buffer", ""};
  std::ofstream file("z_buffer.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
