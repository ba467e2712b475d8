// Goldens of projection, vanishing points and transformation, their laws in exact arithmetic, stored depth,
// refusals.

#include "projection/perspective/perspective.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "projection/perspective/perspective_notes.hpp"

namespace gradus::perspective {
namespace {

/// Both angles given: 90 degrees across, 60 upright, near 1, far 100 (G004-04 to G004-11).
Projection<double> golden() {
  return projection_of(1.0, 1 / gradus::tan(radians_from_degrees(30)), 1.0, 100.0);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

dvec3 ndc(dvec3 view) { return divide(transform(golden(), view)); }

TEST(Perspective, Goldens) {
  EXPECT_EQ(ndc({0, 0, 1}), (dvec3{0, 0, 0}));
  EXPECT_NEAR(ndc({0, 0, 2}).z, 50.0 / 99, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 10}).z, 0.9090909090909091, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 100}).z, 1, 1e-15);
  EXPECT_NEAR(ndc({10, 0, 10}).x, 1, 1e-15);
  EXPECT_NEAR(glm::distance(ndc({2, 1, 4}), dvec3{0.5, 0.4330127018922193, 0.7575757575757576}), 0, 1e-15);
}

TEST(Perspective, MultipliesWhatMayNotBeDivided) {
  // G004-10, G004-11: behind the eye w is negative, before the near plane z is
  const glm::dvec4 behind = transform(golden(), dvec3{1, 1, -1});
  EXPECT_EQ(behind.w, -1);
  EXPECT_THROW(divide(behind), ContractViolation);
  EXPECT_THROW(divide(glm::dvec4{1, 1, 1, 0}), ContractViolation);
  EXPECT_THROW(divide(glm::dvec4{1, 1, 1, std::numeric_limits<double>::quiet_NaN()}), ContractViolation);
  EXPECT_LT(transform(golden(), dvec3{1, 1, 0.5}).z, 0);
}

TEST(Perspective, TheLensSaysTheSame) {
  Lens lens;
  lens.vertical_radians = radians_from_degrees(60);
  lens.near = 1;
  lens.far = 100;
  const Projection<double> p = projection_of(lens, 4.0 / 3);
  EXPECT_DOUBLE_EQ(p.y_scale, golden().y_scale);
  EXPECT_DOUBLE_EQ(p.x_scale, p.y_scale * 3 / 4);
  const glm::dvec4 by_matrix = projection_matrix(p) * glm::dvec4{2, 1, 4, 1};
  EXPECT_EQ(by_matrix, transform(p, dvec3{2, 1, 4}));
  EXPECT_THROW(projection_of(lens, 0), ContractViolation);
  // Near 0 or behind far, angles of 0 and 180 degrees: E004-04
  for (const auto& [near, far, angle] : {std::array{0.0, 100.0, 1.0},
                                         {-1.0, 100.0, 1.0},
                                         {1.0, 1.0, 1.0},
                                         {2.0, 1.0, 1.0},
                                         {not_a_number, 100.0, 1.0},
                                         {1.0, 100.0, 0.0},
                                         {1.0, 100.0, -1.0},
                                         {1.0, 100.0, 3.141592653589793},
                                         {1.0, 100.0, 3.15}}) {
    lens.near = near;
    lens.far = far;
    lens.vertical_radians = angle;
    EXPECT_THROW(projection_of(lens, 1), ContractViolation) << near << " " << far << " " << angle;
  }
}

TEST(Perspective, DepthsThatTwentyFourBitsCannotTellApart) {
  // G001-79: near 1, far 1e6
  const auto p = projection_of(1.0, 1.0, 1.0, 1e6);
  const auto code = [&](double z) { return std::lround(divide(transform(p, dvec3{0, 0, z})).z * 0xffffff); };
  EXPECT_EQ(code(1000), 16760455);
  EXPECT_EQ(code(1000.05), 16760455);
  EXPECT_EQ(code(1000.07), 16760456);
  EXPECT_EQ(code(500000), code(500100));
  EXPECT_LT(divide(transform(p, dvec3{0, 0, 900000})).z,
            divide(transform(p, dvec3{0, 0, 900000.01})).z);  // double can
}

