// The numbers that the pages of transformations claim, measured again.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <span>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "support/documented.hpp"
#include "transformation/affine_2d/affine_2d.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus {
namespace {

using test::states;
using Wide = boost::multiprecision::cpp_bin_float_100;

constexpr const char* page_2d = "docs/topics/transformation/affine_2d.md";
constexpr const char* page_3d = "docs/topics/transformation/affine_3d.md";
constexpr double ulp = 0x1p-52;

/// The largest entry of RᵀR - I, in ulp of 1.
template <int N, class Matrix>
double off_orthogonal(const Matrix& m, double unit = ulp) {
  double worst = 0;
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k <= i; ++k) {
      Wide sum = i == k ? -1 : 0;
      for (int row = 0; row < N; ++row) sum += Wide(m[i][row]) * Wide(m[k][row]);
      worst = std::max(worst, static_cast<double>(Wide(abs(sum))) / unit);
    }
  }
  return worst;
}

TEST(DocumentedTransformation, PointsAndInversesInThePlane) {
  using namespace affine_2d;
  Random random(20240611);
  double points = 0, inverses = 0;
  for (int n = 0; n < 20'000; ++n) {
    double x[8];
    for (double& v : x) {
      const double digits = random.uniform(-1, 1);
      v = std::ldexp(digits, static_cast<int>(random.uniform_int(-9, 9)));
    }
    const Matrix<double> m{x[0], x[1], 0, x[2], x[3], 0, x[4], x[5], 1};
    const dvec2 to = transform(m, dvec2{x[6], x[7]});
    for (int row = 0; row < 2; ++row) {
      const Wide terms[] = {Wide(m[0][row]) * Wide(x[6]), Wide(m[1][row]) * Wide(x[7]), Wide(m[2][row])};
      const Wide sum = terms[0] + terms[1] + terms[2], size = abs(terms[0]) + abs(terms[1]) + abs(terms[2]);
      points = std::max(points, static_cast<double>(Wide(abs(Wide(to[row]) - sum) / size)) / ulp);
    }
    const auto back = inverse(m);
    if (!back) continue;
    const Wide a(x[0]), b(x[1]), c(x[2]), d(x[3]), e(x[4]), f(x[5]), det = a * d - b * c;
    const Wide cancels = (abs(a * d) + abs(b * c)) / abs(det);
    const Wide right[] = {d / det, -b / det, -c / det, a / det};
    for (int k = 0; k < 4; ++k) {
      const Wide off = abs(Wide((*back)[k / 2][k % 2]) - right[k]) / abs(right[k]) / cancels;
      inverses = std::max(inverses, static_cast<double>(off) / ulp);
    }
    for (int row = 0; row < 2; ++row) {
      const Wide p = right[row] * e, q = right[2 + row] * f;
      const Wide off = abs(Wide((*back)[2][row]) + p + q) / (abs(p) + abs(q)) / cancels;
      inverses = std::max(inverses, static_cast<double>(off) / ulp);
    }
  }
  EXPECT_LE(points, 3);
  EXPECT_LE(inverses, 4);
  EXPECT_TRUE(states(page_2d, "to 3 ulp of the sum of its absolute terms (measured {})", {points}));
  EXPECT_TRUE(states(page_2d, "times how far the determinant cancels (measured {})", {inverses}));
}

TEST(DocumentedTransformation, AFarPivotInThePlane) {
  using namespace affine_2d;
  Random random(20240611);
  const double c = 1e12;
  double local = 0, matrix = 0;
  for (int n = 0; n < 1000; ++n) {
    const double degrees = random.uniform(-360, 360);
    const std::vector<Factor<double>> factors{rotation(turn_degrees(degrees), dvec2{c, c})};
    std::vector<dvec2> by_matrix{{c + 1, c}}, by_place = by_matrix;
    one_matrix(std::span<const Factor<double>>(factors), std::span(by_matrix));
    local_coordinates(dvec2{c, c}, std::span<const Factor<double>>(factors), std::span(by_place));
    const Wide radians = Wide(degrees) * boost::math::constants::pi<Wide>() / 180;
    const Wide right[] = {cos(radians), sin(radians)};
    for (int axis = 0; axis < 2; ++axis) {
      local = std::max(local, static_cast<double>(Wide(abs(Wide(by_place[0][axis]) - right[axis]))));
      matrix =
          std::max(matrix, static_cast<double>(Wide(abs(Wide(by_matrix[0][axis]) - Wide(c) - right[axis]))));
    }
  }
  EXPECT_LE(local, 1 * ulp);
  EXPECT_TRUE(states(page_2d,
                     "relative to it: {} off at most in 1000 turns where the matrix is up to {} off.",
                     {local, matrix}));
}

