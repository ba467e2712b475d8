#pragma once
// Where a segment meets a disc, exactly but for the last bits of a long root: the oracle of what clips at
// circles.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>

#include "stress/domain.hpp"

namespace gradus::stress {

/// A point that no number of type T may name, to be compared with ones that do.
template <class T>
class Place {
 public:
  template <class Wide>
  Place(const Wide& x, const Wide& y, T radius) : x_(part_of(x, radius)), y_(part_of(y, radius)) {}

  /// How far a point is from it along the axes, in ulp of max(abs(coordinate), radius); `wrong` for what is
  /// no number.
  double error(glm::vec<2, T> p) const {
    const double x = x_.error(p.x), y = y_.error(p.y);
    return std::isnan(x) || std::isnan(y) ? wrong : std::max(x, y);
  }

 private:
  struct Part {
    double near, unit, rest;  ///< near + rest * unit
    double error(double x) const { return std::abs((x - near) / unit - rest); }
  };
  template <class Wide>
  static Part part_of(const Wide& x, T radius) {
    const auto near = x.template convert_to<T>();
    const T size = std::max(std::abs(near), radius);
    T unit = std::nextafter(size, std::numeric_limits<T>::infinity()) - size;
    // At the largest numbers there is no next one
    if (!std::isfinite(unit)) unit = size - std::nextafter(size, T(0));
    return {double{near}, double{unit}, Wide((x - Wide(near)) / Wide(unit)).template convert_to<double>()};
  }
  Part x_, y_;
};

/// What a segment and a disc have in common.
template <class T>
struct EndsInCircle {
  Place<T> from, to;
  bool from_is_given, to_is_given;  ///< the segment's own end
  bool runs;                        ///< in the open disc: more than a point of the circle
};

using Integer = boost::multiprecision::cpp_int;

namespace detail {

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
  return shift >= 0 ? Integer(Integer(digits) << shift) : Integer(Integer(digits) >> -shift);
}

}  // namespace detail

/// |from + t d - centre|^2 = r^2 as A t^2 + 2 B t + C = 0, all numbers whole in units of 2^unit.
struct WholeQuadratic {
  int unit;
  Integer x, y, dx, dy;
  Integer A, B, C, D, end;  ///< D = B^2 - A C; end: what C is for the other end

  /// Of {from, to, centre, radius}, finite.
  explicit WholeQuadratic(const Input& i) : unit(detail::unit_of(i)) {
    const auto n = [&](std::size_t k) { return detail::whole(i[k], unit); };
    x = n(0), y = n(1), dx = n(2) - x, dy = n(3) - y;
    const Integer fx = x - n(4), fy = y - n(5), r = n(6);
    A = dx * dx + dy * dy, B = fx * dx + fy * dy, C = fx * fx + fy * fy - r * r;
    D = B * B - A * C, end = A + 2 * B + C;
  }
  bool foot_between() const { return B < 0 && -B < A; }
  /// Whether the segment runs in the open disc: more than a point of the circle.
  bool runs() const { return A != 0 && (C < 0 || end < 0 || (D > 0 && foot_between())); }
  /// Whether segment and disc have a point in common.
  bool meet() const { return A == 0 ? C <= 0 : D >= 0 && (C <= 0 || end <= 0 || foot_between()); }
};

namespace detail {

template <class T, unsigned bits>
EndsInCircle<T> ends_in_circle(const WholeQuadratic& q, const Input& i) {
  using Wide = boost::multiprecision::number<
      boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2, void, std::int32_t>>;
  const bool from_is_given = q.C <= 0, to_is_given = q.end <= 0;
  const T radius = static_cast<T>(i[6]);
  const Wide root = from_is_given && to_is_given ? Wide(0) : Wide(sqrt(Wide(q.D)));
  const auto point = [&](const Wide& way) {
    const Wide t = way / Wide(q.A);
    return Place<T>(Wide(ldexp(Wide(Wide(q.x) + t * Wide(q.dx)), q.unit)),
                    Wide(ldexp(Wide(Wide(q.y) + t * Wide(q.dy)), q.unit)), radius);
  };
  const auto given = [&](std::size_t k) { return Place<T>(Wide(i[k]), Wide(i[k + 1]), radius); };
  return {from_is_given ? given(0) : point(-Wide(q.B) - root),
          to_is_given ? given(2) : point(-Wide(q.B) + root), from_is_given, to_is_given, q.runs()};
}

}  // namespace detail

/// Of {from, to, centre, radius}, finite. With b bits a point is off by less than 2^(20 - b) of the largest
/// coordinate, so these are enough to tell it to 2^-300 of a unit in the last place of the answer.
template <class T = double>
std::optional<EndsInCircle<T>> ends_in_circle(const Input& i) {
  const WholeQuadratic q(i);
  if (!q.meet()) return std::nullopt;
  const auto is_moderate = [](double x) {
    return x == 0 || (0x1p-100 < std::abs(x) && std::abs(x) < 0x1p100);
  };
  return std::ranges::all_of(i, is_moderate) && i[6] > 0 ? detail::ends_in_circle<T, 500>(q, i)
                                                         : detail::ends_in_circle<T, 2500>(q, i);
}

}  // namespace gradus::stress
