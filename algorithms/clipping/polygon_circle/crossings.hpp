#pragma once
// Where a polygon's boundary passes through a circle, and in which order round it: exactly.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "clipping/liang_barsky_circle/circle_and_line.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/exact_polynomial.hpp"
#include "core/points.hpp"

namespace gradus::polygon_circle {

using liang_barsky_circle::chord_on;
using liang_barsky_circle::expect_circle;
using liang_barsky_circle::foot_between;
using liang_barsky_circle::in_double;
using liang_barsky_circle::reach;
using liang_barsky_circle::side;

// --- The polygon ------------------------------------------------------------------------------------------

/// The exact sign of a polygon's area: +1 when its corners run counter-clockwise.
/// Domain: finite coordinates. Cost: two products of doubles a corner, in doubt as many exact ones.
inline int area_sign(std::span<const dvec2> corners) {
  double doubled = 0, size = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    doubled += a.x * b.y - a.y * b.x;
    size += std::abs(a.x * b.y) + std::abs(a.y * b.x);
  }
  const double bound = (static_cast<double>(corners.size()) + 4) * 0x1p-52 * size + 0x1p-900;
  if (doubled > bound) return 1;
  if (-doubled > bound) return -1;
  SumOfProducts<2> exact;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    exact.add(a.x, b.y);
    exact.subtract(a.y, b.x);
  }
  return exact.sign();
}

/// The polygon counter-clockwise, from the same first corner, no corner twice in a row; empty where it has no
/// area.
template <std::floating_point T>
std::vector<dvec2> counter_clockwise(std::span<const glm::vec<2, T>> polygon) {
  std::vector<dvec2> corners;
  for (const glm::vec<2, T> p : polygon) {
    liang_barsky_circle::expect_finite(p);
    if (corners.empty() || corners.back() != dvec2(p)) corners.push_back(dvec2(p));
  }
  while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
  const int sign = area_sign(corners);
  if (corners.size() < 3 || sign == 0) return {};
  if (sign < 0) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}
/// The same for points in a vector, an array or braces.
template <OtherPointRow<2> Points = PointsInBraces<2>>
std::vector<dvec2> counter_clockwise(const Points& polygon) {
  return counter_clockwise(span_of(polygon));
}

/// Whether a point lies in a polygon; of a point on its boundary it says either.
/// Domain: finite coordinates. Accuracy: exact.
inline bool contains(std::span<const dvec2> corners, dvec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    // The ray from p to the right meets the edge
    if ((a.y > p.y) == (b.y > p.y)) continue;
    inside ^= orient2d(a, b, p) == (a.y < b.y ? 1 : -1);
  }
  return inside;
}

/// Two edges of a polygon that meet although they are no neighbours, or lie on each other.
struct Meeting {
  std::size_t first, second;
};

