#pragma once
// What kind of outline some corners are.

#include <span>

#include "core/geometry.hpp"

namespace gradus {

/// Whether an outline in the plane has at least three corners and touches itself nowhere but at the corner
/// between two edges that follow each other. Exact.
bool is_simple(std::span<const dvec2> corners);

/// Whether a face lies in one plane, but for the rounding of its corners, to six decimals as model files have
/// them or better.
bool is_flat(std::span<const dvec3> corners);

}  // namespace gradus
