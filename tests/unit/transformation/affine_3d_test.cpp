// Known matrices, turns round any axis in three ways, normals, products and their order, refusals.

#include "transformation/affine_3d/affine_3d.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "transformation/affine_3d/affine_3d_notes.hpp"

namespace gradus::affine_3d {
namespace {

constexpr double right_angle = 1.5707963267948966;
using Mat = Matrix<double>;

/// A matrix by its rows, as it is printed.
Mat rows(const std::array<std::array<double, 4>, 4>& m) {
  Mat made;
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 4; ++x) made[static_cast<int>(x)][static_cast<int>(y)] = m[y][x];
  }
  return made;
}

void expect_near(const Mat& a, const Mat& b, double tolerance) {
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) EXPECT_NEAR(a[x][y], b[x][y], tolerance) << "row " << y << " column " << x;
  }
}

TEST(Affine3d, ThreeOfTheReport) {
  // G000-01: translate
  EXPECT_EQ(translate(dvec3{1, 2, 3}), rows({{{1, 0, 0, 1}, {0, 1, 0, 2}, {0, 0, 1, 3}, {0, 0, 0, 1}}}));
  // G000-02: rotate about z through (1, 0, 0)
  const Mat turned = rotate({0, 0, 1}, right_angle, {1, 0, 0});
  expect_near(turned, rows({{{0, -1, 0, 1}, {1, 0, 0, -1}, {0, 0, 1, 0}, {0, 0, 0, 1}}}), 1e-15);
  EXPECT_NEAR(glm::distance(transform(turned, dvec3{1, 0, 0}), dvec3{1, 0, 0}), 0, 1e-15);
  EXPECT_EQ(rotate({1, 2, 3}, 1), rotate({1, 2, 3}, 1, {0, 0, 0}));
  // G000-03, G000-04: compose
  const Mat t = translate(dvec3{2, 3, 5}), r = rotate({0, 0, 1}, right_angle);
  expect_near(compose(t, r), rows({{{0, -1, 0, 2}, {1, 0, 0, 3}, {0, 0, 1, 5}, {0, 0, 0, 1}}}), 1e-15);
  expect_near(compose(r, t), rows({{{0, -1, 0, -3}, {1, 0, 0, 2}, {0, 0, 1, 5}, {0, 0, 0, 1}}}), 1e-15);
}

template <class A, class B>
concept Composable = requires(A a, B b) { compose(a, b); };

TEST(Affine3d, OnlyMatricesOfOneShapeCompose) {
  static_assert(Composable<glm::dmat4, glm::dmat4>);
  static_assert(!Composable<glm::dmat4, glm::dmat3>);
  static_assert(!Composable<glm::dmat3, glm::dmat3>);
  static_assert(!Composable<glm::dmat4, glm::dvec4>);
}

TEST(Affine3d, QuarterTurnsRoundTheAxes) {
  // G001-32, and exact from degrees
  const Turn<double> quarter = turn_degrees(90.0);
  EXPECT_EQ(transform(rotation_z(quarter), dvec3{1, 0, 0}), (dvec3{0, 1, 0}));
  EXPECT_EQ(transform(rotation_x(quarter), dvec3{0, 1, 0}), (dvec3{0, 0, 1}));
  EXPECT_EQ(transform(rotation_y(quarter), dvec3{0, 0, 1}), (dvec3{1, 0, 0}));
  // G001-33: they do not commute
  const Mat x = rotation_x(quarter), y = rotation_y(quarter);
  EXPECT_EQ(compose(x, y), rows({{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}}));
  EXPECT_EQ(compose(y, x), rows({{{0, 1, 0, 0}, {0, 0, -1, 0}, {-1, 0, 0, 0}, {0, 0, 0, 1}}}));
  // E001-17: round one axis they do
  const Turn<double> other = turn_degrees(180.0);
  EXPECT_EQ(compose(x, rotation_x(other)), compose(rotation_x(other), x));
}

