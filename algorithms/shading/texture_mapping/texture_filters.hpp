#pragma once
// The colour of a place on a texture: from one texel (nearest), from four (bilinear), or from a level whose
// texels are as large as a pixel's footprint (mip-mapped).
//
// Texture coordinates (u, v) go from (0, 0) in the lower left corner to (1, 1), v up; texels are counted as
// in an image, row 0 at the top. A texel is a cell: its colour stands in the middle, half a texel from its
// border.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <type_traits>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/pixels.hpp"

namespace gradus::texture_mapping {

/// What lies beyond the border of a texture: the texture again, or its outermost texels.
enum class Wrap { repeat, clamp };

/// How many texels a texture has, and what lies beyond them.
struct Extent {
  ivec2 size{1, 1};  ///< columns and rows, 1 to `largest` each
  Wrap wrap = Wrap::repeat;
};

/// Most columns or rows of a texture.
inline constexpr int largest = 1 << 15;
/// How far from 0 a texture coordinate may lie.
inline constexpr double farthest = 1 << 20;

/// A place on a texture.
template <class T>
using Uv = glm::vec<2, T>;

/// How far (u, v) goes from a pixel to its neighbours.
template <class T>
struct Footprint {
  Uv<T> along_x, along_y;  ///< to the right, downwards
};

/// The level of a mip chain that suits a footprint: `part` of the way from `lower` to the level after it.
struct Level {
  int lower;
  double part;  ///< in [0, 1]
};

// --- Steps -------------------------------------------------------

/// The texel whose cell holds (u, v) was looked up.
template <class Colour>
struct Picked {
  dvec2 uv;
  ivec2 texel;
  Colour colour;
};

/// The four texels round (u, v) were mixed: lower left, lower right, upper left, upper right.
template <class Colour>
struct Blended {
  dvec2 uv;
  ivec2 size;   ///< of the texture, or of its level
  dvec2 parts;  ///< of the way from left to right, from below to above
  std::array<ivec2, 4> texels;
  std::array<Colour, 4> colours;
  Colour colour;
};

/// The level for a footprint was chosen.
struct LevelChosen {
  Footprint<double> footprint;
  double length;  ///< of its longer side, in texels of level 0
  Level level;
};

/// What two levels have was mixed.
template <class Colour>
struct LevelsMixed {
  Level level;
  Colour finer, coarser, colour;
};

/// A texel of a level is the mean of those that it covers in the level before.
template <class Colour>
struct Averaged {
  int level;
  ivec2 texel;
  Colour colour;
};

// --- Numbers and cells -------------------------------------------

/// What a colour's components are.
template <class Colour>
struct ComponentOf {
  using Type = Colour;
};
template <glm::length_t n, class T, glm::qualifier q>
struct ComponentOf<glm::vec<n, T, q>> {
  using Type = T;
};
template <class Colour>
using Component = typename ComponentOf<Colour>::Type;

/// `part` of the way from a to b. Equal colours stay as they are, to the last bit.
template <class Colour>
constexpr Colour lerp(const Colour& a, const Colour& b, double part) {
  return a + Component<Colour>(part) * (b - a);
}

/// The cell, of `count` in a unit, that holds a coordinate; a border belongs to the cell that begins there.
/// Accuracy: exact.
inline std::int64_t cell_of(double coordinate, int count) {
  const Rounded scaled = two_product(coordinate, static_cast<double>(count));
  const double below = std::floor(scaled.value);
  const bool rounded_up = scaled.value == below && scaled.error < 0;
  return static_cast<std::int64_t>(below) - rounded_up;
}

/// A cell of an axis, brought onto the texture.
constexpr int wrapped(std::int64_t cell, int count, Wrap wrap) {
  if (wrap == Wrap::clamp) return static_cast<int>(std::clamp<std::int64_t>(cell, 0, count - 1));
  const std::int64_t rest = cell % count;
  return static_cast<int>(rest < 0 ? rest + count : rest);
}

/// The texel in a cell: cells are counted from the lower left corner, rows of texels from the top.
constexpr ivec2 texel_in(std::int64_t column, std::int64_t up, const Extent& texture) {
  const auto [size, wrap] = texture;
  return {wrapped(column, size.x, wrap), size.y - 1 - wrapped(up, size.y, wrap)};
}

constexpr bool is_size(ivec2 size) {
  return 1 <= size.x && size.x <= largest && 1 <= size.y && size.y <= largest;
}
inline void expect_lookup(dvec2 uv, const Extent& texture) {
  const ivec2 size = texture.size;
  expects(is_size(size), "a texture has 1 to {} columns and rows, not {} x {}", largest, size.x, size.y);
  const bool near = std::abs(uv.x) <= farthest && std::abs(uv.y) <= farthest;
  expects(near, "texture coordinates within {} were expected, not ({}, {})", farthest, uv.x, uv.y);
}

/// Where (u, v) lies among the middles of texels, and the four round about.
struct Middles {
  dvec2 parts;
  std::array<ivec2, 4> texels;
};
inline Middles middles(dvec2 uv, const Extent& texture) {
  // Texels have their middles at 1/2, 3/2, ...
  const dvec2 place = uv * dvec2(texture.size) - 0.5;
  const dvec2 cell{std::floor(place.x), std::floor(place.y)};
  const auto at = [&, i = static_cast<std::int64_t>(cell.x), j = static_cast<std::int64_t>(cell.y)](
                      int right, int up) { return texel_in(i + right, j + up, texture); };
  return {place - cell, {at(0, 0), at(1, 0), at(0, 1), at(1, 1)}};
}

/// The colours of four texels.
template <class Texel, class Colour = std::invoke_result_t<Texel&, ivec2>>
std::array<Colour, 4> colours_of(const std::array<ivec2, 4>& at, Texel&& texel) {
  return {texel(at[0]), texel(at[1]), texel(at[2]), texel(at[3])};
}

// --- One level ---------------------------------------------------

/// The colour of the texel whose cell holds (u, v).
/// Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, University of Utah,
/// 1974, ch. 4 (pictures on surfaces).
///
/// uv: texture coordinates, v up. texture: how many texels, and what lies beyond. texel(ivec2) gives the
///   colour in a column and a row, row 0 at the top.
///
/// Domain: coordinates within 2^20 of 0, 1 to 2^15 columns and rows.
/// Steps: Picked.
/// Accuracy: exact: the texel is that of floor(u columns) and floor(v rows), computed without rounding.
/// Cost: one texel.
/// Errors: ContractViolation for coordinates or sizes outside the domain.
template <class Texel, class Colour = std::invoke_result_t<Texel&, ivec2>,
          Observer<Picked<Colour>> O = Unobserved>
Colour nearest(dvec2 uv, const Extent& texture, Texel&& texel, O&& observer = {}) {
  expect_lookup(uv, texture);
  // The cell that holds the place
  const ivec2 count = texture.size;
  auto i = cell_of(uv.x, count.x);
  auto j = cell_of(uv.y, count.y);
  // Beyond the border another one
  auto at = texel_in(i, j, texture);
  const Colour colour = texel(at);
  if constexpr (observed<O>) observer(Picked<Colour>{uv, at, colour});
  return colour;
}

/// Mixes the four texels whose middles lie round (u, v), each the more the nearer it is.
/// Source: P. Heckbert, Survey of texture mapping, IEEE Computer Graphics and Applications 6(11), 1986, 58.
///
/// uv, texture, texel: as for nearest. A colour can be a number or a vector of them.
///
/// Domain: as for nearest; finite colours.
/// Steps: Blended.
/// Accuracy: within u (12 + 4 (columns |u| + rows |v|)) of the largest texel of the four, u the rounding
/// unit;
///   where the four are equal, that colour to the last bit.
/// Cost: four texels, three mixtures.
/// Errors: as for nearest.
template <class Texel, class Colour = std::invoke_result_t<Texel&, ivec2>,
          Observer<Blended<Colour>> O = Unobserved>
Colour bilinear(dvec2 uv, const Extent& texture, Texel&& texel, O&& observer = {}) {
  expect_lookup(uv, texture);
  auto four = middles(uv, texture);
  const auto [t, at] = four;
  auto c = colours_of(at, texel);
  // Along u, in both rows
  auto low = lerp(c[0], c[1], t.x);
  auto high = lerp(c[2], c[3], t.x);
  // Along v
  auto mix = lerp(low, high, t.y);
  if constexpr (observed<O>) observer(Blended<Colour>{uv, texture.size, t, at, c, mix});
  return mix;
}

// --- Levels ------------------------------------------------------

/// How many levels a chain has: each has half as many columns and rows as the one before, rounded down and
/// at least 1, until one texel is left.
constexpr int levels_of(ivec2 size) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(size.x, size.y))));
}
constexpr ivec2 size_of_level(ivec2 size, int level) {
  return {std::max(1, size.x >> level), std::max(1, size.y >> level)};
}
/// How many texels the levels before this one have.
constexpr std::size_t begin_of_level(ivec2 size, int level) {
  std::size_t texels = 0;
  for (int k = 0; k < level; ++k) {
    const ivec2 of = size_of_level(size, k);
    texels += static_cast<std::size_t>(of.x) * static_cast<std::size_t>(of.y);
  }
  return texels;
}
/// How many texels a whole chain has: at most 4/3 of the texture's, and 16 for each column and row.
constexpr std::size_t texels_of_chain(ivec2 size) { return begin_of_level(size, levels_of(size)); }

