#pragma once
// Numbers of every kind, for generators.

#include <cmath>
#include <limits>

#include "stress/domain.hpp"

namespace gradus::stress {

/// sign * [1, 2) * 2^e with e from `lowest` to `highest`.
inline double sized(Random& random, int lowest, int highest) {
  const double size = std::ldexp(random.uniform(1, 2), static_cast<int>(random.uniform_int(lowest, highest)));
  return random.unit() < 0.5 ? -size : size;
}

/// A coordinate of this kind; of kinds that are about the place of several, any.
inline double number(Kind kind, Random& random) {
  constexpr double largest = std::numeric_limits<double>::max();
  switch (kind) {
    case Kind::huge:
      return sized(random, 900, 1022);
    case Kind::tiny:
      return sized(random, -1000, -300);
    case Kind::ties:
      return static_cast<double>(random.uniform_int(-8, 16));
    case Kind::denormal:
      return sized(random, -1074, -1040);
    case Kind::extremes: {
      const double some[] = {largest,
                             -largest,
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(),
                             0,
                             1,
                             -1,
                             0x1p52};
      return some[random.uniform_int(0, 7)];
    }
    case Kind::refused: {
      const double some[] = {std::numeric_limits<double>::quiet_NaN(), wrong, -wrong, 1};
      return some[random.uniform_int(0, 3)];
    }
    default:
      return random.uniform(-16, 16);
  }
}

/// x, moved by up to three units in the last place.
inline double nudged(double x, Random& random) {
  const std::int64_t steps = random.uniform_int(-3, 3);
  for (std::int64_t i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps < 0 ? -wrong : wrong);
  return x;
}

inline bool all_finite(const Input& input) {
  for (const double x : input) {
    if (!std::isfinite(x)) return false;
  }
  return true;
}

}  // namespace gradus::stress