TEST(Affine3d, SeenFromTheAxisEndTheTurnIsCounterClockwise) {
  for (const dvec3 axis :
       {dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, 1}, dvec3{1, 2, 3}, dvec3{-1, 0.5, 0}}) {
    const dvec3 from = glm::cross(axis, dvec3{0.3, -0.7, 0.2});
    const dvec3 to = transform(rotation(axis, 0.1), from);
    EXPECT_GT(glm::dot(glm::cross(from, to), axis), 0);
  }
}

TEST(Affine3d, RodriguesInThreeForms) {
  // G001-36
  const Mat golden = rows({{{0.5357142857142858, -0.6229365034008422, 0.5700529070291328, 0},
                            {0.765793646257985, 0.642857142857143, -0.01716931065742361, 0},
                            {-0.3557671927434186, 0.4457407392288521, 0.8214285714285715, 0},
                            {0, 0, 0, 1}}});
  const dvec3 n = direction_of(dvec3{1, 2, 3});
  const Turn<double> sixty = turn_degrees(60.0);
  expect_near(rodrigues(n, sixty), golden, 1e-15);
  expect_near(rodrigues_by_cross_products(n, sixty), golden, 1e-15);
  expect_near(rotation({1, 2, 3}, radians_from_degrees(60)), golden, 1e-15);
  for (int i = 0; i < 3; ++i) {
    dvec3 unit{0};
    unit[i] = 1;
    EXPECT_NEAR(glm::distance(turn_vector(n, dvec3{0}, sixty, unit), dvec3(golden[i])), 0, 1e-15);
  }
  EXPECT_NEAR(glm::distance(transform(golden, dvec3{1, 2, 3}), dvec3{1, 2, 3}), 0, 3e-15);
}

TEST(Affine3d, DecompositionOfTheNotesFirstAxis) {
  // G001-34: 90 degrees about (0,1,1)-(2,1,1)
  const Mat golden = rows({{{1, 0, 0, 0}, {0, 0, -1, 2}, {0, 1, 0, 0}, {0, 0, 0, 1}}});
  const Mat m = decomposition(dvec3{0, 1, 1}, alignment(dvec3{2, 0, 0}), turn_degrees(90.0));
  EXPECT_EQ(m, golden);
  for (const double x : {0.0, 1.0, 2.0, -7.5}) EXPECT_EQ(transform(m, dvec3{x, 1, 1}), (dvec3{x, 1, 1}));
  expect_near(rotate({2, 0, 0}, right_angle, {0, 1, 1}), golden, 1e-15);
}

TEST(Affine3d, DecompositionOfTheNotesSecondAxis) {
  // G001-35: 30 degrees about (1,1,0)-(1,2,1), five factors
  const Mat golden =
      rows({{{0.8660254037844387, -0.35355339059327373, 0.3535533905932737, 0.487527986808835},
             {0.35355339059327373, 0.9330127018922193, 0.0669872981077807, -0.28656609248549314},
             {-0.3535533905932737, 0.0669872981077807, 0.9330127018922194, 0.286566092485493},
             {0, 0, 0, 1}}});
  Recorder<Decomposed<double>> seen;
  const Alignment<double> align = alignment(dvec3{0, 1, 1});
  const Mat m = decomposition(dvec3{1, 1, 0}, align, turn_degrees(30.0), seen);
  expect_near(m, golden, 1e-15);
  expect_near(rotate({0, 1, 1}, radians_from_degrees(30), {1, 1, 0}), golden, 1e-15);
  const auto steps = all<Decomposed<double>>(seen);
  ASSERT_EQ(steps.size(), 5u);
  const Part parts[] = {Part::to_origin, Part::into_plane, Part::turn, Part::out_of_plane, Part::back};
  Mat product(1);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(steps[i].part, parts[i]);
    product = steps[i].matrix * product;
    EXPECT_EQ(steps[i].product, product);
  }
  // The turn round x by +45 degrees takes the axis to z
  EXPECT_NEAR(glm::distance(transform(steps[1].matrix, dvec3{0, 1, 1}), dvec3{0, 0, std::sqrt(2)}), 0, 1e-15);
  EXPECT_EQ(m, decomposition(dvec3{1, 1, 0}, align, turn_degrees(30.0)));
}

