#pragma once
// The textbook's loop in plain arithmetic, one border after the other: what the exact form is measured with,
// and what the faults of lecture notes spoil.

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
  /// Whether a vertex lies inside all borders.
  bool in_all(const Vertex<T>& v) const {
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
/// Cost: one test per vertex, one division per cut.
/// Errors: none.
template <class T, Observer<VertexTested<T>, EdgeCut<T>, VertexKept<T>, BorderPassed<T>> O = Unobserved>
std::vector<Vertex<T>> cut_of_a_cut(std::span<const Vertex<T>> polygon, const PlainBorder<T>& border,
                                    O&& observer = {}) {
  std::vector<Vertex<T>> kept;
  Vertex<T> old = polygon.back();
  for (const auto& now : polygon) {
    int was = border.side(old);
    int is = border.side(now);
    if constexpr (observed<O>) observer(tested(border, polygon, old, now));
    // The edge crosses: cut it
    if (was * is < 0) {
      auto c = border.cut(old, now);
      kept.push_back(c);
      if constexpr (observed<O>) observer(EdgeCut<T>{border.number, old, now, c, was > 0});
    }
    // What is inside or on it stays
    if (is >= 0) {
      kept.push_back(now);
      if constexpr (observed<O>) observer(VertexKept<T>{border.number, now});
    }
    old = now;
  }
  if constexpr (observed<O>) observer(BorderPassed<T>{border.number, kept});
  return kept;
}

}  // namespace gradus::sutherland_hodgman