TEST(Perspective, StepsAndScalars) {
  Recorder<Multiplied<double>, Divided<double>> seen;
  const glm::dvec4 clip = transform(golden(), dvec3{2, 1, 4}, seen);
  EXPECT_EQ(divide(clip, seen), ndc({2, 1, 4}));
  ASSERT_EQ(seen.events().size(), 2u);
  EXPECT_EQ(std::get<Multiplied<double>>(seen.events()[0].step).clip, clip);
  const glm::vec3 f = divide(transform(projection_of(1.0f, 1.0f, 1.0f, 100.0f), glm::vec3{2, 1, 4}));
  EXPECT_NEAR(f.z, 0.75757575f, 1e-6f);
}

// --- Projection --------------------------------------------------

TEST(PerspectiveProjection, Goldens) {
  // G001-39: homogeneous (2,4,8,4), divided (0.5,1,2)
  const glm::dvec4 homogeneous = matrix_onto(2.0) * glm::dvec4(2, 4, 8, 1);
  EXPECT_EQ(homogeneous, glm::dvec4(2, 4, 8, 4));
  EXPECT_EQ(divide(homogeneous), (dvec3{0.5, 1, 2}));
  EXPECT_EQ(project(2.0, dvec3{2, 4, 8}), (dvec3{0.5, 1, 2}));
  // G000-10: the pinhole camera, depths 7, 8, 9
  const dvec3 points[] = {{1, 4, 7}, {2, 5, 8}, {3, 6, 9}};
  const dvec2 expected[] = {{1.0 / 7, 4.0 / 7}, {0.25, 0.625}, {1.0 / 3, 2.0 / 3}};
  for (int i = 0; i < 3; ++i) {
    const dvec3 image = *project(1.0, points[i]);
    EXPECT_NEAR(image.x, expected[i].x, 1e-16);
    EXPECT_NEAR(image.y, expected[i].y, 2e-16);
    // Twice the focal length, twice the picture, exactly
    EXPECT_EQ(*project(2.0, points[i]), 2.0 * image);
  }
}

TEST(PerspectiveProjection, HomogeneousCoordinates) {
  // G001-40: (2,4,6,2) stands for (1,2,3), and (x,y,z,w) for (x/w,y/w,z/w) only
  EXPECT_EQ(divide(glm::dvec4(2, 4, 6, 2)), (dvec3{1, 2, 3}));
  EXPECT_EQ(divide(glm::dvec4(1, 2, 3, 2)), (dvec3{0.5, 1, 1.5}));
}

TEST(PerspectiveProjection, AtOrBehindTheEyeThereIsNoImage) {
  // E000-07, E001-22: (1,1,-1) would be mirrored to (-1,-1)
  for (const double z : {0.0, -0.0, -1.0, -1e-310, -infinity, not_a_number}) {
    EXPECT_FALSE(project(1.0, dvec3{1, 1, z})) << z;
    EXPECT_FALSE(keep_z(1.0, dvec3{1, 1, z})) << z;
  }
  // So near that the image is beyond double: 1 / 1e-310 is
  EXPECT_FALSE(project(1.0, dvec3{1, 0, 1e-310}));
  EXPECT_FALSE(project(1.0, dvec3{0, 0, 1e-310}));
  EXPECT_FALSE(keep_z(1.0, dvec3{1, 0, 1e-310}));
  EXPECT_FALSE(project(1e200, dvec3{1, 0, 1e-200}));
  EXPECT_EQ(project(1e-305, dvec3{1, 0, 1e-305}), (dvec3{1, 0, 1e-305}));
  // E001-22: half of (1,0,2)-(1,0,-2) is seen, from 0.5 towards +infinity
  EXPECT_EQ(project(1.0, dvec3{1, 0, 2})->x, 0.5);
  EXPECT_EQ(project(1.0, dvec3{1, 0, 0x1p-40})->x, 0x1p40);
  EXPECT_FALSE(project(1.0, dvec3{1, 0, -2}));
}

TEST(PerspectiveProjection, FartherIsSmaller) {
  // Image height times depth is the same for equal objects (E002-03 has it the other way round)
  const ExactScope scope;
  const auto height = [](Exact z) {
    return project(Exact(2), ExactVec3{Exact(1), Exact(5), z})->y -
           project(Exact(2), ExactVec3{Exact(1), Exact(-1), z})->y;
  };
  for (const int z : {1, 2, 3, 7, 1000}) EXPECT_EQ(height(Exact(z)) * Exact(z), Exact(12));
  EXPECT_EQ(height(Exact(2)), Exact(2) * height(Exact(4)));
  // No jump at any depth (E002-04)
  EXPECT_NEAR(project(1.0, dvec3{1, 0, 1})->x, project(1.0, dvec3{1, 0, 1 + 1e-9})->x, 2e-9);
}

