#pragma once
// A star of thin triangles by one sample per pixel and by an A-buffer, magnified below, with what the lists
// take.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "antialiasing/a_buffer/a_buffer_picture.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/raster.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/a_buffer/drawing.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::a_buffer {

/// Thin triangles round the middle, and a large one behind them.
inline std::vector<ScreenTriangle> star_of(int side) {
  std::vector<ScreenTriangle> star;
  const dvec2 middle(0.5 * side);
  constexpr int spikes = 22;
  for (int i = 0; i < spikes; ++i) {
    const double angle = 2 * 3.14159265358979323846 * (i + 0.3) / spikes;
    const dvec2 way{cos(angle), sin(angle)}, aside{-way.y, way.x};
    const dvec2 tip = middle + 0.48 * side * way, foot = middle + 0.08 * side * way;
    const auto snap = [](dvec2 p) { return triangle_coverage::snap(p); };
    star.push_back({{snap(tip), snap(foot + 0.011 * side * aside), snap(foot - 0.011 * side * aside)},
                    dvec3(0.1 + 0.01 * i)});
  }
  return star;
}

inline void tell_pictures(Narrator& narrator) {
  const Words& words = narrator.words();
  const int side = static_cast<int>(narrator.arguments().integer("columns"));
  const std::vector<ScreenTriangle> star = star_of(side);
  const Window window{{0, 0}, {side - 1, side - 1}};
  narrator.subtitle("pictures.subtitle", {{"side", side}});
  narrator.columns({{"way", false}, {"pixels"}, {"fragments"}, {"bytes"}});
  narrator.legend({{Role::current, "crop"}});
  const std::array names{words.say("short.one"), words.say("short.masks")};
  PictureShelf shelf(narrator,
                     {.size = ivec2(side),
                      .names = {names.begin(), names.end()},
                      .gap = 3,
                      .heading = 4,
                      .part = PictureShelf::Part{{side / 2, side / 8}, ivec2(side / 3), side / (side / 3)}});
  shelf.start({.text = "pictures.started", .words = {{"side", side}}});
  using Greys = Raster<double>;
  const auto seen = [](const Greys& greys) {
    return std::ranges::count_if(greys.cells(), [](double grey) { return grey > 0; });
  };
  const auto tones = [](const Greys& greys) {
    return [&](ivec2 p) { return tone_on_paper({0, 0, 0, 255}, greys[p]); };
  };
  Greys one(side, side), masks(side, side);
  for (const ScreenTriangle& t : star)
    triangle_coverage::cover(t.corners, window, [&](ivec2 p, const Weights&) { one[p] = 1; });
  shelf.show("PictureDrawn", 0, tones(one),
             {.text = "pictures.one", .row = {names[0], seen(one), "", ""}, .key = "one"});
  const Memory m = a_buffer(
      std::span<const ScreenTriangle>(star), window, [](int, ivec2, const Weights&) { return 1.0; },
      [&](ivec2 p, double sum, double) { masks[p] = sum; });
  shelf.show("PictureDrawn", narrator.last_line(), tones(masks),
             {.text = "pictures.masks",
              .facts = {{"pixels", m.pixels},
                        {"fragments", m.fragments},
                        {"mask_bytes", m.mask_bytes},
                        {"bytes", m.bytes}},
              .words = {{"longest", m.longest}},
              .row = {names[1], seen(masks), m.fragments, m.mask_bytes},
              .key = "masks"});
  shelf.finish({.text = "pictures.finished", .words = {{"one", seen(one)}, {"masks", seen(masks)}}});
  narrator.result({{"fragments", m.fragments}, {"mask_bytes", m.mask_bytes}});
}

}  // namespace gradus::a_buffer
