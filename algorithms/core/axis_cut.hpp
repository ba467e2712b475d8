#pragma once
// Cutting a segment at windows and boxes whose borders lie along the axes, in any dimension, without an error
// that matters: the point of a cut is the correctly rounded one, and the order of two cuts along the segment
// is exact. Everything is computed from the original end points, never from an earlier cut.

#include <array>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/arithmetic/exact.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus {

/// A border of a rectangle or box: the lower and the upper one of x, of y, of z.
enum class Border : std::uint8_t { left, right, bottom, top, near, far };

/// The borders in the order in which a clipper takes them: all four of a rectangle, all six of a box, each
/// once.
template <int N>
using BorderOrder = std::array<Border, 2 * std::size_t{N}>;

template <int N>
constexpr BorderOrder<N> usual_order() {
  BorderOrder<N> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Border>(i);
  return order;
}

/// 0 x, 1 y, 2 z: the axis that the border cuts across.
constexpr int axis_of(Border border) { return static_cast<int>(border) / 2; }
constexpr bool is_upper(Border border) { return static_cast<int>(border) % 2 == 1; }

/// Where the border lies on its axis. Of the two zeros +0: points that are cut at a border copy this, and
/// must not tell which of two borders at 0 came first.
template <int N, class T>
T coordinate(const AxisBox<N, T>& box, Border border) {
  return (is_upper(border) ? box.upper : box.lower)[axis_of(border)] + T(0);
}

/// Whether p lies beyond the border; on it is not beyond it.
template <int N, class T>
bool outside(const glm::vec<N, T>& p, const AxisBox<N, T>& box, Border border) {
  const T at = p[axis_of(border)];
  return is_upper(border) ? box.upper[axis_of(border)] < at : at < box.lower[axis_of(border)];
}

/// Whether every coordinate is a number; rationals always are.
template <int N, class T>
bool is_finite(const glm::vec<N, T>& p) {
  if constexpr (std::floating_point<T>) {
    for (int i = 0; i < N; ++i) {
      if (!std::isfinite(p[i])) return false;
    }
  }
  return true;
}

/// What every clipper along the axes asks of its input. Errors: ContractViolation for a coordinate that is
/// not finite, and for a border that lies beyond the one on the other side.
template <int N, class T>
void expect_clippable(const Segment<N, T>& segment, const AxisBox<N, T>& box) {
  expects(is_finite(segment.a) && is_finite(segment.b), "a segment needs finite end points");
  expects(is_finite(box.lower) && is_finite(box.upper), "a window needs finite borders");
  for (int i = 0; i < N; ++i) {
    expects(box.lower[i] <= box.upper[i], "the window is inside out along axis {}: from {} to {}", i,
            static_cast<double>(box.lower[i]), static_cast<double>(box.upper[i]));
  }
}

// --- The point of a cut -----------------------------------------------------------------------------------

/// The double nearest to a + way * rise / length where fast arithmetic is sure of it, else nothing.
/// Source: quotient and sum in double-double (T. J. Dekker, A floating-point technique for extending the
/// available precision, Numerische Mathematik 18, 1971, 224-242), then a rounding test: what lies within the
/// error bound on both sides must round to the same double.
/// way, rise, length: the three numbers to within 2^-104 of themselves. Domain: any doubles, length not 0;
/// nothing where one of them leaves 2^-400..2^400. Cost: some 10 ns.
inline std::optional<double> sum_with_quotient_filtered(double a, Rounded way, Rounded rise, Rounded length) {
  const auto fits = [](double x) { return 0x1p-400 <= std::abs(x) && std::abs(x) <= 0x1p400; };
  if (!fits(way.value) || !fits(length.value) || !fits(rise.value)) return std::nullopt;

  // The quotient way * rise / length, and what is left over divided once more: wrong by less than 2^-99 of it
  const double quotient = way.value * rise.value / length.value;
  const Rounded above = two_product(way.value, rise.value);
  const Rounded below = two_product(quotient, length.value);
  const double left_over = ((above.value - below.value) + (above.error - below.error)) +
                           ((way.value * rise.error + way.error * rise.value) - quotient * length.error);
  const double correction = left_over / length.value;

  // Add it to a, and ask whether the bound could reach another double
  const Rounded sum = two_sum(a, quotient);
  const double rest = sum.error + correction;
  const double bound = 0x1p-95 * std::abs(quotient) + 0x1p-100 * std::abs(sum.value) + 0x1p-1060;
  const double highest = sum.value + (rest + bound);
  if (highest != sum.value + (rest - bound)) return std::nullopt;
  return highest;
}

