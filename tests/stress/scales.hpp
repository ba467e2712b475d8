#pragma once
// Inputs of every size that doubles have, 2^-1074 to 2^1023: what is hard at one scale, at all of them; and
// numbers of several sizes in one input.

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "stress/numbers.hpp"

namespace gradus::stress {

/// x 2^exponent; the largest number instead of infinity.
inline double at_scale(double x, int exponent) {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(std::ldexp(x, exponent), -largest, largest);
}

/// An exponent that makes moderate numbers huge, tiny or subnormal.
inline int exponent_for(Kind kind, Random& random) {
  if (kind == Kind::huge) return static_cast<int>(random.uniform_int(100, 1018));
  if (kind == Kind::tiny) return static_cast<int>(random.uniform_int(-1021, -100));
  return static_cast<int>(random.uniform_int(-1074, -1022));
}

using Generator = std::function<Input(Kind, Random&)>;

/// A generator that makes shapes at every scale. Of the kinds huge, tiny and denormal every second input is a
/// shape of another kind - random, nearly degenerate, grazing, a tie - all of it times one power of two; the
/// extremes are mostly such shapes, too, each number times one of up to three powers of two, or 0.
/// lengths: which of an input's numbers grow and shrink; none named: all. mend: puts in order what the shape
/// had in order, the corners of a box, say.
inline Generator at_every_scale(Generator shape, std::vector<std::size_t> lengths = {},
                                std::function<void(Input&)> mend = {}) {
  return [=](Kind kind, Random& random) {
    const bool one_size = kind == Kind::huge || kind == Kind::tiny || kind == Kind::denormal;
    if (!one_size && kind != Kind::extremes) return shape(kind, random);
    if (random.unit() < (one_size ? 0.5 : 0.25)) return shape(kind, random);

    constexpr std::array shapes{Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
    Input input = shape(shapes[static_cast<std::size_t>(random.uniform_int(0, 3))], random);
    std::array<int, 3> exponents;
    for (int& e : exponents) e = static_cast<int>(random.uniform_int(-1074, 1018));
    if (one_size) exponents.fill(exponent_for(kind, random));
    const std::int64_t sizes = random.uniform_int(0, 2);

    std::vector<std::size_t> which = lengths;
    if (which.empty()) {
      which.resize(input.size());
      std::iota(which.begin(), which.end(), std::size_t{0});
    }
    for (const std::size_t i : which) {
      const int exponent = exponents[static_cast<std::size_t>(random.uniform_int(0, sizes))];
      const bool none = !one_size && random.unit() < 0.1;
      input[i] = none ? 0 : at_scale(input[i], exponent);
    }
    if (mend) mend(input);
    return input;
  };
}

/// Two numbers in order.
inline void put_in_order(double& lower, double& upper) {
  if (lower > upper) std::swap(lower, upper);
}

}  // namespace gradus::stress
