#pragma once
// Counted: a double that counts what is calculated with it, as a scalar for the numeric topics. It says what
// a method costs on an input, whatever the machine.

#include <compare>
#include <cstdint>
#include <limits>

#include "core/language.hpp"

namespace gradus {

struct Operations {
  std::int64_t additions = 0;  ///< and subtractions
  std::int64_t products = 0;
  std::int64_t divisions = 0;

  constexpr std::int64_t all() const { return additions + products + divisions; }
  friend constexpr bool operator==(const Operations&, const Operations&) = default;
};

/// A double whose additions, products and divisions are counted, for each thread by itself; signs,
/// comparisons and copies are not.
///
/// Accuracy: as double, rounding for rounding.
class Counted {
 public:
  Counted() = default;  ///< without a value, as GLM's unions need; Counted{} is 0
  constexpr Counted(double value) : value_(value) {}

  constexpr double value() const { return value_; }

  friend Counted operator+(Counted a, Counted b) { return ++count().additions, Counted(a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return ++count().additions, Counted(a.value_ - b.value_); }
  friend Counted operator*(Counted a, Counted b) { return ++count().products, Counted(a.value_ * b.value_); }
  friend Counted operator/(Counted a, Counted b) { return ++count().divisions, Counted(a.value_ / b.value_); }
  Counted operator-() const { return {-value_}; }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  Counted& operator/=(Counted b) { return *this = *this / b; }
  friend constexpr auto operator<=>(const Counted&, const Counted&) = default;

  /// What was calculated on this thread so far.
  static Operations& count() {
    thread_local Operations operations;
    return operations;
  }

 private:
  double value_;
};

/// What `work` calculates with Counted.
template <class Work>
Operations operations_of(Work&& work) {
  const Operations before = Counted::count();
  work();
  const Operations after = Counted::count();
  return {after.additions - before.additions, after.products - before.products,
          after.divisions - before.divisions};
}

}  // namespace gradus

/// As GLM asks of a scalar; it must see this before its first vector of Counted.
template <>
class std::numeric_limits<gradus::Counted> : public std::numeric_limits<double> {};
