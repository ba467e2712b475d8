#pragma once
// Segments against boxes along the axes in exact rationals, and segments made to be hard to clip.

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>
#include <optional>

#include "core/axis_cut.hpp"
#include "core/random.hpp"

namespace gradus::test {

using Rational = boost::multiprecision::cpp_rational;

inline bool even(double x) { return std::bit_cast<std::uint64_t>(x) % 2 == 0; }
inline bool even(float x) { return std::bit_cast<std::uint32_t>(x) % 2 == 0; }

/// Whether no number of the type is nearer, and a tie went to even. Domain: |rounded| is not the largest
/// number.
template <class T>
bool is_nearest(T rounded, const Rational& exact) {
  if (!std::isfinite(rounded)) return false;
  if (Rational(rounded) == exact) return true;
  const T infinity = std::numeric_limits<T>::infinity();
  const T next = std::nextafter(rounded, exact < Rational(rounded) ? -infinity : infinity);
  const Rational here = abs(Rational(exact - Rational(rounded)));
  const Rational there = abs(Rational(exact - Rational(next)));
  return even(rounded) ? here <= there : here < there;
}

/// How far x lies from the exact number, in units in the last place of a double there.
inline double error_in_ulp(double x, const Rational& exact) {
  const double near = static_cast<double>(exact);
  if (!std::isfinite(x)) return std::numeric_limits<double>::infinity();
  // The distance to the next double; the largest has none, but the same distance below it
  const double size = std::min(std::abs(near), std::nextafter(std::numeric_limits<double>::max(), 0.0));
  const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(abs(Rational(Rational(x) - exact)) / Rational(unit));
}

/// The two ends of what is left of a segment, exactly.
template <int N>
struct ExactEnds {
  std::array<Rational, std::size_t{N}> a, b;
};

/// What a segment and a box have in common, by the definition: the values of t that every border allows.
template <int N, class T>
std::optional<ExactEnds<N>> exact_clip(const Segment<N, T>& s, const AxisBox<N, T>& box) {
  Rational enter = 0, leave = 1;
  for (int i = 0; i < N; ++i) {
    const Rational a = s.a[i], d = Rational(s.b[i]) - Rational(s.a[i]);
    const Rational lower = box.lower[i], upper = box.upper[i];
    if (d == 0) {
      if (a < lower || upper < a) return std::nullopt;
      continue;
    }
    const Rational first = (lower - a) / d, second = (upper - a) / d;
    enter = std::max(enter, std::min(first, second));
    leave = std::min(leave, std::max(first, second));
  }
  if (leave < enter) return std::nullopt;
  ExactEnds<N> ends;
  for (int i = 0; i < N; ++i) {
    const Rational a = s.a[i], d = Rational(s.b[i]) - Rational(s.a[i]);
    ends.a[static_cast<std::size_t>(i)] = a + enter * d;
    ends.b[static_cast<std::size_t>(i)] = a + leave * d;
  }
  return ends;
}

/// The same for homogeneous points and the view volume -w <= x, y <= w, 0 <= z <= w: the values of t for
/// which no depth is negative.
inline std::optional<ExactEnds<4>> exact_part(const Segment<4, double>& line) {
  Rational enter = 0, leave = 1;
  const auto depths = [](const glm::dvec4& p) {
    const Rational x = p.x, y = p.y, z = p.z, w = p.w;
    return std::array<Rational, 6>{w + x, w - x, w + y, w - y, z, w - z};
  };
  const auto at_a = depths(line.a), at_b = depths(line.b);
  for (std::size_t i = 0; i < 6; ++i) {
    if (at_a[i] < 0 && at_b[i] < 0) return std::nullopt;
    if (at_a[i] >= 0 && at_b[i] >= 0) continue;
    const Rational t = at_a[i] / (at_a[i] - at_b[i]);
    if (at_a[i] < 0) enter = std::max(enter, t);
    if (at_b[i] < 0) leave = std::min(leave, t);
  }
  if (leave < enter) return std::nullopt;
  ExactEnds<4> part;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational a = line.a[static_cast<int>(i)], d = Rational(line.b[static_cast<int>(i)]) - a;
    part.a[i] = a + enter * d;
    part.b[i] = a + leave * d;
  }
  return part;
}

