#pragma once
// The part of a segment that lies in a window, after Liang and Barsky: the segment is a + t (b - a), and each
// border allows the values of t on one side of the t at which the segment crosses it. What all borders allow
// is an interval, from the last entering to the first leaving; when it is empty nothing is left.

#include <algorithm>
#include <compare>
#include <cstdint>
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

/// Which way along its axis a border faces: -1 a lower one, 1 an upper one.
constexpr std::int8_t outward(Border border) { return is_upper(border) ? 1 : -1; }

/// What the step says of a border that allows the values with p t <= q.
template <class T>
Tested<T> tested(Border border, T p, T q, T enter, T leave) {
  using enum Crossing;
  if (p == 0) return {border, p, q, q < 0 ? outside : inside, T(0), enter, leave};
  return {border, p, q, p < 0 ? enters : leaves, q / p, enter, leave};
}

/// The part of a segment a + t d from t = enter to t = leave; ends that are not cut are copied.
template <int N, class T>
Segment<N, T> part(const Segment<N, T>& line, T enter, T leave) {
  const auto d = line.b - line.a;
  return {enter > 0 ? line.a + enter * d : line.a, leave < 1 ? line.a + leave * d : line.b};
}

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
  auto [a, b] = line;
  auto d = b - a;
  T enter = 0, leave = 1;
  if constexpr (observed<O>) observer(Started<T>{line, window, d});
  for (Border edge : order) {
    // The border allows p t <= q
    int axis = axis_of(edge);
    T c = coordinate(window, edge);
    T out = outward(edge);
    T p = out * d[axis];
    T q = out * (c - a[axis]);
    bool beyond = false;
    if (p < 0) {
      // Entering: the last t counts
      const T t = q / p;
      enter = std::max(enter, t);
      if constexpr (observed<O>) observer(tested(edge, p, q, enter, leave));
    } else if (p > 0) {
      // Leaving: the first t counts
      const T t = q / p;
      leave = std::min(leave, t);
      if constexpr (observed<O>) observer(tested(edge, p, q, enter, leave));
    } else {
      // Parallel: beyond or not?
      beyond = q < 0;
      if constexpr (observed<O>) observer(tested(edge, p, q, enter, leave));
    }
    // Nothing left: reject
    if (beyond || enter > leave) {
      if constexpr (observed<O>) observer(Rejected<T>{enter, leave});
      return std::nullopt;
    }
  }
  // Both values of t into the line
  line = part(line, enter, leave);
  if constexpr (observed<O>) observer(Accepted<T>{line, enter, leave});
  return line;
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

  Narrowing(const Segment<N, T>& given, const AxisBox<N, T>& box) : line(given), window(box) {}

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

  /// The line's points at the two borders, correctly rounded, or its ends where there are none.
  Segment<N, T> rest() const {
    const auto at = [&](Border border) {
      return cut_point(line, axis_of(border), coordinate(window, border));
    };
    return {span.enter ? at(*span.enter) : line.a, span.leave ? at(*span.leave) : line.b};
  }
};

/// What the step says of a border.
template <class T, int N>
Ordered<T> ordered(Border border, const Narrowing<N, T>& allowed, bool beyond) {
  return {border, crossing_of(allowed.line, allowed.window, border), beyond, allowed.span};
}

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
  Narrowing allowed(line, window);
  if constexpr (observed<O>) observer(Started<T>{line, window, line.b - line.a});
  for (Border border : order) {
    // Last entering, first leaving
    bool left = allowed.by(border);
    if constexpr (observed<O>) observer(ordered<T>(border, allowed, !left));
    // Nothing left: reject
    if (!left) {
      if constexpr (observed<O>) observer(Missed{allowed.span});
      return std::nullopt;
    }
  }
  // The points at those two borders
  line = allowed.rest();
  if constexpr (observed<O>) observer(Kept<T>{line, allowed.span});
  return line;
}

}  // namespace gradus::liang_barsky
