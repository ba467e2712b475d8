// How fast models are read, and how long a picture takes.

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <string>

#include "pipeline.hpp"
#include "scene/obj.hpp"

namespace gradus::pipeline {
namespace {

/// A ball of 2 n^2 triangles as the text of an OBJ file.
std::string ball(int n) {
  std::string text;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = 3.141592653589793 * i / n, b = 6.283185307179586 * j / n;
      text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", std::sin(a) * std::cos(b), std::cos(a),
                          -std::sin(a) * std::sin(b));
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int p = i * n + j + 1, q = i * n + (j + 1) % n + 1;
      text += fmt::format("f {} {} {}\nf {} {} {}\n", p, p + n, q + n, p, q + n, q);
    }
  }
  return text;
}

ModelFile parse(const std::string& text) {
  return parse_obj(text, "ball.obj", [](const std::string&) { return std::nullopt; });
}

void BM_ReadObj(benchmark::State& state) {
  const std::string text = ball(static_cast<int>(state.range(0)));
  std::int64_t triangles = 0;
  for (auto _ : state) triangles = triangle_count(parse(text).mesh);
  state.SetItemsProcessed(state.iterations() * triangles);
}
BENCHMARK(BM_ReadObj)->Arg(224)->Arg(708)->Unit(benchmark::kMillisecond);

void BM_Render(benchmark::State& state) {
  const Scene scene = scene_of(parse(ball(static_cast<int>(state.range(0)))).mesh, 4.0 / 3);
  for (auto _ : state) benchmark::DoNotOptimize(render(scene, {800, 600}));
}
BENCHMARK(BM_Render)->Arg(16)->Arg(224)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gradus::pipeline
