// Fill methods side by side: time, questions, and peak memory a painted cell; and where the recursion
// overflows. Compare within one run: the ratios are the result, not the times.

#include <benchmark/benchmark.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"

namespace gradus::flood_fill {
namespace {

using Canvas = Raster<std::uint8_t>;  // 0 free, 1 wall, 2 painted
constexpr int side = 1024;

/// A picture with a seed in its largest component, and that component's size.
struct Scene {
  Canvas canvas;
  ivec2 seed{0, 0};
  std::int64_t cells = 0;
};

/// Finds the largest component by filling every one of them breadth first.
Scene scene_of(Canvas canvas) {
  Scene scene{canvas, {0, 0}, 0};
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      if (canvas[{x, y}] != 0) continue;
      const std::int64_t cells = fill_raster(canvas, {x, y}, std::uint8_t{2}, Method::breadth_first).painted;
      if (cells > scene.cells) scene.seed = {x, y}, scene.cells = cells;
    }
  }
  return scene;
}

Scene empty_canvas() {
  Scene scene = scene_of(Canvas(side, side));
  scene.seed = {side / 2, side / 2};
  return scene;
}

Scene noise() {  // 60 % free: just above the density at which one component spans the picture
  Canvas canvas(side, side);
  std::mt19937_64 random(1);
  for (auto& cell : canvas.cells()) cell = random() % 100 < 60 ? 0 : 1;
  return scene_of(canvas);
}

Scene comb() {
  Canvas canvas(side, side);
  for (int y = 1; y < side; ++y) {
    for (int x = 1; x < side; x += 2) canvas[{x, y}] = 1;
  }
  return scene_of(canvas);
}

