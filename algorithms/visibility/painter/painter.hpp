#pragma once
// The painter's algorithm: polygons from back to front, each painted over what is there; sorted by depth, and
// by Newell, Newell and Sancha moved and cut until none covers what comes later.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus::painter {

using bsp_tree::Eye;
using bsp_tree::none;
using bsp_tree::Plane;
using bsp_tree::Polygon;
using bsp_tree::Side;

/// Who looks, and how the screen stands: at right angles but for rounding, of any length.
template <class T>
struct View {
  Eye<T> eye;                ///< a point, w = 1; or the direction towards a distant one, w = 0
  glm::vec<3, T> right, up;  ///< of the screen
  glm::vec<3, T> forward;    ///< depths are counted along it
};

/// The view of an eye that looks along `forward`, with `up` upright on the screen as far as it can be.
/// Domain: lengths from 1e-25 to 1e25. Errors: ContractViolation for an `up` along `forward`.
template <class T>
View<T> view_along(const Eye<T>& eye, const glm::vec<3, T>& forward, const glm::vec<3, T>& up) {
  const glm::vec<3, T> right = glm::cross(forward, up);
  expects(right != glm::vec<3, T>(T{0}), "expected an upright that does not lie along the sight");
  return {eye, right, glm::cross(right, forward), forward};
}
/// The view of a distant eye.
/// towards: the direction to it.
template <class T>
View<T> distant_view(const glm::vec<3, T>& towards, const glm::vec<3, T>& up) {
  return view_along(Eye<T>(towards, T{0}), -towards, up);
}

/// The tests of Newell, Newell and Sancha in their order: the first that P passes says why it can't cover Q.
enum class Test {
  depths,    ///< P begins where Q has ended
  across,    ///< they lie side by side on the screen
  upright,   ///< one lies above the other on the screen
  behind,    ///< P lies behind the plane of Q, seen from the eye
  in_front,  ///< Q lies in front of the plane of P
  apart,     ///< an edge parts their projections
  failed     ///< all six: P may cover Q
};

/// The polygons are in order of their farthest corners.
template <class T>
struct Sorted {
  std::vector<Polygon<T>> order;  ///< the first is farthest
  std::size_t comparisons;
};

/// The first in the order is to be drawn if it covers no other.
template <class T>
struct Taken {
  Polygon<T> p;
  std::size_t others;
};

/// The one taken was held against another.
template <class T>
struct Compared {
  Polygon<T> p, q;
  Test passed;
  bool last;  ///< all that follow are nearer still
};

/// P may cover Q: Q goes before it.
template <class T>
struct Moved {
  Polygon<T> p, q;
};

/// Neither order is right: P's plane cuts a polygon.
template <class T>
struct Cut {
  Polygon<T> p, whole, in_front, behind;  ///< of P's plane, as it is oriented
};

/// A polygon's turn has come; it covers none that comes later.
template <class T>
struct Drawn {
  Polygon<T> polygon;
};

/// All are drawn.
struct Finished {};

// --- Orders on the screen

namespace detail {

inline int sign_of_depth(dvec3 forward, dvec3 p, dvec3 q) {
  // Rounding errs by less than 8u of the products, underflow by less than 2^-1000
  const dvec3 products = forward * (p - q), sizes = glm::abs(products);
  const double depth = products.x + products.y + products.z;
  const double bound = 0x1p-50 * (sizes.x + sizes.y + sizes.z) + 0x1p-1000;
  if (depth > bound) return 1;
  if (-depth > bound) return -1;
  SumOfProducts<2> sum;
  for (int i = 0; i < 3; ++i) {
    sum.add(forward[i], p[i]);
    sum.subtract(forward[i], q[i]);
  }
  return sum.sign();
}
inline int sign_about(dvec3 axis, const Eye<double>& eye, dvec3 p, dvec3 q) {
  using bsp_tree::detail::add_determinant;
  const dvec3 origin{0}, at(eye);
  const std::optional<int> sure = eye.w != 0 ? orient3d_filtered(origin, axis, p - at, q - at)
                                             : orient3d_filtered(origin, axis, at, p - q);
  if (sure) return *sure;
  SumOfProducts<3> sum;
  if (eye.w != 0) add_determinant(sum, false, axis, p, q);
  add_determinant(sum, false, axis, at, p);
  add_determinant(sum, true, axis, at, q);
  return sum.sign();
}

}  // namespace detail

