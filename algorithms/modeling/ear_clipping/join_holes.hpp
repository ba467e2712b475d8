#pragma once
// A polygon with holes becomes one ring: each hole is joined by a bridge, a cut there and back.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/faces.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"

namespace gradus::ear_clipping {

// --- Steps -------------------------------------------------------
// All numbers are those of points.

/// A ray to the right from a hole's rightmost corner has met an edge first.
struct EdgeMet {
  int hole;      ///< from 1 on
  int corner;    ///< the hole's rightmost
  int from, to;  ///< the edge
  int end;       ///< the one of them that lies farther right: a bridge would lead there
};

/// A corner lies in the way: between the ray and the bridge so far.
struct InTheWay {
  int hole, corner;
  int instead_of, end;  ///< where a bridge would have led, and where it would lead now
};

/// How a hole hangs on the ring: by a bridge, or because a corner of it touches a corner or an edge of the
/// ring, or an edge of it a corner of the ring.
enum class Joint : std::uint8_t { bridge, corners, on_edge, by_edge };

/// A hole is part of the ring.
struct HoleJoined {
  int hole, corner;  ///< its corner at the joint; where its edge touches, where that begins
  int end;           ///< the ring's corner there; where its edge is touched, where that begins
  Joint by;
  int corners;  ///< of the ring by now
};

/// All are.
struct AllJoined {
  int corners;
};

// --- The ring that grows -----------------------------------------

/// A hole that is not joined yet: its corners clockwise.
struct Hole {
  int number;
  std::vector<int> corners;

  /// From its k-th corner on.
  std::vector<int> from(std::size_t k) const {
    std::vector<int> turned = corners;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(k));
    return turned;
  }
};

/// Where and how a hole comes into the ring: `way` goes behind a place, round the hole and back.
struct Join {
  std::size_t hole;  ///< among those left
  std::size_t place;
  Joint by;
  int corner;  ///< of the hole
  std::vector<int> way;
};