TEST(Affine3d, DecompositionHasWhatItsAxisNeeds) {
  const auto count = [](dvec3 axis) {
    Recorder<Decomposed<double>> seen;
    const Mat m = decomposition(dvec3{1, 2, 3}, alignment(axis), turn_degrees(90.0), seen);
    expect_near(m, rotate(axis, right_angle, {1, 2, 3}), 4e-15);
    return seen.seen();
  };
  EXPECT_EQ(count({0, 0, 1}), 3u);
  EXPECT_EQ(count({0, 0, -1}), 5u);
  EXPECT_EQ(count({1, 0, 0}), 5u);
  EXPECT_EQ(count({-1, 0, -1}), 5u);
  EXPECT_EQ(count({0, 1, 0}), 5u);
  EXPECT_EQ(count({0, -1, -1}), 5u);
  EXPECT_EQ(count({1, 2, 3}), 7u);
  EXPECT_EQ(count({-1, -2, -3}), 7u);
  EXPECT_EQ(count({1, 1e-200, 1e-200}), 7u);
}

TEST(Affine3d, VectorFormStepByStep) {
  Recorder<Projected<double>, Rejected<double>, Crossed<double>, Turned<double>> seen;
  const dvec3 n = direction_of(dvec3{0, 1, 1}), through{1, 1, 0}, point{2, 3, -1};
  const Turn<double> thirty = turn_degrees(30.0);
  const dvec3 to = turn_vector(n, through, thirty, point, seen);
  EXPECT_EQ(to, turn_vector(n, through, thirty, point));
  ASSERT_EQ(seen.events().size(), 4u);
  const auto [p, r] = all<Projected<double>>(seen)[0];
  const dvec3 s = all<Rejected<double>>(seen)[0].s, v = all<Crossed<double>>(seen)[0].v;
  EXPECT_NEAR(glm::distance(p, r + s), 0, 1e-15);
  EXPECT_NEAR(glm::dot(s, n), 0, 1e-15);
  EXPECT_NEAR(glm::length(v), glm::length(s), 1e-15);
  EXPECT_NEAR(glm::dot(v, s), 0, 1e-15);
  EXPECT_EQ(all<Turned<double>>(seen)[0].to, to);
  EXPECT_NEAR(glm::distance(to, transform(rotate({0, 1, 1}, radians_from_degrees(30), through), point)), 0,
              2e-15);
  EXPECT_EQ(turn_vector(dvec3{0, 0, 1}, dvec3{1, 1, 0}, thirty, dvec3{1, 1, 7}), (dvec3{1, 1, 7}));
}

TEST(Affine3d, WorldVerticesAreTRSTimesModelVertices) {
  const Mat t = translation(dvec3{5, 0, -2}), r = rotation_y(turn_degrees(90.0)), s = scaling(dvec3{2, 3, 4});
  const Mat world = compose(compose(t, r), s);
  for (const dvec3 p : {dvec3{1, 2, 3}, dvec3{-1, 0, 0.5}}) {
    EXPECT_EQ(transform(world, p), transform(t, transform(r, transform(s, p))));
  }
  EXPECT_EQ(transform(world, dvec3{1, 2, 3}), (dvec3{17, 6, -4}));
  // Two instances of one model
  const Mat other = translation(dvec3{0, 10, 0});
  EXPECT_NE(transform(world, dvec3{1, 1, 1}), transform(other, dvec3{1, 1, 1}));
}

TEST(Affine3d, AboutAPoint) {
  const Mat half = about(dvec3{400, 300, 0}, rotation_z(turn_degrees(90.0)));
  EXPECT_EQ(transform(half, dvec3{500, 300, 0}), (dvec3{400, 400, 0}));  // G002-03, columns
  EXPECT_EQ(transform(half, dvec3{400, 300, 0}), (dvec3{400, 300, 0}));
  const Mat grown = about(dvec3{1, 2, 3}, scaling(dvec3{3, 3, 3}));
  EXPECT_EQ(transform(grown, dvec3{1, 2, 3}), (dvec3{1, 2, 3}));
  EXPECT_EQ(glm::distance(transform(grown, dvec3{1, 2, 7}), dvec3{1, 2, 3}), 12);
}

