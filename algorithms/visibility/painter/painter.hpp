#pragma once
// The painter's algorithm: polygons from back to front, each painted over what is there; sorted by depth, or,
// after Newell, Newell and Sancha, moved and cut until none covers what comes later.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <utility>
#include <vector>

#include "core/observe.hpp"
#include "visibility/painter/painter_list.hpp"

namespace gradus::painter {

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

/// The parts, and what had moved before, are where their farthest corners belong.
template <class T>
struct Inserted {
  std::vector<Place<T>> places;
};

/// A polygon's turn has come; it covers none that comes later.
template <class T>
struct Drawn {
  Polygon<T> polygon;
};

/// All are drawn.
struct Finished {};

// --- Moves and cuts

/// Whether Q can't cover P: it lies behind its plane, or P in front of its own.
template <class T>
bool can_go_first(const Piece<T>& q, const Piece<T>& p) {
  return !beside(q, p).before || !beside(p, q).beyond;
}

/// Whether P may cover Q.
constexpr bool failed(Test test) { return test == Test::failed; }

/// Whether no other is left to hold against P: Q may be covered, or all that follow are nearer still.
template <class T>
bool ends(Test test, const Piece<T>& q) {
  return failed(test) || (test == Test::depths && !q.moved);
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
  move_piece(list, q, list.size() - 1);
}

/// Whose plane cuts whom; none where nothing is cut.
struct Crossing {
  std::size_t plane = none, piece = none;
};

/// Where Q can't move: the first piece of a cycle, from Q on, that a plane of it cuts. Without rounding it is
/// that of the last one, P; parts that overlap by rounding alone may need another, from a few before it.
template <class T>
Crossing first_cut(const List<T>& list, std::size_t q) {
  if (q == none || moves(list, q)) return {};
  constexpr std::size_t few = 8;
  const std::size_t last = list.size(), first = std::max(q, last - std::min(few, last));
  for (std::size_t plane = last; plane-- > first;) {
    for (std::size_t piece = q; piece < last; ++piece) {
      const Beside lies = beside(list[piece], list[plane]);
      if (lies.before && lies.beyond) return {plane, piece};
    }
  }
  return {};
}

/// Puts the two parts of a piece that a plane cuts last in the list, in its place.
template <class T>
void cut(List<T>& list, const Crossing& at, const View<T>& view) {
  auto parts = parts_of(list[at.piece], list[at.plane], view);
  for (Piece<T>& part : parts) part.moved = true;
  list.erase(list.begin() + static_cast<std::ptrdiff_t>(at.piece));
  list.insert(list.end(), parts.begin(), parts.end());
}

/// What is reported of that, before.
template <class T>
Cut<T> cut_of(const List<T>& list, const Crossing& at, const View<T>& view) {
  const auto parts = parts_of(list[at.piece], list[at.plane], view);
  return {list[at.plane].polygon, list[at.piece].polygon, parts[0].polygon, parts[1].polygon};
}

/// Puts them back where they belong, and reports that.
template <class T, class O>
void put_back(List<T>& list, const View<T>& view, O& observer) {
  const auto back = put_back<observed<O>>(list, view);
  if constexpr (observed<O>) observer(Inserted<T>{back});
}

/// A list to be drawn by planes, or, of `ready` ones, as it stands.
template <class T>
struct Rest {
  List<T> list;
  bool ready = false;
};

/// The plane of a list that has not been parted: of one that the eye does not see edge-on, where there is
/// one.
template <class T>
Piece<T> parting_piece(List<T>& list) {
  const auto seen = std::ranges::find_if(list, [](const Piece<T>& piece) { return piece.eye_side != 0; });
  if (seen != list.end()) std::iter_swap(seen, list.end() - 1);
  return list.back();
}

/// Draws a list as a BSP tree does, beyond a plane first, and asks for no overlaps: parts that overlap by
/// rounding alone can't mislead it. Who draws and limits the work may ask how many pieces a plane parts.
template <class T, class Draw, class O>
[[gnu::noinline]] void draw_by_planes(List<T> list, const View<T>& view, Draw&& draw, O&& observer) {
  std::vector<Rest<T>> rest{{std::move(list)}};
  while (!rest.empty()) {
    Rest<T> next = bsp_tree::pop(rest);
    if (next.ready) {
      for (const Piece<T>& q : next.list) {
        draw(q.polygon);
        if constexpr (observed<O>) observer(Drawn<T>{q.polygon});
      }
      continue;
    }
    if (next.list.empty()) continue;
    if constexpr (requires { draw.parts(next.list.size()); }) draw.parts(next.list.size());
    const Piece<T> p = parting_piece(next.list);
    List<T> beyond, within, before;
    for (Piece<T>& q : next.list) {
      const Beside lies = beside(q, p);
      if (lies.before && lies.beyond) {
        const auto parts = parts_of(q, p, view);
        const bool front_before = p.eye_side > 0;
        before.push_back(parts[front_before ? 0 : 1]);
        beyond.push_back(parts[front_before ? 1 : 0]);
        if constexpr (observed<O>) observer(Cut<T>{p.polygon, q.polygon, parts[0].polygon, parts[1].polygon});
      } else {
        (lies.before ? before : lies.beyond ? beyond : within).push_back(std::move(q));
      }
    }
    // What lies beyond is taken first
    rest.push_back({std::move(before)});
    rest.push_back({std::move(within), true});
    rest.push_back({std::move(beyond)});
  }
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
/// all, view: as newell. draw(polygon): takes each polygon once.
///
/// Domain: as newell.
/// Steps: Sorted Drawn* Finished
/// Accuracy: depths are compared exactly. The picture is right where no two polygons overlap in depth and on
///   the screen; others may come in the wrong order.
/// Cost: n log n comparisons of a few ns, and some 200 ns per polygon before.
/// Errors: as newell.
template <class T, class Draw, Observer<Sorted<T>, Drawn<T>, Finished> O = Unobserved>
void farthest_vertex(const std::vector<Polygon<T>>& all, const View<T>& view, Draw&& draw,
                     O&& observer = {}) {
  // The farthest last
  auto list = pieces_of(all, view);
  sort(list, view);
  if constexpr (observed<O>) observer(Sorted<T>{order_of(list), comparisons(all, view)});
  while (!list.empty()) {
    // No test: the next is drawn
    auto p = list.back().polygon;
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
/// all: polygons, convex, each in one plane, in any order. view: the eye, a point or infinitely far away, and
/// the
///   screen. draw(polygon): takes each polygon, whole or in parts, once.
///
/// Domain: as bsp_tree::build: polygons may touch, pierce each other, overlap in a cycle and stand twice in
///   the list. For an eye at a point, all corners lie in front of it, at most 89 degrees from `forward`.
/// Steps: Sorted (Taken Compared* (Drawn | Moved | Cut Inserted))* (Taken Compared* Cut* Drawn*)? Finished,
///   the last Taken where rounding has closed a cycle.
/// Accuracy: on a ray that the eye sends through the insides of two drawn polygons, the later one does not
///   lie farther. All tests are exact; corners where a plane cuts are the nearest doubles, and no more than
///   what they are off may be in the wrong order. With a rational scalar nothing is.
/// Cost: at least n log n comparisons; n^2 tests where all overlap in depth; a test some 50 ns to 10 us.
///   A part is compared with those on its way to where it belongs.
///   It ends: a polygon moves at most once before one is drawn or cut, and no plane cuts a part twice.
///   Each plane of a cycle cuts one of it, else no way over it would lead back from one side to the other;
///   where rounding has made parts overlap that only touch, planes alone order the rest.
/// Errors: ContractViolation for corners that are not finite, or not in front of an eye at a point.
template <class T, class Draw,
          Observer<Sorted<T>, Taken<T>, Compared<T>, Moved<T>, Cut<T>, Inserted<T>, Drawn<T>, Finished> O =
              Unobserved>
void newell(const std::vector<Polygon<T>>& all, const View<T>& view, Draw&& draw, O&& observer = {}) {
  // The farthest last
  auto list = pieces_of(all, view);
  sort(list, view);
  if constexpr (observed<O>) observer(Sorted<T>{order_of(list), comparisons(all, view)});
  while (!list.empty()) {
    const auto p = list.back();
    if constexpr (observed<O>) observer(Taken<T>{p.polygon, list.size() - 1});
    // Which Q may P cover?
    auto q = covered(list, view, observer);
    auto at = first_cut(list, q);
    if (moves(list, q)) {
      // Q goes first
      move_to_end(list, q);
      if constexpr (observed<O>) observer(Moved<T>{p.polygon, list.back().polygon});
    } else if (at.plane != none) {
      // No order will do: a cut
      if constexpr (observed<O>) observer(cut_of(list, at, view));
      cut(list, at, view);
      put_back(list, view, observer);
    } else if (q != none) {
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

/// The numbers of the list before the last one, from the last to the first.
template <class T>
auto before_last(const List<T>& list) {
  return std::views::iota(std::size_t{0}, list.size() - 1) | std::views::reverse;
}

/// Of those that P, the last in the list, may cover: the one that is to be drawn before it; none where it
/// covers none.
template <class T, class O>
std::size_t covered(const List<T>& list, const View<T>& view, O& observer) {
  const auto& p = list.back();
  auto found = none;
  for (auto i : before_last(list)) {
    const auto& q = list[i];
    auto test = tested(p, q, view);
    if constexpr (observed<O>) observer(Compared<T>{p.polygon, q.polygon, test, ends(test, q)});
    if (failed(test)) found = i;
    if (ends(test, q)) break;
  }
  return found;
}

// --- The six tests

/// Whether two pieces have no inner place in common in an order of the screen.
template <class T, class Order>
bool part(const Extent<T>& p, const Extent<T>& q, const Order& order) {
  return order(p.last, q.first) <= 0 || order(q.last, p.first) <= 0;
}

/// Whether Q ends where P begins, or before.
template <class T>
bool past(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  return compare_depths(view.forward, p.depths.first, q.depths.last) >= 0;
}

/// Whether they lie side by side on the screen; whether one lies above the other.
template <class T>
bool aside(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  return part(p.across, q.across, [&](auto& a, auto& b) { return turn_about(view.up, view.eye, a, b); });
}
template <class T>
bool over(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  return part(p.upright, q.upright, [&](auto& a, auto& b) { return turn_about(view.right, view.eye, a, b); });
}

/// Whether P lies beyond the plane of Q, seen from the eye; whether Q lies before that of P.
template <class T>
bool beyond(const Piece<T>& p, const Piece<T>& q) {
  return !beside(p, q).before;
}
template <class T>
bool before(const Piece<T>& q, const Piece<T>& p) {
  return !beside(q, p).beyond;
}

/// Whether the plane through the eye and some edge of P has P on one side and Q on the other. P must lie on
/// its side: between corners that rounding has put together an edge may run anywhere.
template <class T>
bool parted(const Piece<T>& p, const Piece<T>& q, const View<T>& view) {
  const auto& corners = p.polygon.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const auto side = [&](const auto& c) {
      if (c == a || c == b) return 0;  // an end of the edge
      return p.eye_side * bsp_tree::side_of_eye(Plane<T>{a, b, c}, view.eye);
    };
    const auto inside = [&](const auto& c) { return side(c) > 0; };
    const auto within = [&](const auto& c) { return side(c) >= 0; };
    if (std::ranges::none_of(q.polygon.corners, inside) && std::ranges::all_of(corners, within) &&
        std::ranges::any_of(corners, inside))
      return true;
  }
  return false;
}

/// The first of the tests that shows that P can't cover Q, as drawn before it. s: the view.
template <class T>
Test tested(const Piece<T>& p, const Piece<T>& q, const View<T>& s) {
  using enum Test;
  // Q ends before P begins
  if (past(p, q, s)) return depths;
  // Extents on the screen
  if (aside(p, q, s)) return across;
  if (over(p, q, s)) return upright;
  // Planes
  if (beyond(p, q)) return behind;
  if (before(q, p)) return in_front;
  // Projections
  if (parted(p, q, s)) return apart;
  if (parted(q, p, s)) return apart;
  return failed;
}

}  // namespace gradus::painter
