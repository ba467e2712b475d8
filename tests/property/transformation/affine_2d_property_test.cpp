// Transformations of the plane against their coordinate formulas, exact rationals, rivals and inverses.

#include "transformation/affine_2d/affine_2d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/exact_scalar.hpp"
#include "support/seed.hpp"

namespace gradus::affine_2d {
namespace {

using test::seed;

template <class T>
constexpr double ulp = static_cast<double>(std::numeric_limits<T>::epsilon());

/// Small rationals, and Pythagorean turns.
class Rationals {
 public:
  explicit Rationals(std::uint64_t offset) : random_(seed() + offset) {}
  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(n));
  }
  Exact number() { return Exact(below(41) - 20, below(9) + 1); }
  ExactVec2 point() {
    const Exact x = number();
    return {x, number()};
  }
  /// ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)) lies on the unit circle for every rational t.
  Turn<Exact> turn() {
    const Exact t = number(), one = Exact(1);
    return turn_of(Exact(2) * t / (one + t * t), (one - t * t) / (one + t * t));
  }
  Factor<Exact> factor() {
    switch (below(6)) {
      case 0:
        return translation(point());
      case 1:
        return scaling(point(), point());
      case 2:
        return rotation(turn(), point());
      case 3:
        return shearing(point(), point());
      case 4:
        return reflection_in_diagonal<Exact>();
      default:
        for (;;) {
          const ExactVec2 a = point(), b = point();
          if (a != b) return reflection_in_line(a, b);
        }
    }
  }

 private:
  std::mt19937_64 random_;
};

TEST(Affine2dProperty, MatricesAreTheCoordinateFormulas) {
  Rationals random(1);
  int cases = 0;
  for (; cases < 1000; ++cases) {
    const ExactScope scope;
    const ExactVec2 p = random.point(), c = random.point(), f = random.point(), d = p - c;
    const Turn<Exact> t = random.turn();
    const auto at = [&](const Factor<Exact>& factor) {
      EXPECT_EQ(transform(matrix(factor), p), transform(factor, p));
      return transform(matrix(factor), p);
    };
    EXPECT_EQ(at(translation(f)), p + f);
    EXPECT_EQ(at(scaling(f, c)), (ExactVec2{c.x + f.x * d.x, c.y + f.y * d.y}));
    EXPECT_EQ(at(rotation(t, c)),
              (ExactVec2{c.x + t.cos * d.x - t.sin * d.y, c.y + t.sin * d.x + t.cos * d.y}));
    EXPECT_EQ(at(shearing(f, c)), (ExactVec2{p.x + f.x * d.y, p.y + f.y * d.x}));
    EXPECT_EQ(determinant(matrix(shearing(f, c))), Exact(1) - f.x * f.y);
    // About a point is: there, about the origin, and back
    const Matrix<Exact> three =
        matrix(translation(c)) * matrix(shearing(f)) * matrix(translation(ExactVec2(-c)));
    EXPECT_EQ(three, matrix(shearing(f, c)));
    // A rotation keeps lengths
    const ExactVec2 moved = at(rotation(t, c)) - c;
    EXPECT_EQ(glm::dot(moved, moved), glm::dot(d, d));
  }
  EXPECT_EQ(cases, 1000);
}

TEST(Affine2dProperty, MirrorsKeepTheirLineAndSwapItsSides) {
  Rationals random(2);
  int cases = 0;
  while (cases < 1000) {
    const ExactScope scope;
    const ExactVec2 a = random.point(), b = random.point(), p = random.point();
    if (a == b) continue;
    ++cases;
    const Matrix<Exact> m = matrix(reflection_in_line(a, b));
    EXPECT_EQ(transform(m, a), a);
    EXPECT_EQ(transform(m, b), b);
    EXPECT_EQ(determinant(m), Exact(-1));
    EXPECT_EQ(m * m, Matrix<Exact>(Exact(1)));
    const ExactVec2 image = transform(m, p);
    EXPECT_EQ(orient2d(a, b, p), -orient2d(a, b, image));
    EXPECT_EQ(glm::dot(image - p, b - a), Exact(0));
  }
}