/// The first two edges that keep a polygon from being simple, or nothing.
/// Domain: finite coordinates. Accuracy: exact. Cost: O(n^2).
inline std::optional<Meeting> meeting_edges(std::span<const dvec2> corners) {
  const std::size_t n = corners.size();
  // Whether p, on the line of a and b, lies between them
  const auto between = [](dvec2 a, dvec2 b, dvec2 p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const dvec2 a = corners[i], b = corners[(i + 1) % n];
    for (std::size_t j = i + 1; j < n; ++j) {
      const dvec2 c = corners[j], d = corners[(j + 1) % n];
      const int abc = orient2d(a, b, c), abd = orient2d(a, b, d);
      if (j == i + 1) {  // neighbours share b: does the second turn back?
        if (abd == 0 && (between(a, b, d) || between(b, d, a))) return Meeting{i, j};
        continue;
      }
      const int cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
      if (i == 0 && j == n - 1) {  // share a
        if (abc == 0 && (between(a, b, c) || between(a, c, b))) return Meeting{i, j};
        continue;
      }
      const bool across = abc * abd < 0 && cda * cdb < 0;
      const bool touches = (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
                           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
      if (across || touches) return Meeting{i, j};
    }
  }
  return std::nullopt;
}

/// Edge number i, from corner i to the next one.
inline Segment<2, double> edge_of(std::span<const dvec2> corners, std::size_t i) {
  return {corners[i], corners[(i + 1) % corners.size()]};
}

// --- Its passages through the circle ----------------------------------------------------------------------

/// A point where the boundary passes into the open disc or out of it.
struct Crossing {
  std::size_t edge;                   ///< from corner `edge` to the next one
  bool leaves;                        ///< out of the disc
  std::optional<std::size_t> corner;  ///< the corner, where one lies on the circle itself
  dvec2 at;
  dvec2 direction;  ///< from the centre, in radii; within 2^-50
};

/// How an edge runs in the open disc.
struct Run {
  Segment<2, double> edge;
  int from, to;  ///< the sides of its ends: -1 inside, 0 on the circle, +1 outside
  bool inside;   ///< part of it lies in the open disc
  bool enters() const { return inside && from >= 0; }
  bool leaves() const { return inside && to >= 0; }
};

/// Domain: finite coordinates. Accuracy: exact. An edge that only touches the circle does not run in it.
inline Run run_of(const Segment<2, double>& edge, const Circle<double>& circle) {
  const int from = side(edge.a, circle), to = side(edge.b, circle);
  const bool inside = from < 0 || to < 0 || (foot_between(edge, circle.centre) && reach(edge, circle) > 0);
  return {edge, from, to, inside};
}

/// The passages of edge number i of n: none, one or two, in the edge's direction.
inline void add_crossings(std::vector<Crossing>& crossings, const Run& run, std::size_t i, std::size_t n,
                          const Circle<double>& circle) {
  if (!run.enters() && !run.leaves()) return;
  const auto chord = chord_on(run.edge, circle);
  const auto add = [&](bool leaves) {
    const bool second = leaves != chord.turned;
    const dvec2 direction = dvec2(chord.chord.x(second).value, chord.chord.y(second).value) / chord.radius;
    const bool on_circle = (leaves ? run.to : run.from) == 0;
    const dvec2 end = leaves ? run.edge.b : run.edge.a;
    const std::size_t corner = leaves ? (i + 1) % n : i;
    crossings.push_back({i, leaves, on_circle ? std::optional(corner) : std::nullopt,
                         on_circle ? end : chord.crossing(leaves), direction});
  };
  if (run.enters()) add(false);
  if (run.leaves()) add(true);
}

// --- Their order round the circle -------------------------------------------------------------------------

/// Tells which of two passages comes first, counter-clockwise from the direction of +x, exactly. Directions
/// that differ by more than their error decide in doubles; else signs of a + b sqrt(D) and of
/// a + b sqrt(D1) + c sqrt(D2), where x = (-k dy ± sqrt(D) dx) / A and y = (k dx ± sqrt(D) dy) / A.
class CircleOrder {
 public:
  CircleOrder(std::span<const dvec2> corners, const Circle<double>& circle)
      : corners_(corners), circle_(circle) {}

  /// 0: angles in [0, pi), 1: angles in [pi, 2 pi).
  int half(const Crossing& c) const {
    if (c.direction.y > error) return 0;
    if (c.direction.y < -error) return 1;
    const liang_barsky_circle::ExactLine line(edge(c), circle_);
    const int y = sign_with_root(line.k * line.dx, c.leaves ? line.dy : -line.dy, line.D);
    if (y != 0) return y > 0 ? 0 : 1;
    const int x = sign_with_root(-(line.k * line.dy), c.leaves ? line.dx : -line.dx, line.D);
    return x > 0 ? 0 : 1;
  }

  /// Whether a comes before b. Where both lie at one corner the polygon's inside decides: at a convex corner
  /// nothing lies between the exit and the entry, at a reflex one the whole circle does. Passages of a
  /// polygon that meets itself at one point have an order, too, or no sorting would be safe.
  bool operator()(const Crossing& a, const Crossing& b) const {
    if (a.corner && a.corner == b.corner) return a.leaves != b.leaves && a.leaves == convex(*a.corner);
    const int half_a = half(a), half_b = half(b);
    if (half_a != half_b) return half_a < half_b;
    const double turn = a.direction.x * b.direction.y - a.direction.y * b.direction.x;
    if (turn > 8 * error) return true;
    if (turn < -8 * error) return false;
    const int x = compare_x(a, b);
    if (x == 0) return place(a) < place(b);
    return half_a == 0 ? x > 0 : x < 0;
  }

  /// Whether the way from a passage counter-clockwise to another is longer than half the circle.
  bool more_than_half(const Crossing& from, const Crossing& to) const {
    const double turn = from.direction.x * to.direction.y - from.direction.y * to.direction.x;
    if (turn > 8 * error) return false;
    if (turn < -8 * error) return true;
    const int half_from = half(from), half_to = half(to);
    if (half_from == half_to) return !(*this)(from, to);
    // In different halves: does the way pass the point opposite to `from`?
    const int x = compare_x(from, to, true);
    return half_from == 0 ? x > 0 : x < 0;
  }

 private:
  Segment<2, double> edge(const Crossing& c) const { return edge_of(corners_, c.edge); }
  /// The same for both passages of a corner.
  std::size_t place(const Crossing& c) const { return c.corner ? *c.corner : corners_.size() + c.edge; }
  bool convex(std::size_t corner) const {
    const std::size_t n = corners_.size();
    return orient2d(corners_[(corner + n - 1) % n], corners_[corner], corners_[(corner + 1) % n]) > 0;
  }
  /// The sign of a's x less b's, or less that of the point opposite to b; over a common denominator.
  int compare_x(const Crossing& a, const Crossing& b, bool opposite = false) const {
    const liang_barsky_circle::ExactLine p(edge(a), circle_), q(edge(b), circle_);
    const Form<3> p_root = q.A * p.dx, q_root = p.A * q.dx;
    const Form<5> p_foot = q.A * (p.k * p.dy), q_foot = p.A * (q.k * q.dy);
    return sign_with_roots((opposite ? -q_foot : q_foot) - p_foot, a.leaves ? p_root : -p_root, p.D,
                           b.leaves != opposite ? -q_root : q_root, q.D);
  }

  static constexpr double error = 0x1p-50;  // of a direction
  std::span<const dvec2> corners_;
  Circle<double> circle_;
};

}  // namespace gradus::polygon_circle
