#pragma once
// The view volume -w <= x, y <= w, 0 <= z <= w as a region for region codes: segments are cut before the
// division by w, while what lies behind the eye (w <= 0) can still be told from what lies before it.
//
// The volume is a convex cone of homogeneous points, so that a segment of them has one part in it or none. A
// segment that runs past the eye keeps its piece before it. (The other piece that J. F. Blinn and M. E.
// Newell, Clipping using homogeneous coordinates, SIGGRAPH 1978, keep too belongs to lines through infinity,
// which no segment between two points of space is.)

#include <cmath>
#include <concepts>
#include <glm/vec4.hpp>
#include <optional>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/axis_cut.hpp"
#include "core/contract.hpp"

namespace gradus::cohen_sutherland_3d {

/// -w <= x <= w, -w <= y <= w, 0 <= z <= w; the faces belong to it.
struct ViewVolume {};

// --- Faces -----------------------------------------------------------------------------------------------

/// How far inside a face a point lies, as two numbers not added yet: w + x, w - x, w + y, w - y, z + 0,
/// w - z.
template <class T>
struct Depth {
  T base, offset;
};

template <class T>
constexpr Depth<T> depth(const glm::vec<4, T>& p, Border face) {
  if (face == Border::near) return {p.z, T(0)};
  const T coordinate = p[axis_of(face)];
  return {p.w, is_upper(face) ? -coordinate : coordinate};
}

/// Whether base + offset < 0, exactly: compared, not added.
template <class T>
constexpr bool negative(const Depth<T>& d) {
  return d.base < -d.offset;
}

/// Whether a homogeneous point lies outside a face; on it is inside. Behind the eye (w < 0) it may be left
/// and right at once.
template <class T>
constexpr bool outside(const glm::vec<4, T>& p, const ViewVolume&, Border face) {
  return negative(depth(p, face));
}

/// A point on a face, whose coordinate across it is copied: x = -w, x = w, …, z = 0 or z = w.
template <class T>
constexpr glm::vec<4, T> copied_onto(glm::vec<4, T> p, Border face) {
  T& coordinate = p[axis_of(face)];
  if (face == Border::near) {
    coordinate = T(0);
  } else {
    coordinate = is_upper(face) ? p.w : T(0) - p.w;
  }
  return p;
}

/// The textbook's cut of the way from p, outside a face, to q, which is not: t = d(p) / (d(p) - d(q)),
/// then p + t (q - p), all rounded to T; the coordinate across the face is copied from w.
template <class T>
constexpr glm::vec<4, T> meet(const glm::vec<4, T>& p, const glm::vec<4, T>& q, Border face,
                              const ViewVolume&) {
  const auto [p_base, p_offset] = depth(p, face);
  const auto [q_base, q_offset] = depth(q, face);
  const T t = (p_base + p_offset) / ((p_base + p_offset) - (q_base + q_offset));
  return copied_onto(p + t * (q - p), face);
}

// --- Where a segment meets a face -------------------------------------------------------------------------

/// What tells where the way from a to b meets a face: the depths of both ends, one of them negative.
template <class T>
struct Crossing {
  Depth<T> a, b;
};

/// The double nearest to a coordinate that is `a` at one end and `b` at the other, where fast arithmetic is
/// sure of it, else nothing. Source and cost: as gradus::cut_coordinate_filtered.
inline std::optional<double> coordinate_at_filtered(const Crossing<double>& c, double a, double b) {
  const Rounded way = two_sum(c.a.base, c.a.offset);
  const Rounded on = two_sum(c.b.base, c.b.offset);
  // way - on: the signs differ, so no digits cancel
  Rounded length = two_difference(way.value, on.value);
  length = fast_two_sum(length.value, length.error + (way.error - on.error));
  return sum_with_quotient_filtered(a, way, two_difference(b, a), length);
}

/// b d(a) - a d(b), multiplied out: a coordinate at the crossing, times d(a) - d(b).
inline SumOfProducts<2> numerator_at(const Crossing<double>& c, double a, double b) {
  SumOfProducts<2> numerator;
  numerator.add(b, c.a.base);
  numerator.add(b, c.a.offset);
  numerator.subtract(a, c.b.base);
  numerator.subtract(a, c.b.offset);
  return numerator;
}

/// The same as coordinate_at_filtered by exact arithmetic alone.
inline double coordinate_at_exact(const Crossing<double>& c, double a, double b) {
  SumOfProducts<1> denominator;
  denominator.add(c.a.base);
  denominator.add(c.a.offset);
  denominator.subtract(c.b.base);
  denominator.subtract(c.b.offset);
  return rounded_quotient(numerator_at(c, a, b), denominator) + 0.0;
}

/// The number nearest to a coordinate that is `a` at one end and `b` at the other, where the way between them
/// crosses. Domain: finite doubles of any size. Accuracy: 1/2 ulp, ties to even; a zero is +0.
inline double coordinate_at(const Crossing<double>& c, double a, double b) {
  if (a == b) return a + 0.0;
  const auto sure = coordinate_at_filtered(c, a, b);
  return sure ? *sure + 0.0 : coordinate_at_exact(c, a, b);
}

/// The same in double, which holds every float.
inline Depth<double> widened(const Depth<float>& d) { return {double{d.base}, double{d.offset}}; }
inline Crossing<double> widened(const Crossing<float>& c) { return {widened(c.a), widened(c.b)}; }

/// The same in a scalar without rounding.
template <class T>
  requires(!std::floating_point<T>)
T coordinate_at(const Crossing<T>& c, T a, T b) {
  const T d_a = c.a.base + c.a.offset, d_b = c.b.base + c.b.offset;
  return (b * d_a - a * d_b) / (d_a - d_b);
}

/// Whether the depth in another face, `a` at one end and `b` at the other, is negative at the crossing, where
/// fast arithmetic is sure of it.
inline std::optional<bool> negative_at_filtered(const Crossing<double>& c, Depth<double> a, Depth<double> b) {
  // (b d(a) - a d(b)) / (d(a) - d(b)): the divisor has the sign of d(a), or that of -d(b)
  const double d_a = c.a.base + c.a.offset, d_b = c.b.base + c.b.offset;
  const double left = (b.base + b.offset) * d_a, right = (a.base + a.offset) * d_b;
  // Each factor is rounded once, each product and the difference once more: less than 4 * 2^-53 of the
  // products
  const double bound = 0x1p-50 * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  const double difference = left - right;
  if (!(std::abs(difference) > bound)) return std::nullopt;
  return (difference < 0) != negative(c.a);
}

/// The same by exact arithmetic alone.
inline bool negative_at_exact(const Crossing<double>& c, Depth<double> a, Depth<double> b) {
  SumOfProducts<2> difference;
  for (const double x : {b.base, b.offset}) {
    difference.add(x, c.a.base);
    difference.add(x, c.a.offset);
  }
  for (const double x : {a.base, a.offset}) {
    difference.subtract(x, c.b.base);
    difference.subtract(x, c.b.offset);
  }
  return negative(c.a) ? difference.sign() > 0 : difference.sign() < 0;
}

/// Whether it is, exactly. Domain: finite doubles of any size.
inline bool negative_at(const Crossing<double>& c, Depth<double> a, Depth<double> b) {
  const auto sure = negative_at_filtered(c, a, b);
  return sure ? *sure : negative_at_exact(c, a, b);
}

inline bool negative_at(const Crossing<float>& c, Depth<float> a, Depth<float> b) {
  return negative_at(widened(c), widened(a), widened(b));
}

template <class T>
  requires(!std::floating_point<T>)
bool negative_at(const Crossing<T>& c, const Depth<T>& a, const Depth<T>& b) {
  return coordinate_at(c, a.base + a.offset, b.base + b.offset) < T(0);
}

/// coordinate_at for float: the nearest float, not the float nearest to the nearest double; a zero is +0.
inline float coordinate_at(const Crossing<float>& c, float a, float b) {
  const Crossing<double> there = widened(c);
  const double exact_to_double = coordinate_at(there, double{a}, double{b});
  const float nearest = static_cast<float>(exact_to_double) + 0.0f;  // of what underflows, -0, too
  if (double{nearest} == exact_to_double) return nearest;
  // Midway between two floats the exact point decides, which may lie a little beside the double
  const float other = std::nextafter(nearest, exact_to_double < double{nearest} ? -INFINITY : INFINITY);
  if (exact_to_double - double{nearest} != double{other} - exact_to_double) return nearest;
  const bool below =
      negative_at(there, Depth<double>{a, -exact_to_double}, Depth<double>{b, -exact_to_double});
  const bool above =
      negative_at(there, Depth<double>{exact_to_double, -a}, Depth<double>{exact_to_double, -b});
  return (other > nearest ? above : below) ? other : nearest;
}

/// The crossing divided by its w: (x / w, y / w, z / w, 1), each the nearest double.
/// Domain: w is not 0 there.
inline glm::dvec4 divided_at(const Crossing<double>& c, const glm::dvec4& a, const glm::dvec4& b) {
  glm::dvec4 point(1);
  const SumOfProducts<2> w = numerator_at(c, a.w, b.w);
  for (int i = 0; i < 3; ++i) point[i] = rounded_quotient(numerator_at(c, a[i], b[i]), w) + 0.0;
  return point;
}
inline glm::vec4 divided_at(const Crossing<float>& c, const glm::vec4& a, const glm::vec4& b) {
  return glm::vec4(divided_at(widened(c), glm::dvec4(a), glm::dvec4(b)));
}

/// The end where the original line meets a face: the coordinate across the face is copied from w (near: 0),
/// the others are the nearest numbers; the code is that of the exact point. An end of the volume that would
/// round to (0, 0, 0, 0), which is no point, is divided by its w. Domain: the ends lie on different sides of
/// the face, or one of them on it. T: float, double or gradus::Exact.
template <class T>
End<4, T> end_at(const Segment<4, T>& line, Border face, const ViewVolume&) {
  const Crossing<T> there{depth(line.a, face), depth(line.b, face)};
  End<4, T> end{line.a, 0};
  for (int i = 0; i < 4; ++i) {
    if (i != axis_of(face)) end.at[i] = coordinate_at(there, line.a[i], line.b[i]);
  }
  end.at = copied_onto(end.at, face);
  for (const Border other : usual_order<3>()) {
    if (other == face) continue;
    const Depth<T> a = depth(line.a, other), b = depth(line.b, other);
    // Where both ends agree, so does all between them
    const bool out = negative(a) == negative(b) ? negative(a) : negative_at(there, a, b);
    if (out) end.code |= bit(other);
  }
  if constexpr (std::floating_point<T>) {
    // In the volume the others are no larger than w
    if (end.code == 0 && end.at.w == 0) end.at = copied_onto(divided_at(there, line.a, line.b), face);
  }
  return end;
}

// --- What is no segment of points ------------------------------------------------------------------------

/// Whether b = -s a with s > 0, so that all four coordinates pass through 0 between them.
template <class T>
bool opposite(const glm::vec<4, T>& a, const glm::vec<4, T>& b) {
  for (int i = 0; i < 4; ++i) {
    if ((a[i] > T(0)) != (b[i] < T(0)) || (a[i] < T(0)) != (b[i] > T(0))) return false;
  }
  for (int i = 1; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if constexpr (std::floating_point<T>) {
        if (orient2d(glm::vec<2, T>(a[i], a[j]), glm::vec<2, T>(0), glm::vec<2, T>(b[i], b[j])) != 0)
          return false;
      } else if (a[i] * b[j] != a[j] * b[i]) {
        return false;
      }
    }
  }
  return true;
}

/// Errors: ContractViolation for a coordinate that is not finite, for (0, 0, 0, 0), which is no point, and
/// for ends opposite each other, between which it lies. (A matrix that can be inverted makes neither of
/// points.)
template <class T>
void expect_clippable(const Segment<4, T>& segment, const ViewVolume&) {
  expects(is_finite(segment.a) && is_finite(segment.b), "a segment needs finite end points");
  const glm::vec<4, T> none(T(0));
  expects(segment.a != none && segment.b != none, "(0, 0, 0, 0) is no homogeneous point");
  expects(!opposite(segment.a, segment.b),
          "the ends are opposite each other: (0, 0, 0, 0), which is no point, lies between them");
}

}  // namespace gradus::cohen_sutherland_3d