/// Which of two points is deeper along `forward`, exactly: +1 p, -1 q, 0 neither.
inline int compare_depths(const glm::dvec3& forward, const glm::dvec3& p, const glm::dvec3& q) {
  return detail::sign_of_depth(forward, p, q);
}
inline int compare_depths(const glm::vec3& forward, const glm::vec3& p, const glm::vec3& q) {
  return detail::sign_of_depth(dvec3(forward), dvec3(p), dvec3(q));
}
template <class T>
int compare_depths(const glm::vec<3, T>& forward, const glm::vec<3, T>& p, const glm::vec<3, T>& q) {
  const T depth = glm::dot(forward, p - q);
  return (depth > T{0}) - (depth < T{0});
}

/// Which way a plane turns about the axis through the eye on the way from p to q, exactly: the sign of
/// det(axis, p - eye, q - eye). About the screen's upright it orders places from side to side.
inline int turn_about(const glm::dvec3& axis, const Eye<double>& eye, const glm::dvec3& p,
                      const glm::dvec3& q) {
  return detail::sign_about(axis, eye, p, q);
}
inline int turn_about(const glm::vec3& axis, const Eye<float>& eye, const glm::vec3& p, const glm::vec3& q) {
  return detail::sign_about(dvec3(axis), Eye<double>(eye), dvec3(p), dvec3(q));
}
template <class T>
int turn_about(const glm::vec<3, T>& axis, const Eye<T>& eye, const glm::vec<3, T>& p,
               const glm::vec<3, T>& q) {
  using Vec = glm::vec<3, T>;
  const T turn = glm::dot(axis, eye.w * glm::cross(p, q) + glm::cross(Vec(eye), p - q));
  return (turn > T{0}) - (turn < T{0});
}

/// Two corners between which all others lie in some order of the screen.
template <class T>
struct Extent {
  glm::vec<3, T> first, last;
};

/// order(p, q): -1 where p comes before q.
template <class T, class Order>
Extent<T> extent_of(const Polygon<T>& polygon, const Order& order) {
  Extent<T> extent{polygon.corners[0], polygon.corners[0]};
  for (std::size_t i = 1; i < polygon.corners.size(); ++i) {
    const auto& corner = polygon.corners[i];
    if (order(corner, extent.first) < 0)
      extent.first = corner;
    else if (order(corner, extent.last) > 0)
      extent.last = corner;
  }
  return extent;
}

// --- What the list holds

/// Whether a piece has corners on the eye's side of a plane, and whether it has some beyond it.
struct Beside {
  bool before = false, beyond = false;
};

/// On which side of a polygon's plane a part lies that it has cut off.
struct Known {
  std::size_t number;  ///< of the polygon in the input
  Beside lies;
};

/// A polygon, or a part of one, with what the tests ask for again and again.
template <class T>
struct Piece {
  Polygon<T> polygon;
  const Polygon<T>* whole;            ///< what it is a part of, in the input
  std::size_t number;                 ///< of that in the input
  int eye_side;                       ///< of its plane, 0 where the eye sees it edge-on
  Extent<T> depths, across, upright;  ///< from near to far, from side to side, up or down
  std::vector<Known> known{};         ///< of planes that have cut it
  bool moved = false;                 ///< since the list was sorted last

  Piece(Polygon<T> its_polygon, const Polygon<T>& its_whole, std::size_t its_number, const View<T>& view)
      : polygon(std::move(its_polygon)),
        whole(&its_whole),
        number(its_number),
        eye_side(bsp_tree::side_of_eye(polygon.plane, view.eye)),
        depths(extent_of(polygon,
                         [&](const auto& p, const auto& q) { return compare_depths(view.forward, p, q); })),
        across(extent_of(polygon,
                         [&](const auto& p, const auto& q) { return turn_about(view.up, view.eye, p, q); })),
        upright(extent_of(
            polygon, [&](const auto& p, const auto& q) { return turn_about(view.right, view.eye, p, q); })) {}
};

/// The farthest last, to be taken off.
template <class T>
using List = std::vector<Piece<T>>;

template <class T>
void expect_in_front(const Polygon<T>& polygon, const View<T>& view) {
  for (const auto& corner : polygon.corners) {
    expects(view.eye.w == T{0} || compare_depths(view.forward, corner, glm::vec<3, T>(view.eye)) > 0,
            "expected polygons in front of the eye, found a corner of {} beside or behind it", polygon.face);
  }
}

template <class T>
List<T> pieces_of(const std::vector<Polygon<T>>& polygons, const View<T>& view) {
  List<T> list;
  list.reserve(polygons.size());
  for (const Polygon<T>& polygon : polygons) {
    expect_in_front(polygon, view);
    list.emplace_back(polygon, polygon, list.size(), view);
  }
  return list;
}

