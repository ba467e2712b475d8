#pragma once
// Floating-point numbers whose exponents have no bounds: for formulas whose result is an ordinary number
// while a product on the way to it would overflow or vanish.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>

#include "core/language.hpp"

namespace gradus {

/// digits * 2^exponent, where 1/2 <= |digits| < 1, or 0. Domain: made from finite numbers; up to 2^18
/// multiplications and divisions in a row. Accuracy: each operation rounds as that of T does while T neither
/// overflows nor underflows, and so gives the same bits. Cost: some ns per operation.
template <std::floating_point T>
class Unbounded {
 public:
  explicit Unbounded(T x) : digits_(std::frexp(x, &exponent_)) {}

  /// The number of T: infinite beyond its range, and rounded once more among its subnormals.
  T in_range() const { return std::scalbn(digits_, exponent_); }

  friend Unbounded operator-(Unbounded a) {
    a.digits_ = -a.digits_;
    return a;
  }
  friend Unbounded operator+(Unbounded a, Unbounded b) {
    // The larger one first; 0 has no size
    if (a.digits_ == 0 || (b.digits_ != 0 && a.exponent_ < b.exponent_)) std::swap(a, b);
    return Unbounded(a.digits_ + std::scalbn(b.digits_, b.exponent_ - a.exponent_), a.exponent_);
  }
  friend Unbounded operator-(Unbounded a, Unbounded b) { return a + -b; }
  friend Unbounded operator*(Unbounded a, Unbounded b) {
    return Unbounded(a.digits_ * b.digits_, a.exponent_ + b.exponent_);
  }
  /// Domain: b is not 0.
  friend Unbounded operator/(Unbounded a, Unbounded b) {
    return Unbounded(a.digits_ / b.digits_, a.exponent_ - b.exponent_);
  }
  friend bool operator<(Unbounded a, Unbounded b) { return (a - b).digits_ < 0; }
  friend bool operator>(Unbounded a, Unbounded b) { return b < a; }
  friend Unbounded abs(Unbounded a) {
    a.digits_ = std::abs(a.digits_);
    return a;
  }

 private:
  Unbounded(T digits, int exponent) : Unbounded(digits) { exponent_ += exponent; }

  int exponent_ = 0;
  T digits_;
};

/// A number without bounds to its size: for a scalar without bounds (gradus::Exact), the number itself.
template <class T>
auto unbounded(const T& x) {
  if constexpr (std::floating_point<T>) {
    return Unbounded<T>(x);
  } else {
    return x;
  }
}

/// The number of T again.
template <class T>
T in_range(const Unbounded<T>& x) {
  return x.in_range();
}
template <class T>
const T& in_range(const T& x) {
  return x;
}

}  // namespace gradus
