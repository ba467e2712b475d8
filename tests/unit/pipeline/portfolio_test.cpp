// What the wireframe report promises of its renderer (R002), by the textbook chain.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "core/record.hpp"
#include "pipeline.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewport/viewport.hpp"
#include "scene/camera/movement.hpp"
#include "scene/models/materials.hpp"
#include "scene/models/obj.hpp"
#include "support/random_scenes.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::portfolio_test {
namespace {

constexpr Size size{64, 48};
constexpr double aspect = 64.0 / 48;
constexpr double pi = 3.141592653589793;

bool near(dvec3 a, dvec3 b, double within = 1e-12) {
  return glm::length(a - b) <= within * (1 + glm::length(b));
}

/// A camera at the origin that looks along +z.
Scene scene_of_objects(std::vector<Object> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.camera.frame = viewing::look_at(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 1, 0});
  scene.camera.lens = {1, 0.1, 50000};
  scene.lights.push_back({});
  return scene;
}

Object square_at(double depth, double half) {
  Random random(1);
  Object object = object_of(test::wall(1, 0, random));
  object.placement = affine_3d::translation(dvec3{0, 0, depth}) * affine_3d::scaling(dvec3{half});
  return object;
}

std::int64_t pixels_shown(const Scene& scene) {
  Scene bright = scene;
  bright.background = LinearRgb{0.5f, 0, 0};
  const Image image = render(bright, size);
  return std::ranges::count_if(image.cells(),
                               [&](Rgba8 c) { return c != srgb8_from_linear(bright.background); });
}

// --- View ------------------------------------------------------------------------------------------

TEST(Portfolio, EveryFrameStartsFromTheModel) {  // R002-009
  Random random(3);
  const Scene scene = test::random_scene(random, 6);
  const auto frame = [&](int i) {
    Scene turned = scene;
    turned.camera.frame = orbited(scene.camera.frame, dvec3{0}, dvec3{0, 1, 0}, i * 2 * pi / 12);
    return render(turned, size);
  };
  std::vector<Image> forwards, backwards;
  for (int i = 0; i <= 12; ++i) forwards.push_back(frame(i));
  for (int i = 12; i >= 0; --i) backwards.push_back(frame(i));
  for (std::size_t i = 0; i <= 12; ++i) EXPECT_TRUE(forwards[i] == backwards[12 - i]) << i;
}

TEST(Portfolio, TheScaleIsThatOfTheDepth) {  // R002-010: fov / (zoom - z), with the depth zoom - z
  Model<WorldPoint> world;
  Random random(test::seed());
  for (int i = 0; i < 1000; ++i)
    world.add({0, i}, {{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(0.1, 900)}});
  const Scene scene = scene_of_objects({});
  const double focal = size.height / (2 * std::tan(scene.camera.lens.vertical_radians / 2));
  const auto seen = to_clip(scene.camera, aspect, world);
  for (const auto& [id, point] : seen.vertices) {
    const dvec3 from = world.vertices[static_cast<std::size_t>(id.vertex)].point.at;
    const dvec2 place = viewport::to_pixel(dvec2(perspective::divide(point.at)), size.width, size.height);
    // x of the world is to the left for who looks along +z
    const dvec2 expected = dvec2{32, 24} - focal / from.z * dvec2(from);
    EXPECT_LT(glm::length(place - expected), 1e-9 * (1 + glm::length(expected)));
  }
}

TEST(Portfolio, EveryStageIsOneMatrixProduct) {  // R004-002
  const std::uint64_t seed = test::seed();
  for (std::uint64_t i = 0; i < 100; ++i) {
    Random random(seed, i);
    const Scene scene = test::random_scene(random, 3);
    const glm::dmat4 seen =
        projection_matrix(lens_of(scene.camera, aspect).perspective) * view_matrix(scene.camera.frame);
    const auto model = input(scene);
    const auto clip = to_clip(scene.camera, aspect, to_world(scene, model));
    for (std::size_t k = 0; k < model.vertices.size(); ++k) {
      const auto& [id, from] = model.vertices[k];
      const glm::dvec4 product = seen * object_at(scene, id.object).placement * glm::dvec4(from.at, 1);
      EXPECT_LT(glm::length(clip.vertices[k].point.at - product), 1e-11) << "seed " << seed << ", case " << i;
    }
  }
}

// --- Camera ----------------------------------------------------------------------------------------

