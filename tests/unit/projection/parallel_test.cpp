// Goldens of the notes, views and slants by hand, rank and repetition of the matrix, refusals.

#include "projection/parallel/parallel.hpp"

#include <gtest/gtest.h>

#include <glm/matrix.hpp>
#include <limits>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "projection/parallel/parallel_notes.hpp"

namespace gradus::parallel {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

dvec2 xy(dvec3 p) { return {p.x, p.y}; }

TEST(Parallel, GoldenOnThePlaneAtD) {
  // G001-38: (3,4,5) goes to (3,4,d), and so does every other depth
  EXPECT_EQ(orthographic(Axis::z, 2.0, dvec3{3, 4, 5}), (dvec3{3, 4, 2}));
  EXPECT_EQ(orthographic(Axis::z, 2.0, dvec3{3, 4, -17}), (dvec3{3, 4, 2}));
  const glm::dmat4 m = matrix_of(Plane<double>{{0, 0, 1}, 2}, dvec3{0, 0, 1});
  EXPECT_EQ(m * glm::dvec4(3, 4, 5, 1), glm::dvec4(3, 4, 2, 1));
  EXPECT_EQ(glm::determinant(m), 0);
}

TEST(Parallel, ThreeViews) {
  const dvec3 p{1, 2, 3};
  EXPECT_EQ(orthographic(Axis::x, 9.0, p), (dvec3{9, 2, 3}));
  EXPECT_EQ(orthographic(Axis::y, 9.0, p), (dvec3{1, 9, 3}));
  EXPECT_EQ(orthographic(Axis::z, 9.0, p), (dvec3{1, 2, 9}));
  EXPECT_EQ(picture_of(Axis::z, p), (dvec2{1, 2}));
  EXPECT_EQ(picture_of(Axis::y, p), (dvec2{1, 3}));
  EXPECT_EQ(picture_of(Axis::x, p), (dvec2{3, 2}));
}

TEST(Parallel, CavalierAndCabinetKeepDepthAtOneAndAHalf) {
  const dvec3 near{1, 1, 3}, far{1, 1, 5};
  for (const auto& [degrees, foreshortening] : {std::pair{45.0, 1.0},
                                                {45.0, 0.5},
                                                {30.0, 1.0},
                                                {63.0, 0.5},
                                                {-120.0, 0.25},
                                                {10.0, 3.0},
                                                {0.0, 0.0}}) {
    const double radians = radians_from_degrees(degrees);
    const Slant<double> slant = slant_of(radians, foreshortening);
    const dvec2 receding = xy(oblique(3.0, slant, far) - oblique(3.0, slant, near));
    EXPECT_NEAR(glm::length(receding), 2 * foreshortening, 1e-15 * (1 + foreshortening));
    EXPECT_NEAR(receding.x, 2 * foreshortening * gradus::cos(radians), 1e-15 * (1 + foreshortening));
    EXPECT_NEAR(receding.y, 2 * foreshortening * gradus::sin(radians), 1e-15 * (1 + foreshortening));
    // What is parallel to the plane keeps its size and shape
    EXPECT_EQ(oblique(3.0, slant, near), near);
    const dvec3 side = oblique(2.5, slant, dvec3{4, 1, 3}) - oblique(2.5, slant, near);
    EXPECT_NEAR(glm::distance(side, dvec3{3, 0, 0}), 0, 1e-15);
  }
}

TEST(Parallel, OrthographicProjectorsStandUpright) {
  const dvec3 p{3, 4, 5};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    dvec3 normal{0};
    normal[static_cast<int>(axis)] = 1;
    const dvec3 projector = orthographic(axis, 1.0, p) - p;
    EXPECT_EQ(glm::cross(projector, normal), dvec3{0});
    EXPECT_NE(glm::dot(projector, normal), 0);
  }
}

TEST(Parallel, TiltedSegmentsAreForeshortened) {
  // G001-43: length 1, tilted by 60 degrees out of the plane, drawn 1/2 long, at any distance
  const auto [s, c] = sin_cos_degrees(60);
  for (const double z : {0.0, 8.0, 1024.0}) {
    const dvec3 a = orthographic(Axis::z, 1.0, dvec3{2, 0, z});
    const dvec3 b = orthographic(Axis::z, 1.0, dvec3{2 + c, 0, z + s});
    EXPECT_EQ(glm::length(b - a), 0.5);
  }
}

TEST(Parallel, AnyPlaneAlongAnyDirection) {
  // Isometric: onto x + y + z = 0 along its normal, the axes come out equally long and 120 degrees apart
  const Plane<double> plane{{1, 1, 1}, 0};
  const dvec3 normal{1, 1, 1};
  const dvec3 x = along(plane, normal, dvec3{1, 0, 0}), y = along(plane, normal, dvec3{0, 1, 0});
  EXPECT_NEAR(glm::length(x), std::sqrt(2.0 / 3), 1e-15);
  EXPECT_NEAR(glm::length(y), glm::length(x), 1e-15);
  EXPECT_NEAR(glm::dot(x, y) / glm::dot(x, x), -0.5, 1e-15);
  // A direction points either way, and its length is nothing
  EXPECT_EQ(along(plane, -4.0 * normal, dvec3{1, 0, 0}), x);
  // The special ones are cases of it
  EXPECT_EQ(along(Plane<double>{{0, 0, 1}, 2}, dvec3{0.5, -0.25, 1}, dvec3{3, 4, 5}),
            oblique(2.0, slant_of(dvec3{0.5, -0.25, 1}), dvec3{3, 4, 5}));
}

