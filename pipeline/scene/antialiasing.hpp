#pragma once
// What can be asked for against aliasing, and how many samples each method takes.

#include <array>
#include <cstddef>
#include <string_view>

namespace gradus::pipeline {

/// From what a pixel takes its light (chapter antialiasing).
enum class Antialiasing {
  none,                 ///< from its centre
  supersampling,        ///< from the middles of n x n cells, all at once
  accumulation_buffer,  ///< from the same places, one picture after the other
  jittered,             ///< from a place anywhere in each of so many cells, others in each pixel
  poisson_disc,         ///< from places that keep their distance, others in each pixel
  area_sampling,        ///< from exact visible areas
  a_buffer,             ///< from masks of 32 sub-samples
  adaptive,             ///< from samples where edges cross it, with one colour per fragment
  adaptive_contrast,    ///< and with one per sample where neighbours differ
};

/// What users call the methods, in the order of Antialiasing.
inline constexpr std::array<std::string_view, 9> antialiasing_names{
    "none",     "supersampling", "accumulation_buffer", "jittered", "poisson_disc", "area_sampling",
    "a_buffer", "adaptive",      "adaptive+contrast"};

constexpr std::string_view name_of(Antialiasing method) {
  return antialiasing_names[static_cast<std::size_t>(method)];
}

/// What pictures have that ask for nothing.
inline constexpr Antialiasing default_antialiasing = Antialiasing::adaptive;
inline constexpr int default_samples = 16;

/// Whether a method takes the number of samples that a scene asks for.
constexpr bool takes_samples(Antialiasing method) {
  using enum Antialiasing;
  return method != none && method != area_sampling && method != a_buffer;
}
/// Whether that number must be a square, for its samples stand in the middles of cells.
constexpr bool takes_squares(Antialiasing method) {
  return method == Antialiasing::supersampling || method == Antialiasing::accumulation_buffer;
}

/// The side of a square of so many samples; 0 when they are none.
constexpr int grid_side(int samples) {
  for (int side = 1; side * side <= samples; ++side)
    if (side * side == samples) return side;
  return 0;
}

}  // namespace gradus::pipeline
