// The engine draws what the repository ships as the textbook chain does: every model, every scene.

#include "engine/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/files.hpp"
#include "scene/scene_file.hpp"
#include "stages/8_output.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::engine_test {
namespace {

constexpr Size size{160, 120};
constexpr double aspect = 160.0 / 120;

std::vector<std::string> shipped(const std::string& folder, const std::string& extension) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(GRADUS_SOURCE_DIR "/examples/" + folder))
    if (entry.path().extension() == extension) paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  return paths;
}

Image decode(const std::string& bytes, const std::string& name, std::int64_t) {
  return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name);
}

Scene scene_in(const std::string& path) {
  SceneFile file = load_scene(path, decode);
  const View view = file.path ? view_at(*file.path, file.view, file.path->first) : file.view;
  file.scene.camera = camera_of(aim_of(file.scene.objects, view, aspect), view, file.scene.objects, aspect);
  if (!file.lights_told) file.scene.lights = default_lights(file.scene.camera);
  return file.scene;
}

std::vector<std::pair<std::string, Scene>> all_shipped() {
  std::vector<std::pair<std::string, Scene>> scenes;
  for (const std::string& path : shipped("scenes", ".json")) scenes.emplace_back(path, scene_in(path));
  for (const char* folder : {"scenes", "models"})
    for (const std::string& path : shipped(folder, ".obj"))
      scenes.emplace_back(path, scene_of(load_obj(path).mesh, aspect));
  return scenes;
}

bool same_light(const LightPicture& a, const LightPicture& b) {
  return std::ranges::equal(a.cells(), b.cells(), [](const PixelLight& p, const PixelLight& q) {
    return p.sum == q.sum && p.share == q.share;
  });
}

/// How many pixels of a picture are more than a step of 255 off. They are listed.
std::int64_t pixels_off(const Image& image, const Image& expected, const std::string& name) {
  std::int64_t off = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgba8 a = image[{x, y}], b = expected[{x, y}];
      const int steps = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
      if (steps <= 1) continue;
      ++off;
      std::cerr << name << ", pixel " << x << " " << y << ": " << steps << " steps\n";
    }
  }
  return off;
}

TEST(Engine, DrawsIntoAPictureThatIsThere) {
  const std::uint64_t seed = test::seed();
  engine::Picture picture;
  engine::Workspace workspace;
  int stayed = 0;
  for (std::uint64_t round = 0; round < 12; ++round) {
    Random random(seed, round);
    Scene scene = test::random_scene(random, 1);
    scene.shading = Shading::gouraud;
    scene.antialiasing = round % 3 == 2 ? Antialiasing::adaptive : Antialiasing::none;
    const Plan plan = plan_of(scene, round < 8 ? size : Size{70, 90});
    const engine::Buffers buffers = engine::buffers_of(scene);
    const auto* const before = picture.image.cells().data();
    engine::draw_into(picture, scene, buffers, plan, workspace, 1);
    stayed += picture.image.cells().data() == before;
    const engine::Picture fresh = engine::picture_of(scene, buffers, plan, workspace, 1);
    EXPECT_TRUE(picture.image == fresh.image) << "round " << round;
    EXPECT_EQ(picture.covered, fresh.covered);
  }
  EXPECT_EQ(stayed, 7 + 3);  // all but the first of each size
}

TEST(Engine, DrawsWhatIsShippedAsTheTextbookChainDoes) {
  int drawn = 0, next = 0;
  std::int64_t pixels = 0, off = 0;
  for (auto& [path, scene] : all_shipped()) {
    if (!engine::draws(scene) || (test::sanitized && next++ % 6 != 0)) continue;
    const engine::Buffers buffers = engine::buffers_of(scene);
    for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
      scene.shading = shading;
      scene.antialiasing = shading == Shading::gouraud ? Antialiasing::adaptive : Antialiasing::none;
      const Plan plan = plan_of(scene, size);
      const LightPicture light = engine::light_of(scene, buffers, plan, 2),
                         expected = antialiased(scene, size);
      EXPECT_TRUE(same_light(light, expected)) << path;
      engine::Workspace workspace;
      pixels += std::ssize(light.cells());
      off += pixels_off(engine::picture_of(scene, buffers, plan, workspace, 2).image,
                        output(over_background(expected, scene.background)), path);
      EXPECT_TRUE(std::ranges::any_of(light.cells(), [](const PixelLight& p) { return p.share > 0; }))
          << path;
      ++drawn;
    }
  }
  EXPECT_GE(drawn, 3 * (test::sanitized ? 3 : 19));
  EXPECT_LE(off * 100'000, pixels) << "at most ten in a million";
}

