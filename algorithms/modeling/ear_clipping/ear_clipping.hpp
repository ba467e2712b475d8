#pragma once
// Cutting a polygon into triangles by taking off its ears, one after the other.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "core/points.hpp"

namespace gradus::ear_clipping {

/// Three corners, as numbers into the polygon.
using Triangle = std::array<int, 3>;

/// A corner was tested: it is an ear when it is convex and the triangle with its neighbours holds no other
/// corner.
struct Tested {
  int before, corner, after;
  int turn;                    ///< +1 convex, 0 straight, -1 reflex
  std::optional<int> blocker;  ///< a corner in the triangle
  bool ear;
};

/// A triangle was cut off; `corner` is gone from the polygon.
struct Cut {
  Triangle triangle;
  int left;     ///< corners that remain
  bool forced;  ///< no ear was found (only straight corners are left, or the polygon crosses itself)
};

/// The polygon is cut up.
struct Finished {
  int triangles;
};

/// What triangulate asks of its polygon.
template <int N, class T>
void expect_polygon(std::span<const glm::vec<N, T>> polygon) {
  expects(polygon.size() >= 3, "a polygon has at least 3 corners, not {}", polygon.size());
  if constexpr (std::floating_point<T>) {
    for (const auto& p : polygon) {
      for (int i = 0; i < N; ++i)
        expects(std::isfinite(p[i]), "a polygon needs finite corners, not {}", p[i]);
    }
  }
}

// --- From space to the plane -------------------------------------

/// The axis along which a polygon casts its largest shadow, and how the shadow runs, seen from that axis's
/// positive side: 1 counter-clockwise, -1 clockwise, 0 it has no area.
struct Shadow {
  int axis;  ///< 0 x, 1 y, 2 z
  int turn;
};

/// The two axes of a shadow's plane: seen from its own axis they turn counter-clockwise.
constexpr std::array<int, 2> plane_of(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

/// The axis whose component is the largest; of equal ones z, then y.
template <class Size>
constexpr int largest_of(Size size) {
  int largest = 2;
  for (const int axis : {1, 0}) {
    if (size(axis) > size(largest)) largest = axis;
  }
  return largest;
}

namespace detail {

/// The components of Newell's normal in doubles, and what they may be off by.
struct Newell {
  glm::dvec3 normal{0.0}, error{0.0};
};
template <std::floating_point T>
Newell newell(std::span<const glm::vec<3, T>> polygon) {
  // Each product is rounded three times, each sum once: less than n + 4 half units of all that is added up,
  // and 2^-1074 for what underflows
  Newell sum;
  glm::dvec3 sizes{0.0};
  const glm::dvec3 origin(polygon[0]);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(polygon[i - 1]) - origin, b = glm::dvec3(polygon[i]) - origin;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [u, v] = plane_of(axis);
      const double left = a[u] * b[v], right = a[v] * b[u];
      sum.normal[axis] += left - right;
      sizes[axis] += std::abs(left) + std::abs(right);
    }
  }
  sum.error = 0x1p-50 * static_cast<double>(polygon.size()) * sizes + 0x1p-1000;
  return sum;
}

/// Adds a component of Newell's normal to an exact sum, or takes it away.
template <std::floating_point T>
void add_shadow(SumOfProducts<2>& sum, std::span<const glm::vec<3, T>> polygon, Shadow shadow) {
  const auto [u, v] = plane_of(shadow.axis);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a(polygon[i]), b(polygon[i + 1 < polygon.size() ? i + 1 : 0]);
    sum.add(shadow.turn * a[u], b[v]);
    sum.subtract(shadow.turn * a[v], b[u]);
  }
}
template <std::floating_point T>
Shadow largest_shadow_exact(std::span<const glm::vec<3, T>> polygon) {
  std::array<Shadow, 3> shadows{};
  for (int axis = 0; axis < 3; ++axis) {
    SumOfProducts<2> area;
    add_shadow(area, polygon, {axis, 1});
    shadows[static_cast<std::size_t>(axis)] = {axis, area.sign()};
  }
  Shadow largest = shadows[2];
  for (const Shadow& other : {shadows[1], shadows[0]}) {
    SumOfProducts<2> more;
    add_shadow(more, polygon, other);
    add_shadow(more, polygon, {largest.axis, -largest.turn});
    if (more.sign() > 0) largest = other;
  }
  return largest;
}

}  // namespace detail