/// A ring from its rightmost corner on, of several the highest, counter-clockwise or clockwise.
template <class T>
std::vector<int> from_rightmost(std::span<const glm::vec<2, T>> points, std::span<const std::int32_t> ring,
                                bool clockwise) {
  const auto at = [&points](int i) { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> turned(ring.begin(), ring.end());
  const auto rightmost = std::ranges::max_element(
      turned, [&](int i, int k) { return at(i).x < at(k).x || (at(i).x == at(k).x && at(i).y < at(k).y); });
  std::ranges::rotate(turned, rightmost);
  // No corner reaches farther: there a simple ring turns the way it runs
  if ((orient2d(at(turned.back()), at(turned[0]), at(turned[1])) < 0) != clockwise)
    std::reverse(turned.begin() + 1, turned.end());
  return turned;
}

/// The ring so far: numbers of points, counter-clockwise. Ends of bridges stand in it twice.
template <class T>
class GrowingRing {
 public:
  using Point = glm::vec<2, T>;

  /// points: must outlive this.
  GrowingRing(std::span<const Point> points, std::span<const std::int32_t> outline)
      : points_(points), corners_(from_rightmost(points, outline, false)) {}

  const std::vector<int>& corners() const { return corners_; }
  int size() const { return int(corners_.size()); }
  Point at(int number) const { return points_[static_cast<std::size_t>(number)]; }

  /// A hole that touches the ring, and where.
  std::optional<Join> touched_by(const std::vector<Hole>& holes) const {
    for (std::size_t h = 0; h < holes.size(); ++h) {
      const std::size_t n = holes[h].corners.size();
      for (std::size_t k = 0; k < n; ++k) {
        const int corner = holes[h].corners[k], after = holes[h].corners[(k + 1) % n];
        for (std::size_t i = 0; i < corners_.size(); ++i) {
          if (const auto by = touch(i, corner, after))
            return Join{h, i, *by, corner, way(holes[h], k, i, *by)};
        }
      }
    }
    return std::nullopt;
  }
  /// A bridge from the first corner of the last hole.
  Join bridge_to(int end, const std::vector<Hole>& holes) const {
    const int corner = holes.back().corners[0];
    const std::size_t place = place_of(end, corner);
    return {holes.size() - 1, place, Joint::bridge, corner, way(holes.back(), 0, place, Joint::bridge)};
  }

  /// The edge that a ray to the right meets first, by the place of its lower end. The ray runs a little
  /// higher than the corner: it passes what only reaches up to it.
  std::optional<std::size_t> met_from(int corner) const {
    const Point m = at(corner);
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Point a = at(corners_[i]), b = at(corners_[next(i)]);
      // Upwards: then the inside lies on the left
      if (!(a.y <= m.y && m.y < b.y) || orient2d(a, b, m) <= 0) continue;
      if (!first || is_left_of(i, *first)) first = i;
    }
    return first;
  }

  /// Whether a corner lies in the way of a bridge from m to v: between it and the ray, before the edge.
  bool in_way(int corner, int m, int v, std::size_t edge) const {
    const Point p = at(corner), from = at(m), to = at(v);
    const bool up = to.y >= from.y;
    if (p.x <= from.x || (up ? p.y < from.y : p.y > from.y)) return false;
    if (orient2d(at(corners_[edge]), at(corners_[next(edge)]), p) < 0) return false;
    const int turn = up ? orient2d(from, to, p) : -orient2d(from, to, p);
    return turn < 0 || (turn == 0 && p.x < to.x);
  }

  void insert(const Join& join) {
    const auto behind = corners_.begin() + static_cast<std::ptrdiff_t>(join.place) + 1;
    corners_.insert(behind, join.way.begin(), join.way.end());
  }
  HoleJoined joined(const std::vector<Hole>& holes, const Join& join) const {
    return {holes[join.hole].number, join.corner, corners_[join.place], join.by, size()};
  }

  std::pair<int, int> edge(std::size_t place) const { return {corners_[place], corners_[next(place)]}; }
  int rightmost(int a, int b) const { return at(a).x > at(b).x ? a : b; }
  std::size_t next(std::size_t place) const { return place + 1 < corners_.size() ? place + 1 : 0; }

 private:
  bool on_edge(int from, int to, int corner) const {
    const Point a = at(from), b = at(to), p = at(corner);
    return p != a && p != b && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y) && orient2d(a, b, p) == 0;
  }
  /// How a hole's corner, or its edge to the next one, touches the ring at a place or on the edge from there.
  std::optional<Joint> touch(std::size_t place, int corner, int after) const {
    if (at(corners_[place]) == at(corner) && faces(place, at(after))) return Joint::corners;
    if (on_edge(corners_[place], corners_[next(place)], corner)) return Joint::on_edge;
    if (on_edge(corner, after, corners_[place]) && faces(place, at(after))) return Joint::by_edge;
    return std::nullopt;
  }
  std::vector<int> way(const Hole& hole, std::size_t k, std::size_t place, Joint by) const {
    const bool from_next = by == Joint::corners || by == Joint::by_edge;
    std::vector<int> way = hole.from(from_next ? (k + 1) % hole.corners.size() : k);
    if (!from_next) way.push_back(way.front());
    if (by == Joint::bridge || by == Joint::by_edge) way.push_back(corners_[place]);
    return way;
  }
  /// Of all places of a corner in the ring the one that looks at a point.
  std::size_t place_of(int corner, int towards) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (at(corners_[i]) == at(corner) && faces(i, at(towards))) return i;
    }
    return static_cast<std::size_t>(std::ranges::find(corners_, corner) - corners_.begin());
  }
  /// Whether the way from the corner at a place to a point begins inside the ring.
  bool faces(std::size_t place, Point p) const {
    const Point before = at(corners_[place > 0 ? place - 1 : corners_.size() - 1]),
                here = at(corners_[place]), after = at(corners_[next(place)]);
    const bool left_of_first = orient2d(before, here, p) > 0, left_of_second = orient2d(here, after, p) > 0;
    return orient2d(before, here, after) > 0 ? left_of_first && left_of_second
                                             : left_of_first || left_of_second;
  }

  /// Of two edges upwards that a ray meets, whether it meets the first one first: edges don't cross, so that
  /// the end that lies at the other's height says it.
  bool is_left_of(std::size_t i, std::size_t k) const {
    const Point a = at(corners_[i]), b = at(corners_[next(i)]), c = at(corners_[k]),
                d = at(corners_[next(k)]);
    const int low = a.y >= c.y ? orient2d(c, d, a) : -orient2d(a, b, c);
    if (low != 0) return low > 0;
    return (b.y <= d.y ? orient2d(c, d, b) : -orient2d(a, b, d)) > 0;
  }

  std::span<const Point> points_;
  std::vector<int> corners_;
};

/// All rings but the first, each from its rightmost corner on, the one that reaches farthest right last.
template <class T>
std::vector<Hole> holes_of(std::span<const glm::vec<2, T>> points, const Faces& rings) {
  std::vector<Hole> holes;
  for (std::size_t i = 1; i < rings.size(); ++i)
    holes.push_back({static_cast<int>(i), from_rightmost(points, rings[i], true)});
  const auto reach = [&](const Hole& hole) { return points[static_cast<std::size_t>(hole.corners[0])].x; };
  std::ranges::sort(holes, [&](const Hole& a, const Hole& b) {
    return reach(a) < reach(b) || (reach(a) == reach(b) && a.number > b.number);
  });
  return holes;
}