TEST(PerspectiveProjection, TheScreenOfTheWireframeReport) {
  // G002-04 to G002-06: centre (400,300), fov 500; its eye is at z = zoom = 1000 and looks along -z
  const auto screen = [](double x, double z) {
    const std::optional<dvec3> image = project(500.0, dvec3{x - 400, 0, 1000 - z});
    return image ? std::optional<double>(400 + image->x) : std::nullopt;
  };
  EXPECT_EQ(screen(600, -1000), 450);
  EXPECT_EQ(screen(600, 500), 600);
  EXPECT_EQ(screen(600, 900), 1400);
  EXPECT_EQ(screen(600, 0), 500);  // not 600: no depth is left out
  EXPECT_NEAR(*screen(600, 1e-9), 500, 1e-9);
  EXPECT_EQ(screen(600, 1000), std::nullopt);
  EXPECT_EQ(screen(600, 2000), std::nullopt);  // not 300, the mirrored one
}

TEST(PerspectiveProjection, ScalingAndForeshortening) {
  // A segment parallel to the plane keeps its proportions, a receding one does not
  const ExactScope scope;
  const auto x = [](int px, int pz) {
    return project(Exact(1), ExactVec3{Exact(px), Exact(0), Exact(pz)})->x;
  };
  EXPECT_EQ((x(0, 4) + x(6, 4)) / Exact(2), x(3, 4));
  EXPECT_NE((x(1, 2) + x(5, 6)) / Exact(2), x(3, 4));
}

TEST(PerspectiveProjection, DepthIsLostInOneAndKeptInTheOther) {
  EXPECT_EQ(project(1.0, dvec3{1, 1, 2}), project(1.0, dvec3{2, 2, 4}));
  EXPECT_LT(divide(transform(golden(), dvec3{1, 1, 2})).z, divide(transform(golden(), dvec3{2, 2, 4})).z);
}

// --- Vanishing points --------------------------------------------

using Point = std::optional<dvec2>;

