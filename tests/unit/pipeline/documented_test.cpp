// The numbers that the pages of rendering and of the engine claim, computed again.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/buffers.hpp"
#include "engine/casts.hpp"
#include "engine/geometry.hpp"
#include "engine/shading.hpp"
#include "scene/files.hpp"
#include "scene/scene_file.hpp"
#include "stages/antialiasing.hpp"
#include "stages/arrangement.hpp"
#include "support/documented.hpp"
#include "support/random_scenes.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::pipeline::documented_test {
namespace {

using test::states;

constexpr const char* rendering = "docs/rendering.md";
constexpr const char* engine_page = "docs/engine.md";

/// What a step of the painter's counts as.
template <class Step>
double counted(const Step& step) {
  PainterLimit limit{{"painter", 2}};
  limit(step);
  return static_cast<double>(limit.limit.work);
}
double counted(painter::Test passed) {
  painter::Compared<double> compared{};
  compared.passed = passed;
  return counted(compared);
}

TEST(DocumentedRendering, WhatAnOrderMayTake) {
  EXPECT_TRUE(states(rendering, "whose order takes more than {} simple tests", {ArrangingLimit::most}));
  const double a_cut = counted(painter::Cut<double>{});
  EXPECT_TRUE(states(rendering,
                     "A cut counts as {}, a test of the painter's by planes as {}, by edges as {}.",
                     {a_cut, counted(painter::Test::behind), counted(painter::Test::apart)}));
  EXPECT_EQ(counted(painter::Test::depths), 1);
  TreeLimit tree{{"bsp_tree", 2}};
  tree(bsp_tree::Split<double>{});
  EXPECT_EQ(static_cast<double>(tree.limit.work), a_cut);
}

TEST(DocumentedRendering, WhatAreasMayTake) {
  EXPECT_TRUE(states(rendering, "takes more than {} cuts of one piece by another, and {} per pixel",
                     {CuttingLimit::most, CuttingLimit::more_a_pixel}));
}

/// How much work orders are of so many triangles with corners anywhere in a cube, which cross one another.
std::vector<WorldPolygon> crossing(std::size_t count) {
  Random random(test::seed());
  std::vector<WorldPolygon> polygons;
  const auto corner = [&] { return dvec3{0, 0, 5} + test::random_point(random, 1); };
  for (std::size_t i = 0; i < count; ++i) {
    const dvec3 a = corner(), b = corner();
    polygons.push_back({{a, b, corner()}, i});
  }
  return polygons;
}
bool passes(HiddenSurfaces method, std::size_t count) {
  const auto polygons = crossing(count);
  const ArrangingLimit limit{"", count};
  try {
    if (method == HiddenSurfaces::bsp_tree) {
      bsp_tree::build(polygons, bsp_tree::ExactSide{}, TreeLimit{limit});
    } else {
      const painter::View<double> view = painter::view_along({0, 0, 0, 1}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
      painter::newell(polygons, view, LimitedDrawing{[](const WorldPolygon&) {}, limit}, PainterLimit{limit});
    }
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

TEST(DocumentedRendering, TrianglesThatCrossEverywhere) {
  for (const HiddenSurfaces method : {HiddenSurfaces::painter, HiddenSurfaces::bsp_tree}) {
    EXPECT_TRUE(passes(method, 250));
    if (test::cases(0, 1) > 0) EXPECT_FALSE(passes(method, 500)) << "takes seconds";
  }
}

TEST(DocumentedRendering, TrianglesOfATown) {
  const SceneFile town =
      load_scene(GRADUS_SOURCE_DIR "/examples/scenes/town.json",
                 [](const std::string&, const std::string&, std::int64_t) { return Image(1, 1); });
  std::int64_t triangles = 0;
  for (const Object& object : town.scene.objects) triangles += triangle_count(*object.mesh);
  EXPECT_TRUE(
      states(rendering, "its {} triangles are too many for the painter", {static_cast<double>(triangles)}));
}

TEST(DocumentedRendering, ContrastOfNeighbours) {
  EXPECT_TRUE(
      states(rendering, "where neighbours differ by more than {} of 255 steps", {contrast_threshold}));
}

TEST(DocumentedEngine, MemoryOfWhatIsKept) {
  // Of a vertex place and depth, of a piece its vertices and the rest
  EXPECT_TRUE(
      states(engine_page,
             "Memory: {} bytes per vertex, {} per piece of a mesh and {} per triangle that touches a pixel; "
             "{} for one that is clipped; 8 bytes per tile and batch of {} pieces.",
             {sizeof(decltype(engine::Frame::grid)::value_type) +
                  sizeof(decltype(engine::Frame::depths)::value_type),
              sizeof(engine::PieceVertices) + sizeof(engine::MeshPiece), sizeof(engine::FrameTriangle),
              sizeof(Triangle), engine::batch_pieces}));
}

TEST(DocumentedEngine, WhatSinglePrecisionIsAsked) {
  EXPECT_EQ(engine::unsure_share, 0x1p-19f) << "depths that surely differ";
  Scene scene;
  scene.camera.lens = {1, 1e-9, 1e9};
  scene.lights.resize(4096);
  EXPECT_TRUE(engine::suits_single_precision(scene)) << "1e-9 to 1e9, 4096 lamps";
  scene.lights.resize(4097);
  EXPECT_FALSE(engine::suits_single_precision(scene));
  scene.lights.clear();
  scene.camera.lens.near = std::nextafter(1e-9, 0);
  EXPECT_FALSE(engine::suits_single_precision(scene));
  scene.camera.lens = {1, 1, std::nextafter(1e9, 2e9)};
  EXPECT_FALSE(engine::suits_single_precision(scene));
}

}  // namespace
}  // namespace gradus::pipeline::documented_test
