// Triangles that share a plane: what snapping takes of it beyond their own depths hides nothing before them.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "antialiasing/area_sampling/visible_picture.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::area_sampling {
namespace {

/// The area in which any triangle but a first few is seen, in pixels.
double seen_behind(const std::vector<ScreenTriangle>& triangles, int first) {
  double area = 0;
  const auto is_behind = [&](int triangle, ivec2, const Weights&) { return triangle >= first ? 1.0 : 0.0; };
  visible_areas(triangles, {{8, 0}, {12, 3}}, is_behind, [&](ivec2, double sum, double) { area += sum; });
  return area;
}

/// A rectangle over the rows, as two triangles.
void add_rectangle(std::vector<ScreenTriangle>& triangles, ivec2 columns, dvec2 depths,
                   std::optional<DepthPlane> plane = {}) {
  const ivec2 a{columns.x, 0}, b{columns.y, 0}, c{columns.y, 1024}, d{columns.x, 1024};
  triangles.push_back({{a, b, c}, {depths.x, depths.y, depths.y}, plane});
  triangles.push_back({{a, c, d}, {depths.x, depths.y, depths.x}, plane});
}

TEST(AreaSamplingSharedPlane, NothingBehindAPosterShinesThrough) {
  Random random(test::seed());
  int beyond = 0;
  for (int round = 0; round < 300; ++round) {
    // A wall seen nearly edge-on, its sides somewhere between two places of the grid
    const dvec2 sides{random.uniform(2400, 2700), random.uniform(2720, 2800)},
        depths{0.2, random.uniform(0.3, 0.9)};
    const ivec2 snapped{static_cast<int>(std::floor(sides.x + 0.5)),
                        static_cast<int>(std::floor(sides.y + 0.5))};
    const double right = (depths.y - depths.x) / (sides.y - sides.x);
    const DepthPlane plane{{sides.x, 0}, depths.x, right, 0};
    // A poster just before it
    const double before = depths.x - 0x1p-30;
    beyond += plane.at(ivec2{snapped.x, 0}) < before;
    std::vector<ScreenTriangle> triangles;
    add_rectangle(triangles, {2048, 3328}, {before, before});
    add_rectangle(triangles, snapped, depths, plane);
    EXPECT_EQ(seen_behind(triangles, 2), 0) << "seed " << test::seed() << ", round " << round;
    // A poster just behind it hides nothing
    triangles.clear();
    const double after = depths.y + 0x1p-30;
    add_rectangle(triangles, snapped, depths, plane);
    add_rectangle(triangles, snapped, {after, after});
    EXPECT_NEAR(seen_behind(triangles, 2), 0, 1e-12) << "seed " << test::seed() << ", round " << round;
  }
  EXPECT_GT(beyond, 100);
}

TEST(AreaSamplingSharedPlane, TwinsAreStillOne) {
  Random random(test::seed());
  for (int round = 0; round < 100; ++round) {
    const dvec2 sides{random.uniform(2400, 2700), random.uniform(2720, 2800)}, depths{0.2, 0.7};
    const ivec2 snapped{static_cast<int>(std::floor(sides.x + 0.5)),
                        static_cast<int>(std::floor(sides.y + 0.5))};
    const DepthPlane plane{{sides.x, 0}, depths.x, 0.5 / (sides.y - sides.x), 0};
    std::vector<ScreenTriangle> triangles;
    add_rectangle(triangles, snapped, depths, plane);
    add_rectangle(triangles, snapped, depths, plane);
    EXPECT_NEAR(seen_behind(triangles, 2), 0, 1e-12) << "seed " << test::seed() << ", round " << round;
  }
}

}  // namespace
}  // namespace gradus::area_sampling