TEST(VanishingPoint, OneTwoAndThreePoints) {
  const glm::dmat4 m = matrix_onto(1.0);
  // One: only z-lines converge
  EXPECT_EQ(vanishing_point(m, dvec3{0, 0, 1}), (dvec2{0, 0}));
  EXPECT_EQ(vanishing_point(m, dvec3{1, 0, 0}), std::nullopt);
  EXPECT_EQ(vanishing_point(m, dvec3{0, 1, 0}), std::nullopt);
  // Two, G001-41: the plane's normal is (1,0,1) / sqrt 2
  const double r = std::sqrt(0.5);
  const glm::dmat4 seen = m * view_matrix(Frame<double>{{0, 0, 0}, {r, 0, -r}, {0, 1, 0}, {r, 0, r}});
  const Point x = vanishing_point(seen, dvec3{1, 0, 0}), z = vanishing_point(seen, dvec3{0, 0, 1});
  ASSERT_TRUE(x && z);
  EXPECT_NEAR(glm::distance(*x, dvec2{1, 0}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(*z, dvec2{-1, 0}), 0, 1e-12);
  EXPECT_EQ(vanishing_point(seen, dvec3{0, 1, 0}), std::nullopt);
  // G001-42, E001-21: a line in the xz-plane does not stay parallel; (1,0,-1) does
  const Point diagonal = vanishing_point(seen, dvec3{1, 0, 1});
  ASSERT_TRUE(diagonal);
  EXPECT_NEAR(glm::distance(*diagonal, dvec2{0, 0}), 0, 1e-12);
  EXPECT_EQ(vanishing_point(seen, dvec3{1, 0, -1}), std::nullopt);
  // Three: the columns of a matrix of rotation with rational numbers
  const ExactScope scope;
  const Exact third(1, 3);
  const ExactVec3 axes[] = {third * ExactVec3{Exact(2), Exact(-1), Exact(2)},
                            third * ExactVec3{Exact(2), Exact(2), Exact(-1)},
                            third * ExactVec3{Exact(-1), Exact(2), Exact(2)}};
  const auto onto = matrix_onto(Exact(2));
  EXPECT_EQ(vanishing_point(onto, axes[0]), (ExactVec2{Exact(2), Exact(-1)}));
  EXPECT_EQ(vanishing_point(onto, axes[1]), (ExactVec2{Exact(-4), Exact(-4)}));
  EXPECT_EQ(vanishing_point(onto, axes[2]), (ExactVec2{Exact(-1), Exact(2)}));
}

TEST(VanishingPoint, ADirectionHasTwoSenses) {
  const glm::dmat4 m = matrix_onto(2.0);
  EXPECT_EQ(vanishing_point(m, dvec3{1, 2, 4}), (dvec2{0.5, 1}));
  EXPECT_EQ(vanishing_point(m, dvec3{-1, -2, -4}), (dvec2{0.5, 1}));
  EXPECT_EQ(vanishing_point(m, dvec3{1e-300, 2e-300, 4e-300}), (dvec2{0.5, 1}));
}

TEST(VanishingPoint, NearlyParallelDirectionsHaveNoFiniteOne) {
  const glm::dmat4 m = matrix_onto(1.0);
  EXPECT_EQ(vanishing_point(m, dvec3{1, 0, 1e-310}), std::nullopt);
  EXPECT_EQ(vanishing_point(m, dvec3{0, 0, 1e-310}), (dvec2{0, 0}));
  EXPECT_EQ(vanishing_point(m, dvec3{1, 0, 0x1p-1000}), (dvec2{0x1p1000, 0}));
  EXPECT_EQ(vanishing_point(m, dvec3{1, 0, not_a_number}), std::nullopt);
  EXPECT_THROW(vanishing_point(m, dvec3{0, 0, 0}), ContractViolation);
}

TEST(VanishingPoint, IsWhereAllLinesOfADirectionEnd) {
  const dvec3 direction{1, -2, 3};
  const dvec2 point = *vanishing_point(matrix_onto(2.0), direction);
  for (const dvec3 start : {dvec3{0, 0, 1}, {5, 1, 2}, {-3, 8, 10}}) {
    const dvec3 image = *project(2.0, start + 1e12 * direction);
    EXPECT_NEAR(glm::distance(dvec2{image.x, image.y}, point), 0, 1e-10);
  }
}

TEST(VanishingPoint, Steps) {
  Recorder<TakenToInfinity<double>, Vanished<double>, StaysParallel<double>> seen;
  vanishing_point(matrix_onto(2.0), dvec3{1, 2, 4}, seen);
  vanishing_point(matrix_onto(2.0), dvec3{1, 2, 0}, seen);
  ASSERT_EQ(seen.events().size(), 4u);
  EXPECT_EQ(std::get<TakenToInfinity<double>>(seen.events()[0].step).image, glm::dvec4(1, 2, 4, 2));
  EXPECT_EQ(std::get<Vanished<double>>(seen.events()[1].step).point, (dvec2{0.5, 1}));
  EXPECT_EQ(std::get<StaysParallel<double>>(seen.events()[3].step).direction, (dvec3{1, 2, 0}));
}

TEST(PerspectiveProjection, StepsAndScalars) {
  Recorder<Scaled<double>, Projected<double>, Unseen<double>> seen;
  EXPECT_EQ(project(2.0, dvec3{2, 4, 8}, seen), project(2.0, dvec3{2, 4, 8}));
  EXPECT_EQ(project(2.0, dvec3{2, 4, -8}, seen), std::nullopt);
  EXPECT_EQ(project(2.0, dvec3{2, 4, 1e-310}, seen), std::nullopt);
  EXPECT_EQ(keep_z(2.0, dvec3{2, 4, 8}, seen), (dvec3{0.5, 1, 8}));
  ASSERT_EQ(seen.events().size(), 7u);
  EXPECT_EQ(std::get<Scaled<double>>(seen.events()[0].step).factor, 0.25);
  EXPECT_EQ(std::get<Projected<double>>(seen.events()[1].step).image, (dvec3{0.5, 1, 2}));
  EXPECT_EQ(std::get<Unseen<double>>(seen.events()[2].step).point.z, -8);
  EXPECT_EQ(std::get<Scaled<double>>(seen.events()[3].step).factor, infinity);
  EXPECT_EQ(std::get<Unseen<double>>(seen.events()[4].step).point.z, 1e-310);
  EXPECT_EQ(project(2.0f, glm::vec3{2, 4, 8}), (glm::vec3{0.5f, 1, 2}));
  EXPECT_EQ(vanishing_point(matrix_onto(2.0f), glm::vec3{1, 2, 4}), (glm::vec2{0.5f, 1}));
  const ExactScope scope;
  EXPECT_EQ(project(Exact(1), ExactVec3{Exact(1), Exact(2), Exact(3)})->x, Exact(1, 3));
}

// --- Depth -------------------------------------------------------

TEST(PerspectiveFrustum, CornersGoToTheCornersOfTheBox) {
  // R004-009, R004-010: with the angles 90 and 60 degrees, near 1, far 100
  const double h = 1, v = gradus::tan(radians_from_degrees(30));
  for (const double z : {1.0, 100.0}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        const dvec3 corner = ndc({x * h * z, y * v * z, z});
        EXPECT_NEAR(glm::distance(corner, dvec3{x, y, z == 1 ? 0 : 1}), 0, 1e-15);
      }
    }
  }
  // R004-012 to R004-014
  EXPECT_LT(ndc({0, 0, 2}).z, ndc({0, 0, 3}).z);
  EXPECT_LT(ndc({0, 0, 0.99}).z, 0);
  EXPECT_GT(ndc({0, 0, 101}).z, 1);
  EXPECT_NEAR(ndc({1, 1, 5}).x, 2 * ndc({1, 1, 10}).x, 1e-16);
}

