// Known matrices, normals under them, refusals.

#include "transformation/affine_3d/affine_3d.hpp"

#include <gtest/gtest.h>

#include "core/exact_scalar.hpp"
#include "core/record.hpp"

namespace gradus::affine_3d {
namespace {

TEST(Affine3d, TranslatesScalesAndTurns) {
  EXPECT_EQ(transform(translation(dvec3{1, 2, 3}), dvec3{4, 5, 6}), (dvec3{5, 7, 9}));
  EXPECT_EQ(transform(scaling(dvec3{2, -1, 0}), dvec3{4, 5, 6}), (dvec3{8, -5, 0}));
  // A quarter turn round z takes x to y
  const dvec3 turned = transform(rotation({0, 0, 7}, 1.5707963267948966), dvec3{1, 0, 5});
  EXPECT_NEAR(glm::distance(turned, dvec3{0, 1, 5}), 0, 1e-15);
  // G000-03, G000-04: the right factor acts first
  const glm::dmat4 t = translation(dvec3{2, 3, 5}), r = rotation({0, 0, 1}, 1.5707963267948966);
  EXPECT_NEAR(glm::distance(dvec3((t * r)[3]), dvec3{2, 3, 5}), 0, 1e-15);
  EXPECT_NEAR(glm::distance(dvec3((r * t)[3]), dvec3{-3, 2, 5}), 0, 1e-15);
}

TEST(Affine3d, RotationsKeepLengthsAndSmallAngles) {
  const glm::dmat4 m = rotation({1e-200, 2e-200, -3e-200}, 1.234);
  EXPECT_NEAR(glm::determinant(glm::dmat3(m)), 1, 1e-15);
  EXPECT_NEAR(glm::distance(transform(m, dvec3{1, 2, -3}), dvec3{1, 2, -3}), 0, 1e-15);
  EXPECT_EQ(rotation({0, 0, 1}, 1e-9)[0].y, 1e-9);
  EXPECT_THROW(rotation({0, 0, 0}, 1), ContractViolation);
}

TEST(Affine3d, NormalsStayUprightAndOutside) {
  const glm::dmat4 m = translation(dvec3{9, 9, 9}) * scaling(dvec3{1, 4, -0.5}) * rotation({1, 1, 0}, 0.7);
  const dvec3 u{1, 2, 3}, v{-2, 1, 1}, normal = glm::cross(u, v);
  const dvec3 moved = normal_matrix(m) * normal;
  const auto direction = [&](dvec3 d) { return transform(m, d) - transform(m, dvec3{0}); };
  EXPECT_NEAR(glm::dot(moved, direction(u)), 0, 1e-13);
  EXPECT_NEAR(glm::dot(moved, direction(v)), 0, 1e-13);
  // A point outside stays outside, although the matrix mirrors
  EXPECT_TRUE(mirrors(m));
  EXPECT_FALSE(mirrors(translation(dvec3{1, 1, 1})));
  EXPECT_GT(glm::dot(moved, direction(normal)), 0);
}

TEST(Affine3d, OneBodyForEveryScalar) {
  const ExactScope scope;
  const ExactVec3 p{Exact(1, 3), Exact(2, 3), Exact(-1, 7)};
  const ExactVec3 q = transform(translation(ExactVec3{Exact(1), Exact(1, 3), Exact(1, 7)}), p);
  EXPECT_EQ(q, (ExactVec3{Exact(4, 3), Exact(1), Exact(0)}));
  EXPECT_EQ(transform(scaling(glm::vec3{2, 3, 4}), glm::vec3{1, 1, 1}), (glm::vec3{2, 3, 4}));
}

TEST(Affine3d, StepsAndObservedEqualsUnobserved) {
  Recorder<Transformed<double>> seen;
  const glm::dmat4 m = rotation({3, 1, 2}, 0.3) * translation(dvec3{1, 2, 3});
  const dvec3 to = transform(m, dvec3{0.1, 0.2, 0.3}, seen);
  EXPECT_EQ(to, transform(m, dvec3{0.1, 0.2, 0.3}));
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<Transformed<double>>(seen)[0].to, to);
}

}  // namespace
}  // namespace gradus::affine_3d
