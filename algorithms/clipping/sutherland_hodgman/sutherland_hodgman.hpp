#pragma once
// Cutting a polygon off at the borders of a convex window, one after the other: at a rectangle or any convex
// polygon in the plane, and at the planes of clip space in homogeneous coordinates, before the division, so
// that what lies behind the eye is gone when it comes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/convex_window.hpp"
#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::sutherland_hodgman {

// --- In the plane: steps -----------------------------------------

/// A vertex was tested against a border.
template <class T>
struct VertexTested {
  int border;
  std::size_t number;  ///< in the polygon as it came to this border
  Vertex<T> vertex;
  int side;  ///< 1 inside, 0 on the border, -1 outside
};

/// The edge between two vertices leaves or enters through the border, and was cut there.
template <class T>
struct EdgeCut {
  int border;
  Vertex<T> from, to;
  Vertex<T> vertex;  ///< the one that was made
  bool leaves;
};

/// One border is done with.
template <class T>
struct BorderPassed {
  int border;
  std::vector<Vertex<T>> polygon;  ///< what is left
};

/// A piece of a border that the polygon runs along there and back: its parts hang together by it.
template <class T>
struct BridgeFound {
  int border;
  Vertex<T> from, to;  ///< in the direction of the border
};

// --- In the plane ------------------------------------------------

/// The place of a corner in its polygon.
template <class V>
constexpr std::size_t number_in(std::span<const V> polygon, const V& corner) {
  return static_cast<std::size_t>(&corner - polygon.data());
}

/// The vertices that stay, in order. Between two on the border the polygon goes along it.
template <class T>
class Kept {
 public:
  /// room: memory to use again; what stood there is gone.
  Kept(int border, std::vector<Vertex<T>> room)
      : polygon(std::move(room)), border_(EdgeName::window(border)) {
    polygon.clear();
  }
  void add(const Vertex<T>& vertex, bool on_border) {
    if (on_border && last_on_ && !polygon.empty()) polygon.back().after = border_;
    if (polygon.empty()) first_on_ = on_border;
    polygon.push_back(vertex);
    last_on_ = on_border;
  }
  void close() {
    if (!polygon.empty() && first_on_ && last_on_) polygon.back().after = border_;
  }
  std::vector<Vertex<T>> polygon;

 private:
  EdgeName border_;
  bool first_on_ = false, last_on_ = false;
};

/// The part of a polygon that lies inside of one border.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// polygon: the vertices in order. scene: what they were made of. border: its own points are inside. room:
///   memory to use again.
///
/// Domain: finite coordinates.
/// Steps: (VertexTested EdgeCut?)* BorderPassed, VertexTested once for every vertex. The edge is cut after
/// its
///   second end was tested.
/// Accuracy: exact decisions; a made vertex is the nearest to the exact one.
/// Cost: one test a vertex, one division a cut.
/// Errors: none.
template <class T, class Window, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> cut_at_border(std::span<const Vertex<T>> polygon, int border,
                                     const Scene<T, Window>& scene, std::vector<Vertex<T>> room = {},
                                     O&& observer = {}) {
  Kept<T> kept(border, std::move(room));
  const Vertex<T>* last = &polygon.back();
  int was = scene.side(border, *last);
  for (const Vertex<T>& now : polygon) {
    const int is = scene.side(border, now);
    if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(polygon, now), now, is});
    // Cut the edge that crosses the border
    if (was * is < 0) {
      auto cut = scene.cut(border, *last);
      kept.add(cut, true);
      if constexpr (observed<O>) observer(EdgeCut<T>{border, *last, now, cut, was > 0});
    }
    // What is inside or on the border stays
    if (is >= 0) kept.add(now, is == 0);
    last = &now;
    was = is;
  }
  kept.close();
  if constexpr (observed<O>) observer(BorderPassed<T>{border, kept.polygon});
  return std::move(kept.polygon);
}

/// The vertices of a polygon as it is given, before anything is cut.
template <class T>
std::vector<Vertex<T>> vertices_of(std::span<const glm::vec<2, T>> points) {
  std::vector<Vertex<T>> vertices;
  vertices.reserve(points.size() + 4);
  for (const auto& point : points) {
    const int number = static_cast<int>(vertices.size());
    vertices.push_back({point, number, {}, {}, EdgeName::polygon(number)});
  }
  return vertices;
}

/// Takes out made vertices that round to the place of a neighbour, so that no edge has length 0, and all of
/// them where fewer than three are left.
template <class T>
void leave_out_repeated(std::vector<Vertex<T>>& polygon) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (kept > 0 && polygon[kept - 1].at == polygon[i].at) {
      if (polygon[i].made()) {
        polygon[kept - 1].after = polygon[i].after;
        continue;
      }
      if (polygon[kept - 1].made()) --kept;
    }
    if (kept != i) polygon[kept] = polygon[i];
    ++kept;
  }
  // The last and the first are neighbours too
  while (kept > 1 && polygon[kept - 1].at == polygon[0].at &&
         (polygon[kept - 1].made() || polygon[0].made())) {
    if (polygon[kept - 1].made()) {
      --kept;
    } else {
      polygon.erase(polygon.begin());
      --kept;
    }
  }
  polygon.resize(kept < 3 ? 0 : kept);
}

