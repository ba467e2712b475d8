// Line methods side by side on one set of lines. Compare within one run: the ratios are the result, not the
// times.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"

namespace gradus::bresenham_line {
namespace {

constexpr int side = 1024;
using Canvas = Raster<std::uint32_t>;

/// 1000 lines inside the canvas: 0 of all directions, 1 nearly level (runs of 20 pixels and more), 2 short
/// (20 px).
const std::vector<Segment>& lines(int kind) {
  static const auto made = [] {
    std::vector<std::vector<Segment>> sets(3);
    std::mt19937_64 random(1);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    for (int i = 0; i < 1000; ++i) {
      const int x = below(side), y = below(side);
      sets[0].push_back({{x, y}, {below(side), below(side)}});
      const int level = 20 + below(side - 40);
      sets[1].push_back({{below(100), level}, {side - 1 - below(100), level + below(41) - 20}});
      const int a = 20 + below(side - 40), b = 20 + below(side - 40);
      sets[2].push_back({{a, b}, {a + below(41) - 20, b + below(41) - 20}});
    }
    return sets;
  }();
  return made[static_cast<std::size_t>(kind)];
}

const char* name(int kind) {
  const char* const names[] = {"all directions", "nearly level", "20 pixels"};
  return names[kind];
}

std::int64_t pixels_of(const std::vector<Segment>& set) {
  std::int64_t pixels = 0;
  for (const Segment& line : set) pixels += pixel_count(line.from, line.to);
  return pixels;
}

/// Times `one(canvas, line)` over a set of lines, and checks once that it gives the pixels of
/// decision_parameter.
template <class One>
void time_lines(benchmark::State& state, One one, bool exact = true) {
  const auto& set = lines(static_cast<int>(state.range(0)));
  Canvas canvas(side, side), reference(side, side);
  for (const Segment& line : set) {
    one(canvas, line);
    decision_parameter(line.from, line.to, [&](ivec2 p) { reference[p] = 1; });
  }
  if (exact && !(canvas == reference)) throw std::logic_error("other pixels");
  for (auto _ : state) {
    for (const Segment& line : set) one(canvas, line);
    benchmark::DoNotOptimize(canvas.cells().data());
    benchmark::ClobberMemory();
  }
  state.SetLabel(name(static_cast<int>(state.range(0))));
  state.SetItemsProcessed(state.iterations() * pixels_of(set));
}

void BM_DecisionParameter(benchmark::State& state) {
  time_lines(state, [](Canvas& canvas, const Segment& line) {
    decision_parameter(line.from, line.to, [&](ivec2 p) { canvas[p] = 1; });
  });
}

void BM_DdaFloat(benchmark::State& state) {
  time_lines(
      state,
      [](Canvas& canvas, const Segment& line) {
        dda<float>(line.from, line.to, [&](ivec2 p) { canvas[p] = 1; });
      },
      false);
}

void BM_RunLength(benchmark::State& state) {
  time_lines(state, [](Canvas& canvas, const Segment& line) {
    const ivec2 step = moves(line.from, line.to).straight;
    run_length(line.from, line.to, [&](ivec2 start, std::int64_t count) {
      for (; count > 0; --count, start += step) canvas[start] = 1;
    });
  });
}

void BM_Draw(benchmark::State& state) {
  time_lines(state,
             [](Canvas& canvas, const Segment& line) { draw(canvas, line.from, line.to, std::uint32_t{1}); });
}

/// The part in a 1024 x 1024 window of lines that go on for up to 2^32 pixels.
void BM_InWindow(benchmark::State& state) {
  std::mt19937_64 random(1);
  std::vector<Segment> set;
  Canvas canvas(side, side);
  std::int64_t pixels = 0;
  const auto any = [&] { return static_cast<int>(static_cast<std::uint32_t>(random())); };
  for (int i = 0; i < 1000; ++i) {
    const int x = static_cast<int>(random() % side), y = static_cast<int>(random() % side);
    const int a = any(), b = any();
    set.push_back({{x, y}, {a, b}});
    const Stretch shown = visible({x, y}, {a, b}, canvas.window());
    pixels += shown.last - shown.first + 1;
  }
  if (pixels < 200000) throw std::logic_error("the lines miss the window");
  const bool fast = state.range(0) == 1;
  for (auto _ : state) {
    for (const Segment& line : set) {
      if (fast) {
        draw(canvas, line.from, line.to, std::uint32_t{1});
      } else {
        in_window(line.from, line.to, canvas.window(), [&](ivec2 p) { canvas[p] = 1; });
      }
    }
    benchmark::ClobberMemory();
  }
  state.SetLabel(fast ? "draw" : "in_window");
  state.SetItemsProcessed(state.iterations() * pixels);
}

/// One jump: the k-th pixel of a line by 128-bit division.
void BM_PixelAt(benchmark::State& state) {
  std::int64_t k = 0;
  ivec2 from{262, 23}, to{91618510, -54756195};
  for (auto _ : state) {
    benchmark::DoNotOptimize(from);
    benchmark::DoNotOptimize(to);
    benchmark::DoNotOptimize(pixel_at(from, to, k));
    k = (k + 7919) % 91618249;
  }
}

BENCHMARK(BM_DecisionParameter)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DdaFloat)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_RunLength)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Draw)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_InWindow)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PixelAt);

}  // namespace
}  // namespace gradus::bresenham_line
