// What a plan decides and says, on scenes where one can see what is right; that no pixel changes by it is the
// property test's.

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/contract.hpp"
#include "plan/cover.hpp"
#include "plan/decisions.hpp"
#include "plan/planned.hpp"
#include "plan/spared.hpp"
#include "support/change_mesh.hpp"
#include "support/random_scenes.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::plan_test {
namespace {

constexpr Size size{64, 64};

/// A camera at the origin that looks along +z and sees a right angle, from 1 to 100 deep.
Scene empty_scene() {
  Scene scene;
  scene.camera.frame = viewing::look_at(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
  scene.camera.lens = {1.5707963267948966, 1, 100};
  return scene;
}

Object cube_at(dvec3 place, double half = 1) {
  Object object = object_of(test::cube(), "cube");
  object.placement = affine_3d::translation(place) * affine_3d::scaling(dvec3{half});
  return object;
}

/// The plan of a scene of one object.
ObjectPlan plan_of_one(const Object& object, Rules rules = Rules::all()) {
  Scene scene = empty_scene();
  scene.objects.push_back(object);
  return plan_of(scene, size, rules).objects.front();
}

TEST(Plan, SaysBeyondWhichSideAnObjectLies) {
  // Of the picture x is to the left where one looks along +z
  const std::vector<std::pair<dvec3, Side>> places{{{15, 0, 10}, Side::left},   {{-15, 0, 10}, Side::right},
                                                   {{0, -15, 10}, Side::lower}, {{0, 15, 10}, Side::upper},
                                                   {{0, 0, -2}, Side::near},    {{0, 0, 102}, Side::far}};
  for (const auto& [place, side] : places) {
    const ObjectPlan plan = plan_of_one(cube_at(place));
    EXPECT_EQ(plan.skipped, Rule::outside) << static_cast<int>(side);
    EXPECT_EQ(plan.beyond, side) << static_cast<int>(side);
    EXPECT_FALSE(plan_of_one(cube_at(place), Rules::none()).skipped) << "no rule, nothing skipped";
  }
  EXPECT_FALSE(plan_of_one(cube_at({11.5, 0, 10})).skipped) << "half of it is in the picture";
}

TEST(Plan, CutsOnlyWhatMayReachBeyondAPlane) {
  EXPECT_TRUE(plan_of_one(cube_at({0, 0, 10})).whole);
  EXPECT_TRUE(plan_of_one(cube_at({11, 0, 10})).whole) << "the sides of the picture cut nothing";
  EXPECT_FALSE(plan_of_one(cube_at({0, 0, 1.5})).whole) << "the near plane";
  EXPECT_FALSE(plan_of_one(cube_at({0, 0, 100})).whole) << "the far plane";
  EXPECT_FALSE(plan_of_one(cube_at({0, 0, 10}), Rules::none()).whole);
}

TEST(Plan, DrawsWhatHasNoSizeThatNumbersHold) {
  Object object = cube_at({0, 0, 10});
  object.placement = affine_3d::scaling(dvec3{1e300, 1e300, 1e300}) * affine_3d::scaling(dvec3{1e20});
  const ObjectPlan plan = plan_of_one(object);
  EXPECT_FALSE(plan.skipped || plan.whole || plan.extent) << "nothing is known of it";
}

TEST(Plan, LeavesOutLightsWhoseRangeEndsBeforeTheObject) {
  Scene scene = empty_scene();
  scene.objects = {cube_at({0, 0, 10})};
  const auto light = [](dvec3 position, double range, Light::Kind kind) {
    Light one;
    one.kind = kind, one.position = position, one.range = range;
    one.direction = {0, 0, 1}, one.across = {4, 0, 0}, one.along = {0, 4, 0};
    return one;
  };
  using enum Light::Kind;
  constexpr double endless = std::numeric_limits<double>::infinity();
  // The cube's nearest point is 9 away; an area reaches up to 4 further
  scene.lights = {light({0, 0, 0}, 9.001, point),   light({0, 0, 0}, 8.999, point),
                  light({0, 0, 0}, 8.999, spot),    light({0, 0, 0}, 1, directional),
                  light({0, 0, 0}, endless, point), light({0, 0, 0}, 5.5, area),
                  light({0, 0, 0}, 4.5, area)};
  EXPECT_EQ(plan_of(scene, size).objects.front().lights, (std::vector{0, 3, 4, 5}));
  EXPECT_EQ(plan_of(scene, size, Rules::none()).objects.front().lights.size(), 7u);
}

TEST(Plan, RefusesAPartThatIsNotInThePicture) {
  for (const Window part : {Window{{0, 0}, {64, 0}}, Window{{-1, 0}, {3, 3}}, Window{{5, 5}, {4, 9}}})
    EXPECT_THROW(plan_of(empty_scene(), size, Rules::all(), part), ContractViolation);
}

// --- What is hidden --------------------------------------------------------------------------------

/// A wall across the view at a depth, from -half to half, of n x n squares.
Object wall_at(double depth, double half, int n) {
  Random random(1);
  Object object = object_of(test::wall(n, 0, random), "wall");
  object.placement = affine_3d::translation(dvec3{0, 0, depth}) * affine_3d::scaling(dvec3{half});
  return object;
}

Plan planned(const Scene& scene) {
  Plan plan = plan_of(scene, size);
  Ledger ledger;
  geometry(scene, plan, ledger);
  return plan;
}

TEST(Plan, FindsWhatIsHiddenWhateverTheOrder) {
  Scene scene = empty_scene();
  scene.objects = {cube_at({0, 0, 30}), cube_at({2, 1, 20}), wall_at(10, 5, 8), cube_at({0, 0, 8}),
                   cube_at({4, 0, 12})};
  const Plan plan = planned(scene);
  EXPECT_EQ(plan.of(0).skipped, Rule::hidden);
  EXPECT_EQ(plan.of(0).behind, 2);
  EXPECT_EQ(plan.of(1).skipped, Rule::hidden);
  EXPECT_FALSE(plan.of(2).skipped);
  EXPECT_FALSE(plan.of(3).skipped) << "before the wall";
  EXPECT_FALSE(plan.of(4).skipped) << "beside its edge";
}

TEST(Plan, AGapHidesNothing) {
  Scene scene = empty_scene();
  Object wall = wall_at(10, 8, 4);
  test::change_mesh(wall, [](Mesh& mesh) { mesh.faces.erase(mesh.faces.begin() + 5); });
  scene.objects = {cube_at({0, 0, 30}, 4), wall};
  EXPECT_FALSE(planned(scene).of(0).skipped);
  scene.objects = {cube_at({0, 0, 30}, 4), wall_at(10, 8, 4)};
  EXPECT_EQ(planned(scene).of(0).skipped, Rule::hidden) << "without the gap";
}

/// Whether triangles cover a place of the 1/256 grid, and how near; by hand, over all of them.
double nearest_at(const std::vector<triangle_coverage::ScreenTriangle>& triangles, ivec2 place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [grid, depth, plane] : triangles) {
    const auto side = [&](ivec2 a, ivec2 b) {
      return std::int64_t{b.x - a.x} * (place.y - a.y) - std::int64_t{b.y - a.y} * (place.x - a.x);
    };
    const std::int64_t u = side(grid[1], grid[2]), v = side(grid[2], grid[0]), w = side(grid[0], grid[1]);
    const bool in = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    if (!in || u + v + w == 0) continue;
    const double area = static_cast<double>(u + v + w);
    nearest = std::min(nearest, (static_cast<double>(u) * depth.x + static_cast<double>(v) * depth.y +
                                 static_cast<double>(w) * depth.z) /
                                    area);
  }
  return nearest;
}

TEST(Plan, EveryPlaceOfAHidingTileIsCoveredAndNearEnough) {
  const std::uint64_t seed = test::seed();
  int hiding = 0, places = 0;
  for (std::uint64_t i = 0; i < 120; ++i) {
    Random random(seed, i);
    Scene scene = test::random_screened_scene(random, 1);
    Plan plan = plan_of(scene, size, Rules::none());
    Ledger ledger;
    const Triangles triangles = geometry(scene, plan, ledger);
    Cover cover(size);
    cover.add(0, triangles);
    const auto on_screen = screen_triangles(triangles, size);
    for (int y = 0; y < size.height; y += tile_pixels) {
      for (int x = 0; x < size.width; x += tile_pixels) {
        const double depth = random.uniform(0, 1);
        const Window tile{{x, y}, {x + tile_pixels - 1, y + tile_pixels - 1}};
        if (cover.hider_of({tile, depth}) < 0) continue;
        ++hiding;
        for (int k = 0; k < 60; ++k, ++places) {
          const int across = tile_pixels * 256;
          const ivec2 place{x * 256 + static_cast<int>(random.uniform_int(0, across)),
                            y * 256 + static_cast<int>(random.uniform_int(0, across))};
          ASSERT_LT(nearest_at(on_screen, place), depth) << "seed " << seed << ", case " << i;
        }
      }
    }
  }
  EXPECT_GT(hiding, 100);
}

// --- In words --------------------------------------------------------------------------------------

std::string told(const Scene& scene, int object) {
  std::string text;
  const Plan plan = planned(scene);
  for (const auto& [stage, work, why] : decisions_on(scene, plan, object))
    text += std::to_string(stage) + " " + std::string(name_of(work)) + (why.empty() ? "" : " (" + why + ")") +
            "\n";
  return text;
}

TEST(Plan, TellsWhyAStageIsLeftOut) {
  Scene scene = empty_scene();
  Light lamp;
  lamp.range = 3;
  scene.lights = {Light{}, lamp};
  scene.objects = {cube_at({0, 0, 10}), cube_at({-20, 0, 10}), cube_at({15, 0, 10}), cube_at({0, 0, 30})};
  EXPECT_EQ(told(scene, 0),
            "1 run\n2 run\n3 run\n4 run (closed and outward: backs are never seen)\n"
            "5 skip (wholly between the planes: nothing is cut)\n6 run\n"
            "7 part (light 2 of 2 beyond its range; no highlight: k_s = 0; no texture)\n");
  // Beside the cube, from in front of the near plane into the range of the second lamp
  scene.objects[1] = wall_at(2, 1, 1);
  scene.objects[1].placement = affine_3d::translation(dvec3{2, 0, 2}) *
                               affine_3d::rotation(dvec3{1, 0, 0}, 1.2) * affine_3d::scaling(dvec3{1.2});
  test::change_materials(scene.objects[1], [](Material& m) { m.specular = LinearRgb{1}; });
  EXPECT_EQ(told(scene, 1),
            "1 run\n2 run\n3 run\n4 part (open or two-sided: backs are seen, and only marked)\n"
            "5 run (may reach beyond a plane)\n6 run\n7 part (no texture)\n");
  EXPECT_EQ(told(scene, 2).substr(0, 43), "1 skip (outside: beyond the left side)\n2 sk");
  scene.objects[1] = wall_at(20, 8, 1);
  EXPECT_EQ(told(scene, 3).substr(0, 55), "1 skip (hidden behind what is nearer, like wall)\n2 skip");
}

TEST(Plan, SparesWhatIsBehindAndTurnedAway) {
  Scene scene = empty_scene();
  scene.objects = {wall_at(10, 20, 1), cube_at({0, 0, 30}, 4)};
  Plan plan = plan_of(scene, size);
  const Raster<int> spared = work_spared(scene, plan);
  // Of the cube behind the wall, front and back; the picture's corner shows the wall alone
  EXPECT_EQ((spared[{32, 32}]), 2);
  EXPECT_EQ((spared[{1, 1}]), 0);
}

}  // namespace
}  // namespace gradus::pipeline::plan_test
