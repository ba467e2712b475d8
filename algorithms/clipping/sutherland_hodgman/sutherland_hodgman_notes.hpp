#pragma once
// How lecture notes clip a polygon at a rectangle: by cutting what was cut before, which is right but for
// rounding; and, as exhibits, their listings and steps that are wrong, so that a figure can show where. Use
// none of them to draw; sutherland_hodgman.hpp has the right one.

#include <cstddef>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

namespace gradus::sutherland_hodgman {

/// A border of a rectangle in plain arithmetic: vertices are where they were rounded to.
template <class T>
struct PlainBorder {
  Rectangle<T> window;
  int number;

  /// 1 inside, 0 on the border, -1 outside.
  int side(const Vertex<T>& v) const { return side_of_border(window, number, v.at); }
  bool inside(const Vertex<T>& v) const { return side(v) >= 0; }
  /// Whether a vertex lies in the whole window.
  bool in_window(const Vertex<T>& v) const {
    for (int i = 0; i < 4; ++i) {
      if (side_of_border(window, i, v.at) < 0) return false;
    }
    return true;
  }
  /// Where the segment between two vertices meets the border's line.
  Vertex<T> cut(const Vertex<T>& from, const Vertex<T>& to) const {
    const int axis = axis_of(number);
    const T c = coordinate_of(window, number);
    const T t = (c - from.at[axis]) / (to.at[axis] - from.at[axis]);
    Vertex<T> vertex{from.at + t * (to.at - from.at), -1, from.after, EdgeName::window(number), from.after};
    vertex.at[axis] = c;
    return vertex;
  }
};

/// A polygon, what it is clipped at, and in which order of its borders.
template <class T>
struct Task {
  std::span<const glm::vec<2, T>> points;
  Rectangle<T> window;
  std::span<const int> order;
};

/// What a pass, which cuts at one border, makes of a polygon when it is used for one border after the other.
template <class T, class Pass>
std::vector<Vertex<T>> by_passes(const Task<T>& task, Pass pass) {
  std::vector<Vertex<T>> polygon = vertices_of(task.points);
  for (const int border : task.order) {
    if (polygon.empty()) break;
    polygon = pass(std::span<const Vertex<T>>(polygon), PlainBorder<T>{task.window, border});
  }
  return polygon;
}

/// What the step says of a vertex and the one before it.
template <class T>
VertexTested<T> tested(const PlainBorder<T>& border, std::span<const Vertex<T>> polygon,
                       const Vertex<T>& last, const Vertex<T>& now) {
  return {border.number, number_in(polygon, now), now, border.side(now), last, border.side(last)};
}

/// One pass of the textbook's loop in plain arithmetic: each cut is computed from the ends of the edge as the
/// cuts before left them, and tested where it was rounded to.
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17(1), 1974, 32-42.
///
/// polygon: not empty. border: of a rectangle.
///
/// Domain: finite coordinates whose differences and their products are finite; others may give anything.
/// Steps: (VertexTested EdgeCut? VertexKept?)* BorderPassed
/// Accuracy: a cut of a cut adds up the rounding errors of both: measured in the benchmark beside the exact
///   form. Where an edge passes a corner closely, it may be cut on the wrong side.
/// Cost: one test a vertex, one division a cut.
/// Errors: none.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> cut_of_a_cut(std::span<const Vertex<T>> polygon, const PlainBorder<T>& border,
                                    O&& observer = {}) {
  std::vector<Vertex<T>> kept;
  Vertex<T> last = polygon.back();
  for (const auto& now : polygon) {
    int was = border.side(last);
    int is = border.side(now);
    if constexpr (observed<O>) observer(tested(border, polygon, last, now));
    // The edge crosses: cut it
    if (was * is < 0) {
      auto c = border.cut(last, now);
      kept.push_back(c);
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, last, now, c, was > 0});
    }
    // What is inside or on it stays
    if (is >= 0) {
      kept.push_back(now);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    }
    last = now;
  }
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept});
  return kept;
}

/// FAULTY: edges that enter are not cut. One pass of the notes' first listing (errata E001-26b).
/// Domain: right only for polygons that lie inside. Steps, Cost: as cut_of_a_cut. Accuracy: none: of the
///   triangle (-5,2), (5,2), (5,8) in [0,10]^2 it keeps the area 15 instead of 22.5.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> entering_not_cut(std::span<const Vertex<T>> polygon, const PlainBorder<T>& border,
                                        O&& observer = {}) {
  std::vector<Vertex<T>> kept;
  Vertex<T> last = polygon.back();
  for (const auto& now : polygon) {
    bool was = border.inside(last);
    bool is = border.inside(now);
    if constexpr (observed<O>) observer(tested(border, polygon, last, now));
    if (is) {
      // Missing: a cut if it enters
      kept.push_back(now);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    } else if (was) {
      auto c = border.cut(last, now);
      kept.push_back(c);
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, last, now, c, true});
    }
    last = now;
  }
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept});
  return kept;
}