/// Squares of such lengths are beyond the range of numbers; a normal of length 0 has no direction.
TEST(Engine, LightsNormalsOfAnyLengthAsTheTextbookChainDoes) {
  for (const double length : {0.0, 1e-300, 1e-90, 1e170}) {
    if (test::sanitized && length > 0) break;
    Scene scene = scene_in(GRADUS_SOURCE_DIR "/examples/scenes/spot.json");
    Mesh mesh = *scene.objects.front().mesh;
    ASSERT_GT(mesh.normals.size(), 100U);
    for (std::size_t i = 0; i < mesh.normals.size(); i += 3) mesh.normals[i] *= length;
    const Object placed = scene.objects.front();
    scene.objects.front() = object_of(std::move(mesh));
    scene.objects.front().placement = placed.placement;
    scene.antialiasing = Antialiasing::none;
    for (const Shading shading : {Shading::gouraud, Shading::phong}) {
      scene.shading = shading;
      const LightPicture expected = antialiased(scene, size);
      EXPECT_EQ(pixels_off(engine::render(scene, size), output(over_background(expected, scene.background)),
                           "normals of length " + std::to_string(length)),
                0);
    }
  }
}

/// The edge of a cone on a wall, seen from so near that from pixel to pixel the cosine to the axis changes by
/// as little as single precision can tell.
Scene edge_of_a_spot(Random& random) {
  Scene scene;
  Mesh wall = test::wall(1, 0, random);
  wall.materials = {{}};
  scene.objects = {object_of(std::move(wall))};
  scene.ambient = LinearRgb{0};
  Light lamp;
  lamp.kind = Light::Kind::spot;
  const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5), z = random.uniform(0.2, 2);
  lamp.position = {x, y, z};
  lamp.intensity = LinearRgb{10};
  // Through a place of the wall, which is on the edge then
  const double to_x = random.uniform(-0.9, 0.9), to_y = random.uniform(-0.9, 0.9);
  const dvec3 place{to_x, to_y, 0}, axis = unit_vector(test::random_point(random, 1) - dvec3{0, 0, 1.2});
  lamp.direction = axis;
  lamp.outer_cosine = glm::dot(axis, unit_vector(place - lamp.position));
  constexpr std::array widths{0.0, 1e-7, 1e-4, 0.9 * 0x1p-6, 1.1 * 0x1p-6};
  lamp.outer_cosine = std::clamp(lamp.outer_cosine, -0.9, 0.95);
  lamp.inner_cosine = lamp.outer_cosine + widths[static_cast<std::size_t>(random.uniform_int(0, 4))];
  if (random.unit() < 0.3) lamp.concentration = random.uniform(0, 30);
  scene.lights = {lamp};
  const double radians = std::exp2(random.uniform(-14, 0));
  const dvec3 from = test::random_point(random, 1) + dvec3{0, 0, 2};
  scene.camera.frame = viewing::look_at(place + from, place, {0, 1, 0});
  scene.camera.lens = {radians, 0.1, 10};
  scene.shading = Shading::phong;
  scene.antialiasing = Antialiasing::none;
  return scene;
}

TEST(Engine, HasTheEdgesOfSpotsWhereTheTextbookChainHasThem) {
  Random random(test::seed());
  std::int64_t off = 0, edges = 0;
  engine::Workspace workspace;
  for (int round = 0; round < (test::sanitized ? 5 : 60); ++round) {
    const Scene scene = edge_of_a_spot(random);
    ASSERT_TRUE(engine::draws_in_single_precision(scene));
    const Image expected = output(over_background(antialiased(scene, size), scene.background));
    off += pixels_off(
        engine::picture_of(scene, engine::buffers_of(scene), plan_of(scene, size), workspace, 2).image,
        expected, "round " + std::to_string(round));
    // From black to light from one pixel to the next
    for (int y = 0; y < size.height; ++y)
      for (int x = 1; x < size.width; ++x)
        edges += (expected[{x, y}].r == 0) != (expected[{x - 1, y}].r == 0);
  }
  EXPECT_EQ(off, 0);
  EXPECT_GT(edges, test::sanitized ? 300 : 4000) << "seed " << test::seed();
}

TEST(Engine, LeavesToTheTextbookChainWhatIsDrawnInAnOrder) {
  Scene scene;
  EXPECT_TRUE(engine::draws(scene));
  scene.hidden_surfaces = HiddenSurfaces::painter;
  EXPECT_FALSE(engine::draws(scene));
  EXPECT_THROW(engine::light_of(scene, engine::buffers_of(scene), plan_of(scene, size)), ContractViolation);
  scene.hidden_surfaces = HiddenSurfaces::z_buffer;
  scene.shading = Shading::wireframe;
  EXPECT_FALSE(engine::draws(scene));
}

TEST(Engine, OfNothingThereIsNoLight) {
  const Scene empty;
  EXPECT_TRUE(engine::render(empty, size) == Image(160, 120, srgb8_from_linear(empty.background)));
}

TEST(Engine, ObjectsOfOneMeshShareItsPieces) {
  Scene scene;
  scene.objects = {object_of(test::cube()), object_of(test::cube())};
  scene.objects.push_back(scene.objects.front());
  const engine::Buffers buffers = engine::buffers_of(scene);
  ASSERT_EQ(buffers.pieces.size(), 3u);
  EXPECT_EQ(buffers.pieces[0], buffers.pieces[2]);
  EXPECT_NE(buffers.pieces[0], buffers.pieces[1]);
  EXPECT_EQ(buffers.pieces[0]->count(), 12);
}

}  // namespace
}  // namespace gradus::pipeline::engine_test
