// Fans of triangles of several sizes by every way to ask for their pixels; wrong are pixels that are drawn
// otherwise than 128-bit integers say, each as often as that happens.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "core/raster.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"

namespace gradus::bench {
namespace {

using namespace triangle_coverage;

__extension__ typedef __int128 Wide;

constexpr int side = 512;
constexpr Window picture{{0, 0}, {side - 1, side - 1}};

/// So many pairs of triangles that share a side, of about `reach` pixels.
struct Mix {
  const char* name;
  int pairs, reach;
};
constexpr Mix mixes[]{{"small", 4096, 4}, {"medium", 512, 32}, {"large", 32, 256}};

struct Scene {
  std::vector<Triangle> triangles;
  Raster<int> right{side, side};  ///< how often each pixel is covered
  std::int64_t tested = 0;

  explicit Scene(const Mix& mix) {
    Random random(11);
    const auto corner = [&](double x, double y) {
      // Half of them on centres and borders of pixels, where edges decide
      const auto beside = [&](double at) { return at + random.uniform(0, mix.reach); };
      const dvec2 p{beside(x), beside(y)};
      return random.unit() < 0.5 ? snap(p) : snap(glm::floor(2.0 * p) / 2.0);
    };
    for (int i = 0; i < mix.pairs; ++i) {
      const double x = random.uniform(0, side - mix.reach), y = random.uniform(0, side - mix.reach);
      const ivec2 a = corner(x, y), b = corner(x, y), c = corner(x, y);
      triangles.push_back({a, b, c});
      triangles.push_back({b, a, b + a - c});
    }
    for (const Triangle& t : triangles) count_right(t);
  }

  /// By areas in 128 bits, each for itself: nothing is added up from pixel to pixel.
  void count_right(const Triangle& t) {
    const Window box = centres(t, picture);
    if (doubled_area(t) == 0 || box.empty()) return;
    const Edges edges = edges_of(t);
    for (int y = box.lower.y; y <= box.upper.y; ++y) {
      for (int x = box.lower.x; x <= box.upper.x; ++x) {
        ++tested;
        right[{x, y}] += std::ranges::all_of(edges, [&](const Edge& edge) {
          const ivec2 p = centre_of({x, y}), way = edge.to - edge.from, to = p - edge.from;
          const Wide area = Wide{way.x} * to.y - Wide{way.y} * to.x;
          return area > 0 || (area == 0 && edge.owns);
        });
      }
    }
  }
};

/// The case of a way to draw a triangle into counts.
template <class Draw>
Case case_of(const Mix& mix, const std::shared_ptr<Scene>& scene, std::string name, Standing standing,
             Draw draw) {
  const auto hits = std::make_shared<Raster<int>>(side, side);
  const auto run = [=] {
    for (const Triangle& t : scene->triangles) draw(t, *hits);
  };
  run();
  Error::Sum sum;
  for (std::size_t i = 0; i < hits->cells().size(); ++i) {
    const int off = hits->cells()[i] - scene->right.cells()[i];
    sum.add(off);
    if (off != 0) sum.wrong_decision();
  }
  return {.method = std::move(name),
          .standing = standing,
          .workload = {mix.name, static_cast<double>(mix.reach)},
          .items = scene->tested,
          .run = run,
          .prepare = [hits] { std::ranges::fill(hits->cells(), 0); },
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Mix& mix : mixes) {
    const auto scene = std::make_shared<Scene>(mix);
    const auto add = [&](const char* name, Standing standing, auto cover_with) {
      all.push_back(case_of(mix, scene, name, standing, [cover_with](const Triangle& t, Raster<int>& hits) {
        cover_with(t, [&](ivec2 p, const Weights&) { ++hits[p]; });
      }));
    };
    add("cover", Standing::taught, [](const Triangle& t, auto plot) { cover(t, picture, plot); });
    add("closed_half_planes", Standing::faulty,
        [](const Triangle& t, auto plot) { closed_half_planes(t, picture, plot); });
    add("expanded_edges", Standing::faulty,
        [](const Triangle& t, auto plot) { expanded_edges(t, {1e8, 1e8}, picture, plot); });
  }
  return all;
}

}  // namespace

Subject triangle_coverage() {
  return {.topic = "triangle_coverage",
          .title = "Pixels of triangles",
          .item = "tested pixel",
          .unit = "hits of a pixel",
          .measure = "pixels a triangle is wide",
          .telling = "medium",
          .cases = cases,
          .choice = {"cover", "every pixel belongs to one triangle, decided exactly"}};
}

}  // namespace gradus::bench
