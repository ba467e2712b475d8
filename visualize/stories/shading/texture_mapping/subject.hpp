#pragma once
// What is textured: a quad of two triangles in perspective, its texture, and the pixels that show it.

#include <fmt/format.h>

#include <map>

#include "figure/tone_of.hpp"
#include "shading/texture_mapping/texture_mapping.hpp"
#include "shading/texture_mapping/texture_mapping_notes.hpp"
#include "stories/telling.hpp"
#include "stories/topic.hpp"

namespace gradus::texture_mapping {

/// A pixel's place on the texture.
using Place = Mapped<double>;
/// A textured picture: the grey of its pixels.
using Picture = std::map<std::pair<int, int>, double>;

/// What the texture shows, in grey.
enum class Motif { checker, cross, squares, patches };

inline double motif_at(Motif motif, ivec2 at, int texels) {
  const bool odd = (at.x + at.y) % 2 != 0;
  if (motif == Motif::checker) return odd ? 0.9 : 0.08;
  if (motif == Motif::cross) return at.x == at.y || at.x + at.y == texels - 1 ? 0.03 : odd ? 0.9 : 0.55;
  // Two squares either way, of many texels each
  if (motif == Motif::squares) return (2 * at.x < texels) == (2 * at.y < texels) ? 0.9 : 0.08;
  // Patches without a pattern, lighter to the upper right
  const int patch = (5 * at.x * at.x + 3 * at.y * at.y + 7 * at.x * at.y + 2 * at.y) % 9;
  return 0.02 + patch / 18.0 + 0.2 * (at.x + texels - at.y) / texels;
}

struct Subject {
  ivec2 size{};                    ///< of the picture
  std::array<dvec3, 4> corners{};  ///< x and y in the picture, y down, and w
  int texels = 8;                  ///< of the texture, either way
  int tiles = 1;                   ///< how often the texture lies on the quad, either way
  Extent texture{};
  Motif motif = Motif::checker;
  std::vector<double> levels{};

  std::string size_text() const { return fmt::format("{0} × {0}", texels); }
  Window picture() const { return {{0, 0}, size - 1}; }
  double texel(ivec2 at) const { return motif_at(motif, at, texels); }
  auto look_up() const {
    return [this](ivec2 at) { return texel(at); };
  }
  MipChain<double> chain() const { return {texture.size, levels}; }
  dvec2 uv_of(std::size_t corner) const {
    return double(tiles) * dvec2(corner == 1 || corner == 2 ? 1 : 0, corner >= 2 ? 1 : 0);
  }
  ivec2 nearest_texel(dvec2 uv) const {
    return texel_in(cell_of(uv.x, texels), cell_of(uv.y, texels), texture);
  }
  Triangle triangle(std::size_t half) const {
    const auto at = [&](std::size_t k) { return triangle_coverage::snap(dvec2(corners[k])); };
    return {at(0), at(half + 1), at(half + 2)};
  }
  Corners<double> in_perspective(std::size_t half) const {
    const auto at = [&](std::size_t k) { return Corner<double>{1 / corners[k].z, uv_of(k)}; };
    return {at(0), at(half + 1), at(half + 2)};
  }
};

/// What each pixel of both triangles shows of the texture: map(triangle, corners, window, plot, observer).
template <class Map>
void each_place(const Subject& subject, const Map& map) {
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
    map(subject.triangle(half), subject.in_perspective(half));
}

/// The picture that a filter gives: colour(uv, footprint).
template <class Filter>
Picture picture_of(const Subject& subject, const Filter& filter) {
  Picture picture;
  each_place(subject, [&](const Triangle& triangle, const Corners<double>& corners) {
    perspective_correct(triangle, corners, subject.picture(),
                        [&](ivec2 p, dvec2 uv, const auto& area) { picture[{p.x, p.y}] = filter(uv, area); });
  });
  return picture;
}

/// The same quad in so many times as many pixels either way, that what a filter does is seen and not they; of
/// a single texture as many copies, which would only be magnified.
inline Subject in_finer_pixels(Subject subject, int times) {
  subject.size *= times;
  for (dvec3& corner : subject.corners) corner *= dvec3(times, times, 1);
  if (subject.tiles == 1) subject.tiles = times;
  return subject;
}

/// The same with so many samples per pixel either way: what the filters are measured by.
inline Picture supersampled(const Subject& subject, int samples) {
  Picture picture;
  std::map<std::pair<int, int>, int> counted;
  each_place(subject, [&](Triangle triangle, const Corners<double>& corners) {
    for (ivec2& corner : triangle) corner *= samples;
    const Window window{{0, 0}, subject.size * samples - 1};
    perspective_correct(triangle, corners, window, [&](ivec2 p, dvec2 uv, const auto&) {
      picture[{p.x / samples, p.y / samples}] += nearest(uv, subject.texture, subject.look_up());
      ++counted[{p.x / samples, p.y / samples}];
    });
  });
  for (auto& [at, sum] : picture) sum /= counted[at];
  return picture;
}

/// The mean difference of two pictures, where the first has pixels.
inline double mean_difference(const Picture& shown, const Picture& right) {
  double sum = 0;
  for (const auto& [at, grey] : shown) {
    const auto there = right.find(at);
    if (there != right.end()) sum += std::abs(grey - there->second);
  }
  return shown.empty() ? 0 : sum / static_cast<double>(shown.size());
}

/// Column and row of a texel.
inline std::string texel_name(ivec2 texel) { return fmt::format("({}, {})", texel.x, texel.y); }

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{
      .size = {static_cast<int>(arguments.integer("columns")), static_cast<int>(arguments.integer("rows"))},
      .texels = static_cast<int>(arguments.integer("texels")),
      .tiles = static_cast<int>(arguments.integer("tiles"))};
  const std::vector<dvec3> corners = arguments.places("corners");
  for (std::size_t k = 0; k < 4; ++k) {
    const dvec3 c = corners[k];
    if (!(c.z > 0)) refuse("corners", "expected w > 0 at every corner, found {}", c.z);
    if (!(std::abs(c.x) <= 4096 && std::abs(c.y) <= 4096))
      refuse("corners", "expected x and y within 4096 pixels, found ({}, {})", c.x, c.y);
    subject.corners[k] = c;
  }
  const std::string& motif = arguments.text("texture");
  subject.motif = motif == "cross"     ? Motif::cross
                  : motif == "squares" ? Motif::squares
                  : motif == "patches" ? Motif::patches
                                       : Motif::checker;
  subject.texture = {ivec2(subject.texels), arguments.text("wrap") == "clamp" ? Wrap::clamp : Wrap::repeat};
  subject.levels.resize(texels_of_chain(subject.texture.size));
  build_mip_chain(subject.texture.size, subject.look_up(), std::span(subject.levels));
  return subject;
}

}  // namespace gradus::texture_mapping
