#pragma once
// Exact areas for speed where a polygon is a few pixels large: no lists of edges or rows, and four rows are
// added up at once.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "core/geometry.hpp"
#include "core/raster.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::area_sampling {

/// What AreaScan draws small polygons with.
class SmallPolygonScan {
 public:
  using Ring = std::span<const ivec2>;
  static constexpr int most = 32;  ///< columns and rows that a polygon may touch
  static constexpr std::size_t most_corners = 256;

  /// Does what AreaScan::draw does; or nothing, and says so by false: where a polygon touches more columns or
  /// rows than `most`, has more corners, reaches out of the picture, has no area, or has a pixel whose byte
  /// sums in double leave open.
  ///
  /// picture, rings: as of AreaScan::draw.
  ///
  /// Domain: as of AreaScan::draw; corners at any place.
  /// Accuracy: exact where true.
  /// Cost: for each row and edge that crosses it some ns, and one for each pixel of the box.
  bool draw(Raster<std::uint8_t>& picture, std::span<const Ring> rings);

 private:
  static constexpr int lanes = 4;  ///< rows that are added up at once
  static constexpr std::size_t stride = most;
  using Bytes = std::array<std::uint8_t, static_cast<std::size_t>(most* most)>;

  void add_edge(ivec2 from, ivec2 to);
  void add(double* changes, double left, double right, double height, double rise);
  static void add_long(double* changes, double left, double right, double height, double rise);
  double sweep(int row, int columns, double scale, double bias, Bytes& bytes);
  template <class Word>
  static void put(std::uint8_t* pixels, const std::uint8_t* bytes);
  static void put_row(std::uint8_t* pixels, const std::uint8_t* bytes, int columns);

  /// By column, then row: how much more is covered than in the column before. Zeros between polygons. An
  /// edge on the right side of the box has its changes in three columns more.
  std::array<double, (most + 3) * stride> changes_{};
};

/// What an edge changes in a row, where it goes from `left` to `right`. height: of it in that row, below 0
/// where what it has on its right isn't covered. rise: how many rows a pixel takes, with the sign of height.
inline void SmallPolygonScan::add(double* changes, double left, double right, double height, double rise) {
  const auto first = static_cast<std::ptrdiff_t>(left);
  const double border = static_cast<double>(first + 1);
  changes += first * static_cast<std::ptrdiff_t>(stride);
  if (right > border + 1) return add_long(changes, left - border + 1, right - border + 1, height, rise);
  // It lies in two columns, or one: the rows it takes within the first and beyond
  const double beyond = std::max(0.0, right - border), within = (right - left) - beyond;
  const double rows_beyond = rise * beyond;
  const double begins = (height - rows_beyond) * (border - left - within * 0.5);
  const double ends = rows_beyond * beyond * 0.5;
  changes[0] += begins;
  changes[stride] += height - begins - ends;
  changes[2 * stride] += ends;
}

/// The same for three columns and more: a triangle in the first and one in the last, between them the area
/// grows evenly. left, right: from the first column's left side; changes: of that column.
inline void SmallPolygonScan::add_long(double* changes, double left, double right, double height,
                                       double rise) {
  const auto last = static_cast<std::ptrdiff_t>(right);
  const double before = 1 - left, after = right - static_cast<double>(last);
  double covered = rise * before * before * 0.5;
  changes[0] += covered;
  for (std::ptrdiff_t i = 1; i < last; ++i) {
    changes += stride;
    const double here = rise * (static_cast<double>(i) + 0.5 - left);
    changes[0] += here - covered;
    covered = here;
  }
  const double ends = rise * after * after * 0.5;
  changes[stride] += height - ends - covered;
  changes[2 * stride] += ends;
}

/// All rows that an edge crosses. from, to: in 1/256 pixel from the corner of the box.
inline void SmallPolygonScan::add_edge(ivec2 from, ivec2 to) {
  using triangle_coverage::subpixels;
  const int dx = to.x - from.x, dy = to.y - from.y;
  if (dy == 0) return;
  const ivec2 top = dy > 0 ? from : to;
  const int bottom = std::max(from.y, to.y);
  constexpr double unit = 1.0 / subpixels;
  const double across = static_cast<double>(dx) / dy * unit;
  // An upright edge takes no part of a column, and any number will do
  const double rise = static_cast<double>(dy) / std::max(std::abs(dx), 1);
  const double sign = dy > 0 ? unit : -unit;
  const double begin = top.x * unit;
  int y = top.y;
  double x = begin;
  double* changes = changes_.data() + y / subpixels;
  do {
    const int next = std::min((y | (subpixels - 1)) + 1, bottom);
    const double end = begin + (next - top.y) * across;
    add(changes, std::min(x, end), std::max(x, end), (next - y) * sign, rise);
    x = end;
    y = next;
    ++changes;
  } while (y < bottom);
}

