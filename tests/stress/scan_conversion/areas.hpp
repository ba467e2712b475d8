#pragma once
// The oracle of fills: connected areas by union-find.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::stress {

using Mask = Raster<std::uint8_t>;  ///< 1 in some cells, 0 in all others

inline bool has(const Mask& mask, ivec2 p) { return mask.contains(p) && mask[p] != 0; }
inline std::int64_t count(const Mask& mask) {
  return std::count(mask.cells().begin(), mask.cells().end(), std::uint8_t{1});
}

/// Not in any area.
inline constexpr int no_area = -1;

/// Which area of connected cells each cell belongs to that is inside(ivec2): the least index of its cells.
template <class Inside>
Raster<int> areas_of(int width, int height, flood_fill::Connectivity connectivity, Inside inside) {
  Raster<int> areas(width, height, no_area);
  const auto parent = [&](int i) -> int& { return areas.cells()[static_cast<std::size_t>(i)]; };
  const auto root = [&](int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const ivec2 p{x, y};
      if (!inside(p)) continue;
      areas[p] = y * width + x;
      // The half of the neighbours that come before it
      for (const ivec2 way : {ivec2{-1, 0}, ivec2{0, -1}, ivec2{-1, -1}, ivec2{1, -1}}) {
        const bool corner = way.x != 0 && way.y != 0;
        if (corner && connectivity == flood_fill::Connectivity::four) continue;
        if (!areas.contains(p + way) || areas[p + way] == no_area) continue;
        const int a = root(areas[p]), b = root(areas[p + way]);
        parent(std::max(a, b)) = std::min(a, b);
      }
    }
  }
  for (int& area : areas.cells()) area = area == no_area ? no_area : root(area);
  return areas;
}

/// The area of the seed; empty when the seed is not inside.
template <class Inside>
Mask area_of(int width, int height, ivec2 seed, flood_fill::Connectivity connectivity, Inside inside) {
  Mask area(width, height);
  const Raster<int> areas = areas_of(width, height, connectivity, inside);
  if (!areas.contains(seed) || areas[seed] == no_area) return area;
  std::transform(areas.cells().begin(), areas.cells().end(), area.cells().begin(),
                 [&](int of) { return of == areas[seed] ? std::uint8_t{1} : std::uint8_t{0}; });
  return area;
}

/// How many cells are wrong after a fill of an area: those in it must have the value, the others what they
/// had before.
template <class Cell>
std::int64_t wrong_cells(const Raster<Cell>& after, const Raster<Cell>& before, const Mask& area,
                         const Cell& value) {
  std::int64_t wrong = 0;
  for (std::size_t i = 0; i < area.cells().size(); ++i) {
    wrong += after.cells()[i] != (area.cells()[i] ? value : before.cells()[i]);
  }
  return wrong;
}

}  // namespace gradus::stress
