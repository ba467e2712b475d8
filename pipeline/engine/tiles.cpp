#include "engine/tiles.hpp"

#include "engine/cores.hpp"

namespace gradus::pipeline::engine {
namespace {

/// A triangle of a batch and a tile that its box meets.
struct Meeting {
  int tile;
  std::int32_t triangle;
};

/// Sorts by tile, and keeps the order within each.
void sort_by_tile(const std::vector<Meeting>& meetings, int tiles, Batch& batch) {
  batch.first.assign(static_cast<std::size_t>(tiles) + 1, 0);
  for (const Meeting& m : meetings) ++batch.first[static_cast<std::size_t>(m.tile) + 1];
  for (std::size_t i = 1; i < batch.first.size(); ++i) batch.first[i] += batch.first[i - 1];
  batch.in_tile.resize(meetings.size());
  std::vector<std::int32_t> next = batch.first;
  for (const Meeting& m : meetings)
    batch.in_tile[static_cast<std::size_t>(next[static_cast<std::size_t>(m.tile)]++)] = m.triangle;
}

void bin_batch(const TileGrid& grid, Touch touch, Batch& batch) {
  std::vector<Meeting> meetings;
  meetings.reserve(batch.triangles.size());
  std::int32_t number = 0;
  for (const FrameTriangle& t : batch.triangles) {
    const Window box = touched(t.grid, grid.window(), touch);
    if (!box.empty()) {
      const Window tiles = grid.tiles_with(box);
      for (int y = tiles.lower.y; y <= tiles.upper.y; ++y)
        for (int x = tiles.lower.x; x <= tiles.upper.x; ++x)
          meetings.push_back({y * grid.columns() + x, number});
    }
    ++number;
  }
  sort_by_tile(meetings, grid.count(), batch);
}

}  // namespace

void bin(Frame& frame, const TileGrid& grid, Touch touch) {
  for_each_of(frame.batches.size(), [&](std::size_t i) { bin_batch(grid, touch, frame.batches[i]); });
}

}  // namespace gradus::pipeline::engine
