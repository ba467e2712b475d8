#pragma once
// How lecture notes clip a polygon at a rectangle: by cutting what was cut before, which is right but for
// rounding; and, as exhibits, their listings and steps that are wrong, so that a figure can show where. Use
// none of them to draw; sutherland_hodgman.hpp has the right one.

#include <cstddef>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

namespace gradus::sutherland_hodgman {

/// The vertex where the segment between two others meets a border, in plain arithmetic, from where they were
/// rounded to.
template <class T>
Vertex<T> plain_cut(const Rectangle<T>& window, int border, const Vertex<T>& from, const Vertex<T>& to) {
  const int axis = axis_of(border);
  const T c = coordinate_of(window, border);
  const T t = (c - from.at[axis]) / (to.at[axis] - from.at[axis]);
  Vertex<T> vertex{from.at + t * (to.at - from.at), -1, from.after, EdgeName::window(border), from.after};
  vertex.at[axis] = c;
  return vertex;
}

/// Whether a vertex, where it was rounded to, is not outside of a border.
template <class T>
constexpr bool plainly_inside(const Rectangle<T>& window, int border, const Vertex<T>& v) {
  return side_of_border(window, border, v.at) >= 0;
}

/// The loop that the forms below share, one border at a time: `pass` cuts at one.
template <class T, class Pass>
std::vector<Vertex<T>> border_by_border(std::span<const glm::vec<2, T>> points, std::span<const int> order,
                                        Pass pass) {
  std::vector<Vertex<T>> polygon = vertices_of(points);
  for (const int border : order) {
    if (polygon.empty()) break;
    polygon = pass(std::span<const Vertex<T>>(polygon), border);
  }
  return polygon;
}

/// The textbook's loop in plain arithmetic: each cut is computed from the ends of the edge as the cuts before
/// left them, and tested where it was rounded to.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// points, window, order: as clip_to_window.
///
/// Domain: finite coordinates whose differences and their products are finite; others may give anything.
/// Steps: ((VertexTested EdgeCut?)* BorderPassed)*
/// Accuracy: a cut of a cut adds up the rounding errors of both: measured in the benchmark beside the exact
///   form. A corner where edge and both borders nearly meet may be cut on the wrong side.
/// Cost: one test a vertex and border, one division a cut.
/// Errors: none.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> cut_of_a_cut(std::span<const glm::vec<2, T>> points, const Rectangle<T>& window,
                                    std::span<const int> order, O&& observer = {}) {
  return border_by_border(points, order, [&](std::span<const Vertex<T>> polygon, int border) {
    std::vector<Vertex<T>> kept;
    const Vertex<T>* last = &polygon.back();
    for (const Vertex<T>& now : polygon) {
      const int was = side_of_border(window, border, last->at);
      const int is = side_of_border(window, border, now.at);
      if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(polygon, now), now, is});
      // Cut the edge that crosses the border
      if (was * is < 0) {
        kept.push_back(plain_cut(window, border, *last, now));
        if constexpr (observed<O>) observer(EdgeCut<T>{border, *last, now, kept.back(), was > 0});
      }
      // What is inside or on the border stays
      if (is >= 0) kept.push_back(now);
      last = &now;
    }
    if constexpr (observed<O>) observer(BorderPassed<T>{border, kept});
    return kept;
  });
}

/// FAULTY: edges that enter are not cut. The notes' first listing (errata E001-26b).
/// Domain: right only for polygons that lie inside. Steps, Cost: as cut_of_a_cut. Accuracy: none: of the
///   triangle (-5,2), (5,2), (5,8) in [0,10]^2 it keeps the area 15 instead of 22.5.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> entering_not_cut(std::span<const glm::vec<2, T>> points, const Rectangle<T>& window,
                                        std::span<const int> order, O&& observer = {}) {
  return border_by_border(points, order, [&](std::span<const Vertex<T>> polygon, int border) {
    std::vector<Vertex<T>> kept;
    const Vertex<T>* last = &polygon.back();
    for (const Vertex<T>& now : polygon) {
      const bool was = plainly_inside(window, border, *last);
      const int side = side_of_border(window, border, now.at);
      if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(polygon, now), now, side});
      if (side >= 0) {
        // Missing: the cut where it enters
        kept.push_back(now);
      } else if (was) {
        kept.push_back(plain_cut(window, border, *last, now));
        if constexpr (observed<O>) observer(EdgeCut<T>{border, *last, now, kept.back(), true});
      }
      last = &now;
    }
    if constexpr (observed<O>) observer(BorderPassed<T>{border, kept});
    return kept;
  });
}

