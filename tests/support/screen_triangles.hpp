#pragma once
// Random triangles of pictures.

#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::test {

/// So many with corners and depths anywhere, some pixels large and beyond a picture of six by six.
inline std::vector<triangle_coverage::ScreenTriangle> triangles_anywhere(Random& random, int count) {
  std::vector<triangle_coverage::ScreenTriangle> triangles;
  for (int i = 0; i < count; ++i) {
    triangle_coverage::ScreenTriangle t;
    for (ivec2& p : t.corners)
      p = {static_cast<int>(random.uniform_int(-200, 1700)),
           static_cast<int>(random.uniform_int(-200, 1700))};
    for (int k = 0; k < 3; ++k) t.depth[k] = random.unit();
    triangles.push_back(t);
  }
  return triangles;
}

/// The side of the picture of pierced_triangles, in pixels.
inline constexpr int pierced_width = 128;

/// Large and small ones that pierce each other: what the benchmark of `adaptive` draws, and what its page
/// tells.
inline std::vector<triangle_coverage::ScreenTriangle> pierced_triangles() {
  Random random(11);
  std::vector<triangle_coverage::ScreenTriangle> triangles;
  for (int i = 0; i < 60; ++i) {
    const double reach = i % 3 == 0 ? 60 : 14, depth = random.uniform(0.2, 0.8);
    const dvec2 middle{random.uniform(0, pierced_width), random.uniform(0, pierced_width)};
    triangle_coverage::ScreenTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec2 off{random.uniform(-reach, reach), random.uniform(-reach, reach)};
      t.corners[k] = triangle_coverage::snap(middle + off);
      t.depth[static_cast<int>(k)] = depth + random.uniform(-0.1, 0.1);
    }
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace gradus::test
