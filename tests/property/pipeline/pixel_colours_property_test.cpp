// The engine's colours of fragments have the bits of stage 7, whatever lights them, and with them their 8
// bits; so have those of every exponent that a shipped scene has.

#include "engine/pixel_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/power_bounds.hpp"
#include "core/colour.hpp"
#include "core/image.hpp"
#include "engine/light_bytes.hpp"
#include "pipeline.hpp"
#include "scene/files.hpp"
#include "scene/scene_file.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/share.hpp"

namespace gradus::pipeline::pixel_colours_property_test {
namespace {

constexpr Size size{160, 120};

/// The exponents of highlights in what the repository ships.
std::vector<float> shipped_exponents() {
  std::set<float> exponents;
  const auto add = [&](const Mesh& mesh) {
    for (const Material& material : mesh.materials) exponents.insert(material.shininess);
  };
  const auto decode = [](const std::string& bytes, const std::string& name, std::int64_t) {
    return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name);
  };
  for (const char* folder : {"scenes", "models"}) {
    const std::string path = std::string(GRADUS_SOURCE_DIR "/examples/") + folder;
    for (const auto& entry : std::filesystem::directory_iterator(path)) {
      const std::string file = entry.path().string();
      if (file.ends_with(".obj")) add(load_obj(file).mesh);
      if (!file.ends_with(".json")) continue;
      for (const Object& object : load_scene(file, decode).scene.objects) add(*object.mesh);
    }
  }
  return {exponents.begin(), exponents.end()};
}

float random_exponent(Random& random, const std::vector<float>& shipped) {
  constexpr std::array others{0.0f, 0.3f, 1.0f, 7.0f, 200.0f, 1000.0f, 333.3f, 1e5f};
  const double which = random.unit();
  if (which < 0.6) return shipped[static_cast<std::size_t>(random.uniform_int(0, std::ssize(shipped) - 1))];
  if (which < 0.9) return static_cast<float>(std::exp2(random.uniform(-2, 10)));
  return others[static_cast<std::size_t>(random.uniform_int(0, std::ssize(others) - 1))];
}

/// Materials of every kind, lights and vectors with numbers that are not often met.
Scene random_lit_scene(Random& random, const std::vector<float>& shipped) {
  Scene scene = test::random_scene(random, 6);
  scene.shading = Shading::phong;
  scene.filter = static_cast<TextureFilter>(random.uniform_int(0, 2));
  for (Object& object : scene.objects) {
    Mesh mesh = random.unit() < 0.3 ? test::textured(*object.mesh, random) : *object.mesh;
    for (Material& material : mesh.materials) {
      material.shininess = random_exponent(random, shipped);
      if (random.unit() < 0.8) material.specular = LinearRgb(test::random_point(random, 0.5) + 0.5);
      if (random.unit() < 0.2) material.diffuse = LinearRgb(0);
      if (random.unit() < 0.1) material.diffuse = LinearRgb{-0.5f, 0.2f, 0.2f};  // no light of this world
    }
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  for (Light& light : scene.lights) {
    if (random.unit() < 0.3) light.concentration = random.uniform(0, 30);
    if (random.unit() < 0.3) light.quadratic = random.uniform(0, 1);
    if (random.unit() < 0.3) light.intensity *= 10.0f;
    if (random.unit() < 0.1) light.constant = 0, light.linear = 0.5;
    if (random.unit() < 0.02) light.intensity = LinearRgb{-0.1f};
  }
  if (random.unit() < 0.2) scene.camera.rays = ParallelRays{5, {0.3, -0.2}, 4, -2, 12};
  return scene;
}

Triangles triangles_of(const Scene& scene) {
  const auto world = to_world(scene, input(scene));
  return clip(world, cull(scene, to_clip(scene.camera, 4.0 / 3, world)), size);
}

/// A place of a triangle, now and then on an edge or in a corner.
Fragment random_fragment(Random& random, const Triangles& triangles) {
  const auto number = static_cast<int>(random.uniform_int(0, std::ssize(triangles) - 1));
  Triangle const& t = triangles[static_cast<std::size_t>(number)];
  const auto weight = [&] { return random.unit() < 0.05 ? std::int64_t{0} : random.uniform_int(1, 1 << 20); };
  const std::int64_t a = weight(), b = weight(), c = weight();
  const triangle_coverage::Weights weights{a + (a + b + c == 0), b, c};
  return {t.id, number, {3, 4}, 0, shares_of(weights, over_w_of(t))};
}

bool same_bits(const LinearRgb& a, const LinearRgb& b) {
  const auto same = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b);
}

/// Ten million in all, of which an ordinary run has a twentieth.
TEST(PixelColours, HaveTheBitsOfStageSeven) {
  const std::uint64_t seed = test::seed();
  const std::vector<float> exponents = shipped_exponents();
  ASSERT_GE(exponents.size(), 3U);
  constexpr std::size_t scenes = 2000;
  constexpr int fragments = test::sanitized ? 200 : 5000;
  std::int64_t compared = 0, bright = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    if (!test::in_share(i, 20)) continue;
    Random random(seed, i);
    const Scene scene = random_lit_scene(random, exponents);
    const Triangles triangles = triangles_of(scene);
    if (triangles.empty()) continue;
    const Plan plan = plan_of(scene, size);
    SceneLight of_stage(scene, size, &plan), of_engine(scene, size, &plan);
    engine::PixelColours colours;
    for (int k = 0; k < fragments; ++k) {
      const Fragment f = random_fragment(random, triangles);
      const Triangle& t = triangle_of(f, triangles);
      const Shaded expected = shaded(of_stage, f, t);
      const LinearRgb colour = colours(of_engine, f, t);
      ASSERT_TRUE(same_bits(colour, expected.colour))
          << "seed " << seed << ", scene " << i << ", fragment " << k;
      ASSERT_EQ(srgb8_from_linear(colour), srgb8_from_linear(expected.colour));
      ++compared;
      bright += expected.specular != dvec3(0);
    }
    EXPECT_EQ(of_engine.count().lamps, of_stage.count().lamps);
    EXPECT_EQ(of_engine.count().lamps_out_of_range, of_stage.count().lamps_out_of_range);
    EXPECT_EQ(of_engine.count().lamps_without_highlight, of_stage.count().lamps_without_highlight);
    EXPECT_EQ(of_engine.count().places, of_stage.count().places);
    EXPECT_EQ(of_engine.count().places_without_texture, of_stage.count().places_without_texture);
  }
  const auto all = static_cast<std::int64_t>(test::share_of(scenes, 20)) * fragments;
  EXPECT_GE(compared, all * 9 / 10) << "seed " << seed;
  EXPECT_GE(bright, all / 10) << "seed " << seed;
}