TEST(PerspectiveFrustum, WhatTheNotesCallNearIsNear) {
  // E004-02: z = n gives 0 and z = f gives 1; E004-05: tan(a)^-1 is the reciprocal of a tangent, no arc
  // tangent
  EXPECT_EQ(ndc({0, 0, 1}).z, 0);
  EXPECT_NEAR(ndc({0, 0, 100}).z, 1, 1e-15);
  EXPECT_NEAR(golden().y_scale, std::sqrt(3.0), 1e-15);
  EXPECT_GT(std::abs(golden().y_scale - gradus::atan(0.5)), 1);
  // E004-03: one lens, 16:9: the angles across and upright are tied by the picture's sides
  Lens lens;
  lens.vertical_radians = radians_from_degrees(60);
  const Projection<double> wide = projection_of(lens, 16.0 / 9);
  EXPECT_NEAR(wide.y_scale / wide.x_scale, 16.0 / 9, 1e-15);
  // E004-04: degenerate planes; as a lens: Perspective.TheLensSaysTheSame
  for (const auto& [near, far] : {std::pair{0.0, 100.0}, {1.0, 1.0}, {2.0, 1.0}, {1.0, infinity}}) {
    EXPECT_THROW(depth_of(DepthCurve::inverse, near, far, 1.0), ContractViolation);
    EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, near, far, 1.0),
                 ContractViolation);
  }
}

TEST(PerspectiveNotes, KeepingZBendsLines) {
  // G001-89, E001-38
  const dvec3 a = *keep_z(1.0, dvec3{0, 0, 1}), m = *keep_z(1.0, dvec3{1, 0, 2}),
              b = *keep_z(1.0, dvec3{2, 0, 3});
  EXPECT_EQ(a, (dvec3{0, 0, 1}));
  EXPECT_NEAR(b.x, 2.0 / 3, 1e-15);
  EXPECT_EQ(b.z, 3);
  EXPECT_EQ(m, (dvec3{0.5, 0, 2}));
  EXPECT_NEAR(interpolated_depth(a, b, m.x), 2.5, 1e-12);
  // A wall at 2.2 hides the line's middle from whoever interpolates, though the line is nearer
  EXPECT_LT(m.z, 2.2);
  EXPECT_GT(interpolated_depth(a, b, m.x), 2.2);
  // Right: the same with a + b / z
  const auto p = projection_of(1.0, 1.0, 0.5, 50.0);
  const auto at = [&](dvec3 v) { return divide(transform(p, v)); };
  const double right = interpolated_depth(at({0, 0, 1}), at({2, 0, 3}), at({1, 0, 2}).x);
  EXPECT_NEAR(right, at({1, 0, 2}).z, 1e-15);
  EXPECT_LT(right, at({0, 0, 2.2}).z);
}

