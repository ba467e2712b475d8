#pragma once
// The BSP tree: planes of polygons divide space again and again, until the polygons can be walked from back
// to front for any eye.

#include <algorithm>
#include <cstddef>
#include <glm/vec4.hpp>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "visibility/bsp_tree/bsp_planes.hpp"

namespace gradus::bsp_tree {

/// A convex polygon, or a part of one that a plane has cut.
///
/// corners: counter-clockwise seen from its front. face: who it is.
///
/// Domain: at least 3 corners, not all on a line; finite, extents from 1e-75 to 1e75 (of double), so that the
///   squares of areas neither overflow nor vanish. Corners may lie beside the plane of the others, by
///   rounding or by more.
/// Errors: ContractViolation for corners without an inside.
template <class T>
struct Polygon {
  std::vector<glm::vec<3, T>> corners{};
  std::size_t face = 0;
  Plane<T> plane{};
  bool is_part = false;  ///< a plane has cut it: corners are rounded

  Polygon() = default;
  Polygon(std::vector<glm::vec<3, T>> its_corners, std::size_t its_face = 0)
      : corners(std::move(its_corners)), face(its_face), plane(plane_of(corners)) {}

  /// A part of it, without corners as yet. Its plane is not found anew from rounded ones.
  Polygon part() const {
    Polygon part;
    part.face = face;
    part.plane = plane;
    part.is_part = true;
    return part;
  }
};

/// Where a polygon lies.
enum class Side { in_plane, in_front, behind, both };

inline constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A plane and what lies in it; what lies in front and behind is in the two subtrees.
template <class T>
struct Node {
  Plane<T> plane;
  std::vector<Polygon<T>> polygons;            ///< in the plane; the first gave it, and is drawn last
  std::size_t in_front = none, behind = none;  ///< nodes
};

/// Node 0 is the root; a tree of nothing has no nodes.
template <class T>
using Tree = std::vector<Node<T>>;

/// A polygon's plane parts a subspace.
template <class T>
struct PlaneTaken {
  std::size_t node;
  std::size_t parent;  ///< none for the root
  bool in_front;       ///< of the parent's plane, or behind it
  Polygon<T> polygon;
  std::size_t others;  ///< polygons that it parts
};

/// A polygon was held against the plane.
template <class T>
struct Placed {
  std::size_t node;
  Polygon<T> polygon;
  Side side;
};

/// The plane cut a polygon in two.
template <class T>
struct Split {
  std::size_t node;
  Polygon<T> in_front, behind;
};

/// The tree stands.
struct Built {
  std::size_t nodes, polygons;
};

/// A node was reached on the walk: the eye lies on this side of its plane, +1 in front, -1 behind, 0 in it.
struct Visited {
  std::size_t node;
  int eye_side;
};

/// A polygon's turn has come; all that came before can't cover it.
template <class T>
struct Drawn {
  std::size_t node;
  Polygon<T> polygon;
};

/// Where the eye is: a point, or at w = 0 the direction towards an eye that is infinitely far away.
template <class T>
using Eye = glm::vec<4, T>;

// --- Sides and cuts

/// Where a polygon lies whose corners have these sides.
constexpr Side side_of(std::span<const int> sides) {
  bool front = false, back = false;
  for (const int side : sides) {
    front = front || side > 0;
    back = back || side < 0;
  }
  if (front && back) return Side::both;
  if (front) return Side::in_front;
  return back ? Side::behind : Side::in_plane;
}

/// The sides of an outline's corners as a chord parts them: in front from corner `high` on up to the first
/// that is not, then behind; and from corner `low` on the same the other way round.
inline std::vector<int> parted_by_chord(std::vector<int> sides, std::size_t high, std::size_t low) {
  const std::size_t n = sides.size();
  const auto walk = [&](std::size_t from, std::size_t to) {
    const int side = sides[from];
    while (sides[from] == side) from = (from + 1) % n;
    for (; from != to; from = (from + 1) % n) {
      const std::size_t next = (from + 1) % n;
      sides[next] = -side;
    }
  };
  walk(high, low);
  walk(low, high);
  return sides;
}

/// The sides of a polygon's corners where some lie in front of a plane and some behind: a plane cuts a convex
/// outline at two places. Where corners beside their polygon's own plane say more than that, those between
/// the highest and the lowest give way.
template <class T>
std::vector<int> sides_of_cut(const Plane<T>& plane, const Polygon<T>& polygon, const std::vector<int>& on) {
  const auto find = [&](int side) {
    return static_cast<std::size_t>(std::ranges::find(on, side) - on.begin());
  };
  if (parted_by_chord(on, find(1), find(-1)) == on) return on;
  std::size_t high = find(1), low = find(-1);
  for (std::size_t i = 0; i < on.size(); ++i) {
    const auto& corner = polygon.corners[i];
    if (on[i] > 0 && compare_heights(plane, corner, polygon.corners[high]) > 0) high = i;
    if (on[i] < 0 && compare_heights(plane, corner, polygon.corners[low]) < 0) low = i;
  }
  return parted_by_chord(on, high, low);
}

/// Whether all that gave a plane lies in another one.
template <class T, class SideOf>
bool lies_in(const Plane<T>& plane, const Plane<T>& other, const SideOf& side) {
  const auto within = [&](const auto& point) { return side(other, point) == 0; };
  return within(plane.a) && within(plane.b) && within(plane.c) && within(plane.highest) &&
         within(plane.lowest);
}

/// The sides of a plane on which a polygon's corners lie. A part lies in the planes of its whole, wherever
/// rounding has put its corners.
template <class T, class SideOf>
std::vector<int> sides(const Plane<T>& plane, const Polygon<T>& polygon, const SideOf& side) {
  if (polygon.is_part && lies_in(polygon.plane, plane, side)) return std::vector<int>(polygon.corners.size());
  std::vector<int> all;
  for (const auto& corner : polygon.corners) all.push_back(side(plane, corner));
  return side_of(all) == Side::both ? sides_of_cut(plane, polygon, all) : all;
}

/// Where a polygon lies, without the sides of all its corners.
template <class T, class SideOf>
Side side_of_polygon(const Plane<T>& plane, const Polygon<T>& polygon, const SideOf& side) {
  if (polygon.is_part && lies_in(polygon.plane, plane, side)) return Side::in_plane;
  bool front = false, back = false;
  for (const auto& corner : polygon.corners) {
    const int at = side(plane, corner);
    front = front || at > 0;
    back = back || at < 0;
    if (front && back) return Side::both;
  }
  return front ? Side::in_front : back ? Side::behind : Side::in_plane;
}

/// The parts of a polygon on the two sides of a plane.
template <class T>
struct Parts {
  Polygon<T> in_front, behind;
};

/// The two parts of a polygon with corners on both sides of a plane, as Sutherland and Hodgman clip.
template <class T>
Parts<T> split(const Plane<T>& plane, const Polygon<T>& polygon, std::span<const int> sides) {
  Parts<T> parts{polygon.part(), polygon.part()};
  auto &front = parts.in_front.corners, &back = parts.behind.corners;
  const std::size_t n = polygon.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const auto &p = polygon.corners[i], &q = polygon.corners[next];
    if (sides[i] >= 0) front.push_back(p);
    if (sides[i] <= 0) back.push_back(p);
    if (sides[i] * sides[next] < 0) {
      const auto cut = crossing(plane, p, q);
      front.push_back(cut);
      back.push_back(cut);
    }
  }
  return parts;
}

