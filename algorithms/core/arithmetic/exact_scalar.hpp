#pragma once
// Exact: a rational number without rounding, as a scalar for the numeric topics, which are templates over
// float, double and Exact. It fits into GLM's vectors and matrices. No sqrt, sin, …: they are not rational.
//
// GLM must see the numeric_limits below before its first vector of Exact; this header sees to that, whether
// it or GLM is included first. The numbers themselves live behind exact_scalar.cpp.

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "core/language.hpp"

namespace gradus {

/// A handle to a rational number of any size; trivially copyable, 16 bytes.
///
/// Each result takes a place in an arena of its thread until the innermost ExactScope around it ends. Values
/// made outside any scope stay until their thread ends. A handle that outlives its scope or comes from
/// another thread is refused when used (ContractViolation). Exact{} is 0 and valid everywhere.
///
/// Source of the arithmetic: Boost.Multiprecision, cpp_rational.
/// Accuracy: exact. Cost: about 0.3 us per operation, growing with the digits.
class Exact {
 public:
  /// Left without a value, as GLM's unions need (reading it is a mistake); Exact{} is 0.
  Exact() = default;

  /// The same number, exactly. Domain: every integer and every finite float and double (others are refused).
  template <std::signed_integral Integer>
  Exact(Integer value) : Exact(from_signed(value)) {}
  template <std::unsigned_integral Integer>
    requires(!std::same_as<Integer, bool>)
  Exact(Integer value) : Exact(from_unsigned(value)) {}
  Exact(float value) : Exact(double{value}) {}
  Exact(double value);

  /// numerator / denominator. Domain: denominator not 0 (refused).
  Exact(std::int64_t numerator, std::int64_t denominator);

  friend Exact operator+(Exact a, Exact b);
  friend Exact operator-(Exact a, Exact b);
  friend Exact operator*(Exact a, Exact b);
  /// Domain: b not 0 (refused).
  friend Exact operator/(Exact a, Exact b);
  friend Exact operator+(Exact a) { return a; }
  friend Exact operator-(Exact a);

  Exact& operator+=(Exact b) { return *this = *this + b; }
  Exact& operator-=(Exact b) { return *this = *this - b; }
  Exact& operator*=(Exact b) { return *this = *this * b; }
  Exact& operator/=(Exact b) { return *this = *this / b; }

  friend bool operator==(Exact a, Exact b);
  friend std::strong_ordering operator<=>(Exact a, Exact b);

  /// The nearest double, as to_double.
  explicit operator double() const;

 private:
  friend class ExactArena;
  Exact(std::uint64_t index, std::uint64_t stamp, std::nullptr_t) : index_(index), stamp_(stamp) {}
  static Exact from_signed(std::int64_t value);
  static Exact from_unsigned(std::uint64_t value);

  std::uint64_t index_;
  std::uint64_t stamp_;  // the same number stands in the arena as long as the value does
};

/// Frees, when it ends, every Exact that its thread made since it began. Scopes nest.
class ExactScope {
 public:
  ExactScope();
  ~ExactScope();
  ExactScope(const ExactScope&) = delete;
  ExactScope& operator=(const ExactScope&) = delete;

  /// Ends the scope early and hands this value to the scope around it: `return scope.leave_with(area);`
  /// Domain: once per scope, the innermost one (refused otherwise).
  Exact leave_with(Exact result);
  /// The same for several values, replaced in place.
  void leave_with(std::span<Exact> results);

 private:
  std::size_t begin_;
  std::size_t depth_;
  bool open_ = true;
};

/// Number of values alive in this thread's arena, the permanent 0 not counted; for tests.
std::size_t exact_values_alive();

/// The nearest double, ties to even; ±infinity beyond the range, subnormals rounded once. Accuracy: 1/2 ulp.
double to_double(Exact x);

/// -1, 0 or +1.
int sign(Exact x);
Exact abs(Exact x);

/// The greatest integer <= x, the least integer >= x.
/// Domain: the result fits into 64 bits (refused otherwise).
std::int64_t floor(Exact x);
std::int64_t ceil(Exact x);

/// "p/q" in lowest terms with q > 1, or "p" for an integer.
std::string to_string(Exact x);

}  // namespace gradus

/// What GLM asks of a scalar. is_iec559 is not true to the letter: GLM's dot, cross and determinant accept
/// only types that say so, meaning "not an integer". Functions without a meaning here (epsilon, max, …) give
/// 0.
template <>
class std::numeric_limits<gradus::Exact> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = true;
  static constexpr bool is_iec559 = true;
  static constexpr bool is_bounded = false;
  static constexpr bool is_modulo = false;
  static constexpr bool has_infinity = false;
  static constexpr bool has_quiet_NaN = false;
  static constexpr bool has_signaling_NaN = false;
  static constexpr bool traps = false;
  static constexpr bool tinyness_before = false;
  static constexpr std::float_round_style round_style = std::round_toward_zero;
  static constexpr int digits = 0, digits10 = 0, max_digits10 = 0, radix = 2;
  static constexpr int min_exponent = 0, min_exponent10 = 0, max_exponent = 0, max_exponent10 = 0;

  static gradus::Exact min() { return gradus::Exact{}; }
  static gradus::Exact max() { return gradus::Exact{}; }
  static gradus::Exact lowest() { return gradus::Exact{}; }
  static gradus::Exact epsilon() { return gradus::Exact{}; }
  static gradus::Exact round_error() { return gradus::Exact{}; }
  static gradus::Exact infinity() { return gradus::Exact{}; }
  static gradus::Exact quiet_NaN() { return gradus::Exact{}; }
  static gradus::Exact signaling_NaN() { return gradus::Exact{}; }
  static gradus::Exact denorm_min() { return gradus::Exact{}; }
};

// Only now GLM, and what includes it
#include "core/arithmetic/exact.hpp"

namespace gradus {

using ExactVec2 = glm::vec<2, Exact>;
using ExactVec3 = glm::vec<3, Exact>;

/// The sign of the doubled area of a, b, c: +1 counter-clockwise, as for double (see
/// core/arithmetic/exact.hpp).
inline int orient2d(const ExactVec2& a, const ExactVec2& b, const ExactVec2& c) {
  const ExactVec2 p = b - a, q = c - a;
  return sign(p.x * q.y - p.y * q.x);
}

/// The side of the plane a, b, c on which d lies: +1 where the normal points, as for double.
inline int orient3d(const ExactVec3& a, const ExactVec3& b, const ExactVec3& c, const ExactVec3& d) {
  const ExactVec3 p = b - a, q = c - a, r = d - a;
  return sign(r.x * (p.y * q.z - p.z * q.y) + r.y * (p.z * q.x - p.x * q.z) + r.z * (p.x * q.y - p.y * q.x));
}

}  // namespace gradus