/// FAULTY: the previous vertex is moved on only after a vertex outside, so that a second vertex inside is cut
/// once more. One pass of the notes' second listing, as it is indented (errata E001-26b).
/// Domain: right only for polygons that lie inside. Steps, Cost: as cut_of_a_cut. Accuracy: none: of the
///   triangle (-5,2), (5,2), (5,8) in [0,10]^2 it keeps 7.5 instead of 22.5, and lies on itself.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> previous_left_behind(std::span<const Vertex<T>> polygon, const PlainBorder<T>& border,
                                            O&& observer = {}) {
  std::vector<Vertex<T>> kept;
  Vertex<T> last = polygon.back();
  for (const auto& now : polygon) {
    bool was = border.inside(last);
    bool is = border.inside(now);
    if constexpr (observed<O>) observer(tested(border, polygon, last, now));
    if (was != is) {
      auto c = border.cut(last, now);
      kept.push_back(c);
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, last, now, c, was});
    }
    if (is) {
      kept.push_back(now);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    } else {
      // Should be done in both cases
      last = now;
    }
  }
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept});
  return kept;
}

/// What the step says of vertices that were marked so.
template <class T>
VertexTested<T> marked(const PlainBorder<T>& border, std::span<const Vertex<T>> polygon,
                       const Vertex<T>& last, const Vertex<T>& now) {
  const auto mark = [&](const Vertex<T>& v) { return border.in_window(v) ? 1 : -1; };
  return {border.number, number_in(polygon, now), now, mark(now), last, mark(last)};
}

/// FAULTY: vertices are marked inside or outside of the whole window instead of one border, and edges with
/// both ends outside are dropped. One pass of the notes' numbered steps (errata E001-26).
/// Domain: right only for polygons that lie inside. Steps: as cut_of_a_cut. Accuracy: none: of a triangle
///   that contains the window nothing remains.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> marked_by_window(std::span<const Vertex<T>> polygon, const PlainBorder<T>& border,
                                        O&& observer = {}) {
  std::vector<Vertex<T>> kept;
  Vertex<T> last = polygon.back();
  for (const auto& now : polygon) {
    // Should ask this border alone
    bool was = border.in_window(last);
    bool is = border.in_window(now);
    if constexpr (observed<O>) observer(marked(border, polygon, last, now));
    int from = border.side(last);
    int to = border.side(now);
    if (was != is && from * to < 0) {
      auto c = border.cut(last, now);
      kept.push_back(c);
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, last, now, c, was});
    }
    if (is) {
      kept.push_back(now);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    }
    last = now;
  }
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept});
  return kept;
}

/// The polygon of a task, before anything is cut.
template <class T>
std::vector<Vertex<T>> vertices_of(const Task<T>& task) {
  return vertices_of(task.points);
}

/// Whether a polygon holds a point, or has it on an edge. Domain: finite. Cost: O(n).
template <class T>
bool holds_point(std::span<const glm::vec<2, T>> points, glm::vec<2, T> p) {
  bool odd = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[i + 1 < points.size() ? i + 1 : 0];
    const int turn = side(Segment<2, T>{a, b}, p);
    if (turn == 0 && (a.x <= p.x) != (b.x < p.x) && (a.y <= p.y) != (b.y < p.y)) return true;
    if ((a.y > p.y) != (b.y > p.y)) odd ^= (turn > 0) == (b.y > a.y);
  }
  return odd;
}

/// Whether a polygon holds all corners of the window.
template <class T>
bool contains_window(const Task<T>& task) {
  const glm::vec<2, T> low = task.window.lower, high = task.window.upper;
  return holds_point(task.points, low) && holds_point(task.points, high) &&
         holds_point(task.points, {low.x, high.y}) && holds_point(task.points, {high.x, low.y});
}

/// FAULTY: a polygon that contains the window comes back as it is, "no vertices are processed". The notes'
/// special case before their loop (errata E001-26); the loop itself would give the window.
/// Domain: right where no polygon contains the window. Steps: BorderPassed for the special case, else those
///   of all passes. Accuracy: none: of (-10,-10), (30,-10), (10,40) around [0,10]^2 it keeps 1000 instead
///   of 100.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> containing_left_whole(const Task<T>& task, O&& observer = {}) {
  // Wrong: the window should stay
  if (contains_window(task)) {
    auto whole = vertices_of(task);
    if constexpr (observed<O>) observer(BorderPassed<T>{task.order[0], whole});
    return whole;
  }
  auto pass = [&](auto v, auto b) {
    // The textbook's loop
    return cut_of_a_cut(v, b, observer);
  };
  return by_passes(task, pass);
}

}  // namespace gradus::sutherland_hodgman
