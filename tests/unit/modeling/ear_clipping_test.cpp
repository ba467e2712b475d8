// Known polygons, the step grammar, refusals.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <utility>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"

namespace gradus::ear_clipping {
namespace {

using Polygon = std::vector<dvec2>;

std::vector<Triangle> triangles(const Polygon& polygon) {
  std::vector<Triangle> found;
  triangulate(std::span<const dvec2>(polygon), [&](const Triangle& t) { found.push_back(t); });
  return found;
}

TEST(EarClipping, ConvexPolygonsComeAsAFan) {
  const Polygon pentagon{{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}};
  EXPECT_EQ(triangles(pentagon), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(EarClipping, TheArrowheadIsNotAFan) {
  // A fan from corner 0 would cover what lies outside
  const Polygon arrow{{0, 0}, {4, 2}, {0, 4}, {1, 2}};
  for (const Triangle& t : triangles(arrow))
    EXPECT_NE(std::ranges::count(t, 3), 0) << "every triangle has the notch";
  EXPECT_EQ(triangles(arrow).size(), 2u);
}

TEST(EarClipping, StepsFollowTheGrammar) {
  const Polygon arrow{{0, 0}, {4, 2}, {0, 4}, {1, 2}};
  Recorder<Tested, Cut, Finished> seen;
  std::vector<Triangle> found;
  triangulate(std::span<const dvec2>(arrow), [&](const Triangle& t) { found.push_back(t); }, seen);
  EXPECT_EQ(found, triangles(arrow));  // observed == unobserved
  EXPECT_EQ(all<Cut>(seen).size(), 2u);
  EXPECT_TRUE(every<Cut>(seen, [](const Cut& cut) { return !cut.forced; }));
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).triangles, 2);
  const auto tests = all<Tested>(seen);
  EXPECT_EQ(tests[0].blocker, 3);  // the notch lies in the triangle of corner 1
  EXPECT_FALSE(tests[0].ear);
  EXPECT_EQ(all<Cut>(seen)[1].left, 2);
}

TEST(EarClipping, FacesInSpaceFromAnySide) {
  // G001-75: the first three corners turn the wrong way
  const std::vector<dvec3> l{{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  for (const int turn : {0, 1, 2}) {
    for (const bool back : {false, true}) {
      std::vector<dvec3> face;
      for (const dvec3 p : l)
        face.push_back(turn == 0 ? p : turn == 1 ? dvec3{p.z, p.x, p.y} : dvec3{p.y, p.z, p.x});
      if (back) std::ranges::reverse(face);
      dvec3 sum{0};
      const dvec3 normal = (back ? -1.0 : 1.0) * (turn == 0   ? dvec3{0, 0, 1}
                                                  : turn == 1 ? dvec3{1, 0, 0}
                                                              : dvec3{0, 1, 0});
      triangulate(std::span<const dvec3>(face), [&](const Triangle& t) {
        const auto at = [&](int i) { return face[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
        const dvec3 area = glm::cross(at(1) - at(0), at(2) - at(0));
        EXPECT_GE(glm::dot(area, normal), 0) << turn << back;
        sum += area;
      });
      EXPECT_EQ(sum, 6.0 * normal);
    }
  }
}

std::vector<Triangle> triangles_in_space(const std::vector<dvec3>& face) {
  std::vector<Triangle> found;
  triangulate(std::span<const dvec3>(face), [&](const Triangle& t) { found.push_back(t); });
  return found;
}

TEST(EarClipping, FacesInSpaceNeedFiniteCorners) {
  const std::vector<dvec3> face{{2, 1, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}, {-1, 2, 0}};
  EXPECT_EQ(triangles_in_space(face).size(), 4u);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (const int axis : {0, 1, 2}) {
        auto broken = face;
        broken[i][axis] = wrong;
        int emitted = 0;
        EXPECT_THROW(triangulate(std::span<const dvec3>(broken), [&](const Triangle&) { ++emitted; }),
                     ContractViolation);
        EXPECT_EQ(emitted, 0);
        if (axis == 2) continue;
        Polygon flat;
        for (const dvec3& p : broken) flat.emplace_back(p.x, p.y);
        EXPECT_THROW(triangulate(std::span<const dvec2>(flat), [&](const Triangle&) { ++emitted; }),
                     ContractViolation);
        EXPECT_EQ(emitted, 0);
      }
    }
  }
}

TEST(EarClipping, FacesInSpaceOfAnySizeAreCutAlike) {
  // Newell's normal underflows below 2^-537 and overflows above 2^511. The shadow along z has no area
  const std::vector<dvec3> l{{0, 2, 1}, {0, 1, 1}, {0, 1, 2}, {0, 0, 2}, {0, 0, 0}, {0, 2, 0}};
  const auto right = triangles_in_space(l);
  EXPECT_EQ(right, triangles({{2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}}));
  for (int exponent = -1074; exponent <= 1022; ++exponent) {
    auto scaled = l;
    for (dvec3& p : scaled) p *= std::ldexp(1.0, exponent);
    ASSERT_EQ(triangles_in_space(scaled), right) << "2^" << exponent;
  }
  // A long narrow one: its sides multiplied neither underflow nor overflow, but scaled as one they would
  auto narrow = l;
  for (dvec3& p : narrow) p = {0, p.y * 0x1p1000, p.z * 0x1p-1070};
  EXPECT_EQ(triangles_in_space(narrow), right);
}

TEST(EarClipping, TheLargestShadowCounts) {
  const auto shadow = [](const std::vector<dvec3>& face) {
    return largest_shadow(std::span<const dvec3>(face));
  };
  for (const double scale : {1.0, 0x1p-1070, 0x1p1020}) {
    // Areas 6 along x, 4 along y, 12 along z
    const std::vector<dvec3> slanted{{0, 0, 0}, {2 * scale, 0, scale}, {0, 3 * scale, 2 * scale}};
    const Shadow z = shadow(slanted);
    EXPECT_EQ(z.axis, 2) << scale;
    EXPECT_EQ(z.turn, 1) << scale;
    const Shadow back = shadow({slanted[2], slanted[1], slanted[0]});
    EXPECT_EQ(back.axis, 2) << scale;
    EXPECT_EQ(back.turn, -1) << scale;
    EXPECT_EQ(shadow({slanted[0], {scale, scale, scale}, {2 * scale, 2 * scale, 2 * scale}}).turn, 0);
  }
}

TEST(EarClipping, AlwaysAsManyTriangles) {
  EXPECT_EQ(triangles({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 2u);                  // on a line
  EXPECT_EQ(triangles({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).size(), 2u);                  // crosses itself
  EXPECT_EQ(triangles({{1, 1}, {1, 1}, {1, 1}}).size(), 1u);                          // a point
  EXPECT_EQ(triangles({{0, 0}, {0, 2}, {2, 2}, {2, 0}}).size(), 2u);                  // clockwise
  EXPECT_EQ(triangles({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}).size(), 4u);  // straight corners
}

TEST(EarClipping, MistakesAndScalars) {
  EXPECT_THROW(triangles({{0, 0}, {1, 0}}), ContractViolation);
  EXPECT_THROW(triangles({{0, 0}, {1, 0}, {0, std::numeric_limits<double>::infinity()}, {2, 2}}),
               ContractViolation);
  const ExactScope scope;
  const std::vector<ExactVec2> exact{
      {Exact(0), Exact(0)}, {Exact(4, 3), Exact(2, 3)}, {Exact(0), Exact(4, 3)}, {Exact(1, 3), Exact(2, 3)}};
  int count = 0;
  triangulate(std::span<const ExactVec2>(exact), [&](const Triangle&) { ++count; });
  const std::vector<glm::vec2> floats{{0, 0}, {4, 2}, {0, 4}, {1, 2}};
  triangulate(std::span<const glm::vec2>(floats), [&](const Triangle&) { ++count; });
  EXPECT_EQ(count, 4);
}

TEST(EarClipping, TheLargestShadowWhereProductsOverflow) {
  // 2^1056 along y, of which plain arithmetic made NaN, and took the 2^743 along z
  const std::vector<dvec3> face{{0, 0, -0x1p313}, {0x1p743, 0, 0}, {0, 0, 0},
                                {0, 1, 0},        {0x1p743, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(largest_shadow(face).axis, 1);
}

TEST(EarClipping, TakesCornersAsProgramsHaveThem) {
  const Polygon arrow{{0, 0}, {4, 2}, {0, 4}, {1, 2}};
  const auto right = triangles(arrow);
  std::vector<Triangle> found;
  const auto add = [&found](const Triangle& t) { found.push_back(t); };
  const auto taken = [&found, &right] { return std::exchange(found, {}) == right; };
  const std::array<dvec2, 4> array{arrow[0], arrow[1], arrow[2], arrow[3]};
  const dvec2 plain[]{{0, 0}, {4, 2}, {0, 4}, {1, 2}};
  Polygon changeable = arrow;
  triangulate(arrow, add);
  EXPECT_TRUE(taken());
  triangulate(array, add);
  EXPECT_TRUE(taken());
  triangulate(plain, add);
  EXPECT_TRUE(taken());
  triangulate(std::span(changeable), add);
  EXPECT_TRUE(taken());
  triangulate({{0, 0}, {4, 2}, {0, 4}, {1, 2}}, add);
  EXPECT_TRUE(taken());
  Recorder<Tested, Cut, Finished> seen;
  triangulate(arrow, add, seen);
  EXPECT_TRUE(taken());
  EXPECT_EQ(all<Cut>(seen).size(), 2u);
  // In space
  const std::vector<dvec3> face{{0, 0, 7}, {4, 2, 7}, {0, 4, 7}, {1, 2, 7}};
  triangulate(face, add);
  EXPECT_TRUE(taken());
  triangulate({{0, 0, 7}, {4, 2, 7}, {0, 4, 7}, {1, 2, 7}}, add);
  EXPECT_TRUE(taken());
  EXPECT_EQ(largest_shadow(face).axis, 2);
  EXPECT_EQ(flattened(face), arrow);
}

}  // namespace
}  // namespace gradus::ear_clipping