/// The double nearest to the other coordinate of a cut where fast arithmetic is sure of it, else nothing.
/// Domain: any doubles with a_axis != b_axis; nothing where a difference leaves 2^-400..2^400. Cost: some 10
/// ns.
inline std::optional<double> cut_coordinate_filtered(double a_axis, double b_axis, double a_other,
                                                     double b_other, double c) {
  return sum_with_quotient_filtered(a_other, two_difference(c, a_axis), two_difference(b_other, a_other),
                                    two_difference(b_axis, a_axis));
}

/// The same by exact arithmetic alone. Domain: finite, a_axis != b_axis (refused). Cost: about 1 us, up to
/// 10 us over the full range of exponents.
double cut_coordinate_exact(double a_axis, double b_axis, double a_other, double b_other, double c);

/// Where a segment meets the border at coordinate c of one axis: the double nearest to its other coordinate,
/// a_other + (c - a_axis) (b_other - a_other) / (b_axis - a_axis). (In three dimensions: called once for each
/// of the two others.) At c = a_axis or c = b_axis it is that end's own.
///
/// a_axis, b_axis: the ends along the axis of the border. a_other, b_other: along the other axis.
///
/// Domain: finite doubles of any size, a_axis and b_axis different, c between them. Numbers that are 0 or of
///   2^-300 to 2^300 in size take the fast path but for ties and near ties.
/// Accuracy: 1/2 ulp, the nearest double, ties to even. It lies between a_other and b_other, and the same
///   bits come out when a and b change places. A zero is +0.
/// Cost: some 10 ns, in doubt about 1 us.
inline double cut_coordinate(double a_axis, double b_axis, double a_other, double b_other, double c) {
  // An end on the border, or a segment along it; + 0.0 turns -0 into 0
  if (c == a_axis || a_other == b_other) return a_other + 0.0;
  if (c == b_axis) return b_other + 0.0;
  const auto sure = cut_coordinate_filtered(a_axis, b_axis, a_other, b_other, c);
  return sure ? *sure + 0.0 : cut_coordinate_exact(a_axis, b_axis, a_other, b_other, c);
}

/// The same for float: the nearest float, not the float nearest to the nearest double.
inline float cut_coordinate(float a_axis, float b_axis, float a_other, float b_other, float c) {
  const double exact_to_double =
      cut_coordinate(double{a_axis}, double{b_axis}, double{a_other}, double{b_other}, double{c});
  const float nearest = static_cast<float>(exact_to_double) + 0.0f;  // of what underflows, -0, too
  if (double{nearest} == exact_to_double) return nearest;
  // Midway between two floats the exact point decides, which may lie a little beside the double
  const float other = std::nextafter(nearest, exact_to_double < double{nearest} ? -INFINITY : INFINITY);
  if (exact_to_double - double{nearest} != double{other} - exact_to_double) return nearest;
  const int side =
      orient2d(glm::dvec2(a_axis, a_other), glm::dvec2(b_axis, b_other), glm::dvec2(c, exact_to_double));
  if (side == 0) return nearest;
  const bool above =
      (side < 0) == (a_axis < b_axis);  // the double lies right of a -> b: the segment is higher
  return above == (other > nearest) ? other : nearest;
}

