// Unit vectors, boxes, rays; the ray through a pixel undoes view and projection.

#include "core/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

// Beyond the domain, but never beyond what C++ defines
TEST(Geometry, NoNumberStaysNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 3; ++i) {
    dvec3 v{1, 2, 3};
    v[i] = nan;
    EXPECT_TRUE(std::isnan(length_of(v))) << i;
    EXPECT_TRUE(std::isnan(unit_vector(v)[i])) << i;
  }
  EXPECT_TRUE(std::isnan(length_of(dvec3{nan, nan, nan})));
  EXPECT_FALSE(std::isfinite(length_of(dvec3{std::numeric_limits<double>::infinity(), 0, 0})));
}

TEST(Geometry, UnitVectorsOfAnySize) {
  for (const double size : {1e-310, 1e-200, 1.0, 1e200, 1e308}) {
    const dvec3 u = unit_vector(dvec3{size, -size, 0.5 * size});
    EXPECT_NEAR(glm::distance(u, dvec3{2, -2, 1} / 3.0), 0, size < 1e-300 ? 1e-13 : 1e-15) << size;
  }
  EXPECT_EQ(unit_vector(dvec3{0}), dvec3{0});
  EXPECT_EQ(length_of(dvec3{0}), 0);
  EXPECT_DOUBLE_EQ(length_of(dvec3{3e200, 0, -4e200}), 5e200);
  EXPECT_NEAR(length_of(dvec3{3e-310, 0, -4e-310}), 5e-310, 1e-323);
  EXPECT_EQ(unit_vector(glm::vec3{0, 0, -4}), (glm::vec3{0, 0, -1}));
}

TEST(Geometry, BoundsGrow) {
  Bounds box;
  EXPECT_TRUE(box.empty());
  box.add({1, 2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.radius(), 0);
  box.add({-1, 4, 3});
  EXPECT_EQ(box.centre(), (dvec3{0, 3, 3}));
}

TEST(Camera, TheMiddleRayLooksForward) {
  const Camera camera;
  const Ray ray = ray_through(camera, 640, 480, {320, 240});
  EXPECT_EQ(ray.origin, dvec3{0});
  EXPECT_EQ(ray.direction, (dvec3{0, 0, -1}));
  // Up in the picture is up, right is right
  EXPECT_GT(ray_through(camera, 640, 480, {320, 0}).direction.y, 0);
  EXPECT_GT(ray_through(camera, 640, 480, {640, 240}).direction.x, 0);
  EXPECT_THROW(ray_through(camera, 0, 480, {0, 0}), ContractViolation);
}

TEST(Camera, RaysUndoTheProjection) {
  Random random(test::seed());
  int cases = 0;
  for (; cases < 5000; ++cases) {
    Camera camera;
    camera.lens.vertical_radians = random.uniform(0.05, 3.0);
    camera.frame = {{1, 2, 3}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    const int width = static_cast<int>(random.uniform_int(1, 4000)),
              height = static_cast<int>(random.uniform_int(1, 4000));
    const dvec2 place{random.uniform(-width, 2 * width), random.uniform(-height, 2 * height)};
    const Ray ray = ray_through(camera, width, height, place);
    const double depth = random.uniform(0.2, 900);
    const dvec3 point = ray.origin + depth * ray.direction;
    const glm::dmat4 all =
        projection_matrix(projection_of(camera.lens, double(width) / height)) * view_matrix(camera.frame);
    const glm::dvec4 clip = all * glm::dvec4(point, 1);
    ASSERT_NEAR(clip.w, depth, 1e-10);
    ASSERT_NEAR((clip.x / clip.w + 1) / 2 * width, place.x, 1e-8 * width) << test::seed();
    ASSERT_NEAR((1 - clip.y / clip.w) / 2 * height, place.y, 1e-8 * height);
  }
  EXPECT_EQ(cases, 5000);
}

}  // namespace
}  // namespace gradus
