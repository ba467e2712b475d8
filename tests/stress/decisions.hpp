#pragma once
// A decision by a sign: the exact one in double, in float and in exact arithmetic, refused where a number is
// none, the same observed. The numbers of an input are read by functions of their type, vector<T>.

#include <algorithm>
#include <concepts>
#include <utility>
#include <vector>

#include "stress/exactly.hpp"

namespace gradus::stress {

/// The numbers as those of another type, as they are.
template <class T>
std::vector<T> numbers_in(const Input& input) {
  std::vector<T> numbers;
  for (const double x : input) numbers.push_back(static_cast<T>(x));
  return numbers;
}
/// Points of N coordinates, from the first number on.
template <int N, class T>
std::vector<glm::vec<N, T>> points_in(const std::vector<T>& numbers, std::size_t count) {
  std::vector<glm::vec<N, T>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < N; ++k) points[i][static_cast<int>(k)] = numbers[N * i + k];
  }
  return points;
}

/// Whether all numbers are floats, too.
inline bool are_floats(const Input& input) {
  return std::ranges::all_of(
      input, [](double x) { return std::abs(x) <= 0x1p127 && double{static_cast<float>(x)} == x; });
}

/// decide: the sign that numbers of each type give. right: that of an input without rounding.
template <class Decide, class Right>
double decision_error(const Input& input, const Decide& decide, const Right& right) {
  const auto decided = [&](const auto& numbers) { return accepted([&] { return decide(numbers); }); };
  const std::optional<int> found = decided(input);
  if (!all_finite(input) || !found) return found.has_value() == all_finite(input) ? 0 : wrong;
  const int sign = right(input);
  if (found != sign) return wrong;
  if (are_floats(input) && decided(numbers_in<float>(input)) != sign) return wrong;
  const ExactScope scope;
  return decided(numbers_in<Exact>(input)) == sign ? 0 : wrong;
}

/// No sign, of what contradicts itself.
inline constexpr int no_sign = 7;

/// The sign that a method tells, for which it draws its one thing where it is 1; observed or not.
/// method: takes what draws and the observer. Step: tells the sign.
template <class Step, class Method>
int sign_told(const Method& method) {
  int sign = no_sign;
  bool drawn = false, drawn_unobserved = false;
  method([&](std::size_t) { drawn = true; },
         [&]<class Told>(const Told& step) {
           if constexpr (std::same_as<Told, Step>) sign = step.sign;
         });
  method([&](std::size_t) { drawn_unobserved = true; });
  return drawn == (sign == 1) && drawn_unobserved == drawn ? sign : no_sign;
}

/// Numbers of a kind, to be put in place; of those to be refused, one of the first `shape` is none, or
/// infinite.
inline Input numbers_to_place(Kind kind, Random& random, std::size_t count, std::size_t shape) {
  Input input = numbers_of(kind == Kind::refused ? Kind::random : kind, random, count);
  if (kind == Kind::refused) {
    const auto place = static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(shape) - 1));
    input[place] = random.unit() < 0.5 ? std::nan("") : wrong;
  }
  return input;
}

}  // namespace gradus::stress
