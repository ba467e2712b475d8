// Texture mapping three ways: a pixel's place and colour as numbers, the steps of a filter watched, a figure.
// Writes texture_mapping.svg into the current folder.

#include "shading/texture_mapping/texture_mapping.hpp"

#include <fmt/core.h>

#include <fstream>
#include <string>

#include "cairo/cairo_output.hpp"
#include "figure/figure.hpp"
#include "stories/topic.hpp"

int main() {
  using namespace gradus;
  using namespace gradus::texture_mapping;

  // A triangle that recedes from w = 1 to w = 3, on the grid of 1/256 pixel, and a checker of 8 x 8 texels
  const Triangle triangle{ivec2{0, 3072}, {3072, 3072}, {1536, 0}};
  const Corners<double> corners{{{1, {0, 0}}, {1, {1, 0}}, {1.0 / 3, {0.5, 1}}}};
  const Extent texture{{8, 8}};
  const auto checker = [](ivec2 at) { return (at.x + at.y) % 2 == 0 ? 0.1 : 0.9; };

  // The place of a pixel, and its colour
  const auto plot = [&](ivec2 pixel, dvec2 uv, const auto&) {
    if (pixel == ivec2{6, 5})
      fmt::print("(6, 5): u = {:.3f}, v = {:.3f}, {:.2f}\n", uv.x, uv.y, nearest(uv, texture, checker));
  };
  perspective_correct(triangle, corners, {{0, 0}, {11, 11}}, plot);

  // Four texels and their parts
  const auto watch = [](const Blended<double>& b) {
    fmt::print("s = {:.2f}, t = {:.2f}: {:.3f}\n", b.parts.x, b.parts.y, b.colour);
  };
  bilinear({0.3, 0.4}, texture, checker, watch);

  // A pixel as a figure
  const TopicEntry& topic = *find_entry("texture_mapping");
  const Trace trace = trace_of(topic, {{"texels", "8"}});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, trace.telling);
  const Colophon colophon{figure.title, caption_of(figure), "examples/shading/texture_mapping", ""};
  std::ofstream file("texture_mapping.svg");
  file << svg_of(lay_out(figure, {}), *find_theme("light"), colophon);
}
