// Antialiasing in the chain: without it today's pictures, with it linear light of several places.

#include "stages/antialiasing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/files.hpp"
#include "scene/models/obj.hpp"
#include "support/change_mesh.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::antialiasing_test {
namespace {

using enum Antialiasing;
constexpr Antialiasing all_methods[]{none,     supersampling, accumulation_buffer,
                                     jittered, poisson_disc,  area_sampling,
                                     a_buffer, adaptive,      adaptive_contrast};

Scene shipped(const std::string& name, Size size) {
  const std::string path = std::string(GRADUS_SOURCE_DIR) + "/examples/models/" + name;
  return scene_of(load_obj(path).mesh, static_cast<double>(size.width) / size.height);
}

/// A square in the middle of the picture whose left side lies at this column; it glows red and nothing else
/// shines.
Scene red_square(double left, Size size) {
  Scene scene;
  scene.ambient = LinearRgb{0};
  scene.camera.lens = {radians_from_degrees(90), 1, 100};
  // At distance 1 half the height is 1
  const auto x = [&](double column) { return (2 * column - size.width) / size.height; };
  const std::string text =
      fmt::format("v {0} -0.5 -2\nv {1} -0.5 -2\nv {1} 0.5 -2\nv {0} 0.5 -2\nf 1 2 3 4\n", 2 * x(left),
                  2 * x(size.width - 2));
  scene.objects.push_back(
      object_of(parse_obj(text, "m.obj", [](const std::string&) { return std::nullopt; }).mesh));
  test::change_materials(scene.objects[0], [](Material& m) { m.emission = {1, 0, 0}; });
  return scene;
}

double difference(const LightPicture& a, const LightPicture& b, const LinearRgb& background) {
  double sum = 0;
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const dvec3 off = dvec3(over(a.cells()[i], background)) - dvec3(over(b.cells()[i], background));
    sum += glm::dot(off, off) / 3;
  }
  return std::sqrt(sum / static_cast<double>(a.cells().size()));
}

TEST(ChainAntialiasing, WithoutItAreTheBitsOfRender) {
  for (const char* name : {"letter_f.obj", "spot.obj"}) {
    Scene scene = shipped(name, {120, 90});
    scene.antialiasing = none;
    EXPECT_EQ(render_antialiased(scene, {120, 90}), render(scene, {120, 90})) << name;
    scene.shading = Shading::gouraud;
    EXPECT_EQ(render_antialiased(scene, {120, 90}), render(scene, {120, 90})) << name;
  }
}

TEST(ChainAntialiasing, OneSampleIsTheCentre) {
  Scene scene = shipped("letter_f.obj", {80, 60});
  scene.samples = 1;
  for (const Antialiasing method : {supersampling, accumulation_buffer, adaptive, adaptive_contrast}) {
    scene.antialiasing = method;
    EXPECT_EQ(render_antialiased(scene, {80, 60}), render(scene, {80, 60})) << name_of(method);
  }
}

TEST(ChainAntialiasing, PassesGiveThePictureOfAllSamplesAtOnce) {
  // R001-162
  Scene scene = shipped("spot.obj", {64, 48});
  for (const int samples : {4, 9, 16}) {
    scene.samples = samples;
    scene.antialiasing = supersampling;
    const LightPicture at_once = antialiased(scene, {64, 48});
    scene.antialiasing = accumulation_buffer;
    const LightPicture passes = antialiased(scene, {64, 48});
    int different = 0;
    for (std::size_t i = 0; i < passes.cells().size(); ++i) {
      const PixelLight &a = at_once.cells()[i], &b = passes.cells()[i];
      different += a.sum != b.sum || a.share != b.share;
    }
    EXPECT_EQ(different, 0) << samples;
  }
}

TEST(ChainAntialiasing, EveryMethodGivesAnEdgeItsShareOfLinearLight) {
  // The square begins at a quarter of column 6
  Scene scene = red_square(6.25, {20, 14});
  scene.background = LinearRgb{0, 0, 1};
  for (const Antialiasing method : all_methods) {
    if (method == none) continue;
    scene.antialiasing = method;
    const LightPicture light = antialiased(scene, {20, 14});
    const PixelLight edge = light[{6, 7}], inside = light[{9, 7}];
    EXPECT_NEAR(edge.share, 0.75, 0.13) << name_of(method);
    EXPECT_NEAR(edge.sum.x, edge.share, 1e-6) << name_of(method);
    EXPECT_NEAR(inside.share, 1, 1e-12) << name_of(method);
    const LinearRgb mixed = over(edge, scene.background);
    EXPECT_NEAR(mixed.r + mixed.b, 1, 1e-6) << name_of(method);
    EXPECT_EQ((light[{5, 7}].share), 0) << name_of(method);
  }
}

TEST(ChainAntialiasing, ExactAreasAreExact) {
  Scene scene = red_square(6.25, {20, 14});
  scene.antialiasing = area_sampling;
  EXPECT_NEAR((antialiased(scene, {20, 14})[{6, 7}].share), 0.75, 1e-12);
}

