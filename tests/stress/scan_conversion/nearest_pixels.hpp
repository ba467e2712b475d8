#pragma once
// Lines and circles of pixels by their definition, in 128 bits: the oracle of Bresenham's methods.

#include <cmath>
#include <cstdint>

#include "core/geometry.hpp"

namespace gradus::stress {

__extension__ using Wide = __int128;

constexpr Wide absolute(Wide x) { return x < 0 ? -x : x; }

/// How far a line goes along the axis that it covers more of, and along the other.
struct LineWays {
  bool steep;
  Wide along, aside;

  LineWays(ivec2 from, ivec2 to) {
    const Wide dx = Wide{to.x} - from.x, dy = Wide{to.y} - from.y;
    steep = absolute(dy) > absolute(dx);
    along = steep ? dy : dx;
    aside = steep ? dx : dy;
  }
};

/// The number of a line's last pixel.
inline std::int64_t last_of_line(ivec2 from, ivec2 to) {
  return static_cast<std::int64_t>(absolute(LineWays(from, to).along));
}

/// Pixel number k of a line: the place of the line, rounded aside, midway to the smaller coordinate.
inline ivec2 pixel_of_line(ivec2 from, ivec2 to, std::int64_t k) {
  const LineWays line(from, to);
  if (line.along == 0) return from;
  const Wide length = absolute(line.along);
  // ceil(aside k / length - 1/2)
  const Wide above = 2 * line.aside * k + length - 1, below = 2 * length;
  const Wide row = above / below - (above % below < 0 ? 1 : 0);
  const std::int64_t forward = line.along > 0 ? k : -k;
  if (line.steep) return {static_cast<int>(from.x + row), static_cast<int>(from.y + forward)};
  return {static_cast<int>(from.x + forward), static_cast<int>(from.y + row)};
}
inline bool on_line(ivec2 from, ivec2 to, ivec2 p) {
  const LineWays line(from, to);
  const Wide way = line.steep ? Wide{p.y} - from.y : Wide{p.x} - from.x;
  const Wide k = line.along < 0 ? -way : way;
  return 0 <= k && k <= absolute(line.along) && p == pixel_of_line(from, to, static_cast<std::int64_t>(k));
}
/// How far a pixel is from the line along the axis that the line covers less of.
inline double off_line(ivec2 from, ivec2 to, ivec2 p) {
  const Wide dx = Wide{to.x} - from.x, dy = Wide{to.y} - from.y, x = Wide{p.x} - from.x,
             y = Wide{p.y} - from.y;
  const Wide longer = std::max(absolute(dx), absolute(dy));
  if (longer == 0) return static_cast<double>(std::max(absolute(x), absolute(y)));
  return static_cast<double>(absolute(dx * y - dy * x)) / static_cast<double>(longer);
}

/// Whether b is the whole number nearest to a circle's height in column a: b - 1/2 < sqrt(r^2 - a^2) < b +
/// 1/2. There is no third case: the square of a whole number and a half is none.
inline bool is_height(Wide radius, Wide a, Wide b) {
  const Wide squared = 4 * (radius * radius - a * a);
  return squared >= 0 && (b == 0 || (2 * b - 1) * (2 * b - 1) < squared) &&
         squared < (2 * b + 1) * (2 * b + 1);
}
/// Folded into the first octant, the pixel is the nearest one of its column.
inline bool on_circle(ivec2 center, int radius, ivec2 p) {
  const Wide x = absolute(Wide{p.x} - center.x), y = absolute(Wide{p.y} - center.y);
  return is_height(radius, std::min(x, y), std::max(x, y));
}
/// How far a pixel is from the circle along the radius.
inline double off_circle(ivec2 center, int radius, ivec2 p) {
  const dvec2 at = dvec2(p) - dvec2(center);
  return std::abs(std::sqrt(at.x * at.x + at.y * at.y) - radius);
}

}  // namespace gradus::stress
