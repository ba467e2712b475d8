#pragma once
// What the promises and the benchmark of perspective judge by. Number: any that rounds nothing, or little.

#include <array>

#include "projection/perspective/perspective.hpp"

namespace gradus::stress {

template <class Number>
Number depth_between(perspective::DepthCurve curve, Number near, Number far, Number z) {
  if (curve == perspective::DepthCurve::linear) return (z - near) / (far - near);
  const Number inverse = (Number(1) - near / z) * far / (far - near);
  return curve == perspective::DepthCurve::inverse ? inverse : Number(1) - inverse;
}

/// After transformation and division.
template <class Number>
std::array<Number, 3> place_in_box(const Projection<Number>& p, Number near, Number far,
                                   const std::array<Number, 3>& view) {
  const auto& [x, y, z] = view;
  return {p.x_scale * x / z, p.y_scale * y / z,
          depth_between(perspective::DepthCurve::inverse, near, far, z)};
}

}  // namespace gradus::stress
