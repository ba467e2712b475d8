// Known matrices and points, products and their order, the way back, refusals.

#include "transformation/affine_2d/affine_2d.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/record.hpp"
#include "transformation/affine_2d/affine_2d_notes.hpp"

namespace gradus::affine_2d {
namespace {

using Factors = std::vector<Factor<double>>;
using Points = std::vector<dvec2>;
using Mat = Matrix<double>;

Mat product_of(const Factors& factors, Points& points) {
  return one_matrix(std::span<const Factor<double>>(factors), std::span(points));
}
Mat product_of(const Factors& factors) {
  Points none;
  return product_of(factors, none);
}
dvec2 moved(const Factor<double>& factor, dvec2 p) { return transform(matrix(factor), p); }

/// A matrix by its rows, as it is printed.
Mat rows(std::array<double, 6> m) { return {m[0], m[3], 0, m[1], m[4], 0, m[2], m[5], 1}; }

void expect_near(const Mat& a, const Mat& b, double tolerance) {
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) EXPECT_NEAR(a[x][y], b[x][y], tolerance) << "row " << y << " column " << x;
  }
}

TEST(Affine2d, MovesScalesAndSlants) {
  EXPECT_EQ(moved(translation<double>({5, -2}), {3, 4}), (dvec2{8, 2}));
  EXPECT_EQ(moved(translation<double>({-5, 2}), {8, 2}), (dvec2{3, 4}));
  EXPECT_EQ(moved(scaling<double>({2, 3}), {1, 1}), (dvec2{2, 3}));
  EXPECT_EQ(moved(scaling<double>({2, 3}, {1, 1}), {2, 2}), (dvec2{3, 4}));  // G001-28
  EXPECT_EQ(moved(scaling<double>({2, 3}, {1, 1}), {1, 1}), (dvec2{1, 1}));
  EXPECT_EQ(moved(shearing<double>({2, 0}), {0, 1}), (dvec2{2, 1}));
  EXPECT_EQ(moved(shearing<double>({0, 3}), {1, 0}), (dvec2{1, 3}));
}

TEST(Affine2d, TheWorkedExample) {
  // G001-27: rotate by 30 degrees, then scale by 2, both about (1, 1)
  const Mat golden =
      rows({1.7320508075688772, -1, 0.2679491924311228, 1, 1.7320508075688772, -1.7320508075688772});
  const Turn<double> thirty = turn_degrees(30.0);
  const Mat m = product_of({rotation(thirty, dvec2{1, 1}), scaling<double>({2, 2}, {1, 1})});
  expect_near(m, golden, 1e-15);
  EXPECT_NEAR(glm::distance(transform(m, dvec2{1, 1}), dvec2{1, 1}), 0, 1e-15);
  EXPECT_NEAR(glm::distance(transform(m, dvec2{2, 1}), dvec2{2.7320508075688772, 2}), 0, 1e-15);
  // The same in the four steps of the notes' pictures
  const Mat four = product_of({translation<double>({-1, -1}), rotation(thirty), scaling<double>({2, 2}),
                               translation<double>({1, 1})});
  expect_near(four, golden, 1e-15);
}

TEST(Affine2d, QuarterTurnsAreExact) {
  const auto quarter = rotation(turn_degrees(90.0), dvec2{3, 7});
  EXPECT_EQ(moved(quarter, {3, 7}), (dvec2{3, 7}));
  EXPECT_EQ(moved(quarter, {5, 8}), (dvec2{2, 9}));
  EXPECT_EQ(product_of({quarter, quarter, quarter, quarter}), Mat(1));
  EXPECT_EQ(matrix(rotation(turn_degrees(180.0))), matrix(reflection_in_origin<double>()));
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, 360.0, -90.0}) {
    const Mat m = matrix(rotation(turn_degrees(degrees)));
    for (int i = 0; i < 4; ++i)
      EXPECT_FALSE(m[i / 2][i % 2] == 0 && std::signbit(m[i / 2][i % 2])) << degrees;
  }
}

TEST(Affine2d, ShearsKeepTheirPivot) {
  // G001-29, G001-30
  EXPECT_EQ(moved(shearing<double>({0.5, 0.25}, {1, 1}), {1, 1}), (dvec2{1, 1}));
  EXPECT_EQ(moved(shearing<double>({0, 0}, {1, 1}), {3, 4}), (dvec2{3, 4}));
  EXPECT_EQ(moved(shearing<double>({0.5, 0.25}, {1, 1}), {3, 5}), (dvec2{3 + 0.5 * 4, 5 + 0.25 * 2}));
}

