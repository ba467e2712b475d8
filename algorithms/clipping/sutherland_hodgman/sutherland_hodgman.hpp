#pragma once
// Cutting a polygon off at the borders of a convex window, one after the other: at a rectangle or any convex
// polygon in the plane. sutherland_hodgman_homogeneous.hpp does so at the planes of clip space.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/convex_window.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::sutherland_hodgman {

// --- Steps -------------------------------------------------------

/// A vertex was tested against a border.
template <class T>
struct VertexTested {
  int border;
  std::size_t number;  ///< in the polygon as it came to this border
  Vertex<T> vertex;
  int side;        ///< 1 inside, 0 on the border, -1 outside
  Vertex<T> last;  ///< the one before it, and the side of that
  int was;
};

/// The edge between two vertices leaves or enters through the border, and was cut there.
template <class T>
struct EdgeCut {
  int border;
  Vertex<T> from, to;
  Vertex<T> vertex;  ///< the one that was made
  bool leaves;
};

/// A vertex stays. Where its edge enters, the cut stands before it by now.
template <class T>
struct VertexKept {
  int border;
  Vertex<T> vertex;
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

// --- One border --------------------------------------------------

/// The place of a corner in its polygon.
template <class V>
constexpr std::size_t number_in(std::span<const V> polygon, const V& corner) {
  return static_cast<std::size_t>(&corner - polygon.data());
}

/// The vertices that stay, in order. Between two on the border the polygon goes along it.
template <class T>
class Kept {
 public:
  /// Forgets what stood there, for one border more.
  void start(int border) {
    polygon.clear();
    border_ = EdgeName::window(border);
    first_on_ = last_on_ = false;
  }
  /// side: of the border; 0 on it.
  void add(const Vertex<T>& vertex, int side) {
    const bool on = side == 0;
    if (on && last_on_ && !polygon.empty()) polygon.back().after = border_;
    if (polygon.empty()) first_on_ = on;
    polygon.push_back(vertex);
    last_on_ = on;
  }
  void add(const Vertex<T>& cut) { add(cut, 0); }
  void close() {
    if (!polygon.empty() && first_on_ && last_on_) polygon.back().after = border_;
  }
  std::vector<Vertex<T>> polygon;

 private:
  EdgeName border_{};
  bool first_on_ = false, last_on_ = false;
};

/// A border, and what the vertices were made of that come to it.
template <class T, class Window>
struct ExactBorder {
  const Scene<T, Window>& scene;
  int number;

  /// 1 inside, 0 on the border, -1 outside.
  int side(const Vertex<T>& v) const { return scene.side(number, v); }
  /// The vertex at which the edge after `from` crosses the border.
  Vertex<T> cut(const Vertex<T>& from) const { return scene.cut(number, from); }
};
template <class T, class Window>
ExactBorder(const Scene<T, Window>&, int) -> ExactBorder<T, Window>;

/// What the step says of a vertex and the one before it.
template <class T, class Window>
VertexTested<T> tested(const ExactBorder<T, Window>& border, std::span<const Vertex<T>> polygon,
                       const Vertex<T>& last, int was, const Vertex<T>& now, int is) {
  return {border.number, number_in(polygon, now), now, is, last, was};
}

/// The part of a polygon that lies inside one border.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// polygon: the vertices in order, not empty. border: its own points are inside. kept: what stays; what stood
///   there is gone, its memory is used again.
///
/// Domain: finite coordinates.
/// Steps: (VertexTested EdgeCut? VertexKept?)* BorderPassed, VertexTested once for every vertex. The edge is
///   cut after its second end was tested, and before that end is kept.
/// Accuracy: exact decisions; a made vertex is the nearest to the exact one.
/// Cost: one test per vertex, one division per cut.
/// Errors: none.
template <class T, class Window,
          Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
void cut_at_border(std::span<const Vertex<T>> polygon, const ExactBorder<T, Window>& border, Kept<T>& kept,
                   O&& observer = {}) {
  kept.start(border.number);
  Vertex<T> old = polygon.back();
  int was = border.side(old);
  for (const auto& now : polygon) {
    int is = border.side(now);
    if constexpr (observed<O>) observer(tested(border, polygon, old, was, now, is));
    // The edge crosses: cut it
    if (was * is < 0) {
      kept.add(border.cut(old));
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, old, now, kept.polygon.back(), was > 0});
    }
    // What is inside or on it stays
    if (is >= 0) {
      kept.add(now, is);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    }
    old = now;
    was = is;
  }
  kept.close();
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept.polygon});
}

// --- All borders -------------------------------------------------

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
/// Steps: ((VertexTested EdgeCut? VertexKept?)* BorderPassed)*, a BorderPassed for every border until nothing
///   is left.
/// Accuracy: all decisions exact. A vertex inside is copied; a made one is the nearest to the exact point
///   where edge and border cross, the coordinate across a rectangle's border and a corner of the window
///   copied. At a rectangle clipping twice changes nothing, bit for bit. No made vertex repeats its
///   neighbour.
/// Cost: one test per vertex and border, one division per cut.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out.
template <class T, class Window,
          Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> clip_to_window(std::span<const glm::vec<2, T>> points, const Window& window,
                                      std::span<const int> order, O&& observer = {}) {
  expect_finite(points);
  expect_window(window);
  const Scene<T, Window> scene{{points}, window};
  std::vector<Vertex<T>> polygon = vertices_of(points);
  Kept<T> kept;
  for (const int border : order) {
    if (polygon.empty()) break;
    cut_at_border(std::span<const Vertex<T>>(polygon), ExactBorder{scene, border}, kept, observer);
    std::swap(polygon, kept.polygon);
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

}  // namespace gradus::sutherland_hodgman