/// What every method asks of its input.
template <class T>
void expect_finite(std::span<const glm::vec<2, T>> points) {
  for (const auto& point : points) expects(is_finite(point), "a polygon needs finite vertices");
}
template <class T>
void expect_window(const Rectangle<T>& window) {
  expects(is_finite(window.lower) && is_finite(window.upper), "a window needs finite borders");
  for (int i = 0; i < 2; ++i) {
    expects(window.lower[i] <= window.upper[i], "the window is inside out along axis {}: from {} to {}", i,
            static_cast<double>(window.lower[i]), static_cast<double>(window.upper[i]));
  }
}
template <class T>
void expect_window(const ConvexWindow<T>& window) {
  expects(window.corners.size() >= 3, "a window needs three corners, got {}", window.corners.size());
}

/// All borders of a window, in their own order.
template <class Window>
std::vector<int> all_borders(const Window& window) {
  std::vector<int> order(static_cast<std::size_t>(border_count(window)));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// The part of a polygon that lies in a convex window, cut at one border after the other. Every vertex
/// remembers the edge and the border that made it: it is computed from them as they were given, never from an
/// earlier cut, and never tested against that border again.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// points: the vertices in order, either way round, the last one followed by the first. window: a Rectangle
///   or a ConvexWindow; its border belongs to it. order: the borders, each once, in the order of cutting.
///
/// Domain: finite coordinates of any size; polygons may cross themselves. Of a concave polygon parts may hang
///   together by edges along a border (see bridges); separate_pieces keeps them apart. A polygon that only
///   touches the window gives nothing or a polygon without area.
/// Steps: ((VertexTested EdgeCut?)* BorderPassed)*, a BorderPassed for every border until nothing is left.
/// Accuracy: all decisions exact. A vertex inside is copied; a made one is the nearest to the exact point
///   where edge and border cross, the coordinate across a rectangle's border and a corner of the window
///   copied. At a rectangle clipping twice changes nothing, bit for bit. No made vertex repeats its
///   neighbour.
/// Cost: one test a vertex and border, one division a cut.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out.
template <class T, class Window, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> clip_to_window(std::span<const glm::vec<2, T>> points, const Window& window,
                                      std::span<const int> order, O&& observer = {}) {
  expect_finite(points);
  expect_window(window);
  const Scene<T, Window> scene{{points}, window};
  std::vector<Vertex<T>> polygon = vertices_of(points), room;
  for (const int border : order) {
    if (polygon.empty()) break;
    const std::span<const Vertex<T>> rest(polygon);
    room = cut_at_border(rest, border, scene, std::move(room), observer);
    std::swap(polygon, room);
  }
  leave_out_repeated(polygon);
  return polygon;
}

/// The same, in the borders' own order: left, right, bottom, top.
template <class T, class Window = Rectangle<T>>
std::vector<Vertex<T>> clip_to_window(std::span<const glm::vec<2, T>> points, const Window& window) {
  return clip_to_window(points, window, all_borders(window));
}

/// The same for points in a vector, an array or braces, whose numbers are doubles; a window in braces is a
/// Rectangle. With an order and an observer or without.
template <OtherPointRow<2> Points = PointsInBraces<2>, class Window = Rectangle<ScalarOf<Points>>,
          class... More>
auto clip_to_window(const Points& points, const Window& window, More&&... order_and_observer) {
  return clip_to_window(span_of(points), window, std::forward<More>(order_and_observer)...);
}

/// An edge along a border, with its ends in the border's direction.
template <class T>
struct AlongBorder {
  Vertex<T> from, to;
  bool forward;  ///< whether the polygon runs it that way
};

/// The bridges of a clipped polygon: the stretches of borders that it runs along there and back, as the parts
/// of a concave one do that hang together. They bound nothing and have no area.
///
/// polygon: what clip_to_window gave for these points and this window.
///
/// Steps: BridgeFound*, border by border, in the direction of each.
/// Accuracy: exact: the crossings on a border are compared, not their rounded coordinates.
/// Cost: O(k^2) for k edges along one border.
template <class T, class Window, Observer<BridgeFound<T>> O = Unobserved>
std::vector<BridgeFound<T>> bridges(std::span<const Vertex<T>> polygon,
                                    std::span<const glm::vec<2, T>> points, const Window& window,
                                    O&& observer = {}) {
  const Scene<T, Window> scene{{points}, window};
  std::vector<BridgeFound<T>> found;
  for (int border = 0; border < border_count(window); ++border) {
    const auto before = [&](const Vertex<T>& a, const Vertex<T>& b) {
      return order_along(scene, border, a, b) < 0;
    };
    // The edges along this border, and where they begin and end
    std::vector<AlongBorder<T>> edges;
    std::vector<Vertex<T>> ends;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex<T>&a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      if (a.after != EdgeName::window(border)) continue;
      const bool forward = before(a, b);
      edges.push_back({forward ? a : b, forward ? b : a, forward});
      ends.insert(ends.end(), {a, b});
    }
    std::sort(ends.begin(), ends.end(), before);
    // A stretch is a bridge if it is run both ways
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (!before(ends[i], ends[i + 1])) continue;
      bool there = false, back = false;
      for (const AlongBorder<T>& edge : edges) {
        const bool holds = !before(ends[i], edge.from) && !before(edge.to, ends[i + 1]);
        (edge.forward ? there : back) |= holds;
      }
      if (!there || !back) continue;
      if (!found.empty() && found.back().border == border && !before(found.back().to, ends[i])) {
        found.back().to = ends[i + 1];
      } else {
        found.push_back({border, ends[i], ends[i + 1]});
      }
    }
  }
  for (const BridgeFound<T>& bridge : found) {
    if constexpr (observed<O>) observer(bridge);
  }
  return found;
}

