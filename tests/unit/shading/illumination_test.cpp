// Goldens of Phong's model, the lamps it knows, what must add nothing, and what lecture notes get wrong.

#include "shading/illumination/illumination.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "core/record.hpp"
#include "core/surface.hpp"
#include "shading/illumination/illumination_notes.hpp"

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

/// The same in double, for the goldens' last digits.
Reflectance<double> exactly(double kd, double ks, double n, dvec3 colour = dvec3{1}) {
  return {0.1 * colour, kd * colour, dvec3{ks}, n, dvec3{0}};
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

/// The light of some lamps at the origin, on a surface that looks up, in white ambient light.
constexpr auto right = [](auto&&... a) { return phong(a...); };
template <class Method>
Parts<double> at_origin(const Method& method, const std::vector<Light>& lights, dvec3 eye,
                        const Reflectance<double>& material) {
  return method(dvec3{0}, dvec3{0, 0, 1}, eye, material, std::span<const Light>(lights), dvec3{1}, AllSeen{});
}
dvec3 golden(dvec3 light, dvec3 eye, const Reflectance<double>& material) {
  return at_origin(right, {lamp(light)}, eye, material).sum();
}

TEST(Illumination, Goldens) {
  const auto plain = exactly(0.7, 0.2, 10);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(golden({0, 3, 4}, {0, -3, 4}, plain)[k], 0.86, 1e-12);                    // G001-80
    EXPECT_NEAR(golden({0, 3, 4}, {0, 0, 5}, plain)[k], 0.68147483648, 1e-12);            // G001-81
    EXPECT_NEAR(golden({0, 0, 2}, {0, 0, 2}, plain)[k], 1, 1e-12);                        // G001-87
    EXPECT_NEAR(golden({3, 0, -4}, {-10, 0, 1.4}, exactly(0.7, 0.2, 1))[k], 0.1, 1e-12);  // G001-82
  }
  // G001-83: N.L = 0.5, R.V = -1
  const double far = std::sqrt(3.0);
  EXPECT_EQ(at_origin(right, {lamp({far, 0, 1})}, {far, 0, -1}, exactly(0, 1, 2)).specular, dvec3{0});
  const dvec3 red = golden({0, 3, 4}, {0, -3, 4}, exactly(0.7, 0.2, 10, {1, 0, 0}));
  EXPECT_NEAR(glm::distance(red, dvec3{0.86, 0.2, 0.2}), 0, 1e-12);  // G001-84
}

TEST(Illumination, TheDirectionToTheLightBeginsAtTheSurface) {
  const auto cosine = [](const auto& method, dvec3 place, dvec3 light) {
    const std::vector<Light> lights{lamp(light)};
    return method(place, dvec3{0, 1, 0}, dvec3{0, 9, 9}, exactly(1, 0, 1), std::span<const Light>(lights),
                  dvec3{0}, AllSeen{})
        .diffuse.x;
  };
  EXPECT_NEAR(cosine(right, {100, 0, 0}, {0, 10, 0}), 0.09950371902099892, 1e-12);  // G002-11
  EXPECT_NEAR(cosine(right, {0, 0, 0}, {0, 0.5, 0}), 1, 1e-12);                     // G002-12
  // E002-13: from the tip of the normal the first is lit as from straight above, the second not at all
  const auto faulty = [](auto&&... a) { return light_minus_normal(a...); };
  EXPECT_NEAR(cosine(faulty, {100, 0, 0}, {0, 10, 0}), 1, 1e-12);
  EXPECT_EQ(cosine(faulty, {0, 0, 0}, {0, 0.5, 0}), 0);
}

TEST(Illumination, TheHighlightIsWhite) {
  // G001-84: on a red surface
  const dvec3 colour = lit({0, 3, 4}, {0, -3, 4}, surface(0.7f, 0.2f, 10, {1, 0, 0}));
  EXPECT_NEAR(glm::distance(colour, dvec3{0.86, 0.2, 0.2}), 0, 1e-7);
}