/// The same in a scalar without rounding (gradus::Exact): the point itself.
template <class T>
  requires(!std::floating_point<T>)
T cut_coordinate(T a_axis, T b_axis, T a_other, T b_other, T c) {
  return a_other + (c - a_axis) * (b_other - a_other) / (b_axis - a_axis);
}

/// The whole point where a segment meets the border at c of `axis`: that coordinate is copied, every other
/// one the nearest number to the exact one. Domain: finite, c between segment.a[axis] and segment.b[axis],
/// those two different.
template <int N, class T>
glm::vec<N, T> cut_point(const Segment<N, T>& segment, int axis, T c) {
  glm::vec<N, T> point = segment.a;
  for (int i = 0; i < N; ++i) {
    if (i == axis) {
      point[i] = c;
    } else {
      point[i] = cut_coordinate(segment.a[axis], segment.b[axis], segment.a[i], segment.b[i], c);
    }
  }
  return point;
}

// --- The order of cuts ------------------------------------------------------------------------------------

/// Which of two borders a segment from a to b comes to first: the exact order of
/// (c.x - a.x) / (b.x - a.x) and (c.y - a.y) / (b.y - a.y), where x and y stand for any two axes i and j.
/// less: border c_i comes first; equal: both at once, the segment passes through the borders' corner.
///
/// a_i, b_i: the ends along axis i, c_i its border; a_j, b_j, c_j likewise. i == j is allowed.
///
/// Domain: finite doubles of any size, a_i != b_i and a_j != b_j; else the answer is equal, or without
/// meaning. Accuracy: exact: it is the side of the line on which the corner (c_i, c_j) lies. Cost: about 3
/// ns, in doubt about 0.2 us.
template <std::floating_point T>
std::strong_ordering compare_cuts(T a_i, T b_i, T c_i, T a_j, T b_j, T c_j) {
  const int side = orient2d(glm::vec<2, T>(a_i, a_j), glm::vec<2, T>(b_i, b_j), glm::vec<2, T>(c_i, c_j));
  return ((a_i < b_i) == (a_j < b_j) ? -side : side) <=> 0;
}

/// The same in a scalar without rounding.
template <class T>
  requires(!std::floating_point<T>)
std::strong_ordering compare_cuts(T a_i, T b_i, T c_i, T a_j, T b_j, T c_j) {
  const T first = (c_i - a_i) * (b_j - a_j), second = (c_j - a_j) * (b_i - a_i);
  return (a_i < b_i) == (a_j < b_j) ? first <=> second : second <=> first;
}

/// The order of the cuts of a segment at border c_i of axis i and border c_j of axis j; see above.
template <int N, class T>
std::strong_ordering compare_cuts(const Segment<N, T>& segment, int i, T c_i, int j, T c_j) {
  return compare_cuts(segment.a[i], segment.b[i], c_i, segment.a[j], segment.b[j], c_j);
}

/// On which side of border c_j of axis j a segment stands where it meets border c_i of axis i: the exact
/// order of its coordinate there and c_j. The nearest double answers already, unless it is c_j itself.
///
/// at: the coordinate along j of cut_point(segment, i, c_i).
///
/// Domain: finite, segment.a[i] != segment.b[i]. Accuracy: exact. Cost: a comparison, seldom 0.2 us.
template <int N, class T>
std::strong_ordering compare_at_cut(const Segment<N, T>& segment, int i, T c_i, int j, T c_j, T at) {
  if (at < c_j) return std::strong_ordering::less;
  if (at > c_j) return std::strong_ordering::greater;
  if (segment.a[j] == segment.b[j]) return std::strong_ordering::equal;
  // Of two cuts the one that comes first decides: until it comes to c_j, the segment stays on a's side of it
  const std::strong_ordering order = compare_cuts(segment, i, c_i, j, c_j);
  return segment.a[j] < segment.b[j] ? order : 0 <=> order;
}

}  // namespace gradus
