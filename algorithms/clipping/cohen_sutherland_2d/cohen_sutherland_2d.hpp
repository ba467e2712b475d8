#pragma once
// The part of a segment that lies in a window, after Cohen and Sutherland: each end gets a code of four bits
// that says beyond which borders it lies. Codes without a bit: accept; a bit in common: reject; else an end
// that is outside moves along the segment to a border of its code, and the question is asked again.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::cohen_sutherland_2d {

using Order = BorderOrder<2>;

/// A bit for every border that a point lies beyond: 1 left, 2 right, 4 bottom, 8 top. 0 is in the window.
using Code = std::uint8_t;

constexpr Code bit(Border border) { return static_cast<Code>(1 << static_cast<int>(border)); }

/// The code of a point. On a border is inside.
template <class T = double>
Code region_code(glm::vec<2, T> p, const Rectangle<T>& window) {
  Code code = 0;
  if (p.x < window.lower.x) code |= bit(Border::left);
  if (p.x > window.upper.x) code |= bit(Border::right);
  if (p.y < window.lower.y) code |= bit(Border::bottom);
  if (p.y > window.upper.y) code |= bit(Border::top);
  return code;
}

/// The first border of the order whose bit is set. Domain: code is not 0.
constexpr Border first(const Order& order, Code code) {
  for (const Border border : order) {
    if (code & bit(border)) return border;
  }
  return order.back();
}

// --- Steps -------------------------------------------------------

/// Both ends have their codes.
template <class T>
struct Classified {
  Segment<2, T> line;
  Rectangle<T> window;
  Code code_a, code_b;
};

/// An end was moved along the line to a border, and has its new code.
template <class T>
struct Cut {
  bool of_a;  ///< whether a was moved, not b
  Border border;
  Segment<2, T> line;   ///< what is left,
  Code code_a, code_b;  ///< and its codes

  glm::vec<2, T> to() const { return of_a ? line.a : line.b; }
  Code after() const { return of_a ? code_a : code_b; }
};

/// No bit is set: this part lies in the window.
template <class T>
struct Accepted {
  Segment<2, T> line;
};

/// Both ends lie beyond the same border (or, in cut_of_a_cut's rounded arithmetic, four cuts have settled
/// nothing).
struct Rejected {
  Code common;
};

// --- Ends --------------------------------------------------------

/// An end of what is left: a point, and its code.
template <class T>
struct End {
  glm::vec<2, T> at;
  Code code;
};

/// An end that has not moved.
template <class T = double>
End<T> end_in(glm::vec<2, T> p, const Rectangle<T>& window) {
  return {p, region_code(p, window)};
}

// --- The taught method -------------------------------------------

/// Where the line from a to b meets a border, in the arithmetic of T. Domain: it does.
template <class T>
glm::vec<2, T> meet(glm::vec<2, T> a, glm::vec<2, T> b, Border border, const Rectangle<T>& window) {
  const T c = coordinate(window, border);
  if (axis_of(border) == 0) {
    return {c, a.y + (b.y - a.y) * (c - a.x) / (b.x - a.x)};
  }
  return {a.x + (b.x - a.x) * (c - a.y) / (b.y - a.y), c};
}

/// The end where what is left from a to b meets a border, rounded, and the code of the rounded point.
template <class T>
End<T> cut(const End<T>& a, const End<T>& b, Border border, const Rectangle<T>& window) {
  return end_in(meet(a.at, b.at, border, window), window);
}

