// Rotations in space: orthogonal for axes of every size, three forms and the decomposition equal by exact
// rationals, errors of each measured.

#include "transformation/affine_3d/affine_3d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/exact_scalar.hpp"
#include "support/seed.hpp"

namespace gradus::affine_3d {
namespace {

using test::seed;

/// The greatest entry of |R^T R - I|, exactly, in ulp of 1: eps is 2^-52 for double.
template <class T>
double orthogonality_error(const Matrix<T>& m) {
  const ExactScope scope;
  double worst = 0;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b <= a; ++b) {
      Exact dot(a == b ? -1 : 0);
      for (int i = 0; i < 3; ++i) dot += Exact(m[a][i]) * Exact(m[b][i]);
      worst = std::max(worst, to_double(abs(dot)));
    }
  }
  return worst / static_cast<double>(std::numeric_limits<T>::epsilon());
}

class Axes {
 public:
  explicit Axes(std::uint64_t offset) : random_(seed() + offset) {}
  double number(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  /// Of length about `scale`; every fourth with components of very different size or 0.
  dvec3 axis(double scale) {
    for (;;) {
      dvec3 v{number(-1, 1), number(-1, 1), number(-1, 1)};
      if (random_() % 4 == 0) {
        for (int i = 0; i < 3; ++i)
          v[i] = random_() % 3 == 0 ? 0 : v[i] * std::pow(10.0, -double(random_() % 20));
      }
      if (v != dvec3{0}) return v * scale;
    }
  }
  double angle() {
    switch (random_() % 4) {
      case 0:
        return number(-1e-7, 1e-7);
      case 1:
        return number(-1e22, 1e22);
      default:
        return number(-7, 7);
    }
  }

 private:
  std::mt19937_64 random_;
};

TEST(Affine3dProperty, RotationsAreOrthogonalForAxesOfEverySize) {
  Axes random(1);
  int cases = 0;
  for (const double scale : {1.0, 1e-200, 1e200, 1e-300, 1e300}) {
    double worst = 0;
    for (int i = 0; i < 2000; ++i, ++cases) {
      const dvec3 axis = random.axis(scale);
      const double radians = random.angle();
      const glm::dmat4 m = rotation(axis, radians);
      worst = std::max(worst, orthogonality_error<double>(m));
      // The size of the axis makes no difference
      if (scale == 1.0) {
        EXPECT_EQ(rotation(axis * 0x1p600, radians), m);
        EXPECT_EQ(rotation(axis * 0x1p-600, radians), m);
      }
    }
    std::printf("axes of size %g: orthogonal to %.3f ulp\n", scale, worst);
    EXPECT_GT(worst, 0);
    EXPECT_LE(worst, 4);
  }
  EXPECT_EQ(cases, 10000);
}

TEST(Affine3dProperty, RotationsInFloatAreOrthogonalToo) {
  Axes random(2);
  double worst = 0;
  int cases = 0;
  while (cases < 4000) {
    const glm::vec3 axis(random.axis(cases % 2 ? 1e-30 : 1e30));
    if (axis == glm::vec3{0}) continue;  // too small for float
    ++cases;
    worst =
        std::max(worst, orthogonality_error<float>(rotation(axis, static_cast<float>(random.number(-7, 7)))));
  }
  std::printf("float: orthogonal to %.3f ulp\n", worst);
  EXPECT_EQ(cases, 4000);
  EXPECT_LE(worst, 4);
}

TEST(Affine3dProperty, FormulasWithoutTheLastStepComeClose) {
  Axes random(3);
  double rodrigues_worst = 0, decomposition_worst = 0, apart = 0;
  int cases = 0;
  for (; cases < 4000; ++cases) {
    const dvec3 axis = random.axis(1);
    const double radians = random.angle();
    const Matrix<double> m = rodrigues(direction_of(axis), turn(radians));
    const Matrix<double> d = decomposition(dvec3{0}, alignment(axis), turn(radians));
    const Matrix<double> r = rotation(axis, radians);
    rodrigues_worst = std::max(rodrigues_worst, orthogonality_error<double>(m));
    decomposition_worst = std::max(decomposition_worst, orthogonality_error<double>(d));
    const Matrix<double> k = rodrigues_by_cross_products(direction_of(axis), turn(radians));
    for (int i = 0; i < 9; ++i) {
      const int x = i / 3, y = i % 3;
      apart = std::max({apart, std::abs(m[x][y] - d[x][y]), std::abs(m[x][y] - k[x][y])});
      EXPECT_NEAR(m[x][y], r[x][y], 1e-15);
    }
  }
  std::printf("orthogonal to: rodrigues %.2f ulp, decomposition %.2f ulp; apart %.2f ulp\n", rodrigues_worst,
              decomposition_worst, apart / 0x1p-52);
  EXPECT_EQ(cases, 4000);
  EXPECT_LE(rodrigues_worst, 10);
  EXPECT_LE(decomposition_worst, 10);
  EXPECT_LE(apart, 8 * 0x1p-52);
  EXPECT_GT(apart, 0);
}

/// Rational turns, points, and axes with rational length in space and in the yz plane.
class Rationals {
 public:
  explicit Rationals(std::uint64_t offset) : random_(seed() + offset) {}
  Exact number() {
    const auto n = static_cast<std::int64_t>(random_() % 31) - 15;
    return Exact(n, static_cast<std::int64_t>(random_() % 7) + 1);
  }
  ExactVec3 vector() {
    const Exact x = number(), y = number();
    return {x, y, number()};
  }
  ExactVec3 whole() {
    const auto n = [this] { return Exact(static_cast<std::int64_t>(random_() % 2001) - 1000); };
    const Exact x = n(), y = n();
    return {x, y, n()};
  }
  Turn<Exact> turn() {
    const Exact t = number(), one = Exact(1);
    return turn_of(Exact(2) * t / (one + t * t), (one - t * t) / (one + t * t));
  }

