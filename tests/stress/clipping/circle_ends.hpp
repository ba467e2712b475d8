#pragma once
// Where a segment meets a disc, exactly but for the last bits of a long root: the oracle of what clips at
// circles.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "stress/domain.hpp"

namespace gradus::stress {

/// A point that no double may name, to be compared with ones that do.
class Place {
 public:
  template <class Wide>
  Place(const Wide& x, const Wide& y, double radius) : x_(part_of(x, radius)), y_(part_of(y, radius)) {}

  /// How far a point is from it along the axes, in ulp of max(abs(coordinate), radius).
  double error(glm::dvec2 p) const { return std::max(x_.error(p.x), y_.error(p.y)); }

 private:
  struct Part {
    double near, unit, rest;  ///< near + rest * unit
    double error(double x) const { return std::abs((x - near) / unit - rest); }
  };
  template <class Wide>
  static Part part_of(const Wide& x, double radius) {
    const auto near = x.template convert_to<double>();
    const double size = std::max(std::abs(near), radius);
    double unit = std::nextafter(size, wrong) - size;
    // At the largest numbers there is no next one
    if (!std::isfinite(unit)) unit = size - std::nextafter(size, 0.0);
    return {near, unit, Wide((x - Wide(near)) / Wide(unit)).template convert_to<double>()};
  }
  Part x_, y_;
};

/// What a segment and a disc have in common.
struct EndsInCircle {
  Place from, to;
  bool from_is_given, to_is_given;  ///< the segment's own end
  bool runs;                        ///< in the open disc: more than a point of the circle
};

namespace detail {

template <unsigned bits>
std::optional<EndsInCircle> ends_in_circle(const Input& i) {
  using Rational = boost::multiprecision::cpp_rational;
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2>>;
  const Rational dx = Rational(i[2]) - Rational(i[0]), dy = Rational(i[3]) - Rational(i[1]);
  const Rational fx = Rational(i[0]) - Rational(i[4]), fy = Rational(i[1]) - Rational(i[5]);
  const Rational r(i[6]), A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
  const Rational D = B * B - A * C, end = A + 2 * B + C;  // end: the sign of the other end
  const bool from_is_given = C <= 0, to_is_given = end <= 0, foot_between = B < 0 && -B < A;
  if (A == 0 ? C > 0 : D < 0 || (!from_is_given && !to_is_given && !foot_between)) return std::nullopt;
  const auto wide = [](const Rational& x) { return Wide(numerator(x)) / Wide(denominator(x)); };
  const bool all_given = from_is_given && to_is_given;
  const Wide root = all_given ? Wide(0) : Wide(sqrt(wide(D)));
  const auto point = [&](const Wide& way) {
    const Wide t = way / wide(A);
    return Place(Wide(i[0]) + t * wide(dx), Wide(i[1]) + t * wide(dy), i[6]);
  };
  const auto given = [&](std::size_t k) { return Place(Wide(i[k]), Wide(i[k + 1]), i[6]); };
  return EndsInCircle{from_is_given ? given(0) : point(-wide(B) - root),
                      to_is_given ? given(2) : point(-wide(B) + root), from_is_given, to_is_given,
                      A != 0 && (C < 0 || end < 0 || (D > 0 && foot_between))};
}

}  // namespace detail

/// Of {from, to, centre, radius}, finite. Roots have enough bits for any exact number that doubles make here.
inline std::optional<EndsInCircle> ends_in_circle(const Input& i) {
  const auto is_moderate = [](double x) {
    return x == 0 || (0x1p-100 < std::abs(x) && std::abs(x) < 0x1p100);
  };
  return std::all_of(i.begin(), i.end(), is_moderate) ? detail::ends_in_circle<2500>(i)
                                                      : detail::ends_in_circle<9000>(i);
}

}  // namespace gradus::stress
