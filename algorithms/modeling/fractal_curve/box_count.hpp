#pragma once
// Measuring a dimension: how many boxes of a grid a curve meets, box by box smaller.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::fractal_curve {

using Whole = std::int64_t;
using Line = Segment<2, Whole>;
/// Column and row. A box has its left and its lower side; the other two are its neighbours'.
using Box = glm::vec<2, Whole>;
using Boxes = std::vector<Box>;

// --- Steps -------------------------------------------------------

/// All boxes of a size were found.
struct SideCounted {
  Whole side;
  Boxes met;  ///< by columns, then rows
};

struct AllCounted {
  std::size_t sides;
};

/// How many boxes of a size there are.
struct Count {
  Whole side, boxes;
};

// --- Boxes of a segment ------------------------------------------

/// The quotient rounded down. Domain: b > 0.
constexpr Whole floor_div(Whole a, Whole b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Adds the boxes that a segment meets, column by column.
///
/// Domain: coordinates up to 2^30 in size, 1 <= side <= 2^30.
/// Accuracy: exact: quotients of whole numbers of 63 bits.
/// Cost: two divisions per column, and one addition per box.
inline void cover(Line l, Whole side, Boxes& met) {
  if (l.b.x < l.a.x) std::swap(l.a, l.b);
  const Whole dx = l.b.x - l.a.x, dy = l.b.y - l.a.y;
  const Whole first = floor_div(l.a.x, side), last = floor_div(l.b.x, side);
  // In which row it is at some x
  const auto row = [&](Whole x) { return floor_div(l.a.y * dx + dy * (x - l.a.x), dx * side); };
  for (Whole c = first; c <= last; ++c) {
    Whole from = floor_div(l.a.y, side), to = floor_div(l.b.y, side);
    if (c > first) from = row(c * side);
    // The right side belongs to the next column: a rise that ends in a corner there ends below it
    if (c < last) {
      const Whole above = -(l.a.y * dx + dy * ((c + 1) * side - l.a.x));
      to = dy > 0 ? -floor_div(above, dx * side) - 1 : row((c + 1) * side);
    }
    for (Whole r = std::min(from, to); r <= std::max(from, to); ++r) met.push_back({c, r});
  }
}

/// Each box once.
inline void sort_unique(Boxes& boxes) {
  const auto before = [](Box a, Box b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::ranges::sort(boxes, before);
  const auto same = std::ranges::unique(boxes);
  boxes.erase(same.begin(), same.end());
}

inline void expect_boxes(std::span<const Line> lines, std::span<const Whole> sides) {
  constexpr Whole most = Whole{1} << 30, most_boxes = Whole{1} << 24;
  Whole length = 0;
  for (const auto& [a, b] : lines) {
    for (const Whole x : {a.x, a.y, b.x, b.y})
      expects(-most <= x && x <= most, "coordinates up to 2^30 in size, not {}", x);
    length += std::abs(b.x - a.x) + std::abs(b.y - a.y);
  }
  for (const Whole side : sides) {
    expects(1 <= side && side <= most, "boxes of 1 to 2^30, not {}", side);
    expects(length / side + 3 * std::ssize(lines) <= most_boxes, "at most 2^24 boxes, more of side {}", side);
  }
}

// --- The method --------------------------------------------------

/// Counts the boxes of a grid that a curve meets, for boxes of several sizes.
/// Source: B. B. Mandelbrot, The fractal geometry of nature, 1982; K. Falconer, Fractal geometry, 1990,
/// section 3.1.
///
/// lines: the curve's segments, of whole numbers. sides: of the boxes, one of which has its lower left corner
///   at 0.
///
/// Domain: coordinates up to 2^30 in size; sides from 1 to 2^30; at most 2^24 boxes.
/// Steps: SideCounted for each side, AllCounted.
/// Accuracy: exact: boxes are half open, so each point lies in one of them.
/// Cost: for each side, the boxes of all segments, sorted.
/// Errors: ContractViolation outside the domain.
template <Observer<SideCounted, AllCounted> O = Unobserved>
std::vector<Count> box_count(std::span<const Line> lines, std::span<const Whole> sides, O&& observer = {}) {
  expect_boxes(lines, sides);
  std::vector<Count> counts;
  for (Whole side : sides) {
    Boxes met;
    for (const Line& l : lines) {
      cover(l, side, met);
    }
    // Each box once
    sort_unique(met);
    Whole n = std::ssize(met);
    counts.push_back({side, n});
    if constexpr (observed<O>) observer(SideCounted{side, met});
  }
  if constexpr (observed<O>) observer(AllCounted{counts.size()});
  return counts;
}

/// A straight line through points, by least squares.
struct Fit {
  double slope, at_0;
  double error;  ///< the standard error of the slope
};

/// The line of log boxes over log 1/side: its slope is the measured dimension.
/// Source: as above; the standard error as in any text on linear regression.
///
/// Domain: three counts or more, not all of one side, each of one box or more.
/// Accuracy: that of some dozens of roundings.
inline Fit fitted(std::span<const Count> counts) {
  const auto n = static_cast<double>(counts.size());
  expects(counts.size() >= 3, "three counts or more, not {}", counts.size());
  std::vector<dvec2> points;
  dvec2 mean{};
  for (const auto& [side, boxes] : counts) {
    expects(boxes >= 1, "a count of {} boxes", boxes);
    points.push_back({-gradus::log(static_cast<double>(side)), gradus::log(static_cast<double>(boxes))});
    mean += points.back() / n;
  }
  double xx = 0, xy = 0, rest = 0;
  for (const dvec2 p : points) {
    xx += (p.x - mean.x) * (p.x - mean.x);
    xy += (p.x - mean.x) * (p.y - mean.y);
  }
  expects(xx > 0, "counts of more than one side");
  const double slope = xy / xx, at_0 = mean.y - slope * mean.x;
  for (const dvec2 p : points) rest += (p.y - at_0 - slope * p.x) * (p.y - at_0 - slope * p.x);
  return {slope, at_0, std::sqrt(rest / (n - 2) / xx)};
}

}  // namespace gradus::fractal_curve
