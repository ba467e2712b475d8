// Faces of any size, closedness, made normals.

#include "core/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "support/hard_inputs.hpp"

namespace gradus {
namespace {

Mesh cube(double size = 1, bool outward = true) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(size * dvec3{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  for (std::vector<int> face :
       {std::vector{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}) {
    if (!outward) std::ranges::reverse(face);
    std::vector<Corner> corners;
    for (const int v : face) corners.push_back({v});
    add_face(mesh, corners);
  }
  return mesh;
}

TEST(Mesh, FacesKeepTheirCornersAndPlaces) {
  Mesh mesh = cube();
  EXPECT_EQ(triangle_count(mesh), 12);
  const std::vector<Corner> pentagon{{0}, {1}, {3}, {7}, {4}};
  EXPECT_EQ(add_face(mesh, pentagon, 0, 2, 77), 6);
  EXPECT_EQ(mesh.faces[6].line, 77);
  EXPECT_EQ(mesh.faces[6].file, 2);
  EXPECT_EQ(corners_of(mesh, mesh.faces[6])[4], Corner{4});
  EXPECT_EQ(triangle_count(mesh), 15);
  EXPECT_THROW(add_face(mesh, std::span(pentagon).first(2)), ContractViolation);
}

TEST(Mesh, BoundsAreThoseOfTheFaces) {
  Mesh mesh = cube(2);
  mesh.positions.push_back({100, 0, 0});  // no face uses it
  EXPECT_EQ(bounds_of(mesh).lower, dvec3{-2});
  EXPECT_EQ(bounds_of(mesh).upper, dvec3{2});
  EXPECT_DOUBLE_EQ(bounds_of(mesh).radius(), 2 * std::sqrt(3.0));
  EXPECT_TRUE(bounds_of(Mesh{}).empty());
}

TEST(Mesh, AreaVectorsOfConcaveFaces) {
  // G001-75: the first three corners of this L turn the wrong way
  Mesh mesh;
  mesh.positions = {{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  add_face(mesh, std::vector<Corner>{{0}, {1}, {2}, {3}, {4}, {5}});
  EXPECT_EQ(area_vector(mesh, mesh.faces[0]), (dvec3{0, 0, 6}));
}

TEST(Mesh, AFaceInTheOtherOrderHasTheOppositeNormal) {
  Mesh mesh;
  mesh.positions = {{2, 1, 0}, {1, 1, 3}, {1, 2, 0}, {0, 2, -1}};
  add_face(mesh, std::vector<Corner>{{0}, {1}, {2}, {3}});
  add_face(mesh, std::vector<Corner>{{3}, {2}, {1}, {0}});
  EXPECT_NE(area_vector(mesh, mesh.faces[0]), dvec3{0});
  EXPECT_EQ(area_vector(mesh, mesh.faces[0]), -area_vector(mesh, mesh.faces[1]));
}

TEST(Mesh, ClosedOutward) {
  EXPECT_TRUE(closed_outward(cube()));
  EXPECT_FALSE(closed_outward(cube(1, false)));  // inside out
  Mesh open = cube();
  open.faces.pop_back();
  EXPECT_FALSE(closed_outward(open));
  Mesh turned = cube();  // one face the other way round
  std::swap(turned.corners[1], turned.corners[3]);
  EXPECT_FALSE(closed_outward(turned));
  Mesh twice = cube();
  add_face(twice, std::vector<Corner>{{1}, {3}, {7}, {5}});
  EXPECT_FALSE(closed_outward(twice));
  EXPECT_FALSE(closed_outward(Mesh{}));
}

TEST(Mesh, SizeMakesNoDifferenceToWhatIsClosed) {
  for (const double size : {1e-300, 1e-200, 1e-110, 1e110, 1e200}) {
    EXPECT_TRUE(closed_outward(cube(size))) << size;
    EXPECT_FALSE(closed_outward(cube(size, false))) << size;
  }
}

TEST(Mesh, UnitScaleIsThePowerOfTwoThatMakesARadiusOne) {
  for (const double size : {1e-300, 1e-20, 1.0, 1e20, 1e290}) {
    const Bounds bounds = bounds_of(cube(size));
    const double scale = unit_scale(bounds);
    EXPECT_EQ(std::scalbn(1.0, std::ilogb(scale)), scale);
    EXPECT_GE(bounds.radius() * scale, 1) << size;
    EXPECT_LT(bounds.radius() * scale, 2) << size;
  }
  EXPECT_EQ(unit_scale(Bounds{}), 1);
  EXPECT_EQ(unit_scale(bounds_of(cube(0))), 1);
  const Mesh small = cube(1e-300);
  EXPECT_NEAR(unit_vector(area_vector(small, small.faces[0], unit_scale(bounds_of(small)))).x, 1, 1e-15);
}

TEST(Mesh, MadeNormalsAreAreaWeighted) {
  // A corner of the cube lies on three faces of one size: its normal is the diagonal, whatever their corners
  // (G001-88)
  for (const double size : {1.0, 1e-200, 1e100}) {
    Mesh mesh = cube(size);
    add_missing_normals(mesh);
    ASSERT_EQ(mesh.normals.size(), 8u) << size;
    for (const Corner& corner : mesh.corners) {
      const dvec3 normal = mesh.normals[static_cast<std::size_t>(corner.normal)];
      EXPECT_NEAR(glm::distance(normal, unit_vector(position_of(mesh, corner))), 0, 1e-15);
    }
  }
  // Two faces at right angles, one three times as large
  Mesh roof;
  roof.positions = {{0, 0, 0}, {0, 0, 1}, {3, 0, 0}, {0, 1, 0}};
  add_face(roof, std::vector<Corner>{{0}, {1}, {2}});  // normal +y, doubled area 3
  add_face(roof, std::vector<Corner>{{0}, {3}, {1}});  // normal +x, doubled area 1
  add_missing_normals(roof);
  const dvec3 shared = roof.normals[static_cast<std::size_t>(roof.corners[0].normal)];
  EXPECT_NEAR(glm::distance(shared, unit_vector(dvec3{1, 3, 0})), 0, 1e-15);
}

TEST(Mesh, SmoothingGroupsAndGivenNormals) {
  Mesh mesh = cube();
  const std::vector<int> groups{1, 2, 0, 0, 1, 0};  // faces 0 (+x) and 4 (+z) are smooth together
  add_missing_normals(mesh, groups);
  const auto normal = [&](int face, int corner) {
    const Corner& c =
        corners_of(mesh, mesh.faces[static_cast<std::size_t>(face)])[static_cast<std::size_t>(corner)];
    return mesh.normals[static_cast<std::size_t>(c.normal)];
  };
  EXPECT_EQ(normal(2, 0), (dvec3{0, 1, 0}));
  EXPECT_EQ(normal(1, 0), (dvec3{-1, 0, 0}));
  EXPECT_EQ(normal(0, 0), (dvec3{1, 0, 0}));  // corner 1 is not on face 4
  EXPECT_NEAR(glm::distance(normal(0, 2), unit_vector(dvec3{1, 0, 1})), 0, 1e-15);
  EXPECT_THROW(add_missing_normals(mesh, std::span(groups).first(2)), ContractViolation);

  Mesh given = cube();
  given.normals = {{0, 0, 1}, {0, 0, 0}};
  given.corners[0].normal = 0;
  given.corners[1].normal = 1;  // zero: none
  add_missing_normals(given);
  EXPECT_EQ(given.corners[0].normal, 0);
  EXPECT_GT(given.corners[1].normal, 1);
  // A face without area has no normal to give
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  add_face(flat, std::vector<Corner>{{0}, {1}, {2}});
  add_missing_normals(flat);
  EXPECT_EQ(flat.normals[0], dvec3{0});
}

TEST(Mesh, AreasAreWithinTheirBound) {
  using namespace test;
  for (const int corners : {3, 4, 12, 60}) {
    // Here or far out, flat or not
    const auto draw = [corners](Random& random) {
      Numbers n(static_cast<std::size_t>(3 * corners));
      const double away = random.unit() < 0.5 ? 0 : number(random, 10);
      for (double& x : n) x = away + random.uniform(-1, 1);
      if (random.unit() < 0.5)
        for (std::size_t i = 0; i < n.size(); i += 3) n[i + 2] = n[i] / 2 + n[i + 1];
      return n;
    };
    const auto judge = [corners](const Numbers& n) {
      Mesh mesh;
      std::vector<Corner> ring;
      for (std::size_t i = 0; i < n.size(); i += 3) {
        ring.push_back({static_cast<int>(mesh.positions.size())});
        mesh.positions.push_back(three(n, i));
      }
      add_face(mesh, ring);
      const Bounds box = bounds_of(mesh);
      const double scale = unit_scale(box), m = corners - 2;
      const dvec3 found = area_vector(mesh, mesh.faces[0], scale), sides = scale * (box.upper - box.lower);
      const double side = std::max({sides.x, sides.y, sides.z});
      double most = 0;
      for (int i = 0; i < 3; ++i) {
        // By the trapezoids under the edges
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        Fraction right;
        for (std::size_t c = 0; c < mesh.positions.size(); ++c) {
          const dvec3 a = mesh.positions[c], b = mesh.positions[(c + 1) % mesh.positions.size()];
          right += (Fraction(a[k]) + Fraction(b[k])) * (Fraction(a[j]) - Fraction(b[j]));
        }
        most = std::max(most,
                        off(found[i], right * Fraction(scale * scale), m * (m + 9) * 0x1p-53 * side * side));
      }
      return most;
    };
    EXPECT_LE(worst(9000 / corners, draw, judge), 1) << corners << " corners";
  }
}

}  // namespace
}  // namespace gradus
