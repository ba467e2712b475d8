// Segments and circles against integers of any size and 200-bit roots; the reverse; the textbook's error.

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "stress/clipping/circle_ends.hpp"
#include "stress/clipping/circle_scales.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::liang_barsky_circle {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2, void, std::int32_t>>;

/// What is right: decided with rationals, points with one root of 200 bits.
struct Oracle {
  Rational ax, ay, dx, dy, fx, fy, r, A, B, C, k, D;

  template <class T>
  Oracle(const Segment<2, T>& s, const Circle<T>& c)
      : ax(s.a.x),
        ay(s.a.y),
        dx(Rational(s.b.x) - ax),
        dy(Rational(s.b.y) - ay),
        fx(ax - Rational(c.centre.x)),
        fy(ay - Rational(c.centre.y)),
        r(c.radius),
        A(dx * dx + dy * dy),
        B(fx * dx + fy * dy),
        C(fx * fx + fy * fy - r * r),
        k(dx * fy - dy * fx),
        D(r * r * A - k * k) {}

  /// The side of the point at t = 1.
  int to_side() const { return Rational(A + 2 * B + C).sign(); }
  int from_side() const { return C.sign(); }

  /// Whether t = (-B +- sqrt(D)) / A, of both signs, have a stretch in common with 0 <= t <= 1; by squaring.
  bool hits() const {
    if (A == 0) return C <= 0;
    if (D < 0) return false;
    // enters <= 1: -B - sqrt(D) <= A; leaves >= 0: -B + sqrt(D) >= 0
    const Rational a = -B - A;
    const bool enters = a <= 0 || a * a <= D;
    const bool leaves = B <= 0 || B * B <= D;
    return enters && leaves;
  }

  /// The point where the line enters or leaves.
  void point(bool leaves, Wide& x, Wide& y) const {
    const Wide root = sqrt(Wide(D)), a(A);
    const Wide sign = leaves ? 1 : -1;
    // Foot and half chord apart, so that 200 bits suffice
    x = Wide(Rational(ax + -B / A * dx)) + sign * root * Wide(dx) / a;
    y = Wide(Rational(ay + -B / A * dy)) + sign * root * Wide(dy) / a;
  }
};

template <class T>
T ulp_of(T size) {
  return size < std::numeric_limits<T>::min()
             ? std::numeric_limits<T>::denorm_min()
             : std::nextafter(size, std::numeric_limits<T>::infinity()) - size;
}

/// In ulp of max(|coordinate|, r).
template <class T>
double error_of(T got, const Wide& right, T radius) {
  const T size = std::max(static_cast<T>(abs(right)), radius);
  return static_cast<double>(abs(Wide(got) - right) / Wide(ulp_of(size)));
}

/// Segments and circles of every kind: generic, nearly and exactly tangent, through integer points, ends on
/// the circle, far away, mixed sizes.
template <class T>
class Cases {
 public:
  Cases(std::uint64_t offset, int reach) : random_(test::seed() + offset), reach_(reach) {}

  struct Case {
    Segment<2, T> segment;
    Circle<T> circle;
  };