/// The largest shadow: along the axis of the largest component of Newell's normal, which is twice its area.
/// F. Tampieri, Newell's method for computing the plane equation of a polygon, Graphics Gems III, 1992.
/// Domain: at least 3 corners, finite, of any size.
/// Accuracy: the turn is exact, and 0 only if no shadow has an area. Which of nearly equal shadows is the
///   larger one, rounding decides.
/// Cost: O(n), about 5 ns per corner; in doubt 1 us.
template <class T>
Shadow largest_shadow(std::span<const glm::vec<3, T>> polygon) {
  if constexpr (std::floating_point<T>) {
    const auto [normal, error] = detail::newell(polygon);
    const auto finite = [](glm::dvec3 v) { return std::isfinite(v.x + v.y + v.z); };
    if (!finite(normal) || !finite(error)) return detail::largest_shadow_exact(polygon);
    const int axis = largest_of([&normal](int i) { return std::abs(normal[i]); });
    if (normal[axis] > error[axis]) return {axis, 1};
    if (normal[axis] < -error[axis]) return {axis, -1};
    return detail::largest_shadow_exact(polygon);
  } else {
    glm::vec<3, T> normal{T(0), T(0), T(0)};
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      normal += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    }
    const int axis = largest_of([&normal](int i) { return normal[i] < T(0) ? -normal[i] : normal[i]; });
    return {axis, normal[axis] > T(0) ? 1 : normal[axis] < T(0) ? -1 : 0};
  }
}

/// The largest shadow of a polygon, turned so that it runs counter-clockwise: flat polygons in space become
/// polygons of the plane. Coordinates are copied, not computed. Domain: at least 3 corners, finite.
template <class T>
std::vector<glm::vec<2, T>> flattened(std::span<const glm::vec<3, T>> polygon) {
  const Shadow shadow = largest_shadow(polygon);
  auto [u, v] = plane_of(shadow.axis);
  if (shadow.turn < 0) std::swap(u, v);
  std::vector<glm::vec<2, T>> flat;
  flat.reserve(polygon.size());
  for (const glm::vec<3, T>& p : polygon) flat.push_back({p[u], p[v]});
  return flat;
}

/// Both for corners in a vector, an array or braces.
template <OtherPointRow<3> Points = PointsInBraces<3>>
Shadow largest_shadow(const Points& polygon) {
  return largest_shadow(span_of(polygon));
}
template <OtherPointRow<3> Points = PointsInBraces<3>>
auto flattened(const Points& polygon) {
  return flattened(span_of(polygon));
}

// --- In the plane ------------------------------------------------

/// What is left of a polygon: a ring of corners.
class Ring {
 public:
  explicit Ring(int size) : next_(static_cast<std::size_t>(size)), before_(next_.size()), size_(size) {
    for (int i = 0; i < size; ++i) {
      next_[static_cast<std::size_t>(i)] = (i + 1) % size;
      before_[static_cast<std::size_t>(i)] = (i + size - 1) % size;
    }
  }
  int next(int i) const { return next_[static_cast<std::size_t>(i)]; }
  int before(int i) const { return before_[static_cast<std::size_t>(i)]; }
  int size() const { return size_; }
  /// A corner of the ring.
  int any() const { return any_; }
  /// A corner with its neighbours.
  Triangle triangle(int i) const { return {before(i), i, next(i)}; }
  void remove(int i) {
    any_ = next(i);
    next_[static_cast<std::size_t>(before(i))] = next(i);
    before_[static_cast<std::size_t>(next(i))] = before(i);
    --size_;
  }

 private:
  std::vector<int> next_, before_;
  int size_;
  int any_ = 0;
};

/// +1 where the corner is convex, -1 where it is reflex, 0 where it is straight or turns back.
template <class T>
int turn_at(std::span<const glm::vec<2, T>> polygon, const Ring& ring, int corner) {
  const auto at = [&polygon](int i) { return polygon[static_cast<std::size_t>(i)]; };
  return orient2d(at(ring.before(corner)), at(corner), at(ring.next(corner)));
}

/// A corner of the ring that lies in the triangle at this convex corner or on its border, and is none of its
/// three places.
template <class T>
std::optional<int> blocker_of(std::span<const glm::vec<2, T>> polygon, const Ring& ring, int corner) {
  const auto at = [&polygon](int i) { return polygon[static_cast<std::size_t>(i)]; };
  const auto a = at(ring.before(corner)), b = at(corner), c = at(ring.next(corner));
  const int last = ring.before(corner);
  for (int i = ring.next(ring.next(corner)); i != last; i = ring.next(i)) {
    const auto p = at(i);
    if (p == a || p == b || p == c) continue;
    if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return i;
  }
  return std::nullopt;
}

