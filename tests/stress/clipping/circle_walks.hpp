#pragma once
// What is promised of the rings of a polygon in a circle, and of the steps to them.

#include "core/record.hpp"
#include "stress/clipping/circle_polygons.hpp"

namespace gradus::stress::circle_walks {

using namespace circle_polygons;

// --- Promises ---

/// Whether 200 bits hold every sum of products of these numbers.
inline bool of_one_size(const Input& i) {
  double least = wrong, most = 0;
  for (const double x : i) {
    if (x != 0) least = std::min(least, std::abs(x));
    most = std::max(most, std::abs(x));
  }
  return most <= 0x1p30 * least;
}

/// Whether a point lies in a polygon, not on it: an odd number of edges passes right of it.
inline bool holds(const Points& points, dvec2 at) {
  const test::ExactPoint p = test::exact_point(at);
  bool inside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto a = test::exact_point(points[i]), b = test::exact_point(points[(i + 1) % points.size()]);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    inside ^= (test::turn(a, b, p) > 0) == (a.y < b.y);
  }
  return inside;
}

/// A straight way between two points.
struct Way {
  dvec2 from, to;
};

/// How far a way is from an edge's piece, in either direction; a given end must be met bit for bit.
inline double error_of(const Way& way, const EndsInCircle<double>& piece) {
  const auto off = [](const Place<double>& place, bool given, dvec2 p) {
    const double error = place.error(p);
    return given && error != 0 ? wrong : error;
  };
  return std::max(off(piece.from, piece.from_is_given, way.from), off(piece.to, piece.to_is_given, way.to));
}
inline double error_either_way(const Way& way, const EndsInCircle<double>& piece) {
  return std::min(error_of(way, piece), error_of({way.to, way.from}, piece));
}

/// The rings, if nothing is refused.
template <class T = double>
std::optional<Region<T>> region_of(const Input& i) {
  try {
    return arcs(points_of<T>(i), circle_of<T>(i));
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
}

/// What the rings have of straight ways, and their corners; short pieces may have rounded to one.
struct WaysOfRings {
  std::vector<Way> ways, points;
  bool any_of_no_length = false;
};
inline WaysOfRings ways_of(const Region<double>& region) {
  WaysOfRings all;
  for (const auto& ring : region.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Way way{ring[k].at, ring[(k + 1) % ring.size()].at};
      all.points.push_back({way.from, way.from});
      if (!ring[k].arc) all.ways.push_back(way);
      all.any_of_no_length |= !ring[k].arc && ring.size() > 1 && way.from == way.to;
    }
  }
  return all;
}

/// The worst end of what the rings have of the polygon's edges; wrong where they lack an edge's piece, or
/// have one that is none.
inline double pieces_error(const Input& i) {
  const auto region = region_of(i);
  if (!is_taken(i)) return region ? wrong : 0;
  if (!is_simple(i)) return 0;
  if (!region) return wrong;
  const Points points = points_of(i);
  std::vector<EndsInCircle<double>> pieces;
  const bool has_area = test::exact_area(points) != 0;
  for (std::size_t k = 0; has_area && k < corners; ++k) {
    const dvec2 a = points[k], b = points[(k + 1) % corners];
    if (a == b) continue;
    const auto ends = ends_in_circle({a.x, a.y, b.x, b.y, i[0], i[1], i[2]});
    if (ends && ends->runs) pieces.push_back(*ends);
  }
  if (pieces.empty()) {
    const bool whole = has_area && i[2] > 0 && holds(points, {i[0], i[1]});
    if (!whole) return region->rings.empty() ? 0 : wrong;
    const bool is_whole =
        region->rings.size() == 1 && region->rings[0].size() == 1 && region->rings[0][0].arc;
    return is_whole ? 0 : wrong;
  }
  const WaysOfRings found = ways_of(*region);
  if (found.any_of_no_length) return wrong;
  double worst = 0;
  for (const auto& piece : pieces) {
    double best = wrong;
    for (const Way& way : found.ways) best = std::min(best, error_either_way(way, piece));
    for (const Way& way : found.points) best = std::min(best, error_either_way(way, piece));
    worst = std::max(worst, best);
  }
  for (const Way& way : found.ways) {
    const auto is_way = [&](const auto& piece) { return error_either_way(way, piece) <= 1; };
    if (std::ranges::none_of(pieces, is_way)) return wrong;
  }
  return worst;
}

// --- Steps ---