TEST(PerspectiveNotes, HowFarDepthIsOff) {
  // Half-way (z1 - z0)^2 / (2 (z0 + z1)), at worst (sqrt z1 - sqrt z0)^2
  const dvec3 a = *keep_z(1.0, dvec3{0, 0, 1}), b = *keep_z(1.0, dvec3{2, 0, 3});
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double z = 1 + 2 * i / 1000.0;
    const dvec3 m = *keep_z(1.0, dvec3{z - 1, 0, z});
    worst = std::max(worst, interpolated_depth(a, b, m.x) - m.z);
  }
  EXPECT_NEAR(worst, std::pow(std::sqrt(3.0) - 1, 2), 1e-6);
  const dvec3 middle = *keep_z(1.0, dvec3{0.5, 0, 1.5});
  EXPECT_NEAR(middle.x, b.x / 2, 1e-16);
  EXPECT_NEAR(interpolated_depth(a, b, middle.x) - middle.z, 0.5, 1e-15);
}

// E000-07, E001-22, E004-04: what the division makes of points behind the eye
TEST(PerspectiveNotes, WhatLiesBehindTheEyeIsMirrored) {
  const auto straight = projection_of(1.0, 1.0, 1.0, 100.0);
  EXPECT_EQ(dvec2(divide_untested(straight, dvec3{1, 1, -1})), (dvec2{-1, -1}));
  EXPECT_EQ(divide_untested(straight, dvec3{1, 0, 2}).x, 0.5);
  EXPECT_EQ(divide_untested(straight, dvec3{1, 0, -2}).x, -0.5);
  // 90 degrees across, 60 upright
  const dvec3 mirrored = divide_untested(golden(), dvec3{1, 1, -1});
  EXPECT_NEAR(glm::distance(mirrored, dvec3{-1, -std::sqrt(3.0), 200.0 / 99}), 0, 1e-15);
  EXPECT_TRUE(std::isinf(divide_untested(straight, dvec3{1, 1, 0}).x));
  EXPECT_TRUE(std::isnan(divide_untested(straight, dvec3{0, 1, 0}).x));
  for (const double z : {-1.0, -2.0, 0.0, -0.0, -infinity, not_a_number}) {
    EXPECT_EQ(divide_tested(straight, dvec3{1, 1, z}), std::nullopt) << z;
  }
  // Of the segment (1,0,2)-(1,0,-2) the part before the eye runs from 0.5 to infinity
  double last = 0;
  for (double z = 2; z > 1e-300; z /= 16) {
    const double x = divide_tested(straight, dvec3{1, 0, z})->x;
    EXPECT_EQ(x, 1 / z);
    EXPECT_GT(x, last);
    last = x;
  }
  EXPECT_GT(last, 1e299);
}

// E004-04: the matrix alone refuses no planes and no angle
TEST(PerspectiveNotes, AnyPlanesAndAngles) {
  for (const double z : {0.5, 1.0, 7.0, 100.0}) {
    EXPECT_EQ(divide_untested(projection_of(1.0, 1.0, 0.0, 100.0), dvec3{0, 0, z}).z, 1) << z;
    EXPECT_FALSE(std::isfinite(divide_untested(projection_of(1.0, 1.0, 2.0, 2.0), dvec3{0, 0, z}).z)) << z;
  }
  // 180 degrees: half of it has no tangent, in doubles a huge one, and everything lands in the middle
  const double cotangent = 1 / std::tan(radians_from_degrees(90.0));
  EXPECT_LT(cotangent, 1e-15);
  EXPECT_LT(divide_untested(projection_of(cotangent, cotangent, 1.0, 100.0), dvec3{1000, 0, 1}).x, 1e-12);
}

// E002-03, E002-04, E002-05: G002-04 to G002-06
TEST(PerspectiveNotes, ZoomMinusZ) {
  const WireScreen<double> screen{{400, 300}, 500, 1000};
  const auto x = [&](double z) { return zoom_minus_z(screen, dvec3{600, 300, z}).x; };
  // The larger z, the larger
  EXPECT_EQ(x(-1000), 450);
  EXPECT_EQ(x(500), 600);
  EXPECT_EQ(x(900), 1400);
  // A plane tears at z = 0
  EXPECT_EQ(x(0), 600);
  EXPECT_NEAR(x(1e-9), 500, 1e-9);
  EXPECT_NEAR(x(-1e-9), 500, 1e-9);
  // And flies apart at z = zoom
  EXPECT_EQ(x(999), 100400);
  EXPECT_EQ(x(1001), -99600);
  EXPECT_TRUE(std::isinf(x(1000)));
  EXPECT_EQ(x(2000), 300);  // mirrored
  EXPECT_EQ(zoom_minus_z(screen, dvec3{400, 400, 500}), (dvec2{400, 400}));
  // zoom + z: the larger z, the smaller, without a jump
  double last = infinity;
  for (const double z : {-999.0, -500.0, -1e-9, 0.0, 1e-9, 500.0, 900.0, 999.0, 1000.0, 1001.0, 2000.0}) {
    const dvec3 image = *divide_tested(projection_of(500.0, 500.0, 1.0, 1e6), dvec3{200, 0, 1000 + z});
    EXPECT_LT(image.x, last) << z;
    EXPECT_NEAR(image.x, 100000 / (1000 + z), 1e-9) << z;
    last = image.x;
  }
}