TEST(Parallel, ProjectorsThatNeverMeetThePlaneAreRefused) {
  EXPECT_THROW(slant_of(dvec3{1, 2, 0}), ContractViolation);
  EXPECT_THROW(slant_of(dvec3{1, 2, -0.0}), ContractViolation);
  EXPECT_THROW(slant_of(dvec3{1, 0, 1e-310}), ContractViolation);
  EXPECT_THROW(slant_of(dvec3{1, 0, not_a_number}), ContractViolation);
  const Plane<double> plane{{1, 1, 1}, 0};
  EXPECT_THROW(along(plane, dvec3{1, -1, 0}, dvec3{0}), ContractViolation);
  EXPECT_THROW(along(plane, dvec3{0.1, 0.2, -0.3}, dvec3{0}), ContractViolation);  // -2.8e-17 rounded
  EXPECT_THROW(along(plane, dvec3{0}, dvec3{0}), ContractViolation);
  EXPECT_THROW(along(plane, dvec3{not_a_number, 0, 1}, dvec3{0}), ContractViolation);
  EXPECT_THROW(matrix_of(plane, dvec3{1, -1, 0}), ContractViolation);
  EXPECT_NO_THROW(along(plane, dvec3{1, -1, 1e-10}, dvec3{0}));
  const ExactScope scope;
  const Plane<Exact> exact{{Exact(1), Exact(1), Exact(1)}, Exact(0)};
  const ExactVec3 origin{Exact(0), Exact(0), Exact(0)};
  EXPECT_THROW(along(exact, ExactVec3{Exact(1, 10), Exact(2, 10), Exact(-3, 10)}, origin), ContractViolation);
  EXPECT_NO_THROW(along(exact, ExactVec3{Exact(0.1), Exact(0.2), Exact(-0.3)}, origin));
}

TEST(Parallel, DepthIsLostAndProjectingTwiceChangesNothing) {
  const ExactScope scope;
  const Plane<Exact> plane{{Exact(2), Exact(-1), Exact(3)}, Exact(7)};
  const auto m = matrix_of(plane, ExactVec3{Exact(1), Exact(2), Exact(1, 3)});
  const auto twice = m * m;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) EXPECT_EQ(twice[column][row], m[column][row]);
  }
  EXPECT_EQ(glm::determinant(m), Exact(0));
  // Rank 3: some 3 x 3 minor is not 0
  EXPECT_NE(glm::determinant(glm::mat<3, 3, Exact>(m[0][0], m[0][1], m[0][3], m[1][0], m[1][1], m[1][3],
                                                   m[3][0], m[3][1], m[3][3])),
            Exact(0));
}

TEST(Parallel, StepsAndScalars) {
  Recorder<Cast<double>, Projected<double>> seen;
  const Slant<double> slant{-0.5, -0.25};
  EXPECT_EQ(oblique(2.0, slant, dvec3{3, 4, 6}, seen), oblique(2.0, slant, dvec3{3, 4, 6}));
  EXPECT_EQ(orthographic(Axis::y, 2.0, dvec3{3, 4, 6}, seen), (dvec3{3, 2, 6}));
  EXPECT_EQ(along(Plane<double>{{0, 0, 1}, 2}, dvec3{0, 0, 2}, dvec3{3, 4, 6}, seen), (dvec3{3, 4, 2}));
  EXPECT_EQ(keep_x_and_y(2.0, slant, dvec3{3, 4, 6}, seen), (dvec3{3, 4, 2}));
  ASSERT_EQ(seen.events().size(), 8u);
  const double expected[] = {-4, -2, -2, -4};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(std::get<Cast<double>>(seen.events()[2 * i].step).t, expected[i]);
    EXPECT_EQ(std::get<Projected<double>>(seen.events()[2 * i + 1].step).point, (dvec3{3, 4, 6}));
  }
  EXPECT_EQ(std::get<Projected<double>>(seen.events()[1].step).image, (dvec3{5, 5, 2}));

  EXPECT_EQ(oblique(2.0f, Slant<float>{-0.5f, -0.25f}, glm::vec3{3, 4, 6}), (glm::vec3{5, 5, 2}));
  EXPECT_EQ(along(Plane<float>{{0, 0, 1}, 2}, glm::vec3{0.5f, 0.25f, 1}, glm::vec3{3, 4, 6}),
            (glm::vec3{1, 3, 2}));
  EXPECT_EQ(orthographic(Axis::x, 2.0f, glm::vec3{3, 4, 6}), (glm::vec3{2, 4, 6}));
  const ExactScope scope;
  EXPECT_EQ(orthographic(Axis::z, Exact(1, 3), ExactVec3(Exact(3))).z, Exact(1, 3));
}

TEST(ParallelNotes, TheMatrixKnowsOneDirectionOnly) {
  // E001-19: right without a slant, the front alone with one
  const dvec3 p{3, 4, 5};
  EXPECT_EQ(keep_x_and_y(2.0, Slant<double>{0, 0}, p), oblique(2.0, Slant<double>{0, 0}, p));
  EXPECT_EQ(keep_x_and_y(2.0, Slant<double>{0, 0}, p), orthographic(Axis::z, 2.0, p));
  const Slant<double> cabinet = slant_of(radians_from_degrees(45), 0.5);
  EXPECT_EQ(keep_x_and_y(2.0, cabinet, p), (dvec3{3, 4, 2}));
  EXPECT_NEAR(glm::distance(keep_x_and_y(2.0, cabinet, p), oblique(2.0, cabinet, p)), 1.5, 1e-15);
  // The errata's form: x' = x + (d - z) a
  EXPECT_EQ(oblique(2.0, cabinet, p).x, 3 + (2.0 - 5.0) * cabinet.a);
  EXPECT_EQ(oblique(2.0, cabinet, p).y, 4 + (2.0 - 5.0) * cabinet.b);
}

}  // namespace
}  // namespace gradus::parallel
