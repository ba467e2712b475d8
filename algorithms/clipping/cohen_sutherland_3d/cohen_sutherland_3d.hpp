#pragma once
// The part of a segment that lies in a box along the axes, after Cohen and Sutherland: each end gets a code
// of six bits that says beyond which faces it lies. Codes without a bit: accept; a bit in common: reject;
// else an end that is outside moves along the segment to a face of its code, and the question is asked again.
//
// The methods take any region of which they know outside, meet, end_at and expect_clippable: a box along the
// axes here; in cohen_sutherland_3d_volume.hpp the view volume, which is a box once it is divided by w.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "core/axis_cut.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::cohen_sutherland_3d {

using Order = BorderOrder<3>;

/// A bit for every face that a point lies beyond: 1 left, 2 right, 4 bottom, 8 top, 16 near, 32 far. 0 is
/// inside.
using Code = std::uint8_t;

constexpr Code bit(Border face) { return static_cast<Code>(1 << static_cast<int>(face)); }

/// The code of a point. On a face is inside.
/// Domain: finite. Accuracy: exact. Cost: six comparisons.
template <int N, class T, class Region>
constexpr Code region_code(const glm::vec<N, T>& p, const Region& region) {
  Code code = 0;
  for (const Border face : usual_order<3>()) {
    if (outside(p, region, face)) code |= bit(face);
  }
  return code;
}

/// The first face of the order whose bit is set. Domain: code is not 0.
constexpr Border first_of(const Order& order, Code code) {
  for (const Border face : order) {
    if (code & bit(face)) return face;
  }
  return order.back();
}

/// Whether an order names each face, and so none twice.
constexpr bool names_each_face(const Order& order) {
  int named = 0;
  for (const Border face : order) named |= bit(face);
  return named == 63;
}

// --- Steps -------------------------------------------------------

/// Both ends have their codes.
template <int N, class T>
struct Classified {
  Segment<N, T> line;
  Code code_a, code_b;
};

/// An end was moved along the line to a face, and has its new code.
template <int N, class T>
struct Cut {
  bool of_a;  ///< whether a was moved, not b
  Border face;
  Segment<N, T> line;   ///< what is left,
  Code code_a, code_b;  ///< and its codes

  glm::vec<N, T> to() const { return of_a ? line.a : line.b; }
  Code after() const { return of_a ? code_a : code_b; }
};

/// No bit is set: this part lies inside.
template <int N, class T>
struct Accepted {
  Segment<N, T> line;
};

/// Both ends lie beyond the same face (or, in cut_of_a_cut's rounded arithmetic, six cuts have settled
/// nothing).
struct Rejected {
  Code common;
};

// --- Ends on their way -------------------------------------------

/// What stands where nothing of a segment lies inside.
inline constexpr std::nullopt_t nothing = std::nullopt;

/// An end on its way: where it is, to the nearest number, and its code.
template <int N, class T>
struct End {
  glm::vec<N, T> at;
  Code code;
};

/// A point with its code.
template <int N, class T, class Region>
constexpr End<N, T> coded(const glm::vec<N, T>& p, const Region& region) {
  return {p, region_code(p, region)};
}

/// The first face of the order that an end lies beyond. Domain: its code is not 0.
template <int N, class T>
constexpr Border first_of(const Order& order, const End<N, T>& end) {
  return first_of(order, end.code);
}

// --- The taught method -------------------------------------------

/// Where the way from p, outside a face, to q, which is not, comes to it, in the arithmetic of T.
template <class T>
constexpr glm::vec<3, T> meet(const glm::vec<3, T>& p, const glm::vec<3, T>& q, Border face,
                              const AxisBox<3, T>& box) {
  const int axis = axis_of(face);
  const T c = coordinate(box, face);
  const T t = (c - p[axis]) / (q[axis] - p[axis]);
  auto at = p + t * (q - p);
  at[axis] = c;
  return at;
}

/// Where the way from one end to the other comes to a face that just one of them lies beyond, in the
/// arithmetic of T.
template <int N, class T, class Region>
constexpr End<N, T> cut(const End<N, T>& a, const End<N, T>& b, Border face, const Region& region) {
  const bool from_a = (a.code & bit(face)) != 0;
  return coded(from_a ? meet(a.at, b.at, face, region) : meet(b.at, a.at, face, region), region);
}

/// The part of a segment that lies in a box or in the view volume, each cut computed from what the last one
/// left over.
/// Source: D. Cohen, I. Sutherland, about 1967; in three dimensions J. Foley, A. van Dam, S. Feiner,
/// J. Hughes, Computer graphics: principles and practice, 2nd edition 1990, section 6.5.3.
///
/// T: float, double or gradus::Exact. line: any two points, in any units. region: an AxisBox<3, T>, whose
///   faces belong to it, or ViewVolume with a homogeneous line. order: of several faces that an end lies
///   beyond, which is cut at first.
///
/// Domain: finite coordinates whose differences don't overflow (in the view volume: sums, too); beyond, the
///   answer may be wrong. correctly_rounded has no such limit.
/// Steps: Classified Cut* (Accepted | Rejected), at most 6 Cuts.
/// Accuracy: exact for Exact. In floating point every cut starts from a rounded point, the errors add up, and
///   lines that pass near an edge may be decided wrongly; the measured sizes are in
///   docs/topics/clipping/cohen_sutherland_3d.md. The number of cuts is limited to 6, what exact arithmetic
///   needs at most: rounding can put an end back outside a face that it was cut at.
/// Cost: six comparisons per end, one division per cut.
/// Errors: ContractViolation for coordinates that are not finite, boxes that are inside out, and an order
///   that leaves out a face.
template <int N = 3, class T = double, class Region = AxisBox<N, T>,
          Observer<Classified<N, T>, Cut<N, T>, Accepted<N, T>, Rejected> O = Unobserved>
