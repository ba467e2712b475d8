#pragma once
// Segments against boxes along the axes by exact arithmetic.

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

#include "core/axis_cut.hpp"
#include "support/fraction.hpp"

namespace gradus::test {

using Rational = boost::multiprecision::cpp_rational;

inline bool even(double x) { return std::bit_cast<std::uint64_t>(x) % 2 == 0; }
inline bool even(float x) { return std::bit_cast<std::uint32_t>(x) % 2 == 0; }

/// Whether no number of the type is nearer, and a tie went to even. Domain: |rounded| is not the largest
/// number.
template <class T, class Exact>
bool is_nearest(T rounded, const Exact& exact) {
  if (!std::isfinite(rounded)) return false;
  const Exact off = exact - Exact(rounded);
  if (off == 0) return true;
  const T infinity = std::numeric_limits<T>::infinity();
  const T next = std::nextafter(rounded, off < 0 ? -infinity : infinity);
  const Exact twice = 2 * abs(off), step = abs(Exact(Exact(next) - Exact(rounded)));
  return even(rounded) ? twice <= step : twice < step;
}

/// How far x lies from the exact number, in units in the last place of a double there, or of `least` where
/// that is larger.
inline double error_in_ulp(double x, const Fraction& exact, double least = 0) {
  if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
  if (least == 0 && Fraction(x) == exact) return 0;
  // The distance to the next double; after the largest there is none, but the same distance below it
  const double near = std::max(std::abs(static_cast<double>(exact)), least);
  const double size = std::min(near, std::nextafter(std::numeric_limits<double>::max(), 0.0));
  const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(abs(Fraction(x) - exact) / unit);
}

/// The nearest double. Domain: inside their range.
inline double nearest(const Fraction& exact) {
  const double guess = static_cast<double>(exact);
  if (is_nearest(guess, exact)) return guess;
  const double above = std::nextafter(guess, HUGE_VAL);
  return is_nearest(above, exact) ? above : std::nextafter(guess, -HUGE_VAL);
}

/// The two ends of what is left of a segment, exactly.
template <int N>
struct ExactEnds {
  std::array<Fraction, std::size_t{N}> a, b;
};

template <int N, class T>
ExactEnds<N> exact_ends(const Segment<N, T>& s) {
  ExactEnds<N> ends;
  for (int i = 0; i < N; ++i) {
    ends.a[static_cast<std::size_t>(i)] = Fraction(s.a[i]);
    ends.b[static_cast<std::size_t>(i)] = Fraction(s.b[i]);
  }
  return ends;
}
template <int N>
using ExactPlace = std::array<Fraction, std::size_t{N}>;

/// The points at two values of t, which runs from 0 to 1 along the segment.
template <int N>
ExactEnds<N> ends_at(const ExactEnds<N>& s, const Fraction& enter, const Fraction& leave) {
  ExactEnds<N> ends;
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    const Fraction d = s.b[i] - s.a[i];
    ends.a[i] = s.a[i] + enter * d;
    ends.b[i] = s.a[i] + leave * d;
  }
  return ends;
}

/// What a segment and a box have in common, by the definition: the values of t that every border allows.
template <int N>
std::optional<ExactEnds<N>> exact_clip(const ExactEnds<N>& s, const ExactPlace<N>& lower,
                                       const ExactPlace<N>& upper) {
  Fraction enter = 0, leave = 1;
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    const Fraction d = s.b[i] - s.a[i];
    if (d == 0) {
      if (s.a[i] < lower[i] || upper[i] < s.a[i]) return std::nullopt;
      continue;
    }
    const Fraction first = (lower[i] - s.a[i]) / d, second = (upper[i] - s.a[i]) / d;
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  if (leave < enter) return std::nullopt;
  return ends_at<N>(s, enter, leave);
}
template <int N, class T>
std::optional<ExactEnds<N>> exact_clip(const Segment<N, T>& s, const AxisBox<N, T>& box) {
  const ExactEnds<N> borders = exact_ends(Segment<N, T>{box.lower, box.upper});
  return exact_clip<N>(exact_ends(s), borders.a, borders.b);
}

/// The same for homogeneous points and the view volume -w <= x, y <= w, 0 <= z <= w: the values of t for
/// which no depth is negative.
template <class T>
std::optional<ExactEnds<4>> exact_part(const Segment<4, T>& line) {
  Fraction enter = 0, leave = 1;
  const auto depths = [](const glm::vec<4, T>& p) {
    const Fraction x = p.x, y = p.y, z = p.z, w = p.w;
    return std::array<Fraction, 6>{w + x, w - x, w + y, w - y, z, w - z};
  };
  const auto at_a = depths(line.a), at_b = depths(line.b);
  for (std::size_t i = 0; i < 6; ++i) {
    if (at_a[i] < 0 && at_b[i] < 0) return std::nullopt;
    if (at_a[i] >= 0 && at_b[i] >= 0) continue;
    const Fraction t = at_a[i] / (at_a[i] - at_b[i]);
    if (at_a[i] < 0) enter = std::max(enter, t);
    if (at_b[i] < 0) leave = std::min(leave, t);
  }
  if (leave < enter) return std::nullopt;
  return ends_at<4>(exact_ends(line), enter, leave);
}

/// What stands for a homogeneous point in numbers of the type: the point itself, or, where it would round to
/// (0, 0, 0, 0), the same divided by w. Domain: no coordinate is larger than w.
template <class T>
std::array<Fraction, 4> representable(std::array<Fraction, 4> p) {
  // Half the smallest number is a tie, and 0 is even
  const Fraction w = p[3];
  if (2 * w <= Fraction(std::numeric_limits<T>::denorm_min())) {
    for (Fraction& x : p) x = x / w;
  }
  return p;
}
template <class T>
std::optional<ExactEnds<4>> representable(const std::optional<ExactEnds<4>>& part) {
  if (!part) return std::nullopt;
  return ExactEnds<4>{representable<T>(part->a), representable<T>(part->b)};
}

/// The worst coordinate of what is left of a segment, by error(found, exact); infinite where something is
/// left and nothing should be, or nothing and something should.
template <int N, class T, class Error>
double worst_end(const std::optional<Segment<N, T>>& found, const std::optional<ExactEnds<N>>& exact,
                 Error error) {
  if (found.has_value() != exact.has_value()) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (int i = 0; found && i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    worst = std::max({worst, error(found->a[i], exact->a[k]), error(found->b[i], exact->b[k])});
  }
  return worst;
}

/// The error of a number that should be the nearest one, ties to even.
template <class T>
double rounding_error(T found, const Fraction& exact) {
  if (!is_nearest(found, exact)) return std::numeric_limits<double>::infinity();
  return std::same_as<T, double> ? error_in_ulp(double{found}, exact) : 0;
}

template <int N, class T>
bool same_bits(const Segment<N, T>& p, const Segment<N, T>& q) {
  for (int i = 0; i < N; ++i) {
    if (p.a[i] != q.a[i] || std::signbit(p.a[i]) != std::signbit(q.a[i])) return false;
    if (p.b[i] != q.b[i] || std::signbit(p.b[i]) != std::signbit(q.b[i])) return false;
  }
  return true;
}

template <int N, class T>
bool same_bits(const std::optional<Segment<N, T>>& p, const std::optional<Segment<N, T>>& q) {
  return p.has_value() == q.has_value() && (!p || same_bits(*p, *q));
}

template <int N, class T>
Segment<N, T> reversed(const Segment<N, T>& s) {
  return {s.b, s.a};
}

}  // namespace gradus::test
