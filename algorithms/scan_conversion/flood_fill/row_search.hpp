#pragma once
// Where runs begin and end in a row, 16 bytes at a time.

#include <bit>
#include <cstdint>
#include <type_traits>

#include "scan_conversion/flood_fill/bitmap.hpp"

namespace gradus::flood_fill {

/// The first of the cells x .. end - 1 that has this value, or end, or x if x is beyond it.
template <class Cell>
int first_equal(const Cell* row, int x, int end, const Cell& value) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<Cell, std::uint8_t>) {
    for (; end - x >= 16; x += 16) {
      const unsigned equal = equal_sixteen(row + x, value);
      if (equal != 0) return x + std::countr_zero(equal);
    }
  }
#endif
  while (x < end && !(row[x] == value)) ++x;
  return x;
}

/// So many cells of a run are looked at one by one first: most runs are short, and 16 bytes of which some
/// were just written take the processor longer to read.
inline constexpr int one_by_one = 8;

/// The first of the cells x .. width - 1 that has another value, or width.
template <class Cell>
int first_other(const Cell* row, int x, int width, const Cell& value) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<Cell, std::uint8_t>) {
    for (int k = 0; k < one_by_one; ++k, ++x) {
      if (x >= width || row[x] != value) return x;
    }
    for (; width - x >= 16; x += 16) {
      const int equal = std::countr_one(equal_sixteen(row + x, value));
      if (equal < 16) return x + equal;
    }
  }
#endif
  while (x < width && row[x] == value) ++x;
  return x;
}

/// The first cell of the run of this value that ends in cell x. Domain: row[x] has the value.
template <class Cell>
int run_start(const Cell* row, int x, const Cell& value) {
#ifdef __SSE2__
  if constexpr (std::is_same_v<Cell, std::uint8_t>) {
    for (int k = 0; k < one_by_one; ++k, --x) {
      if (x == 0 || row[x - 1] != value) return x;
    }
    for (; x >= 16; x -= 16) {
      const unsigned others = ~equal_sixteen(row + x - 16, value) & 0xffff;
      if (others != 0) return x - 16 + static_cast<int>(std::bit_width(others));
    }
  }
#endif
  while (x > 0 && row[x - 1] == value) --x;
  return x;
}

}  // namespace gradus::flood_fill