inline void remove(std::vector<Hole>& holes, const Join& join) {
  holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(join.hole));
}

/// The bridge of the hole that reaches farthest right: from its rightmost corner to the right end of the
/// edge that a ray to the right meets first, or, where corners lie in the way, to the one next to the ray.
template <class T, Observer<EdgeMet, InTheWay> O = Unobserved>
Join bridge(const GrowingRing<T>& R, const std::vector<Hole>& H, O&& observer = {}) {
  int m = H.back().corners[0];
  // What a ray to the right meets
  auto e = R.met_from(m);
  expects(e.has_value(), "hole {} does not lie inside", H.back().number);
  auto [a, b] = R.edge(*e);
  // To its end farther right
  int v = R.rightmost(a, b);
  if constexpr (observed<O>) observer(EdgeMet{H.back().number, m, a, b, v});
  // But for corners in the way
  for (int c : R.corners()) {
    if (R.in_way(c, m, v, *e)) {
      if constexpr (observed<O>) observer(InTheWay{H.back().number, m, v, c});
      v = c;
    }
  }
  return R.bridge_to(v, H);
}

/// Makes one ring of an outline and the holes in it, so that triangulate can cut it. From the rightmost
/// corner of a hole a bridge leads to a corner that is seen from there; holes farther right come first, so
/// that none is in the way. Source: D. Eberly, Triangulation by ear clipping, Geometric Tools, 1998-2015,
/// section 5.
///
/// P: the points. rings: the outline, then its holes, each in either direction. Returns the corners of the
///   ring, counter-clockwise.
///
/// Domain: simple rings, the holes inside the outline and beside each other. They may touch it and each other
///   in points, as long as the inside stays in one piece. Finite.
/// Steps: ((EdgeMet InTheWay*)? HoleJoined)* AllJoined.
/// Accuracy: all decisions are exact. A bridge adds two corners to those of outline and holes. A hole that
///   touches the ring needs none: there an edge that is touched adds one corner.
/// Cost: O(h^2 n) for h holes and n corners in all.
/// Errors: ContractViolation for points that are not finite, rings of less than three corners, numbers of no
///   point, and a hole outside.
template <class T, Observer<EdgeMet, InTheWay, HoleJoined, AllJoined> O = Unobserved>
std::vector<int> join_holes(std::span<const glm::vec<2, T>> P, const Faces& rings, O&& observer = {}) {
  expect_polygon(P);
  expect_faces(rings, P.size());
  expects(!rings.empty(), "a polygon has an outline");
  GrowingRing<T> R(P, rings[0]);
  // The rightmost is the last
  auto H = holes_of(P, rings);
  while (!H.empty()) {
    // One that touches hangs there
    auto j = R.touched_by(H);
    if (!j) {
      j = bridge(R, H, observer);
    }
    // There, round it, and back
    R.insert(*j);
    if constexpr (observed<O>) observer(R.joined(H, *j));
    remove(H, *j);
  }
  if constexpr (observed<O>) observer(AllJoined{R.size()});
  return R.corners();
}

/// The places of a ring's corners.
template <class T>
std::vector<glm::vec<2, T>> places_of(std::span<const glm::vec<2, T>> points, const std::vector<int>& ring) {
  std::vector<glm::vec<2, T>> places;
  for (const int corner : ring) places.push_back(points[static_cast<std::size_t>(corner)]);
  return places;
}

/// Cuts a polygon with holes into triangles of its points: join_holes, then triangulate.
///
/// emit(Triangle) gets each triangle, counter-clockwise, by the numbers of its points.
///
/// Domain, Errors: as join_holes.
/// Steps: those of join_holes, then those of triangulate, whose numbers are places in the joined ring.
/// Accuracy: as theirs: with n corners in all and h holes that touch nothing n + 2h - 2 triangles, which
/// cover
///   the polygon without its holes exactly once.
/// Cost: as triangulate.
template <class T, std::invocable<const Triangle&> Emit, class O = Unobserved>
void triangulate_with_holes(std::span<const glm::vec<2, T>> P, const Faces& rings, Emit&& emit,
                            O&& observer = {}) {
  const std::vector<int> ring = join_holes(P, rings, observer);
  const std::vector<glm::vec<2, T>> places = places_of(P, ring);
  const auto number = [&ring](int place) { return ring[static_cast<std::size_t>(place)]; };
  const auto name = [&](const Triangle& t) { emit(Triangle{number(t[0]), number(t[1]), number(t[2])}); };
  triangulate(std::span<const glm::vec<2, T>>(places), name, observer);
}

}  // namespace gradus::ear_clipping
