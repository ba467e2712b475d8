// A viewport three ways: pixels alone, the steps of one point watched by a lambda, one step as a figure.
// Writes viewport.svg into the current folder.

#include "projection/viewport/viewport.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;

  // The pixels alone, or "none"
  const Rectangle<double> window{{-1, -0.75}, {1, 0.75}};
  const auto map = viewport::stretched(window, {8, 6});
  for (const dvec2 point : {dvec2{0.3, 0.4}, dvec2{1.3, 0.5}}) {
    if (const auto pixel = viewport::rasterize(map, point)) {
      fmt::print("column {}, row {}\n", pixel->x, pixel->y);
    } else {
      fmt::print("outside\n");
    }
  }

  // The steps of one point, as the algorithm reports them
  const auto watch = []<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, viewport::Placed<double>>)
      fmt::print("at ({}, {})\n", step.place.x, step.place.y);
  };
  viewport::rasterize(map, dvec2{0.3, 0.4}, viewport::Rounding::floor, watch);

  // Step 2 as a figure
  const Trace trace = trace_of(*find_entry("viewport"), {{"resolution", "8,6"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {2, 0});
  const Colophon colophon{figure.title, caption_of(figure), "examples/projection/viewport", ""};
  std::ofstream("viewport.svg") << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