TEST(ChainAntialiasing, PartlyCoveredPixelsKeepTheirColourBeforeNoBackground) {
  Scene scene = red_square(6.25, {20, 14});
  int partly = 0;
  for (const Antialiasing method : all_methods) {
    scene.antialiasing = method;
    const Image image = with_alpha(antialiased(scene, {20, 14}));
    for (const Rgba8& p : image.cells()) {
      if (p.a == 0) {
        EXPECT_EQ(p, (Rgba8{0, 0, 0, 0}));
        continue;
      }
      // As red at the edge as inside
      EXPECT_EQ((Rgba8{p.r, p.g, p.b, 255}), (Rgba8{255, 0, 0, 255})) << name_of(method);
      partly += p.a < 255;
    }
    EXPECT_EQ((image[{9, 7}].a), 255) << name_of(method);
    // Three quarters, but for samples that may stand anywhere
    if (method != poisson_disc) {
      EXPECT_EQ(int{(image[{6, 7}].a)}, method == none ? 255 : 191) << name_of(method);
    }
  }
  EXPECT_GT(partly, 40);
}

TEST(ChainAntialiasing, EveryMethodIsNearerToManySamplesThanCentresAre) {
  Scene scene = shipped("letter_f.obj", {60, 45});
  scene.antialiasing = supersampling;
  scene.samples = 256;
  const LightPicture right = antialiased(scene, {60, 45});
  scene.samples = 16;
  scene.antialiasing = none;
  const double without = difference(antialiased(scene, {60, 45}), right, scene.background);
  EXPECT_GT(without, 0.04);
  for (const Antialiasing method : all_methods) {
    if (method == none) continue;
    scene.antialiasing = method;
    const double error = difference(antialiased(scene, {60, 45}), right, scene.background);
    EXPECT_LT(error, without / 3) << name_of(method);
    RecordProperty(std::string(name_of(method)), std::to_string(error / without));
  }
}

TEST(ChainAntialiasing, RandomPixelsDiffer) {
  const Pattern pattern = jittered_pattern(4);
  EXPECT_EQ(pattern.places.size(), 64u * 64 * 4);
  EXPECT_NE(pattern.at({0, 0}, 0), pattern.at({1, 0}, 0));
  const Pattern discs = poisson_disc_pattern(16);
  EXPECT_EQ(discs.places.size(), 32u * 32 * 16);
  EXPECT_NE(discs.at({0, 0}, 0), discs.at({1, 0}, 0));
  EXPECT_EQ(pattern.at({3, 5}, 2), pattern.at({67, 69}, 2));
  for (const ivec2 p : pattern.places) {
    EXPECT_GE(std::min(p.x, p.y), 0);
    EXPECT_LT(std::max(p.x, p.y), 256);
  }
}

TEST(ChainAntialiasing, RefusesNumbersOfSamples) {
  Scene scene = shipped("letter_f.obj", {8, 6});
  for (const int samples : {0, -1, 257}) {
    scene.samples = samples;
    EXPECT_THROW(antialiased(scene, {8, 6}), ContractViolation) << samples;
  }
  scene.samples = 8;
  scene.antialiasing = supersampling;
  EXPECT_THROW(antialiased(scene, {8, 6}), ContractViolation);
}

/// Up to a limit that is nearly reached when they begin: whole models take seconds to reach it.
TEST(ChainAntialiasing, AreasThatWouldTakeTooLongNameTheWayOut) {
  constexpr Size size{60, 40};
  const Scene scene = shipped("letter_f.obj", size);
  const Window window = picture_window(size);
  const auto world = to_world(scene, input(scene));
  const auto seen = to_clip(scene.camera, 1.5, world);
  const Triangles triangles = clip(world, cull(scene, seen), size);
  const auto screen = screen_triangles(triangles, size);
  FragmentColour colour(scene, triangles, size);
  const auto draw = [&](CuttingLimit limit) {
    area_sampling::visible_areas(screen, window, LimitedColour{colour, limit}, [](auto&&...) {});
  };
  CuttingLimit limit(screen.size(), window);
  EXPECT_EQ(limit.left, 10'000'000 + 100 * 60 * 40);
  EXPECT_NO_THROW(draw(limit));
  limit.left = 300;
  try {
    draw(limit);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(),
              fmt::format("--aa area_sampling: expected triangles whose areas take at most 10000000 cuts and "
                          "100 per pixel, found {} that take more; adaptive and a_buffer take samples, and "
                          "draw any",
                          screen.size()));
  }
}

TEST(ChainAntialiasing, NothingInViewShowsTheBackground) {
  Scene scene = red_square(6, {20, 14});
  scene.camera.frame.eye = {0, 0, -50};
  for (const Antialiasing method : all_methods) {
    scene.antialiasing = method;
    const LightPicture light = antialiased(scene, {20, 14});
    for (const PixelLight& pixel : light.cells()) EXPECT_EQ(pixel.share, 0);
  }
}

}  // namespace
}  // namespace gradus::pipeline::antialiasing_test
