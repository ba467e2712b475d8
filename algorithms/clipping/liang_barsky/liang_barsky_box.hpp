#pragma once
// Liang and Barsky's method in space: six faces in place of four borders, and the same two values of t, the
// last entering and the first leaving.

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
  const auto [a, b] = line;
  const auto d = b - a;
  T enter = T(0), leave = T(1);
  using enum Crossing;
  if constexpr (observed<O>) observer(BoxStarted<T>{line, box, d});
  for (const Border face : order) {
    // The face allows p t <= q
    const int axis = axis_of(face);
    const T c = coordinate(box, face);
    T p = d[axis], q = c - a[axis];
    if (!is_upper(face)) p = -p, q = -q;
    T t = T(0);
    auto comes = q < T(0) ? outside : inside;
    // The last entering, the first leaving
    if (p < T(0)) {
      t = q / p;
      comes = enters;
      if (t > enter) enter = t;
    } else if (p > T(0)) {
      t = q / p;
      comes = leaves;
      if (t < leave) leave = t;
    }
    if constexpr (observed<O>) observer(Tested<T>{face, p, q, comes, t, enter, leave});
    // Nothing left: reject
    if (comes == outside || enter > leave) {
      if constexpr (observed<O>) observer(Rejected<T>{enter, leave});
      return std::nullopt;
    }
  }
  // Put both values into the line
  Segment<3, T> rest = line;
  if (enter > T(0)) rest.a = a + enter * d;
  if (leave < T(1)) rest.b = a + leave * d;
  if constexpr (observed<O>) observer(BoxAccepted<T>{rest, enter, leave});
  return rest;
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
/// and
///   box have a point in common, a face's coordinate copied, the others 1/2 ulp.
/// Cost: comparisons, five orders of some 3 ns at most, some 30 ns for each end that is cut; in doubt some
/// us. Errors: as box_parametric.
template <class T = double, Observer<BoxStarted<T>, Ordered<T>, BoxKept<T>, Missed> O = Unobserved>
std::optional<Segment<3, T>> box_correctly_rounded(Segment<3, T> line, const AxisBox<3, T>& box,
                                                   const BoxOrder& order = usual_order<3>(),
                                                   O&& observer = {}) {
  expect_clippable(line, box);
  Narrowing<3, T> narrowing{line, box};
  if constexpr (observed<O>) observer(BoxStarted<T>{line, box, line.b - line.a});
  for (const Border face : order) {
    // The last entering, the first leaving
    bool left = narrowing.by(face);
    const auto& span = narrowing.span;
    if constexpr (observed<O>) observer(Ordered<T>{face, crossing_of(line, box, face), !left, span});
    // Nothing left: reject
    if (!left) {
      if constexpr (observed<O>) observer(Missed{span});
      return std::nullopt;
    }
  }
  // The points at those two faces
  Segment<3, T> rest = narrowing.rest();
  if constexpr (observed<O>) observer(BoxKept<T>{rest, narrowing.span});
  return rest;
}

}  // namespace gradus::liang_barsky