TEST(Affine2dProperty, AllWaysThroughAChainAgreeExactly) {
  Rationals random(3);
  int cases = 0, flat = 0, undone = 0;
  for (; cases < 600; ++cases) {
    const ExactScope scope;
    std::vector<Factor<Exact>> factors;
    for (std::int64_t k = random.below(5); k >= 0; --k) factors.push_back(random.factor());
    std::vector<ExactVec2> shape{random.point(), random.point(), random.point()};
    const std::span<const Factor<Exact>> chain(factors);
    std::vector<ExactVec2> a = shape, b = shape, c = shape;
    const Matrix<Exact> m = one_matrix(chain, std::span(a));
    factor_by_factor(chain, std::span(b));
    const ExactVec2 origin = random.point();
    local_coordinates(origin, chain, std::span(c));
    Exact det(1);
    for (const auto& f : factors) det *= determinant(matrix(f));
    EXPECT_EQ(determinant(m), det);
    for (std::size_t i = 0; i < shape.size(); ++i) {
      EXPECT_EQ(a[i], transform(m, shape[i]));
      EXPECT_EQ(a[i], b[i]);
      EXPECT_EQ(a[i], origin + c[i]);
    }
    std::vector<ExactVec2> back = a;
    const bool can = undo(chain, std::span(back));
    EXPECT_EQ(can, det != Exact(0));
    EXPECT_EQ(inverse(m).has_value(), can);
    if (can) {
      EXPECT_EQ(back, shape);
      EXPECT_EQ(*inverse(m) * m, Matrix<Exact>(Exact(1)));
      ++undone;
    } else {
      ++flat;
    }
  }
  EXPECT_EQ(cases, 600);
  EXPECT_GE(undone, 200);
  EXPECT_GE(flat, 10);
}

Factor<Exact> exact(const auto& f) {
  const auto vec = [](const auto& v) { return ExactVec2(Exact(v.x), Exact(v.y)); };
  return {{vec(f.linear[0]), vec(f.linear[1])}, vec(f.pivot), vec(f.shift)};
}

/// The greatest error of transform and inverse, in units of their bounds.
template <class T>
void measure_errors(std::uint64_t offset) {
  std::mt19937_64 random(seed() + offset);
  std::uniform_real_distribution<T> number(-8, 8);
  const auto point = [&] {
    const T x = number(random);
    return Point<T>(x, number(random));
  };
  double worst_point = 0, worst_inverse = 0;
  int cases = 0, inverses = 0;
  for (; cases < 1500; ++cases) {
    const ExactScope scope;
    const Factor<T> f{{point(), point()}, point(), point()};
    const Point<T> p = point();
    const Matrix<T> m = matrix(f);
    Matrix<Exact> e;
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 3; ++y) e[x][y] = Exact(m[x][y]);
    }
    const ExactVec2 q = transform(e, ExactVec2(Exact(p.x), Exact(p.y)));
    const Point<T> to = transform(m, p);
    for (int i = 0; i < 2; ++i) {
      const double terms =
          std::abs(double(m[0][i] * p.x)) + std::abs(double(m[1][i] * p.y)) + std::abs(double(m[2][i]));
      worst_point = std::max(worst_point, to_double(abs(Exact(to[i]) - q[i])) / (terms * ulp<T>));
    }
    const auto back = inverse(m);
    const auto exact_back = inverse(e);
    if (!back) continue;
    ASSERT_TRUE(exact_back.has_value());
    ++inverses;
    const double xx = std::abs(double(m[0].x) * double(m[1].y)),
                 xy = std::abs(double(m[1].x) * double(m[0].y));
    const double cancels = (xx + xy) / std::abs(to_double(determinant(e)));
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 2; ++y) {
        const double terms = x < 2 ? std::abs(to_double((*exact_back)[x][y]))
                                   : std::abs(to_double((*exact_back)[0][y]) * double(m[2].x)) +
                                         std::abs(to_double((*exact_back)[1][y]) * double(m[2].y));
        const double error = to_double(abs(Exact((*back)[x][y]) - (*exact_back)[x][y]));
        worst_inverse = std::max(worst_inverse, error / (terms * cancels * ulp<T>));
      }
    }
  }
  std::printf("worst, in ulp of the terms: point %.2f, inverse %.2f\n", worst_point, worst_inverse);
  EXPECT_EQ(cases, 1500);
  EXPECT_GE(inverses, 1450);
  EXPECT_GT(worst_point, 0.1);
  EXPECT_LE(worst_point, 3);
  EXPECT_GT(worst_inverse, 0.1);
  EXPECT_LE(worst_inverse, 4);
}

