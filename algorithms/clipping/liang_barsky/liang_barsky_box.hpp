#pragma once
// Liang and Barsky's method in space: six faces in place of four borders, and the same two values of t, the
// last entering and the first leaving.

#include <algorithm>
#include <glm/vec3.hpp>
#include <optional>

#include "clipping/liang_barsky/liang_barsky.hpp"
#include "core/axis_cut.hpp"
#include "core/observe.hpp"

namespace gradus::liang_barsky {

using BoxOrder = BorderOrder<3>;

// --- Steps: Tested, Rejected, Ordered and Missed are those of the rectangle ------

/// The line is written as a + t d, with t from 0 to 1.
template <class T>
struct BoxStarted {
  Segment<3, T> line;
  AxisBox<3, T> box;
  glm::vec<3, T> d;
};

/// The interval is not empty: this part lies in the box.
template <class T>
struct BoxAccepted {
  Segment<3, T> line;
  T enter, leave;
};

/// Its ends were computed.
template <class T>
struct BoxKept {
  Segment<3, T> line;
  Span span;
};

// --- The taught method -------------------------------------------

/// The part of a segment that lies in a box, in six divisions at most.
/// Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM Transactions on Graphics 3(1),
/// 1984, 1-22, on three dimensions.
///
/// T: float, double or gradus::Exact. line: any two points, in any units. box: its faces belong to it; it may
/// be flat. order: in which the faces are tested; the result is the same, but a line outside is found out
/// sooner or later.
///
/// Domain: finite coordinates whose differences don't overflow; beyond, the answer may be wrong.
///   box_correctly_rounded has no such limit. a == b is a point.
/// Steps: BoxStarted Tested+ (BoxAccepted | Rejected), at most 6 Tested.
/// Accuracy: exact for Exact. In floating point a cut rounds five times, an end may come to lie beside the
///   face it was cut at, and lines that pass near an edge may be decided wrongly.
/// Cost: six divisions, and six products for the ends.
/// Errors: ContractViolation for coordinates that are not finite and boxes that are inside out.
template <class T = double, Observer<BoxStarted<T>, Tested<T>, BoxAccepted<T>, Rejected<T>> O = Unobserved>
std::optional<Segment<3, T>> box_parametric(Segment<3, T> line, const AxisBox<3, T>& box,
                                            const BoxOrder& order = usual_order<3>(), O&& observer = {}) {
  expect_clippable(line, box);
  auto [a, b] = line;
  auto d = b - a;
  T enter = 0, leave = 1;
  if constexpr (observed<O>) observer(BoxStarted<T>{line, box, d});
  for (Border face : order) {
    // The face allows p t <= q
    int axis = axis_of(face);
    T c = coordinate(box, face);
    T out = outward(face);
    T p = out * d[axis];
    T q = out * (c - a[axis]);
    bool beyond = false;
    if (p < 0) {
      // Entering: the last t counts
      const T t = q / p;
      enter = std::max(enter, t);
      if constexpr (observed<O>) observer(tested(face, p, q, enter, leave));
    } else if (p > 0) {
      // Leaving: the first t counts
      const T t = q / p;
      leave = std::min(leave, t);
      if constexpr (observed<O>) observer(tested(face, p, q, enter, leave));
    } else {
      // Parallel: beyond the face?
      beyond = q < 0;
      if constexpr (observed<O>) observer(tested(face, p, q, enter, leave));
    }
    // Nothing left: reject
    if (beyond || enter > leave) {
      if constexpr (observed<O>) observer(Rejected<T>{enter, leave});
      return std::nullopt;
    }
  }
  // Both values of t into the line
  line = part(line, enter, leave);
  if constexpr (observed<O>) observer(BoxAccepted<T>{line, enter, leave});
  return line;
}

// --- The method without rounding errors --------------------------

/// The part of a segment that lies in a box, decided exactly, its ends correctly rounded: faces are compared
/// by the exact order in which the line comes to them, and no value of t is ever rounded.
///
/// line, box, order: as for box_parametric.
///
/// Domain: all finite coordinates, from the subnormals to the largest. Numbers that are 0 or of 2^-300 to
///   2^300 in size take fast arithmetic nearly always.
/// Steps: BoxStarted Ordered+ (BoxKept | Missed), at most 6 Ordered; BoxStarted.d is rounded.
/// Accuracy: as cohen_sutherland_3d::correctly_rounded, and the same numbers: accepted exactly when segment
///   and box have a point in common, a face's coordinate copied, the others 1/2 ulp.
/// Cost: comparisons, nine orders of some 3 ns at most, some 30 ns for each end that is cut; in doubt 1 us.
/// Errors: as box_parametric.
template <class T = double, Observer<BoxStarted<T>, Ordered<T>, BoxKept<T>, Missed> O = Unobserved>
std::optional<Segment<3, T>> box_correctly_rounded(Segment<3, T> line, const AxisBox<3, T>& box,
                                                   const BoxOrder& order = usual_order<3>(),
                                                   O&& observer = {}) {
  expect_clippable(line, box);
  const Cuts cuts{line, box};
  if constexpr (observed<O>) observer(BoxStarted<T>{line, box, line.b - line.a});
  auto enter = cuts.start();
  auto leave = cuts.end();
  for (Border face : order) {
    // Which ends lie beyond it?
    auto [a, b] = cuts.ends(face);
    bool beyond = a && b;
    auto t = cuts.at(face);
    if (a && !b) {
      // Entering: the last t counts
      if (t > enter) enter = t;
    } else if (b && !a) {
      // Leaving: the first t counts
      if (t < leave) leave = t;
    }
    if constexpr (observed<O>) observer(ordered(face, beyond, enter, leave));
    // Nothing left: reject
    if (beyond || enter > leave) {
      if constexpr (observed<O>) observer(Missed{span_of(enter, leave)});
      return std::nullopt;
    }
  }
  // The points at those two cuts
  line = {enter.at(), leave.at()};
  if constexpr (observed<O>) observer(BoxKept<T>{line, span_of(enter, leave)});
  return line;
}

}  // namespace gradus::liang_barsky