/// The same for what clip_to_window gave, as it is, and points in any form that it takes.
template <class T, PointRow<2> Points = PointsInBraces<2>, class Window = Rectangle<T>, class... Observed>
auto bridges(const std::vector<Vertex<T>>& polygon, const Points& points, const Window& window,
             Observed&&... observer) {
  return bridges(span_of(polygon), span_of(points), window, std::forward<Observed>(observer)...);
}

// --- In clip space -----------------------------------------------

/// A plane of clip space that goes with an axis: inside is sign * p[axis] + bound * p.w >= 0. So {2, 1, 0} is
/// z >= 0, {0, -1, 1} is x <= w and {0, -1, 64} is x <= 64 w.
template <class T>
struct Plane {
  int axis;  ///< 0 x, 1 y, 2 z
  T sign;    ///< 1 or -1
  T bound;   ///< the limit in units of w
};

/// How far inside of the plane a point lies; its sign is that of the exact comparison of the coordinate with
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
constexpr Crossing<T, Vertex> crossing(const Plane<T>& plane, const Vertex& a, const Vertex& b) {
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

/// The part of a polygon that lies inside of a plane.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// polygon: the corners in order. Vertex: see crossing. plane: the border itself is inside.
///
/// Domain: finite coordinates up to 2^1020 / (1 + bound), so that no difference overflows. Of a concave
///   polygon pieces may hang together by edges that run along the plane.
/// Steps: (Tested Cut?)* Passed, Tested once for every corner.
/// Accuracy: corners inside are copied; a cut lies on the plane to the rounding of bound * w, and along it is
///   within 6 ulp of the edge's largest coordinate (bound: 0 or 2^k). A corner on it gives no second one.
/// Cost: one test a corner, one division a cut.
/// Errors: none.
template <class T, class Vertex, Observer<Tested<T>, Cut<T>, Passed<T>> O = Unobserved>
std::vector<Vertex> clip(std::span<const Vertex> polygon, const Plane<T>& plane, O&& observer = {}) {
  std::vector<Vertex> kept;
  kept.reserve(polygon.size() + 1);
  if (polygon.empty()) return kept;
  const Vertex* last = &polygon.back();
  for (const Vertex& now : polygon) {
    const T was = distance(plane, last->at);
    const T is = distance(plane, now.at);
    if constexpr (observed<O>) observer(Tested<T>{plane, number_in(polygon, now), now.at, is >= T(0)});
    // Cut the edge that crosses the plane
    if (crosses(was, is)) {
      auto c = crossing(plane, *last, now);
      kept.push_back(c.vertex);
      if constexpr (observed<O>) observer(Cut<T>{plane, c.inside, c.outside, c.t, c.vertex.at});
    }
    // What is inside stays
    if (is >= T(0)) kept.push_back(now);
    last = &now;
  }
  if constexpr (observed<O>) observer(Passed<T>{plane, kept.size()});
  return kept;
}

/// The part of a polygon that lies inside of all planes, cut at one after the other.
///
/// polygon: the corners in order; the parts of a convex one are convex. planes: in the order of cutting.
///
/// Domain: finite coordinates; no plane leaves the polygon as it is.
/// Steps: ((Tested Cut?)* Passed)*, a Passed for every plane until nothing is left.
/// Accuracy: that of one plane, for each.
/// Cost: one test a corner and plane; a convex polygon gains at most one corner a plane.
/// Errors: none.
template <class T, class Vertex, Observer<Tested<T>, Cut<T>, Passed<T>> O = Unobserved>
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
