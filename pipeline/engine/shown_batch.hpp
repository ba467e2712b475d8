#pragma once
// What the samples of pixels show: of each triangle how many, and where it is asked for its colour.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/samples_batch.hpp"

namespace gradus::pipeline::engine {

/// A triangle that samples of a pixel show.
struct ShownTriangle {
  std::size_t cell;
  std::int32_t id, samples;
  ivec2 place;  ///< in the pixel, where the textbook's `adaptive` asks for its colour
};

/// Adds, for each pixel whose samples were looked at, the triangles that they show: at each sample, of those
/// that cover it, the least by depth in the textbook's arithmetic, of equals the first.
/// pixels, places, buffer: those of find_samples; places from the one nearest to the pixel's centre on. Cost:
/// 20 nanoseconds per pixel.
void find_shown(const Frame& frame, const Window& pixels, std::span<const ivec2> places,
                const SampleBuffer& buffer, std::vector<ShownTriangle>& shown);

}  // namespace gradus::pipeline::engine
