#pragma once
// What lights a scene: plain data that illumination, shading, ray tracing and the loaders share. Colours are
// linear RGB; sRGB is the business of image files (core/colour.hpp).

#include <glm/vec3.hpp>
#include <limits>

#include "core/geometry.hpp"

namespace gradus {

/// A colour or an amount of light, linear, a component each for red, green and blue; 1 is full white.
using LinearRgb = glm::vec3;

/// A lamp. At the distance d its light arrives weakened by 1 / (constant + linear d + quadratic d^2), never
/// stronger than it left, times (1 - (d / range)^4)^2 within the range; beyond it the lamp adds exactly
/// nothing.
struct Light {
  enum class Kind { point, directional, spot, area };

  Kind kind = Kind::point;
  dvec3 position{0};          ///< where it stands, of an area its middle: world space
  dvec3 direction{0, 0, 0};   ///< directional, spot: where its light travels to, any length but 0
  LinearRgb intensity{1.0f};  ///< what it sends out, >= 0
  double constant = 1, linear = 0, quadratic = 0;          ///< attenuation by distance, >= 0, not all 0
  double range = std::numeric_limits<double>::infinity();  ///< > 0; without an end unless it is given
  /// Spot: cosines of the angles between its axis and the outer and the inner cone, -1 <= outer <= inner
  /// <= 1. On the outer cone and outside it the lamp adds nothing, inside the inner one it is not dimmed.
  double outer_cosine = 0.5, inner_cosine = 0.5;
  double concentration = 0;   ///< spot: the cosine to its axis weakens it with this power, >= 0
  dvec3 across{0}, along{0};  ///< area: the sides of its rectangle; it shines to where across x along points
  int samples = 4;            ///< area: it counts as samples * samples lamps, in [1, 1024]
};

}  // namespace gradus
