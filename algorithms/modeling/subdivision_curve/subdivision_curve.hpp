#pragma once
// Corner cutting: of every edge of a polygon its middle half stays, round after round, until no corner is
// seen. What it tends to is the uniform quadratic B-spline of the polygon: a parabola at each corner.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::subdivision_curve {

/// Whether a last edge leads from the last corner back to the first.
enum class Ends : std::uint8_t { open, closed };

template <class T>
using Point = glm::vec<2, T>;
template <class T>
using Points = std::vector<Point<T>>;

/// As many points as one may ask for.
inline constexpr std::int64_t most_points = std::int64_t{1} << 24;

// --- Steps -------------------------------------------------------

/// An edge has given way to its middle half, from q to r.
template <class T>
struct EdgeCut {
  int round;         ///< from 1 on
  std::size_t edge;  ///< from 0 on
  Segment<2, T> whole;
  Point<T> q, r;
};

/// All edges of a round were cut.
struct RoundDone {
  int round;
  std::int64_t points;  ///< that it leaves
};

/// A piece of a B-spline: it leaves `from` towards the control point and arrives at `to` from there.
template <class T>
struct Parabola {
  Point<T> from, control, to;

  /// The point at t from 0 to 1, by two rounds of dividing in proportion.
  Point<T> at(const T& t) const {
    const T s = T(1) - t;
    const Point<T> a = s * from + t * control;
    const Point<T> b = s * control + t * to;
    return s * a + t * b;
  }
};

/// The limit's piece at a corner was found.
template <class T>
struct ArcFound {
  std::size_t corner;  ///< of the polygon, from 0 on
  Parabola<T> arc;
};

struct Finished {
  std::int64_t points;  ///< or arcs
};

/// Numbers the corners of the arcs, from that of the first one on.
struct ArcsFound {
  std::size_t count = 0;

  template <class T>
  ArcFound<T> operator()(ArcFound<T> step) {
    step.corner += count++;
    return step;
  }
};

// --- Edges and corners -------------------------------------------

template <class T>
std::vector<Segment<2, T>> edges(const Points<T>& p, Ends ends) {
  std::vector<Segment<2, T>> all;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) all.push_back({p[i], p[i + 1]});
  if (ends == Ends::closed) all.push_back({p.back(), p.front()});
  return all;
}

/// A corner with its neighbours. The ends of an open polygon are none.
template <class T>
struct Corner {
  Point<T> before, at, after;
};
template <class T>
std::vector<Corner<T>> corners(const Points<T>& p, Ends ends) {
  const std::size_t n = p.size();
  const std::size_t skip = ends == Ends::open;
  std::vector<Corner<T>> all;
  for (auto i = skip; i + skip < n; ++i) {
    const auto& before = p[(i + n - 1) % n];
    const auto& after = p[(i + 1) % n];
    all.push_back({before, p[i], after});
  }
  return all;
}

template <class T>
void expect_polygon(const Points<T>& polygon) {
  expects(polygon.size() >= 3, "a polygon has at least three corners, not {}", polygon.size());
  for (const Point<T>& p : polygon) expects(all_finite(p.x, p.y), "a corner is not finite");
}

// --- The methods -------------------------------------------------

/// Cuts the corners of a polygon, so many rounds. Returns the points of the last.
/// Source: G. M. Chaikin, An algorithm for high-speed curve generation, 1974.
///
/// points: its corners. rounds: how often. ends: open, then the ends are cut off like corners, or closed.
///
/// Domain: at least three corners, finite; rounds >= 0; at most 2^24 points in the end.
/// Steps: EdgeCut for each edge, RoundDone after each round, Finished.
/// Accuracy: each coordinate within 2 u M and the smallest subnormal number per round, where M is the largest
///   coordinate and u = 2^-53 in double; no sum overflows. Each round leaves a quarter of the distance to the
///   limit.
/// Cost: four products per new point; 2^rounds times as many points.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<EdgeCut<T>, RoundDone, Finished> O = Unobserved>
Points<T> chaikin(Points<T> points, int rounds, Ends ends, O&& observer = {}) {
  expect_polygon(points);
  expects(0 <= rounds && rounds < 24 && std::ssize(points) << rounds <= most_points,
          "at most 2^24 points in the end, not {} rounds from {}", rounds, points.size());
  const T s(0.75), t(0.25);
  for (int k = 0; k < rounds; ++k) {
    Points<T> cut;
    cut.reserve(2 * points.size());
    auto all = edges(points, ends);
    for (auto [a, b] : all) {
      Point<T> q = s * a + t * b;
      Point<T> r = t * a + s * b;
      cut.insert(cut.end(), {q, r});
      if constexpr (observed<O>) observer(EdgeCut<T>{k + 1, cut.size() / 2 - 1, {a, b}, q, r});
    }
    swap(points, cut);
    if constexpr (observed<O>) observer(RoundDone{k + 1, std::ssize(points)});
  }
  if constexpr (observed<O>) observer(Finished{std::ssize(points)});
  return points;
}

/// What cutting corners tends to: for each corner a parabola from the middle of one edge to that of the next.
/// Source: R. F. Riesenfeld, On Chaikin's algorithm, 1975.
///
/// polygon: its corners. ends: as for chaikin. take(arc): for each corner, in their order.
///
/// Domain: at least three corners, finite.
/// Steps: ArcFound for each corner, Finished.
/// Accuracy: middles of edges correctly rounded, but for subnormal numbers; a point of an arc by Parabola::at
///   within 8 u M and eight of the smallest subnormal numbers.
/// Cost: four products per corner.
/// Errors: ContractViolation outside the domain.
template <class T, class Take, Observer<ArcFound<T>, Finished> O = Unobserved>
void limit(const Points<T>& polygon, Ends ends, Take&& take, O&& observer = {}) {
  expect_polygon(polygon);
  Tally<O, ArcsFound> tally(observer);
  const T h(0.5);
  auto all = corners(polygon, ends);
  for (auto [a, b, c] : all) {
    Point<T> p = h * a + h * b;
    Point<T> q = h * b + h * c;
    // Tangent to both edges
    const Parabola<T> arc{p, b, q};
    take(arc);
    if constexpr (observed<O>) observer(tally.count(ArcFound<T>{ends == Ends::open, arc}));
  }
  if constexpr (observed<O>) observer(Finished{std::ssize(all)});
}

/// How far the farthest corner lies from the limit: an eighth of a second difference, |a - 2 b + c| / 8.
template <class T>
T distance_to_limit(const Points<T>& polygon, Ends ends) {
  T most(0);
  for (auto [a, b, c] : corners(polygon, ends)) {
    const auto m = T(0.5) * a + T(0.5) * c;
    most = std::max(most, length_of(m - b) / 4);
  }
  return most;
}

}  // namespace gradus::subdivision_curve
