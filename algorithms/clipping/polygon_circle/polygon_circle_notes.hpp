#pragma once
// The notes' clipping of a polygon with a circle, kept as an exhibit (errata E001-26j and E001-26k).

#include "clipping/polygon_circle/polygon_circle.hpp"

namespace gradus::polygon_circle {

/// The ends of an edge were told from the circle.
struct Looked {
  std::size_t edge;
  dvec2 from, to;
  bool from_inside, to_inside;
};

/// A corner was put out.
struct Kept {
  dvec2 at;
  bool cut;  ///< the first point of the clipped edge; else a corner of the polygon
};

/// The polygon that comes out.
template <class T>
struct Joined {
  std::vector<glm::vec<2, T>> corners;
};

/// The first point of what the circle leaves of an edge, which has an end inside: its start, when that is
/// inside, else the entry.
template <class T>
dvec2 first_of(const Segment<2, double>& edge, const Walk<T>& walk) {
  if (side(edge.a, walk.circle) <= 0) return edge.a;
  return chord_on(edge, walk.circle).entry(side(edge.b, walk.circle));
}

/// FAULTY: of the clipped edge it takes the first point also where the edge leaves, which is the edge's own
/// start, so that the exit is lost; edges with both ends outside are skipped though they may cross twice; and
/// chords stand where arcs belong. The notes' listing, after Sutherland and Hodgman (errata E001-26j, k).
///
/// polygon, circle: as for arcs.
///
/// Domain: right for polygons inside the circle.
/// Steps: Oriented (Looked Kept*)* Joined, Looked once per edge.
/// Accuracy: none: the square round the unit circle gives area 0 for pi, the square [0,2]^2 0 for pi/4.
/// Cost: O(n).
/// Errors: as arcs.
template <std::floating_point T, Observer<Oriented, Looked, Kept, Joined<T>> O = Unobserved>
std::vector<glm::vec<2, T>> first_crossing(std::span<const glm::vec<2, T>> polygon, const Circle<T>& circle,
                                           O&& observer = {}) {
  expect_circle(circle);
  Walk walk(polygon, circle);
  if constexpr (observed<O>) observer(Oriented{walk.corners, walk.circle});
  std::vector<glm::vec<2, T>> kept;
  for (auto i : walk.edges()) {
    auto edge = walk.edge(i);
    bool was = walk.holds(edge.a);
    bool is = walk.holds(edge.b);
    if constexpr (observed<O>) observer(Looked{i, edge.a, edge.b, was, is});
    // One end in: "the crossing"
    if (was != is) {
      auto c = first_of(edge, walk);
      kept.push_back(c);
      if constexpr (observed<O>) observer(Kept{c, true});
    }
    // The second end, if inside
    if (is) {
      kept.push_back(edge.b);
      if constexpr (observed<O>) observer(Kept{edge.b, false});
    }
  }
  if constexpr (observed<O>) observer(Joined<T>{kept});
  return kept;
}

/// The same for points in a vector, an array or braces, whose numbers are doubles.
template <OtherPointRow<2> Points = PointsInBraces<2>, class... Observed>
auto first_crossing(const Points& polygon, const Circle<ScalarOf<Points>>& circle, Observed&&... observer) {
  return first_crossing(span_of(polygon), circle, std::forward<Observed>(observer)...);
}

}  // namespace gradus::polygon_circle