TEST(Portfolio, AStepShiftsEveryNodeAndTheStepBackUndoesIt) {  // R002-012
  const std::uint64_t seed = test::seed();
  for (std::uint64_t i = 0; i < 300; ++i) {
    Random random(seed, i);
    const Frame<double> frame = test::random_scene(random, 1).camera.frame;
    const dvec3 way = test::random_point(random, 10), node = test::random_point(random, 100);
    const Frame<double> there = moved(frame, way);
    EXPECT_TRUE(near(viewing::to_view(there, node), viewing::to_view(frame, node) - way)) << seed << ' ' << i;
    EXPECT_TRUE(near(moved(there, -way).eye, frame.eye)) << seed << ' ' << i;
  }
}

void expect_right_angles(const Frame<double>& frame) {
  for (const dvec3 axis : {frame.right, frame.up, frame.forward})
    EXPECT_NEAR(glm::length(axis), 1, 1e-15 * 4);
  EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, 1e-15 * 4);
  EXPECT_NEAR(glm::dot(frame.right, frame.forward), 0, 1e-15 * 4);
  EXPECT_NEAR(glm::dot(frame.up, frame.forward), 0, 1e-15 * 4);
  EXPECT_TRUE(near(glm::cross(frame.forward, frame.up), frame.right, 1e-14));
}

TEST(Portfolio, TurnsAreInversePairsAndBendNoAxis) {  // R002-013
  Random random(test::seed());
  Frame<double> frame = test::random_scene(random, 1).camera.frame;
  const Frame<double> first = frame;
  for (int i = 0; i < 1000; ++i) frame = turned_up(turned_left(frame, 0.1), 0.07);
  expect_right_angles(frame);
  for (int i = 0; i < 1000; ++i) frame = turned_left(turned_up(frame, -0.07), -0.1);
  expect_right_angles(frame);
  EXPECT_TRUE(near(frame.forward, first.forward, 1e-10) && near(frame.up, first.up, 1e-10));
  // To the left: what was ahead is to the right; upwards: it is below
  EXPECT_GT(viewing::to_view(turned_left(first, 0.2), first.eye + first.forward).x, 0.1);
  EXPECT_LT(viewing::to_view(turned_up(first, 0.2), first.eye + first.forward).y, -0.1);
}

TEST(Portfolio, AnOrbitKeepsItsDistanceAndLooksAtThePlace) {
  Frame<double> frame = viewing::look_at(dvec3{3, 1, -4}, dvec3{1, 0, 0}, dvec3{0, 1, 0});
  const dvec3 place{1, 0, 0};
  const double distance = glm::length(frame.eye - place);
  for (int i = 0; i < 100; ++i) {
    frame = orbited(frame, place, dvec3{0, 1, 0}, 0.13);
    EXPECT_NEAR(glm::length(frame.eye - place), distance, 1e-12);
    EXPECT_TRUE(near(frame.forward, unit_vector(place - frame.eye), 1e-12));
  }
}

TEST(Portfolio, MovingAllMovesNothingApart) {  // R002-015
  const std::uint64_t seed = test::seed();
  for (std::uint64_t i = 0; i < 40; ++i) {
    Random random(seed, i);
    Scene scene = test::random_scene(random, 4);
    const auto before = to_world(scene, input(scene));
    const dvec3 way{std::ldexp(1.0, static_cast<int>(i % 4)), 2, -0.5};
    for (Object& object : scene.objects) object.placement = affine_3d::translation(way) * object.placement;
    const auto after = to_world(scene, input(scene));
    for (std::size_t k = 0; k < before.vertices.size(); ++k)
      EXPECT_TRUE(near(after.vertices[k].point.at, before.vertices[k].point.at + way)) << seed << ' ' << i;
  }
}

// --- Clipping --------------------------------------------------------------------------------------

TEST(Portfolio, TheFarPlaneIsTheRenderDistance) {  // R002-018
  EXPECT_GT(pixels_shown(scene_of_objects({square_at(49999, 9000)})), 100);
  EXPECT_EQ(pixels_shown(scene_of_objects({square_at(50001, 9000)})), 0);
  EXPECT_EQ(pixels_shown(scene_of_objects({square_at(0.05, 1)})), 0) << "in front of the near plane";
  EXPECT_EQ(pixels_shown(scene_of_objects({square_at(-5, 1)})), 0) << "behind the eye";
}

// --- Models ----------------------------------------------------------------------------------------

Mesh mesh_of(const std::string& text) { return parse_obj(text, {"model.obj", true}, {}).mesh; }