 private:
  std::mt19937_64 random_;
};

TEST(Affine3dProperty, DecompositionIsRodriguesExactly) {
  Rationals random(4);
  int cases = 0, general = 0;
  for (; cases < 600; ++cases) {
    const ExactScope scope;
    // The turns that align it make the axis: z, turned back round y, then round x
    Alignment<Exact> align;
    if (cases % 3 != 0) align.x = random.turn();
    if (cases % 3 != 1) align.y = random.turn();
    Matrix<Exact> out(Exact(1));
    if (align.y) out = rotation_y(reversed(*align.y)) * out;
    if (align.x) out = rotation_x(reversed(*align.x)) * out;
    const ExactVec3 n(out[2]), through = random.vector(), p = random.vector();
    ASSERT_EQ(glm::dot(n, n), Exact(1));
    const Turn<Exact> turn = random.turn();
    const Matrix<Exact> by_parts = decomposition(through, align, turn);
    const Matrix<Exact> whole = about(through, rodrigues(n, turn));
    EXPECT_EQ(by_parts, whole);
    EXPECT_EQ(rodrigues_by_cross_products(n, turn), rodrigues(n, turn));
    EXPECT_EQ(turn_vector(n, through, turn, p), transform(whole, p));
    // The axis stays, point by point; lengths stay
    const Exact t = random.number();
    EXPECT_EQ(transform(by_parts, ExactVec3(through + t * n)), ExactVec3(through + t * n));
    const ExactVec3 d = p - through, e = transform(by_parts, p) - through;
    EXPECT_EQ(glm::dot(d, d), glm::dot(e, e));
    // About a point is there, and back
    EXPECT_EQ(whole, translation(through) * rodrigues(n, turn) * translation(ExactVec3(-through)));
    general += align.x && align.y && n.x != Exact(0) && n.y != Exact(0);
  }
  EXPECT_EQ(cases, 600);
  EXPECT_GE(general, 150);
}

TEST(Affine3dProperty, VectorFormObeysItsDrawing) {
  Rationals random(5);
  int cases = 0;
  for (; cases < 600; ++cases) {
    const ExactScope scope;
    const ExactVec3 n(rotation_x(random.turn()) * rotation_y(random.turn())[2]);
    ExactVec3 p, r, s;
    int steps = 0;
    const auto watch = [&]<class Step>(const Step& step) {
      ++steps;
      if constexpr (std::same_as<Step, Projected<Exact>>) {
        p = step.p, r = step.r;
        EXPECT_EQ(glm::cross(r, n), ExactVec3(Exact(0)));
      } else if constexpr (std::same_as<Step, Rejected<Exact>>) {
        s = step.s;
        EXPECT_EQ(r + s, p);
        EXPECT_EQ(glm::dot(s, n), Exact(0));
      } else if constexpr (std::same_as<Step, Crossed<Exact>>) {
        EXPECT_EQ(glm::dot(step.v, s), Exact(0));
        EXPECT_EQ(glm::dot(step.v, step.v), glm::dot(s, s));
      }
    };
    turn_vector(n, random.vector(), random.turn(), random.vector(), watch);
    EXPECT_EQ(steps, 4);
  }
  EXPECT_EQ(cases, 600);
}

TEST(Affine3dProperty, BacMinusCab) {
  Rationals random(6);
  int cases = 0;
  for (; cases < 2000; ++cases) {
    const ExactScope scope;
    const ExactVec3 a = random.whole(), b = random.whole(), c = random.whole();
    EXPECT_EQ(glm::cross(a, glm::cross(b, c)), ExactVec3(b * glm::dot(a, c) - c * glm::dot(a, b)));
  }
  EXPECT_EQ(cases, 2000);
}

TEST(Affine3dProperty, ChainsAreTheirFactorsOneByOne) {
  Rationals random(7);
  int cases = 0;
  for (; cases < 400; ++cases) {
    const ExactScope scope;
    const std::vector<Matrix<Exact>> factors{scaling(random.vector()),
                                             about(random.vector(), rotation_y(random.turn())),
                                             translation(random.vector())};
    std::vector<ExactVec3> points{random.vector(), random.vector()};
    const std::vector<ExactVec3> before = points;
    one_matrix(std::span<const Matrix<Exact>>(factors), std::span(points));
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points[i], transform(factors[2], transform(factors[1], transform(factors[0], before[i]))));
    }
    // A translation changes no distance
    const Matrix<Exact> t = translation(random.vector());
    const ExactVec3 was = before[1] - before[0], is = transform(t, before[1]) - transform(t, before[0]);
    EXPECT_EQ(was, is);
  }
  EXPECT_EQ(cases, 400);
}

TEST(Affine3dProperty, VectorFormInDouble) {
  Axes random(8);
  double worst = 0;
  int cases = 0;
  for (; cases < 3000; ++cases) {
    const dvec3 n = direction_of(random.axis(1)), through = random.axis(3), p = random.axis(3);
    const Turn<double> t = turn(random.angle());
    const dvec3 to = turn_vector(n, through, t, p);
    const dvec3 other = transform(about(through, polished(rodrigues(n, t))), p);
    const double size = glm::length(through) + glm::length(p - through);
    worst = std::max(worst, glm::distance(to, other) / size);
  }
  std::printf("vector form: %.2f ulp of its size from the matrix\n", worst / 0x1p-52);
  EXPECT_EQ(cases, 3000);
  EXPECT_LE(worst, 8 * 0x1p-52);
}

}  // namespace
}  // namespace gradus::affine_3d
