// Which of several surfaces in one plane is seen: that of the lowest (object, face).

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "stages/arrangement.hpp"

namespace gradus::pipeline {
namespace {

/// A triangle in the world plane z = 0, round its corners from `first` on, maybe the other way round.
Triangle triangle_of(int face, std::size_t first, bool turned) {
  constexpr std::array<dvec3, 3> corners{dvec3{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  Triangle triangle{{0, face, 0}, {}, turned};
  for (std::size_t i = 0; i < 3; ++i)
    triangle.corners[turned ? 2 - i : i].world.at = corners[(first + i) % 3];
  return triangle;
}

TEST(Coplanar, ATreeDrawsTheLowestFaceOfAPlaneLast) {
  Triangles triangles;
  for (int face = 0; face < 12; ++face)
    triangles.push_back(triangle_of(face, static_cast<std::size_t>(face), face % 2 == 1));
  SceneCamera camera;
  for (const double side : {-5.0, 5.0}) {
    camera.frame.eye = {1, 1, side};
    const Triangles ordered = in_tree_order(camera, triangles);
    ASSERT_EQ(ordered.size(), 12U);
    for (int place = 0; place < 12; ++place)
      EXPECT_EQ(ordered[static_cast<std::size_t>(place)].id.face, 11 - place) << "eye at z = " << side;
  }
}

}  // namespace
}  // namespace gradus::pipeline
