// Goldens of Phong's model, and what must add nothing.

#include "shading/illumination/illumination.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/record.hpp"

namespace gradus::illumination {
namespace {

Material surface(float kd, float ks, float n, LinearRgb colour = LinearRgb{1}) {
  Material m;
  m.ambient = 0.1f * colour;
  m.diffuse = kd * colour;
  m.specular = LinearRgb{ks};
  m.shininess = n;
  return m;
}

Light lamp(dvec3 position) {
  Light light;
  light.position = position;
  return light;
}

dvec3 lit(dvec3 light, dvec3 eye, const Material& material = surface(0.7f, 0.2f, 10)) {
  const std::vector<Light> lights{lamp(light)};
  return phong(dvec3{0}, dvec3{0, 0, 1}, eye, material, std::span<const Light>(lights), LinearRgb{1}).sum();
}

TEST(Illumination, Goldens) {
  // G001-80, G001-81; the material's numbers are floats
  EXPECT_NEAR(lit({0, 3, 4}, {0, -3, 4}).x, 0.86, 1e-7);
  EXPECT_NEAR(lit({0, 3, 4}, {0, 0, 5}).y, 0.68147483648, 1e-7);
  // G001-87
  EXPECT_NEAR(lit({0, 0, 2}, {0, 0, 2}).z, 1, 1e-7);
}

TEST(Illumination, TheDirectionToTheLightBeginsAtTheSurface) {
  // G002-11, G002-12, E002-13: from the tip of the normal the first would be lit as from straight above, the
  // second not at all
  const auto cosine = [](dvec3 place, dvec3 light) {
    const std::vector<Light> lights{lamp(light)};
    const Material white = surface(1, 0, 1);
    return phong(place, dvec3{0, 1, 0}, dvec3{0, 9, 9}, white, std::span<const Light>(lights), LinearRgb{0})
        .diffuse.x;
  };
  EXPECT_NEAR(cosine({100, 0, 0}, {0, 10, 0}), 10 / std::sqrt(10100.0), 1e-7);
  EXPECT_NEAR(cosine({0, 0, 0}, {0, 0.5, 0}), 1, 1e-7);
}

TEST(Illumination, TheHighlightIsWhite) {
  // G001-84: on a red surface
  const dvec3 colour = lit({0, 3, 4}, {0, -3, 4}, surface(0.7f, 0.2f, 10, {1, 0, 0}));
  EXPECT_NEAR(glm::distance(colour, dvec3{0.86, 0.2, 0.2}), 0, 1e-7);
}

TEST(Illumination, LightFromBehindAddsNothing) {
  // G001-82
  EXPECT_NEAR(lit({3, 0, -4}, {-10, 0, 1.4}, surface(0.7f, 0.2f, 1)).x, 0.1, 1e-7);
  // G001-83: an even power of a negative cosine
  EXPECT_NEAR(lit({3, 0, 4}, {10, 0, -0.5}, surface(0, 0.2f, 2)).x, 0.1, 1e-7);
  EXPECT_NEAR(lit({3, 0, 0}, {0, 0, 1}).x, 0.1, 1e-7);  // at the horizon
}

TEST(Illumination, WhatHasNoDirectionAddsNothing) {
  EXPECT_NEAR(lit({0, 0, 0}, {0, 0, 1}).x, 0.1, 1e-7);  // the light at the place
  EXPECT_NEAR(lit({0, 0, 4}, {0, 0, 0}).x, 0.8, 1e-7);  // the eye: no highlight
  const std::vector<Light> lights{lamp({0, 0, 4})};
  const auto parts = phong(dvec3{0}, dvec3{0}, dvec3{0, 0, 1}, surface(0.7f, 0.2f, 0),
                           std::span<const Light>(lights), LinearRgb{1});
  EXPECT_EQ(parts.diffuse + parts.specular, dvec3{0});  // no normal, although n = 0
}

TEST(Illumination, ExponentsOfAnySizeGiveNumbers) {
  EXPECT_NEAR(lit({0, 0, 4}, {0, 0, 4}, surface(0, 0.5f, 1e6f)).x, 0.6, 1e-7);  // straight into the mirror
  EXPECT_NEAR(lit({0, 0, 4}, {1, 0, 4}, surface(0, 0.5f, 1e6f)).x, 0.1, 1e-7);  // a little beside it
  EXPECT_NEAR(lit({0, 0, 4}, {1, 0, 4}, surface(0, 0.5f, 0)).x, 0.6, 1e-7);     // a highlight everywhere
  // A root of a negative cosine
  EXPECT_NEAR(lit({3, 0, 4}, {10, 0, -0.5}, surface(0, 0.5f, 0.5f)).x, 0.1, 1e-7);
}

TEST(Illumination, LightsAddUpAndWeaken) {
  const Material m = surface(0.5f, 0, 1);
  Light near = lamp({0, 0, 2}), far = lamp({0, 0, 2});
  far.constant = 1;
  far.linear = 0.5;
  far.quadratic = 0.5;
  EXPECT_DOUBLE_EQ(attenuation(far, 2.0), 0.25);
  far.constant = 0;
  EXPECT_DOUBLE_EQ(attenuation(far, 0.1), 1);  // never stronger than it left
  far.constant = 1;
  Light sun;
  sun.kind = Light::Kind::directional;
  sun.direction = {0, 0, -3};
  sun.intensity = {0, 0, 2};
  const std::vector<Light> lights{near, far, sun};
  const auto parts =
      phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 0, 9}, m, std::span<const Light>(lights), LinearRgb{0.5f});
  EXPECT_NEAR(glm::distance(parts.diffuse, dvec3{0.625, 0.625, 1.625}), 0, 1e-7);
  EXPECT_NEAR(parts.ambient.x, 0.05, 1e-7);
  Material glowing = m;
  glowing.emission = {3, 0, 0};
  EXPECT_NEAR(lit({0, 0, -1}, {0, 0, 1}, glowing).x, 3.1, 1e-6);
}

