// Circle methods side by side on one set of circles. Compare within one run: the ratios are the result, not
// the times.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"

namespace gradus::bresenham_circle {
namespace {

constexpr int side = 1024;
using Canvas = Raster<std::uint8_t>;  // a byte a cell: a MiB, so that memory does not decide

/// 1000 circles: 0 inside the canvas, any radius, 1 small (radius 5 to 14), 2 large (400 to 500), 3 cut by
/// its border.
const std::vector<Circle>& circles(int kind) {
  static const auto made = [] {
    std::vector<std::vector<Circle>> sets(4);
    std::mt19937_64 random(1);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    const auto inside = [&](int radius) {
      const int room = side - 2 * radius;
      const int x = radius + below(room);
      return Circle{{x, radius + below(room)}, radius};
    };
    for (int i = 0; i < 1000; ++i) {
      sets[0].push_back(inside(1 + below(510)));
      sets[1].push_back(inside(5 + below(10)));
      sets[2].push_back(inside(400 + below(100)));
      const int x = below(side);
      sets[3].push_back({{x, below(side)}, side / 4 + below(side)});
    }
    return sets;
  }();
  return made[static_cast<std::size_t>(kind)];
}

const char* name(int kind) {
  const char* const names[] = {"all radii", "radius 5 to 14", "radius 400 to 499", "cut by the border"};
  return names[kind];
}

/// Times `one(canvas, circle)` over a set of circles, and checks once that it gives the pixels of
/// decision_parameter.
template <class One>
void time_circles(benchmark::State& state, One one) {
  const auto& set = circles(static_cast<int>(state.range(0)));
  Canvas canvas(side, side), reference(side, side);
  std::int64_t pixels = 0;
  for (const Circle& circle : set) {
    one(canvas, circle);
    decision_parameter(circle.center, circle.radius, [&](ivec2 p) {
      if (!reference.contains(p)) return;
      reference[p] = 1;
      ++pixels;
    });
  }
  if (!(canvas == reference)) throw std::logic_error("other pixels");
  for (auto _ : state) {
    for (const Circle& circle : set) one(canvas, circle);
    benchmark::DoNotOptimize(canvas.cells().data());
    benchmark::ClobberMemory();
  }
  state.SetLabel(name(static_cast<int>(state.range(0))));
  state.SetItemsProcessed(state.iterations() * pixels);
}

void BM_DecisionParameter(benchmark::State& state) {
  time_circles(state, [](Canvas& canvas, const Circle& circle) {
    decision_parameter(circle.center, circle.radius, [&](ivec2 p) { canvas[p] = 1; });
  });
}

/// The same with the question whether the pixel is inside, pixel by pixel: what cutting costs without
/// in_window.
void BM_DecisionParameterGuarded(benchmark::State& state) {
  time_circles(state, [](Canvas& canvas, const Circle& circle) {
    decision_parameter(circle.center, circle.radius, [&](ivec2 p) {
      if (canvas.contains(p)) canvas[p] = 1;
    });
  });
}

void BM_InWindow(benchmark::State& state) {
  time_circles(state, [](Canvas& canvas, const Circle& circle) {
    in_window(circle.center, circle.radius, canvas.window(), [&](ivec2 p) { canvas[p] = 1; });
  });
}

void BM_Draw(benchmark::State& state) {
  time_circles(state, [](Canvas& canvas, const Circle& circle) {
    draw(canvas, circle.center, circle.radius, std::uint8_t{1});
  });
}

/// The part in the canvas of circles of up to 12 billion pixels.
void BM_DrawHuge(benchmark::State& state) {
  std::mt19937_64 random(1);
  std::vector<Circle> set;
  Canvas canvas(side, side);
  std::int64_t pixels = 0;
  while (set.size() < 1000) {
    // Through a pixel of the canvas, in any octant
    const int radius = static_cast<int>(random() % INT32_MAX);
    const Octant& octant = octants[random() % 8];
    const auto x = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last_column(radius) + 1));
    const ivec2 on_circle = pixel_of({0, 0}, octant, x, height_at(radius, x));
    const ivec2 pixel{static_cast<int>(random() % side), static_cast<int>(random() % side)};
    const ivec2 center = pixel - on_circle;
    for (const Arc& arc : visible(center, radius, canvas.window())) pixels += arc.shown.count();
    set.push_back({center, radius});
  }
  if (pixels < 200000) throw std::logic_error("the circles miss the window");
  for (auto _ : state) {
    for (const Circle& circle : set) draw(canvas, circle.center, circle.radius, std::uint8_t{1});
    benchmark::DoNotOptimize(canvas.cells().data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * pixels);
}

BENCHMARK(BM_DecisionParameter)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DecisionParameterGuarded)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_InWindow)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Draw)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DrawHuge)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gradus::bresenham_circle
