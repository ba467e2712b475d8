#pragma once
// What samples of the pixels of a tile show. Where one triangle covers a pixel whole and is surely nearest,
// no sample is looked at; elsewhere all are, at once.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/visibility_batch.hpp"

namespace gradus::pipeline::engine {

/// Samples per pixel, at most.
inline constexpr std::size_t most_samples = 16;

/// The middle of a pixel, in 1/256 pixel.
inline constexpr ivec2 pixel_middle{triangle_coverage::subpixels / 2, triangle_coverage::subpixels / 2};

/// From the middle of a pixel to its samples, in 1/256 pixel; the last one fills up.
struct SampleOffsets {
  explicit SampleOffsets(std::span<const ivec2> places) {
    for (std::size_t s = 0; s < most_samples; ++s) {
      const ivec2 from_middle = places[std::min(s, places.size() - 1)] - pixel_middle;
      right[s] = from_middle.x;
      down[s] = from_middle.y;
    }
  }
  alignas(64) std::int32_t right[most_samples];
  alignas(64) std::int32_t down[most_samples];
};

/// The samples of a pixel, of triangles that do not cover it whole or not surely.
struct alignas(64) PixelSamples {
  std::array<float, most_samples> nearness;
  std::array<std::int32_t, most_samples> ids;
};

/// What is nearest in the pixels of a tile.
struct alignas(64) SampleBuffer {
  static constexpr std::size_t cells = TileBuffer::cells;

  std::array<float, cells> least, most;   ///< how near the triangle below comes, in all of the pixel's square
  std::array<std::int32_t, cells> whole;  ///< the nearest of those that cover the square
  std::array<std::int32_t, cells> sampled;  ///< place in `samples` where others are to be looked at, else -1
  std::vector<PixelSamples> samples;        ///< room for all cells; as many are in use as the next has
  std::vector<std::int32_t> sampled_cells;  ///< of each of them
};

/// Finds what may be seen of the triangles of a tile.
///
/// frame: with its triangles sorted into tiles by Touch::neighbours. places: of the samples in a pixel, in
///   1/256 pixel; 1 to 16 of them. buffer: is overwritten.
///
/// Domain: that of make_frame.
/// Accuracy: coverage exact; see find_shown.
/// Cost: some 100 nanoseconds per triangle and tile, 10 per block of its box, and 20 per pixel that it
///   neither covers nor leaves out whole; memory of 128 bytes per pixel of a tile.
/// Errors: none.
void find_samples(const Frame& frame, int tile, const Window& pixels, std::span<const ivec2> places,
                  SampleBuffer& buffer);

}  // namespace gradus::pipeline::engine