/// The byte of a light with a highlight from the bounds of its power, where both become one float, is that
/// from the power itself: of a hundred million, of which an ordinary run has a hundredth.
TEST(PixelColours, HaveTheBytesOfNearestPowers) {
  const std::uint64_t seed = test::seed();
  const std::vector<float> exponents = shipped_exponents();
  const engine::LightBytes bytes;
  constexpr std::size_t blocks = 10'000;
  constexpr int in_block = test::sanitized ? 100 : 10'000;
  std::int64_t compared = 0, in_doubt = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    if (!test::in_share(i, 100)) continue;
    Random random(seed, i);
    for (int k = 0; k < in_block; ++k) {
      const double rv = random.unit() < 0.5 ? random.unit() : 1 - random.unit() * random.unit() * 0.1;
      const double n{random_exponent(random, exponents)}, rest = random.unit() * random.unit(),
                                                          strength = random.unit();
      const Between power = power_bounds(rv, n);
      const auto low = static_cast<float>(rest + strength * power.low),
                 high = static_cast<float>(rest + strength * power.high);
      ++compared;
      if (low != high) {
        ++in_doubt;
        continue;
      }
      const auto light = static_cast<float>(rest + strength * pow(rv, n));
      ASSERT_EQ(bytes(low), srgb8_from_linear(light)) << "seed " << seed << ", block " << i << ", " << k;
    }
  }
  EXPECT_EQ(compared, static_cast<std::int64_t>(test::share_of(blocks, 100)) * in_block);
  EXPECT_LE(in_doubt * 100'000, compared) << "at most ten in a million, seed " << seed;
}

}  // namespace
}  // namespace gradus::pipeline::pixel_colours_property_test
