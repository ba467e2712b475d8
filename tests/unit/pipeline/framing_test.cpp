// Default cameras: everything in the picture, as large as it may be.

#include "scene/camera/framing.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/contract.hpp"
#include "core/random.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewport/viewport.hpp"
#include "scene/files.hpp"
#include "support/change_mesh.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::framing_test {
namespace {

/// Where a camera puts a point: x and y in [-1, 1], depth in [0, 1].
dvec3 seen(const Camera& camera, double aspect, dvec3 point) {
  const dvec3 view = viewing::to_view(camera.frame, point);
  return perspective::divide(perspective::transform(projection_of(camera.lens, aspect), view));
}

TEST(Framing, ABoxThatTouchesTheEyeHasDepthsToo) {
  Bounds bounds;
  bounds.add({0, 0, 0}), bounds.add({1, 1, 1});
  for (const double z : {0.0, 5e-324, 1e-300}) {
    Camera camera;
    camera.frame = viewing::look_at({0, 0, z}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
    const Camera told = with_depths(camera, bounds);
    EXPECT_TRUE(0 < told.lens.near && told.lens.near < told.lens.far) << z << ": " << told.lens.near;
  }
}

TEST(Framing, EverythingIsInThePictureAndFillsIt) {
  Random random(test::seed());
  int cases = 0;
  for (; cases < 3000; ++cases) {
    const auto any = [&](double size) {
      return dvec3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    const double size = std::array{1e-20, 1.0, 1e12}[static_cast<std::size_t>(cases % 3)];
    const dvec3 middle = any(size), stretch = any(1);
    std::vector<dvec3> points;
    for (int i = 0; i < 40; ++i) points.push_back(middle + stretch * any(size));
    const double aspect = random.uniform(0.2, 5);
    const double angle = random.uniform(0.1, 2.5);
    const Camera camera = framed(std::span<const dvec3>(points), aspect, any(1), angle);
    Bounds picture;
    for (const dvec3 p : points) picture.add(seen(camera, aspect, p));
    ASSERT_GE(picture.lower.x, -0.9001) << "case " << cases << ", seed " << test::seed();
    ASSERT_LE(picture.upper.x, 0.9001);
    ASSERT_GE(picture.lower.y, -0.9001);
    ASSERT_LE(picture.upper.y, 0.9001);
    ASSERT_GE(picture.lower.z, 0);
    ASSERT_LE(picture.upper.z, 1);
    // In the middle, and as large as the margin allows
    ASSERT_NEAR(picture.lower.x, -picture.upper.x, 1e-3);
    ASSERT_NEAR(picture.lower.y, -picture.upper.y, 1e-3);
    // (from very near a wide lens would have to go into what it sees)
    if (angle < 1 && aspect < 2) ASSERT_GT(std::max(picture.upper.x, picture.upper.y), 0.899);
  }
  EXPECT_EQ(cases, 3000);
}

TEST(Framing, SpecialCases) {
  Bounds point;
  point.add({5, 6, 7});
  EXPECT_NEAR(glm::distance(seen(framed(point, 1), 1, {5, 6, 7}), dvec3{0, 0, 0.5}), 0, 0.51);
  EXPECT_THROW(framed(Bounds{}, 1), ContractViolation);
  Bounds box = point;
  box.add({6, 7, 8});
  EXPECT_THROW(framed(box, 0), ContractViolation);
  EXPECT_THROW(framed(box, 1, front_right_above, 4), ContractViolation);
  // Straight from above: -z is up
  const Camera above = framed(box, 1, {0, 1, 0});
  EXPECT_NEAR(glm::distance(above.frame.up, dvec3{0, 0, -1}), 0, 1e-15);
  // Somebody else's camera inside the box
  Camera inside;
  inside.frame.eye = {5.5, 6.5, 7.5};
  const Lens lens = with_depths(inside, box).lens;
  EXPECT_GT(lens.near, 0);
  EXPECT_LT(lens.near, 1e-3);
  EXPECT_GT(lens.far, 0.5);
  Camera away;  // looks the other way: a lens all the same
  away.frame.eye = {0, 0, -50};
  EXPECT_GT(with_depths(away, box).lens.far, with_depths(away, box).lens.near);
}

TEST(Framing, RoomsAreSeenFromTheirOpenSide) {
  const std::string models = std::string(GRADUS_SOURCE_DIR) + "/";
  const Object room = object_of(load_obj(models + "tests/support/models/tinyobj/cornell_box.obj").mesh);
  EXPECT_TRUE(room.two_sided);
  EXPECT_EQ(viewing_side(room), (dvec3{0, 0, -1}));
  Object tiny = room;
  test::change_mesh(tiny, [](Mesh& mesh) {
    for (dvec3& at : mesh.positions) at *= 0x1p-1000;
  });
  EXPECT_EQ(viewing_side(tiny), (dvec3{0, 0, -1})) << "whatever its size";
  const Object letter = object_of(load_obj(models + "examples/models/letter_f.obj").mesh);
  EXPECT_FALSE(letter.two_sided);
  EXPECT_EQ(viewing_side(letter), front_right_above);
}

TEST(Framing, LightsShineFromTheViewersSide) {
  Bounds box;
  box.add({0, 0, 0});
  box.add({1, 1, 1});
  const Camera camera = framed(box, 1.5);
  const std::vector<Light> lights = default_lights(camera);
  ASSERT_EQ(lights.size(), 2u);
  for (const Light& light : lights) EXPECT_GT(glm::dot(light.direction, camera.frame.forward), 0);
  EXPECT_LT(glm::dot(lights[0].direction, camera.frame.up), 0);
}

}  // namespace
}  // namespace gradus::pipeline::framing_test
