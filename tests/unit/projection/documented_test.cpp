// The numbers that the pages of projections claim, measured again.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <set>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "projection/parallel/parallel.hpp"
#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "projection/viewport/viewport.hpp"
#include "stress/projection/viewing.hpp"
#include "stress/projection/viewport.hpp"
#include "support/documented.hpp"

namespace gradus {
namespace {

using test::states;
using Wide = boost::multiprecision::cpp_bin_float_100;

constexpr const char* viewing_page = "docs/topics/projection/viewing.md";
constexpr const char* viewport_page = "docs/topics/projection/viewport.md";
constexpr const char* parallel_page = "docs/topics/projection/parallel.md";

TEST(DocumentedProjection, TheWorstUpKnown) {
  // In float, for whose ulp the bound is the same; found by `gradus stress viewing`
  using F = glm::vec3;
  const F eye{0, 0x1.7328e8p0f, 0}, target{0, 0, -0x1.c8c26ap0f}, up{-0x1p12f, 0, 1};
  const auto frame = viewing::look_at(eye, target, up);
  const auto exact = stress::axes_of<Wide>(eye, target, up);
  double worst = 0;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Wide off = std::max(Wide(abs(Wide(frame.right[k]) - exact.right[i])),
                              Wide(abs(Wide(frame.up[k]) - exact.up[i])));
    worst = std::max(worst, static_cast<double>(Wide(off * exact.sine)) / 0x1p-23);
  }
  EXPECT_TRUE(states(viewing_page,
                     "sine of the angle between the view and the given up (the worst known is {} off)",
                     {worst}));
}

TEST(DocumentedProjection, AnEyeFarAway) {
  const dvec3 far{0x1p40, 0, 0}, p{0.25, 1.5, -0.125};
  const auto near = viewing::look_at(dvec3{2, 3, 5}, dvec3{0}, dvec3{0, 1, 0});
  auto away = near;
  away.eye = far + near.eye;
  EXPECT_EQ(viewing::to_view(away, far + p), viewing::to_view(near, p));
  const dvec3 lost = dvec3(viewing::world_to_view(away) * glm::dvec4(far + p, 1)) - viewing::to_view(near, p);
  EXPECT_TRUE(states(viewing_page, "the matrix is off by {} where `to_view` is exact", {glm::length(lost)}));
}

TEST(DocumentedProjection, PlacesAndTheWayBack) {
  using namespace viewport;
  Random random(20240611);
  double places = 0, back = 0;
  for (int n = 0; n < 200'000; ++n) {
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform_int(-60, 60)));
    const dvec2 lower{size * random.uniform(-1, 1), size * random.uniform(-1, 1)};
    const dvec2 upper = lower + size * dvec2{random.uniform(0.01, 1), random.uniform(0.01, 1)};
    const ivec2 picture{static_cast<int>(random.uniform_int(1, 5000)),
                        static_cast<int>(random.uniform_int(1, 5000))};
    const auto map = stretched(Rectangle<double>{lower, upper}, picture);
    const dvec2 point{random.uniform(lower.x, upper.x), random.uniform(lower.y, upper.y)};
    const dvec2 place = place_at(map.viewport, fraction_of(map, point)), again = to_plane(map, place);
    const double largest =
        std::max({std::abs(lower.x), std::abs(lower.y), std::abs(upper.x), std::abs(upper.y)});
    for (int k = 0; k < 2; ++k) {
      using Long = boost::multiprecision::cpp_bin_float_quad;
      const Long share = (Long(point[k]) - Long(lower[k])) / (Long(upper[k]) - Long(lower[k]));
      const Long right = (k == 0 ? share : Long(1 - share)) * picture[k];
      places = std::max(places,
                        static_cast<double>(Long(abs(Long(Long(place[k]) - right)))) / picture[k] / 0x1p-52);
      back = std::max(back, std::abs(again[k] - point[k]) / largest / 0x1p-52);
    }
  }
  EXPECT_TRUE(
      states(viewport_page, "pictures to 5000 pixels per side) the worst is {} · 2⁻⁵² of it off.", {places}));
  EXPECT_TRUE(
      states(viewport_page,
             "There and back is within 4 ulp of the window's largest coordinate, the worst {} · 2⁻⁵² of it.",
             {back}));
}

TEST(DocumentedProjection, CentresLeadBack) {
  using namespace viewport;
  Random random(20240611);
  int pixels = 0, lost = 0;
  for (int n = 0; n < 2000; ++n) {
    const ivec2 picture{static_cast<int>(random.uniform_int(1, 24)),
                        static_cast<int>(random.uniform_int(1, 24))};
    const double digits = random.uniform(1, 2);
    const double largest = std::ldexp(digits, static_cast<int>(random.uniform_int(-60, 60)));
    const double ulp = std::nextafter(largest, HUGE_VAL) - largest;
    // From 9 ulp per pixel on, those most of the time
    const auto share = [&](int count) {
      const double more = random.unit();
      return count * ulp * (9 + std::ldexp(more, static_cast<int>(random.uniform_int(0, 30))));
    };
    const Rectangle<double> window{{largest - share(picture.x), largest - share(picture.y)},
                                   {largest, largest}};
    const auto map = stretched(window, picture);
    for (int y = 0; y < picture.y; ++y) {
      for (int x = 0; x < picture.x; ++x, ++pixels)
        lost += rasterize(map, pixel_centre(map, {x, y})) != std::optional(ivec2{x, y});
    }
  }
  EXPECT_EQ(lost, 0);
  EXPECT_TRUE(states(viewport_page, "(tested for {} pixels of 2000 windows)", {double(pixels)}));
  // Where they are narrower than an ulp
  const auto narrow = stretched(Rectangle<double>{{1e9, 0}, {1e9 + 1e-4, 1}}, {1920, 1});
  int doubles = 0, none = 0;
  for (double x = 1e9; x <= 1e9 + 1e-4; x = std::nextafter(x, HUGE_VAL)) ++doubles;
  for (int x = 0; x < 1920; ++x)
    none += rasterize(narrow, pixel_centre(narrow, {x, 0})) != std::optional(ivec2{x, 0});
  EXPECT_TRUE(states(viewport_page,
                     "of 1,920 columns from 1e9 to 1e9 + 1e-4, which share {} doubles, {} hold none",
                     {double(doubles), double(none)}));
}