TEST(Affine2dNotes, TheShearsCentreIsAddedButNotSubtracted) {
  // E001-13, and what G001-29 and G001-30 record of the notes
  EXPECT_EQ(moved(shearing_centre_added<double>({0.5, 0.25}, {1, 1}), {1, 1}), (dvec2{2, 2}));
  EXPECT_EQ(moved(shearing_centre_added<double>({0, 0}, {1, 1}), {3, 4}), (dvec2{4, 5}));
  EXPECT_EQ(moved(shearing_centre_added<double>({0.5, 0.25}, {0, 0}), {3, 4}),
            moved(shearing<double>({0.5, 0.25}), {3, 4}));
  Factors factors{shearing<double>({0.5, 0.25}, {1, 1}), rotation(turn_degrees(90.0), dvec2{2, 2})};
  Points points{{1, 1}}, right{{1, 1}};
  centre_added(std::span<const Factor<double>>(factors), std::span(points));
  product_of(factors, right);
  EXPECT_EQ(points[0], (dvec2{2, 2}));
  EXPECT_EQ(right[0], (dvec2{3, 1}));
}

TEST(Affine2d, AShearByBothFactorsMayFlatten) {
  // G001-31, E001-14
  const Mat flat = matrix(shearing<double>({2, 0.5}));
  EXPECT_EQ(determinant(flat), 0);
  EXPECT_EQ(transform(flat, dvec2{2, -1}), (dvec2{0, 0}));
  EXPECT_FALSE(inverse(flat).has_value());
  EXPECT_FALSE(inverse(matrix(shearing<double>({3, 1.0 / 3}))).has_value());
  EXPECT_FALSE(inverse(shearing<double>({-0.2, -5.0}, {1, 1})).has_value());
  EXPECT_FALSE(inverse(shearing<float>({3, 1.0f / 3})).has_value());
  EXPECT_TRUE(inverse(shearing<double>({3, 0.3333})).has_value());
  // Nor is it the product of the two: for 1, 1 that is (2 1; 1 1)
  const Mat x = matrix(shearing<double>({1, 0})), y = matrix(shearing<double>({0, 1}));
  EXPECT_EQ(compose(x, y), rows({2, 1, 0, 1, 1, 0}));
  EXPECT_NE(compose(x, y), matrix(shearing<double>({1, 1})));
}

TEST(Affine2d, OneNegativeFactorMirrorsTwoTurn) {
  // E001-16
  EXPECT_LT(determinant(matrix(scaling<double>({-1, 1}))), 0);
  EXPECT_LT(determinant(matrix(scaling<double>({2, -3}))), 0);
  EXPECT_EQ(determinant(matrix(scaling<double>({-1, -1}))), 1);
  EXPECT_EQ(matrix(scaling<double>({-1, -1})), matrix(rotation(turn_degrees(180.0))));
}

TEST(Affine2d, OnlyEqualFactorsKeepTheShape) {
  // E001-15: equal up to sign, and not 0
  const auto angle = [](const Factor<double>& f) {
    const dvec2 a = moved(f, {0, 0}), b = moved(f, {4, 0}) - a, c = moved(f, {1, 3}) - a;
    return glm::dot(b, c) / std::sqrt(glm::dot(b, b) * glm::dot(c, c));
  };
  const double was = angle(scaling<double>({1, 1}));
  EXPECT_NEAR(angle(scaling<double>({2, 2})), was, 1e-15);
  EXPECT_NEAR(angle(scaling<double>({-2, 2}, {5, 6})), was, 1e-15);
  EXPECT_GT(std::abs(angle(scaling<double>({2, 3})) - was), 0.05);
  EXPECT_TRUE(std::isnan(angle(scaling<double>({0, 0}))));  // no shape is left
}