TEST(Illumination, TheNotesTintTheHighlight) {
  // E001-37
  const auto faulty = [](auto&&... a) { return tinted_highlight(a...); };
  const dvec3 colour =
      at_origin(faulty, {lamp({0, 3, 4})}, {0, -3, 4}, exactly(0.7, 0.2, 10, {1, 0, 0})).sum();
  EXPECT_NEAR(glm::distance(colour, dvec3{0.86, 0, 0}), 0, 1e-12);
}

TEST(Illumination, TheNotesClampEachProductAlone) {
  // E001-36
  const auto faulty = [](auto&&... a) { return light_behind(a...); };
  const std::vector<Light> behind{lamp({3, 0, -4})};
  EXPECT_NEAR(at_origin(faulty, behind, {-10, 0, 1.4}, exactly(0.7, 0.2, 1)).sum().x, 0.19665735447541463,
              1e-12);
  // 0^0 = 1 of what was clamped
  EXPECT_NEAR(at_origin(faulty, behind, {10, 0, 1.4}, exactly(0.7, 0.2, 0)).sum().x, 0.3, 1e-12);
}

TEST(Illumination, TheNotesClampNothing) {
  // E001-35: darker than its ambient light; (-1)^2 = 1; a root of a negative number
  const auto faulty = [](auto&&... a) { return unclamped(a...); };
  EXPECT_NEAR(at_origin(faulty, {lamp({3, 0, -4})}, {0, 0, 1}, exactly(0.1, 0, 1)).sum().x, 0.1 - 0.08,
              1e-12);
  EXPECT_NEAR(at_origin(faulty, {lamp({0, 0, 4})}, {0, 0, -4}, exactly(0, 0.2, 2)).specular.x, 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(at_origin(faulty, {lamp({3, 0, 4})}, {10, 0, 1}, exactly(0, 0.2, 0.5)).specular.x));
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
  Recorder<AmbientAdded<double>, LampTaken<double>, LightAdded<double>, Finished<double>> seen;
  const std::vector<Light> lights{lamp({0, 3, 4}), lamp({0, 0, -1})};
  const auto run = [&](auto&& observer) {
    return phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, -3, 4}, surface(0.7f, 0.2f, 10),
                 std::span<const Light>(lights), LinearRgb{1}, AllSeen{}, observer);
  };
  const auto parts = run(seen);
  EXPECT_EQ(parts.sum(), run(Unobserved{}).sum());
  ASSERT_EQ(seen.events().size(), 6u);
  EXPECT_TRUE(std::holds_alternative<AmbientAdded<double>>(seen.events()[0].step));
  const auto& first = std::get<LightAdded<double>>(seen.events()[2].step);
  EXPECT_NEAR(first.n_dot_l, 0.8, 1e-15);
  EXPECT_NEAR(first.cosine, 1, 1e-15);
  const auto& second = std::get<LightAdded<double>>(seen.events()[4].step);
  EXPECT_EQ(second.light, 1u);
  EXPECT_EQ(second.diffuse, dvec3{0});
  EXPECT_EQ(std::get<Finished<double>>(seen.events()[5].step).specular, parts.specular);
  // float says the same, less exactly
  const auto floats = phong(glm::vec3{0}, glm::vec3{0, 0, 1}, glm::vec3{0, -3, 4}, surface(0.7f, 0.2f, 10),
                            std::span<const Light>(lights), LinearRgb{1});
  EXPECT_NEAR(floats.sum().x, parts.sum().x, 1e-6);
}

// --- Lamps

/// What one lamp scatters from the origin, where the surface is white and looks up.
double scatter(const Light& light) {
  return at_origin(right, {light}, {0, 0, 9}, exactly(1, 0, 1)).diffuse.x;
}

TEST(Illumination, AmbientLightKnowsNoNormal) {
  std::mt19937_64 random(114);  // NOLINT: the same on each run
  std::normal_distribution<double> coordinate;
  for (int round = 0; round < 100; ++round) {
    const dvec3 normal = unit_vector(dvec3{coordinate(random), coordinate(random), coordinate(random)});
    EXPECT_EQ(
        phong(dvec3{0}, normal, dvec3{0, 0, 9}, exactly(1, 1, 1), std::span<const Light>(), dvec3{0.5}).sum(),
        dvec3{0.05});
  }
}