// --- The tree

/// Polygons that no plane has parted yet, and the node below which they belong.
template <class T>
struct Subspace {
  std::size_t parent = none;
  bool in_front = false;
  std::vector<Polygon<T>> polygons{};

  bool empty() const { return polygons.empty(); }
  /// All but the one whose plane parts them.
  std::span<const Polygon<T>> others() const { return std::span(polygons).subspan(1); }
  void add(const Polygon<T>& polygon) { polygons.push_back(polygon); }
};

/// What there is to part at first.
template <class T>
std::vector<Subspace<T>> whole_space(const std::vector<Polygon<T>>& polygons) {
  return {{none, false, polygons}};
}

/// A polygon lies in a node's plane.
template <class T>
void add_to_node(Tree<T>& tree, std::size_t node, const Polygon<T>& polygon) {
  tree[node].polygons.push_back(polygon);
}

/// Makes the node of the first polygon's plane, and links it to its parent.
template <class T>
std::size_t add_node(Tree<T>& tree, const Subspace<T>& space) {
  const std::size_t node = tree.size();
  if (space.parent != none) {
    Node<T>& parent = tree[space.parent];
    (space.in_front ? parent.in_front : parent.behind) = node;
  }
  const Polygon<T>& first = space.polygons.front();
  tree.push_back({first.plane, {first}});
  return node;
}