TEST(Affine2d, Reflections) {
  EXPECT_EQ(moved(reflection_in_x_axis<double>(), {3, 4}), (dvec2{3, -4}));
  EXPECT_EQ(moved(reflection_in_y_axis<double>(), {3, 4}), (dvec2{-3, 4}));
  EXPECT_EQ(moved(reflection_in_origin<double>(), {3, 4}), (dvec2{-3, -4}));
  EXPECT_EQ(moved(reflection_in_diagonal<double>(), {3, 4}), (dvec2{4, 3}));
  // The line through (0, 1) and (2, 2)
  const auto mirror = reflection_in_line<double>({0, 1}, {2, 2});
  EXPECT_NEAR(glm::distance(moved(mirror, {4, 3}), dvec2{4, 3}), 0, 1e-15);
  EXPECT_NEAR(glm::distance(moved(mirror, {0, 6}), dvec2{4, -2}), 0, 1e-15);
  EXPECT_EQ(reflection_in_line<double>({1, 1}, {5, 5}).linear, reflection_in_diagonal<double>().linear);
  const auto far = reflection_in_line<double>({0, 0}, {1e-200, 1e-200});
  EXPECT_EQ(far.linear, reflection_in_diagonal<double>().linear);
  EXPECT_THROW(reflection_in_line<double>({1, 1}, {1, 1}), ContractViolation);
}

TEST(Affine2d, TheOrderMatters) {
  const Factors forth{translation<double>({2, 0}), rotation(turn_degrees(90.0))};
  const Factors back{forth[1], forth[0]};
  Points a{{1, 0}}, b{{1, 0}};
  product_of(forth, a);
  product_of(back, b);
  EXPECT_EQ(a[0], (dvec2{0, 3}));
  EXPECT_EQ(b[0], (dvec2{2, 1}));
  // E001-17: not even rotations of the plane commute when their centres differ
  const auto r = rotation(turn_degrees(90.0)), s = rotation(turn_degrees(90.0), dvec2{2, 0});
  EXPECT_NE(product_of({r, s}), product_of({s, r}));
  EXPECT_EQ(product_of({r, rotation(turn_degrees(180.0))}), product_of({rotation(turn_degrees(180.0)), r}));
}

TEST(Affine2d, RowVectorsTurnTheOtherWay) {
  // G002-03: about the middle of an 800 x 600 screen; columns (400, 400), rows (400, 200)
  const dvec2 centre{400, 300};
  EXPECT_EQ(moved(rotation(turn_degrees(90.0), centre), {500, 300}), (dvec2{400, 400}));
  EXPECT_EQ(moved(rotation(turn_degrees(-90.0), centre), {500, 300}), (dvec2{400, 200}));
  // Without the centre the model swings round a corner
  EXPECT_EQ(moved(rotation(turn_degrees(90.0)), centre), (dvec2{-300, 400}));
  EXPECT_EQ(moved(rotation(turn_degrees(90.0), centre), centre), centre);
}

TEST(Affine2d, AFarPivotIsSubtractedFirst) {
  // Part 4: (c + 1, c) turned by 30 degrees about (c, c)
  const double c = 1e12, exact = 0.8660254037844386;
  const Factors factors{rotation(turn_degrees(30.0), dvec2{c, c})};
  Points by_matrix{{c + 1, c}}, local = by_matrix;
  product_of(factors, by_matrix);
  EXPECT_EQ(by_matrix[0].x - c, 0.8659667968750000);
  EXPECT_NEAR(by_matrix[0].x - c - exact, -5.86e-5, 1e-7);
  local_coordinates(dvec2{c, c}, std::span<const Factor<double>>(factors), std::span(local));
  EXPECT_EQ(local[0].x, exact);
  EXPECT_EQ(local[0].y, 0.5);
  const std::vector<Factor<float>> in_float{rotation(turn_degrees(30.0f), Point<float>(1e6f, 1e6f))};
  std::vector<Point<float>> p{{1e6f + 1, 1e6f}}, q = p;
  one_matrix(std::span<const Factor<float>>(in_float), std::span(p));
  EXPECT_EQ(p[0].x - 1e6f, 0.875f);
  local_coordinates(Point<float>(1e6f, 1e6f), std::span<const Factor<float>>(in_float), std::span(q));
  EXPECT_EQ(q[0].x, 0.8660254f);
}