/// Entries of all sizes, up to the bounds of plain arithmetic and just beyond, zeros of both signs, and
/// determinants that cancel: plain numbers give the bits that numbers without bounds to their exponents do.
template <class T>
void compare_inverses(int bound, std::uint64_t offset) {
  std::mt19937_64 random(seed() + offset);
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  const auto entry = [&](int size) {
    if (below(12) == 0) return below(2) ? T(0) : -T(0);
    const int exponent = std::clamp(size + below(9) - 4, -bound - 1, bound);
    const T x = std::ldexp(std::uniform_real_distribution<T>(1, 2)(random), exponent);
    return below(2) ? x : -x;
  };
  const auto bits_of = [](const std::optional<Matrix<T>>& m) {
    std::vector<std::pair<T, bool>> bits;
    for (int k = 0; m && k < 6; ++k) {
      const T x = (*m)[k / 2][k % 2];
      bits.emplace_back(x, std::signbit(x));
    }
    return bits;
  };
  int plain = 0, none = 0, cancels = 0;
  for (int i = 0; i < 100'000; ++i) {
    const bool of_one_size = below(2) == 0;
    const int size = below(2 * bound + 3) - bound - 1;
    Matrix<T> m(T(1));
    for (int k = 0; k < 6; ++k) {
      m[k / 2][k % 2] = entry(of_one_size ? size : below(2 * bound + 3) - bound - 1);
    }
    if (below(4) == 0) {
      // The second column nearly along the first
      m[1].x = m[0].x;
      m[1].y = m[0].y * (1 + T(below(64) - 32) * std::numeric_limits<T>::epsilon());
      ++cancels;
    }
    const auto back = inverse(m);
    ASSERT_EQ(bits_of(back), bits_of(detail::inverse_in(m, detail::Boundless{}))) << i << ", seed " << seed();
    ASSERT_TRUE(!flattens(glm::mat<2, 2, T>(m)) || !back);
    plain += detail::are_moderate<T>(m[0].x, m[0].y, m[1].x, m[1].y, m[2].x, m[2].y);
    none += !back;
  }
  std::printf("%d of 100000 in plain numbers, %d cancel, %d have no inverse\n", plain, cancels, none);
  EXPECT_GE(plain, 50'000);
  EXPECT_LE(plain, 99'900);
  EXPECT_GE(cancels, 20'000);
  EXPECT_GE(none, 1000);
}

TEST(Affine2dProperty, PlainInversesHaveTheBitsOfThoseWithoutBounds) {
  compare_inverses<double>(240, 6);
  compare_inverses<float>(24, 7);
}

TEST(Affine2dProperty, ErrorsInDouble) { measure_errors<double>(4); }
TEST(Affine2dProperty, ErrorsInFloat) { measure_errors<float>(5); }

TEST(Affine2dProperty, LocalCoordinatesAreRightWhereTheMatrixIsNot) {
  std::mt19937_64 random(seed() + 6);
  std::uniform_real_distribution<double> angle(0, 360), small(-1, 1);
  double worst_local = 0, worst_matrix = 0;
  int cases = 0;
  for (; cases < 1000; ++cases) {
    const double c = std::ldexp(1, 20 + cases % 20);  // 2^20 to 2^39
    const dvec2 pivot{c, -c};
    const dvec2 offset{std::ldexp(std::floor(small(random) * 1024), -10),
                       std::ldexp(std::floor(small(random) * 1024), -10)};
    const auto f = rotation(turn_degrees(angle(random)), pivot);
    const ExactScope scope;
    const ExactVec2 e = transform(exact(rotation(turn_of(f.linear[0].y, f.linear[0].x))),
                                  ExactVec2(Exact(offset.x), Exact(offset.y)));
    std::vector<dvec2> local{pivot + offset}, by_matrix = local;
    local_coordinates(pivot, std::span<const Factor<double>>(&f, 1), std::span(local));
    one_matrix(std::span<const Factor<double>>(&f, 1), std::span(by_matrix));
    for (int i = 0; i < 2; ++i) {
      worst_local = std::max(worst_local, to_double(abs(Exact(local[0][i]) - e[i])));
      worst_matrix = std::max(worst_matrix, to_double(abs(Exact(by_matrix[0][i]) - Exact(pivot[i]) - e[i])));
    }
  }
  std::printf("worst error: local %.3g, matrix %.3g\n", worst_local, worst_matrix);
  EXPECT_EQ(cases, 1000);
  EXPECT_LE(worst_local, 2 * ulp<double>);
  EXPECT_GE(worst_matrix, 1e-5);
}

TEST(Affine2dProperty, AMendedRotationIsOrthogonal) {
  std::mt19937_64 random(seed() + 7);
  std::uniform_real_distribution<double> angle(-10, 10), drift(-1e-3, 1e-3);
  double worst = 0;
  int cases = 0;
  for (; cases < 1000; ++cases) {
    Matrix<double> m = matrix(rotation(turn(angle(random))));
    for (int i = 0; i < 4; ++i) m[i / 2][i % 2] += drift(random);
    const Matrix<double> r = nearest_rotation(m);
    const ExactScope scope;
    const Exact c(r[0].x), s(r[0].y);
    EXPECT_EQ(r[1].x, -r[0].y);
    worst = std::max(worst, to_double(abs(c * c + s * s - Exact(1))));
    EXPECT_NEAR(r[0].x, m[0].x, 2e-3);
  }
  EXPECT_EQ(cases, 1000);
  EXPECT_LE(worst, 2 * ulp<double>);
}

}  // namespace
}  // namespace gradus::affine_2d