/// Puts those with the farthest corners last; of equals the earlier one in the list comes later in it, and so
/// is drawn first the first time. Tells how many comparisons it took.
template <class T>
std::size_t sort(List<T>& list, const View<T>& view) {
  std::size_t comparisons = 0;
  std::ranges::stable_sort(list, [&](const Piece<T>& p, const Piece<T>& q) {
    ++comparisons;
    const int order = compare_depths(view.forward, p.depths.last, q.depths.last);
    return order != 0 ? order < 0 : p.number > q.number;
  });
  for (Piece<T>& piece : list) piece.moved = false;
  return comparisons;
}

/// What is reported of a list: the first to be drawn comes first.
template <class T>
std::vector<Polygon<T>> order_of(const List<T>& list) {
  std::vector<Polygon<T>> order;
  for (auto piece = list.rbegin(); piece != list.rend(); ++piece) order.push_back(piece->polygon);
  return order;
}

// --- The six tests

/// How corners lie to the plane of P, seen from the eye; what crosses it more than twice lies in it, but for
/// rounding. The plane of one that the eye sees edge-on has no sides.
template <class T>
Beside corners_beside(const Polygon<T>& polygon, const Piece<T>& p) {
  std::vector<int> sides = bsp_tree::sides(p.polygon.plane, polygon, bsp_tree::ExactSide{});
  std::erase(sides, 0);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) crossings += sides[i] != sides[(i + 1) % sides.size()];
  if (sides.empty() || crossings > 2 || p.eye_side == 0) return {};
  const bool first_before = sides[0] == p.eye_side;
  return {first_before || crossings > 0, !first_before || crossings > 0};
}

/// How Q lies to the plane of P. Parts lie in their own plane, on one side of each that has cut them, and on
/// that of their whole where it has but one, wherever rounding has put their corners: so no plane cuts one
/// twice.
template <class T>
Beside beside(const Piece<T>& q, const Piece<T>& p) {
  if (q.number == p.number) return {};
  for (const Known& known : q.known) {
    if (known.number == p.number) return known.lies;
  }
  const Beside whole = corners_beside(*q.whole, p);
  return q.known.empty() || !whole.before || !whole.beyond ? whole : corners_beside(q.polygon, p);
}

/// Whether two pieces have no inner place in common in an order of the screen.
template <class T, class Order>
bool part(const Extent<T>& p, const Extent<T>& q, const Order& order) {
  return order(p.last, q.first) <= 0 || order(q.last, p.first) <= 0;
}

/// Whether the plane through the eye and some edge of P has P on one side and Q on the other. P must lie on
/// its side: between corners that rounding has put together an edge may run anywhere.
template <class T>
bool edge_parts(const Piece<T>& p, const Piece<T>& q, const Eye<T>& eye) {
  const auto& corners = p.polygon.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto side = [&](const auto& c) {
      return p.eye_side * bsp_tree::side_of_eye(Plane<T>{a, b, c}, eye);
    };
    const auto inside = [&](const auto& c) { return side(c) > 0; };
    const auto within = [&](const auto& c) { return side(c) >= 0; };
    if (std::ranges::none_of(q.polygon.corners, inside) && std::ranges::all_of(corners, within) &&
        std::ranges::any_of(corners, inside))
      return true;
  }
  return false;
}

/// The first of the tests that shows that P can't cover Q, as drawn before it.
template <class T>
Test tested(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  const auto& [eye, right, up, forward] = view;
  // Q ends before P begins
  if (compare_depths(forward, p.depths.first, q.depths.last) >= 0) return Test::depths;
  // Extents on the screen
  const auto aside = [&](auto& a, auto& b) { return turn_about(up, eye, a, b); };
  if (part(p.across, q.across, aside)) return Test::across;
  const auto above = [&](auto& a, auto& b) { return turn_about(right, eye, a, b); };
  if (part(p.upright, q.upright, above)) return Test::upright;
  // Planes
  if (!beside(p, q).before) return Test::behind;
  if (!beside(q, p).beyond) return Test::in_front;
  // Projections
  if (edge_parts(p, q, eye)) return Test::apart;
  if (edge_parts(q, p, eye)) return Test::apart;
  return Test::failed;
}

/// Whether Q can't cover P: it lies behind its plane, or P in front of its own.
template <class T>
bool can_go_first(const Piece<T>& q, const Piece<T>& p) {
  return !beside(q, p).before || !beside(p, q).beyond;
}

