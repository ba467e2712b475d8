#pragma once
// What the painter's list holds: polygons and their parts as an eye sees them, in exact orders of depth and
// of places on the screen, and on which side of each other's planes they lie.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/merge_sort.hpp"
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

// --- Orders on the screen

namespace detail {

inline int sign_of_depth(dvec3 forward, dvec3 p, dvec3 q) {
  // Rounding errs by less than 8u of the products, underflow by less than 2^-1000
  const dvec3 products = forward * (p - q), sizes = glm::abs(products);
  const double depth = products.x + products.y + products.z;
  const double bound = 0x1p-50 * (sizes.x + sizes.y + sizes.z) + 0x1p-1000;
  if (depth > bound) return 1;
  if (-depth > bound) return -1;
  if (p == q) return 0;
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
  if (p == q) return 0;
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
  bool moved = false;                 ///< last in the list, where it does not belong

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

/// Whether P belongs before Q in a list: its farthest corner is nearer. Of equals the earlier one in the
/// input comes later, and so is drawn first the first time.
template <class T>
bool belongs_before(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  const int order = compare_depths(view.forward, p.depths.last, q.depths.last);
  return order != 0 ? order < 0 : p.number > q.number;
}

/// Puts those with the farthest corners last. Tells how many comparisons it took.
template <class T>
std::size_t sort(List<T>& list, const View<T>& view) {
  return merge_sort(list, [&](const Piece<T>& p, const Piece<T>& q) { return belongs_before(p, q, view); });
}

/// How many comparisons sorting them takes, as above or by something else.
template <class T, class... By>
std::size_t comparisons(const std::vector<Polygon<T>>& polygons, const View<T>& view, const By&... by) {
  auto list = pieces_of(polygons, view);
  if constexpr (sizeof...(By) == 0)
    return sort(list, view);
  else
    return sort_by(list, by...);
}

/// Moves a piece to another place in the list; those between make room.
template <class T>
void move_piece(List<T>& list, std::size_t from, std::size_t to) {
  const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
  Piece<T> piece = std::move(list[from]);
  if (to < from)
    std::move_backward(at(to), at(from), at(from + 1));
  else
    std::move(at(from + 1), at(to + 1), at(from));
  list[to] = std::move(piece);
}

/// A piece has been put where it belongs.
template <class T>
struct Place {
  Polygon<T> polygon;
  std::size_t before;  ///< so many of those in the list by now are drawn before it
};

/// Puts the moved pieces, which are the last ones, back where they belong among those before them, one by
/// one. Equal ones keep their order. Tells their places to who asks for a report. Cost: a comparison and a
/// move for each place that one is away.
template <bool reported = false, class T>
std::vector<Place<T>> put_back(List<T>& list, const View<T>& view) {
  std::size_t next = list.size();
  while (next > 0 && list[next - 1].moved) --next;
  std::vector<Place<T>> places;
  for (; next < list.size(); ++next) {
    std::size_t place = next;
    while (place > 0 && belongs_before(list[next], list[place - 1], view)) --place;
    list[next].moved = false;
    if constexpr (reported) places.push_back({list[next].polygon, next - place});
    move_piece(list, next, place);
  }
  return places;
}

/// What is reported of a list: the first to be drawn comes first.
template <class T>
std::vector<Polygon<T>> order_of(const List<T>& list) {
  std::vector<Polygon<T>> order;
  for (auto piece = list.rbegin(); piece != list.rend(); ++piece) order.push_back(piece->polygon);
  return order;
}

// --- Sides and parts

/// How corners lie to the plane of P, seen from the eye. The plane of one that the eye sees edge-on has no
/// sides.
template <class T>
Beside corners_beside(const Polygon<T>& polygon, const Piece<T>& p) {
  if (p.eye_side == 0) return {};
  const Side at = bsp_tree::side_of_polygon(p.polygon.plane, polygon, bsp_tree::ExactSide{});
  const Side before = p.eye_side > 0 ? Side::in_front : Side::behind;
  const Side beyond = p.eye_side > 0 ? Side::behind : Side::in_front;
  return {at == Side::both || at == before, at == Side::both || at == beyond};
}

/// How Q lies to P where each lies in the plane of the other: as if they were stacked, the first in the input
/// nearest to the eye, so that it is drawn last.
template <class T>
Beside stacked(const Piece<T>& q, const Piece<T>& p) {
  const Beside other = corners_beside(*p.whole, q);
  if (p.eye_side == 0 || q.eye_side == 0 || other.before || other.beyond) return {};
  const bool first = q.number < p.number;
  return {first, !first};
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
  if (!whole.before && !whole.beyond) return stacked(q, p);
  return q.known.empty() || !whole.before || !whole.beyond ? whole : corners_beside(q.polygon, p);
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

}  // namespace gradus::painter
