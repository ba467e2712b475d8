// Hidden parts of lines: exact of a convex solid, and where rays say so.

#include "stories/wireframe.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gradus {
namespace {

Mesh mesh_of(std::vector<dvec3> positions, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  for (const auto& face : faces) {
    std::vector<Corner> corners;
    for (const int position : face) corners.push_back({position});
    add_face(mesh, corners);
  }
  return mesh;
}

/// Corner i lies at x, y, z = its bits 0, 1, 2.
Mesh cube() {
  std::vector<dvec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  return mesh_of(corners,
                 {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

TEST(Wireframe, EdgesOfACubeAreSeenOrHiddenAsAWhole) {
  const Mesh mesh = cube();
  const Wireframe wires(mesh);
  for (const SightFrom& sight : {parallel_sight({3, 2, 5}), central_sight({3, 2, 5})}) {
    int hidden = 0;
    for (const auto& [a, b] : wires.edges()) {
      const std::vector<SightPiece> pieces = wires.pieces(a, b, sight);
      ASSERT_EQ(pieces.size(), 1u);
      hidden += pieces[0].hidden;
      EXPECT_EQ(pieces[0].hidden, a == dvec3(0) || b == dvec3(0));
    }
    EXPECT_EQ(hidden, 3);
  }
}

TEST(Wireframe, APartBehindACubeEndsWhereItComesOut) {
  const Mesh mesh = cube();
  const auto pieces = Wireframe(mesh).pieces({-1, 0.5, -1}, {3, 0.5, -1}, parallel_sight({0, 0, 1}));
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_NEAR(pieces[1].from, 0.25, 1e-8);
  EXPECT_NEAR(pieces[1].to, 0.5, 1e-8);
  EXPECT_TRUE(pieces[1].hidden);
  // However short it is: of 64 samples none would lie in it
  const auto brief = Wireframe(mesh).pieces({-100, 0.5, -1}, {1100, 0.5, -1}, parallel_sight({0, 0, 1}));
  ASSERT_EQ(brief.size(), 3u);
  EXPECT_NEAR(1200 * (brief[1].to - brief[1].from), 1, 1e-6);
}

TEST(Wireframe, ConvexSolidsHideWhatRaysSayTheyHide) {
  const Mesh tetrahedron =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> near(-2, 3), share(0.001, 0.999);
  const auto point = [&] { return dvec3{near(random), near(random), near(random)}; };
  int asked = 0, hidden = 0, cut = 0;
  for (const Mesh& mesh : {cube(), tetrahedron}) {
    const Wireframe wires(mesh);
    for (int i = 0; i < 2000; ++i) {
      const dvec3 a = point(), b = point(), viewer = 4.0 * glm::normalize(point());
      const SightFrom sight = i % 2 == 0 ? parallel_sight(viewer) : central_sight(viewer);
      const auto pieces = wires.pieces(a, b, sight);
      cut += pieces.size() > 1;
      EXPECT_EQ(pieces.front().from, 0);
      EXPECT_EQ(pieces.back().to, 1);
      for (const SightPiece& piece : pieces) {
        if (piece.to - piece.from < 1e-3) continue;
        const double t = piece.from + share(random) * (piece.to - piece.from);
        const dvec3 p = a + t * (b - a);
        EXPECT_EQ(wires.hides(p, sight(p)), piece.hidden) << i << " " << t;
        ++asked;
        hidden += piece.hidden;
      }
    }
  }
  EXPECT_GT(asked, 4000);
  EXPECT_GT(hidden, 500);
  EXPECT_GT(cut, 500);
}

TEST(Wireframe, OtherMeshesAreSampled) {
  // Through the open top of a cube one sees down to where its wall begins to hide
  const Mesh open =
      mesh_of(cube().positions, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  const auto pieces = Wireframe(open).pieces({0.5, 0.9, 0.5}, {0.5, 0.1, 0.5}, parallel_sight({0, 1, 1}));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_FALSE(pieces[0].hidden);
  EXPECT_TRUE(pieces[1].hidden);
  EXPECT_NEAR(pieces[0].to, 0.5, 1e-5);
}

}  // namespace
}  // namespace gradus