// Distances whose squares overflow or vanish
TEST(Illumination, LightsAtAnyDistance) {
  const auto from = [](double distance, double constant, double linear) {
    Light light = lamp({0, 0.6 * distance, 0.8 * distance});
    light.constant = constant;
    light.linear = linear;
    const std::vector<Light> lights{light};
    return phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 0, 9}, surface(1, 0, 1), std::span<const Light>(lights),
                 LinearRgb{0})
        .diffuse.x;
  };
  EXPECT_DOUBLE_EQ(from(1e200, 0, 1e-199), 0.08);
  EXPECT_DOUBLE_EQ(from(1e-200, 0, 1e201), 0.08);
  EXPECT_DOUBLE_EQ(from(0x5p-1074, 1, 0), 0.8);
}

TEST(Illumination, StepsFollowTheGrammar) {
  Recorder<AmbientAdded<double>, LightAdded<double>, Finished<double>> seen;
  const std::vector<Light> lights{lamp({0, 3, 4}), lamp({0, 0, -1})};
  const auto run = [&](auto&& observer) {
    return phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, -3, 4}, surface(0.7f, 0.2f, 10),
                 std::span<const Light>(lights), LinearRgb{1}, observer);
  };
  const auto parts = run(seen);
  EXPECT_EQ(parts.sum(), run(Unobserved{}).sum());
  ASSERT_EQ(seen.events().size(), 4u);
  EXPECT_TRUE(std::holds_alternative<AmbientAdded<double>>(seen.events()[0].step));
  const auto& first = std::get<LightAdded<double>>(seen.events()[1].step);
  EXPECT_NEAR(first.n_dot_l, 0.8, 1e-15);
  EXPECT_NEAR(first.r_dot_v, 1, 1e-15);
  const auto& second = std::get<LightAdded<double>>(seen.events()[2].step);
  EXPECT_EQ(second.light, 1u);
  EXPECT_EQ(second.diffuse, dvec3{0});
  EXPECT_EQ(std::get<Finished<double>>(seen.events()[3].step).specular, parts.specular);
  // float says the same, less exactly
  const auto floats = phong(glm::vec3{0}, glm::vec3{0, 0, 1}, glm::vec3{0, -3, 4}, surface(0.7f, 0.2f, 10),
                            std::span<const Light>(lights), LinearRgb{1});
  EXPECT_NEAR(floats.sum().x, parts.sum().x, 1e-6);
}

}  // namespace
}  // namespace gradus::illumination