TEST(DocumentedProjection, AlongADirectionNearlyInThePlane) {
  using namespace parallel;
  using Long = boost::multiprecision::cpp_bin_float_quad;
  Random random(20240611);
  double worst = 0;
  for (int n = 0; n < 16'000; ++n) {
    const auto vector = [&] {
      return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const dvec3 normal = vector(), point = 10.0 * vector();
    dvec3 v = vector();
    if (n % 2 == 0) {
      v -= normal * (glm::dot(normal, v) / glm::dot(normal, normal));
      v += std::ldexp(1.0, -static_cast<int>(random.uniform_int(1, 40))) * normal;
    }
    const double offset = random.uniform(-10, 10);
    const Plane<double> plane{normal, offset};
    if (!meets(plane, v)) continue;
    const dvec3 image = along(plane, v, point);
    Long q = 0, ahead = offset, size = std::abs(offset), sum = 0;
    for (int k = 0; k < 3; ++k) {
      const Long slope = Long(normal[k]) * v[k], place = Long(normal[k]) * point[k];
      q += slope, sum += abs(slope), ahead -= place, size += abs(place);
    }
    for (int k = 0; k < 3; ++k) {
      const Long right = point[k] + v[k] * ahead / q;
      const Long bound = 0x1p-53 * (10 * abs(Long(v[k])) * size * sum / (q * q) + 2 * std::abs(point[k]));
      worst = std::max(worst, static_cast<double>(Long(abs(Long(right - image[k])) / bound)));
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_TRUE(states(parallel_page,
                     "The worst of 16,000 random cases, nearly parallel ones included, reached {} of that.",
                     {worst}));
}

/// How far apart two depths z must lie for their stored depths to differ, wherever roundings fall: a step of
/// what is stored, by the slope there, n = 1 and f = 1e6.
struct Curve {
  long double slope(long double z) const { return linear ? 1 / (1e6L - 1) : 1e6L / (1e6L - 1) / (z * z); }
  double step_of_24_bits(long double z) const { return static_cast<double>(1 / (0xffffff * slope(z))); }
  double step_of_floats(long double z) const {
    const long double inverse = 1e6L / (1e6L - 1) * (1 - 1 / z), depth = reversed ? 1 - inverse : inverse;
    const float at = static_cast<float>(depth);
    return static_cast<double>((at - std::nextafter(at, 0.0f)) / slope(z));
  }
  bool linear = false, reversed = false;
};

TEST(DocumentedProjection, StepsOfDepth) {
  constexpr const char* page = "docs/topics/projection/perspective.md";
  const Curve linear{.linear = true}, inverse, reversed{.reversed = true};
  const auto row = [&](const char* text, double z) {
    return states(page, text,
                  {linear.step_of_24_bits(z), inverse.step_of_24_bits(z), inverse.step_of_floats(z),
                   reversed.step_of_floats(z)});
  };
  EXPECT_TRUE(row("| 100 | {} | {} | {} | {} |", 100));
  EXPECT_TRUE(row("| 1000 | {} | {} | {} | {} |", 1000));
  EXPECT_TRUE(row("| 100,000 | {} | {} | {} | {} |", 1e5));
  EXPECT_TRUE(
      states(page, "| 1,000,000 | {} | {} | {} | finer than 1e-8 |",
             {linear.step_of_24_bits(1e6), inverse.step_of_24_bits(1e6), inverse.step_of_floats(1e6)}));
  EXPECT_LT(reversed.step_of_floats(1e6), 1e-8);
  EXPECT_TRUE(states(page, "reversed floats separate 500000 and 500000.01, though a step is {} there.",
                     {reversed.step_of_floats(5e5)}));
}

TEST(DocumentedProjection, DepthsAlongALineOfTheScreen) {
  Random random(20240611);
  double kept = 0, inverted = 0;
  for (int n = 0; n < 100'000; ++n) {
    const double z0 = random.uniform(1, 100), z1 = random.uniform(1, 100), part = random.unit();
    const double z =
        z0 + part * (z1 - z0);  // of the line's point; its image divides the images of the ends so
    const double share = part * z1 / z;
    kept = std::max(kept, (1 - share) * z0 + share * z1 - z);
    inverted = std::max(inverted, std::abs(1 / ((1 - share) / z0 + share / z1) - z) / z);
  }
  EXPECT_TRUE(states("docs/topics/projection/perspective.md",
                     "in 100,000 random lines the worst was {}, and {} of the depth with 1/z.",
                     {kept, inverted}));
}

}  // namespace
}  // namespace gradus
