#pragma once
// The frame of a viewer in numbers of many digits: what the promises and the benchmark of viewing judge by.

#include "stress/core/triple.hpp"

namespace gradus::stress {

template <class Number>
struct Axes {
  Triple<Number> right, up, forward;
  Number sine;  ///< of the angle between the view and the hint for up
};

/// Domain: eye and target apart, a hint of any length but 0, not along the view.
template <class Number, class T>
Axes<Number> axes_of(const glm::vec<3, T>& eye, const glm::vec<3, T>& target, const glm::vec<3, T>& up) {
  const Triple<Number> forward = unit(way_from<Number>(eye, target));
  const Triple<Number> across = cross(forward, unit(way_from<Number>(glm::vec<3, T>(0), up)));
  const Triple<Number> right = unit(across);
  return {right, cross(right, forward), forward, length_of(across)};
}

}  // namespace gradus::stress