TEST(Affine3d, ARigidMountTurnsWithTheCar) {
  // G000-18: an offset in the car's frame, after a quarter turn
  EXPECT_EQ(transform(rotation_z(turn_degrees(90.0)), dvec3{1, 0, 2}), (dvec3{0, 1, 2}));
}

TEST(Affine3dNotes, RowsTurnTheOtherWayAndLoseTranslations) {
  // G002-01, G002-02, G002-03 and E002-01
  const Mat quarter = rotation_z(turn_degrees(90.0));
  EXPECT_EQ(transform(quarter, dvec3{1, 0, 0}), (dvec3{0, 1, 0}));
  EXPECT_EQ(transform_row(dvec3{1, 0, 0}, quarter), (glm::dvec4{0, -1, 0, 1}));
  EXPECT_EQ(transform_row(dvec3{1, 2, 3}, translation(dvec3{5, 6, 7})), (glm::dvec4{1, 2, 3, 39}));
  EXPECT_EQ(transform_row(dvec3{1, 2, 3}, glm::transpose(translation(dvec3{5, 6, 7}))),
            (glm::dvec4{6, 8, 10, 1}));
  EXPECT_EQ(transform_row(dvec3{100, 0, 0}, quarter) + glm::dvec4(400, 300, 0, 0),
            (glm::dvec4{400, 200, 0, 1}));
  EXPECT_EQ(transform_row(dvec3{1, 2, 3}, scaling(dvec3{2, 3, 4})), (glm::dvec4{2, 6, 12, 1}));
  const std::vector<Mat> factors{scaling(dvec3{2, 2, 2}), quarter};
  std::vector<dvec3> points{{1, 0, 0}}, watched = points;
  row_vectors(std::span<const Mat>(factors), std::span(points));
  EXPECT_EQ(points[0], (dvec3{0, -2, 0}));
  Recorder<Started<double>, Multiplied<double>, RowTransformed<double>> seen;
  row_vectors(std::span<const Mat>(factors), std::span(watched), seen);
  EXPECT_EQ(watched, points);
  EXPECT_EQ(seen.events().size(), 4u);
}

TEST(Affine3dNotes, AConstantOffsetStaysBehind) {
  // E000-14, G000-18: after a quarter turn (1,0,2) should be (0,1,2)
  const Turn<double> quarter = turn_degrees(90.0);
  const dvec3 n{0, 0, 1};
  EXPECT_EQ(constant_offset(n, dvec3{0}, quarter, dvec3{1, 0, 2}), (dvec3{1, 0, 2}));
  EXPECT_EQ(turn_vector(n, dvec3{0}, quarter, dvec3{1, 0, 2}), (dvec3{0, 1, 2}));
  EXPECT_EQ(constant_offset(n, dvec3{3, 4, 0}, quarter, dvec3{4, 4, 2}), (dvec3{4, 4, 2}));
  EXPECT_EQ(turn_vector(n, dvec3{3, 4, 0}, quarter, dvec3{4, 4, 2}), (dvec3{3, 5, 2}));
  // Only an offset along the axis is safe
  EXPECT_EQ(constant_offset(n, dvec3{3, 4, 0}, quarter, dvec3{3, 4, 7}), (dvec3{3, 4, 7}));
  EXPECT_EQ(turn_vector(n, dvec3{3, 4, 0}, quarter, dvec3{3, 4, 7}), (dvec3{3, 4, 7}));
  Recorder<OffsetAdded<double>> seen;
  constant_offset(n, dvec3{3, 4, 0}, quarter, dvec3{4, 4, 2}, seen);
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<OffsetAdded<double>>(seen)[0].offset, (dvec3{1, 0, 2}));
}

