#pragma once
// Pictures to fill: what the benchmark measures, and what the page of flood_fill has counted.

#include <cstdint>
#include <random>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::test {

using Canvas = Raster<std::uint8_t>;  // 0 free, 1 wall

/// Cells walled off at random; with 60 % free just above where one area spans the picture.
inline Canvas noise(int side) {
  Canvas canvas(side, side);
  std::mt19937_64 random(1);
  for (auto& cell : canvas.cells()) cell = random() % 100 < 60 ? 0 : 1;
  return canvas;
}

/// A row along the upper side, and columns one cell wide that hang from it.
inline Canvas comb(int side) {
  Canvas canvas(side, side);
  for (int y = 1; y < side; ++y) {
    for (int x = 1; x < side; x += 2) canvas[{x, y}] = 1;
  }
  return canvas;
}

/// Corridors one cell wide, without loops.
inline Canvas maze(int side) {
  Canvas canvas(side + 1, side + 1, 1);
  std::mt19937_64 random(1);
  std::vector<ivec2> path{{1, 1}};
  canvas[{1, 1}] = 0;
  while (!path.empty()) {
    std::vector<ivec2> open;
    for (const ivec2 way : flood_fill::ways(flood_fill::Connectivity::four)) {
      const ivec2 next = path.back() + 2 * way;
      if (canvas.contains(next) && canvas[next] == 1) open.push_back(way);
    }
    if (open.empty()) {
      path.pop_back();
      continue;
    }
    const ivec2 way = open[random() % open.size()];
    canvas[path.back() + way] = 0;
    canvas[path.back() + 2 * way] = 0;
    path.push_back(path.back() + 2 * way);
  }
  return canvas;
}

}  // namespace gradus::test
