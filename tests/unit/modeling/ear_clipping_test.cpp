// Known polygons, the step grammar, refusals.

#include "modeling/ear_clipping/ear_clipping.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/exact_scalar.hpp"
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

}  // namespace
}  // namespace gradus::ear_clipping