TEST(Affine3d, AChainStepByStep) {
  const std::vector<Mat> factors{rotation_x(turn_degrees(90.0)), rotation_y(turn_degrees(90.0)),
                                 translation(dvec3{1, 2, 3})};
  const std::vector<dvec3> shape{{1, 0, 0}, {0, 1, 0}};
  std::vector<dvec3> a = shape, b = shape;
  Recorder<Started<double>, Multiplied<double>, Transformed<double>> seen;
  const Mat m = one_matrix(std::span<const Mat>(factors), std::span(a), seen);
  EXPECT_EQ(m, one_matrix(std::span<const Mat>(factors), std::span(b)));
  EXPECT_EQ(a, b);
  EXPECT_EQ(m, factors[2] * factors[1] * factors[0]);
  ASSERT_EQ(seen.events().size(), 1u + 3u + 2u);
  EXPECT_EQ(all<Started<double>>(seen)[0].points, shape);
  EXPECT_EQ(all<Multiplied<double>>(seen)[2].product, m);
  EXPECT_TRUE(every<Transformed<double>>(seen, [&](const auto& s) { return s.to == transform(m, s.from); }));
  Recorder<Transformed<double>> one;
  EXPECT_EQ(transform(m, shape[0], one), a[0]);
  EXPECT_EQ(all<Transformed<double>>(one)[0].to, a[0]);
}

TEST(Affine3d, RepeatedProductsDriftAndAreMended) {
  // Part 4: 1e5 turns of 0.01 rad in float
  const glm::mat4 step = rotation(glm::vec3{1, 2, 3}, 0.01f);
  glm::mat4 drifting(1.0f);
  for (int i = 0; i < 100000; ++i) drifting = step * drifting;
  const auto error = [](const glm::mat4& m) {
    const glm::dmat3 d(m);
    const glm::dmat3 left = glm::transpose(d) * d - glm::dmat3(1);
    double worst = 0;
    for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(left[i / 3][i % 3]));
    return worst;
  };
  EXPECT_NEAR(glm::determinant(glm::dmat3(drifting)), 0.9982, 2e-4);
  EXPECT_GT(error(drifting), 1e-3);
  EXPECT_LT(error(orthonormalized(drifting)), 4.8e-7);
}

TEST(Affine3d, NotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(translation(dvec3{0, nan, 0}), ContractViolation);
  EXPECT_THROW(scaling(dvec3{1, 1, inf}), ContractViolation);
  EXPECT_THROW(rotation({0, nan, 1}, 1), ContractViolation);
  EXPECT_THROW(rotation({0, inf, 1}, 1), ContractViolation);
  EXPECT_THROW(rotation({0, 0, 1}, nan), ContractViolation);
  EXPECT_THROW(rotate({0, 0, 1}, 1, {nan, 0, 0}), ContractViolation);
  EXPECT_THROW(rotate({0, 0, 0}, 1), ContractViolation);
  EXPECT_THROW(alignment(dvec3{0, 0, 0}), ContractViolation);
  EXPECT_THROW(alignment(glm::vec3{0, 0, 0}), ContractViolation);
  EXPECT_THROW(orthonormalized(Mat(0)), ContractViolation);
}

TEST(Affine3d, TranslatesScalesAndTurns) {
  EXPECT_EQ(transform(translation(dvec3{1, 2, 3}), dvec3{4, 5, 6}), (dvec3{5, 7, 9}));
  EXPECT_EQ(transform(scaling(dvec3{2, -1, 0}), dvec3{4, 5, 6}), (dvec3{8, -5, 0}));
  // A quarter turn round z takes x to y
  const dvec3 turned = transform(rotation({0, 0, 7}, 1.5707963267948966), dvec3{1, 0, 5});
  EXPECT_NEAR(glm::distance(turned, dvec3{0, 1, 5}), 0, 1e-15);
  EXPECT_EQ(rotation({0, 0, 1}, 1e-9)[0].y, 1e-9);
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
  const Turn<float> quarter = turn_degrees(90.0f);
  EXPECT_EQ(decomposition(glm::vec3{1, 2, 3}, alignment(glm::vec3{0, 0, 1}), quarter),
            about(glm::vec3{1, 2, 3}, rotation_z(quarter)));
}

}  // namespace
}  // namespace gradus::affine_3d