TEST(Illumination, ScatteredLightFollowsTheCosine) {
  const auto at_angle = [](double degrees) {
    const auto [s, c] = sin_cos_degrees(degrees);
    return scatter(lamp(5.0 * dvec3{s, 0, c}));
  };
  EXPECT_EQ(at_angle(0), 1);
  EXPECT_NEAR(at_angle(60), 0.5, 1e-15);
  for (int degrees = 90; degrees <= 180; degrees += 5) EXPECT_EQ(at_angle(degrees), 0) << degrees;
  // Half the cosine halves each channel
  const auto parts =
      at_origin(right, {lamp({0, 5 * std::sqrt(0.75), 2.5})}, {0, 0, 9}, exactly(0.5, 0, 1, {1, 0.5, 0.25}));
  EXPECT_NEAR(glm::distance(parts.diffuse, 0.5 * dvec3{0.5, 0.25, 0.125}), 0, 1e-15);
}

TEST(Illumination, TheHighlightIsLargestInTheMirrorAndNarrowsWithN) {
  // Where the highlight has half its strength: cos^n = 1/2
  double width_before = 90;
  for (const double n : {1.0, 4.0, 16.0, 64.0, 256.0}) {
    const auto highlight = [&](double off) {
      const auto [s, c] = sin_cos_degrees(30 + off);
      return at_origin(right, {lamp({-0.5, 0, std::sqrt(0.75)})}, {s, 0, c}, exactly(0, 1, n)).specular.x;
    };
    EXPECT_NEAR(highlight(0), 1, 1e-12);
    double last = highlight(0), width = 0;
    for (int off = 1; off < 60; ++off) {
      EXPECT_LE(highlight(off), last);
      last = highlight(off);
      if (last >= 0.5) width = off;
    }
    EXPECT_LT(width, width_before) << n;
    width_before = width;
  }
}

TEST(Illumination, FarLightIsParallel) {
  double before = 4;
  for (double distance = 1; distance < 1e9; distance *= 10) {
    const Light far = lamp({0.3 * distance, 0, distance});
    const auto l = towards(far, 0, dvec3{0}).first, m = towards(far, 0, dvec3{1, 0, 0}).first;
    const double angle = glm::length(glm::cross(l, m));
    EXPECT_LT(angle, before);
    EXPECT_LE(angle, 1.1 / distance);
    before = angle;
  }
  Light sun;
  sun.kind = Light::Kind::directional;
  sun.direction = {0, 3, -4};
  EXPECT_EQ(towards(sun, 0, dvec3{0}), towards(sun, 0, dvec3{1e9, 5, -7}));
}

TEST(Illumination, DirectionsHaveLengthOne) {
  const std::uint64_t seed = 43;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> coordinate;
  for (int round = 0; round < 1000; ++round) {
    const dvec3 position{coordinate(random), 1e3 * coordinate(random), 1e-3 * coordinate(random)};
    const dvec3 place{coordinate(random), coordinate(random), coordinate(random)};
    const dvec3 l = towards(lamp(position), 0, place).first;
    EXPECT_NEAR(glm::length(l), 1, 1e-15) << seed << ' ' << round;
    const dvec3 n = unit_vector(place);
    EXPECT_NEAR(glm::length(reflected(n, l)), 1, 2e-15) << seed << ' ' << round;
  }
}

TEST(Illumination, BeyondItsRangeALampAddsNothing) {
  Light light = lamp({0, 0, 2});
  for (const double range : {0.5, 1.0, 2.0}) {
    light.range = range;
    EXPECT_EQ(scatter(light), 0) << range;
  }
  light.range = 4;
  EXPECT_NEAR(scatter(light), (1 - 1.0 / 16) * (1 - 1.0 / 16), 1e-15);
  light.range = std::nextafter(2.0, 3.0);
  EXPECT_LT(scatter(light), 1e-29);  // smooth to the end
  light.range = Light{}.range;
  EXPECT_EQ(scatter(light), 1);
}