/// The plane of a node, which parts others: how it lies to them is told by `side`.
template <class T, class SideOf>
class Cutter {
 public:
  Cutter(const Node<T>& node, const SideOf& side) : plane_(node.plane), side_(side) {}

  auto sides(const Polygon<T>& polygon) const { return bsp_tree::sides(plane_, polygon, side_); }
  Parts<T> operator()(const Polygon<T>& polygon, std::span<const int> sides) const {
    return split(plane_, polygon, sides);
  }

 private:
  const Plane<T> plane_;
  const SideOf& side_;
};

/// What is reported of a new node.
template <class T>
PlaneTaken<T> taken(const Tree<T>& tree, std::size_t node, const Subspace<T>& space) {
  return {node, space.parent, space.in_front, tree[node].polygons.front(), space.polygons.size() - 1};
}

/// How many polygons a tree holds, whole or in parts.
template <class T>
std::size_t polygon_count(const Tree<T>& tree) {
  std::size_t count = 0;
  for (const Node<T>& node : tree) count += node.polygons.size();
  return count;
}

/// Takes the last one off a list of things to do.
template <class Item>
Item pop(std::vector<Item>& list) {
  Item item = std::move(list.back());
  list.pop_back();
  return item;
}

/// Parts space by the plane of the first polygon; what lies on both sides of it is cut. In front and behind
/// the same is done again, until every polygon lies in the plane of a node.
/// Source: H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface generation by a priori tree structures,
/// Computer Graphics (SIGGRAPH) 14(3), 1980, 124-133.
///
/// polygons: convex, each in one plane, in any order; it decides how many are cut. side: tells on which side
///   of a plane a point lies; exactly unless another is given, which may take a little as 0 where corners are
///   rounded and faces thus not quite flat.
///
/// Domain: the polygons may touch, pierce each other, overlap in a cycle and stand twice in the list. A part
///   may have no area where rounding has closed it.
/// Steps: (PlaneTaken (Placed | Placed Split)*)* Built
/// Accuracy: sides are exact, against planes as thick as their polygons are uneven; corners at a
///   cut are the nearest doubles, and count from then on as they stand. So the parts of a polygon meet along
///   their cuts and nowhere else, and their areas add up to its own but for that rounding. With a rational
///   scalar nothing is rounded.
/// Cost: at worst n^2 tests and parts, in practice some n log n; a test some 6 ns, a cut some 30 us.
/// Errors: ContractViolation for coordinates that are not finite.
template <class T, class SideOf = ExactSide,
          Observer<PlaneTaken<T>, Placed<T>, Split<T>, Built> O = Unobserved>
Tree<T> build(const std::vector<Polygon<T>>& polygons, const SideOf& side = {}, O&& observer = {}) {
  using enum Side;
  Tree<T> tree;
  auto rest = whole_space(polygons);
  while (!rest.empty()) {
    auto space = pop(rest);
    if (space.empty()) continue;
    // The first parts the others
    auto n = add_node(tree, space);
    Cutter cut(tree[n], side);
    if constexpr (observed<O>) observer(taken(tree, n, space));
    Subspace<T> front{n, true};
    Subspace<T> back{n, false};
    for (auto& p : space.others()) {
      auto on = cut.sides(p);
      const Side at = side_of(on);
      if constexpr (observed<O>) observer(Placed<T>{n, p, at});
      if (at == in_front) {
        front.add(p);
      } else if (at == behind) {
        back.add(p);
      } else if (at == in_plane) {
        add_to_node(tree, n, p);
      } else {
        // Cut along the plane
        auto [f, b] = cut(p, on);
        if constexpr (observed<O>) observer(Split<T>{n, f, b});
        front.add(f);
        back.add(b);
      }
    }
    rest.push_back(back);
    rest.push_back(front);
  }
  if constexpr (observed<O>) observer(Built{tree.size(), polygon_count(tree)});
  return tree;
}