TEST(Affine2d, RepeatedProductsDriftAndAreMended) {
  // Part 4: 1e5 turns of 0.01 rad in float
  const Matrix<float> step = matrix(rotation(turn(0.01f)));
  Matrix<float> drifting(1.0f), mended(1.0f);
  for (int i = 0; i < 100000; ++i) {
    drifting = step * drifting;
    mended = nearest_rotation(step * mended);
  }
  EXPECT_LT(std::abs(determinant(drifting) - 1), 3e-3f);
  EXPECT_GT(std::abs(determinant(drifting) - 1), 1e-3f);
  EXPECT_LT(std::abs(determinant(mended) - 1), 3e-7f);
  EXPECT_THROW(nearest_rotation(matrix(reflection_in_x_axis<double>())), ContractViolation);
}

TEST(Affine2d, TheWayBack) {
  const auto m = matrix(translation<double>({3, 4}));
  EXPECT_EQ(inverse(m).value(), matrix(translation<double>({-3, -4})));
  EXPECT_EQ(inverse(matrix(scaling<double>({2, 4}, {1, 1}))).value(),
            matrix(scaling<double>({0.5, 0.25}, {1, 1})));
  EXPECT_FALSE(inverse(matrix(scaling<double>({0, 1}))).has_value());
  EXPECT_FALSE(inverse(matrix(scaling<double>({0, 0}))).has_value());
  // Tiny and huge are not flat
  EXPECT_EQ(inverse(matrix(scaling<double>({1e-200, 1e-200}))).value()[0][0], 1e200);
  EXPECT_EQ(inverse(matrix(scaling<double>({1e200, 1e200}))).value()[1][1], 1e-200);
  EXPECT_EQ(inverse(matrix(scaling<double>({1e-200, 1e200}))).value()[1][1], 1e-200);
}

// Columns, or rows, of sizes so different that a product on the way leaves the range of double, though the
// determinant does not
TEST(Affine2d, TheWayBackFromEntriesOfAnySize) {
  const auto back = inverse(Mat{1e200, 1e-200, 0, 1e200, -1e-200, 0, 0, 0, 1});  // its determinant is -2
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, (Mat{5e-201, 5e-201, 0, 5e199, -5e199, 0, 0, 0, 1}));
  const auto other = inverse(Mat{1e200, 1e200, 0, 1e-200, -1e-200, 0, 0, 0, 1});
  ASSERT_TRUE(other);
  EXPECT_EQ(*other, (Mat{5e-201, 5e199, 0, 5e-201, -5e199, 0, 0, 0, 1}));
  const auto single = inverse(Matrix<float>{1e30f, 1e-30f, 0, 1e30f, -1e-30f, 0, 0, 0, 1});
  ASSERT_TRUE(single);
  EXPECT_NEAR((*single)[1][0] / 5e29f, 1, 1e-6f);
  // Subnormal entries
  const auto tiny = inverse(Mat{1, 0x1p-1074, 0, 0x1p-1074, 1, 0, 3, 0, 1});
  ASSERT_TRUE(tiny);
  EXPECT_EQ(*tiny, (Mat{1, -0x1p-1074, 0, -0x1p-1074, 1, 0, -3, 0x3p-1074, 1}));
  const auto least = inverse(Mat{0x3p-1023, 0x1p-1023, 0, 0x1p-1023, 0x3p-1023, 0, 0, 0, 1});
  ASSERT_TRUE(least);
  EXPECT_EQ((*least)[0][0], 0x3p1020);
  // The shift comes back through numbers that would vanish
  EXPECT_EQ(inverse(Mat{0x1p1000, 0, 0, 0, 0x1p1000, 0, 0x1p1000, 0x1p-60, 1}).value()[2],
            (dvec3{-1, -0x1p-1060, 1}));
  // What double has no numbers for has no inverse in it
  EXPECT_FALSE(inverse(matrix(scaling<double>({1e-310, 1}))).has_value());
  EXPECT_FALSE(inverse(scaling<double>({0x1p-1074, 1})).has_value());
  EXPECT_FALSE(inverse(Mat{1e-200, 0, 0, 0, 1e-200, 0, 1e200, 0, 1}).has_value());
}

TEST(Affine2d, NotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(translation<double>({nan, 0}), ContractViolation);
  EXPECT_THROW(scaling<double>({1, inf}), ContractViolation);
  EXPECT_THROW(scaling<double>({1, 1}, {nan, 0}), ContractViolation);
  EXPECT_THROW(shearing<double>({nan, 0}), ContractViolation);
  EXPECT_THROW(rotation(turn(nan)), ContractViolation);
  EXPECT_THROW(rotation(Turn<double>{nan, nan, nan}), ContractViolation);
  EXPECT_THROW(reflection_in_line<double>({0, 0}, {nan, 1}), ContractViolation);
  EXPECT_THROW(reflection_in_line<double>({-1e308, 0}, {1e308, 1}), ContractViolation);
  Mat bad(1);
  bad[0][0] = nan;
  EXPECT_THROW(inverse(bad), ContractViolation);
}

