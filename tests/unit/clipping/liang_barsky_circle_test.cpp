// Segments and circles of known result, the step grammar, what the notes' listings do, exact arithmetic.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clipping/liang_barsky_circle/liang_barsky_circle_batch.hpp"
#include "clipping/liang_barsky_circle/liang_barsky_circle_notes.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "support/hard_inputs.hpp"

namespace gradus::liang_barsky_circle {
namespace {

using S = Segment<2, double>;
using C = Circle<double>;
using Kept = std::optional<S>;

constexpr C unit{{0, 0}, 1};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

S segment(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

void expect_near(const Kept& kept, const S& right, double tolerance) {
  ASSERT_TRUE(kept);
  EXPECT_NEAR(kept->a.x, right.a.x, tolerance);
  EXPECT_NEAR(kept->a.y, right.a.y, tolerance);
  EXPECT_NEAR(kept->b.x, right.b.x, tolerance);
  EXPECT_NEAR(kept->b.y, right.b.y, tolerance);
}

TEST(LiangBarskyCircle, GoldenSegments) {
  // G001-59, 61, 62, 63, 65, 66
  const std::pair<S, S> kept[] = {
      {segment(-3, 0, 3, 0), segment(-1, 0, 1, 0)}, {segment(0, 0, 0.5, 0), segment(0, 0, 0.5, 0)},
      {segment(-2, 1, 2, 1), segment(0, 1, 0, 1)},  {segment(0.5, 0, 0.5, 0), segment(0.5, 0, 0.5, 0)},
      {segment(1, 0, 2, 0), segment(1, 0, 1, 0)},   {segment(0, 0, 2, 0), segment(0, 0, 1, 0)},
  };
  for (const auto& [given, right] : kept) {
    EXPECT_EQ(exact_decision(given, unit), right) << given.a.x;
    expect_near(half_chord(given, unit), right, 1e-15);
  }
  // G001-60, 64: nothing
  for (const S& given : {segment(2, 0, 3, 0), segment(5, 0, 5, 0)}) {
    EXPECT_FALSE(exact_decision(given, unit));
    EXPECT_FALSE(half_chord(given, unit));
  }
}

TEST(LiangBarskyCircle, DiscriminantAndBothValuesOfEveryGoldenSegment) {
  // G001-59 to 68: D = r^2 A - k^2, t1, t2 and the part that is kept; the notes' B^2 - 4AC is 4 D
  struct Golden {
    S given;
    double D;
    std::optional<std::pair<double, double>> t;  ///< none for a point and for a line that misses
    Kept kept;
  };
  const double far = std::sqrt(3.0) / 4e8;
  const Golden goldens[] = {
      {segment(-3, 0, 3, 0), 36, {{1.0 / 3, 2.0 / 3}}, segment(-1, 0, 1, 0)},
      {segment(2, 0, 3, 0), 1, {{-3, -1}}, {}},
      {segment(0, 0, 0.5, 0), 0.25, {{-2, 2}}, segment(0, 0, 0.5, 0)},
      {segment(-2, 1, 2, 1), 0, {{0.5, 0.5}}, segment(0, 1, 0, 1)},
      {segment(0.5, 0, 0.5, 0), 0, {}, segment(0.5, 0, 0.5, 0)},
      {segment(5, 0, 5, 0), 0, {}, {}},
      {segment(1, 0, 2, 0), 1, {{-2, 0}}, segment(1, 0, 1, 0)},
      {segment(0, 0, 2, 0), 4, {{-0.5, 0.5}}, segment(0, 0, 1, 0)},
      {segment(-1e8, 0.5, 1e8, 0.5),
       3e16,
       {{0.5 - far, 0.5 + far}},
       segment(-0.8660254037844386, 0.5, 0.8660254037844386, 0.5)},
      {segment(-1e8, 1.0000001, 1e8, 1.0000001), -8.0000004e9, {}, {}},
  };
  for (const auto& [given, D, t, right] : goldens) {
    SCOPED_TRACE(testing::PrintToString(given.a.x) + " to " + testing::PrintToString(given.b.x));
    Recorder<Started<double>, Measured<double>, Crossed<double>, Limited<double>, Finished<double>> seen;
    const Kept kept = half_chord(given, unit, seen);
    const auto measured = all<Measured<double>>(seen);
    ASSERT_EQ(measured.size(), 1u);
    EXPECT_NEAR(measured[0].D, D, 1e-6 * std::abs(D));
    const auto crossed = all<Crossed<double>>(seen);
    ASSERT_EQ(crossed.size(), t ? 1u : 0u);
    if (t) {
      EXPECT_NEAR(crossed[0].enters, t->first, 1e-15);
      EXPECT_NEAR(crossed[0].leaves, t->second, 1e-15);
    }
    ASSERT_EQ(kept.has_value(), right.has_value());
    if (right) expect_near(kept, *right, std::abs(given.a.x) > 1e6 ? 1e-8 : 1e-15);
    EXPECT_EQ(exact_decision(given, unit).has_value(), right.has_value());
  }
}

TEST(LiangBarskyCircle, FarEndsCancelNothing) {
  // G001-67 and 68
  const S far = segment(-1e8, 0.5, 1e8, 0.5);
  EXPECT_EQ(exact_decision(far, unit), segment(-0.8660254037844386, 0.5, 0.8660254037844386, 0.5));
  expect_near(half_chord(far, unit), segment(-0.8660254037844386, 0.5, 0.8660254037844386, 0.5), 1e-8);
  const S past = segment(-1e8, 1.0000001, 1e8, 1.0000001);
  EXPECT_FALSE(exact_decision(past, unit));
  EXPECT_FALSE(half_chord(past, unit));
  const S near = segment(-1e6, 0.999, 1e6, 0.999);
  const double half = std::sqrt((1 - 0.999) * (1 + 0.999));
  expect_near(exact_decision(near, unit), segment(-half, 0.999, half, 0.999), 1e-16);
  expect_near(half_chord(near, unit), segment(-half, 0.999, half, 0.999), 2e-10);
}

TEST(LiangBarskyCircle, Grazing) {
  const double above = 1 + 0x1p-52, below = 1 - 0x1p-53;
  EXPECT_FALSE(exact_decision(segment(-2, above, 2, above), unit));
  // 1 - (1 - 2^-53)^2 = 2^-52 - 2^-106
  const double half = 0x1p-26;
  expect_near(exact_decision(segment(-2, below, 2, below), unit), segment(-half, below, half, below), 1e-24);
  // The notes' arithmetic can't see either
  const Kept touching = discriminant_equals_zero(segment(-2, above, 2, above), unit);
  ASSERT_TRUE(touching);
  EXPECT_EQ(touching->a, dvec2(0, above));
}

TEST(LiangBarskyCircle, TangentsFromInsideAndOutside) {
  EXPECT_EQ(exact_decision(segment(-2, -1, 2, -1), unit), segment(0, -1, 0, -1));
  EXPECT_EQ(exact_decision(segment(-1, -5, -1, 7), unit), segment(-1, 0, -1, 0));
  // The x axis touches the circle of radius 3 round (0, 3)
  EXPECT_EQ(exact_decision(segment(-4, 0, 9, 0), C{{0, 3}, 3}), segment(0, 0, 0, 0));
  // A tangent that is not parallel to an axis: 3x + 4y = 25 touches the circle of radius 5 at (3, 4)
  EXPECT_EQ(exact_decision(segment(-1, 7, 7, 1), C{{0, 0}, 5}), segment(3, 4, 3, 4));
  // It ends before it touches
  EXPECT_FALSE(exact_decision(segment(7, 1, 5, 2.5), C{{0, 0}, 5}));
  // It ends where it touches
  EXPECT_EQ(exact_decision(segment(7, 1, 3, 4), C{{0, 0}, 5}), segment(3, 4, 3, 4));
}

TEST(LiangBarskyCircle, PointsOfFiveByThreeByFour) {
  const struct {
    S given;
    C circle;
    S kept;
  } known[] = {
      // A chord between points of the circle stays as it is
      {segment(3, 4, -4, 3), {{0, 0}, 5}, segment(3, 4, -4, 3)},
      // From a point of the circle away from it, to such a point, and through it
      {segment(3, 4, 6, 8), {{0, 0}, 5}, segment(3, 4, 3, 4)},
      {segment(6, 8, 3, 4), {{0, 0}, 5}, segment(3, 4, 3, 4)},
      {segment(3, 4, -6, -8), {{0, 0}, 5}, segment(3, 4, -3, -4)},
      {segment(3, 4, 3, -8), {{0, 0}, 5}, segment(3, 4, 3, -4)},
      // Points with round coordinates come out round
      {segment(-9, -3, 7, 9), {{0, 0}, 5}, segment(-5, 0, 1.4, 4.8)},
      {segment(-6, -3, 10, 9), {{3, 0}, 5}, segment(-2, 0, 4.4, 4.8)},
      {segment(-9, 2, 7, 14), {{0, 5}, 5}, segment(-5, 5, 1.4, 9.8)},
      // At the end of the range, too
      {segment(-1e300, 3e299, 1e300, 3e299), {{0, 0}, 5e299}, segment(-4e299, 3e299, 4e299, 3e299)},
  };
  for (const auto& [given, circle, kept] : known) EXPECT_EQ(exact_decision(given, circle), kept) << given.b.x;
}

TEST(LiangBarskyCircle, RadiusZeroIsItsCentre) {
  const C point{{2, 1}, 0};
  EXPECT_EQ(exact_decision(segment(0, 0, 4, 2), point), segment(2, 1, 2, 1));
  EXPECT_EQ(exact_decision(segment(2, 1, 2, 1), point), segment(2, 1, 2, 1));
  EXPECT_EQ(exact_decision(segment(2, 1, 4, 2), point), segment(2, 1, 2, 1));
  EXPECT_FALSE(exact_decision(segment(0, 0, 4, 2.0000000001), point));
  EXPECT_FALSE(exact_decision(segment(2, 2, 2, 2), point));
  EXPECT_EQ(half_chord(segment(2, 1, 2, 1), point), segment(2, 1, 2, 1));
}

TEST(LiangBarskyCircle, MistakesAreRefusedByName) {
  const S any = segment(0, 0, 1, 1);
  for (const double r : {-1.0, nan, infinity, -infinity}) {
    EXPECT_THROW(half_chord(any, C{{0, 0}, r}), ContractViolation);
    EXPECT_THROW(exact_decision(any, C{{0, 0}, r}), ContractViolation);
  }
  for (const double x : {nan, infinity}) {
    EXPECT_THROW(exact_decision(any, C{{x, 0}, 1}), ContractViolation);
    EXPECT_THROW(exact_decision(segment(0, x, 1, 1), unit), ContractViolation);
    EXPECT_THROW(half_chord(segment(0, 0, 1, x), unit), ContractViolation);
  }
  try {
    exact_decision(any, C{{0, 0}, -1});
    FAIL();
  } catch (const ContractViolation& e) {
    EXPECT_STREQ(e.what(), "the circle's radius is finite and not negative, not -1");
  }
  // The notes' listings square it
  EXPECT_EQ(without_empty_test(segment(-3, 0, 3, 0), C{{0, 0}, -1}), segment(-1, 0, 1, 0));
}

TEST(LiangBarskyCircle, BatchesOfOneLength) {
  const std::vector<S> segments(9, segment(1, 1, 2, 2));
  std::vector<S> clipped(9);
  std::vector<std::uint8_t> accepted(9);
  const C five{{0, 0}, 5};
  EXPECT_EQ(clip_batch(segments, five, clipped, accepted).accepted, 9u);
  EXPECT_EQ(clip_batch({}, five, {}, {}).accepted, 0u);
  EXPECT_THROW(clip_batch({}, C{{0, 0}, -1}, {}, {}), ContractViolation);
  EXPECT_THROW(clip_batch(segments, five, std::span(clipped).first(8), accepted), ContractViolation);
  EXPECT_THROW(clip_batch(segments, five, clipped, std::span(accepted).first(8)), ContractViolation);
}

TEST(LiangBarskyCircle, StepsFollowTheGrammar) {
  using Seen =
      Recorder<Started<double>, Measured<double>, Crossed<double>, Limited<double>, Finished<double>>;
  Seen hit;
  const C five{{0, 0}, 5};
  const S given = segment(-6, 3, 2, 3);
  EXPECT_EQ(half_chord(given, five, hit), half_chord(given, five));
  ASSERT_EQ(hit.events().size(), 5u);
  EXPECT_EQ(all<Measured<double>>(hit)[0].A, 64);
  EXPECT_EQ(all<Measured<double>>(hit)[0].k, 24);
  EXPECT_EQ(all<Measured<double>>(hit)[0].D, 25 * 64 - 24 * 24);
  EXPECT_EQ(all<Crossed<double>>(hit)[0].foot, 0.75);
  EXPECT_EQ(all<Crossed<double>>(hit)[0].half, 0.5);
  EXPECT_EQ(all<Limited<double>>(hit)[0].first, 0.25);
  EXPECT_EQ(all<Limited<double>>(hit)[0].last, 1);
  EXPECT_EQ(all<Finished<double>>(hit)[0].kept, segment(-4, 3, 2, 3));
  Seen miss;
  EXPECT_FALSE(half_chord(segment(-6, 6, 6, 6), five, miss));
  EXPECT_EQ(miss.events().size(), 3u);

  using Decided = Recorder<Started<double>, Placed, Reached, Cut<double>, Finished<double>>;
  const auto steps = [&](const S& s) {
    Decided seen;
    EXPECT_EQ(exact_decision(s, five, seen), exact_decision(s, five));
    std::string text;
    for (const auto& event : seen.events()) text += "SPRCF"[event.step.index()];
    return text;
  };
  EXPECT_EQ(steps(segment(-1, 0, 1, 0)), "SPF");
  EXPECT_EQ(steps(segment(-9, 0, 1, 0)), "SPCF");
  EXPECT_EQ(steps(segment(-9, 0, 9, 0)), "SPRCCF");
  EXPECT_EQ(steps(segment(-9, 0, -7, 0)), "SPRF");
  EXPECT_EQ(steps(segment(-9, 6, 9, 6)), "SPRF");
}

/// A, B, C, k and D are rational: only the root is not.
TEST(LiangBarskyCircle, TheQuadraticIsExactInExact) {
  const ExactScope scope;
  const auto e = [](double x) { return Exact(x); };
  const Segment<2, Exact> s{{e(-6), e(3)}, {e(2), e(3)}};
  const Quadratic<Exact> q = quadratic(s, Circle<Exact>{{e(0), e(0)}, e(5)});
  EXPECT_EQ(q.A, e(64));
  EXPECT_EQ(q.B, e(-48));
  EXPECT_EQ(q.C, e(20));
  EXPECT_EQ(q.D, q.B * q.B - q.A * q.C);
  // A tangent that doubles can't tell
  const Segment<2, Exact> tangent{{e(-2), e(0.1) * e(10)}, {e(2), e(0.1) * e(10)}};
  EXPECT_EQ(sign(quadratic(tangent, Circle<Exact>{{e(0), e(0)}, e(0.1) * e(10)}).D), 0);
  // Float and double with the same small numbers
  const Quadratic<float> f = quadratic(Segment<2, float>{{-6, 3}, {2, 3}}, Circle<float>{{0, 0}, 5});
  const Quadratic<double> d = quadratic(segment(-6, 3, 2, 3), C{{0, 0}, 5});
  EXPECT_EQ(double{f.D}, d.D);
  EXPECT_EQ(e(d.D), q.D);
  const auto kept = exact_decision(Segment<2, float>{{-6, 3}, {2, 3}}, Circle<float>{{0, 0}, 5});
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->a, glm::vec2(-4, 3));
  EXPECT_EQ(half_chord(Segment<2, float>{{-6, 3}, {2, 3}}, Circle<float>{{0, 0}, 5})->a, glm::vec2(-4, 3));
}

// --- The notes' listings ----------------------------------------------------------------------------------

TEST(LiangBarskyCircleNotes, TheSegmentIsNotTheLine) {
  EXPECT_EQ(without_empty_test(segment(2, 0, 3, 0), unit), segment(2, 0, 1, 0));
  // Right where the segment itself crosses
  EXPECT_EQ(without_empty_test(segment(-3, 0, 3, 0), unit), segment(-1, 0, 1, 0));
  EXPECT_FALSE(discriminant_equals_zero(segment(2, 0, 3, 0), unit));
  EXPECT_EQ(discriminant_equals_zero(segment(0, 0, 0.5, 0), unit), segment(0, 0, 0.5, 0));
}

TEST(LiangBarskyCircleNotes, APointInsideIsLost) {
  Recorder<Started<double>, Discriminant<double>, Solved<double>, Limited<double>, Finished<double>> seen;
  EXPECT_FALSE(discriminant_equals_zero(segment(0.5, 0, 0.5, 0), unit, seen));
  EXPECT_EQ(all<Discriminant<double>>(seen)[0].A, 0);
  EXPECT_TRUE(std::isnan(all<Solved<double>>(seen)[0].enters));
}

TEST(LiangBarskyCircleNotes, TheDiscriminantCancels) {
  Recorder<Started<double>, Discriminant<double>, Solved<double>, Limited<double>, Finished<double>> seen;
  EXPECT_EQ(discriminant_equals_zero(segment(-1e8, 0.5, 1e8, 0.5), unit, seen), segment(0, 0.5, 0, 0.5));
  EXPECT_EQ(all<Discriminant<double>>(seen)[0].D, 0);
  EXPECT_TRUE(discriminant_equals_zero(segment(-1e8, 1.0000001, 1e8, 1.0000001), unit));
  const Kept near = discriminant_equals_zero(segment(-1e6, 0.999, 1e6, 0.999), unit);
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->b.x, 0.04335, 1e-5);  // right: 0.04471
}

TEST(LiangBarskyCircleNotes, StepsAreWatchedOnly) {
  for (const S& s : {segment(-3, 0, 3, 0), segment(2, 0, 3, 0), segment(-2, 1, 2, 1), segment(-2, 2, 2, 2)}) {
    Recorder<Started<double>, Discriminant<double>, Solved<double>, Limited<double>, Finished<double>> a, b;
    EXPECT_EQ(without_empty_test(s, unit, a), without_empty_test(s, unit));
    EXPECT_EQ(discriminant_equals_zero(s, unit, b), discriminant_equals_zero(s, unit));
    EXPECT_EQ(all<Finished<double>>(a).size(), 1u);
    EXPECT_EQ(all<Finished<double>>(b).size(), 1u);
  }
}

/// The larger distance between two points along an axis, in ulp of max(|coordinate|, r).
double off_by(dvec2 found, dvec2 right, double radius) {
  double most = 0;
  for (const int axis : {0, 1}) {
    const double size = std::max(std::abs(right[axis]), radius);
    most = std::max(most, std::abs(found[axis] - right[axis]) / (std::nextafter(size, infinity) - size));
  }
  return most;
}

/// What the taught form and the notes' make of random segments: the numbers in the header of half_chord and
/// on the topic's page, of the seed that they name.
TEST(LiangBarskyCircleNotes, ErrorsOfTheTextbookForms) {
  Random random(20240611 + 5);
  int compared = 0, above = 0;
  double worst_taught = 0, worst_notes = 0;
  for (int i = 0; i < 20'000; ++i) {
    double n[7];
    for (double& x : n) x = random.uniform(-10, 10);
    const S s = segment(n[0], n[1], n[2], n[3]);
    const C c{{n[4] / 2, n[5] / 2}, std::abs(n[6])};
    const Kept right = exact_decision(s, c), taught = half_chord(s, c);
    ASSERT_EQ(right.has_value(), taught.has_value());
    if (!right) continue;
    const auto error = [&](const Kept& got) {
      return got ? std::max(off_by(got->a, right->a, c.radius), off_by(got->b, right->b, c.radius)) : 0;
    };
    ++compared;
    above += error(taught) > 1;
    worst_taught = std::max(worst_taught, error(taught));
    worst_notes = std::max(worst_notes, error(discriminant_equals_zero(s, c)));
  }
  EXPECT_EQ(compared, 10'378);
  EXPECT_EQ(std::lround(100.0 * above / compared), 24);
  EXPECT_EQ(std::lround(worst_taught), 29);
  EXPECT_EQ(std::lround(worst_notes), 629);
}

test::Fraction power_of_two(int exponent) {
  return test::Fraction(std::ldexp(1.0, exponent / 2)) *
         test::Fraction(std::ldexp(1.0, exponent - exponent / 2));
}

TEST(LiangBarskyCircle, ChordsAreWithinTheirBound) {
  using namespace test;
  // Any lines, tangents but for a little, and both at all sizes that doubles have
  const auto draw = [](Random& random) {
    Numbers n = numbers(random, 7, random.unit() < 0.5 ? 0 : 20);
    n[6] = std::abs(n[6]);
    if (random.unit() < 0.6) {
      const double angle = random.uniform(-3, 3), x = std::cos(angle), y = std::sin(angle),
                   way = number(random, 20);
      const double r = n[6] * (1 - std::ldexp(1.0, -static_cast<int>(random.uniform_int(1, 60))));
      n[2] = n[0] + r * x - way * y, n[3] = n[1] + r * y + way * x;
      n[4] = n[0] + r * x + way * y, n[5] = n[1] + r * y - way * x;
    }
    const int by = random.unit() < 0.5 ? 0 : static_cast<int>(random.uniform_int(-1060, 980));
    for (double& x : n) x = std::ldexp(x, by);
    return n;
  };
  const auto judge = [](const Numbers& n) {
    const Circle<double> circle{{n[0], n[1]}, n[6]};
    const Segment<2, double> s{{n[2], n[3]}, {n[4], n[5]}};
    if (!(circle.radius > 0) || s.a == s.b || reach(s, circle) < 0) return not_in_domain;
    const int by = chord_on(s, circle).magnified;
    const Chord chord = chord_of(s, circle, by);
    const Fraction r = circle.radius, one = r * power_of_two(by);
    const Fraction dx = Fraction(n[4]) - Fraction(n[2]), dy = Fraction(n[5]) - Fraction(n[3]);
    const Fraction fx = Fraction(n[2]) - Fraction(n[0]), fy = Fraction(n[3]) - Fraction(n[1]);
    const Fraction A = dx * dx + dy * dy, k = dx * fy - dy * fx, D = r * r * A - k * k;
    const auto foot = [&](Rounded found, const Fraction& right) {
      return off((Fraction(found.value) + Fraction(found.error)) / one, right / (A * r), 0x1p-56);
    };
    // By squares: f - g = (f^2 - g^2) / (f + g)
    const auto half = [&](Rounded found, const Fraction& way) {
      const Fraction is = abs(Fraction(found.value) + Fraction(found.error)) / one;
      const Fraction square = D * way * way / (A * A * r * r);
      if (square.sign() == 0) return off(is, 0, 0x1p-56);
      const Fraction sum = is + Fraction(std::sqrt(static_cast<double>(square)));
      return off(is * is / sum, square / sum, 0x1p-56);
    };
    return std::max({foot(chord.foot_x, -(k * dy)), foot(chord.foot_y, k * dx), half(chord.half_x, dx),
                     half(chord.half_y, dy)});
  };
  EXPECT_LE(worst(2000, draw, judge), 1);
}

}  // namespace
}  // namespace gradus::liang_barsky_circle