Scene maze() {  // corridors one cell wide, without loops
  Canvas canvas(side + 1, side + 1, 1);
  std::mt19937_64 random(1);
  std::vector<ivec2> path{{1, 1}};
  canvas[{1, 1}] = 0;
  while (!path.empty()) {
    std::vector<ivec2> open;
    for (const ivec2 way : ways(Connectivity::four)) {
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
  return scene_of(canvas);
}

const Scene& scene(int number) {
  static const Scene scenes[] = {empty_canvas(), maze(), noise(), comb()};
  return scenes[number];
}

const char* scene_name(int number) {
  const char* const names[] = {"empty", "maze", "noise_60", "comb"};
  return names[number];
}

void report(benchmark::State& state, const Scene& picture, const Filled& filled) {
  if (filled.painted != picture.cells) throw std::logic_error("the fill missed cells");
  const auto painted = static_cast<double>(filled.painted);
  state.counters["painted"] = painted;
  state.counters["peak_entries"] = static_cast<double>(filled.peak_waiting);
  state.counters["peak_bytes"] = static_cast<double>(filled.peak_bytes);
  state.counters["bytes_per_cell"] = static_cast<double>(filled.peak_bytes) / painted;
  state.counters["cells_per_second"] =
      benchmark::Counter(painted, benchmark::Counter::kIsIterationInvariantRate);
}

void fill_by(benchmark::State& state, Method method) {
  const Scene& picture = scene(static_cast<int>(state.range(0)));
  state.SetLabel(scene_name(static_cast<int>(state.range(0))));
  Filled filled;
  for (auto _ : state) {
    state.PauseTiming();
    Canvas canvas = picture.canvas;
    state.ResumeTiming();
    filled = fill_raster(canvas, picture.seed, std::uint8_t{2}, method);
    benchmark::DoNotOptimize(canvas.cells().data());
  }
  // Questions, counted apart from the timing
  Canvas canvas = picture.canvas;
  std::int64_t questions = 0;
  const auto inside = [&](ivec2 p) {
    ++questions;
    return canvas.contains(p) && canvas[p] == 0;
  };
  fill(method, picture.seed, inside, [&](ivec2 p) { canvas[p] = 2; });
  report(state, picture, filled);
  state.counters["questions_per_cell"] = static_cast<double>(questions) / static_cast<double>(filled.painted);
}

void BM_DepthFirst(benchmark::State& state) { fill_by(state, Method::depth_first); }
void BM_BreadthFirst(benchmark::State& state) { fill_by(state, Method::breadth_first); }
void BM_Span(benchmark::State& state) { fill_by(state, Method::span); }

void BM_SpanRows(benchmark::State& state) {
  const Scene& picture = scene(static_cast<int>(state.range(0)));
  state.SetLabel(scene_name(static_cast<int>(state.range(0))));
  Filled filled;
  for (auto _ : state) {
    state.PauseTiming();
    Canvas canvas = picture.canvas;
    state.ResumeTiming();
    filled = fill_rows(canvas, picture.seed, std::uint8_t{2});
    benchmark::DoNotOptimize(canvas.cells().data());
  }
  report(state, picture, filled);
}

// --- Where the recursion overflows -------------------------------

/// The notes' listing, nearly to the letter: everything but the position is global.
Canvas* notes_canvas = nullptr;
void notes_fill(int x, int y, int target, int color) {
  if (x < 0 || x >= notes_canvas->width() || y < 0 || y >= notes_canvas->height()) return;
  if ((*notes_canvas)[{x, y}] != target) return;
  (*notes_canvas)[{x, y}] = static_cast<std::uint8_t>(color);
  notes_fill(x + 1, y, target, color);
  notes_fill(x - 1, y, target, color);
  notes_fill(x, y + 1, target, color);
  notes_fill(x, y - 1, target, color);
}

void* run_notes(void* canvas) {
  notes_canvas = static_cast<Canvas*>(canvas);
  notes_fill(0, 0, 0, 2);
  return nullptr;
}

void* run_recursive(void* canvas) {
  auto& c = *static_cast<Canvas*>(canvas);
  recursive({0, 0}, [&](ivec2 p) { return c.contains(p) && c[p] == 0; }, [&](ivec2 p) { c[p] = 2; });
  return nullptr;
}

/// Whether an empty canvas of n x n is filled from its corner on a stack of 8 MiB. In a child, since it may
/// crash.
bool survives(void* (*run)(void*), int n) {
  const pid_t child = fork();
  if (child == 0) {
    Canvas canvas(n, n);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{8} << 20);
    pthread_t thread;
    if (pthread_create(&thread, &attributes, run, &canvas) != 0) _exit(3);
    pthread_join(thread, nullptr);
    _exit(std::count(canvas.cells().begin(), canvas.cells().end(), 2) == std::int64_t{n} * n ? 0 : 4);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) throw std::runtime_error("no child process");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return true;
  if (WIFSIGNALED(status)) return false;
  throw std::runtime_error("the child failed in another way");
}

void overflow(benchmark::State& state, void* (*run)(void*)) {
  int fine = 16, crashes = 2048;
  for (auto _ : state) {
    fine = 16, crashes = 2048;
    if (!survives(run, fine) || survives(run, crashes)) throw std::logic_error("the range is wrong");
    while (crashes - fine > 1) {
      const int middle = (fine + crashes) / 2;
      (survives(run, middle) ? fine : crashes) = middle;
    }
  }
  state.counters["side_that_overflows"] = crashes;
  state.counters["bytes_per_call"] = static_cast<double>(std::size_t{8} << 20) / (1.0 * fine * fine);
}

void BM_RecursionOverflows(benchmark::State& state) { overflow(state, run_recursive); }
void BM_NotesRecursionOverflows(benchmark::State& state) { overflow(state, run_notes); }

BENCHMARK(BM_DepthFirst)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_BreadthFirst)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Span)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SpanRows)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RecursionOverflows)->Iterations(1);
BENCHMARK(BM_NotesRecursionOverflows)->Iterations(1);

}  // namespace
}  // namespace gradus::flood_fill