/// What a run over a copy of the shape tells; the points come out as without an observer.
template <class... Steps, class Run>
Recorder<Steps...> told(const Points& shape, Run run) {
  Recorder<Steps...> seen;
  Points observed = shape, unobserved = shape;
  run(std::span(observed), seen);
  run(std::span(unobserved), Unobserved{});
  EXPECT_EQ(observed, unobserved);
  return seen;
}

TEST(Affine2d, StepsAndObservedEqualsUnobserved) {
  const Factors factors{rotation(turn_degrees(30.0), dvec2{1, 1}), scaling<double>({2, 2}, {1, 1}),
                        shearing<double>({0.5, 0}, {2, 1})};
  const Factors flat{translation<double>({1, 1}), shearing<double>({2, 0.5}), scaling<double>({2, 2})};
  const Points shape{{0, 0}, {2, 0}, {2, 1}};
  const std::span<const Factor<double>> chain(factors);

  Mat m;
  const auto product = told<Started<double>, Multiplied<double>, Moved<double>>(
      shape, [&](auto points, auto&& seen) { m = one_matrix(chain, points, seen); });
  ASSERT_EQ(product.seen(), 1u + 3u + 3u);
  EXPECT_EQ(all<Started<double>>(product)[0].points, shape);
  Mat expected(1);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto step = all<Multiplied<double>>(product)[k];
    expected = matrix(factors[k]) * expected;
    EXPECT_EQ(step.factor, k);
    EXPECT_EQ(step.matrix, matrix(factors[k]));
    EXPECT_EQ(step.product, expected);
  }
  EXPECT_EQ(m, expected);
  EXPECT_TRUE(every<Moved<double>>(product, [&](const auto& s) { return s.to == transform(m, s.from); }));

  const auto acted = told<Started<double>, Acted<double>>(
      shape, [&](auto points, auto&& seen) { factor_by_factor(chain, points, seen); });
  ASSERT_EQ(acted.seen(), 4u);
  Points moved_by_all = shape;
  factor_by_factor(chain, std::span(moved_by_all));
  EXPECT_EQ(all<Acted<double>>(acted)[2].points, moved_by_all);
  const auto rebased = told<Rebased<double>, Multiplied<double>, Moved<double>>(
      shape, [&](auto points, auto&& seen) { local_coordinates(dvec2{1, 1}, chain, points, seen); });
  ASSERT_EQ(rebased.seen(), 7u);
  EXPECT_EQ(all<Rebased<double>>(rebased)[0].points[1], (dvec2{1, -1}));
  const auto undone = told<Undone<double>, Stuck>(
      shape, [&](auto points, auto&& seen) { EXPECT_TRUE(undo(chain, points, seen)); });
  ASSERT_EQ(undone.seen(), 3u);
  EXPECT_EQ(all<Undone<double>>(undone)[0].factor, 2u);
  const auto stuck = told<Undone<double>, Stuck>(shape, [&](auto points, auto&& seen) {
    EXPECT_FALSE(undo(std::span<const Factor<double>>(flat), points, seen));
  });
  ASSERT_EQ(stuck.seen(), 2u);
  EXPECT_EQ(all<Stuck>(stuck)[0].factor, 1u);
  std::vector<Mat> products;
  const auto added = told<Started<double>, Multiplied<double>, Moved<double>>(
      shape, [&](auto points, auto&& seen) { products.push_back(centre_added(chain, points, seen)); });
  EXPECT_EQ(added.seen(), 7u);
  EXPECT_EQ(products[0], products[1]);
}

TEST(Affine2d, NoFactorsAndNoPoints) {
  Points shape{{1, 2}}, none;
  EXPECT_EQ(product_of({}, shape), Mat(1));
  EXPECT_EQ(shape[0], (dvec2{1, 2}));
  EXPECT_EQ(product_of({scaling<double>({2, 2})}, none)[0][0], 2);
}

}  // namespace
}  // namespace gradus::affine_2d
