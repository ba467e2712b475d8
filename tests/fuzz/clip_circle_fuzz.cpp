// Segments in a circle: decisions against rationals, points against roots of 300 bits.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::liang_barsky_circle;
using gradus::test::require;
using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<300, boost::multiprecision::digit_base_2, void, std::int32_t>>;

namespace {

/// Half a unit of the last place of a number of this size, and more.
template <class T>
double error_of(T got, const Wide& right, T radius) {
  const T size = std::max(static_cast<T>(abs(right)), radius);
  const T unit = size < std::numeric_limits<T>::min()
                     ? std::numeric_limits<T>::denorm_min()
                     : std::max(size - std::nextafter(size, T(0)), std::numeric_limits<T>::denorm_min());
  // At a power of two the unit above is twice the one below
  const T wider = size < std::numeric_limits<T>::max() ? std::nextafter(size, HUGE_VALF) - size : unit;
  return static_cast<double>(abs(Wide(got) - right) / Wide(std::max(unit, wider)));
}

template <class T>
void compare(const Segment<2, T>& s, const Circle<T>& c) {
  const Rational ax = s.a.x, ay = s.a.y, dx = Rational(s.b.x) - ax, dy = Rational(s.b.y) - ay;
  const Rational fx = ax - Rational(c.centre.x), fy = ay - Rational(c.centre.y), r = c.radius;
  const Rational A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
  const Rational k = dx * fy - dy * fx, D = r * r * A - k * k;
  const int from_side = C.sign(), to_side = Rational(A + 2 * B + C).sign();
  bool hits = C <= 0;
  if (A != 0) {
    const Rational late = -B - A;
    hits = D >= 0 && (late <= 0 || late * late <= D) && (B <= 0 || B * B <= D);
  }
  const auto kept = exact_decision(s, c);
  require(kept.has_value() == hits, "kept exactly when there is a common point");
  const auto back = exact_decision(Segment<2, T>{s.b, s.a}, c);
  require(back.has_value() == hits, "the reverse is kept as well");
  if (!kept) return;
  require(back->a == kept->b && back->b == kept->a, "the reverse is the reverse");
  if (from_side <= 0) require(kept->a == s.a, "an end inside stays");
  if (to_side <= 0) require(kept->b == s.b, "an end inside stays");
  for (const bool leaves : {false, true}) {
    if ((leaves ? to_side : from_side) <= 0) continue;
    const auto got = leaves ? kept->b : kept->a;
    const Wide root = (leaves ? 1 : -1) * sqrt(Wide(D));
    const Wide x = Wide(Rational(ax - B / A * dx)) + root * Wide(dx) / Wide(A);
    const Wide y = Wide(Rational(ay - B / A * dy)) + root * Wide(dy) / Wide(A);
    require(error_of(got.x, x, c.radius) <= 0.63, "x is right to 0.63 ulp");
    require(error_of(got.y, y, c.radius) <= 0.63, "y is right to 0.63 ulp");
    require(std::min(s.a.x, s.b.x) <= got.x && got.x <= std::max(s.a.x, s.b.x) &&
                std::min(s.a.y, s.b.y) <= got.y && got.y <= std::max(s.a.y, s.b.y),
            "the point lies in the segment's box");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  static constexpr int reaches[]{30, 200, 1020};
  const int reach = reaches[input.below(3)];
  Segment<2, double> s;
  Circle<double> c;
  s.a = input.point(-reach - 54, reach);
  s.b = input.point(-reach - 54, reach);
  c.centre = input.point(-reach - 54, reach);
  c.radius = std::abs(input.number(-reach - 54, reach));
  const int kind = input.below(6);
  if (kind == 0) c.radius = std::hypot(s.a.x - c.centre.x, s.a.y - c.centre.y);
  if (kind == 1) c.radius = std::abs(s.a.y - c.centre.y), s.b.y = s.a.y;
  if (kind == 2) {  // tangent to 3-4-5, exactly where numbers are small
    c.centre = {};
    const double p = input.below(64), q = input.below(64);
    c.radius = 5;
    s = {{3 - 4 * p, 4 + 3 * p}, {3 + 4 * q, 4 - 3 * q}};
    for (int i = input.below(3); i > 0; --i) c.radius = std::nextafter(c.radius, input.coin() ? 0.0 : 9.0);
  }
  if (!std::isfinite(c.radius)) c.radius = 1;
  compare(s, c);
  if (reach > 30) return 0;
  compare(Segment<2, float>{glm::vec2(s.a), glm::vec2(s.b)},
          Circle<float>{glm::vec2(c.centre), static_cast<float>(c.radius)});
  return 0;
}
