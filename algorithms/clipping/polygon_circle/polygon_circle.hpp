#pragma once
// The part of a polygon that lies in a circle, with true arcs: the boundary goes along the polygon from where
// it enters the disc to where it leaves, and then along the circle to the next entry.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "clipping/polygon_circle/crossings.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/observe.hpp"

namespace gradus::polygon_circle {

// --- What comes out ----------------------------------------------

/// A corner of a ring, and how the boundary goes on to the next one.
template <class T>
struct Corner {
  glm::vec<2, T> at;
  bool arc = false;             ///< along the circle, counter-clockwise; else straight
  bool more_than_half = false;  ///< of the circle is the arc; tells all of it from nothing

  friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

/// A closed boundary, counter-clockwise. A whole circle is one corner with an arc to itself.
template <class T>
using Ring = std::vector<Corner<T>>;

/// Pieces that share no inner point. No piece has a hole: the polygon is simple, and a disc is convex.
template <class T>
struct Region {
  Circle<T> circle;
  std::vector<Ring<T>> rings;

  void add(Ring<T> ring) { rings.push_back(std::move(ring)); }
};

// --- Steps -------------------------------------------------------

/// The polygon runs counter-clockwise.
struct Oriented {
  std::vector<dvec2> corners;  ///< no corner twice in a row; none where it has no area
  Circle<double> circle;
};

/// An edge's passages are known.
struct Tested {
  std::size_t edge;  ///< from corner `edge` to the next one
  Run run;
  std::optional<dvec2> enters, leaves;
};

/// The passages are in their order round the circle.
struct Sorted {
  std::vector<Crossing> crossings;
};

/// A piece begins, or goes on, at an entry.
struct Entered {
  std::size_t ring;
  std::size_t number;  ///< of the passage, in sorted order
  dvec2 at;
};

/// The boundary went straight on to a corner inside.
struct Walked {
  std::size_t ring;
  std::size_t corner;
  dvec2 at;
};

/// The boundary went straight on to the exit, and along the circle to the next entry.
struct Bent {
  std::size_t ring;
  std::size_t exit, entry;  ///< numbers of the passages
  dvec2 from, to;
  bool more_than_half;
};

/// A piece is complete.
struct Closed {
  std::size_t ring;
  std::size_t corners;
};

/// All is done.
template <class T>
struct Finished {
  Region<T> region;
};

// --- The walk ----------------------------------------------------

/// A polygon and a circle, and what a walk along the boundary of their common part knows.
template <class T>
class Walk {
 public:
  const Circle<T> given;  ///< the circle
  const Circle<double> circle;
  const std::vector<dvec2> corners;  ///< counter-clockwise
  std::vector<Crossing> passes;

  Walk(std::span<const glm::vec<2, T>> polygon, const Circle<T>& c)
      : given(c), circle(in_double(c)), corners(counter_clockwise(polygon)), order_(corners, circle) {}
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// Edges go by their first corners.
  auto edges() const { return std::views::iota(std::size_t{0}, corners.size()); }
  Segment<2, double> edge(std::size_t i) const { return edge_of(corners, i); }
  /// Whether a point lies in the circle or on it.
  bool holds(dvec2 p) const { return side(p, circle) <= 0; }
  Run run(std::size_t i) const { return run_of(edge(i), circle); }
  std::size_t next(std::size_t i) const { return (i + 1) % corners.size(); }

  /// Finds the passages of an edge.
  void pass(std::size_t i) { add_crossings(passes, run(i), i, corners.size(), circle); }
  /// Puts the passages in their order round the circle. From then on they go by their numbers.
  void sort() {
    std::sort(passes.begin(), passes.end(), order_);
    used_.resize(passes.size());
    exits_.resize(corners.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
      if (passes[i].leaves) exits_[passes[i].edge] = i;
    }
  }

  dvec2 at(std::size_t pass) const { return passes[pass].at; }
  std::size_t edge_at(std::size_t pass) const { return passes[pass].edge; }

  /// Where a ring may begin.
  std::vector<std::size_t> entries() const {
    std::vector<std::size_t> entries;
    for (std::size_t i = 0; i < passes.size(); ++i) {
      if (!passes[i].leaves) entries.push_back(i);
    }
    return entries;
  }
  /// Goes in by an entry; false where a ring has done so before.
  bool enter(std::size_t entry) {
    const bool first = !used_[entry];
    used_[entry] = true;
    return first;
  }
  /// Where an edge leaves, if it does.
  std::optional<std::size_t> exit(std::size_t edge) const { return exits_[edge]; }
  /// The passage that follows round the circle.
  std::size_t after(std::size_t pass) const { return (pass + 1) % passes.size(); }
  /// Whether the way there is longer than half the circle.
  bool more_than_half(std::size_t exit) const {
    return order_.more_than_half(passes[exit], passes[after(exit)]);
  }