// --- Moves and cuts

/// Whether no other is left to hold against P: Q may be covered, or all that follow are nearer still.
template <class T>
bool ends(Test test, const Piece<T>& q) {
  return test == Test::failed || (test == Test::depths && !q.moved);
}

/// Whether Q, if there is one, may be put before P: for the first time, and rightly.
template <class T>
bool moves(const List<T>& list, std::size_t q) {
  return q != none && !list[q].moved && can_go_first(list[q], list.back());
}

/// Puts a piece last in the list, where it is the next to be drawn.
template <class T>
void move_to_end(List<T>& list, std::size_t q) {
  list[q].moved = true;
  const auto at = list.begin() + static_cast<std::ptrdiff_t>(q);
  std::rotate(at, at + 1, list.end());
}

/// The first piece from Q on that the plane of the last one cuts; none if there is none.
template <class T>
std::size_t first_cut(const List<T>& list, std::size_t q) {
  for (; q < list.size() - 1; ++q) {
    const Beside lies = beside(list[q], list.back());
    if (lies.before && lies.beyond) return q;
  }
  return none;
}

/// The parts of a piece in front of the plane of P and behind it, as that is oriented.
template <class T>
std::array<Piece<T>, 2> parts_of(const Piece<T>& piece, const Piece<T>& p, const View<T>& view) {
  const auto on = bsp_tree::sides(p.polygon.plane, piece.polygon, bsp_tree::ExactSide{});
  const auto [in_front, behind] = bsp_tree::split(p.polygon.plane, piece.polygon, on);
  const auto part = [&](const Polygon<T>& polygon, bool before) {
    Piece<T> its{polygon, *piece.whole, piece.number, view};
    its.known = piece.known;
    its.known.push_back({p.number, {before, !before}});
    return its;
  };
  return {part(in_front, p.eye_side > 0), part(behind, p.eye_side < 0)};
}

/// Puts the two parts in place of a piece that the plane of the last one cuts.
template <class T>
bsp_tree::Parts<T> cut(List<T>& list, std::size_t r, const View<T>& view) {
  const auto parts = parts_of(list[r], list.back(), view);
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(r));
  list.insert(list.end(), parts.begin(), parts.end());
  return {parts[0].polygon, parts[1].polygon};
}

/// Draws a list as a BSP tree does, beyond a plane first, and asks for no overlaps: parts that overlap by
/// rounding alone can't mislead it.
template <class T, class Draw, class O>
void draw_by_planes(List<T> list, const View<T>& view, Draw&& draw, O&& observer) {
  if (list.empty()) return;
  // One that the eye does not see edge-on
  const auto seen = std::ranges::find_if(list, [](const Piece<T>& piece) { return piece.eye_side != 0; });
  if (seen != list.end()) std::iter_swap(seen, list.end() - 1);
  const Piece<T> p = list.back();
  List<T> beyond, within, before;
  for (const Piece<T>& q : list) {
    const Beside lies = beside(q, p);
    if (lies.before && lies.beyond) {
      const auto parts = parts_of(q, p, view);
      const bool front_before = p.eye_side > 0;
      before.push_back(parts[front_before ? 0 : 1]);
      beyond.push_back(parts[front_before ? 1 : 0]);
      if constexpr (observed<O>) observer(Cut<T>{p.polygon, q.polygon, parts[0].polygon, parts[1].polygon});
    } else {
      (lies.before ? before : lies.beyond ? beyond : within).push_back(q);
    }
  }
  draw_by_planes(std::move(beyond), view, draw, observer);
  for (const Piece<T>& q : within) {
    draw(q.polygon);
    if constexpr (observed<O>) observer(Drawn<T>{q.polygon});
  }
  draw_by_planes(std::move(before), view, draw, observer);
}

template <class T, class Draw, class O>
void draw_rest(List<T>& list, const View<T>& view, Draw&& draw, O&& observer) {
  draw_by_planes(std::exchange(list, {}), view, draw, observer);
}

// --- The methods

