#pragma once
// What the promises and the benchmark of parallel judge by.

#include <array>
#include <cstddef>

namespace gradus::stress {

/// Where the line through a point along a direction meets the plane of all p with normal . p = offset.
/// Number: any that rounds nothing, or little.
template <class Number>
std::array<Number, 3> crossing_of(const std::array<Number, 3>& normal, const Number& offset,
                                  const std::array<Number, 3>& direction,
                                  const std::array<Number, 3>& point) {
  Number ahead = offset, speed = Number(0);
  for (std::size_t k = 0; k < 3; ++k) {
    ahead = ahead - normal[k] * point[k];
    speed = speed + normal[k] * direction[k];
  }
  const Number t = ahead / speed;
  return {point[0] + t * direction[0], point[1] + t * direction[1], point[2] + t * direction[2]};
}

}  // namespace gradus::stress
