#pragma once
// Visits an octree's cells from near to far or from far to near: at each cell, it compares the eye with the
// cell's centre, without looking at what the cells hold.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <ranges>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::octree_order {

/// A cube: its corner with the least coordinates and its side. Children are numbered by bits: 1 for the upper
/// half in x, 2 in y, 4 in z.
template <class T>
struct Cell {
  glm::vec<3, T> lower;
  T side;
  int depth = 0;  ///< of the root 0

  friend constexpr bool operator==(const Cell&, const Cell&) = default;
};

/// Where the eye is: a point, or at w = 0 the direction towards an eye that is infinitely far away.
template <class T>
using Eye = glm::vec<4, T>;

// --- Steps -------------------------------------------------------

/// A cell with children was reached; which child the eye is nearest to.
template <class T>
struct Entered {
  Cell<T> cell;
  int nearest;
};

/// A leaf's turn has come.
template <class T>
struct Visited {
  Cell<T> cell;
  std::int64_t number;  ///< from 1 on
};

/// All leaves were visited.
struct Finished {
  std::int64_t cells;     ///< leaves
  std::int64_t compared;  ///< coordinates of the eye with those of a middle
};

/// Counts both, and numbers the leaves.
struct Work {
  std::int64_t cells = 0, compared = 0;

  template <class T>
  Entered<T> operator()(const Entered<T>& step) {
    compared += 3;
    return step;
  }
  template <class T>
  Visited<T> operator()(const Visited<T>& step) {
    return {step.cell, ++cells};
  }
  Finished operator()(Finished) const { return {cells, compared}; }
};

// --- One cell ----------------------------------------------------

template <class T>
constexpr glm::vec<3, T> middle_of(const Cell<T>& cell) {
  return cell.lower + cell.side / T(2);
}

/// The child of a cell with this number.
template <class T>
constexpr Cell<T> child_of(const Cell<T>& cell, int number) {
  const T half = cell.side / T(2);
  Cell<T> child{cell.lower, half, cell.depth + 1};
  for (int axis = 0; axis < 3; ++axis) {
    if ((number >> axis & 1) != 0) child.lower[axis] += half;
  }
  return child;
}

/// The number of the child on the eye's side of all three planes through the middle. In a plane both sides
/// may come first: it counts as above.
template <class T>
constexpr int nearest_child(const Cell<T>& cell, const Eye<T>& eye) {
  const auto middle = middle_of(cell);
  int nearest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool above = eye[axis] >= eye.w * middle[axis];
    if (above) nearest |= 1 << axis;
  }
  return nearest;
}

/// Child k of an order is the nearest one with these bits the other way round: behind one plane, behind two,
/// behind all three.
inline constexpr std::array<int, 8> turned_bits{0, 1, 2, 4, 3, 5, 6, 7};

/// From the last to the first.
inline constexpr auto turned_back = std::views::reverse(turned_bits);

/// Deepest that cells may be cut.
inline constexpr int deepest = 48;

template <class T>
void expect_cube(const Cell<T>& root, const Eye<T>& eye) {
  expects(root.side > T(0), "expected a cell with a side above 0");
  expects(eye.w == T(0) || eye.w == T(1), "expected an eye with w = 0 or w = 1");
}

// --- The walks ---------------------------------------------------

/// What both walks have in common: where the eye is, and who is asked.
template <class T, class Split, class Visit>
struct Walk {
  const Eye<T>& eye;
  Split& split;
  Visit& visit;

  int nearest(const Cell<T>& cell) const { return nearest_child(cell, eye); }
  bool is_leaf(const Cell<T>& cell) { return cell.depth == deepest || !split(cell); }
};

template <class T, class Split, class Visit>
Walk(const Eye<T>&, Split&, Visit&) -> Walk<T, Split, Visit>;

/// The cells below one, near ones first.
template <class T, class Split, class Visit, class O>
void nearer_first(Walk<T, Split, Visit>& walk, const Cell<T>& cell, O& observer) {
  if (walk.is_leaf(cell)) {
    walk.visit(cell);
    if constexpr (observed<O>) observer(Visited<T>{cell, 0});
    return;
  }
  // The eye's side of three planes
  int near = walk.nearest(cell);
  if constexpr (observed<O>) observer(Entered<T>{cell, near});
  // 000, 001, 010, 100, 011, …, 111
  for (int bits : turned_bits) {
    const int k = near ^ bits;
    auto next = child_of(cell, k);
    nearer_first(walk, next, observer);
  }
}

/// The cells below one, far ones first.
template <class T, class Split, class Visit, class O>
void farther_first(Walk<T, Split, Visit>& walk, const Cell<T>& cell, O& observer) {
  if (walk.is_leaf(cell)) {
    walk.visit(cell);
    if constexpr (observed<O>) observer(Visited<T>{cell, 0});
    return;
  }
  // The eye's side of three planes
  int near = walk.nearest(cell);
  if constexpr (observed<O>) observer(Entered<T>{cell, near});
  // 111, 110, 101, 011, 100, …, 000
  for (int bits : turned_back) {
    const int k = near ^ bits;
    auto next = child_of(cell, k);
    farther_first(walk, next, observer);
  }
}

/// Visits an octree's leaves from front to back: no leaf hides one that was visited before it.
/// Source: L. J. Doctor, J. G. Torborg, Display techniques for octree-encoded objects, IEEE Computer Graphics
/// and Applications 1 (3), 1981.
///
/// root: a cube. eye: a point, also one inside, or a direction. split(cell) says whether a cell has children;
///   visit(cell) is called for every leaf.
///
/// Domain: finite; side > 0. Cells deeper than 48 are always leaves.
/// Steps: Entered and Visited in the order of the walk, Finished.
/// Accuracy: exact where middles are, as of any cube whose side is a power of two and whose lower corner is a
///   multiple of the least cell's; else the order is that for a plane within a rounding of the middle.
/// Cost: three comparisons per cell with children, for any contents; memory for the depth.
/// Errors: ContractViolation for a side of 0 or less, or a w beside 0 and 1.
template <class T, class Split, class Visit, Observer<Entered<T>, Visited<T>, Finished> O = Unobserved>
void front_to_back(const Cell<T>& root, const Eye<T>& eye, Split&& split, Visit&& visit, O&& observer = {}) {
  expect_cube(root, eye);
  Tally<O, Work> tally(observer);
  Walk walk{eye, split, visit};
  nearer_first(walk, root, tally);
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

/// Visits an octree's leaves from back to front, as a painter needs them: each may be drawn over all before
/// it.
///
/// root, eye, split, visit: as for front_to_back, whose order this is the other way round.
///
/// Domain, Steps, Accuracy, Cost, Errors: as for front_to_back.
template <class T, class Split, class Visit, Observer<Entered<T>, Visited<T>, Finished> O = Unobserved>
void back_to_front(const Cell<T>& root, const Eye<T>& eye, Split&& split, Visit&& visit, O&& observer = {}) {
  expect_cube(root, eye);
  Tally<O, Work> tally(observer);
  Walk walk{eye, split, visit};
  farther_first(walk, root, tally);
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
}

}  // namespace gradus::octree_order
