#pragma once
// Judging by exact rationals, answers in float as well as in double; and inputs for what must hold exactly.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/arithmetic/finite.hpp"
#include "core/arithmetic/turn.hpp"
#include "core/contract.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {

/// So many numbers of a kind.
inline Input numbers_of(Kind kind, Random& random, std::size_t count) {
  Input input(count);
  for (double& x : input) x = number(kind, random);
  return input;
}

// --- Float and double ------------------------------------------------------------------------------------

/// The number in float; what is far from 1 comes nearer, so that all of double's sizes give all of float's.
inline float as_float(double x) {
  constexpr double largest = std::numeric_limits<float>::max();
  if (!std::isfinite(x)) return static_cast<float>(x);
  constexpr int usual = 20, nearer = 9;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  if (std::abs(exponent) > usual) {
    const int beyond = (std::abs(exponent) - usual) / nearer;
    exponent = exponent < 0 ? -usual - beyond : usual + beyond;
  }
  return static_cast<float>(std::clamp(std::ldexp(mantissa, exponent), -largest, largest));
}

inline std::vector<float> as_floats(const Input& input) {
  std::vector<float> numbers(input.size());
  std::ranges::transform(input, numbers.begin(), as_float);
  return numbers;
}

inline bool all_finite(const std::vector<float>& numbers) {
  return std::ranges::all_of(numbers, [](float x) { return std::isfinite(x); });
}

/// The larger error of the two: `judge` takes the numbers in double, and in float.
template <class Judge>
std::function<double(const Input&)> in_both(Judge judge) {
  return [judge](const Input& input) {
    const ExactScope scope;
    return std::max(judge(input), judge(as_floats(input)));
  };
}

/// What a call gives; nothing where it refuses its arguments.
template <class Call>
auto accepted(Call call) -> std::optional<decltype(call())> {
  try {
    return call();
  } catch (const ContractViolation&) {
    return std::nullopt;
  }
}

// --- Errors ----------------------------------------------------------------------------------------------

template <class T>
glm::vec<3, T> vector_in(const std::vector<T>& numbers, std::size_t from) {
  return {numbers[from], numbers[from + 1], numbers[from + 2]};
}

/// The rounding unit u of T: half of the step from 1 to the next number.
template <class T>
Exact rounding_unit() {
  return Exact(std::numeric_limits<T>::epsilon() / 2);
}

/// From |x| to the next number of T, among the subnormal ones, too.
template <class T>
Exact ulp_of(const Exact& x) {
  using Limits = std::numeric_limits<T>;
  const int exponent = std::max(std::ilogb(to_double(x)), Limits::min_exponent - 1);
  return Exact(std::ldexp(1.0, exponent + 1 - Limits::digits));
}

/// Whether T has no number so large.
template <class T>
bool overflows(const Exact& x) {
  return std::abs(to_double(x)) > std::numeric_limits<T>::max();
}

/// Whether a product or a quotient is 0, or a normal number of T.
template <class T>
bool fits(const Exact& x) {
  const double size = std::abs(to_double(x));
  return (std::numeric_limits<T>::min() <= size && size <= std::numeric_limits<T>::max() / 4) || sign(x) == 0;
}

/// An error as a share of what is allowed.
inline double in_bounds(const Exact& error, const Exact& bound) {
  if (sign(error) == 0) return 0;
  if (sign(bound) == 0) return wrong;
  // Mostly doubles hold both: no rational need be reduced
  const double off = to_double(error), most = to_double(bound);
  const bool held = std::min(off, most) > 0x1p-960 && std::max(off, most) < 0x1p1020;
  return held ? off / most : to_double(error / bound);
}

// --- What holds exactly ----------------------------------------------------------------------------------

/// Small fractions of few digits, zeros among them.
inline double small_fraction(Kind kind, Random& random) {
  if (kind == Kind::ties) return static_cast<double>(random.uniform_int(-4, 4));
  return std::ldexp(static_cast<double>(random.uniform_int(-40, 40)),
                    -static_cast<int>(random.uniform_int(0, 3)));
}
inline Input small_fractions(std::size_t count, Kind kind, Random& random) {
  Input input(count);
  for (double& x : input) x = small_fraction(kind, random);
  return input;
}

/// Whether exact arithmetic with these numbers takes a bounded time.
inline bool of_moderate_size(const Input& input) {
  return std::ranges::all_of(
      input, [](double x) { return x == 0 || (0x1p-20 <= std::abs(x) && std::abs(x) <= 0x1p20); });
}

/// A relation between exact numbers as a promise.
inline Property exact_relation(std::string name, std::string states, std::size_t numbers,
                               std::function<bool(const Input&)> holds,
                               std::function<Input(Kind, Random&)> generate = {}) {
  if (!generate) generate = [=](Kind kind, Random& random) { return small_fractions(numbers, kind, random); };
  const auto error = [holds](const Input& input) {
    if (!of_moderate_size(input)) return 0.0;
    const ExactScope scope;
    return holds(input) ? 0.0 : wrong;
  };
  return {.name = std::move(name),
          .states = "in exact arithmetic " + std::move(states),
          .numbers = numbers,
          .kinds = {Kind::random, Kind::ties},
          .generate = std::move(generate),
          .error = error};
}

/// ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) lies on the unit circle for every rational t.
inline Turn<Exact> rational_turn(const Exact& t) {
  const Exact one(1), square = t * t;
  return turn_of(Exact(2) * t / (one + square), (one - square) / (one + square));
}

}  // namespace gradus::stress
