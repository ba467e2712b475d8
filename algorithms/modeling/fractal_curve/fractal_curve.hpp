#pragma once
// The Koch curve: every segment gives way to four a third as long, level after level. Its corners are whole
// numbers of a lattice of triangles, so that nothing is rounded before the curve is laid into the plane.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::fractal_curve {

using Index = std::size_t;

/// x + y w, where w is 1 turned to the left by 60 degrees: a corner of a lattice of equilateral triangles.
using Corner = ivec2;
using Corners = std::vector<Corner>;

/// As many segments as one may ask for.
inline constexpr std::int64_t most_segments = std::int64_t{1} << 24;

// --- Steps -------------------------------------------------------

/// A segment has given way to four, from each of five corners to the next.
struct Replaced {
  int level;                  ///< from 1 on
  Index segment;              ///< of the level before, from 0 on
  std::array<Corner, 5> way;  ///< on this level's lattice
};

/// All segments of a level were replaced.
struct LevelDone {
  int level;
  std::int64_t segments;   ///< that it has
  std::int64_t triangles;  ///< of its lattice that it and its base enclose
};

struct Finished {
  std::int64_t segments;
};

// --- The lattice -------------------------------------------------

/// The corner times w: turned to the left by 60 degrees about 0.
constexpr Corner turned(Corner c) { return {-c.y, c.x + c.y}; }
/// Turned to the right.
constexpr Corner turned_back(Corner c) { return {c.x + c.y, -c.x}; }

constexpr std::int64_t power(std::int64_t base, int exponent) {
  std::int64_t product = 1;
  for (int k = 0; k < exponent; ++k) product *= base;
  return product;
}

/// How many triangles of the lattice lie to the right of a way that is closed by a straight line, less those
/// to its left.
inline std::int64_t triangles_of(const Corners& way) {
  std::int64_t sum = 0;
  for (Index i = 0; i < way.size(); ++i) {
    const Corner &a = way[i], &b = way[(i + 1) % way.size()];
    sum += std::int64_t{a.y} * b.x - std::int64_t{a.x} * b.y;
  }
  return sum;
}

/// What is begun with: a segment from 0 to 1, or three round a triangle that lies to their right.
enum class Shape : std::uint8_t { curve, snowflake };
inline Corners base_of(Shape shape) {
  if (shape == Shape::curve) return {{0, 0}, {1, 0}};
  return {{0, 0}, {0, 1}, {1, 0}, {0, 0}};
}

inline void append(Corners& all, std::initializer_list<Corner> more) {
  all.insert(all.end(), more.begin(), more.end());
}

inline void expect_way(const Corners& way, int levels) {
  constexpr int most_levels = 12;
  expects(way.size() >= 2, "a way has at least two corners, not {}", way.size());
  expects(0 <= levels && levels <= most_levels && (std::ssize(way) - 1) << 2 * levels <= most_segments,
          "at most 2^24 segments in the end, not {} levels from {}", levels, way.size() - 1);
  const std::int64_t most = (std::int64_t{1} << 28) / power(3, levels);
  for (const Corner c : way)
    expects(-most <= c.x && c.x <= most && -most <= c.y && c.y <= most,
            "corners up to {} in size for {} levels, not ({}, {})", most, levels, c.x, c.y);
}

// --- The taught method -------------------------------------------

/// Replaces each segment by four a third as long, so many levels: there and back over a tip to its left.
/// Returns the corners on the last level's lattice, whose unit is 3^levels times smaller.
/// Source: H. von Koch, Sur une courbe continue sans tangente, obtenue par une construction géométrique
/// élémentaire, 1904.
///
/// p: the corners of what is begun with, two or more; closed where the last is the first. levels: how often.
///
/// Domain: 0 <= levels <= 12; at most 2^24 segments in the end; corners up to 2^28 / 3^levels in size.
/// Steps: (Replaced for each segment, LevelDone) for each level, Finished.
/// Accuracy: exact: sums of whole numbers.
/// Cost: seven sums of corners per segment of each level; four times as many segments a level.
/// Errors: ContractViolation outside the domain.
template <Observer<Replaced, LevelDone, Finished> O = Unobserved>
Corners koch(Corners p, int levels, O&& observer = {}) {
  expect_way(p, levels);
  for (int k = 0; k < levels; ++k) {
    const Index n = p.size();
    // A third is the unit now
    Corners finer{3 * p[0]};
    finer.reserve(4 * n);
    for (Index i = 1; i < n; ++i) {
      Corner t = p[i] - p[i - 1];
      Corner a = 3 * p[i - 1];
      Corner b = a + t;
      Corner c = b + turned(t);
      Corner d = b + t;
      Corner e = d + t;
      append(finer, {b, c, d, e});
      if constexpr (observed<O>) observer(Replaced{k + 1, i - 1, {a, b, c, d, e}});
    }
    swap(p, finer);
    if constexpr (observed<O>) observer(LevelDone{k + 1, std::ssize(p) - 1, triangles_of(p)});
  }
  if constexpr (observed<O>) observer(Finished{std::ssize(p) - 1});
  return p;
}

// --- In the plane ------------------------------------------------

/// Where a corner of that level lies when 0 is laid at base.a and 1 at base.b.
///
/// Domain: corners of levels of base_of(); numbers up to 2^1020 in size.
/// Accuracy: within 14 u M and two of the smallest subnormal numbers, where M is the base's largest
///   coordinate and u = 2^-53; its ends are exact. The error is that of one corner, at every level.
inline dvec2 in_plane(Corner c, int level, const Segment<2, double>& base) {
  constexpr double root_of_3 = 1.7320508075688772;
  const auto whole = static_cast<double>(2 * power(3, level));
  const double along = 2 * c.x + c.y, aside = c.y;
  const double r = (whole - along) / whole, s = along / whole, h = root_of_3 * aside / whole;
  const dvec2 &a = base.a, &b = base.b;
  return r * a + s * b + h * dvec2{a.y - b.y, b.x - a.x};
}

/// All corners of a way.
inline std::vector<dvec2> in_plane(const Corners& way, int level, const Segment<2, double>& base) {
  std::vector<dvec2> points;
  points.reserve(way.size());
  for (const Corner c : way) points.push_back(in_plane(c, level, base));
  return points;
}

/// The dimension of what consists of so many parts, each `smaller` times smaller: log parts / log smaller.
/// Domain: parts >= 1, smaller > 1. Accuracy: that of two logarithms and a quotient.
inline double similarity_dimension(double parts, double smaller) {
  return gradus::log(parts) / gradus::log(smaller);
}

}  // namespace gradus::fractal_curve
