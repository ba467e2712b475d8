#pragma once
// Cutting a polygon off at the planes of clip space, in homogeneous coordinates and before the division, so
// that what lies behind the eye is gone when it comes.

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "core/points.hpp"

namespace gradus::sutherland_hodgman {

/// A plane of clip space that goes with an axis: inside is sign * p[axis] + bound * p.w >= 0. So {2, 1, 0} is
/// z >= 0, {0, -1, 1} is x <= w and {0, -1, 64} is x <= 64 w.
template <class T>
struct Plane {
  int axis;  ///< 0 x, 1 y, 2 z
  T sign;    ///< 1 or -1
  T bound;   ///< the limit in units of w
};

/// How far inside the plane a point lies; its sign is that of the exact comparison of the coordinate with
/// the rounded bound * w.
template <class T>
constexpr T distance(const Plane<T>& plane, const glm::vec<4, T>& p) {
  return unfused(plane.bound * p.w) + plane.sign * p[plane.axis];
}

/// A corner was tested against a plane.
template <class T>
struct Tested {
  Plane<T> plane;
  std::size_t corner;  ///< its number in the polygon as it came to this plane
  glm::vec<4, T> at;
  bool inside;
};

/// An edge leaves or enters through a plane, and gets a corner there.
template <class T>
struct Cut {
  Plane<T> plane;
  glm::vec<4, T> inside, outside;  ///< the ends of the edge
  T t;                             ///< the share of the way from the inside to the outside, in (0, 1)
  glm::vec<4, T> at;
};

/// A corner stays. Where its edge enters, the cut stands before it by now.
template <class T>
struct CornerKept {
  Plane<T> plane;
  std::size_t corner;  ///< its number in the polygon as it came to this plane
};

/// One plane is done with.
template <class T>
struct Passed {
  Plane<T> plane;
  std::size_t corners;  ///< that are left
};

/// Whether an edge has its ends strictly on the two sides.
template <class T>
constexpr bool crosses(T was, T is) {
  return (was > T(0) && is < T(0)) || (was < T(0) && is > T(0));
}

/// A new corner, on the edge between two others.
template <class T, class Vertex>
struct Crossing {
  Vertex vertex;
  glm::vec<4, T> inside, outside;  ///< the ends of the edge
  T t;                             ///< the share of the way from the inside to the outside
};

/// The corner where the edge between a and b meets the plane. It is computed from the end with the smaller
/// |w|, whichever way the edge runs: both faces at an edge get the same corner, and an end that is very far
/// away leaves no rounding errors of its size. The coordinate across the plane is not computed but copied
/// from bound * w, so that the corner lies on the plane and not beside it. Vertex: has a vec<4, T> `at`, and
/// mix(a, b, t) makes the vertex t of the way from a to b. Domain: a and b lie on the two sides of the plane.
template <class T, class Vertex>
constexpr Crossing<T, Vertex> cut(const Plane<T>& plane, const Vertex& a, const Vertex& b) {
  const bool leaves = distance(plane, a.at) > T(0);
  const Vertex &inside = leaves ? a : b, &outside = leaves ? b : a;
  const T from = distance(plane, inside.at), to = distance(plane, outside.at);
  const T t = from / (from - to);
  const auto size = [](T w) { return w < T(0) ? -w : w; };
  Vertex vertex = size(outside.at.w) < size(inside.at.w) ? mix(outside, inside, to / (to - from))
                                                         : mix(inside, outside, t);
  vertex.at[plane.axis] = T(0) - plane.sign * plane.bound * vertex.at.w;
  return {vertex, inside.at, outside.at, t};
}

/// A corner with a place and nothing else.
template <class T>
struct Point {
  glm::vec<4, T> at;
};

template <class T>
constexpr Point<T> mix(const Point<T>& a, const Point<T>& b, T t) {
  return {a.at + t * (b.at - a.at)};
}

/// The part of a polygon that lies inside a plane.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// polygon: the corners in order. Vertex: see cut. plane: the border itself is inside.
///
/// Domain: finite coordinates up to 2^1020 / (1 + bound), so that no difference overflows. Of a concave
///   polygon pieces may hang together by edges that run along the plane.
/// Steps: (Tested Cut? CornerKept?)* Passed, Tested once for every corner.
/// Accuracy: corners inside are copied; a cut lies on the plane to the rounding of bound * w, and along it is
///   within 6 ulp of the edge's largest coordinate (bound: 0 or 2^k). A corner on it gives no second one.
/// Cost: one test per corner, one division per cut.
/// Errors: none.
template <class T, class Vertex, Observer<Tested<T>, Cut<T>, CornerKept<T>, Passed<T>> O = Unobserved>
std::vector<Vertex> clip(std::span<const Vertex> polygon, const Plane<T>& plane, O&& observer = {}) {
  std::vector<Vertex> kept;
  kept.reserve(polygon.size() + 1);
  if (polygon.empty()) return kept;
  Vertex old = polygon.back();
  for (const auto& now : polygon) {
    T was = distance(plane, old.at);
    T is = distance(plane, now.at);
    if constexpr (observed<O>) observer(Tested<T>{plane, number_in(polygon, now), now.at, is >= 0});
    // The edge crosses: cut it
    if (crosses(was, is)) {
      auto c = cut(plane, old, now);
      kept.push_back(c.vertex);
      if constexpr (observed<O>) observer(Cut<T>{plane, c.inside, c.outside, c.t, c.vertex.at});
    }
    // What is inside or on it stays
    if (is >= 0) {
      kept.push_back(now);
      if constexpr (observed<O>) observer(CornerKept<T>{plane, number_in(polygon, now)});
    }
    old = now;
  }
  if constexpr (observed<O>) observer(Passed<T>{plane, kept.size()});
  return kept;
}

/// The part of a polygon that lies inside all planes, cut at one after the other.
///
/// polygon: the corners in order; the parts of a convex one are convex. planes: in the order of cutting.
///
/// Domain: finite coordinates; no plane leaves the polygon as it is.
/// Steps: ((Tested Cut? CornerKept?)* Passed)*, a Passed for every plane until nothing is left.
/// Accuracy: that of one plane, for each.
/// Cost: one test per corner and plane; a convex polygon gains at most one corner per plane.
/// Errors: none.
template <class T, class Vertex, Observer<Tested<T>, Cut<T>, CornerKept<T>, Passed<T>> O = Unobserved>
std::vector<Vertex> clip(std::vector<Vertex> polygon, std::span<const Plane<T>> planes, O&& observer = {}) {
  for (const Plane<T>& plane : planes) {
    if (polygon.empty()) break;
    std::span<const Vertex> rest = polygon;
    polygon = clip(rest, plane, observer);
  }
  return polygon;
}

/// Both for corners in a vector or an array, and for planes such as view_volume gives.
template <OtherRow Corners, class T, class... Observed>
auto clip(const Corners& polygon, const Plane<T>& plane, Observed&&... observer) {
  return clip(span_of(polygon), plane, std::forward<Observed>(observer)...);
}
template <ContiguousRow Corners, OtherRow Planes, class... Observed>
auto clip(const Corners& polygon, const Planes& planes, Observed&&... observer) {
  std::vector<ItemOf<Corners>> corners(std::begin(polygon), std::end(polygon));
  return clip(std::move(corners), span_of(planes), std::forward<Observed>(observer)...);
}

/// The six planes of clip space in the order of cutting: far, then the sides, `x` and `y` times as far out as
/// the picture's, near at the end. By then nothing is larger than the far plane allows; a cut near the eye of
/// an edge that comes from very far away would otherwise be all rounding error. x, y: 1 cuts at the sides of
/// the picture; larger ones are guard planes, for those who discard pixels. Errors: ContractViolation unless
/// x, y >= 1.
template <class T>
constexpr std::array<Plane<T>, 6> view_volume(T x, T y) {
  expects(x >= T(1) && y >= T(1), "guard planes lie at the sides of the picture or outside");
  const T one = T(1);
  return {{{2, -one, one}, {0, one, x}, {0, -one, x}, {1, one, y}, {1, -one, y}, {2, one, T(0)}}};
}

}  // namespace gradus::sutherland_hodgman
