// The engine's pictures are those of the textbook chain: every pixel has the same winner, and the same bits
// of light or a colour at most one step of 255 away, whatever the scene, the plan and the number of threads.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

#include "engine/engine.hpp"
#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "stages/8_output.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::engine_property_test {
namespace {

/// How many pixels of two pictures differ in a bit.
int differing(const LightPicture& a, const LightPicture& b) {
  EXPECT_EQ(a.cells().size(), b.cells().size());
  int count = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i)
    count += a.cells()[i].sum != b.cells()[i].sum || a.cells()[i].share != b.cells()[i].share;
  return count;
}

/// Triangles of sizes from far below a pixel to far beyond the picture, some without area, some twice.
Mesh loose_triangles(Random& random) {
  Mesh mesh;
  for (int i = 0; i < 40; ++i) {
    const double size = std::pow(10.0, random.uniform(-4, 2));
    const dvec3 middle = test::random_point(random, 4);
    const int first = static_cast<int>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(middle + test::random_point(random, size));
    if (random.unit() < 0.1) mesh.positions.back() = mesh.positions[static_cast<std::size_t>(first)];
    test::add_face(mesh, {first, first + 1, first + 2});
    if (random.unit() < 0.2) test::add_face(mesh, {first + 1, first + 2, first});
  }
  mesh.materials = {test::random_material(random)};
  return mesh;
}