  Case next() {
    switch (random_.uniform_int(0, 7)) {
      case 0: {  // small integers: tangents, ends on the circle, points
        Case c{{whole(6), whole(6)}, {whole(3), static_cast<T>(random_.uniform_int(0, 6))}};
        return c;
      }
      case 1: {  // Pythagorean tangents, scaled: 3x + 4y = 25 and its like
        const T e = power(-20, 20);
        const T p = static_cast<T>(random_.uniform_int(1, 40)),
                q = static_cast<T>(random_.uniform_int(1, 40));
        return {{{(3 - 4 * p) * e, (4 + 3 * p) * e}, {(3 + 4 * q) * e, (4 - 3 * q) * e}}, {{0, 0}, 5 * e}};
      }
      case 2: {  // nearly tangent, and nudged
        Case c = generic(power(-5, 5));
        const auto n = normal(c.segment);
        const T along = unit();
        const auto on = c.segment.a + along * (c.segment.b - c.segment.a);
        c.circle.centre = on + c.circle.radius * n;
        c.circle.radius = nudged(c.circle.radius);
        return c;
      }
      case 3: {  // an end nearly on the circle
        Case c = generic(power(-5, 5));
        const auto d = c.segment.a - c.circle.centre;
        c.circle.radius = nudged(std::sqrt(d.x * d.x + d.y * d.y));
        return c;
      }
      case 4: {  // far ends
        Case c = generic(T(1));
        const T far = power(10, std::numeric_limits<T>::digits);
        c.segment.a = c.circle.centre + far * c.segment.a;
        c.segment.b = c.circle.centre - far * c.segment.b;
        if (random_.unit() < 0.5) c.segment.b.y = c.segment.a.y = c.circle.centre.y + unit();
        return c;
      }
      case 5: {  // a far and large circle
        Case c = generic(T(1));
        const T far = power(5, std::numeric_limits<T>::digits);
        c.circle.centre *= far;
        const auto d = c.segment.a - c.circle.centre;
        c.circle.radius = std::sqrt(d.x * d.x + d.y * d.y) + unit();
        return c;
      }
      case 6:  // every number of a size of its own
        return {{mixed(), mixed()}, {mixed(), std::abs(mixed().x)}};
      default:
        return generic(power(-reach_, reach_));
    }
  }
  T unit() { return static_cast<T>(random_.uniform(-1, 1)); }

 private:
  T power(int lowest, int highest) {
    return std::ldexp(T(1), static_cast<int>(random_.uniform_int(lowest, highest)));
  }
  glm::vec<2, T> whole(int most) {
    const T x = static_cast<T>(random_.uniform_int(-most, most));
    return {x, static_cast<T>(random_.uniform_int(-most, most))};
  }
  glm::vec<2, T> mixed() {
    const T x = unit() * power(-reach_, reach_);
    return {x, unit() * power(-reach_, reach_)};
  }
  glm::vec<2, T> point(T size) {
    const T x = 2 * unit() * size;
    return {x, 2 * unit() * size};
  }
  Case generic(T size) {
    Case c;
    c.segment.a = point(size);
    c.segment.b = point(size);
    c.circle.centre = point(size) * T(0.5);
    c.circle.radius = std::abs(unit()) * size;
    return c;
  }
  glm::vec<2, T> normal(const Segment<2, T>& s) {
    const auto d = s.b - s.a;
    const T length = std::sqrt(d.x * d.x + d.y * d.y);
    return {-d.y / length, d.x / length};
  }
  T nudged(T x) {
    for (std::int64_t i = random_.uniform_int(0, 3); i > 0; --i)
      x = std::nextafter(x, random_.unit() < 0.5 ? T(0) : std::numeric_limits<T>::max());
    return x;
  }
  Random random_;
  int reach_;
};

struct Counts {
  int inside = 0, cut = 0, missed = 0, touched = 0, doubtful = 0;
  double worst = 0;
};

template <class T>
void expect_right(const typename Cases<T>::Case& given, Counts& counts) {
  const auto& [s, c] = given;
  const Oracle right(s, c);
  ASSERT_EQ(side(in_double(s).a, in_double(c)), right.from_side());
  ASSERT_EQ(side(in_double(s).b, in_double(c)), right.to_side());
  if (right.A != 0) ASSERT_EQ(reach(in_double(s), in_double(c)), right.D.sign());
  const auto kept = exact_decision(s, c);
  ASSERT_EQ(kept.has_value(), right.hits());
  // The reverse, bit for bit
  const auto back = exact_decision(Segment<2, T>{s.b, s.a}, c);
  ASSERT_EQ(back.has_value(), kept.has_value());
  if (!kept) {
    ++counts.missed;
    return;
  }
  ASSERT_EQ(back->a, kept->b);
  ASSERT_EQ(back->b, kept->a);
  counts.touched += kept->a == kept->b;
  if (right.from_side() <= 0) ASSERT_EQ(kept->a, s.a);
  if (right.to_side() <= 0) ASSERT_EQ(kept->b, s.b);
  if (right.from_side() <= 0 && right.to_side() <= 0) {
    ++counts.inside;
    return;
  }
  ++counts.cut;
  counts.doubtful += !line_by_pairs(in_double(s), in_double(c)).has_value();
  for (const bool leaves : {false, true}) {
    if ((leaves ? right.to_side() : right.from_side()) <= 0) continue;
    const auto got = leaves ? kept->b : kept->a;
    Wide x, y;
    right.point(leaves, x, y);
    const double error = std::max(error_of(got.x, x, c.radius), error_of(got.y, y, c.radius));
    counts.worst = std::max(counts.worst, error);
    ASSERT_LE(error, 0.63);
    ASSERT_LE(std::min(s.a.x, s.b.x), got.x);
    ASSERT_LE(got.x, std::max(s.a.x, s.b.x));
    ASSERT_LE(std::min(s.a.y, s.b.y), got.y);
    ASSERT_LE(got.y, std::max(s.a.y, s.b.y));
  }
}

