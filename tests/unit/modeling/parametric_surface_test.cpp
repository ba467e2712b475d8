// Known results, poles and seam, the mesh as another structure counts it, what the exhibits lack, refusals.

#include "modeling/parametric_surface/parametric_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/record.hpp"
#include "modeling/mesh_structures/counts.hpp"
#include "modeling/mesh_structures/mesh_structures.hpp"
#include "modeling/parametric_surface/parametric_surface_notes.hpp"
#include "support/documented.hpp"

namespace gradus::parametric_surface {
namespace {

constexpr auto page = "docs/topics/modeling/parametric_surface.md";

SurfacePoint<double> at(double r, double s, double t) { return point(r, angle(s), angle(t)); }

TEST(ParametricSurface, PointIsTheKnownOne) {  // G001-23
  const SurfacePoint<double> found = at(2, 60, 30);
  const dvec3 right{0.8660254037844386, 1.5, 1};
  EXPECT_LE(length_of(found.point - right), 1e-12);
  EXPECT_LE(length_of(found.normal - 0.5 * right), 1e-12);
  EXPECT_LE(length_of(found.by_s - dvec3{-1.5, 0.8660254037844386, 0}), 1e-12);
  EXPECT_LE(length_of(found.by_t - dvec3{-0.5, -0.8660254037844386, 1.7320508075688772}), 1e-12);
  const SurfacePoint<float> in_float = point(2.0F, angle(60.0F), angle(30.0F));
  EXPECT_LE(length_of(dvec3(in_float.point) - right), 1e-6);
}

TEST(ParametricSurface, TangentsAreTheDifferencesOfNearPoints) {
  const long double degree = 3.14159265358979323846L / 180, r = 2, h = 1e-6L;
  const auto exactly = [&](long double s, long double t) {
    return glm::vec<3, long double>{r * std::cos(t) * std::cos(s), r * std::cos(t) * std::sin(s),
                                    r * std::sin(t)};
  };
  for (const double s : {-200.0, 0.0, 13.0, 359.9}) {
    for (const double t : {-90.0, -45.0, 0.0, 77.0}) {
      const long double a = s * degree, b = t * degree;
      const SurfacePoint<double> found = at(2, s, t);
      EXPECT_LE(length_of(found.by_s - dvec3((exactly(a + h, b) - exactly(a - h, b)) / (2 * h))), 1e-11);
      EXPECT_LE(length_of(found.by_t - dvec3((exactly(a, b + h) - exactly(a, b - h)) / (2 * h))), 1e-11);
    }
  }
}

TEST(ParametricSurface, APoleIsOnePointWithoutATangentAlongS) {
  for (const double t : {-90.0, 90.0}) {
    const dvec3 pole{0, 0, t < 0 ? -3 : 3};
    for (const double s : {-1e6, 0.0, 60.0, 359.99, 1e300}) {
      const SurfacePoint<double> found = at(3, s, t);
      EXPECT_EQ(found.point, pole);
      EXPECT_EQ(found.normal, pole / 3.0);
      EXPECT_EQ(found.by_s, dvec3{0});
      EXPECT_DOUBLE_EQ(length_of(found.by_t), 3);
    }
  }
}

TEST(ParametricSurface, TheSeamHasOnePointForBothAngles) {
  for (const double t : {-90.0, -12.5, 0.0, 60.0}) EXPECT_EQ(at(2, 0, t), at(2, 360, t));
  EXPECT_EQ(at(2, -90, 10), at(2, 270, 10));
  const double below = std::nextafter(360.0, 0.0);
  EXPECT_LE(length_of(at(2, below, 0).point - at(2, 0, 0).point), 1e-14);
  EXPECT_LT(at(2, below, 0).point.y, 0);
}

TEST(ParametricSurface, PatchesAreAClosedSurface) {
  for (const int n : {3, 4, 12}) {
    for (const int m : {2, 3, 6}) {
      const Patches<double> mesh = patches(2.0, n, m);
      const mesh_structures::Counts counts = mesh_structures::counts_of(mesh.faces, mesh.points.size());
      EXPECT_EQ(counts.vertices, 2 + n * (m - 1));
      EXPECT_EQ(counts.faces, n * m);
      EXPECT_EQ(counts.euler(), 2);
      EXPECT_EQ(counts.boundary_edges + counts.crowded_edges + counts.pinched + counts.isolated, 0);
      EXPECT_TRUE(mesh_structures::half_edges(mesh.faces, mesh.points.size())) << "turned alike";
    }
  }
}

TEST(ParametricSurface, FacesLookOutwardAndAreAsFarOffAsTheyMayBe) {
  for (const int m : {2, 3, 5}) {
    const Patches<double> mesh = patches(1.0, 7, m);
    double nearest = 1;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      std::vector<dvec3> ring;
      for (const auto p : mesh.faces[f]) ring.push_back(mesh.points[static_cast<std::size_t>(p)]);
      const dvec3 normal = glm::normalize(glm::cross(ring[1] - ring[0], ring.back() - ring[0]));
      for (const dvec3 p : ring) EXPECT_NEAR(glm::dot(normal, p - ring[0]), 0, 1e-15) << "not flat";
      nearest = std::min(nearest, glm::dot(normal, ring[0]));
    }
    EXPECT_GT(nearest, 0);
    const double bound = off_sphere(1, 7, m);
    EXPECT_LE(1 - nearest, bound + 1e-15);
    if (m % 2 == 1) {
      EXPECT_NEAR(1 - nearest, bound, 1e-15);
    }
  }
}

TEST(ParametricSurface, TheNormalJumpsFromFaceToFaceAndNotOnTheSurface) {
  const Patches<double> mesh = patches(2.0, 8, 4);
  const auto between = [](dvec3 a, dvec3 b) {
    return std::atan2(length_of(glm::cross(a, b)), glm::dot(a, b)) * 180 / 3.141592653589793;
  };
  const double before = 44.999,
               jump = between(lookup(mesh, before, 20.0).normal, lookup(mesh, 45.0, 20.0).normal);
  EXPECT_LE(between(at(2, before, 20).normal, at(2, 45, 20).normal), 0.002);
  double off = 0, turned = 0;
  for (double s = 0; s < 360; s += 0.5) {
    for (double t = -90; t <= 90; t += 0.5) {
      const LookedUp<double> found = lookup(mesh, s, t);
      off = std::max(off, length_of(found.point - at(2, s, t).point));
      turned = std::max(turned, between(found.normal, at(2, s, t).normal));
    }
  }
  EXPECT_TRUE(test::states(page, "jumps by {} degrees from face to face at t = 20", {jump}));
  EXPECT_TRUE(test::states(
      page, "The points of 8 × 4 patches are off by {} at most, their normals by {} degrees", {off, turned}));
  EXPECT_TRUE(test::states(page, "faces are {} from the sphere of radius 2", {off_sphere(2, 8, 4)}));
}

TEST(ParametricSurface, LookingUpTakesAnyAngle) {
  const Patches<double> mesh = patches(2.0, 12, 6);
  EXPECT_EQ(lookup(mesh, 400.0, 30.0), lookup(mesh, 40.0, 30.0));
  for (const double s : {-1e-20, 360.0, std::nextafter(360.0, 0.0)})
    EXPECT_LE(length_of(lookup(mesh, s, 0.0).point - dvec3{2, 0, 0}), 1e-14) << s;
  EXPECT_EQ(lookup(mesh, 17.0, 90.0).point, (dvec3{0, 0, 2}));
  EXPECT_EQ(lookup(mesh, 17.0, -90.0).point, (dvec3{0, 0, -2}));
}

TEST(ParametricSurface, ExhibitsHaveNoNormalAtThePolesAndAnOpenSeam) {  // E001-11
  const auto by_tangents = [](double r, double s, double t) {
    return normal_by_tangents(r, angle(s), angle(t));
  };
  EXPECT_LE(length_of(by_tangents(2, 60, 30).normal - at(2, 60, 30).normal), 1e-15);
  EXPECT_TRUE(std::isnan(by_tangents(2, 60, 90).normal.z));
  EXPECT_TRUE(std::isnan(by_tangents(2, 60, -90).normal.z));
  EXPECT_TRUE(std::isnan(by_tangents(1e-170, 60, 30).normal.z)) << "the product underflows";

  const Patches<double> open = seam_twice(2.0, 8, 4);
  EXPECT_EQ(open.points.size(), 9u * 5u);
  const mesh_structures::Counts counts = mesh_structures::counts_of(open.faces, open.points.size());
  EXPECT_EQ(counts.euler(), 1);
  double apart = 0;
  for (std::size_t j = 0; j < 5; ++j)
    apart = std::max(apart, length_of(open.points[9 * j] - open.points[9 * j + 8]));
  EXPECT_EQ(apart, 0);
  EXPECT_TRUE(test::states(page, "makes {} points instead of {}, and {} edges have one face",
                           {45, 26, 1.0 * counts.boundary_edges}));
}

TEST(ParametricSurface, StepsFollowTheGrammarAndObservedEqualsUnobserved) {
  Recorder<Turned<double>, Raised<double>, PointFound<double>, AlongParallel<double>, AlongMeridian<double>,
           NormalFound<double>>
      one;
  EXPECT_EQ(point(2.0, angle(10.0), angle(20.0), one), at(2, 10, 20));
  ASSERT_EQ(one.events().size(), 6u);
  EXPECT_TRUE(every<AlongParallel<double>>(
      one, [](const auto& d) { return std::abs(length_of(d.tangent) - d.length) < 1e-15; }));

  Recorder<RowMade, StripMade, Finished> rows;
  EXPECT_EQ(patches(2.0, 5, 4, rows).points, patches(2.0, 5, 4).points);
  EXPECT_EQ(all<RowMade>(rows).size(), 5u);
  EXPECT_EQ(all<StripMade>(rows).size(), 4u);
  EXPECT_EQ(std::get<Finished>(rows.events().back().step).faces, 20u);

  Recorder<CellFound<double>, Mixed<double>, FaceNormalTaken<double>> looked;
  const Patches<double> mesh = patches(2.0, 5, 4);
  EXPECT_EQ(lookup(mesh, 100.0, 50.0, looked), lookup(mesh, 100.0, 50.0));
  EXPECT_EQ(std::get<0>(looked.events()[0].step).i, 1);
  EXPECT_EQ(std::get<0>(looked.events()[0].step).j, 3);
}

TEST(ParametricSurface, MistakesAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::max();
  for (const double r : {0.0, -1.0, nan, most}) {
    EXPECT_THROW(at(r, 0, 0), ContractViolation) << r;
    EXPECT_THROW(patches(r, 4, 4), ContractViolation) << r;
  }
  EXPECT_THROW(angle(nan), ContractViolation);
  EXPECT_THROW(patches(1.0, 2, 2), ContractViolation);
  EXPECT_THROW(patches(1.0, 3, 1), ContractViolation);
  EXPECT_THROW(patches(1.0, 1 << 13, 1 << 12), ContractViolation);
  const Patches<double> mesh = patches(1.0, 3, 2);
  EXPECT_THROW(lookup(mesh, nan, 0.0), ContractViolation);
  EXPECT_THROW(lookup(mesh, 0.0, 90.5), ContractViolation);
  EXPECT_THROW(lookup(mesh, 0.0, nan), ContractViolation);
}

}  // namespace
}  // namespace gradus::parametric_surface