 private:
  CircleOrder order_;
  std::vector<bool> used_;
  std::vector<std::optional<std::size_t>> exits_;
};
template <class Points, class T>
Walk(const Points&, const Circle<T>&) -> Walk<T>;

/// What is left where the boundary never passes the circle: all of the polygon, all of the circle or nothing.
/// Nothing is put in where it does.
template <class T>
Region<T> undivided(const Walk<T>& walk) {
  Region<T> region{walk.given, {}};
  if (!walk.passes.empty() || walk.corners.empty() || walk.given.radius == T(0)) return region;
  Ring<T> polygon;
  for (const dvec2 p : walk.corners) polygon.push_back({glm::vec<2, T>(p)});
  const auto inside = [&walk](dvec2 p) { return side(p, walk.circle) < 0; };
  if (std::any_of(walk.corners.begin(), walk.corners.end(), inside)) {
    region.add(polygon);
  } else if (contains(walk.corners, walk.circle.centre)) {
    region.add({{walk.given.centre + glm::vec<2, T>(walk.given.radius, 0), true, true}});
  }
  return region;
}

/// The boundary goes straight to a point; what rounds to the corner before it is no new one.
template <class T>
void append(Ring<T>& ring, dvec2 at) {
  const Corner<T> corner{glm::vec<2, T>(at)};
  if (ring.empty() || ring.back() != corner) ring.push_back(corner);
}

/// The boundary goes straight to passage number `exit`, and from there by an arc to the next one. Where the
/// two are one point with nothing between them, there is no arc.
template <class T>
void add_arc(Ring<T>& ring, const Walk<T>& walk, std::size_t exit) {
  const dvec2 from = walk.passes[exit].at, to = walk.passes[walk.after(exit)].at;
  const bool more_than_half = walk.more_than_half(exit);
  if (glm::vec<2, T>(from) == glm::vec<2, T>(to) && !more_than_half) return;
  append(ring, from);
  ring.back().arc = true;
  ring.back().more_than_half = more_than_half;
}

/// What the step says of an edge, whose passages stand last.
template <class T>
Tested tested(const Walk<T>& walk, std::size_t edge) {
  const Run run = walk.run(edge);
  Tested step{edge, run, std::nullopt, std::nullopt};
  const std::size_t passes = std::size_t{run.enters()} + std::size_t{run.leaves()};
  for (const Crossing& pass : std::span(walk.passes).last(passes)) {
    (pass.leaves ? step.leaves : step.enters) = pass.at;
  }
  return step;
}

/// Refuses what only a polygon that meets itself can give. Of the others as many passages leave as enter, so
/// every walk along the polygon comes to an exit.
inline void expect_alternating(std::span<const Crossing> passes) {
  for (std::size_t i = 0; i < passes.size(); ++i) {
    expects(passes[i].leaves != passes[(i + 1) % passes.size()].leaves,
            "the polygon must be simple: its edges {} and {} meet", passes[i].edge,
            passes[(i + 1) % passes.size()].edge);
  }
}

/// What the step says of the arc from a passage.
template <class T>
Bent bent(std::size_t ring, const Walk<T>& walk, std::size_t exit) {
  const std::size_t entry = walk.after(exit);
  return {ring, exit, entry, walk.passes[exit].at, walk.passes[entry].at, walk.more_than_half(exit)};
}

/// The ring without a last corner that is its first.
template <class T>
Ring<T> closed(Ring<T> ring) {
  while (ring.size() > 1 && !ring.back().arc && ring.back().at == ring.front().at) ring.pop_back();
  return ring;
}

// --- The method --------------------------------------------------

/// The part of a polygon that lies in a circle, bounded by the polygon's edges and by arcs of the circle.
/// The walk is that of K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, Computer
/// Graphics 11(2) (SIGGRAPH), 1977, 214-222, with a disc for the second polygon.
///
/// polygon: simple, convex or not, in either direction. Returns rings, counter-clockwise.
///
/// Domain: all finite coordinates and radii. Corners on the circle, edges that touch it, a polygon round the
///   circle or inside: all are decided exactly. What has no area, a tangent's point or radius 0, gives
///   nothing. A polygon that crosses itself is refused or gives rings without meaning (see meeting_edges).
/// Steps: Oriented Tested* Sorted ((Entered Walked* Bent)+ Closed)* Finished; Tested once per edge, Closed
///   once for every ring that has a passage.
/// Accuracy: which edges are cut, how often, and the order round the circle are exact. Corners inside or on
///   the circle are copied; cut ones lie within 0.63 ulp of max(|coordinate|, radius). The area of what the
///   rings describe is right to 4 (r + length of the boundary) ulp(max(|coordinate|, r)).
/// Cost: O(n + m log m) for n edges and m passages.
/// Errors: ContractViolation when the radius is negative, NaN or infinite, a coordinate not finite, or
///   entries and exits do not alternate, which only happens when edges cross or touch each other.
template <std::floating_point T,
          Observer<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<T>> O = Unobserved>
Region<T> arcs(std::span<const glm::vec<2, T>> polygon, const Circle<T>& circle, O&& observer = {}) {
  expect_circle(circle);
  Walk w(polygon, circle);
  if constexpr (observed<O>) observer(Oriented{w.corners, w.circle});
  // Where does the boundary pass?
  for (auto i : w.edges()) {
    w.pass(i);
    if constexpr (observed<O>) observer(tested(w, i));
  }
  // Order that round the circle
  w.sort();
  if constexpr (observed<O>) observer(Sorted{w.passes});
  expect_alternating(w.passes);
  auto region = undivided(w);
  // Each entry left begins a ring
  for (auto entry : w.entries()) {
    Ring<T> ring;
    while (w.enter(entry)) {
      append(ring, w.at(entry));
      if constexpr (observed<O>) observer(Entered{region.rings.size(), entry, w.at(entry)});
      // Along the edges to an exit
      auto i = w.edge_at(entry);
      while (!w.exit(i)) {
        i = w.next(i);
        append(ring, w.corners[i]);
        if constexpr (observed<O>) observer(Walked{region.rings.size(), i, w.corners[i]});
      }
      // Along the arc to an entry
      auto exit = *w.exit(i);
      add_arc(ring, w, exit);
      if constexpr (observed<O>) observer(bent(region.rings.size(), w, exit));
      entry = w.after(exit);
    }
    if (ring.empty()) continue;
    region.add(closed(ring));
    if constexpr (observed<O>) observer(Closed{region.rings.size() - 1, region.rings.back().size()});
  }
  if constexpr (observed<O>) observer(Finished<T>{region});
  return region;
}

/// The same for points in a vector, an array or braces, whose numbers are doubles.
template <OtherPointRow<2> Points = PointsInBraces<2>, class... Observed>
auto arcs(const Points& polygon, const Circle<ScalarOf<Points>>& circle, Observed&&... observer) {
  return arcs(span_of(polygon), circle, std::forward<Observed>(observer)...);
}

// --- What to do with rings ---------------------------------------

/// The angle of an arc from its direction at both ends, in radians; `more_than_half` tells a tiny one from
/// nearly the whole circle. Domain: directions in radii, as those of ends_of_arc. Accuracy: that of the ends,
/// a few ulp of the angle for points far from each other.
inline double sweep(dvec2 from, dvec2 to, bool more_than_half) {
  constexpr double whole = 0x1.921fb54442d18p2;  // 2 pi
  const double turn = from.x * to.y - from.y * to.x, same = from.x * to.x + from.y * to.y;
  double angle = atan2(turn, same);
  if (angle < 0) angle += whole;
  // Rounded ends of a short way may have changed places
  if (more_than_half && angle < whole / 4) return whole;
  if (!more_than_half && angle > 3 * whole / 4) return 0;
  return angle;
}

/// A circle's radius as about 1 times a power of two, in which nothing that lies in it overflows or
/// underflows.
struct Unit {
  double size;    ///< the power of two
  double radius;  ///< in such units: from 1 to 2
};
/// Domain: radius > 0.
inline Unit unit_of(double radius) {
  const double size = std::ldexp(1.0, std::ilogb(radius));
  return {size, radius / size};
}

/// A point seen from the centre, in units of about the radius. Accuracy: one rounding. Domain: no farther
/// away than twice the radius, or the size of an ulp of the centre.
inline dvec2 seen_from(dvec2 centre, dvec2 p, const Unit& unit) {
  // In quarters, for large differences overflow
  const double part = unit.size > 1 ? 0.25 : 1;
  return (part * p - part * centre) / (part * unit.size);
}

/// The directions, from the centre and in radii, of the ends of the arc that begins at corner i of a ring.
struct ArcEnds {
  dvec2 from, to;
  double radians;
};
template <class T>
ArcEnds ends_of_arc(const Ring<T>& ring, std::size_t i, const Circle<T>& circle) {
  const dvec2 c(circle.centre);
  const Unit unit = unit_of(circle.radius);
  const dvec2 from = seen_from(c, dvec2(ring[i].at), unit) / unit.radius;
  const dvec2 to = seen_from(c, dvec2(ring[(i + 1) % ring.size()].at), unit) / unit.radius;
  return {from, to, sweep(from, to, ring[i].more_than_half)};
}

/// The area that rings enclose in units of about the radius, squared: triangles from the centre for straight
/// ways, sectors for arcs. Of circles of every size, while `area` may lie beyond doubles.
template <std::floating_point T>
double area_in(const Unit& unit, const Region<T>& region) {
  const dvec2 c(region.circle.centre);
  double area = 0;
  for (const Ring<T>& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring[i].arc) {
        area += unit.radius * unit.radius * ends_of_arc(ring, i, region.circle).radians / 2;
      } else {
        const dvec2 a = seen_from(c, dvec2(ring[i].at), unit);
        const dvec2 b = seen_from(c, dvec2(ring[(i + 1) % ring.size()].at), unit);
        area += (a.x * b.y - a.y * b.x) / 2;
      }
    }
  }
  return area;
}

