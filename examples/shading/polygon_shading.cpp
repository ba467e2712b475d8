// Gouraud shading three ways: its pixels as numbers, its scan lines watched, a step as a figure.
// Writes polygon_shading.svg into the current folder.

#include "shading/polygon_shading/polygon_shading.hpp"

#include <fmt/core.h>

#include <fstream>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::polygon_shading;

  // A triangle with an intensity at each corner
  const Corner<double, double> corners[]{{{0.5, 0.5}, 0}, {{10.5, 0.5}, 0.5}, {{5.5, 10.5}, 1}};
  const std::span<const Corner<double, double>> triangle(corners);
  const Window picture{{0, 0}, {10, 10}};
  gouraud(triangle, picture, [](ivec2 p, double intensity) {
    if (p == ivec2{5, 4}) fmt::print("pixel (5, 4): {:.2f}\n", intensity);
  });

  // The ends of its scan lines
  const auto watch = []<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, RowBegun<double, double>>)
      fmt::print("row {}: alpha {:.1f}, beta {:.1f}\n", s.row, s.left.part, s.right.part);
  };
  gouraud(triangle, picture, [](ivec2, double) {}, watch);

  // The pixel as a figure
  const TopicEntry& topic = *find_entry("polygon_shading");
  const Trace trace = trace_of(topic, {{"intensities", "0 0.5 1"}, {"window", "-0.5,-0.5,11.5,11.5"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/shading/polygon_shading", ""};
  std::ofstream file("polygon_shading.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