std::optional<Segment<N, T>> cut_of_a_cut(Segment<N, T> line, const Region& region,
                                          const Order& order = usual_order<3>(), O&& observer = {}) {
  expect_clippable(line, region);
  expects(names_each_face(order), "an order of cutting names each of the six faces once");
  End a = coded(line.a, region);
  End b = coded(line.b, region);
  if constexpr (observed<O>) observer(Classified<N, T>{line, a.code, b.code});
  int cuts = 0;
  // Both beyond one face: reject
  while ((a.code & b.code) == 0) {
    // Both inside: accept
    if ((a.code | b.code) == 0) {
      if constexpr (observed<O>) observer(Accepted<N, T>{{a.at, b.at}});
      return Segment{a.at, b.at};
    }
    // Rounding may ask for more
    if (++cuts > 6) break;
    // An end that is outside moves
    // to a face of its code
    auto& e = a.code != 0 ? a : b;
    auto face = first_of(order, e);
    e = cut(a, b, face, region);
    if constexpr (observed<O>) observer(Cut<N, T>{&e == &a, face, {a.at, b.at}, a.code, b.code});
  }
  if constexpr (observed<O>) observer(Rejected{static_cast<Code>(a.code & b.code)});
  return nothing;
}

// --- The method without rounding errors --------------------------

/// The end where the original line meets a face: correctly rounded, its code exact. Only where a rounded
/// coordinate falls onto a face is there something to decide.
template <class T>
End<3, T> end_at(const Segment<3, T>& line, Border face, const AxisBox<3, T>& box) {
  const int axis = axis_of(face);
  const T c = coordinate(box, face);
  End<3, T> end{cut_point(line, axis, c), 0};
  for (const Border other : usual_order<3>()) {
    const int i = axis_of(other);
    if (i == axis) continue;
    const auto side = compare_at_cut(line, axis, c, i, coordinate(box, other), end.at[i]);
    if (is_upper(other) ? side > 0 : side < 0) end.code |= bit(other);
  }
  return end;
}

/// The part of a segment that lies in a box or in the view volume, decided exactly, its ends correctly
/// rounded: every cut is computed from the original end points, and codes are those of the exact points.
///
/// line, region, order: as for cut_of_a_cut; the part is the same for every order. T: float, double or
///   gradus::Exact.
///
/// Domain: all finite coordinates, from the subnormals to the largest; a box may be flat. Numbers that are 0
///   or of 2^-300 to 2^300 in size take fast arithmetic nearly always.
/// Steps: Classified Cut* (Accepted | Rejected), at most 6 Cuts; Cut.to() is the rounded point. No face is
///   cut at twice: an end that was cut there never is beyond it again, and where both ends are the line is
///   rejected.
/// Accuracy: accepted exactly when the segment and the region have a point in common. The coordinate across a
///   face is copied (from the box, or from w), the others are the nearest numbers to those of the exact point
///   (1/2 ulp). An end that would round to the homogeneous (0, 0, 0, 0), which is no point, is divided by its
///   w: the nearest doubles to x / w, y / w, z / w, and 1; in float, the floats nearest to those. So, bit for
///   bit, clipping again changes nothing, and (b, a) gives the reverse of (a, b).
/// Cost: as cut_of_a_cut, and some 40 ns per cut, in the view volume some 150 ns; in doubt some us per cut.
/// Errors: as cut_of_a_cut.
template <int N = 3, class T = double, class Region = AxisBox<N, T>,
          Observer<Classified<N, T>, Cut<N, T>, Accepted<N, T>, Rejected> O = Unobserved>
std::optional<Segment<N, T>> correctly_rounded(Segment<N, T> line, const Region& region,
                                               const Order& order = usual_order<3>(), O&& observer = {}) {
  expect_clippable(line, region);
  expects(names_each_face(order), "an order of cutting names each of the six faces once");
  End a = coded(line.a, region);
  End b = coded(line.b, region);
  if constexpr (observed<O>) observer(Classified<N, T>{line, a.code, b.code});
  int cuts = 0;
  // Both beyond one face: reject
  while ((a.code & b.code) == 0) {
    // Both inside: accept
    if ((a.code | b.code) == 0) {
      if constexpr (observed<O>) observer(Accepted<N, T>{{a.at, b.at}});
      return Segment{a.at, b.at};
    }
    // One cut per face is enough
    if (++cuts > 6) break;
    // An end that is outside moves
    // to a face on the given line
    auto& e = a.code != 0 ? a : b;
    auto face = first_of(order, e);
    e = end_at(line, face, region);
    if constexpr (observed<O>) observer(Cut<N, T>{&e == &a, face, {a.at, b.at}, a.code, b.code});
  }
  if constexpr (observed<O>) observer(Rejected{static_cast<Code>(a.code & b.code)});
  return nothing;
}

}  // namespace gradus::cohen_sutherland_3d
