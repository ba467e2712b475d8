// What lets light through: by the A-buffer front to back, opaque by all other methods, and never a reason to
// leave out what is behind.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/scene_file.hpp"
#include "support/random_scenes.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::opacity_test {
namespace {

const LinearRgb red{1, 0, 0}, green{0, 1, 0}, ground{0, 0, 1};

/// A body whose light is its own alone.
Object shining(Mesh mesh, LinearRgb light, float opacity, dvec3 at, double size = 1) {
  Material material;
  material.ambient = material.diffuse = LinearRgb{0};
  material.emission = light;
  material.opacity = opacity;
  mesh.materials = {material};
  Object object = object_of(std::move(mesh));
  object.placement = affine_3d::translation(at) * affine_3d::scaling(dvec3{size});
  return object;
}

Mesh square() {
  Random random(1);
  return test::wall(1, 0, random);
}

/// Seen from +z; the picture shows 2 x 2 units at z = 0 and less of what is nearer.
Scene scene_of(std::vector<Object> objects, Antialiasing method = Antialiasing::a_buffer) {
  Scene scene;
  scene.objects = std::move(objects);
  scene.camera.frame = viewing::look_at(dvec3{0, 0, 10}, dvec3{0}, dvec3{0, 1, 0});
  scene.camera.lens = {0.2, 1, 100};
  scene.background = ground;
  scene.antialiasing = method;
  return scene;
}

constexpr Size size{16, 16};

/// The light in the middle.
LinearRgb middle_of(const Scene& scene) {
  return over_background(antialiased(scene, size), scene.background)[ivec2{8, 8}];
}

void expect_near(const LinearRgb& found, const dvec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
}

TEST(Opacity, TwoHalfTransparentFaces) {
  const Object front = shining(square(), red, 0.5f, {0, 0, 1}, 4),
               back = shining(square(), green, 0.5f, {0, 0, -1}, 4);
  for (const HiddenSurfaces method :
       {HiddenSurfaces::z_buffer, HiddenSurfaces::painter, HiddenSurfaces::bsp_tree}) {
    for (const auto& objects : {std::vector{front, back}, std::vector{back, front}}) {
      Scene scene = scene_of(objects);
      scene.hidden_surfaces = method;
      expect_near(middle_of(scene), {0.5, 0.25, 0.25});
      EXPECT_NEAR((antialiased(scene, size)[ivec2{8, 8}].share), 0.75, 1e-6);
    }
  }
}

TEST(Opacity, AnyOpacitiesFrontToBack) {
  for (const float a : {0.0f, 0.25f, 1.0f}) {
    for (const float b : {0.0f, 0.7f, 1.0f}) {
      const Scene scene =
          scene_of({shining(square(), red, a, {0, 0, 1}, 4), shining(square(), green, b, {0, 0, -1}, 4)});
      const double first = double{a}, second = (1 - first) * double{b};
      expect_near(middle_of(scene), {first, second, 1 - first - second});
    }
  }
}

TEST(Opacity, BodiesShowTheirBacks) {
  Scene scene = scene_of({shining(test::cube(), red, 0.5f, {0, 0, 0}, 2)});
  ASSERT_FALSE(scene.objects[0].two_sided) << "it is closed";
  expect_near(middle_of(scene), {0.75, 0, 0.25});
  scene.culling = Culling::back;
  expect_near(middle_of(scene), {0.5, 0, 0.5});
}

TEST(Opacity, OtherMethodsDrawItOpaque) {
  using enum Antialiasing;
  for (const Antialiasing method : {none, supersampling, accumulation_buffer, jittered, poisson_disc,
                                    area_sampling, adaptive, adaptive_contrast}) {
    const auto picture = [method](float opacity) {
      Scene scene = scene_of(
          {shining(test::cube(), red, opacity, {0.3, 0, 0}), shining(square(), green, opacity, {0, 0, -3})},
          method);
      scene.samples = 4;
      return render_antialiased(scene, size);
    };
    EXPECT_EQ(picture(0.25f), picture(1)) << name_of(method);
  }
}

/// A ball behind a wall of glass, and one behind a wall.
TEST(Opacity, GlassHidesNothing) {
  for (const Antialiasing method : {Antialiasing::a_buffer, Antialiasing::adaptive}) {
    for (const float opacity : {0.5f, 1.0f}) {
      const Scene scene = scene_of(
          {shining(test::ball(6), green, 1, {0, 0, -3}, 0.5), shining(square(), red, opacity, {0, 0, 1}, 4)},
          method);
      Plan plan = plan_of(scene, size);
      Ledger ledger;
      const LightPicture planned = antialiased_by_plan(scene, plan, ledger);
      const LightPicture plain = antialiased(scene, size);
      for (std::size_t i = 0; i < plain.cells().size(); ++i) {
        ASSERT_EQ(planned.cells()[i].sum, plain.cells()[i].sum);
        ASSERT_EQ(planned.cells()[i].share, plain.cells()[i].share);
      }
      const bool through = method == Antialiasing::a_buffer && opacity < 1;
      EXPECT_EQ(plan.objects[0].skipped.has_value(), !through);
      expect_near(LinearRgb(planned[ivec2{8, 8}].sum), through ? dvec3{0.5, 0.5, 0} : dvec3{1, 0, 0});
    }
  }
}

TEST(Opacity, ScenesTellIt) {
  const auto find = [](const std::string&) -> std::optional<FoundModel> {
    return FoundModel{LibraryText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "t.obj",
                      [](const std::string&) -> std::optional<LibraryText> { return std::nullopt; }};
  };
  const auto object = [&](const std::string& material) {
    return parse_scene(R"({"objects": [{"model": "t.obj", "material": )" + material + "}]}", "s.json", find,
                       {})
        .scene.objects[0];
  };
  EXPECT_EQ(object(R"({"opacity": 0.25})").mesh->materials[1].opacity, 0.25f);
  EXPECT_TRUE(object(R"({"opacity": 0.25})").see_through);
  EXPECT_FALSE(object(R"({"opacity": 1})").see_through);
  EXPECT_FALSE(object("{}").see_through);
  for (const char* wrong : {"-0.1", "1.5", "\"half\""})
    EXPECT_THROW(object(std::string(R"({"opacity": )") + wrong + "}"), InputError) << wrong;
}

}  // namespace
}  // namespace gradus::pipeline::opacity_test