/// One more object, of kinds that random_scene has not; or one of its objects a second time, as deep.
void add_object(Scene& scene, Random& random) {
  const auto kind = random.uniform_int(0, 3);
  if (kind == 0) scene.objects.push_back(object_of(loose_triangles(random)));
  if (kind == 1) scene.objects.push_back(object_of(test::textured(test::cube(), random)));
  if (kind == 2) scene.objects.push_back(object_of(test::textured(test::ball(7), random)));
  if (kind == 3) {
    scene.objects.push_back(scene.objects.front());
    Mesh mesh = *scene.objects.back().mesh;
    mesh.materials = {test::random_material(random)};
    scene.objects.back().mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  if (kind == 1 || kind == 2) {
    const dvec3 place = test::random_point(random, 4),
                axis = test::random_point(random, 1) + dvec3{0, 0, 0.01};
    scene.objects.back().placement =
        affine_3d::translation(place) * affine_3d::rotation(axis, random.uniform(0, 6));
  }
}

Scene random_engine_scene(Random& random, int number) {
  Scene scene = number % 2 == 0 ? test::random_scene(random, 8) : test::random_screened_scene(random, 8);
  for (int i = 0; i < 3; ++i) add_object(scene, random);
  scene.shading = static_cast<Shading>(random.uniform_int(0, 2));
  scene.culling = static_cast<Culling>(random.uniform_int(0, 2));
  scene.filter = static_cast<TextureFilter>(random.uniform_int(0, 2));
  if (random.unit() < 0.3) {
    const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
    scene.camera.rays = ParallelRays{
        random.uniform(2, 9), {a, b}, random.uniform(1, 9), random.uniform(-3, 1), random.uniform(6, 15)};
  }
  return scene;
}

TEST(Engine, HasEveryBitOfTheTextbookChain) {
  const std::uint64_t seed = test::seed();
  constexpr int cases = test::sanitized ? 10 : 250;
  for (int i = 0; i < cases; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Scene scene = random_engine_scene(random, i);
    scene.antialiasing = Antialiasing::none;
    const Size size{static_cast<int>(random.uniform_int(1, 200)),
                    static_cast<int>(random.uniform_int(1, 150))};
    const LightPicture expected = antialiased(scene, size);
    const engine::Buffers buffers = engine::buffers_of(scene);
    const Plan plan = plan_of(scene, size);
    for (const int threads : {1, 2, 4})
      ASSERT_EQ(differing(engine::light_of(scene, buffers, plan, threads), expected), 0)
          << "seed " << seed << ", case " << i << ", " << threads << " threads";
  }
}

/// Lights and materials at the ends of their ranges.
void vary_light(Scene& scene, Random& random) {
  for (Light& light : scene.lights) {
    if (random.unit() < 0.3) light.inner_cosine = light.outer_cosine + (random.unit() < 0.5 ? 0 : 1e-3);
    if (random.unit() < 0.3) light.concentration = random.uniform(0, 30);
    if (random.unit() < 0.3) light.quadratic = random.uniform(0, 1);
    if (random.unit() < 0.3) light.intensity *= 10.0f;
  }
  for (Object& object : scene.objects) {
    if (random.unit() < 0.5) continue;
    Mesh mesh = *object.mesh;
    Material& material = mesh.materials[0];
    material.specular = LinearRgb{0.5f};
    constexpr std::array shininess{0.0f, 0.3f, 1.0f, 7.0f, 200.0f, 1000.0f, 333.3f};
    material.shininess = shininess[static_cast<std::size_t>(random.uniform_int(0, 6))];
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
}

/// The largest difference of two colours, in steps of 255.
int steps(Rgba8 a, Rgba8 b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

/// Compares pictures in 8 bits: how many pixels differ by more than a step. They are listed.
class Comparison {
 public:
  void add(const Image& image, const Image& expected, const std::string& name) {
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        ++pixels_;
        const int apart = steps(image[{x, y}], expected[{x, y}]);
        if (apart <= 1) continue;
        ++off_;
        std::cerr << name << ", pixel " << x << " " << y << ": " << apart << " steps\n";
      }
    }
  }
  /// At most ten in a million.
  bool is_close() const { return off_ * 100'000 <= pixels_; }

 private:
  std::int64_t pixels_ = 0, off_ = 0;
};

void expect_within_one_step(Antialiasing method, int cases) {
  const std::uint64_t seed = test::seed();
  Comparison comparison;
  engine::Workspace workspace;
  int in_single = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Scene scene = random_engine_scene(random, i);
    vary_light(scene, random);
    scene.antialiasing = method;
    scene.samples = method == Antialiasing::none ? 16 : static_cast<int>(random.uniform_int(1, 16));
    const Size size{static_cast<int>(random.uniform_int(1, 200)),
                    static_cast<int>(random.uniform_int(1, 150))};
    const std::string name = "seed " + std::to_string(seed) + ", case " + std::to_string(i);
    const engine::Buffers buffers = engine::buffers_of(scene);
    const Plan plan = plan_of(scene, size);
    const Image image = engine::picture_of(scene, buffers, plan, workspace, 1).image;
    for (const int threads : {2, 4})
      ASSERT_TRUE(engine::picture_of(scene, buffers, plan, workspace, threads).image == image)
          << name << ", " << threads << " threads";
    comparison.add(image, output(over_background(antialiased(scene, size), scene.background)), name);
    in_single += engine::draws_in_single_precision(scene);
    // A part has the bits of the whole
    const auto left = static_cast<int>(random.uniform_int(0, size.width - 1)),
               top = static_cast<int>(random.uniform_int(0, size.height - 1));
    const Plan of_part =
        plan_of(scene, size, Rules::all(), Window{{left, top}, {size.width - 1, size.height - 1}});
    const Image part = engine::picture_of(scene, buffers, of_part, workspace, 2).image;
    for (int y = top; y < size.height; ++y)
      for (int x = left; x < size.width; ++x)
        ASSERT_EQ(steps(part[ivec2{x - left, y - top}], image[ivec2{x, y}]), 0) << name << ", a part";
  }
  EXPECT_TRUE(comparison.is_close()) << "seed " << seed;
  EXPECT_GE(in_single * 2, cases) << "seed " << seed;
}

TEST(Engine, HasTheColoursOfTheTextbookChainWithinOneStep) {
  expect_within_one_step(Antialiasing::none, test::sanitized ? 10 : 250);
}

TEST(Engine, HasTheColoursOfAdaptiveAntialiasingWithinOneStep) {
  expect_within_one_step(Antialiasing::adaptive, test::sanitized ? 10 : 120);
}

TEST(Engine, HasEveryBitOfEachAntialiasingMethod) {
  const std::uint64_t seed = test::seed();
  constexpr int cases = test::sanitized ? 16 : 80;
  constexpr Size size{150, 90};
  for (int i = 0; i < cases; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Scene scene = random_engine_scene(random, i);
    scene.antialiasing = static_cast<Antialiasing>(i % 8 + 1);
    scene.samples = 4;
    const auto left = static_cast<int>(random.uniform_int(0, 100)),
               top = static_cast<int>(random.uniform_int(0, 60));
    Plan plan = plan_of(scene, size, Rules::all(), Window{{left, top}, {149, 89}});
    const LightPicture light = engine::light_of(scene, engine::buffers_of(scene), plan, 2);
    Ledger ledger;
    ASSERT_EQ(differing(light, antialiased_by_plan(scene, plan, ledger)), 0)
        << "seed " << seed << ", case " << i << ", " << name_of(scene.antialiasing);
  }
}

}  // namespace
}  // namespace gradus::pipeline::engine_property_test