TEST(Illumination, ASpotLightsItsCone) {
  Light spot = lamp({0, 0, 2});
  spot.kind = Light::Kind::spot;
  const auto at_angle = [&](double degrees) {
    const auto [s, c] = sin_cos_degrees(degrees);
    spot.direction = 7.0 * dvec3{s, 0, -c};
    return scatter(spot);
  };
  spot.outer_cosine = sin_cos_degrees(40).cos;
  spot.inner_cosine = sin_cos_degrees(20).cos;
  EXPECT_EQ(at_angle(0), 1);
  EXPECT_EQ(at_angle(19), 1);
  EXPECT_EQ(at_angle(40.001), 0);
  EXPECT_EQ(at_angle(180), 0);
  double last = 1;
  for (int degrees = 20; degrees < 41; ++degrees) {
    EXPECT_LE(at_angle(degrees), last);
    last = at_angle(degrees);
  }
  const double c = sin_cos_degrees(30).cos;
  const double t = (c - spot.outer_cosine) / (spot.inner_cosine - spot.outer_cosine);
  EXPECT_NEAR(at_angle(30), t * t * (3 - 2 * t), 1e-14);
  spot.concentration = 8;
  EXPECT_NEAR(at_angle(30), t * t * (3 - 2 * t) * std::pow(c, 8), 1e-14);
  // A hard edge: both cones are one; on it there is nothing
  spot.concentration = 0;
  spot.outer_cosine = spot.inner_cosine = 0.5;
  EXPECT_EQ(at_angle(59.999), 1);
  EXPECT_EQ(at_angle(60.001), 0);
  spot.outer_cosine = spot.inner_cosine = 1;
  EXPECT_EQ(at_angle(0), 0);
}

Light panel(dvec3 middle, dvec3 across, dvec3 along, int samples) {
  Light area = lamp(middle);
  area.kind = Light::Kind::area;
  area.across = across, area.along = along;
  area.constant = 0, area.quadratic = 1;
  area.samples = samples;
  return area;
}

// How near an area comes to Lambert's integral is a promise
TEST(Illumination, TwiceAnAreasSamplesLeaveAQuarterOfItsError) {
  const auto light = [](int n) { return scatter(panel({1, -2, 4}, {-0.2, 1, -0.4}, {1, 0.3, 0.2}, n)); };
  EXPECT_GT(light(1), 0.01);
  for (const int n : {1, 2, 4})
    EXPECT_NEAR((light(n) - light(2 * n)) / (light(2 * n) - light(4 * n)), 4, 0.5) << n;
}

