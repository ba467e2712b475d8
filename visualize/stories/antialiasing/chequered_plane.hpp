#pragma once
// What all patterns of samples are shown on: a chequered plane whose squares get finer than any of them
// towards the horizon.

#include "antialiasing/sampling_theorem/test_patterns.hpp"

namespace gradus {

/// Its light at the places of a picture of this size, from 0 to 1.
struct ChequeredPlane {
  ivec2 size{48, 36};

  double operator()(dvec2 place) const {
    const double across = size.x;
    return sampling_theorem::Chequerboard{{0.5 * across, std::floor(size.y / 8.0)}, across, 0.25}(place);
  }
};

}  // namespace gradus
