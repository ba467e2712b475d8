#pragma once
// Where a segment meets a disc, exactly but for the last bits of a long root: the oracle of what clips at
// circles.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "stress/domain.hpp"

namespace gradus::stress {

/// A point that no double may name, to be compared with ones that do.
class Place {
 public:
  template <class Wide>
  Place(const Wide& x, const Wide& y, double radius) : x_(part_of(x, radius)), y_(part_of(y, radius)) {}

  /// How far a point is from it along the axes, in ulp of max(abs(coordinate), radius); `wrong` for what is
  /// no number.
  double error(glm::dvec2 p) const {
    const double x = x_.error(p.x), y = y_.error(p.y);
    return std::isnan(x) || std::isnan(y) ? wrong : std::max(x, y);
  }

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

using Integer = boost::multiprecision::cpp_int;

/// The exponent of the lowest bit of any of these numbers: all of them are whole in units of 2^that.
inline int unit_of(const Input& i) {
  int lowest = 0;
  for (const double x : i) {
    if (x != 0) lowest = std::min(lowest, std::max(-1074, std::ilogb(x) - 52));
  }
  return lowest;
}
/// x in units of 2^exponent.
inline Integer whole(double x, int exponent) {
  int of_x = 0;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &of_x), 53));
  const int shift = of_x - 53 - exponent;
  return shift >= 0 ? Integer(digits) << shift : Integer(digits) >> -shift;
}

template <unsigned bits>
std::optional<EndsInCircle> ends_in_circle(const Input& i) {
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2, void, std::int32_t>>;
  const int unit = unit_of(i);
  std::array<Integer, 7> n;
  std::transform(i.begin(), i.end(), n.begin(), [unit](double x) { return whole(x, unit); });
  const Integer dx = n[2] - n[0], dy = n[3] - n[1], fx = n[0] - n[4], fy = n[1] - n[5], r = n[6];
  const Integer A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
  const Integer D = B * B - A * C, end = A + 2 * B + C;  // end: the sign of the other end
  const bool from_is_given = C <= 0, to_is_given = end <= 0, foot_between = B < 0 && -B < A;
  if (A == 0 ? C > 0 : D < 0 || (!from_is_given && !to_is_given && !foot_between)) return std::nullopt;
  const bool all_given = from_is_given && to_is_given;
  const Wide root = all_given ? Wide(0) : Wide(sqrt(Wide(D)));
  const auto point = [&](const Wide& way) {
    const Wide t = way / Wide(A);
    return Place(Wide(ldexp(Wide(Wide(n[0]) + t * Wide(dx)), unit)),
                 Wide(ldexp(Wide(Wide(n[1]) + t * Wide(dy)), unit)), i[6]);
  };
  const auto given = [&](std::size_t k) { return Place(Wide(i[k]), Wide(i[k + 1]), i[6]); };
  return EndsInCircle{from_is_given ? given(0) : point(-Wide(B) - root),
                      to_is_given ? given(2) : point(-Wide(B) + root), from_is_given, to_is_given,
                      A != 0 && (C < 0 || end < 0 || (D > 0 && foot_between))};
}

}  // namespace detail

/// Of {from, to, centre, radius}, finite. With b bits a point is off by less than 2^(20 - b) of the largest
/// coordinate, so these are enough to tell it to 2^-300 of a unit in the last place of whatever is asked.
inline std::optional<EndsInCircle> ends_in_circle(const Input& i) {
  const auto is_moderate = [](double x) {
    return x == 0 || (0x1p-100 < std::abs(x) && std::abs(x) < 0x1p100);
  };
  return std::all_of(i.begin(), i.end(), is_moderate) && i[6] > 0 ? detail::ends_in_circle<500>(i)
                                                                  : detail::ends_in_circle<2500>(i);
}

}  // namespace gradus::stress
