#pragma once
// The projection that tests of perspective measure by.

#include <limits>

#include "projection/perspective/perspective.hpp"

namespace gradus::perspective {

/// Both angles given: 90 degrees across, 60 upright, near 1, far 100 (G004-04 to G004-11).
inline Projection<double> golden() {
  return projection_of(1.0, 1 / gradus::tan(radians_from_degrees(30)), 1.0, 100.0);
}

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

inline dvec3 ndc(dvec3 view) { return divide(transform(golden(), view)); }

}  // namespace gradus::perspective
