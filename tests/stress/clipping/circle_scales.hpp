#pragma once
// Segments and circles of every size there is, of one or of several in one input.

#include <cmath>
#include <glm/vec2.hpp>

#include "stress/clipping/floats.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {

/// Exponents of powers of two.
struct Sizes {
  int least = -1074, most = 1023;

  Sizes within(int lowest, int highest) const {
    return {std::clamp(lowest, least, most), std::clamp(highest, least, most)};
  }
  /// Either sign.
  double any(Random& random) const { return sized(random, least, most); }
  double power(Random& random) const {
    return std::ldexp(1.0, static_cast<int>(random.uniform_int(least, most)));
  }
};

/// An exponent for a whole input of moderate numbers, so that it fits into the kind.
inline int scale_of(Kind kind, Random& random) {
  if (kind == Kind::huge) return static_cast<int>(random.uniform_int(100, 1018));
  if (kind == Kind::tiny) return -static_cast<int>(random.uniform_int(100, 1021));
  return -static_cast<int>(random.uniform_int(1022, 1074));
}

/// Times 2^exponent; what is too large becomes the largest number.
inline void scale(Input& input, int exponent) {
  constexpr double largest = std::numeric_limits<double>::max();
  for (double& x : input) x = std::clamp(std::ldexp(x, exponent), -largest, largest);
}

/// A way along an axis past the rim of a circle round the origin, at its height or beside it, as long or as
/// short as these sizes go; {from, to, centre, radius}.
inline Input along_an_axis(Random& random, const Sizes& sizes) {
  const double radius = std::abs(sizes.any(random));
  const double heights[] = {0, radius / 2, radius, radius, nudged(radius, random), 2 * radius};
  const double height = heights[random.uniform_int(0, 5)];
  const auto length = [&] {
    // Of any size, or of the circle's
    const int like = std::ilogb(radius);
    return (random.unit() < 0.5 ? sizes : sizes.within(like - 60, like + 60)).power(random);
  };
  const double before = length(), after = length();
  const bool turned = random.unit() < 0.5;
  if (random.unit() < 0.5) return {-before, height, after, turned ? -height : height, 0, 0, radius};
  return {height, turned ? after : -before, height, turned ? -before : after, 0, 0, radius};
}

/// From beside a circle to anywhere, round a centre of any size.
inline Input from_near_to_far(Random& random, const Sizes& sizes) {
  const double radius = std::abs(sizes.any(random));
  const auto near = [&] { return radius * random.uniform(-2, 2); };
  const auto any = [&] { return random.unit() < 0.2 ? 0 : sizes.any(random); };
  glm::dvec2 centre(0);
  if (random.unit() < 0.5) centre.x = any();
  if (random.unit() < 0.25) centre.y = any();
  const double x = centre.x + near(), y = centre.y + near(), to_x = any(), to_y = any();
  if (random.unit() < 0.5) return {x, y, to_x, to_y, centre.x, centre.y, radius};
  return {to_x, to_y, x, y, centre.x, centre.y, radius};
}

/// A tangent of 3-4-5, or one a little beside it, whose ends are up to 2^46 radii away; of any size.
inline Input pythagorean(Random& random, const Sizes& sizes) {
  const double p = std::floor(random.uniform(1, 64)), q = std::floor(random.uniform(1, 64));
  const double before = p * Sizes{0, 40}.power(random), after = q * Sizes{0, 40}.power(random);
  Input input{3 - 4 * before, 4 + 3 * before, 3 + 4 * after, 4 - 3 * after, 0, 0, 5};
  if (random.unit() < 0.5) input[6] = nudged(5, random);
  scale(input, static_cast<int>(random.uniform_int(sizes.least, sizes.most - 48)));
  return input;
}

/// A segment and a circle of sizes that have nothing to do with each other, finite.
inline Input of_mixed_sizes(Random& random, const Sizes& sizes = {}) {
  Input input;
  switch (random.uniform_int(0, 4)) {
    case 0:
      for (int i = 0; i < 7; ++i) {
        input.push_back(random.unit() < 0.2 ? 0 : sizes.any(random));
      }
      break;
    case 1:
      input = from_near_to_far(random, sizes);
      break;
    case 2:
      input = pythagorean(random, sizes);
      break;
    default:
      input = along_an_axis(random, sizes);
  }
  constexpr double largest = std::numeric_limits<double>::max();
  for (double& x : input) x = std::clamp(x, -largest, largest);
  input[6] = std::abs(input[6]);
  return input;
}

}  // namespace gradus::stress
