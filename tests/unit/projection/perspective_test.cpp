// Goldens of projection and vanishing points, their laws in exact arithmetic, refusals.

#include "projection/perspective/perspective.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "projection/perspective/perspective_notes.hpp"
#include "support/golden_projection.hpp"

namespace gradus::perspective {
namespace {

TEST(Perspective, Goldens) {
  EXPECT_EQ(ndc({0, 0, 1}), (dvec3{0, 0, 0}));
  EXPECT_NEAR(ndc({0, 0, 2}).z, 50.0 / 99, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 10}).z, 0.9090909090909091, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 100}).z, 1, 1e-15);
  EXPECT_NEAR(ndc({10, 0, 10}).x, 1, 1e-15);
  EXPECT_NEAR(glm::distance(ndc({2, 1, 4}), dvec3{0.5, 0.4330127018922193, 0.7575757575757576}), 0, 1e-15);
}

TEST(Perspective, MultipliesWhatMayNotBeDivided) {
  // G004-10, G004-11: behind the eye w is negative, in front of the near plane z is
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

}  // namespace
}  // namespace gradus::perspective