TEST(Portfolio, AFactorScalesCoordinatesAndKeepsNormalsOfLengthOne) {  // R002-026, R002-027
  Object object = object_of(mesh_of("v 1 2 3\nv 4 2 3\nv 1 7 3\nvn 0 0 2\nf 1//1 2//1 3//1\n"));
  object.placement = affine_3d::scaling(dvec3{4});
  const Scene scene = scene_of_objects({object});
  const auto world = to_world(scene, input(scene));
  EXPECT_EQ(world.vertices[1].point.at, (dvec3{16, 8, 12}));
  for (const PieceCorner& corner : world.pieces[0].corners) EXPECT_EQ(corner.normal, (dvec3{0, 0, 1}));
}

TEST(Portfolio, FacesBecomeTriangles) {  // R002-023, R002-028, R002-030, R002-031: G002-15
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
  const auto pieces_of = [&](const std::string& face) {
    return input(scene_of_objects({object_of(mesh_of(corners + face))})).pieces;
  };
  const auto one = pieces_of("f 1/1/1 2/1/1 3/1/1\n");
  ASSERT_EQ(one.size(), 1u);
  // A quad: two triangles that share a diagonal, each corner of the outline in one of them at least
  const auto two = pieces_of("f 1//1 2//1 3//1 4//1\n");
  ASSERT_EQ(two.size(), 2u);
  std::array<int, 4> uses{};
  for (const Piece& piece : two)
    for (const PieceCorner& corner : piece.corners) ++uses[static_cast<std::size_t>(corner.vertex)];
  std::ranges::sort(uses);
  EXPECT_EQ(uses, (std::array{1, 1, 2, 2})) << "the diagonal's ends are in both";
  EXPECT_EQ(two[0].id.face, two[1].id.face) << "of one face, with one material";
}

TEST(Portfolio, ColoursOfMaterials) {  // R002-035, R002-036: G002-16
  EXPECT_EQ(mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").materials.at(0).diffuse, LinearRgb{0.7f})
      << "without a material light grey; the report takes red";
  std::vector<std::string> notes;
  const auto materials = parse_mtl("newmtl violet\nKd 0.8 0.2 1.0\n", {"model.mtl", true}, notes);
  const dvec3 kd(materials.at(0).diffuse);
  EXPECT_TRUE(near(255.0 * kd, {204, 51, 255}, 1e-6));
}

// --- Drawing tools: the ray of a click -------------------------------------------------------------

TEST(Portfolio, AClickMeetsThePlaneItShows) {  // R002-051, R002-052: G002-13, G002-14
  // The report's camera: at z = 1000 before the middle (400, 300), looking along -z with a focal length of
  // 500 pixels, y downwards; its plane y = 0 runs through the upper edge of the screen
  Camera camera;
  camera.frame = {{400, 300, 1000}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  camera.lens = {2 * std::atan(300.0 / 500), 1, 5000};
  const Ray ray = ray_through(camera, 800, 600, {431.25, 112.5});
  const auto t = meets_plane(ray, dvec3{0}, dvec3{0, 1, 0});
  ASSERT_TRUE(t);
  EXPECT_TRUE(near(ray.origin + *t * ray.direction, {450, 0, 200}, 1e-12));

  const std::uint64_t seed = test::seed();
  int met = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(seed, i);
    const Scene scene = test::random_scene(random, 1);
    const dvec2 click{random.uniform(0, 64), random.uniform(0, 48)};
    const double height = random.uniform(-4, 4);
    const Ray one = ray_through(scene.camera, size.width, size.height, click);
    const auto at = meets_plane(one, dvec3{7, height, -3}, dvec3{0, 2, 0});
    if (!at) continue;
    ++met;
    const dvec3 place = one.origin + *at * one.direction;
    EXPECT_NEAR(place.y, height, 1e-9 * (1 + *at));
    // Projected back it is where the click was
    const dvec3 view = viewing::to_view(scene.camera.frame, place);
    const glm::dvec4 clip = transform(lens_of(scene.camera, aspect), view);
    const dvec2 back = viewport::to_pixel(dvec2(clip) / clip.w, size.width, size.height);
    EXPECT_LT(glm::length(back - click), 1e-7) << seed << ' ' << i;
  }
  EXPECT_GT(met, 300);
  EXPECT_FALSE(meets_plane({dvec3{0, 1, 0}, dvec3{1, 0, 0}}, dvec3{0}, dvec3{0, 1, 0})) << "runs beside it";
  EXPECT_FALSE(meets_plane({dvec3{0, 1, 0}, dvec3{0, 1, 0}}, dvec3{0}, dvec3{0, 1, 0})) << "looks away";
}

}  // namespace
}  // namespace gradus::pipeline::portfolio_test
