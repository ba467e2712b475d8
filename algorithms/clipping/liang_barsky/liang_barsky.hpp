#pragma once
// The part of a segment that lies in a window, after Liang and Barsky: the segment is a + t (b - a), and each
// border allows the values of t on one side of the t at which the segment crosses it. What all borders allow
// is an interval, from the last entering to the first leaving; when it is empty nothing is left.

#include <algorithm>
#include <compare>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <utility>

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

/// The t at which a line comes to a border, or that of one of its ends: compared exactly, though no value of
/// it is ever computed.
template <int N, class T>
struct Cut {
  enum class Place { start, crossing, end };

  const Segment<N, T>* line;
  const AxisBox<N, T>* window;
  Place place;
  Border border{};

  friend std::strong_ordering operator<=>(const Cut& i, const Cut& j) {
    if (i.place != Place::crossing || j.place != Place::crossing) return i.place <=> j.place;
    return compare_cuts(*i.line, axis_of(i.border), coordinate(*i.window, i.border), axis_of(j.border),
                        coordinate(*i.window, j.border));
  }

  /// The line's point there, correctly rounded.
  glm::vec<N, T> at() const {
    if (place == Place::crossing) return cut_point(*line, axis_of(border), coordinate(*window, border));
    return place == Place::start ? line->a : line->b;
  }
};

/// The cuts of a line with a window's borders. Holds references.
template <int N, class T>
struct Cuts {
  const Segment<N, T>& line;
  const AxisBox<N, T>& window;

  Cut<N, T> start() const { return {&line, &window, Cut<N, T>::Place::start}; }
  Cut<N, T> end() const { return {&line, &window, Cut<N, T>::Place::end}; }
  Cut<N, T> at(Border border) const { return {&line, &window, Cut<N, T>::Place::crossing, border}; }
  /// Whether a lies beyond the border, and whether b does.
  std::pair<bool, bool> ends(Border border) const {
    return {outside(line.a, window, border), outside(line.b, window, border)};
  }
};
template <int N, class T>
Cuts(const Segment<N, T>&, const AxisBox<N, T>&) -> Cuts<N, T>;

/// What the steps say of the last entering and the first leaving.
template <int N, class T>
Span span_of(const Cut<N, T>& enter, const Cut<N, T>& leave) {
  const auto border = [](const Cut<N, T>& cut) {
    return cut.place == Cut<N, T>::Place::crossing ? std::optional(cut.border) : std::nullopt;
  };
  return {border(enter), border(leave)};
}

/// What the step says of a border.
template <int N, class T>
Ordered<T> ordered(Border border, bool beyond, const Cut<N, T>& enter, const Cut<N, T>& leave) {
  return {border, crossing_of(*enter.line, *enter.window, border), beyond || enter > leave,
          span_of(enter, leave)};
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
/// Cost: comparisons, five orders of some 3 ns at most, some 15 ns for each end that is cut; in doubt 1 us.
/// Errors: as parametric.
template <class T = double, Observer<Started<T>, Ordered<T>, Kept<T>, Missed> O = Unobserved>
std::optional<Segment<2, T>> correctly_rounded(Segment<2, T> line, const Rectangle<T>& window,
                                               const Order& order = usual_order<2>(), O&& observer = {}) {
  expect_clippable(line, window);
  const Cuts cuts{line, window};
  if constexpr (observed<O>) observer(Started<T>{line, window, line.b - line.a});
  auto enter = cuts.start();
  auto leave = cuts.end();
  for (Border edge : order) {
    // Which ends lie beyond it?
    auto [a, b] = cuts.ends(edge);
    bool beyond = a && b;
    auto t = cuts.at(edge);
    if (a && !b) {
      // Entering: the last t counts
      if (t > enter) enter = t;
    } else if (b && !a) {
      // Leaving: the first t counts
      if (t < leave) leave = t;
    }
    if constexpr (observed<O>) observer(ordered(edge, beyond, enter, leave));
    // Nothing left: reject
    if (beyond || enter > leave) {
      if constexpr (observed<O>) observer(Missed{span_of(enter, leave)});
      return std::nullopt;
    }
  }
  // The points at those two cuts
  line = {enter.at(), leave.at()};
  if constexpr (observed<O>) observer(Kept<T>{line, span_of(enter, leave)});
  return line;
}

}  // namespace gradus::liang_barsky