TEST(Illumination, AnAreaShinesToItsFrontOnly) {
  EXPECT_GT(scatter(panel({0, 0, 2}, {0, 1, 0}, {1, 0, 0}, 3)), 0.2);
  EXPECT_EQ(scatter(panel({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 3)), 0);
  // Its middle alone, seen straight from below: the strength of a point
  EXPECT_DOUBLE_EQ(scatter(panel({0, 0, 2}, {0, 1, 0}, {1, 0, 0}, 1)), 0.25);
}

/// Which share of the light a wall over x < 0 leaves, at places to the left and to the right.
TEST(Illumination, OnlyAnAreaHasASoftEdge) {
  const auto shares = [](const Light& light) {
    std::vector<double> levels;
    for (int x = -30; x <= 30; ++x) {
      // The wall covers x < 0 at the height 1
      const auto above = [](dvec3 from, dvec3 l, double d) {
        if (l.z <= 0 || 1 / l.z > d) return true;
        return from.x + l.x / l.z >= 0;
      };
      const auto lit = [&](auto&& visible) {
        return phong(dvec3{0.02 * x, 0, 0}, dvec3{0, 0, 1}, dvec3{0, 0, 9}, exactly(1, 0, 1),
                     std::span<const Light>(&light, 1), dvec3{0}, visible)
            .diffuse.x;
      };
      const double share = lit(above) / lit(AllSeen{});
      EXPECT_GE(share, levels.empty() ? 0 : levels.back() - 1e-12);
      levels.push_back(share);
    }
    int between = 0;
    for (const double share : levels) between += share > 0 && share < 1;
    EXPECT_EQ(levels.front(), 0);
    EXPECT_EQ(levels.back(), 1);
    return between;
  };
  const Light point = lamp({0, 0, 2});
  Light spot = point, sun = point;
  spot.kind = Light::Kind::spot;
  spot.direction = {0, 0, -1};
  sun.kind = Light::Kind::directional;
  sun.direction = {0, 0, -1};
  EXPECT_EQ(shares(point), 0);
  EXPECT_EQ(shares(spot), 0);
  EXPECT_EQ(shares(sun), 0);
  EXPECT_GT(shares(panel({0, 0, 2}, {0, 0.6, 0}, {0.6, 0, 0}, 8)), 20);
}

TEST(Illumination, VisibilityIsAskedWhereLightArrives) {
  std::vector<double> ways;
  const auto ask = [&](dvec3, dvec3 l, double d) {
    EXPECT_NEAR(glm::length(l), 1, 1e-15);
    ways.push_back(d);
    return false;
  };
  Light sun, out = lamp({0, 0, 3});
  sun.kind = Light::Kind::directional;
  sun.direction = {0, 0, -1};
  out.range = 2;
  const std::vector<Light> lights{lamp({0, 0, 2}), sun, out, panel({0, 0, 4}, {0, 1, 0}, {1, 0, 0}, 2)};
  const auto parts = phong(dvec3{0}, dvec3{0, 0, 1}, dvec3{0, 0, 9}, exactly(1, 1, 1),
                           std::span<const Light>(lights), dvec3{1}, ask);
  ASSERT_EQ(ways.size(), 6u);
  EXPECT_EQ(ways[0], 2);
  EXPECT_EQ(ways[1], std::numeric_limits<double>::infinity());
  EXPECT_EQ(parts.diffuse + parts.specular, dvec3{0});
}

TEST(Illumination, BlinnsHighlightIsHalfwayBetween) {
  const auto blinn = [](auto&&... a) { return blinn_phong(a...); };
  const auto material = exactly(0, 1, 10);
  // In the mirror both are 1; elsewhere H is half as far off as R
  EXPECT_NEAR(at_origin(blinn, {lamp({0, 3, 4})}, {0, -3, 4}, material).specular.x, 1, 1e-12);
  for (int off = 0; off <= 60; off += 5) {
    const auto [s, c] = sin_cos_degrees(off);
    const double b = at_origin(blinn, {lamp({0, 0, 4})}, {s, 0, c}, material).specular.x;
    const double p = at_origin(right, {lamp({0, 0, 4})}, {s, 0, c}, material).specular.x;
    EXPECT_NEAR(b, std::pow(sin_cos_degrees(0.5 * off).cos, 10), 1e-12);
    EXPECT_GE(b, p);
  }
  // Opposite directions have nothing halfway
  EXPECT_EQ(at_origin(blinn, {lamp({1, 0, 0})}, {-1, 0, 0}, material).specular.x, 0);
  EXPECT_EQ(at_origin(blinn, {lamp({1, 0, -1})}, {-1, 0, 2}, material).specular.x, 0);  // from behind
}

TEST(Illumination, EachFieldOfALampCounts) {
  const auto m = exactly(0.5, 0.5, 4);
  Light spot = lamp({0, 3, 4});
  spot.kind = Light::Kind::spot;
  spot.direction = {0, -3, -4};
  spot.outer_cosine = 0.5, spot.inner_cosine = 0.99;
  const auto colour = [&](const Light& light) { return at_origin(right, {light}, {0, -1, 4}, m).sum(); };
  const dvec3 before = colour(spot);
  Light other = spot;
  other.position = {0, 4, 4};
  EXPECT_NE(colour(other), before);
  other = spot, other.intensity = LinearRgb{0.5f};
  EXPECT_NE(colour(other), before);
  other = spot, other.direction = {0, -4, -3};
  EXPECT_NE(colour(other), before);
  other = spot, other.intensity = LinearRgb{1, 0.5f, 1};
  EXPECT_EQ(colour(other).x, before.x);
  EXPECT_NE(colour(other).y, before.y);
}

}  // namespace
}  // namespace gradus::illumination
