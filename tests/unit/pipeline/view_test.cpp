#include "scene/camera/view.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "projection/viewing/viewing.hpp"

namespace gradus::pipeline::view_test {
namespace {

/// The unit cube's corners round (1, 2, 3), as a closed tetrahedron that touches all sides of its box.
Object body() {
  Mesh mesh;
  for (const dvec3 at : {dvec3{0, 0, 0}, dvec3{1, 1, 0}, dvec3{1, 0, 1}, dvec3{0, 1, 1}}) {
    mesh.positions.push_back(at + dvec3{0.5, 1.5, 2.5});
  }
  constexpr std::array<std::array<int, 3>, 4> faces{{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  for (const auto& [a, b, c] : faces) add_face(mesh, std::array{Corner{a}, Corner{b}, Corner{c}});
  return object_of(mesh);
}

bool near(dvec3 a, dvec3 b) { return glm::length(a - b) < 1e-9; }

TEST(View, NothingToldShowsAllFromTheFront) {
  const Object object = body();
  ASSERT_FALSE(object.two_sided);
  const Aim aim = aim_of(object, {}, 1);
  EXPECT_TRUE(leads_somewhere(aim) && tells_upright(aim));
  EXPECT_TRUE(near(aim.up, {0, 1, 0}));
  EXPECT_GT(aim.eye.z, 4) << "in front";
  const Camera camera = camera_of(aim, 0.7, object);
  for (const dvec3 at : object.mesh->positions) {
    const dvec3 v = viewing::to_view(camera.frame, at);
    EXPECT_LT(camera.lens.near, v.z);
    EXPECT_GT(camera.lens.far, v.z);
    EXPECT_LT(std::abs(v.y / v.z), 0.7) << "in the picture";
  }
}

/// The same body, magnified by a power of two.
Object magnified(const Object& object, int exponent) {
  Mesh mesh = *object.mesh;
  for (dvec3& at : mesh.positions) at *= std::ldexp(1.0, exponent);
  return object_of(mesh);
}

TEST(View, SizeMakesNoDifference) {
  const Aim one = aim_of(body(), {}, 1);
  for (const int exponent : {-1000, -900, -600, -540, -100, 90}) {
    SCOPED_TRACE(exponent);
    const Object object = magnified(body(), exponent);
    EXPECT_FALSE(object.two_sided);
    const Aim aim = aim_of(object, {}, 1);
    const double scale = std::ldexp(1.0, exponent);
    EXPECT_TRUE(aim.eye == scale * one.eye && aim.target == scale * one.target) << "the same, magnified";
    EXPECT_TRUE(leads_somewhere(aim) && tells_upright(aim));
  }
}

TEST(View, PointsThatAreHardlyApartAreSeenFromAPlaceThatIs) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double far : {0.0, 1e-300, 1.0, 1000.0, 1e20, 1e30}) {
    for (const double step : {0.0, std::nextafter(far, inf) - far, 2 * (std::nextafter(far, inf) - far)}) {
      for (const dvec3 way : {dvec3{1, 1, 0}, dvec3{0, 1, 1}, dvec3{1, 0, 1}}) {
        Mesh mesh;
        mesh.positions = {dvec3{far}, dvec3{far} + step * way,
                          dvec3{far} + step * dvec3{way.z, way.x, way.y}};
        add_face(mesh, std::array{Corner{0}, Corner{1}, Corner{2}});
        const Aim aim = aim_of(object_of(mesh), {}, 1.5);
        EXPECT_TRUE(leads_somewhere(aim) && tells_upright(aim)) << far << " and " << step;
      }
    }
  }
}

TEST(View, WhereZIsUpTheFrontIsMinusY) {
  const Aim aim = aim_of(body(), {.eye = {}, .target = {}, .up = dvec3{0, 0, 5}}, 1);
  EXPECT_LT(aim.eye.y, 1) << "the eye stands at -y";
  EXPECT_GT(aim.eye.z, 3) << "and above";
  EXPECT_GT(viewing::look_at(aim.eye, aim.target, aim.up).up.z, 0.9);
}

TEST(View, WhatIsToldIsTaken) {
  const Object object = body();
  const Aim from = aim_of(object, {.eye = dvec3{9, 2, 3}, .target = {}, .up = {}}, 2);
  EXPECT_TRUE(near(from.eye, {9, 2, 3}));
  EXPECT_TRUE(near(from.target, {1, 2, 3})) << "the middle";
  const Aim to = aim_of(object, {.eye = {}, .target = dvec3{0, 0, 0}, .up = {}}, 2);
  EXPECT_TRUE(near(to.eye, aim_of(object, {}, 2).eye)) << "the eye stays where it was";
  EXPECT_TRUE(near(to.target, {0, 0, 0}));
}

TEST(View, SeenFromStraightAboveMinusZIsUp) {
  EXPECT_TRUE(near(aim_of(body(), {.eye = dvec3{1, 9, 3}, .target = {}, .up = {}}, 1).up, {0, 0, -1}));
  EXPECT_TRUE(near(aim_of(body(), {.eye = dvec3{1, -9, 3}, .target = {}, .up = {}}, 1).up, {0, 0, -1}));
  EXPECT_TRUE(near(aim_of(body(), {.eye = dvec3{1.1, 9, 3}, .target = {}, .up = {}}, 1).up, {0, 1, 0}));
}

TEST(View, APathThatComesNearStraightAboveDoesNotJump) {
  // Towards the point above the middle, along a line that misses it by 0.01: by the turn a step can make
  const Object object = body();
  const auto right_at = [&](double x) {
    const Aim aim = aim_of(object, {.eye = dvec3{1 + x, 9, 3.01}, .target = dvec3{1, 2, 3}, .up = {}}, 1);
    return viewing::look_at(aim.eye, aim.target, aim.up).right;
  };
  constexpr double step = 1e-4;
  for (int i = -10'000; i < 10'000; ++i) {
    const dvec3 a = right_at(step * i), b = right_at(step * (i + 1));
    ASSERT_LE(glm::length(b - a), 1.01 * step / 0.01) << "x = " << step * i;
  }
}

TEST(View, TellsWhatLeavesThePictureUndetermined) {
  const Object object = body();
  EXPECT_FALSE(leads_somewhere(aim_of(object, {.eye = dvec3{1, 2, 3}, .target = {}, .up = {}}, 1)));
  const Aim along = aim_of(object, {.eye = dvec3{1, 2, 9}, .target = {}, .up = dvec3{0, 0, 3}}, 1);
  EXPECT_TRUE(leads_somewhere(along));
  EXPECT_FALSE(tells_upright(along));
  EXPECT_THROW(aim_of(object, {.eye = {}, .target = {}, .up = dvec3{0}}, 1), ContractViolation);
}

TEST(View, APlacedObjectIsSeenWhereItStands) {
  Object object = body();
  const Aim here = aim_of(object, {}, 1);
  object.placement[3] = {100, 0, 0, 1};
  const Aim there = aim_of(object, {}, 1);
  EXPECT_TRUE(near(there.eye - here.eye, {100, 0, 0}));
  EXPECT_TRUE(near(there.target - here.target, {100, 0, 0}));
}

}  // namespace
}  // namespace gradus::pipeline::view_test
