// Simple polygons are covered exactly once: no triangle turned round, and the areas add up, in rationals.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "core/random.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "support/seed.hpp"

namespace gradus::ear_clipping {
namespace {

using boost::multiprecision::cpp_rational;

cpp_rational doubled_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const cpp_rational ax(a.x), ay(a.y);
  return (cpp_rational(b.x) - ax) * (cpp_rational(c.y) - ay) -
         (cpp_rational(b.y) - ay) * (cpp_rational(c.x) - ax);
}

/// A simple polygon: corners round a middle, near or far, some of them on the line of their neighbours.
std::vector<glm::dvec2> any_star(Random& random) {
  const auto n = random.uniform_int(3, 24);
  const double scale = random.uniform_int(0, 1) ? 1 : 1e-9;
  std::vector<glm::dvec2> polygon;
  for (std::int64_t i = 0; i < n; ++i) {
    const double angle =
        6.283185307179586 * (static_cast<double>(i) + 0.4 * random.unit()) / static_cast<double>(n);
    const double radius = random.uniform(0.1, 1);
    polygon.push_back(scale * radius * glm::dvec2{std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

/// A comb on whole numbers: deep notches and straight corners.
std::vector<glm::dvec2> any_comb(Random& random) {
  const auto teeth = random.uniform_int(1, 8);
  std::vector<glm::dvec2> polygon{{0, 0}};
  for (std::int64_t i = 1; i <= 2 * teeth; ++i) {
    if (random.uniform_int(0, 2) == 0) polygon.emplace_back(static_cast<double>(i) - 0.5, 0);
  }
  const double end = static_cast<double>(2 * teeth);
  polygon.emplace_back(end, 0);
  for (std::int64_t i = 2 * teeth; i >= 0; --i) {
    polygon.emplace_back(static_cast<double>(i),
                         i % 2 == 0 ? 10 : 1 + static_cast<double>(random.uniform_int(0, 1)));
  }
  return polygon;
}

TEST(EarClippingProperty, SimplePolygonsAreCoveredOnce) {
  Random random(test::seed());
  int cases = 0, reflex = 0, straight = 0;
  for (; cases < 4000; ++cases) {
    const auto polygon = cases % 2 ? any_star(random) : any_comb(random);
    cpp_rational whole = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      whole += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
    cpp_rational sum = 0;
    std::size_t count = 0;
    triangulate(std::span<const glm::dvec2>(polygon), [&](const Triangle& t) {
      const auto at = [&](std::size_t i) { return polygon[static_cast<std::size_t>(t[i])]; };
      const cpp_rational area = doubled_area(at(0), at(1), at(2));
      ASSERT_GE(area, 0) << "case " << cases << ", seed " << test::seed();
      sum += area;
      straight += area == 0;
      ++count;
    });
    ASSERT_EQ(count, polygon.size() - 2);
    ASSERT_EQ(sum, whole) << "case " << cases << ", seed " << test::seed();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      reflex +=
          orient2d(polygon[i], polygon[(i + 1) % polygon.size()], polygon[(i + 2) % polygon.size()]) < 0;
    }
  }
  EXPECT_EQ(cases, 4000);
  EXPECT_GT(reflex, 4000);
  std::printf("%d polygons, %d reflex corners, %d triangles without area\n", cases, reflex, straight);
}

using ExactNormal = std::array<cpp_rational, 3>;

/// Twice the area of a triangle in space, as a vector across it.
ExactNormal doubled_normal(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  ExactNormal normal;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    normal[static_cast<std::size_t>(axis)] = doubled_area({a[u], a[v]}, {b[u], b[v]}, {c[u], c[v]});
  }
  return normal;
}
cpp_rational dot(const ExactNormal& a, const ExactNormal& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TEST(EarClippingProperty, FacesOnAnyPlaneAreCoveredOnce) {
  // Combs and stars on whole numbers, on planes of whole numbers: exactly flat at every scale
  Random random(test::seed() + 1);
  const auto whole = [&random](std::int64_t size) {
    return static_cast<double>(random.uniform_int(-size, size));
  };
  const auto vector = [&] {
    const double x = whole(9), y = whole(9), z = whole(9);
    return glm::dvec3(x, y, z);
  };
  int cases = 0, axes[3] = {0, 0, 0}, turned = 0, subnormal = 0;
  for (int round = 0; round < 3000; ++round) {
    const glm::dvec3 origin = vector(), u = vector(), v = vector();
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform_int(-1073, 1000)));
    std::vector<glm::dvec3> face;
    for (const glm::dvec2 p : round % 2 ? any_comb(random) : any_star(random)) {
      const double size = round % 2 ? 2 : 1 << 20;
      const glm::dvec2 place{std::round(size * p.x), std::round(size * p.y)};
      face.push_back(scale * (origin + place.x * u + place.y * v));
    }
    ExactNormal normal{};
    for (std::size_t i = 2; i < face.size(); ++i) {
      const auto part = doubled_normal(face[0], face[i - 1], face[i]);
      for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] += part[axis];
    }
    if (dot(normal, normal) == 0) continue;
    ExactNormal sum{};
    std::size_t count = 0;
    triangulate(face, [&](const Triangle& t) {
      const auto at = [&](int i) { return face[static_cast<std::size_t>(i)]; };
      const auto part = doubled_normal(at(t[0]), at(t[1]), at(t[2]));
      ASSERT_GE(dot(part, normal), 0) << "round " << round << ", seed " << test::seed();
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
      ++count;
    });
    ASSERT_EQ(count, face.size() - 2);
    ASSERT_EQ(sum, normal) << "round " << round << ", seed " << test::seed();
    const Shadow shadow = largest_shadow(face);
    ASSERT_EQ(shadow.turn, normal[static_cast<std::size_t>(shadow.axis)].sign());
    ++axes[shadow.axis];
    turned += shadow.turn < 0;
    subnormal += scale < 0x1p-1000;
    ++cases;
  }
  std::printf("%d faces, shadows along x %d, y %d, z %d; %d turned, %d tiny\n", cases, axes[0], axes[1],
              axes[2], turned, subnormal);
  EXPECT_GE(cases, 1500);
  for (const int along : axes) EXPECT_GE(along, 200);
  EXPECT_GE(turned, 200);
  EXPECT_GE(subnormal, 50);
}

}  // namespace
}  // namespace gradus::ear_clipping