template <class T>
Counts run_cases(std::uint64_t offset, int reach, int count) {
  Cases<T> cases(offset, reach);
  Counts counts;
  for (int i = 0; i < count; ++i) {
    const auto given = cases.next();
    SCOPED_TRACE(testing::Message() << std::hexfloat << "case " << i << ": " << given.segment.a.x << ","
                                    << given.segment.a.y << " " << given.segment.b.x << ","
                                    << given.segment.b.y << " circle " << given.circle.centre.x << ","
                                    << given.circle.centre.y << "," << given.circle.radius);
    expect_right<T>(given, counts);
    if (testing::Test::HasFatalFailure()) return counts;
  }
  EXPECT_EQ(counts.inside + counts.cut + counts.missed, count);
  EXPECT_GE(counts.inside, count / 20);
  EXPECT_GE(counts.cut, count / 10);
  EXPECT_GE(counts.missed, count / 10);
  EXPECT_GE(counts.touched, count / 100);
  EXPECT_GE(counts.doubtful, counts.cut / 10) << "the slow path";
  std::printf("inside %d, cut %d (%d in doubt), missed %d, points %d, worst %.3f ulp\n", counts.inside,
              counts.cut, counts.doubtful, counts.missed, counts.touched, counts.worst);
  return counts;
}

