// Known results, counts, what is sharp, limits, the step grammar, refusals.

#include "modeling/subdivision_surface/subdivision_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/record.hpp"
#include "modeling/subdivision_surface/subdivision_surface_batch.hpp"
#include "modeling/subdivision_surface/subdivision_surface_notes.hpp"
#include "unit/modeling/subdivision_surface/shapes.hpp"

namespace gradus::subdivision_surface {
namespace {

using Mesh = Surface<double>;

TEST(SubdivisionSurface, CubesFirstLevelIsTheKnownOne) {  // G001-20
  const Mesh next = catmull_clark(cube(), 1);
  ASSERT_EQ(next.points.size(), 26u);
  EXPECT_EQ(next.faces.size(), 24u);
  EXPECT_NEAR(next.points[7].x, 5.0 / 9, 1e-15);
  EXPECT_EQ(next.points[25], (Point<double>{1, 0, 0}));
  EXPECT_NE(std::ranges::find(next.points, Point<double>{0.75, 0.75, 0}), next.points.end());
  EXPECT_EQ(Links(next).edges().size(), 48u);
}

TEST(SubdivisionSurface, CubesCornerEndsAtOneHalf) {  // G001-20
  const ExactScope scope;
  const Limit<Exact> corner = limit(in<Exact>(cube()), 7);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(corner.point[k], Exact(0.5));
  const auto found = limit(cube(), 7);
  EXPECT_NEAR(found.point.x, 0.5, 1e-15);
  EXPECT_NEAR(found.normal.x / found.normal.z, 1, 1e-14);
  EXPECT_GT(found.normal.x, 0);
}

TEST(SubdivisionSurface, FacesOfNCornersBecomeN) {  // G001-21
  const Mesh next = catmull_clark(pencil(), 1);
  EXPECT_EQ(next.faces.size(), 5u * 3 + 5u * 4 + 5u);
  for (std::size_t f = 0; f < next.faces.size(); ++f) EXPECT_EQ(next.faces[f].size(), 4u);
  EXPECT_EQ(catmull_clark(pencil(), 3).faces.size(), 40u * 16);
  const Mesh wrong = always_four(pencil());
  EXPECT_EQ(wrong.faces.size(), 44u);
  EXPECT_FALSE(keeps_contracts([&] { const Links links(wrong); }));
  EXPECT_EQ(always_four(cube()), catmull_clark(cube(), 1));
}

TEST(SubdivisionSurface, TrianglesBecomeFour) {
  const Mesh next = loop(tetrahedron(), 2);
  EXPECT_EQ(next.faces.size(), 64u);
  // Euler: V = 2 + F / 2
  EXPECT_EQ(next.points.size(), 34u);
}

TEST(SubdivisionSurface, BordersAndCreasesAreCubicSplines) {
  // The border of one square is smoothed as a curve: 1/8, 3/4, 1/8
  const Mesh square{{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, faces_of({{0, 1, 2, 3}})};
  const Mesh next = catmull_clark(square, 1);
  EXPECT_EQ(next.points[0], (Point<double>{1, 1, 0}));
  EXPECT_EQ(next.points[4], (Point<double>{4, 0, 0}));
  // With its four corners sharp it stays a square
  Mesh kept = square;
  for (std::int32_t v = 0; v < 4; ++v) kept.corners.push_back({v});
  EXPECT_EQ(catmull_clark(kept, 3).points[2], (Point<double>{8, 8, 0}));
  // So is the ring of creases round a cube's top, as a polygon of its own
  Mesh cut = cube();
  cut.creases = {{4, 5}, {5, 7}, {7, 6}, {6, 4}};
  EXPECT_EQ(catmull_clark(cut, 1).points[7], (Point<double>{0.75, 0.75, 1}));
  EXPECT_EQ(limit(cut, 7).point.z, 1);
  EXPECT_EQ(limit(cut, 7).normal, (Point<double>{0, 0, 0}));
}

TEST(SubdivisionSurface, SharpnessIsUsedUpByLevels) {
  Mesh cut = cube();
  for (const double sharpness : {2.0, 1.0, 0.25, 0.0}) {
    cut.creases = {{4, 5, sharpness}, {5, 7, sharpness}, {7, 6, sharpness}, {6, 4, sharpness}};
    const Mesh next = catmull_clark(cut, 1);
    EXPECT_EQ(next.creases.size(), sharpness > 1 ? 8u : 0u);
    const double part = std::min(sharpness, 1.0);
    EXPECT_NEAR(next.points[7].z, part * 1 + (1 - part) * 5.0 / 9, 1e-15) << sharpness;
  }
}

TEST(SubdivisionSurface, LevelsTendToTheLimit) {
  for (const Mesh& mesh : {cube(), pencil(), open_cube(), arch_of_quads()}) {
    const Mesh last = catmull_clark(mesh, 5);
    for (std::int32_t v = 0; v < std::ssize(mesh.points); ++v) {
      const Point<double> off = limit(mesh, v).point - last.points[static_cast<std::size_t>(v)];
      EXPECT_LT(length_of(off), 4e-3) << v;
    }
  }
}

TEST(SubdivisionSurface, NormalsAreThoseOfFineLevels) {
  for (const Mesh& mesh : {cube(), pencil(), open_cube()}) {
    const Mesh last = catmull_clark(mesh, 5);
    const Links links(last);
    for (std::int32_t v = 0; v < std::ssize(mesh.points); ++v) {
      Point<double> sum{0};
      for (const auto f : links.star(v).faces) {
        const auto ring = links.ring(f);
        const auto& p = last.points;
        const auto at = [&](std::size_t i) { return p[static_cast<std::size_t>(ring[i])]; };
        sum += glm::cross(at(2) - at(0), at(3) - at(1));
      }
      const Point<double> normal = limit(mesh, v).normal;
      EXPECT_GT(glm::dot(sum, normal) / (length_of(sum) * length_of(normal)), 0.99) << v;
    }
  }
}

TEST(SubdivisionSurface, TheBatchHasTheSameFaces) {
  constexpr double bound = 1e-14;
  for (const Mesh& mesh : {cube(), pencil(), open_cube(), arch_of_quads()}) {
    for (int levels = 0; levels <= 5; ++levels) {
      const Mesh right = catmull_clark(mesh, levels), fast = catmull_clark_batch(mesh, levels);
      ASSERT_EQ(fast.points.size(), right.points.size());
      ASSERT_EQ(fast.faces.first, right.faces.first);
      double worst = 0;
      for (std::size_t c = 0; c < right.faces.corners.size(); ++c) {
        const auto corner = [&](const Mesh& m) {
          return m.points[static_cast<std::size_t>(m.faces.corners[c])];
        };
        worst = std::max(worst, length_of(corner(right) - corner(fast)));
      }
      EXPECT_LE(worst, 4 * bound) << levels;  // the largest coordinate is 4
    }
  }
  Mesh sharp = cube();
  sharp.creases = {{0, 1, 2}};
  EXPECT_EQ(catmull_clark_batch(sharp, 3), catmull_clark(sharp, 3));
}

TEST(SubdivisionSurface, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<FacePointFound<double>, EdgePointFound<double>, VertexPointFound<double>, LevelDone> seen;
  EXPECT_EQ(catmull_clark(cube(), 2, seen), catmull_clark(cube(), 2));
  EXPECT_EQ(all<FacePointFound<double>>(seen).size(), 6u + 24u);
  EXPECT_EQ(all<EdgePointFound<double>>(seen).size(), 12u + 48u);
  EXPECT_EQ(all<VertexPointFound<double>>(seen).size(), 8u + 26u);
  EXPECT_EQ(std::get<LevelDone>(seen.events().back().step).faces, 96);
  Recorder<EdgePointFound<double>, VertexPointFound<double>, LevelDone> thirds;
  EXPECT_EQ(loop(tetrahedron(), 1, thirds), loop(tetrahedron(), 1));
  EXPECT_EQ(all<EdgePointFound<double>>(thirds).size(), 6u);
  Recorder<LimitFound<double>, NormalFound<double>> ends;
  EXPECT_EQ(limit(cube(), 0, ends).point, limit(cube(), 0).point);
  EXPECT_EQ(ends.events().size(), 2u);
}

TEST(SubdivisionSurface, MistakesAreNamed) {
  const auto refuses = [](Mesh mesh, int levels = 1) {
    return !keeps_contracts([&] { catmull_clark(std::move(mesh), levels); });
  };
  Mesh mesh = cube();
  EXPECT_FALSE(refuses(mesh));
  EXPECT_TRUE(refuses(mesh, -1));
  EXPECT_TRUE(refuses(mesh, 13));
  mesh.points[0].x = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(refuses(mesh));
  mesh = cube();
  mesh.points.push_back({0, 0, 0});  // of no face
  EXPECT_TRUE(refuses(mesh));
  mesh = cube();
  mesh.creases = {{0, 7, 1}};  // across the cube
  EXPECT_TRUE(refuses(mesh));
  mesh.creases = {{0, 1, -1}};
  EXPECT_TRUE(refuses(mesh));
  mesh = cube();
  mesh.faces.add(std::vector<std::int32_t>{0, 1, 7});  // a third face at an edge
  EXPECT_TRUE(refuses(mesh));
  // One face turned over; two tips that touch
  EXPECT_TRUE(refuses({cube().points, faces_of({{0, 2, 3, 1}, {0, 4, 5, 1}})}));
  EXPECT_TRUE(refuses({cube().points, faces_of({{0, 1, 2}, {0, 4, 5}})}));
  EXPECT_FALSE(keeps_contracts([] { loop(cube(), 1); }));
  EXPECT_FALSE(keeps_contracts([] { limit(cube(), 8); }));
  mesh = cube();
  mesh.corners = {{7, 2.5}};
  EXPECT_FALSE(keeps_contracts([&] { limit(mesh, 7); }));
}

}  // namespace
}  // namespace gradus::subdivision_surface
