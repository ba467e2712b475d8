// How the engine's time grows with the pixels of a picture.

#include <fmt/format.h>

#include "benchmark/pipeline/engine_picture.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;
using engine_scenes::picture_of_sphere;

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int side : {128, 256, 512, 1024, 2048, 4096}) {
    for (const Shading shading : {Shading::gouraud, Shading::phong})
      all.push_back(picture_of_sphere(23, {side, side}, shading,
                                      {fmt::format("{0} x {0} pixels", side), 1.0 * side * side}));
  }
  return all;
}

}  // namespace

Subject engine_pixels() {
  return {.topic = "engine_pixels",
          .title = "The engine: a sphere of 1,012 triangles",
          .item = "picture",
          .measure = "pixels",
          .cases = cases};
}

}  // namespace gradus::bench
