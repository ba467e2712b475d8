// How long the textbook chain takes for a picture, and how fast models are read.

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/arithmetic/elementary.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/models/obj.hpp"

namespace gradus::bench {
namespace {

/// A ball of 2 n^2 triangles as the text of an OBJ file.
std::string ball(int n) {
  constexpr double pi = 0x1.921fb54442d18p1;
  std::string text;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const SinCos a = sin_cos(pi * i / n), b = sin_cos(2 * pi * j / n);
      text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", a.sin * b.cos, a.cos, -a.sin * b.sin);
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

pipeline::ModelFile parse(const std::string& text) {
  return pipeline::parse_obj(text, "ball.obj", [](const std::string&) { return std::nullopt; });
}

Case reading(int n, Workload workload) {
  const auto text = std::make_shared<std::string>(ball(n));
  const auto count = std::make_shared<std::int64_t>();
  return {.method = "parse_obj",
          .standing = Standing::taught,
          .workload = std::move(workload),
          .items = std::int64_t{2} * n * n,
          .run = [text, count] { *count = triangle_count(parse(*text).mesh); }};
}

Case picture(int n, pipeline::Size size, std::string method, Workload workload) {
  const double aspect = static_cast<double>(size.width) / size.height;
  const auto scene = std::make_shared<pipeline::Scene>(pipeline::scene_of(parse(ball(n)).mesh, aspect));
  const auto image = std::make_shared<Image>();
  return {.method = std::move(method),
          .standing = Standing::taught,
          .workload = std::move(workload),
          .items = std::int64_t{2} * n * n,
          .run = [scene, size, image] { *image = pipeline::render(*scene, size); }};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int n : {8, 32, 128, 256}) {
    const Workload workload{fmt::format("ball of {} triangles", 2 * n * n), 2.0 * n * n};
    all.push_back(reading(n, workload));
    all.push_back(picture(n, {200, 150}, "render, 200 x 150", workload));
    all.push_back(picture(n, {800, 600}, "render, 800 x 600", workload));
  }
  return all;
}

}  // namespace

Subject textbook_chain() {
  return {.topic = "textbook_chain",
          .title = "A model becomes a picture",
          .item = "triangle",
          .measure = "triangles of the model",
          .cases = cases};
}

}  // namespace gradus::bench