TEST(LiangBarskyCircleProperty, DoubleAgainstExactArithmetic) {
  const int count = static_cast<int>(test::cases(20'000, 1'000'000));
  run_cases<double>(1, 60, count);
}

TEST(LiangBarskyCircleProperty, FloatAgainstExactArithmetic) {
  const int count = static_cast<int>(test::cases(20'000, 1'000'000));
  run_cases<float>(2, 30, count);
}

TEST(LiangBarskyCircleProperty, WholeRangeOfDouble) {
  const int count = static_cast<int>(test::cases(3'000, 100'000));
  run_cases<double>(3, 1000, count);
}

/// Sizes from 2^-1074 to 2^1023 that have nothing to do with each other, in one input: every decision against
/// rationals, every point against 2500 bits, and the reverse.
TEST(LiangBarskyCircleProperty, MixedSizesAgainstExactArithmetic) {
  Random random(test::seed() + 11);
  const int count = static_cast<int>(test::cases(3'000, 200'000));
  int kept = 0, cut = 0, touched = 0, underflows = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const stress::Input n = stress::of_mixed_sizes(random);
    SCOPED_TRACE(testing::Message() << "case " << i << ": " << fmt::format("{:a}", fmt::join(n, ",")));
    const Segment<2, double> s{{n[0], n[1]}, {n[2], n[3]}};
    const Circle<double> c{{n[4], n[5]}, n[6]};
    const Oracle right(s, c);
    ASSERT_EQ(side(s.a, c), right.from_side());
    ASSERT_EQ(side(s.b, c), right.to_side());
    ASSERT_EQ(past_foot(s.a, s, c.centre), right.B.sign());
    if (right.A != 0) ASSERT_EQ(reach(s, c), right.D.sign());
    const auto ends = stress::ends_in_circle(n);
    const auto got = exact_decision(s, c), back = exact_decision(Segment<2, double>{s.b, s.a}, c);
    ASSERT_EQ(got.has_value(), ends.has_value());
    ASSERT_EQ(back.has_value(), got.has_value());
    underflows += n[6] * n[6] == 0 || (right.A != 0 && quadratic(s, c).A == 0);
    if (!got) continue;
    ++kept;
    cut += !ends->from_is_given || !ends->to_is_given;
    touched += got->a == got->b;
    ASSERT_EQ(got->a, back->b);
    ASSERT_EQ(got->b, back->a);
    const double error = std::max(ends->from.error(got->a), ends->to.error(got->b));
    worst = std::max(worst, error);
    ASSERT_LE(error, 0.63);
  }
  std::printf("%d of %d kept, %d cut, %d points, %d with squares that underflow, worst %.3f ulp\n", kept,
              count, cut, touched, underflows, worst);
  EXPECT_GE(kept, count / 4);
  EXPECT_GE(cut, count / 4);
  EXPECT_GE(touched, count / 20);
  EXPECT_GE(underflows, count / 10);
}

/// D, A, B, C and the sides are rational: the same template in Exact decides as the filters do.
TEST(LiangBarskyCircleProperty, TheQuadraticInExactDecidesTheSame) {
  Cases<double> cases(4, 60);
  int touching = 0;
  constexpr int count = 3000;
  for (int i = 0; i < count; ++i) {
    const ExactScope scope;
    const auto [s, c] = cases.next();
    const auto e = [](dvec2 p) { return ExactVec2(Exact(p.x), Exact(p.y)); };
    const Quadratic<Exact> q =
        quadratic(Segment<2, Exact>{e(s.a), e(s.b)}, Circle<Exact>{e(c.centre), Exact(c.radius)});
    ASSERT_EQ(sign(q.D), q.A == Exact{} ? 0 : reach(s, c)) << i;
    ASSERT_EQ(sign(q.C), side(s.a, c)) << i;
    ASSERT_EQ(sign(q.B), past_foot(s.a, s, c.centre)) << i;
    ASSERT_EQ(q.B * q.B - q.A * q.C, q.D) << i;
    touching += sign(q.D) == 0;
  }
  EXPECT_GE(touching, count / 50);
}

/// What the taught form and the notes' make of random segments: the numbers in the header of half_chord and
/// on the topic's page, of the seed that they name, whatever GRADUS_SEED is.
TEST(LiangBarskyCircleProperty, ErrorsOfTheTextbookForms) {
  Random random(20240611 + 5);
  const int count = 20'000;
  int compared = 0, wrong_taught = 0, wrong_notes = 0, above = 0;
  double worst_taught = 0, worst_notes = 0;
  for (int i = 0; i < count; ++i) {
    double n[7];
    for (double& x : n) x = random.uniform(-10, 10);
    const Segment<2, double> s{{n[0], n[1]}, {n[2], n[3]}};
    const Circle<double> c{{n[4] / 2, n[5] / 2}, std::abs(n[6])};
    const auto right = exact_decision(s, c), taught = half_chord(s, c),
               notes = discriminant_equals_zero(s, c);
    wrong_taught += right.has_value() != taught.has_value();
    wrong_notes += right.has_value() != notes.has_value();
    if (!right) continue;
    const auto error = [&](const std::optional<Segment<2, double>>& got) {
      double most = 0;
      if (!got) return most;
      for (const auto& [a, b] : {std::pair{got->a, right->a}, std::pair{got->b, right->b}}) {
        for (const int axis : {0, 1}) {
          most = std::max(most, error_of(a[axis], Wide(b[axis]), c.radius));
        }
      }
      return most;
    };
    ++compared;
    above += error(taught) > 1;
    worst_taught = std::max(worst_taught, error(taught));
    worst_notes = std::max(worst_notes, error(notes));
  }
  std::printf("%d kept; half_chord: %d decided wrongly, %d above 1 ulp, worst %.0f; notes: %d, worst %.0f\n",
              compared, wrong_taught, above, worst_taught, wrong_notes, worst_notes);
  EXPECT_EQ(compared, 10'378);
  EXPECT_EQ(wrong_taught, 0);
  EXPECT_EQ(std::lround(100.0 * above / compared), 24);
  EXPECT_EQ(std::lround(worst_taught), 29);
  EXPECT_EQ(std::lround(worst_notes), 629);
}

/// 30,000 lines tangent by construction: rounding says anything, exact arithmetic what is.
TEST(LiangBarskyCircleProperty, TangencyIsDecidedByRounding) {
  Random random(test::seed() + 6);
  int sign_of_D[3] = {0, 0, 0}, wrong = 0;
  const int count = 30'000;
  for (int i = 0; i < count; ++i) {
    // The tangent at the angle of (x, y), |(x, y)| = r rounded
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double r = std::sqrt(x * x + y * y), a = random.uniform(1, 3), b = random.uniform(1, 3);
    const Segment<2, double> s{{x - a * y, y + a * x}, {x + b * y, y - b * x}};
    const Circle<double> c{{0, 0}, r};
    const auto d = s.b - s.a;
    const double B = 2 * (s.a.x * d.x + s.a.y * d.y), A = d.x * d.x + d.y * d.y;
    const double D = B * B - 4 * A * (s.a.x * s.a.x + s.a.y * s.a.y - r * r);
    ++sign_of_D[(D > 0) - (D < 0) + 1];
    wrong += ((D > 0) - (D < 0)) != Oracle(s, c).D.sign();
    ASSERT_EQ(reach(s, c), Oracle(s, c).D.sign());
  }
  std::printf("D < 0 %d, = 0 %d, > 0 %d; %d other than exact\n", sign_of_D[0], sign_of_D[1], sign_of_D[2],
              wrong);
  for (const int n : sign_of_D) EXPECT_GE(n, count / 10);
  EXPECT_GE(wrong, count / 4);
}

// --- Many at once ---------------------------------------------------------------------------------------

// Runs `test` once for every kind of machine that this one can be
template <class Test>
int on_every_target(Test test) {
  int targets = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    test();
    ++targets;
  }
  hwy::SetSupportedTargetsForTest(0);
  return targets;
}

bool same_bits(const Segment<2, double>& a, const Segment<2, double>& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return same(a.a.x, b.a.x) && same(a.a.y, b.a.y) && same(a.b.x, b.b.x) && same(a.b.y, b.b.y);
}

/// Segments for one circle: round it, tangent to it or 1 ulp beside, with ends on it, inside, points, through
/// its centre, with far ends, on a grid, of any size.
class Round {
 public:
  explicit Round(std::uint64_t offset) : random_(test::seed() + offset) {}

  static constexpr int kinds = 9;
  Segment<2, double> next(int kind, const Circle<double>& c) {
    const double r = c.radius;
    const dvec2 n = direction(), along(-n.y, n.x);
    switch (kind) {
      case 0:
        return {c.centre + 3 * r * unit(), c.centre + 3 * r * unit()};
      case 1: {  // tangents, by rounding
        const dvec2 foot = c.centre + r * n;
        return nudged(
            {foot - r * random_.uniform(-0.1, 3) * along, foot + r * random_.uniform(0, 3) * along});
      }
      case 2:  // along a coordinate, where tangents are exact
        return nudged({{c.centre.x - 2 * r, c.centre.y + r}, {c.centre.x + 2 * r, c.centre.y + r}});
      case 3: {  // an end on the circle
        const dvec2 on = random_.unit() < 0.3 ? c.centre + dvec2(0, r) : c.centre + r * n;
        return nudged({on, c.centre + 2 * r * unit()});
      }
      case 4:
        return {c.centre + 0.7 * r * unit(), c.centre + 0.7 * r * unit()};
      case 5: {
        const dvec2 p = nudged({c.centre + random_.uniform(0, 2) * r * n, {}}).a;
        return {p, p};
      }
      case 6:
        return {c.centre - 4 * r * n, c.centre + random_.uniform(0, 4) * r * n};
      case 7: {  // far ends
        const double far = std::ldexp(r, static_cast<int>(random_.uniform_int(5, 60)));
        return {c.centre + r * unit() - far * along, c.centre + r * unit() + far * along};
      }
      default: {  // a grid as fine as a fifth of the circle's size
        const double e = std::ldexp(1.0, r > 0 ? std::ilogb(r) - 2 : 0);
        const auto whole = [&] { return static_cast<double>(random_.uniform_int(-10, 10)) * e; };
        const double x = whole(), y = whole(), z = whole();
        return {{x, y}, {z, whole()}};
      }
    }
  }

 private:
  dvec2 unit() {
    const double x = random_.uniform(-1, 1);
    return {x, random_.uniform(-1, 1)};
  }
  dvec2 direction() {
    const dvec2 p = unit();
    return p / std::sqrt(p.x * p.x + p.y * p.y);
  }
  Segment<2, double> nudged(Segment<2, double> s) {
    for (double* x : {&s.a.x, &s.a.y, &s.b.x, &s.b.y}) {
      const double to = random_.unit() < 0.5 ? -HUGE_VAL : HUGE_VAL;
      if (random_.unit() < 0.2 && std::abs(*x) < 1e308) *x = std::nextafter(*x, to);
    }
    return random_.unit() < 0.5 ? s : Segment<2, double>{s.b, s.a};
  }
  Random random_;
};

bool finite(const Segment<2, double>& s) {
  return std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x) && std::isfinite(s.b.y);
}

struct BatchCases {
  std::int64_t ran = 0, accepted = 0, cut = 0, one_by_one = 0;
};

// Compares a batch with exact_decision, and clips in place too
void expect_same(std::vector<Segment<2, double>> segments, const Circle<double>& c, BatchCases& counts) {
  const std::size_t size = segments.size();
  std::vector<Segment<2, double>> clipped(size);
  std::vector<std::uint8_t> accepted(size), again(size);
  const BatchCount count = clip_batch(segments, c, clipped, accepted);
  ASSERT_EQ(count.accepted, static_cast<std::size_t>(std::count(accepted.begin(), accepted.end(), 1)));
  ASSERT_LE(count.one_by_one, size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto right = exact_decision(segments[i], c);
    ASSERT_EQ(accepted[i], right.has_value()) << "segment " << i;
    ASSERT_TRUE(same_bits(clipped[i], right ? *right : segments[i])) << "segment " << i;
    counts.cut += right && !same_bits(*right, segments[i]);
  }
  counts.ran += static_cast<std::int64_t>(size);
  counts.accepted += static_cast<std::int64_t>(count.accepted);
  counts.one_by_one += static_cast<std::int64_t>(count.one_by_one);
  clip_batch(segments, c, segments, again);
  ASSERT_EQ(again, accepted);
  for (std::size_t i = 0; i < size; ++i) ASSERT_TRUE(same_bits(segments[i], clipped[i]));
}

TEST(LiangBarskyCircleProperty, TheBatchHasTheBitsOfTheScalarMethodOnEveryTarget) {
  BatchCases counts;
  const int rounds = static_cast<int>(test::cases(1500, 50'000));
  const int targets = on_every_target([&] {
    Cases<double> near(7, 60), any(8, 1000);
    Round round_it(9);
    for (int round = 0; round < rounds; ++round) {
      SCOPED_TRACE(testing::Message() << "GRADUS_SEED=" << test::seed() << " round " << round);
      auto first = (round % 4 == 3 ? any : near).next();
      if (round % 16 == 5) first.circle.radius = 0;
      if (round % 16 == 9) first.circle.centre = {0, 0};
      // Numbers of segments that leave a rest, or none
      std::vector<Segment<2, double>> segments;
      const auto add = [&](const Segment<2, double>& s) {
        if (finite(s)) segments.push_back(s);
      };
      add(first.segment);
      for (int i = 1; i < round % 23; ++i) add(round_it.next((round + i) % Round::kinds, first.circle));
      if (round % 23 == 0) segments.clear();
      expect_same(segments, first.circle, counts);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  std::printf("%d targets, %lld segments: %lld accepted, %lld cut, %lld one by one\n", targets,
              static_cast<long long>(counts.ran), static_cast<long long>(counts.accepted),
              static_cast<long long>(counts.cut), static_cast<long long>(counts.one_by_one));
  EXPECT_GE(targets, 2);
  EXPECT_GE(counts.ran, 10LL * rounds * targets);
  EXPECT_GE(counts.accepted, counts.ran / 4);
  EXPECT_GE(counts.cut, counts.ran / 8);
  EXPECT_GE(counts.one_by_one, counts.ran / 10);
}

/// Circles beside which everything else is of another size.
TEST(LiangBarskyCircleProperty, TheBatchHasTheBitsOfTheScalarMethodForMixedSizes) {
  BatchCases counts;
  const int rounds = static_cast<int>(test::cases(1000, 50'000));
  const int targets = on_every_target([&] {
    Random random(test::seed() + 12);
    for (int round = 0; round < rounds; ++round) {
      // Beyond 2^150 all go one by one
      const stress::Sizes sizes = round % 8 == 0 ? stress::Sizes{} : stress::Sizes{-700, 148};
      const stress::Input n = stress::of_mixed_sizes(random, sizes);
      SCOPED_TRACE(testing::Message() << "round " << round << ": " << fmt::format("{:a}", fmt::join(n, ",")));
      const Segment<2, double> s{{n[0], n[1]}, {n[2], n[3]}};
      const Segment<2, double> up{{s.a.x, std::nextafter(s.a.y, HUGE_VAL)}, s.b};
      std::vector<Segment<2, double>> segments{s, {s.b, s.a}, {s.a, s.a}, up, {{0, 0}, s.b}, s, s, s};
      std::erase_if(segments, [](const Segment<2, double>& given) { return !finite(given); });
      expect_same(segments, {{n[4], n[5]}, n[6]}, counts);
      if (testing::Test::HasFatalFailure()) return;
    }
  });
  EXPECT_GE(counts.ran, 7LL * rounds * targets);
  EXPECT_GE(counts.cut, counts.ran / 8);
  EXPECT_GE(counts.ran - counts.one_by_one, counts.ran / 4) << "certified ones";
}

/// As a program would use it: what has no certificate is rare, but for ends 2^30 radii away and more.
TEST(LiangBarskyCircleProperty, NearlyEverySegmentOfABatchIsCertified) {
  Round round_it(10);
  const auto of_kind = [&](int kind, const Circle<double>& c) {
    std::vector<Segment<2, double>> segments(16'384);
    for (auto& s : segments) s = round_it.next(kind, c);
    return segments;
  };
  const Circle<double> near{{0.3, -0.2}, 5}, far{{1e6, -3e7}, 0.01};
  const std::vector<std::vector<Segment<2, double>>> sets{of_kind(0, near), of_kind(4, near),
                                                          of_kind(7, near), of_kind(0, far)};
  const Circle<double> circles[] = {near, near, near, far};
  const char* const names[] = {"random", "inside", "far ends", "random, far circle"};
  const int targets = on_every_target([&] {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      BatchCases counts;
      expect_same(sets[i], circles[i], counts);
      std::printf("%s: %lld of %lld cut, %lld one by one\n", names[i], static_cast<long long>(counts.cut),
                  static_cast<long long>(counts.ran), static_cast<long long>(counts.one_by_one));
      EXPECT_LE(counts.one_by_one, i == 2 ? counts.ran * 6 / 10 : counts.ran / 1000) << names[i];
      EXPECT_GE(counts.cut, i == 1 ? 0 : counts.ran / 4) << names[i];
    }
  });
  EXPECT_GE(targets, 2);
}

TEST(LiangBarskyCircleProperty, ABatchRefusesWhatTheScalarMethodRefuses) {
  on_every_target([&] {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Segment<2, double>> segments(9, Segment<2, double>{{1, 1}, {2, 2}}), clipped(9);
    std::vector<std::uint8_t> accepted(9);
    const Circle<double> five{{0, 0}, 5};
    EXPECT_EQ(clip_batch(segments, five, clipped, accepted).accepted, 9u);
    for (const std::size_t bad : {0u, 5u, 8u}) {
      for (int axis = 0; axis < 4; ++axis) {
        std::vector<Segment<2, double>> some = segments;
        (&some[bad].a.x)[axis] = axis % 2 ? std::nan("") : -infinity;
        EXPECT_THROW(clip_batch(some, five, clipped, accepted), ContractViolation);
      }
    }
    const Circle<double> no_circles[] = {
        {{0, 0}, -1}, {{0, 0}, std::nan("")}, {{0, 0}, infinity}, {{infinity, 0}, 1}, {{0, std::nan("")}, 1}};
    for (const auto& c : no_circles) {
      EXPECT_THROW(clip_batch(segments, c, clipped, accepted), ContractViolation);
      EXPECT_THROW(clip_batch({}, c, {}, {}), ContractViolation);
    }
    EXPECT_THROW(clip_batch(segments, five, std::span(clipped).first(8), accepted), ContractViolation);
    EXPECT_THROW(clip_batch(segments, five, clipped, std::span(accepted).first(8)), ContractViolation);
    EXPECT_EQ(clip_batch({}, five, {}, {}).accepted, 0u);
  });
}

}  // namespace
}  // namespace gradus::liang_barsky_circle