/// What stands for a homogeneous point in numbers of the type: the point itself, or, where it would round to
/// (0, 0, 0, 0), the same divided by w. Domain: no coordinate is larger than w.
template <class T>
std::array<Rational, 4> representable(std::array<Rational, 4> p) {
  // Half the smallest number is a tie, and 0 is even
  const Rational w = p[3];
  if (2 * w <= Rational(std::numeric_limits<T>::denorm_min())) {
    for (Rational& x : p) x /= w;
  }
  return p;
}
template <class T>
std::optional<ExactEnds<4>> representable(const std::optional<ExactEnds<4>>& part) {
  if (!part) return std::nullopt;
  return ExactEnds<4>{representable<T>(part->a), representable<T>(part->b)};
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

/// A segment and what to clip it to.
struct ClipCase {
  Segment<2, double> line;
  AxisBox<2, double> window;
};

/// Makes cases of all kinds: ordinary ones, segments through corners or a few steps beside them, ends on
/// borders, exact ties, numbers of mixed sizes over the whole range, points and windows without extent.
class ClipCases {
 public:
  static constexpr int kinds = 8;
  explicit ClipCases(std::uint64_t seed) : random(seed) {}

  ClipCase operator()(int kind) {
    switch (kind % kinds) {
      case 0:
        return uniform();
      case 1:
        return at_corner(3, 3);
      case 2:
        return grid();
      case 3:
        return at_corner(-290, 290);
      case 4:
        return mixed(-299, 299);
      case 5:
        return mixed(-1074, 1023);
      case 6:
        return tied();
      default:
        return thin();
    }
  }

  Random random;

 private:
  double number(std::int64_t lowest, std::int64_t highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }
  double nudged(double x) {
    const std::int64_t steps = random.uniform_int(-2, 2);
    const double infinity = std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < std::abs(steps); ++i)
      x = std::nextafter(x, steps < 0 ? -infinity : infinity);
    return x;
  }
  static AxisBox<2, double> box(double x0, double y0, double x1, double y1) {
    return {{std::min(x0, x1), std::min(y0, y1)}, {std::max(x0, x1), std::max(y0, y1)}};
  }

  ClipCase uniform() {
    const auto c = [&] { return random.uniform(-1000, 1000); };
    ClipCase k{};
    k.line.a = {c(), c()};
    k.line.b = {c(), c()};
    const double left = random.uniform(-700, 0), bottom = random.uniform(-700, 0);
    k.window = {{left, bottom}, {left + random.uniform(0, 1000), bottom + random.uniform(0, 1000)}};
    return k;
  }
  /// Through a corner of the window, or a few steps beside it
  ClipCase at_corner(std::int64_t lowest, std::int64_t highest) {
    const std::int64_t size = random.uniform_int(lowest, highest);
    ClipCase k{};
    k.line.a = {number(size - 3, size), number(size - 3, size)};
    k.line.b = {number(size - 3, size), number(size - 3, size)};
    const bool halfway = random.unit() < 0.4;
    const double t = halfway ? 0.5 : random.unit();
    const glm::dvec2 at = k.line.a * (1 - t) + k.line.b * t;
    const glm::dvec2 corner{nudged(at.x), nudged(at.y)};
    if (halfway) k.line.b = {2 * corner.x - k.line.a.x, 2 * corner.y - k.line.a.y};
    const double x = number(size - 4, size), y = number(size - 4, size);
    k.window = box(corner.x, corner.y, corner.x + x, corner.y + y);
    return k;
  }
  ClipCase grid() {
    const auto c = [&] { return static_cast<double>(random.uniform_int(-4, 14)); };
    ClipCase k{};
    k.line.a = {c(), c()};
    k.line.b = {c(), c()};
    k.window = box(0, 0, 10, 10);
    return k;
  }
  ClipCase mixed(std::int64_t lowest, std::int64_t highest) {
    const auto c = [&] { return random.unit() < 0.1 ? 0.0 : number(lowest, highest); };
    ClipCase k{};
    k.line.a = {c(), c()};
    k.line.b = {c(), c()};
    const double x = c(), y = c(), z = c();
    k.window = box(x, y, z, c());
    // Often across the window
    if (random.unit() < 0.5) {
      k.window.lower.x = -std::abs(k.window.lower.x);
      k.window.upper.x = std::max(k.window.upper.x, std::abs(c()));
      k.line.b.x = -k.line.a.x;
    }
    return k;
  }
  /// A border halfway along the segment, where the other coordinate is midway between two doubles
  ClipCase tied() {
    ClipCase k{};
    const std::int64_t high = std::int64_t{1} << 53, low = std::int64_t{1} << 52;
    const std::int64_t first = random.uniform_int(low, high - 1);
    const std::int64_t second = random.uniform_int(low, high - 1);
    const double from = static_cast<double>(first);
    const double to = static_cast<double>(second - (first + second + 1) % 2);
    const double x = random.uniform(1, 8), hair = random.unit() < 0.5 ? 0 : number(-200, -90);
    k.line = {{-x, from}, {x, to}};
    k.window = {{hair, -1e17}, {10, 1e17}};
    if (random.unit() < 0.5) k.window = {{-10, -1e17}, {hair, 1e17}};
    if (random.unit() < 0.5) {
      k.line = {{from, -x}, {to, x}};
      k.window = {{k.window.lower.y, k.window.lower.x}, {k.window.upper.y, k.window.upper.x}};
    }
    return k;
  }
  /// No extent in one axis or two, of the segment or of the window
  ClipCase thin() {
    ClipCase k = grid();
    const auto c = [&] { return static_cast<double>(random.uniform_int(-1, 11)); };
    const int which = static_cast<int>(random.uniform_int(0, 4));
    if (which == 0) k.line.b = k.line.a;
    if (which == 1) k.line.b.x = k.line.a.x;
    if (which == 2) k.line.b.y = k.line.a.y;
    if (which == 3) k.window.lower.x = k.window.upper.x = c();
    if (which == 4) k.window.upper = k.window.lower = {c(), c()};
    return k;
  }
};

/// Whether a cut needs exact arithmetic.
inline bool is_slow_cut(const Segment<2, double>& s, int axis, double c) {
  const int other = 1 - axis;
  if (c == s.a[axis] || c == s.b[axis] || s.a[other] == s.b[other]) return false;
  return !cut_coordinate_filtered(s.a[axis], s.b[axis], s.a[other], s.b[other], c);
}

}  // namespace gradus::test