/// A texture and its levels, each row by row from the top, one after the other. Holds a view.
template <class Colour>
class MipChain {
 public:
  /// texels: from build_mip_chain, as many as texels_of_chain says.
  constexpr MipChain(ivec2 size, std::span<const Colour> texels) : size_(size), texels_(texels) {
    expects(is_size(size), "a texture has 1 to {} columns and rows, not {} x {}", largest, size.x, size.y);
    expects(texels.size() == texels_of_chain(size), "{} texels were expected, not {}", texels_of_chain(size),
            texels.size());
    for (int k = 0; k < levels_of(size); ++k) begin_[static_cast<std::size_t>(k)] = begin_of_level(size, k);
  }

  constexpr int levels() const { return levels_of(size_); }
  constexpr ivec2 size(int level = 0) const { return size_of_level(size_, level); }
  /// The texels of a level, as the filters take them.
  constexpr auto level(int level) const {
    return [this, begin = begin_[static_cast<std::size_t>(level)], columns = size(level).x](ivec2 at) {
      return texels_[begin + static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(at.x)];
    };
  }

 private:
  ivec2 size_;
  std::span<const Colour> texels_;
  std::array<std::size_t, 16> begin_{};
};

/// Which texels of an axis one of the next level covers: of each how many parts, `count` parts in all. Of an
/// even number two halves; of an odd one, which can't be halved, all texels are stretched alike.
struct Covered {
  int first;
  std::array<int, 3> parts;
};
constexpr Covered covered(int texel, int count) {
  const int half = count / 2;
  if (half == 0) return {0, {1, 0, 0}};
  if (count % 2 == 0) return {2 * texel, {half, half, 0}};
  return {2 * texel, {half - texel, half, texel + 1}};
}