/// The part of a segment that lies in a window, each cut computed from what the last one left over.
/// D. Cohen, I. Sutherland, about 1967; in this form J. Foley, A. van Dam, S. Feiner, J. Hughes, Computer
/// graphics: principles and practice, 2nd edition 1990, section 3.12.3.
///
/// T: float, double or gradus::Exact. line: any two points, in any units. window: its borders belong to it.
/// order: of several borders that an end lies beyond, which is cut at first.
///
/// Domain: finite coordinates whose differences and products of differences don't overflow (2^500 will do);
///   beyond, the answer may be wrong. correctly_rounded has no such limit.
/// Steps: Classified Cut* (Accepted | Rejected), at most 4 Cuts.
/// Accuracy: exact for Exact. In floating point every cut rounds four times and starts from a rounded point:
///   of the accepted lines of the property test with ends in +-1000 about half have a coordinate that is not
///   the nearest one or its neighbour, and lines that pass near a corner may be decided wrongly. The number
///   of cuts is limited to 4, what exact arithmetic needs at most: rounding can send an end to and fro
///   between two borders.
/// Cost: four comparisons per end, one division per cut.
/// Errors: ContractViolation for coordinates that are not finite and windows that are inside out.
template <class T = double, Observer<Classified<T>, Cut<T>, Accepted<T>, Rejected> O = Unobserved>
std::optional<Segment<2, T>> cut_of_a_cut(Segment<2, T> line, const Rectangle<T>& window,
                                          const Order& order = usual_order<2>(), O&& observer = {}) {
  expect_clippable(line, window);
  End<T> a = end_in(line.a, window);
  End<T> b = end_in(line.b, window);
  if constexpr (observed<O>) observer(Classified<T>{line, window, a.code, b.code});
  int cuts = 0;
  // Both beyond one border: reject
  while ((a.code & b.code) == 0) {
    // Both inside: accept
    if ((a.code | b.code) == 0) {
      if constexpr (observed<O>) observer(Accepted<T>{{a.at, b.at}});
      return Segment{a.at, b.at};
    }
    if (++cuts > 4) break;
    // Move an end that is outside
    // to a border of its code
    End<T>& e = a.code ? a : b;
    auto to = first(order, e.code);
    e = cut(a, b, to, window);
    if constexpr (observed<O>) observer(Cut<T>{&e == &a, to, {a.at, b.at}, a.code, b.code});
  }
  if constexpr (observed<O>) observer(Rejected{static_cast<Code>(a.code & b.code)});
  return std::nullopt;
}

// --- The method without rounding errors --------------------------

/// The end where the original line meets a border: correctly rounded, its code exact. Only where the rounded
/// coordinate falls onto a border is there something to decide.
template <class T>
End<T> cut(const Segment<2, T>& line, Border border, const Rectangle<T>& window) {
  const int axis = axis_of(border), other = 1 - axis;
  const T c = coordinate(window, border);
  End<T> end{cut_point(line, axis, c), 0};
  const auto beyond = [&](Border side) {
    return compare_at_cut(line, axis, c, other, coordinate(window, side), end.at[other]);
  };
  const Border lower = static_cast<Border>(2 * other), upper = static_cast<Border>(2 * other + 1);
  if (beyond(lower) < 0) end.code |= bit(lower);
  if (beyond(upper) > 0) end.code |= bit(upper);
  return end;
}

/// The part of a segment that lies in a window, decided exactly, its ends correctly rounded: every cut is
/// computed from the original end points, and codes are those of the exact points.
///
/// line, window, order: as for cut_of_a_cut.
///
/// Domain: all finite coordinates, from the subnormals to the largest. Numbers that are 0 or of 2^-300 to
///   2^300 in size take fast arithmetic nearly always.
/// Steps: Classified Cut* (Accepted | Rejected), at most 4 Cuts; Cut.to() is the rounded point. No border is
///   cut at twice: an end that was cut there never is beyond it again, and where both ends are the line is
///   rejected.
/// Accuracy: accepted exactly when the segment and the window have a point in common. The coordinate of the
///   border is copied, the other one is the nearest number to that of the exact point (1/2 ulp). So, bit for
///   bit, clipping again changes nothing, and (b, a) gives the reverse of (a, b).
/// Cost: as cut_of_a_cut, and some 15 ns per cut; in doubt some 1 us per cut.
/// Errors: as cut_of_a_cut.
template <class T = double, Observer<Classified<T>, Cut<T>, Accepted<T>, Rejected> O = Unobserved>
std::optional<Segment<2, T>> correctly_rounded(Segment<2, T> line, const Rectangle<T>& window,
                                               const Order& order = usual_order<2>(), O&& observer = {}) {
  expect_clippable(line, window);
  End<T> a = end_in(line.a, window);
  End<T> b = end_in(line.b, window);
  if constexpr (observed<O>) observer(Classified<T>{line, window, a.code, b.code});
  int cuts = 0;
  // Both beyond one border: reject
  while ((a.code & b.code) == 0) {
    // Both inside: accept
    if ((a.code | b.code) == 0) {
      if constexpr (observed<O>) observer(Accepted<T>{{a.at, b.at}});
      return Segment{a.at, b.at};
    }
    // One cut a border is enough
    if (++cuts > 4) break;
    // Move an end that is outside
    // along the line that was given
    End<T>& e = a.code ? a : b;
    auto to = first(order, e.code);
    e = cut(line, to, window);
    if constexpr (observed<O>) observer(Cut<T>{&e == &a, to, {a.at, b.at}, a.code, b.code});
  }
  if constexpr (observed<O>) observer(Rejected{static_cast<Code>(a.code & b.code)});
  return std::nullopt;
}

}  // namespace gradus::cohen_sutherland_2d