/// Tests a corner.
template <class T>
Tested judge(std::span<const glm::vec<2, T>> polygon, const Ring& ring, int corner) {
  const int turn = turn_at(polygon, ring, corner);
  const auto blocker = turn > 0 ? blocker_of(polygon, ring, corner) : std::nullopt;
  return {ring.before(corner), corner, ring.next(corner), turn, blocker, turn > 0 && !blocker};
}

/// The corner to cut off when there is no ear: a straight one if there is, else (the polygon crosses itself)
/// any.
template <class T>
int forced(std::span<const glm::vec<2, T>> polygon, const Ring& ring) {
  int corner = ring.any();
  for (int i = 0; i < ring.size(); ++i, corner = ring.next(corner)) {
    if (turn_at(polygon, ring, corner) == 0) return corner;
  }
  return corner;
}

/// Cuts a polygon of the plane into triangles. Every simple polygon has an ear: a convex corner whose
/// triangle holds no other corner. Cut it off, and go on with what is left. G. H. Meisters, Polygons have
/// ears, American Mathematical Monthly 82, 1975, 648-651.
///
/// P: the corners, counter-clockwise. emit(Triangle) gets each triangle, counter-clockwise; a convex
///   polygon comes as a fan from corner 0.
///
/// Domain: at least 3 corners, finite. A simple polygon gives triangles that cover it exactly once; corners
///   on a line or at the same place may give some without area. One that crosses itself or runs clockwise
///   gives as many triangles, which cover something else.
/// Steps: (Tested+ Cut)* Finished.
/// Accuracy: the tests are exact; size - 2 triangles for every polygon.
/// Cost: O(n^2) usually, O(n^3) at worst; O(n) tests for a convex polygon.
/// Errors: ContractViolation for less than 3 corners or coordinates that are not finite.
template <class T, std::invocable<const Triangle&> Emit, Observer<Tested, Cut, Finished> O = Unobserved>
void triangulate(std::span<const glm::vec<2, T>> P, Emit&& emit, O&& observer = {}) {
  expect_polygon(P);
  const int n = int(P.size());
  Ring ring(n);
  int at = 1;
  // Tests since the last ear
  int failed = 0;
  while (ring.size() > 2) {
    // Convex, holding no corner?
    auto v = judge(P, ring, at);
    if constexpr (observed<O>) observer(v);
    const int left = ring.size();
    failed += v.ear ? 0 : 1;
    if (!v.ear && failed < left) {
      at = ring.next(at);
      continue;
    }
    // None at all: another one
    if (!v.ear) {
      at = forced(P, ring);
    }
    // Cut it off
    auto ear = ring.triangle(at);
    emit(ear);
    ring.remove(at);
    if constexpr (observed<O>) observer(Cut{ear, ring.size(), !v.ear});
    at = ear[2];
    failed = 0;
  }
  if constexpr (observed<O>) observer(Finished{n - 2});
}

/// The same for a flat polygon in space, seen from the side on which it runs counter-clockwise.
///
/// Domain: at least 3 corners, finite, of any size. Of a polygon that isn't quite flat its largest shadow
/// along
///   an axis is cut.
/// Steps, Cost: as above.
/// Accuracy: exact: the shadow's coordinates are the polygon's own.
/// Errors: as above.
template <class T, class Emit, Observer<Tested, Cut, Finished> O = Unobserved>
void triangulate(std::span<const glm::vec<3, T>> polygon, Emit&& emit, O&& observer = {}) {
  expect_polygon(polygon);
  const auto flat = flattened(polygon);
  std::span<const glm::vec<2, T>> all = flat;
  triangulate(all, emit, observer);
}

/// Both for corners in a vector, an array or braces, whose numbers are doubles.
template <OtherPointRow<2> Points = PointsInBraces<2>, class Emit, class... Observed>
void triangulate(const Points& polygon, Emit&& emit, Observed&&... observer) {
  triangulate(span_of(polygon), emit, std::forward<Observed>(observer)...);
}
template <OtherPointRow<3> Points = PointsInBraces<3>, class Emit, class... Observed>
void triangulate(const Points& polygon, Emit&& emit, Observed&&... observer) {
  triangulate(span_of(polygon), emit, std::forward<Observed>(observer)...);
}

}  // namespace gradus::ear_clipping