using Steps = Recorder<Oriented, Tested, Sorted, Entered, Walked, Bent, Closed, Finished<double>>;
/// The steps of a simple polygon.
inline std::optional<Steps> steps_of(const Input& i) {
  if (!is_taken(i) || !is_simple(i)) return std::nullopt;
  Steps seen;
  arcs(points_of(i), circle_of(i), seen);
  return seen;
}

/// 0 where each edge runs in the open disc exactly when it does, and has the bits of a clipped segment.
inline double edges_error(const Input& i) {
  const auto seen = steps_of(i);
  if (!seen) return 0;
  for (const Tested& t : all<Tested>(*seen)) {
    const auto [a, b] = t.run.edge;
    if (t.run.inside != WholeQuadratic({a.x, a.y, b.x, b.y, i[0], i[1], i[2]}).runs()) return wrong;
    if (!t.run.inside) continue;
    const Segment<2, double> run{t.enters.value_or(a), t.leaves.value_or(b)};
    if (run != liang_barsky_circle::exact_decision(t.run.edge, circle_of(i))) return wrong;
  }
  return 0;
}

/// The direction of a passage from the centre, in 400 bits.
using Many = test::Float<400>;
struct Direction {
  Many x, y;
  int half() const { return (abs(y) > Many(0x1p-1000) ? y > 0 : x > 0) ? 0 : 1; }
};
inline Direction direction_of(const Crossing& c, const Points& around, const Circle<double>& circle) {
  const Segment<2, double> s = edge_of(around, c.edge);
  const Many dx = Many(s.b.x) - s.a.x, dy = Many(s.b.y) - s.a.y;
  const Many fx = Many(s.a.x) - circle.centre.x, fy = Many(s.a.y) - circle.centre.y;
  const Many k = dx * fy - dy * fx, A = dx * dx + dy * dy, r(circle.radius);
  const Many root = sqrt(Many(r * r * A - k * k)) * (c.leaves ? 1 : -1);
  return {(root * dx - k * dy) / A / r, (root * dy + k * dx) / A / r};
}

/// How far each passage is turned beyond the one before it, round the circle; below 0 where the order is
/// wrong.
inline std::vector<Many> turns_of(const Steps& seen) {
  const auto oriented = all<Oriented>(seen).at(0);
  const auto sorted = all<Sorted>(seen).at(0);
  std::vector<Direction> directions;
  for (const Crossing& c : sorted.crossings) {
    directions.push_back(direction_of(c, oriented.corners, oriented.circle));
  }
  std::vector<Many> turns;
  for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
    const Direction &a = directions[k], &b = directions[k + 1];
    turns.push_back(a.half() == b.half() ? Many(a.x * b.y - a.y * b.x) : Many(b.half() - a.half()));
  }
  return turns;
}
inline double order_error(const Input& i) {
  if (!of_one_size(i)) return 0;
  const auto seen = steps_of(i);
  if (!seen) return 0;
  // 400 bits hold what equal directions leave
  const auto is_right = [](const Many& turn) { return turn >= -Many(0x1p-1000); };
  return std::ranges::all_of(turns_of(*seen), is_right) ? 0 : wrong;
}
/// Whether passages lie so close that doubles can't tell them apart.
inline bool has_doubtful_order(const Input& i) {
  const auto seen = of_one_size(i) ? steps_of(i) : std::nullopt;
  if (!seen) return false;
  return std::ranges::any_of(turns_of(*seen),
                             [](const Many& turn) { return Many(0x1p-1000) < turn && turn < Many(0x1p-50); });
}

/// 0 where every arc that can be told from a point lies in the polygon, at one of some places at least: at
/// others a corner may touch it.
inline double arcs_error(const Input& i) {
  // Of the smallest circles doubles can't name the middle of an arc
  if (!is_taken(i) || i[2] < 0x1p-1000 || !is_simple(i) || !of_one_size(i)) return 0;
  const auto region = region_of(i);
  if (!region) return wrong;
  const auto lies_inside = [&](const ArcEnds& arc) {
    const double start = atan2(arc.from.y, arc.from.x);
    for (const double part : {0.5, 0.3, 0.7}) {
      const SinCos at = sin_cos(start + part * arc.radians);
      const dvec2 direction(at.cos, at.sin);
      for (const double length : {1.0, 1 - 0x1p-30}) {
        if (holds(points_of(i), region->circle.centre + length * region->circle.radius * direction))
          return true;
      }
    }
    return false;
  };
  for (const auto& ring : region->rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (!ring[k].arc) continue;
      const ArcEnds arc = ends_of_arc(ring, k, region->circle);
      if (arc.radians >= 1e-3 && !lies_inside(arc)) return wrong;
    }
  }
  return 0;
}

}  // namespace gradus::stress::circle_walks