// E001-21: G001-41, G001-42
TEST(PerspectiveNotes, TheRuleOfThePlaneIsTooWide) {
  const double r = std::sqrt(0.5);
  const glm::dmat4 seen =
      matrix_onto(1.0) * view_matrix(Frame<double>{{0, 0, 0}, {r, 0, -r}, {0, 1, 0}, {r, 0, r}});
  for (const dvec3 direction : {dvec3{1, 0, 0}, {0, 0, 1}, {1, 0, 1}}) {
    EXPECT_EQ(parallel_by_plane(seen, direction), std::nullopt);
    EXPECT_NE(vanishing_point(seen, direction), std::nullopt);
  }
  EXPECT_NEAR(glm::length(*vanishing_point(seen, dvec3{1, 0, 1})), 0, 1e-12);
  // It is right along the picture plane, for the y-axis, and for all that leaves the plane
  for (const dvec3 direction : {dvec3{1, 0, -1}, {0, 1, 0}, {1, 1, 0}, {1, -2, 3}}) {
    EXPECT_EQ(parallel_by_plane(seen, direction), vanishing_point(seen, direction));
  }
  EXPECT_THROW(parallel_by_plane(seen, dvec3{0}), ContractViolation);
}

TEST(PerspectiveNotes, Steps) {
  const auto lens = projection_of(1.0, 1.0, 1.0, 100.0);
  Recorder<Multiplied<double>, Divided<double>, LeftUndivided<double>> tested;
  EXPECT_EQ(divide_tested(lens, dvec3{2, 1, 4}, tested), divide_tested(lens, dvec3{2, 1, 4}));
  EXPECT_EQ(divide_tested(lens, dvec3{2, 1, -4}, tested), std::nullopt);
  ASSERT_EQ(tested.events().size(), 4u);
  EXPECT_EQ(std::get<Divided<double>>(tested.events()[1].step).ndc.x, 0.5);
  EXPECT_EQ(std::get<LeftUndivided<double>>(tested.events()[3].step).clip.w, -4);
  Recorder<Multiplied<double>, Divided<double>> untested;
  EXPECT_EQ(divide_untested(lens, dvec3{2, 1, -4}, untested), divide_untested(lens, dvec3{2, 1, -4}));
  ASSERT_EQ(untested.events().size(), 2u);
  EXPECT_EQ(std::get<Divided<double>>(untested.events()[1].step).clip.w, -4);
  const WireScreen<double> screen{{400, 300}, 500, 1000};
  Recorder<LeftAlone<double>, Divided<double>> wire;
  EXPECT_EQ(zoom_minus_z(screen, dvec3{600, 300, 500}, wire), zoom_minus_z(screen, dvec3{600, 300, 500}));
  zoom_minus_z(screen, dvec3{600, 300, 0}, wire);
  ASSERT_EQ(wire.events().size(), 2u);
  EXPECT_EQ(std::get<Divided<double>>(wire.events()[0].step).clip.w, 500);
  EXPECT_EQ(std::get<LeftAlone<double>>(wire.events()[1].step).node.x, 600);
  Recorder<TakenToInfinity<double>, Vanished<double>, StaysParallel<double>> rule;
  parallel_by_plane(matrix_onto(1.0), dvec3{1, 0, 1}, rule);
  parallel_by_plane(matrix_onto(1.0), dvec3{1, 1, 1}, rule);
  ASSERT_EQ(rule.events().size(), 3u);
  EXPECT_EQ(std::get<StaysParallel<double>>(rule.events()[0].step).direction, (dvec3{1, 0, 1}));
  EXPECT_EQ(std::get<Vanished<double>>(rule.events()[2].step).point, (dvec2{1, 1}));
  EXPECT_EQ(divide_tested(projection_of(1.0f, 1.0f, 1.0f, 100.0f), glm::vec3{2, 1, 4})->x, 0.5f);
}

