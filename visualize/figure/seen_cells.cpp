#include "figure/seen_cells.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_set>

namespace gradus {

std::vector<Window> windows_to_look_in(const Trace& trace) {
  constexpr std::int64_t most_cells = std::int64_t{1} << 26;
  const Window& all = trace.grid.cells;
  if (all.empty()) return {};
  if (all.width() <= most_cells && all.height() <= most_cells / all.width()) return {all};

  constexpr std::int64_t side = 128;
  std::vector<Window> blocks;
  std::unordered_set<std::uint64_t> known;
  const auto block_of = [](std::int64_t coordinate) { return (coordinate + (std::int64_t{1} << 32)) / side; };
  for (const TraceStep& step : trace.steps) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const std::int64_t column = block_of(step.focus.x) + dx, row = block_of(step.focus.y) + dy;
        const std::uint64_t id = static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column);
        if (!known.insert(id).second) continue;
        const std::int64_t x = column * side - (std::int64_t{1} << 32),
                           y = row * side - (std::int64_t{1} << 32);
        const auto bounded = [](std::int64_t v) {
          return static_cast<int>(std::clamp<std::int64_t>(v, INT32_MIN, INT32_MAX));
        };
        if (x > INT32_MAX || y > INT32_MAX || x + side <= INT32_MIN || y + side <= INT32_MIN) continue;
        const Window block{{bounded(x), bounded(y)}, {bounded(x + side - 1), bounded(y + side - 1)}};
        if (const Window shared = intersection(block, all); !shared.empty()) blocks.push_back(shared);
      }
    }
  }
  return blocks;
}

}  // namespace gradus