TEST(DocumentedTransformation, ProductsDrift) {
  using namespace affine_2d;
  const Matrix<float> step = matrix(rotation(turn(0.01f)));
  Matrix<float> drifting(1.0f);
  for (int i = 0; i < 100'000; ++i) drifting = step * drifting;
  EXPECT_TRUE(states(page_2d, "100,000 products of a turn by 0.01 in float leave det = {};",
                     {double(drifting[0].x) * drifting[1].y - double(drifting[0].y) * drifting[1].x}));

  const glm::mat4 turn_3d = affine_3d::rotation(glm::vec3{1, 2, 3}, 0.01f);
  glm::mat4 product(1.0f);
  for (int i = 0; i < 100'000; ++i) product = turn_3d * product;
  EXPECT_TRUE(states(page_3d, "100,000 turns by 0.01 in float have det = {};",
                     {glm::determinant(glm::dmat3(product))}));
}

TEST(DocumentedTransformation, NearestRotations) {
  using namespace affine_2d;
  Random random(20240611);
  double worst = 0;
  for (int i = 0; i < 750'000;) {
    float x[4];
    for (float& v : x) v = static_cast<float>(random.uniform(-1, 1));
    if (double(x[0]) * x[3] - double(x[1]) * x[2] <= 0) continue;
    const Matrix<float> turn = nearest_rotation(Matrix<float>{x[0], x[1], 0, x[2], x[3], 0, 0, 0, 1});
    const double cos = turn[0].x, sin = turn[0].y;  // whose squares are exact in double
    worst = std::max(worst, std::abs(cos * cos + sin * sin - 1) / 0x1p-23);
    ++i;
  }
  EXPECT_LE(worst, 3);
  EXPECT_TRUE(states(page_2d, "orthogonal to 3 ulp of 1 (measured {} in 750,000 matrices)", {worst}));
}

TEST(DocumentedTransformation, RotationsAreOrthogonal) {
  using namespace affine_3d;
  Random random(20240611);
  double polished = 0, plain = 0, parts = 0, apart = 0;
  for (int n = 0; n < 10'000; ++n) {
    constexpr double sizes[] = {1, 1e-200, 1e200, 1e-300, 1e300};
    dvec3 axis{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    axis *= sizes[n % 5];
    const double angle = random.uniform(-7, 7);
    const Turn<double> t = turn(angle);
    const Matrix<double> r = rodrigues(direction_of(axis), t),
                         d = decomposition(dvec3(0), alignment(axis), t);
    polished = std::max(polished, off_orthogonal<3>(rotation(axis, angle)));
    plain = std::max(plain, off_orthogonal<3>(r));
    parts = std::max(parts, off_orthogonal<3>(d));
    for (int k = 0; k < 9; ++k) apart = std::max(apart, std::abs(r[k / 3][k % 3] - d[k / 3][k % 3]) / ulp);
  }
  EXPECT_LE(polished, 4);
  EXPECT_LE(std::max(plain, parts), 10);
  EXPECT_TRUE(states(
      page_3d, "is above 4 ulp (measured {} over 10,000 axes of length 1, 1e-200, 1e200, 1e-300, 1e300)",
      {polished}));
  EXPECT_TRUE(states(page_3d,
                     "to 10 ulp (measured {}), `decomposition` to 10 ({}), and they differ by up to {} ulp.",
                     {plain, parts, apart}));
  EXPECT_TRUE(states(page_3d, "| `decomposition` | 2 to 6 | {} |", {parts}));
  EXPECT_TRUE(states(page_3d, "| `rodrigues`, as a matrix | none | {} |", {plain}));
  EXPECT_TRUE(states(page_3d, "| `rotation`, the same mended | none | {} |", {polished}));
}

TEST(DocumentedTransformation, NearlyParallelColumnsAreOrthonormalized) {
  using namespace affine_3d;
  Random random(20240611);
  double worst = 0, rounded = 0;
  for (int n = 0; n < 10'000; ++n) {
    const double angle = std::ldexp(1.0, n % 2 == 0 ? -20 : -static_cast<int>(random.uniform_int(1, 50)));
    const auto vector = [&] {
      return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    const dvec3 a = vector(), b = a + angle * vector();
    const Matrix<double> m{glm::dvec4(a, 0), glm::dvec4(b, 0), glm::dvec4(0, 0, 1, 0),
                           glm::dvec4(0, 0, 0, 1)};
    worst = std::max(worst, off_orthogonal<3>(orthonormalized(m)));
    if (n % 2 != 0) continue;
    // With rounded products, at just this angle
    const dvec3 x = glm::normalize(a), side = glm::normalize(glm::cross(x, vector()));
    const dvec3 z = glm::normalize(glm::cross(x, x + angle * side));
    rounded = std::max(
        rounded, static_cast<double>(Wide(abs(Wide(x.x) * z.x + Wide(x.y) * z.y + Wide(x.z) * z.z))) / ulp);
  }
  EXPECT_LE(worst, 2);
  EXPECT_TRUE(states(page_3d, "is orthogonal to 2 ulp (measured {}) however small", {worst}));
  EXPECT_TRUE(states(page_3d, "With rounded ones columns 2⁻²⁰ apart came out {} ulp off.", {rounded}));
}

}  // namespace
}  // namespace gradus
