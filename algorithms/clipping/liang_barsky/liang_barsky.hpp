#pragma once
// The part of a segment that lies in a window, after Liang and Barsky: the segment is a + t (b - a), and each
// border allows the values of t on one side of the t at which the segment crosses it. What all borders allow
// is an interval, from the last entering to the first leaving; when it is empty nothing is left.

#include <compare>
#include <glm/vec2.hpp>
#include <optional>

#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::liang_barsky {

using Order = BorderOrder<2>;

// --- Steps -------------------------------------------------------

/// The line is written as a + t d, with t from 0 to 1.
template <class T>
struct Started {
  Segment<2, T> line;
  Rectangle<T> window;
  glm::vec<2, T> d;
};

/// How a border cuts the line.
enum class Crossing {
  inside,   ///< parallel, and not beyond the border
  outside,  ///< parallel, beyond it: nothing is left
  enters,   ///< comes in at t
  leaves    ///< goes out at t
};

/// A border allows the values with p t <= q.
template <class T>
struct Tested {
  Border border;
  T p, q;
  Crossing crossing;
  T t;             ///< q / p; 0 when parallel
  T enter, leave;  ///< what is allowed by now
};

/// The interval is not empty: this part lies in the window.
template <class T>
struct Accepted {
  Segment<2, T> line;
  T enter, leave;
};

/// The line leaves before it enters, or runs beside the window.
template <class T>
struct Rejected {
  T enter, leave;
};

// --- The taught method -------------------------------------------

/// The part of a segment that lies in a window, in four divisions at most.
/// Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM Transactions on Graphics 3(1),
/// 1984, 1-22.
///
/// T: float, double or gradus::Exact. line: any two points, in any units. window: its borders belong to it.
/// order: in which the borders are tested; the result is the same, but a line outside is found out sooner or
/// later.
///
/// Domain: finite coordinates whose differences don't overflow; beyond, the answer may be wrong.
///   correctly_rounded has no such limit. a == b is a point.
/// Steps: Started Tested+ (Accepted | Rejected), at most 4 Tested.
/// Accuracy: exact for Exact. In floating point a cut rounds five times, an end may come to lie beside the
///   border it was cut at, and lines that pass near a corner may be decided wrongly.
/// Cost: four divisions, and four products for the ends.
/// Errors: ContractViolation for coordinates that are not finite and windows that are inside out.
template <class T = double, Observer<Started<T>, Tested<T>, Accepted<T>, Rejected<T>> O = Unobserved>
std::optional<Segment<2, T>> parametric(Segment<2, T> line, const Rectangle<T>& window,
                                        const Order& order = usual_order<2>(), O&& observer = {}) {
  expect_clippable(line, window);
  const auto [a, b] = line;
  const auto d = b - a;
  T enter = T(0), leave = T(1);
  using enum Crossing;
  if constexpr (observed<O>) observer(Started<T>{line, window, d});
  for (const Border border : order) {
    // The border allows p t <= q
    const int axis = axis_of(border);
    const T c = coordinate(window, border);
    T p = d[axis], q = c - a[axis];
    if (!is_upper(border)) p = -p, q = -q;
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
    if constexpr (observed<O>) observer(Tested<T>{border, p, q, comes, t, enter, leave});
    // Nothing left: reject
    if (comes == outside || enter > leave) {
      if constexpr (observed<O>) observer(Rejected<T>{enter, leave});
      return std::nullopt;
    }
  }
  // Put both values into the line
  Segment<2, T> rest = line;
  if (enter > T(0)) rest.a = a + enter * d;
  if (leave < T(1)) rest.b = a + leave * d;
  if constexpr (observed<O>) observer(Accepted<T>{rest, enter, leave});
  return rest;
}

// --- The method without rounding errors --------------------------

/// How a border cuts a line, by comparisons alone.
template <int N, class T>
Crossing crossing_of(const Segment<N, T>& line, const AxisBox<N, T>& window, Border border) {
  const int axis = axis_of(border);
  const T a = line.a[axis], b = line.b[axis];
  if (a == b) return outside(line.a, window, border) ? Crossing::outside : Crossing::inside;
  return (a < b) == is_upper(border) ? Crossing::leaves : Crossing::enters;
}

