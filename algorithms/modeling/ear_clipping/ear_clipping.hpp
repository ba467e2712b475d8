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
#include <vector>

#include "core/contract.hpp"
#include "core/exact.hpp"
#include "core/observe.hpp"

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

/// The polygon without the axis along which its plane is steepest to the others, turned so that it runs
/// counter-clockwise: flat polygons in space become polygons of the plane. Coordinates are copied, not
/// computed. Domain: at least 3 corners.
template <class T>
std::vector<glm::vec<2, T>> flattened(std::span<const glm::vec<3, T>> polygon) {
  using Vec2 = glm::vec<2, T>;
  // Newell's normal
  glm::vec<3, T> normal{T(0), T(0), T(0)};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    normal += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  const auto size = [](T x) { return x < T(0) ? -x : x; };
  const T x = size(normal.x), y = size(normal.y), z = size(normal.z);
  std::vector<Vec2> flat;
  flat.reserve(polygon.size());
  for (const glm::vec<3, T>& p : polygon) {
    if (z >= x && z >= y) {
      flat.push_back(normal.z < T(0) ? Vec2{p.y, p.x} : Vec2{p.x, p.y});
    } else if (y >= x) {
      flat.push_back(normal.y < T(0) ? Vec2{p.x, p.z} : Vec2{p.z, p.x});
    } else {
      flat.push_back(normal.x < T(0) ? Vec2{p.z, p.y} : Vec2{p.y, p.z});
    }
  }
  return flat;
}

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
/// polygon: the corners, counter-clockwise. emit(Triangle) gets each triangle, counter-clockwise; a convex
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
void triangulate(std::span<const glm::vec<2, T>> polygon, Emit&& emit, O&& observer = {}) {
  const int n = int(polygon.size());
  expects(n >= 3, "a polygon has at least 3 corners, not {}", n);
  Ring ring(n);
  int at = 1;
  int failed = 0;  // tests since the last ear
  while (ring.size() > 2) {
    // An ear is convex and holds no corner
    const auto v = judge(polygon, ring, at);
    if constexpr (observed<O>) observer(v);
    if (!v.ear && ++failed < ring.size()) {
      at = ring.next(at);
      continue;
    }
    if (!v.ear) at = forced(polygon, ring);
    // Cut it off
    const Triangle ear = ring.triangle(at);
    emit(ear);
    ring.remove(at);
    if constexpr (observed<O>) observer(Cut{ear, ring.size(), !v.ear});
    at = ear[2];
    failed = 0;
  }
  if constexpr (observed<O>) observer(Finished{n - 2});
}

/// The same for a flat polygon in space, seen from the side on which it runs counter-clockwise.
template <class T, class Emit, Observer<Tested, Cut, Finished> O = Unobserved>
void triangulate(std::span<const glm::vec<3, T>> polygon, Emit&& emit, O&& observer = {}) {
  expects(polygon.size() >= 3, "a polygon has at least 3 corners, not {}", polygon.size());
  const auto flat = flattened(polygon);
  std::span<const glm::vec<2, T>> all = flat;
  triangulate(all, emit, observer);
}

}  // namespace gradus::ear_clipping
