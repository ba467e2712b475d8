// sin … pow: special values as C has them, all others against 100 digits.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/elementary.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;
using Reference = boost::multiprecision::cpp_bin_float_100;
using Huge = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1500, boost::multiprecision::digit_base_2>>;

namespace {

/// Domain: exact is in the range of double.
void check(double result, const Reference& exact, const char* what) {
  const Reference largest = std::numeric_limits<double>::max();
  if (abs(exact) >= largest) {
    require(std::isinf(result) || std::abs(result) == std::numeric_limits<double>::max(), what);
    return;
  }
  const int exponent = exact == 0 ? -1074 : std::max(ilogb(exact) - 52, -1074);
  require(static_cast<double>(abs(Reference(result) - exact) / ldexp(Reference(1), exponent)) < 0.501, what);
}

/// Where C's own functions give no number, an infinity or a zero, ours give the same.
bool special(double ours, double theirs, const char* what) {
  if (!std::isnan(theirs) && !std::isinf(theirs) && theirs != 0) return false;
  if (std::isnan(theirs)) {
    require(std::isnan(ours), what);
  } else if (std::isinf(theirs)) {
    // Near the end of the range theirs may round otherwise
    require(ours == theirs || std::abs(ours) > 0x1.ffffffffffffp1023, what);
  } else {
    require(std::abs(ours) <= 0x1p-1074 && std::signbit(ours) == std::signbit(theirs), what);
  }
  return true;
}

Reference without_turns(double x) {
  static const Huge turn = 2 * boost::math::constants::pi<Huge>();
  const Huge turns = round(Huge(x) / turn);
  return Reference(Huge(x) - turns * turn);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const int which = input.below(12);
  const double x = input.any_number(), y = input.any_number();
  switch (which) {
    case 0:
      if (!special(gradus::sin(x), std::sin(x), "sin")) check(gradus::sin(x), sin(without_turns(x)), "sin");
      break;
    case 1:
      if (!special(gradus::cos(x), std::cos(x), "cos")) check(gradus::cos(x), cos(without_turns(x)), "cos");
      break;
    case 2:
      if (!special(gradus::tan(x), std::tan(x), "tan")) check(gradus::tan(x), tan(without_turns(x)), "tan");
      break;
    case 3: {
      const SinCos both = sin_cos_degrees(x);
      if (!std::isfinite(x)) {
        require(std::isnan(both.sin) && std::isnan(both.cos), "degrees");
        break;
      }
      const Huge degree = boost::math::constants::pi<Huge>() / 180;
      const Reference angle = Reference(Huge(std::fmod(x, 360.0)) * degree);
      const bool quarter = std::fmod(x, 90.0) == 0;
      if (quarter) {
        require((both.sin == 0 || both.cos == 0) && std::abs(both.sin + both.cos) == 1, "quarters are exact");
        require(!(both.sin == 0 && std::signbit(both.sin)) && !(both.cos == 0 && std::signbit(both.cos)),
                "zeros are positive");
      } else {
        check(both.sin, sin(angle), "sine of degrees");
        check(both.cos, cos(angle), "cosine of degrees");
      }
      break;
    }
    case 4:
      if (!special(gradus::asin(x), std::asin(x), "asin")) check(gradus::asin(x), asin(Reference(x)), "asin");
      break;
    case 5:
      if (!special(gradus::acos(x), std::acos(x), "acos")) check(gradus::acos(x), acos(Reference(x)), "acos");
      break;
    case 6:
      if (!special(gradus::atan(x), std::atan(x), "atan") && std::isfinite(x)) {
        check(gradus::atan(x), atan(Reference(x)), "atan");
      }
      break;
    case 7:
      if (special(gradus::atan2(y, x), std::atan2(y, x), "atan2")) break;
      if (std::isfinite(x) && std::isfinite(y)) {
        check(gradus::atan2(y, x), atan2(Reference(y), Reference(x)), "atan2");
      } else {
        require(std::abs(gradus::atan2(y, x) - std::atan2(y, x)) <= 0x1p-50, "atan2");
      }
      break;
    case 8:
      if (!special(gradus::exp(x), std::exp(x), "exp")) check(gradus::exp(x), exp(Reference(x)), "exp");
      break;
    case 9:
      if (!special(gradus::log(x), std::log(x), "log")) check(gradus::log(x), log(Reference(x)), "log");
      break;
    case 10:
      if (special(gradus::pow(x, y), std::pow(x, y), "pow")) break;
      if (std::isfinite(x) && std::isfinite(y)) {
        const Reference positive = pow(Reference(std::abs(x)), Reference(y));
        const bool negative = x < 0 && std::fmod(y, 2.0) != 0;
        check(gradus::pow(x, y), negative ? Reference(-positive) : positive, "pow");
      } else {
        require(gradus::pow(x, y) == std::pow(x, y), "pow");
      }
      break;
    default:
      if (std::isfinite(x)) {
        const Huge degree = boost::math::constants::pi<Huge>() / 180;
        check(radians_from_degrees(x), Reference(Huge(x) * degree), "radians");
      }
  }
  return 0;
}