/// The borders of the last entering and of the first leaving, as far as there are any between a and b.
struct Span {
  std::optional<Border> enter, leave;
};

/// A border was put in its place among those that the line comes to.
template <class T>
struct Ordered {
  Border border;
  Crossing crossing;
  bool beyond;  ///< the whole line lies beyond the border
  Span span;    ///< the last entering and the first leaving by now
};

/// The whole of a line lies beyond a border, or it comes to the first leaving before the last entering.
struct Missed {
  Span span;
};

/// Its ends were computed.
template <class T>
struct Kept {
  Segment<2, T> line;
  Span span;
};

/// What borders leave of a line: it is narrowed by one after the other.
template <int N, class T>
struct Narrowing {
  Segment<N, T> line;
  AxisBox<N, T> window;
  Span span{};

  /// The exact order in which the line comes to two borders.
  std::strong_ordering order_of(Border i, Border j) const {
    return compare_cuts(line, axis_of(i), coordinate(window, i), axis_of(j), coordinate(window, j));
  }

  /// Takes a border into account: whether any of the line can be left.
  bool by(Border border) {
    const Crossing crossing = crossing_of(line, window, border);
    if (crossing == Crossing::inside) return true;
    if (crossing == Crossing::outside) return false;
    const bool enters = crossing == Crossing::enters;
    // Nothing happens at a border that both ends are inside of; beyond it lies all, or the part at one end
    if (!outside(enters ? line.a : line.b, window, border)) return true;
    if (outside(enters ? line.b : line.a, window, border)) return false;
    auto& latest = enters ? span.enter : span.leave;
    const bool better = !latest || (enters ? order_of(border, *latest) > 0 : order_of(border, *latest) < 0);
    if (better) latest = border;
    return !span.enter || !span.leave || order_of(*span.enter, *span.leave) <= 0;
  }

  /// The line's points at the two borders, correctly rounded, or its ends where it has none.
  Segment<N, T> rest() const {
    const auto at = [&](Border border) {
      return cut_point(line, axis_of(border), coordinate(window, border));
    };
    return {span.enter ? at(*span.enter) : line.a, span.leave ? at(*span.leave) : line.b};
  }
};

/// The part of a segment that lies in a window, decided exactly, its ends correctly rounded: borders are
/// compared by the exact order in which the line comes to them, and no value of t is ever rounded.
///
/// line, window, order: as for parametric.
///
/// Domain: all finite coordinates, from the subnormals to the largest. Numbers that are 0 or of 2^-300 to
///   2^300 in size take fast arithmetic nearly always.
/// Steps: Started Ordered+ (Kept | Missed), at most 4 Ordered; Started.d is rounded.
/// Accuracy: as cohen_sutherland_2d::correctly_rounded, and the same bits: accepted exactly when segment and
///   window have a point in common, a border's coordinate copied, the other one 1/2 ulp.
/// Cost: comparisons, three orders of some 3 ns at most, some 15 ns for each end that is cut; in doubt 1 us.
/// Errors: as parametric.
template <class T = double, Observer<Started<T>, Ordered<T>, Kept<T>, Missed> O = Unobserved>
std::optional<Segment<2, T>> correctly_rounded(Segment<2, T> line, const Rectangle<T>& window,
                                               const Order& order = usual_order<2>(), O&& observer = {}) {
  expect_clippable(line, window);
  Narrowing<2, T> narrowing{line, window};
  if constexpr (observed<O>) observer(Started<T>{line, window, line.b - line.a});
  for (const Border border : order) {
    // The last entering, the first leaving
    bool left = narrowing.by(border);
    const auto& span = narrowing.span;
    if constexpr (observed<O>) observer(Ordered<T>{border, crossing_of(line, window, border), !left, span});
    // Nothing left: reject
    if (!left) {
      if constexpr (observed<O>) observer(Missed{span});
      return std::nullopt;
    }
  }
  // The points at those two borders
  Segment<2, T> rest = narrowing.rest();
  if constexpr (observed<O>) observer(Kept<T>{rest, narrowing.span});
  return rest;
}

}  // namespace gradus::liang_barsky
