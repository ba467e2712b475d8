// A camera that goes once round: on a circle, back where it began, and nothing ever out of the picture.

#include "scene/camera/turntable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"
#include "support/random_scenes.hpp"
#include "support/seed.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::turntable_test {
namespace {

std::vector<Object> random_objects(Random& random) {
  std::vector<Object> objects;
  for (auto count = random.uniform_int(1, 4); count > 0; --count)
    objects.push_back(test::random_object(random));
  return objects;
}

double between(dvec3 a, dvec3 b) { return glm::length(a - b); }

/// Expects every corner to be within the picture; returns how near the border the outermost comes, at most 1.
double expect_all_seen(const std::vector<Object>& objects, const SceneCamera& camera, double aspect) {
  const Projection<double> p = projection_of(camera.lens, aspect);
  double outermost = 0;
  for (const Object& object : objects) {
    for (const Corner& corner : object.mesh->corners) {
      const dvec3 world = affine_3d::transform(object.placement, position_of(*object.mesh, corner));
      const dvec3 seen = viewing::to_view(camera.frame, world);
      EXPECT_GT(seen.z, 0);
      outermost =
          std::max({outermost, std::abs(seen.x * p.x_scale / seen.z), std::abs(seen.y * p.y_scale / seen.z)});
    }
  }
  EXPECT_LE(outermost, 0.92) << "the margin is a twentieth on either side";
  return outermost;
}

TEST(Turntable, AllIsSeenInEveryFrame) {
  double near_the_border = 0;
  constexpr int cases = 60, frames = 30;
  for (std::uint64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", case " << i);
    Random random(test::seed(), i);
    const std::vector<Object> objects = random_objects(random);
    View view;
    if (i % 3 == 1) view.up = dvec3{0, 0, 1};
    if (i % 3 == 2) view.up = dvec3{1, 2, -0.5};
    const double aspect = random.uniform(0.4, 2.5);
    const CameraPath path = turntable(objects, view, aspect, frames);
    double outermost = 0;
    for (int frame = 0; frame < frames; ++frame) {
      const View at = view_at(path, view, frame);
      const SceneCamera camera = camera_of(aim_of(objects, at, aspect), at, objects, aspect);
      outermost = std::max(outermost, expect_all_seen(objects, camera, aspect));
    }
    near_the_border += outermost / cases;
  }
  EXPECT_GT(near_the_border, 0.7) << "and not from needlessly far away";
}

TEST(Turntable, EachFrameIsTheNextPartOfACircle) {
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", case " << i);
    Random random(test::seed(), i);
    const std::vector<Object> objects = random_objects(random);
    View view;
    if (i % 2 == 0) view.eye = 20.0 * test::random_point(random, 1) + dvec3{9, 1, 8};
    if (i % 4 == 0) view.target = test::random_point(random, 2);
    const int frames = static_cast<int>(random.uniform_int(1, 90));
    const CameraPath path = turntable(objects, view, 1.5, frames);
    ASSERT_EQ(std::ssize(path.eye), frames);
    EXPECT_EQ(path.last, frames - 1);
    if (view.eye) EXPECT_LT(between(path.eye[0].value, *view.eye), 1e-12 * (1 + glm::length(*view.eye)));
    if (view.eye && view.target) EXPECT_LT(between(path.target[0].value, *view.target), 1e-12 * 10);
    // A step further, and from the last frame to the first, is the same turn
    const dvec3 axis = unit_vector(path.up[0].value), first = path.eye[0].value;
    for (int k = 0; k < frames; ++k) {
      const dvec3 here = path.eye[static_cast<std::size_t>(k)].value,
                  next = path.eye[static_cast<std::size_t>((k + 1) % frames)].value;
      EXPECT_NEAR(glm::dot(here - first, axis), 0, 1e-11 * (1 + glm::length(first)));
      EXPECT_NEAR(between(here, next), between(first, path.eye[static_cast<std::size_t>(1 % frames)].value),
                  1e-11 * (1 + glm::length(first)));
      if (frames > 2) {  // counter-clockwise seen from above
        const dvec3 target = path.target[static_cast<std::size_t>(k)].value;
        EXPECT_GE(glm::dot(axis, glm::cross(here - target, next - here)), -1e-9);
      }
    }
  }
}

TEST(Turntable, RefusesNumbersOfFramesOutOfRange) {
  Random random(1);
  const std::vector<Object> objects = random_objects(random);
  for (const int frames : {0, -1, most_turntable_frames + 1})
    EXPECT_THROW(turntable(objects, {}, 1, frames), ContractViolation);
}

}  // namespace
}  // namespace gradus::pipeline::turntable_test
