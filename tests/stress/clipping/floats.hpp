#pragma once
// Inputs for what is promised of floats, too.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "stress/domain.hpp"

namespace gradus::stress {

/// The numbers as floats, infinite beyond their range.
inline Input rounded_to_floats(Input input) {
  for (double& x : input) {
    const bool fits = std::abs(x) <= double{std::numeric_limits<float>::max()};
    x = fits ? double{static_cast<float>(x)} : x * HUGE_VAL;
  }
  return input;
}

/// A generator of shapes, and of the same at every scale that floats have.
inline std::function<Input(Kind, Random&)> at_every_scale_of_floats(std::function<Input(Kind, Random&)> shape,
                                                                    std::function<void(Input&)> mend = {}) {
  return [=](Kind kind, Random& random) {
    constexpr Kind shapes[] = {Kind::random, Kind::near_degenerate, Kind::grazing, Kind::ties};
    const bool is_shape = kind == Kind::refused || std::ranges::find(shapes, kind) != std::end(shapes);
    Input input = shape(is_shape ? kind : shapes[random.uniform_int(0, 3)], random);
    const int exponent = is_shape             ? 0
                         : kind == Kind::huge ? static_cast<int>(random.uniform_int(20, 121))
                                              : static_cast<int>(random.uniform_int(-149, -20));
    for (double& x : input) x = std::ldexp(x, exponent);
    input = rounded_to_floats(input);
    if (mend) mend(input);
    return input;
  };
}

}  // namespace gradus::stress