/// The mean of what a texel of the next level covers. It is the first texel, and the mean of how far the
/// others differ from it: equal texels stay as they are.
template <class Texel, class Colour = std::invoke_result_t<Texel&, ivec2>>
Colour covered_mean(ivec2 at, ivec2 size, Texel&& texel) {
  using T = Component<Colour>;
  const auto x = covered(at.x, size.x), y = covered(at.y, size.y);
  const Colour first = texel(ivec2{x.first, y.first});
  Colour sum = first - first;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const int parts = x.parts[static_cast<std::size_t>(i)] * y.parts[static_cast<std::size_t>(j)];
      if (parts == 0) continue;
      sum = sum + T(parts) * (texel(ivec2{x.first + i, y.first + j}) - first);
    }
  }
  return first + sum / T(size.x * size.y);
}

/// Of each texel of a level what it covers in the one before, level k.
template <class Colour>
auto means(const MipChain<Colour>& chain, int k) {
  return [size = chain.size(k), texels = chain.level(k)](ivec2 at) { return covered_mean(at, size, texels); };
}

/// The texels of a level, row by row from the top.
constexpr auto texels_of(ivec2 size) { return pixels({{0, 0}, size - 1}); }

/// Builds the levels of a texture: each texel is the mean of those that it covers in the level before (a box
/// filter). Colours are to be linear, so that the mean is that of the light.
/// Source: L. Williams, Pyramidal parametrics, SIGGRAPH 1983, 1-11; sizes that are no powers of two as in
/// NVIDIA, Non-power-of-two mipmap creation, 2005.
///
/// size: columns and rows. texel(ivec2) gives the colour in a column and a row. all: the caller's, as long as
///   texels_of_chain(size) says; takes the texture and its levels.
///
/// Domain: 1 to 2^15 columns and rows; finite colours.
/// Steps: Averaged for every texel of every level after the first, row by row.
/// Accuracy: exact for sizes that are powers of two while the sums fit a significand; else each texel within
///   16 u of the largest that it covers. The mean of a level is that of the texture, within 16 u per level of
///   the largest texel. Equal texels give equal levels, to the last bit.
/// Cost: four to nine texels for each of the chain, which has a third more than the texture.
/// Errors: ContractViolation for sizes outside the domain, or a chain of another length.
template <class Texel, class Colour, Observer<Averaged<Colour>> O = Unobserved>
void build_mip_chain(ivec2 size, Texel&& texel, std::span<Colour> all, O&& observer = {}) {
  MipChain<Colour> chain(size, all);
  auto next = all.begin();
  // Level 0 is the texture itself
  for (ivec2 p : texels_of(size)) {
    *next++ = texel(p);
  }
  const int n = chain.levels();
  for (int k = 1; k < n; ++k) {
    // Of the texels that one covers
    auto mean = means(chain, k - 1);
    const ivec2 to = chain.size(k);
    for (ivec2 p : texels_of(to)) {
      *next++ = mean(p);
      if constexpr (observed<O>) observer(Averaged<Colour>{k, p, next[-1]});
    }
  }
}

