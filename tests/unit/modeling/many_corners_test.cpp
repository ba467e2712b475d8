// Ear clipping of very many corners: the triangles of the plain walk, in its order, and in time.

#include "modeling/ear_clipping/many_corners.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::ear_clipping {
namespace {

using Polygon = std::vector<dvec2>;

std::vector<Triangle> plainly(const Polygon& polygon) {
  std::vector<Triangle> found;
  triangulate(std::span<const dvec2>(polygon), [&](const Triangle& t) { found.push_back(t); });
  return found;
}
std::vector<Triangle> by_tree(const Polygon& polygon) {
  std::vector<Triangle> found;
  triangulate_many(std::span<const dvec2>(polygon), [&](const Triangle& t) { found.push_back(t); });
  return found;
}

/// Corners round a middle, as far away as the function says.
template <class Distance>
Polygon round_a_middle(int corners, Distance distance) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const SinCos at = sin_cos(0x1.921fb54442d18p2 * i / corners);
    polygon.push_back(distance(i) * dvec2(at.cos, at.sin));
  }
  return polygon;
}

/// Deep notches beside each other.
Polygon comb(int teeth) {
  Polygon polygon{{0, 0}, {2.0 * teeth, 0}};
  for (int i = teeth; i > 0; --i) {
    polygon.emplace_back(2 * i, 100);
    polygon.emplace_back(2 * i - 1, 1);
  }
  return polygon;
}

TEST(ManyCorners, SimplePolygonsAsTheWalkFindsThem) {
  Random random(test::seed());
  for (int corners = 3; corners < 300; corners += corners < 40 ? 1 : 37) {
    SCOPED_TRACE(corners);
    const Polygon star = round_a_middle(corners, [&](int) { return random.uniform(0.1, 8); });
    EXPECT_EQ(by_tree(star), plainly(star));
    const Polygon convex = round_a_middle(corners, [](int) { return 8.0; });
    EXPECT_EQ(by_tree(convex), plainly(convex));
    EXPECT_EQ(by_tree(comb(corners)), plainly(comb(corners)));
  }
}

TEST(ManyCorners, AnyPolygonsAsTheWalkFindsThem) {
  Random random(test::seed());
  for (int i = 0; i < 200; ++i) {
    // On a small grid: corners at the same place, straight ones, edges that cross and turn back
    const auto side = random.uniform_int(1, 30), corners = random.uniform_int(3, 90);
    Polygon polygon;
    for (int k = 0; k < corners; ++k)
      polygon.emplace_back(double(random.uniform_int(0, side)), double(random.uniform_int(0, side)));
    EXPECT_EQ(by_tree(polygon), plainly(polygon)) << "polygon " << i;
  }
  const double far = std::numeric_limits<double>::max();
  for (const Polygon& polygon :
       {Polygon(20, dvec2{1, 2}), Polygon{{-far, -far}, {far, -far}, {far, far}, {0, 1e-300}, {-far, far}},
        round_a_middle(60, [far](int k) { return k % 2 ? far / 2 : 5e-324; })})
    EXPECT_EQ(by_tree(polygon), plainly(polygon));
}

TEST(ManyCorners, InSpaceFromAnySide) {
  Random random(test::seed());
  const Polygon star = round_a_middle(150, [&](int) { return random.uniform(1, 8); });
  for (const bool back : {false, true}) {
    std::vector<dvec3> face;
    for (const dvec2 p : star) face.emplace_back(p.y, 3, back ? -p.x : p.x);
    std::vector<Triangle> walked, found;
    triangulate(std::span<const dvec3>(face), [&](const Triangle& t) { walked.push_back(t); });
    triangulate_many(std::span<const dvec3>(face), [&](const Triangle& t) { found.push_back(t); });
    EXPECT_EQ(found, walked);
  }
}

TEST(ManyCorners, AHundredThousandFillThePolygon) {
  Random random(test::seed());
  const int corners = test::sanitized ? 10'000 : 100'000;
  const Polygon convex = round_a_middle(corners, [](int) { return 8.0; }),
                star = round_a_middle(corners, [&](int) { return random.uniform(6, 8); });
  for (const Polygon& polygon : {convex, star}) {
    const auto place = [&](int i) { return polygon[static_cast<std::size_t>(i)]; };
    const auto doubled_area = [](dvec2 a, dvec2 b, dvec2 c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    double whole = 0, filled = 0;
    for (int i = 0; i < corners; ++i) whole += doubled_area(dvec2{0}, place(i), place((i + 1) % corners));
    const auto triangles = by_tree(polygon);
    EXPECT_EQ(triangles.size(), static_cast<std::size_t>(corners - 2));
    for (const Triangle& t : triangles) filled += doubled_area(place(t[0]), place(t[1]), place(t[2]));
    EXPECT_NEAR(filled, whole, 1e-9 * whole);
  }
}

}  // namespace
}  // namespace gradus::ear_clipping