/// FAULTY: the previous vertex is moved on only after a vertex outside, so that a second vertex inside is cut
/// once more. The notes' second listing, as it is indented (errata E001-26b).
/// Domain: right only for polygons that lie inside. Steps, Cost: as cut_of_a_cut. Accuracy: none: of the
///   triangle (-5,2), (5,2), (5,8) in [0,10]^2 it keeps 7.5 instead of 22.5, and lies on itself.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> previous_left_behind(std::span<const glm::vec<2, T>> points,
                                            const Rectangle<T>& window, std::span<const int> order,
                                            O&& observer = {}) {
  return border_by_border(points, order, [&](std::span<const Vertex<T>> polygon, int border) {
    std::vector<Vertex<T>> kept;
    const Vertex<T>* last = &polygon.back();
    for (const Vertex<T>& now : polygon) {
      const bool was = plainly_inside(window, border, *last);
      const int side = side_of_border(window, border, now.at);
      if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(polygon, now), now, side});
      if (was != (side >= 0)) {
        kept.push_back(plain_cut(window, border, *last, now));
        if constexpr (observed<O>) observer(EdgeCut<T>{border, *last, now, kept.back(), was});
      }
      if (side >= 0) {
        kept.push_back(now);
      } else {
        last = &now;  // here only
      }
    }
    if constexpr (observed<O>) observer(BorderPassed<T>{border, kept});
    return kept;
  });
}

/// Whether a polygon holds a point, or has it on an edge. Domain: finite. Cost: O(n).
template <class T>
bool holds_point(std::span<const glm::vec<2, T>> points, glm::vec<2, T> p) {
  bool odd = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[i + 1 < points.size() ? i + 1 : 0];
    const int turn = side(Line<T>{a, b}, p);
    if (turn == 0 && (a.x <= p.x) != (b.x < p.x) && (a.y <= p.y) != (b.y < p.y)) return true;
    if ((a.y > p.y) != (b.y > p.y)) odd ^= (turn > 0) == (b.y > a.y);
  }
  return odd;
}

/// FAULTY: a polygon that contains the window comes back as it is, "no vertices are processed". The notes'
/// special case (errata E001-26); the loop itself would give the window.
/// Domain: right where no polygon contains the window. Steps: as cut_of_a_cut; none for the special case.
/// Accuracy: none: of (-10,-10), (30,-10), (10,40) around [0,10]^2 it keeps 1000 instead of 100.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> containing_left_whole(std::span<const glm::vec<2, T>> points,
                                             const Rectangle<T>& window, std::span<const int> order,
                                             O&& observer = {}) {
  const glm::vec<2, T> low = window.lower, high = window.upper;
  const bool contains = holds_point(points, low) && holds_point(points, high) &&
                        holds_point(points, {low.x, high.y}) && holds_point(points, {high.x, low.y});
  if (contains) return vertices_of(points);
  return cut_of_a_cut(points, window, order, observer);
}

/// FAULTY: vertices are marked inside or outside of the whole window instead of one border, and edges with
/// both ends outside are dropped. The notes' numbered steps (errata E001-26).
/// Domain: right only for polygons that lie inside. Steps: as cut_of_a_cut. Accuracy: none: of a triangle
///   that contains the window nothing remains.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> marked_by_window(std::span<const glm::vec<2, T>> points, const Rectangle<T>& window,
                                        std::span<const int> order, O&& observer = {}) {
  const auto inside = [&](const Vertex<T>& v) {
    for (int border = 0; border < 4; ++border) {
      if (!plainly_inside(window, border, v)) return false;
    }
    return true;
  };
  return border_by_border(points, order, [&](std::span<const Vertex<T>> polygon, int border) {
    std::vector<Vertex<T>> kept;
    const Vertex<T>* last = &polygon.back();
    for (const Vertex<T>& now : polygon) {
      const bool was = inside(*last), is = inside(now);
      if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(polygon, now), now, is ? 1 : -1});
      // Cut at this border, if the edge meets it
      const int from = side_of_border(window, border, last->at), to = side_of_border(window, border, now.at);
      if (was != is && from * to < 0) {
        kept.push_back(plain_cut(window, border, *last, now));
        if constexpr (observed<O>) observer(EdgeCut<T>{border, *last, now, kept.back(), was});
      }
      if (is) kept.push_back(now);
      last = &now;
    }
    if constexpr (observed<O>) observer(BorderPassed<T>{border, kept});
    return kept;
  });
}

}  // namespace gradus::sutherland_hodgman
