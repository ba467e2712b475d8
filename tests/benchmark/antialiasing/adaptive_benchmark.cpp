// Random triangles, large and small, that pierce each other: without antialiasing, with all samples
// everywhere, and adaptive, with more and more samples.

#include "antialiasing/adaptive/adaptive.hpp"

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <memory>

#include "benchmark/subject.hpp"
#include "support/screen_triangles.hpp"

namespace gradus::bench {
namespace {

using namespace gradus::adaptive;

constexpr int width = test::pierced_width;
constexpr Window sheet{{0, 0}, {width - 1, width - 1}};

/// Each with a colour that changes across it.
dvec3 colour_of(int triangle, ivec2, const Weights& w) {
  const dvec3 shares = triangle_coverage::barycentric(w);
  return 0.2 + 0.6 * dvec3(shares.x, 0.15 * (triangle % 6), shares.z);
}

using Picture = Raster<dvec3>;
auto into(Picture& picture) {
  return [&picture](ivec2 p, const dvec3& sum, double) { picture[p] = sum; };
}

struct Scene {
  std::vector<ScreenTriangle> triangles = test::pierced_triangles();
  Picture right{width, width};

  Scene() {
    const auto always = [](const auto&, const auto&) { return 1.0; };
    adaptive_contrast(triangles, sheet, n_rooks(256), always, 0, colour_of, into(right));
  }
};

template <class Draw>
Case case_of(const std::shared_ptr<Scene>& scene, std::string name, Standing standing, Workload workload,
             Draw draw) {
  const auto picture = std::make_shared<Picture>(width, width);
  const auto run = [=] { draw(*scene, into(*picture)); };
  run();
  // A picture has one error: the root of the mean square
  Error::Sum pixels, sum;
  for (std::size_t i = 0; i < picture->cells().size(); ++i) {
    const dvec3 off = picture->cells()[i] - scene->right.cells()[i];
    for (int k = 0; k < 3; ++k) pixels.add(off[k]);
  }
  sum.add(pixels.error().rms);
  return {.method = std::move(name),
          .standing = standing,
          .workload = std::move(workload),
          .items = std::int64_t{width} * width,
          .run = run,
          .error = sum.error()};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto scene = std::make_shared<Scene>();
  for (const int count : {4, 8, 16, 64}) {
    const Workload workload{fmt::format("{} samples", count), static_cast<double>(count)};
    all.push_back(case_of(scene, "none", Standing::taught, workload, [](const Scene& s, const auto& plot) {
      each_sample(s.triangles, sheet, n_rooks(1), colour_of, plot);
    }));
    all.push_back(case_of(scene, "each_sample", Standing::taught, workload,
                          [places = n_rooks(count)](const Scene& s, const auto& plot) {
                            each_sample(s.triangles, sheet, places, colour_of, plot);
                          }));
    all.push_back(case_of(scene, "adaptive", Standing::robust, workload,
                          [places = n_rooks(count)](const Scene& s, const auto& plot) {
                            adaptive::adaptive(s.triangles, sheet, places, colour_of, plot);
                          }));
  }
  return all;
}

}  // namespace

Subject adaptive() {
  return {.topic = "adaptive",
          .title = "Pictures of triangles, sampled",
          .item = "pixel",
          .unit = "parts of white (RMS)",
          .measure = "samples per pixel",
          .telling = "16 samples",
          .cases = cases,
          .choice = {"adaptive", "the picture of each_sample, in less time"}};
}

}  // namespace gradus::bench
