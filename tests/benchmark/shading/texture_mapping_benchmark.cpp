// A chequered floor to the horizon, textured by each filter: how far its pixels are from the mean of what
// they cover, and what a pixel takes.

#include "shading/texture_mapping/texture_mapping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/raster.hpp"
#include "shading/texture_mapping/texture_mapping_notes.hpp"

namespace gradus::bench {
namespace {

using namespace texture_mapping;
using Picture = Raster<double>;

constexpr int width = 128, samples = 16, texels = 512;
constexpr Extent texture{{texels, texels}};

/// Thirty-two squares either way, sixteen texels each.
double checker(ivec2 at) { return (at.x / 16 + at.y / 16) % 2 == 0 ? 0.1 : 0.9; }

/// A square floor in perspective, `far` times as far behind as in front, cut along a diagonal.
struct Floor {
  std::array<Triangle, 2> triangles;
  std::array<Corners<double>, 2> corners;

  explicit Floor(double far, int scale = 1) {
    const double half = 0.5 * width, narrow = half / far;
    const std::array<dvec2, 4> at{dvec2{0, width}, {width, width}, {half + narrow, 0}, {half - narrow, 0}};
    const std::array<dvec2, 4> uv{dvec2{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const std::size_t k : {0U, 1U}) {
      const std::array<std::size_t, 3> ring{0, k + 1, k + 2};
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t v = ring[c];
        triangles[k][c] = triangle_coverage::snap(at[v]) * scale;
        corners[k][c] = {v >= 2 ? 1 / far : 1, uv[v]};
      }
    }
  }
  template <class Plot>
  void map(const Window& window, const Plot& plot) const {
    for (const std::size_t k : {0U, 1U}) perspective_correct(triangles[k], corners[k], window, plot);
  }
};

constexpr Window window{{0, 0}, {width - 1, width - 1}};

/// The mean of 16 x 16 samples per pixel; less than 0 where not all of them lie on the floor.
Picture reference(double far) {
  Picture sum(width, width), count(width, width);
  const Window fine{{0, 0}, {samples * width - 1, samples * width - 1}};
  Floor(far, samples).map(fine, [&](ivec2 p, dvec2 uv, const auto&) {
    sum[p / samples] += nearest(uv, texture, checker);
    count[p / samples] += 1;
  });
  for (std::size_t k = 0; k < sum.cells().size(); ++k) {
    const double all = count.cells()[k];
    sum.cells()[k] = all == samples * samples ? sum.cells()[k] / all : -1;
  }
  return sum;
}

template <class Paint>
Case case_of(double far, const Picture& right, const char* name, Standing standing, const Paint& paint) {
  const auto floor = std::make_shared<Floor>(far);
  const auto out = std::make_shared<Picture>(width, width);
  const auto run = [=] { paint(*floor, *out); };
  run();
  Error::Sum sum;
  std::int64_t pixels = 0;
  for (std::size_t k = 0; k < right.cells().size(); ++k) {
    if (right.cells()[k] < 0) continue;
    sum.add(std::abs(out->cells()[k] - right.cells()[k]));
  }
  floor->map(window, [&](ivec2, dvec2, const auto&) { ++pixels; });
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("{} times as far", far), far},
          .items = pixels,
          .run = run,
          .error = sum.error()};
}

std::vector<Case> cases() {
  const auto levels = std::make_shared<std::vector<double>>(texels_of_chain(texture.size));
  build_mip_chain(texture.size, checker, std::span(*levels));
  std::vector<Case> all;
  for (const double far : {2, 4, 8, 16, 32}) {
    const Picture right = reference(far);
    all.push_back(case_of(far, right, "nearest", Standing::robust, [](const Floor& floor, Picture& out) {
      floor.map(window, [&](ivec2 p, dvec2 uv, const auto&) { out[p] = nearest(uv, texture, checker); });
    }));
    all.push_back(case_of(far, right, "bilinear", Standing::robust, [](const Floor& floor, Picture& out) {
      floor.map(window, [&](ivec2 p, dvec2 uv, const auto&) { out[p] = bilinear(uv, texture, checker); });
    }));
    all.push_back(
        case_of(far, right, "mip_mapped", Standing::taught, [levels](const Floor& floor, Picture& out) {
          const MipChain<double> chain(texture.size, *levels);
          floor.map(window, [&](ivec2 p, dvec2 uv, const auto& footprint) {
            out[p] = mip_mapped(uv, footprint, chain);
          });
        }));
    all.push_back(case_of(far, right, "affine", Standing::faulty, [](const Floor& floor, Picture& out) {
      for (const std::size_t k : {0U, 1U}) {
        affine(floor.triangles[k], floor.corners[k], window,
               [&](ivec2 p, dvec2 uv, const auto&) { out[p] = nearest(uv, texture, checker); });
      }
    }));
  }
  return all;
}

}  // namespace

Subject texture_mapping() {
  return {.topic = "texture_mapping",
          .title = "Texturing a floor",
          .item = "pixel",
          .unit = "parts of full light",
          .measure = "times as far behind as in front",
          .telling = "8 times as far",
          .cases = cases,
          .choice = {"mip_mapped", "no aliases however far away, in the same time everywhere"}};
}

}  // namespace gradus::bench
