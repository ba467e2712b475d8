#pragma once
// Exhibit: an accumulation buffer of lecture notes that has the picture's own type, kept so that a figure can
// show where it goes wrong. Never use it to draw; accumulation_buffer.hpp has the right one.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

namespace gradus::accumulation_buffer {

/// The caller's sums in bytes. FAULTY: what is added wraps round at 256.
struct ByteSums {
  std::span<std::uint8_t> values;
  ivec2 size;

  constexpr void clear() const { std::ranges::fill(values, std::uint8_t{0}); }
  constexpr void operator()(ivec2 pixel, int value) const {
    std::uint8_t& sum = values[static_cast<std::size_t>(pixel.y * size.x + pixel.x)];
    sum = static_cast<std::uint8_t>((sum + value) % 256);
  }
  constexpr void divide(int passes) const {
    for (std::uint8_t& sum : values) sum = static_cast<std::uint8_t>(sum / passes);
  }
};

/// FAULTY: the buffer has the type of the picture, a byte a value, and overflows (errata E001-54): four
/// passes of 200 add up to 800, which a byte has as 32, and a quarter of that is 8 instead of 200.
///
/// grid, render, sums: as for accumulate, in bytes 0 to 255.
///
/// Domain: as accumulate; one byte a pixel.
/// Steps: Started PassAdded{a b} Averaged, as accumulate.
/// Accuracy: floor((sum mod 256) / passes) instead of sum / passes; right as long as the sum is below 256.
/// Cost: as accumulate.
/// Errors: as accumulate.
template <std::invocable<dvec2, const ByteSums&> Render,
          Observer<Started, PassAdded, Averaged> O = Unobserved>
constexpr void eight_bits(ivec2 grid, Render&& render, const ByteSums& sums, O&& observer = {}) {
  expects(allowed(grid.x, grid.y), "{} x {} passes are not from 1 to {}", grid.x, grid.y, most_passes);
  const int a = grid.x, b = grid.y;
  // Sums of the picture's own type
  sums.clear();
  if constexpr (observed<O>) observer(Started{a * b});
  for (int j = 0; j < b; ++j) {
    for (int i = 0; i < a; ++i) {
      const auto place = place_of(i, j, grid);
      // Added modulo 256
      render(place, sums);
      if constexpr (observed<O>) observer(PassAdded{j * a + i, place});
    }
  }
  sums.divide(a * b);
  if constexpr (observed<O>) observer(Averaged{a * b});
}

}  // namespace gradus::accumulation_buffer