/// Gives polygons to `draw` in the order of their farthest corners, the farthest first.
/// Source: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem, ACM National
/// Conference 1972, 443-450: the order that their tests begin with.
///
/// polygons, view: as newell. draw(polygon): takes each polygon once.
///
/// Domain: as newell.
/// Steps: Sorted Drawn* Finished
/// Accuracy: depths are compared exactly. The picture is right where no two polygons overlap in depth and on
///   the screen; others may come in the wrong order.
/// Cost: n log n comparisons of a few ns, and some 200 ns a polygon before.
/// Errors: as newell.
template <class T, class Draw, Observer<Sorted<T>, Drawn<T>, Finished> O = Unobserved>
void farthest_vertex(const std::vector<Polygon<T>>& polygons, const View<T>& view, Draw&& draw,
                     O&& observer = {}) {
  // The farthest last
  auto list = pieces_of(polygons, view);
  const auto count = sort(list, view);
  if constexpr (observed<O>) observer(Sorted<T>{order_of(list), count});
  while (!list.empty()) {
    // No test: the next one is drawn
    const auto p = list.back().polygon;
    list.pop_back();
    draw(p);
    if constexpr (observed<O>) observer(Drawn<T>{p});
  }
  if constexpr (observed<O>) observer(Finished{});
}

/// Gives polygons to `draw` from back to front: none covers one that comes later. They are sorted by their
/// farthest corners. The farthest is drawn if one of six tests says of each that overlaps its depths that it
/// can't cover it; else that one goes first, or, if that has not helped, is cut.
/// Source: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem, ACM National
/// Conference 1972, 443-450; J. D. Foley et al., Computer Graphics, 2nd ed. 1990, 673-675.
///
/// polygons: convex, each in one plane, in any order. view: the eye, a point or infinitely far away, and the
///   screen. draw(polygon): takes each polygon, whole or in parts, once.
///
/// Domain: as bsp_tree::build: polygons may touch, pierce each other, overlap in a cycle and stand twice in
///   the list. For an eye at a point, all corners lie in front of it, at most 89 degrees from `forward`.
/// Steps: Sorted (Taken Compared* (Drawn | Moved | Cut Sorted))* (Taken Compared* Cut* Drawn*)? Finished, the
///   last Taken where rounding has closed a cycle.
/// Accuracy: on a ray that the eye sends through the insides of two drawn polygons, the later one does not
///   lie farther. All tests are exact; corners where a plane cuts are the nearest doubles, and no more than
///   what they are off may be in the wrong order. With a rational scalar nothing is.
/// Cost: at least n log n comparisons; n^2 tests where all overlap in depth; a test some 100 ns to 10 us.
///   It ends: a polygon moves at most once before one is drawn or cut, and no plane cuts a part twice.
///   Each plane of a cycle cuts one of it, else no way over it would lead back from one side to the other;
///   where rounding has made parts overlap that only touch, planes alone order the rest.
/// Errors: ContractViolation for corners that are not finite, or not in front of an eye at a point.
template <class T, class Draw,
          Observer<Sorted<T>, Taken<T>, Compared<T>, Moved<T>, Cut<T>, Drawn<T>, Finished> O = Unobserved>
void newell(const std::vector<Polygon<T>>& polygons, const View<T>& view, Draw&& draw, O&& observer = {}) {
  // The farthest last
  auto list = pieces_of(polygons, view);
  const auto count = sort(list, view);
  if constexpr (observed<O>) observer(Sorted<T>{order_of(list), count});
  while (!list.empty()) {
    const auto p = list.back();
    if constexpr (observed<O>) observer(Taken<T>{p.polygon, list.size() - 1});
    // Which Q may P cover?
    std::size_t covered = none;
    for (auto i = list.size() - 1; i-- > 0;) {
      const auto& q = list[i];
      const Test test = tested(p, q, view);
      if constexpr (observed<O>) observer(Compared<T>{p.polygon, q.polygon, test, ends(test, q)});
      if (test == Test::failed) covered = i;
      if (ends(test, q)) break;
    }
    const auto r = first_cut(list, covered);
    if (moves(list, covered)) {
      // Q goes first
      move_to_end(list, covered);
      if constexpr (observed<O>) observer(Moved<T>{p.polygon, list.back().polygon});
    } else if (r != none) {
      // P's plane cuts what it can't order
      const auto whole = list[r].polygon;
      const auto parts = cut(list, r, view);
      if constexpr (observed<O>) observer(Cut<T>{p.polygon, whole, parts.in_front, parts.behind});
      const auto again = sort(list, view);
      if constexpr (observed<O>) observer(Sorted<T>{order_of(list), again});
    } else if (covered != none) {
      // Rounding has closed a cycle
      draw_rest(list, view, draw, observer);
    } else {
      // P covers none
      list.pop_back();
      draw(p.polygon);
      if constexpr (observed<O>) observer(Drawn<T>{p.polygon});
    }
  }
  if constexpr (observed<O>) observer(Finished{});
}

}  // namespace gradus::painter