/// The area that rings enclose.
/// Domain: any region; what is too large for a double is infinite.
/// Accuracy: with n corners, none farther from the centre than R >= r: n (n + 50) 2^-54 R^2, and 2^-1074.
/// Cost: O(n).
template <std::floating_point T>
double area(const Region<T>& region) {
  if (region.rings.empty()) return 0;
  const Unit unit = unit_of(region.circle.radius);
  return area_in(unit, region) * unit.size * unit.size;
}

/// The rings as polygons, for those who have no arcs: every arc becomes chords of equal length that nowhere
/// lie farther from it than the tolerance (the sagitta, in the units of the polygon). The points are on the
/// circle, so the polygons lie inside the region and are smaller.
///
/// tolerance: 2^-40 r or more; a chord never spans more than a third of the circle.
///
/// Domain: any region.
/// Accuracy: the chords' sagitta is at most the tolerance and 4 ulp of |centre| + r, and points lie within 4
///   ulp of that beside the circle. The ends of arcs are copied.
/// Cost: 0.2 us per point, about 2.2 sqrt(r / tolerance) points for a whole circle.
/// Errors: ContractViolation when the tolerance is NaN or less than 2^-40 r.
template <std::floating_point T>
std::vector<std::vector<glm::vec<2, T>>> flatten(const Region<T>& region, double tolerance) {
  const double r = region.circle.radius;
  // As a quotient: near the smallest numbers 2^-40 r would be 0
  expects(r == 0 ? tolerance >= 0 : tolerance / r >= 0x1p-40,
          "the tolerance is at least 2^-40 of the radius {}, not {}", r, tolerance);
  constexpr double third = 0x1.0c152382d7366p1;  // 2 pi / 3
  // sagitta = r (1 - cos(step / 2)) = 2 r sin^2(step / 4)
  const double step = std::min(third, 4 * asin(std::min(1.0, std::sqrt(tolerance / r / 2)))) * (1 - 0x1p-30);
  const dvec2 centre(region.circle.centre);
  std::vector<std::vector<glm::vec<2, T>>> polygons;
  for (const Ring<T>& ring : region.rings) {
    auto& polygon = polygons.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      polygon.push_back(ring[i].at);
      if (!ring[i].arc) continue;
      const ArcEnds arc = ends_of_arc(ring, i, region.circle);
      const double first = atan2(arc.from.y, arc.from.x);
      const int chords = static_cast<int>(std::ceil(arc.radians / step));  // less than 2^22
      for (int k = 1; k < chords; ++k) {
        const SinCos at = sin_cos(first + arc.radians * (static_cast<double>(k) / chords));
        polygon.push_back(glm::vec<2, T>(centre + r * dvec2(at.cos, at.sin)));
      }
    }
  }
  return polygons;
}

}  // namespace gradus::polygon_circle