/// The longer side of a footprint, in texels. Accuracy: 4 u.
inline double longer_side(const Footprint<double>& footprint, ivec2 size) {
  const auto length = [size](dvec2 way) { return length_of(dvec3(way * dvec2(size), 0)); };
  return std::max(length(footprint.along_x), length(footprint.along_y));
}

/// The level whose texels are as long as the footprint's longer side, log2 of that side: level 0 for sides of
/// up to a texel, the last one for those that are longer than the texture.
/// Source: OpenGL 4.6, core profile, 2022, section 8.14.1 (scale factor and level of detail).
///
/// length: of the longer side, in texels of level 0, >= 0. levels: of the chain.
///
/// Domain: as said.
/// Accuracy: the lower level is exact, the part within 2^-50. Sides of a power of two take one level alone.
/// Cost: a logarithm. Errors: none.
inline Level level_of(double length, int levels) {
  const int last = levels - 1;
  // Too long, even endlessly so
  if (!(length < std::ldexp(1.0, last))) return {last, 0};
  if (length <= 1) return {0, 0};
  // length = (1 + fraction) 2^lower
  const int lower = std::ilogb(length);
  const double scaled = std::ldexp(length, -lower);
  return {lower, log(scaled) / std::numbers::ln2};
}

/// Mixes what the two levels have whose texels are nearest to the pixel's footprint in length (trilinear), so
/// that no more than a few texels meet a pixel.
/// Source: L. Williams, Pyramidal parametrics, SIGGRAPH 1983, 1-11.
///
/// uv: texture coordinates. area: how far they go from pixel to pixel. chain: from build_mip_chain. wrap:
///   what lies beyond the texture.
///
/// Domain: as for bilinear.
/// Steps: LevelChosen Blended (Blended LevelsMixed)?, the latter where the side of the footprint isn't the
///   very texel of a level.
/// Accuracy: as bilinear's in both levels, and 20 u of the largest texel more; equal texels give that colour
///   to the last bit. The levels' means are squares: along the shorter side of the footprint it blurs.
/// Cost: four or eight texels and a logarithm, however large the footprint.
/// Errors: as for nearest.
template <class Colour, Observer<LevelChosen, Blended<Colour>, LevelsMixed<Colour>> O = Unobserved>
Colour mip_mapped(dvec2 uv, const Footprint<double>& area, const MipChain<Colour>& chain,
                  Wrap wrap = Wrap::repeat, O&& observer = {}) {
  const ivec2 size = chain.size();
  // Its longer side, in texels
  auto d = longer_side(area, size);
  // Texels as long as the footprint
  const int n = chain.levels();
  auto [k, t] = level_of(d, n);
  if constexpr (observed<O>) observer(LevelChosen{area, d, {k, t}});
  auto in = [&](int i) {
    Extent of{chain.size(i), wrap};
    auto texel = chain.level(i);
    return bilinear(uv, of, texel, observer);
  };
  auto fine = in(k);
  if (t == 0) return fine;
  // Between two levels
  auto coarse = in(k + 1);
  auto mix = lerp(fine, coarse, t);
  if constexpr (observed<O>) observer(LevelsMixed<Colour>{{k, t}, fine, coarse, mix});
  return mix;
}

}  // namespace gradus::texture_mapping