// --- The walk

/// The side of a plane on which an eye lies, exactly, at infinity as well.
inline int side_of_eye(const Plane<double>& plane, const Eye<double>& eye) {
  if (eye.w != 0) return orient3d(plane.a, plane.b, plane.c, dvec3(eye) / eye.w);
  const dvec3 way(eye), a = plane.a;
  if (const auto sure = orient3d_filtered(dvec3{0}, plane.b - a, plane.c - a, way)) return *sure;
  SumOfProducts<3> volume;
  detail::add_determinant(volume, false, plane.b, plane.c, way);
  detail::add_determinant(volume, true, a, plane.c, way);
  detail::add_determinant(volume, false, a, plane.b, way);
  return volume.sign();
}
inline int side_of_eye(const Plane<float>& plane, const Eye<float>& eye) {
  return side_of_eye(detail::in_double(plane), glm::dvec4(eye));
}
template <class T>
int side_of_eye(const Plane<T>& plane, const Eye<T>& eye) {
  using Vec = glm::vec<3, T>;
  const T height = glm::dot(glm::cross(plane.b - plane.a, plane.c - plane.a), Vec(eye) - eye.w * plane.a);
  return (height > T{0}) - (height < T{0});
}

/// The same of a node's plane.
template <class T>
int eye_side(const Node<T>& node, const Eye<T>& eye) {
  return side_of_eye(node.plane, eye);
}

/// What is still to be done on the walk: a node's subtree, or its own polygons.
struct Turn {
  std::size_t node;
  bool own = false;
};

/// The whole tree.
template <class T>
std::vector<Turn> first_turn(const Tree<T>& tree) {
  return {{tree.empty() ? none : 0}};
}

inline void push(std::vector<Turn>& turns, std::size_t node, bool own = false) {
  turns.push_back({node, own});
}

/// Those in a node's plane, the first of which is to be seen.
template <class T>
auto reversed(const Node<T>& node) {
  return std::views::reverse(node.polygons);
}

/// The subtree on the eye's side of a node's plane, and the one beyond it. In the plane itself the eye sees
/// no polygon of it: either may come first.
template <class T>
std::size_t near_side(const Node<T>& node, int side) {
  return side > 0 ? node.in_front : node.behind;
}
template <class T>
std::size_t far_side(const Node<T>& node, int side) {
  return side > 0 ? node.behind : node.in_front;
}

/// Gives a tree's polygons to `draw` from back to front: before those of a plane all that lies beyond it,
/// seen from the eye, and after them all on the eye's own side. None can cover one that comes later. Of those
/// in one plane the first is seen: they come from the last to the first.
/// Source: Fuchs, Kedem and Naylor 1980, as build.
///
/// eye: a point, w = 1; or the direction towards a distant one, w = 0, not all 0. draw(polygon): takes each
///   polygon, whole or a part, once.
///
/// Domain: w is 1 or 0; finite. Polygons that the eye sees edge-on come in either order.
/// Steps: (Visited | Drawn)*, a Visited for each node on the way down, and its polygons' Drawn on the way up.
/// Accuracy: the eye's sides are exact.
/// Cost: each node twice; one test of 6 ns per node.
/// Errors: none.
template <class T, class Draw, Observer<Visited, Drawn<T>> O = Unobserved>
void back_to_front(const Tree<T>& tree, const Eye<T>& eye, Draw&& draw, O&& observer = {}) {
  auto turns = first_turn(tree);
  while (!turns.empty()) {
    auto [at, own] = pop(turns);
    if (at == none) continue;
    const auto& n = tree[at];
    if (own) {
      // All beyond it is drawn
      for (auto& p : reversed(n)) {
        draw(p);
        if constexpr (observed<O>) observer(Drawn<T>{at, p});
      }
      continue;
    }
    int side = eye_side(n, eye);
    if constexpr (observed<O>) observer(Visited{at, side});
    // The eye's own side comes last
    push(turns, near_side(n, side));
    push(turns, at, true);
    push(turns, far_side(n, side));
  }
}

}  // namespace gradus::bsp_tree
