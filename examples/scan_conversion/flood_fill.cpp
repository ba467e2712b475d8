// Fills a small picture, then shows the wave of the breadth-first fill half way as a figure.
// Writes flood_fill.png into the current folder.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // A fill of anything that can be asked and painted
  Raster<char> canvas(40, 12, '.');
  for (int y = 0; y < 9; ++y) canvas[{20, y}] = '#';
  const auto inside = [&](ivec2 p) { return canvas.contains(p) && canvas[p] == '.'; };
  const auto filled = flood_fill::span({3, 3}, inside, [&](ivec2 p) { canvas[p] = 'x'; });
  fmt::print("{} pixels painted; at most {} spans waited, {} bytes\n", filled.painted, filled.peak_waiting,
             filled.peak_bytes);

  // The same question, watched
  const Trace trace = trace_of(*find_entry("flood_fill"), {{"method", "breadth_first"}, {"at", "3,1"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {trace.last / 2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/scan_conversion/flood_fill", ""};
  std::ofstream("flood_fill.png", std::ios::binary)
      << png_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
