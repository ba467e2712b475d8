// How the engine's time grows with the triangles of a picture.

#include <fmt/format.h>

#include "benchmark/pipeline/engine_picture.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;
using engine_scenes::picture_of_sphere;

std::vector<Case> cases() {
  constexpr Size size{512, 512};
  std::vector<Case> all;
  for (const int n : {71, 123, 224, 388, 708, 1225}) {
    const double triangles = 2.0 * n * (n - 1);
    for (const Shading shading : {Shading::gouraud, Shading::phong})
      all.push_back(
          picture_of_sphere(n, size, shading, {fmt::format("{:.0f} triangles", triangles), triangles}));
  }
  return all;
}

}  // namespace

Subject engine_triangles() {
  return {.topic = "engine_triangles",
          .title = "The engine: a sphere in 512 x 512 pixels",
          .item = "picture",
          .measure = "triangles",
          .cases = cases};
}

}  // namespace gradus::bench
