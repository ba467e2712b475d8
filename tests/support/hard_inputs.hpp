#pragma once
// A search for the inputs at which a bound is hard to keep: from random ones to what uses most of it.

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "support/fraction.hpp"
#include "support/seed.hpp"

namespace gradus::test {

using Numbers = std::vector<double>;

/// What is said of an input that nothing is promised for.
inline constexpr double not_in_domain = 0;

/// How many times the unit a number is off.
inline double off(const Fraction& found, const Fraction& right, const Fraction& unit) {
  return static_cast<double>(abs(found - right) / unit);
}

/// Of both signs, sizes from 2^-range to 2^range.
inline double number(Random& random, int range = 8) {
  const double digits = random.uniform(-1, 1);
  return std::ldexp(digits, static_cast<int>(random.uniform_int(-range, range)));
}
inline Numbers numbers(Random& random, std::size_t count, int range = 8) {
  Numbers all(count);
  for (double& x : all) x = number(random, range);
  return all;
}
inline double whole_number(Random& random, double least, double most) {
  return std::floor(random.uniform(least, most));
}
inline dvec3 three(const Numbers& n, std::size_t at) { return {n[at], n[at + 1], n[at + 2]}; }

/// The worst that `judge` finds among so many random inputs, and as many that are the worst so far with one
/// number changed a little.
template <class Draw, class Judge>
double worst(int draws, Draw draw, Judge judge) {
  Random random(seed());
  Numbers hardest;
  double most = -1;
  const auto consider = [&](Numbers input) {
    if (const double found = judge(input); found > most) most = found, hardest = std::move(input);
  };
  for (int i = 0; i < draws; ++i) {
    consider(draw(random));
    Numbers near = hardest;
    double& x = near[static_cast<std::size_t>(random.uniform_int(0, std::ssize(near) - 1))];
    const double little = random.uniform(-1, 1);
    x *= 1 + std::ldexp(little, -static_cast<int>(random.uniform_int(1, 52)));
    consider(near);
  }
  std::cout << "the worst uses " << most << "\n";
  return most;
}

}  // namespace gradus::test
