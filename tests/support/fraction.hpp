#pragma once
// Exact numbers for oracles that take few steps: as rationals, but never reduced, which saves most of the
// time, and with the power of two apart, so that the sizes of doubles cost nothing.

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstdint>
#include <stdexcept>

namespace gradus::test {

/// above / below * 2^exponent. Grows with every step.
class Fraction {
 public:
  using Integer = boost::multiprecision::cpp_int;

  Fraction(int x = 0) : above_(x) {}
  /// Domain: finite; what is not throws.
  template <std::floating_point T>
  Fraction(T x) {
    if (!std::isfinite(x)) throw std::domain_error("a number that is not finite is no fraction");
    if (x == 0) return;
    auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(double{x}, &exponent_), 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(digits));
    above_ = digits >> zeros;
    exponent_ += zeros - 53;
  }

  int sign() const { return above_.sign(); }

  friend Fraction operator-(const Fraction& a) { return {-a.above_, a.below_, a.exponent_}; }
  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    const Integer x = a.above_ << (a.exponent_ - exponent), y = b.above_ << (b.exponent_ - exponent);
    if (a.below_ == b.below_) return {x + y, a.below_, exponent};
    return {x * b.below_ + y * a.below_, a.below_ * b.below_, exponent};
  }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return {a.above_ * b.above_, a.below_ * b.below_, a.exponent_ + b.exponent_};
  }
  /// Domain: b is not 0.
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    const Fraction inverse{b.sign() < 0 ? Integer(-b.below_) : b.below_, abs(b.above_), -b.exponent_};
    return a * inverse;
  }
  Fraction& operator+=(const Fraction& b) { return *this = *this + b; }

  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return (a.sign() == b.sign() ? (a - b).sign() : a.sign() - b.sign()) <=> 0;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) { return (a <=> b) == 0; }
  friend Fraction abs(const Fraction& a) { return a.sign() < 0 ? -a : a; }

  /// Within an ulp.
  explicit operator double() const {
    if (sign() == 0) return 0;
    const Integer size = abs(above_);
    const int more = 70 + static_cast<int>(msb(below_)) - static_cast<int>(msb(size));
    const Integer quotient = more >= 0 ? Integer((size << more) / below_) : Integer(size / (below_ << -more));
    return sign() * std::ldexp(quotient.convert_to<double>(), exponent_ - more);
  }

 private:
  Fraction(Integer above, Integer below, int exponent)
      : above_(std::move(above)), below_(std::move(below)), exponent_(exponent) {}

  Integer above_ = 0, below_ = 1;  // below_ is above 0
  int exponent_ = 0;
};

}  // namespace gradus::test