/// The bytes of some rows: scale times their areas, rounded. Takes the changes away. Returns the largest
/// difference between a byte and what was rounded to it.
inline double SmallPolygonScan::sweep(int row, int columns, double scale, double bias, Bytes& bytes) {
  constexpr double rounding = 0x1.8p52;  // added to a number, it leaves no bits behind the point
  constexpr bool little = std::endian::native == std::endian::little;
  std::array<double, lanes> area{}, off{};
  double* changes = changes_.data() + row;
  for (int column = 0; column < columns; column += 4) {
    std::array<double, lanes> packed{};  // four bytes as they lie in memory
    double place = little ? 1 : 0x1p24;
    for (int i = 0; i < 4; ++i) {
      for (std::size_t r = 0; r < lanes; ++r) {
        area[r] += changes[r];
        changes[r] = 0;
        const double exact = area[r] * scale + bias, byte = (exact + rounding) - rounding;
        const double away = std::abs(exact - byte);
        off[r] = off[r] > away ? off[r] : away;
        packed[r] += byte * place;
      }
      changes += stride;
      place *= little ? 0x1p8 : 0x1p-8;
    }
    for (std::size_t r = 0; r < lanes; ++r) {
      const auto word = static_cast<std::uint32_t>(static_cast<std::int64_t>(packed[r]));
      std::memcpy(bytes.data() + (static_cast<std::size_t>(row) + r) * most + column, &word, sizeof word);
    }
  }
  // What edges on the right side have changed beyond
  for (std::size_t i = 0; i < 3; ++i) std::fill_n(changes + i * stride, lanes, 0.0);
  return std::max(std::max(off[0], off[1]), std::max(off[2], off[3]));
}

/// Gives pixels these bytes, but for those that are 0.
template <class Word>
inline void SmallPolygonScan::put(std::uint8_t* pixels, const std::uint8_t* bytes) {
  constexpr auto low = static_cast<Word>(0x7f7f7f7f7f7f7f7f);
  Word before, now;
  std::memcpy(&before, pixels, sizeof before);
  std::memcpy(&now, bytes, sizeof now);
  // All ones in bytes that are not 0
  const Word taken = ((((now & low) + low) | now) & ~low) / 0x80 * 0xff;
  now |= before & ~taken;
  std::memcpy(pixels, &now, sizeof now);
}

inline void SmallPolygonScan::put_row(std::uint8_t* pixels, const std::uint8_t* bytes, int columns) {
  // The last word overlaps the one before
  if (columns >= 8) {
    for (int i = 0; i < columns - 8; i += 8) put<std::uint64_t>(pixels + i, bytes + i);
    put<std::uint64_t>(pixels + columns - 8, bytes + columns - 8);
  } else if (columns >= 4) {
    put<std::uint32_t>(pixels, bytes);
    put<std::uint32_t>(pixels + columns - 4, bytes + columns - 4);
  } else {
    for (int i = 0; i < columns; ++i) pixels[i] = bytes[i] != 0 ? bytes[i] : pixels[i];
  }
}

inline bool SmallPolygonScan::draw(Raster<std::uint8_t>& picture, std::span<const Ring> rings) {
  using triangle_coverage::subpixels;
  if (rings.empty() || rings[0].empty()) return false;
  ivec2 lower = rings[0].front(), upper = lower;
  // Most that are larger are so from the first corner to the one in the middle
  const ivec2 middle = rings[0][rings[0].size() / 2];
  const auto apart = [](int a, int b) { return std::abs(std::int64_t{a} - b) > most * subpixels; };
  if (apart(lower.x, middle.x) || apart(lower.y, middle.y)) return false;
  const auto wide = [](int x) { return static_cast<std::uint64_t>(x); };
  std::uint64_t doubled = 0;  // twice the area; overflows cancel where the box is small
  std::size_t edges = 0;
  for (const Ring& ring : rings) {
    if (ring.empty()) continue;
    if ((edges += ring.size()) > most_corners) return false;
    ivec2 from = ring.back();
    for (const ivec2 to : ring) {
      lower = {std::min(lower.x, to.x), std::min(lower.y, to.y)};
      upper = {std::max(upper.x, to.x), std::max(upper.y, to.y)};
      doubled += wide(from.x) * wide(to.y) - wide(from.y) * wide(to.x);
      from = to;
    }
  }
  if (lower.x < 0 || lower.y < 0) return false;
  const int left = lower.x / subpixels, top = lower.y / subpixels;
  const int right = (upper.x - 1) / subpixels, bottom = (upper.y - 1) / subpixels;
  const int columns = right - left + 1, rows = bottom - top + 1;
  if (doubled == 0 || columns > most || rows > most) return false;
  if (right >= picture.width() || bottom >= picture.height()) return false;

  // Whether sums may be off: not where all edges are upright, level or diagonal
  bool rounded = false;
  const ivec2 corner{left * subpixels, top * subpixels};
  for (const Ring& ring : rings) {
    if (ring.empty()) continue;
    ivec2 from = ring.back() - corner;
    for (const ivec2 outer : ring) {
      const ivec2 to = outer - corner;
      const ivec2 d = to - from;
      rounded |= std::int64_t{d.x * d.y} * (d.x * d.x - d.y * d.y) != 0;
      add_edge(from, to);
      from = to;
    }
  }
  // Covered lies right of edges that go up where the rings run clockwise, as one sees them. Sums without an
  // error get what ends at a half above it.
  const double scale = static_cast<std::int64_t>(doubled) > 0 ? -255 : 255, bias = rounded ? 0 : 0x1p-20;
  Bytes bytes;
  double off = 0;
  for (int row = 0; row < rows; row += lanes) off = std::max(off, sweep(row, columns, scale, bias, bytes));
  // Crossings are off by less than 2^-46, what an edge changes in a row by 2^-44, sums of 256 by 2^-43 for
  // each: a byte by less than 2^-34 for each edge
  if (rounded && off > 0.5 - 0x1p-34 * static_cast<double>(edges)) return false;
  for (int row = 0; row < rows; ++row)
    put_row(picture.row(top + row).data() + left, bytes.data() + std::size_t(row) * most, columns);
  return true;
}

}  // namespace gradus::area_sampling