TEST(StoredDepth, CurvesRunBetweenNearAndFar) {
  for (const auto& [curve, at_near, at_far] : {std::tuple{DepthCurve::linear, 0.0, 1.0},
                                               {DepthCurve::inverse, 0.0, 1.0},
                                               {DepthCurve::reversed, 1.0, 0.0}}) {
    EXPECT_EQ(depth_of(curve, 1.0, 1e6, 1.0), at_near);
    EXPECT_EQ(depth_of(curve, 1.0, 1e6, 1e6), at_far);
  }
}

TEST(StoredDepth, TheSmallestStepGrowsWithTheSquareOfTheDistance) {
  // n = 1, f = 1e6, 24 bits
  const auto step = [](double z) {
    return separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, z);
  };
  EXPECT_NEAR(step(100), 6e-4, 0.1e-4);
  EXPECT_NEAR(step(1000), 0.0596, 0.00005);
  EXPECT_NEAR(step(1e5), 596, 0.5);
  EXPECT_NEAR(step(1e6), 59604.58872345619, 1e-6);  // G001-79
  // Linear 24 bits: the same everywhere; reversed 24 bits: as the inverse curve
  for (const double z : {1.0, 1000.0, 1e6}) {
    EXPECT_NEAR(separable_step(DepthCurve::linear, DepthFormat::fixed24, 1, 1e6, z), 999999.0 / 0xffffff,
                1e-12);
    EXPECT_EQ(separable_step(DepthCurve::reversed, DepthFormat::fixed24, 1, 1e6, z), step(z));
  }
  // Reversed floats: about 2^-23 z at most, at any distance up to where far itself is near
  for (double z = 1; z < 1e5; z *= 3) {
    EXPECT_LT(separable_step(DepthCurve::reversed, DepthFormat::float32, 1, 1e6, z), z * 0x1p-23 * 1.2) << z;
  }
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, 0.5), ContractViolation);
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, 2e6), ContractViolation);
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, not_a_number),
               ContractViolation);
}

TEST(StoredDepth, WhatFloatsTellApart) {
  const auto bits = [](DepthCurve curve, double z) {
    return stored(DepthFormat::float32, depth_of(curve, 1.0, 1e6, z));
  };
  EXPECT_EQ(bits(DepthCurve::inverse, 999'000), std::bit_cast<std::uint32_t>(1.0f));
  EXPECT_EQ(bits(DepthCurve::inverse, 999'900), std::bit_cast<std::uint32_t>(1.0f));
  EXPECT_NE(bits(DepthCurve::reversed, 999'000), bits(DepthCurve::reversed, 999'900));
  EXPECT_NE(bits(DepthCurve::reversed, 500'000), bits(DepthCurve::reversed, 500'000.01));
  // … of which the last is luck: there a step is 0.028
  EXPECT_NEAR(separable_step(DepthCurve::reversed, DepthFormat::float32, 1, 1e6, 500'000), 0.0284217, 1e-7);
  EXPECT_EQ(bits(DepthCurve::reversed, 500'000), bits(DepthCurve::reversed, 499'999.99));
}

TEST(StoredDepth, Spacing) {
  EXPECT_EQ(spacing(DepthFormat::float32, 1), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.75), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.5), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.49), 0x1p-25);
  EXPECT_EQ(spacing(DepthFormat::float32, 0), 0x1p-149);
  EXPECT_EQ(spacing(DepthFormat::fixed24, 0.3), 1.0 / 16777215);
  EXPECT_EQ(stored(DepthFormat::fixed24, 1), 16777215u);
  Recorder<Resolved> seen;
  EXPECT_EQ(separable_step(DepthCurve::linear, DepthFormat::fixed24, 1, 3, 2, seen), 2.0 / 16777215);
  ASSERT_EQ(seen.events().size(), 1u);
  const Resolved& r = std::get<Resolved>(seen.events()[0].step);
  EXPECT_EQ(r.depth, 0.5);
  EXPECT_EQ(r.slope, 0.5);
  EXPECT_EQ(r.step, 2.0 / 16777215);
}

}  // namespace
}  // namespace gradus::perspective
