// Clipping in doubles against clipping in rationals: decisions, nearest points, symmetry, number of cuts, and
// the measured error of the textbook's form.

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "core/exact_scalar.hpp"
#include "support/box_cases.hpp"
#include "support/clip_oracle.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::cohen_sutherland_3d {
namespace {

using glm::dvec3;
using glm::dvec4;
using test::Rational;

/// Counts cuts, and those that needed exact arithmetic.
template <int N>
struct Counter {
  const Segment<N, double>& line;
  const AxisBox<3, double>* box = nullptr;
  int cuts = 0, slow = 0;

  void operator()(const Classified<N, double>&) {}
  void operator()(const Cut<N, double>& cut) {
    ++cuts;
    slow += is_slow(cut);
  }
  void operator()(const Accepted<N, double>&) {}
  void operator()(const Rejected&) {}

  bool is_slow(const Cut<N, double>& cut) const {
    const auto &a = line.a, &b = line.b;
    const int axis = axis_of(cut.face);
    if constexpr (N == 3) {
      const double c = coordinate(*box, cut.face);
      for (int i = 0; i < 3; ++i) {
        if (i == axis || a[i] == b[i] || c == a[axis] || c == b[axis]) continue;
        if (!cut_coordinate_filtered(a[axis], b[axis], a[i], b[i], c)) return true;
        for (const double d : {box->lower[i], box->upper[i]}) {
          if (cut.to()[i] == d && !orient2d_filtered({a[axis], a[i]}, {b[axis], b[i]}, {c, d})) return true;
        }
      }
    } else {
      const Crossing<double> there{depth(a, cut.face), depth(b, cut.face)};
      for (int i = 0; i < 4; ++i) {
        if (i != axis && a[i] != b[i] && !coordinate_at_filtered(there, a[i], b[i])) return true;
      }
      for (const Border other : usual_order<3>()) {
        const auto p = depth(a, other), q = depth(b, other);
        if (other != cut.face && negative(p) != negative(q) && !negative_at_filtered(there, p, q))
          return true;
      }
    }
    return false;
  }
};

Order random_order(Random& random) {
  Order order = usual_order<3>();
  for (std::size_t i = order.size(); i-- > 1;) {
    std::swap(order[i], order[static_cast<std::size_t>(random.uniform_int(0, static_cast<std::int64_t>(i)))]);
  }
  return order;
}

// --- The box ---------------------------------------------------------------------------------------------

TEST(CohenSutherland3dProperty, BoxesAgreeWithRationals) {
  test::BoxCases cases(test::seed());
  const auto wanted = test::cases(8'000, 400'000);
  std::int64_t ran = 0, kept = 0, slow = 0, six = 0;
  for (; ran < wanted; ++ran) {
    const auto [line, box] = cases(static_cast<int>(ran % 8));
    Counter<3> counter{line, &box};
    const auto part = correctly_rounded(line, box, usual_order<3>(), counter);
    const auto exact = test::exact_clip(line, box);
    ASSERT_EQ(part.has_value(), exact.has_value()) << "case " << ran;
    ASSERT_LE(counter.cuts, 6) << "case " << ran;
    slow += counter.slow > 0;
    six += counter.cuts == 6;
    // Backwards, in another order, unwatched: the same
    const auto back = correctly_rounded(test::reversed(line), box);
    ASSERT_EQ(back.has_value(), part.has_value()) << "case " << ran;
    const auto other = correctly_rounded(line, box, random_order(cases.random));
    ASSERT_EQ(other, part) << "case " << ran;
    ASSERT_TRUE(test::same_bits(correctly_rounded(line, box), part)) << "case " << ran;
    if (!part) continue;
    ++kept;
    ASSERT_TRUE(test::same_bits(test::reversed(*back), *part)) << "case " << ran;
    for (std::size_t i = 0; i < 3; ++i) {
      const int axis = static_cast<int>(i);
      ASSERT_TRUE(test::is_nearest(part->a[axis], exact->a[i])) << "case " << ran;
      ASSERT_TRUE(test::is_nearest(part->b[axis], exact->b[i])) << "case " << ran;
    }
    // Inside of the box, so that clipping again changes nothing
    ASSERT_EQ(region_code(part->a, box) | region_code(part->b, box), 0) << "case " << ran;
    ASSERT_TRUE(test::same_bits(correctly_rounded(*part, box), part)) << "case " << ran;
  }
  std::printf("%lld boxes, %lld parts, %lld on the slow path, %lld with six cuts\n",
              static_cast<long long>(ran), static_cast<long long>(kept), static_cast<long long>(slow),
              static_cast<long long>(six));
  EXPECT_EQ(ran, wanted);
  EXPECT_GT(kept, ran / 4);
  EXPECT_LT(kept, ran * 3 / 4);
  EXPECT_GT(slow, ran / 10);
}

TEST(CohenSutherland3dProperty, FloatsAreTheNearestFloats) {
  test::BoxCases cases(test::seed() + 1);
  int kept = 0;
  for (int i = 0; i < 4'000; ++i) {
    const auto k = cases(i % 4 == 3 ? 7 : i % 4);
    const Segment<3, float> line{glm::vec3(k.line.a), glm::vec3(k.line.b)};
    const AxisBox<3, float> box{glm::vec3(k.box.lower), glm::vec3(k.box.upper)};
    const auto part = correctly_rounded(line, box);
    const auto exact = test::exact_clip(line, box);
    ASSERT_EQ(part.has_value(), exact.has_value()) << "case " << i;
    if (!part) continue;
    ++kept;
    for (std::size_t j = 0; j < 3; ++j) {
      ASSERT_TRUE(test::is_nearest(part->a[static_cast<int>(j)], exact->a[j])) << "case " << i;
      ASSERT_TRUE(test::is_nearest(part->b[static_cast<int>(j)], exact->b[j])) << "case " << i;
    }
  }
  EXPECT_GT(kept, 1000);
}

TEST(CohenSutherland3dProperty, TheTextbookIsExactInRationals) {
  test::BoxCases cases(test::seed() + 2);
  const auto exactly = [](const dvec3& p) { return ExactVec3(Exact(p.x), Exact(p.y), Exact(p.z)); };
  int kept = 0;
  for (int i = 0; i < 2'000; ++i) {
    const ExactScope scope;
    const auto [line, box] = cases(i % 8 == 5 ? 0 : i % 8);
    const auto part = correctly_rounded(line, box);
    const Segment<3, Exact> same{exactly(line.a), exactly(line.b)};
    const AxisBox<3, Exact> same_box{exactly(box.lower), exactly(box.upper)};
    int cuts = 0;
    const auto count = [&]<class Step>(const Step&) { cuts += std::same_as<Step, Cut<3, Exact>>; };
    const auto taught = cut_of_a_cut(same, same_box, usual_order<3>(), count);
    ASSERT_LE(cuts, 6);
    ASSERT_EQ(taught.has_value(), part.has_value()) << "case " << i;
    ASSERT_EQ(correctly_rounded(same, same_box), taught) << "case " << i;
    if (!part) continue;
    ++kept;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(to_double(taught->a[axis]), part->a[axis]) << "case " << i;
      ASSERT_EQ(to_double(taught->b[axis]), part->b[axis]) << "case " << i;
    }
  }
  EXPECT_GT(kept, 500);
}

// What docs/topics/clipping/cohen_sutherland_3d.md says about the cut of a cut
TEST(CohenSutherland3dProperty, MeasuredErrorOfACutOfACut) {
  test::BoxCases cases(test::seed() + 3);
  const auto wanted = test::cases(10'000, 300'000);
  std::int64_t cut = 0, off = 0;
  double worst = 0;
  for (std::int64_t i = 0; i < wanted; ++i) {
    const auto [line, box] = cases.ordinary();
    const auto part = cut_of_a_cut(line, box);
    const auto exact = test::exact_clip(line, box);
    if (!part || !exact || *part == line) continue;
    ++cut;
    double error = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      error = std::max({error, test::error_in_ulp(part->a[static_cast<int>(j)], exact->a[j]),
                        test::error_in_ulp(part->b[static_cast<int>(j)], exact->b[j])});
    }
    off += error > 1;
    worst = std::max(worst, error);
  }
  // Of segments that pass an edge within some steps
  std::int64_t near = 0, wrong = 0;
  for (std::int64_t i = 0; i < wanted; ++i) {
    const auto [line, box] = cases(1);
    ++near;
    wrong += cut_of_a_cut(line, box).has_value() != correctly_rounded(line, box).has_value();
  }
  std::printf(
      "cut of a cut: of %lld segments cut %lld (%.1f %%) are off by more than 1 ulp, worst %.0f ulp; of %lld "
      "past an edge %lld (%.1f %%) decided wrongly\n",
      static_cast<long long>(cut), static_cast<long long>(off),
      100.0 * static_cast<double>(off) / static_cast<double>(cut), worst, static_cast<long long>(near),
      static_cast<long long>(wrong), 100.0 * static_cast<double>(wrong) / static_cast<double>(near));
  EXPECT_GT(cut, wanted / 20);
  EXPECT_GT(off, cut / 4);
  EXPECT_GT(worst, 100);
  EXPECT_GT(wrong, near / 50);
}

// --- Many at once ------------------------------------------------------------------------------------------

using Space = Segment<3, double>;

std::string where(std::int64_t i) {
  return "GRADUS_SEED=" + std::to_string(test::seed()) + " case " + std::to_string(i);
}

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

std::vector<std::uint8_t> batched(std::span<const Space> lines, const AxisBox<3, double>& box,
                                  std::vector<Space>& clipped) {
  clipped.resize(lines.size());
  std::vector<std::uint8_t> accepted(lines.size());
  const std::size_t kept = clip_batch(lines, box, clipped, accepted);
  EXPECT_EQ(kept, static_cast<std::size_t>(std::count(accepted.begin(), accepted.end(), 1)));
  return accepted;
}

// One axis far smaller than the others, down to where digits are lost
test::BoxCase stretched(test::BoxCase k, Random& random) {
  const int i = static_cast<int>(random.uniform_int(0, 2));
  const int exponent = static_cast<int>(random.uniform_int(-1'090, 0));
  for (double* x : {&k.line.a[i], &k.line.b[i], &k.box.lower[i], &k.box.upper[i]})
    *x = std::ldexp(*x, exponent);
  return k;
}

// Lines that are all as hard as this one for its box: backwards, some steps beside it, from within the box,
// and lines of its kind
std::vector<Space> like(const test::BoxCase& k, int kind, test::BoxCases& cases, std::size_t size) {
  std::vector<Space> lines;
  while (lines.size() < size) {
    Space line = k.line;
    const auto change = cases.random.uniform_int(0, 9);
    if (change >= 1) {
      // Mostly one coordinate alone, some steps to a side
      double& x =
          (cases.random.unit() < 0.5 ? line.a : line.b)[static_cast<int>(cases.random.uniform_int(0, 2))];
      const double way = cases.random.unit() < 0.5 ? -1 : 1;
      const auto steps = cases.random.uniform_int(0, 3);
      for (std::int64_t i = 0; i < steps; ++i)
        x = std::nextafter(x, way * std::numeric_limits<double>::max());
    }
    if (change == 7) line.b = k.box.lower;
    if (change == 8) line.b = 0.5 * k.box.lower + 0.5 * k.box.upper;
    if (change == 9) line = cases(kind).line;
    lines.push_back(cases.random.unit() < 0.5 ? line : test::reversed(line));
  }
  return lines;
}

TEST(CohenSutherland3dProperty, TheBatchHasTheBitsOfTheScalarMethodOnEveryTarget) {
  test::BoxCases cases(test::seed() + 7);
  std::int64_t ran = 0, kept = 0, cut = 0, missed = 0;
  const int targets = on_every_target([&] {
    const auto rounds = test::cases(4'000, 200'000);
    for (std::int64_t round = 0; round < rounds; ++round) {
      SCOPED_TRACE(where(round));
      // Numbers of lines that leave a rest, and none at all
      const int kind = static_cast<int>(round % test::BoxCases::kinds);
      const test::BoxCase k = round % 3 ? cases(kind) : stretched(cases(kind), cases.random);
      std::vector<Space> lines = like(k, kind, cases, static_cast<std::size_t>(round % 23));
      std::vector<Space> clipped;
      const auto accepted = batched(lines, k.box, clipped);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto line = correctly_rounded(lines[i], k.box);
        ASSERT_EQ(accepted[i], line.has_value()) << i;
        ASSERT_TRUE(test::same_bits(clipped[i], line ? *line : lines[i])) << i;
        ++ran;
        kept += accepted[i];
        cut += line && *line != lines[i];
        missed += !line && !(region_code(lines[i].a, k.box) & region_code(lines[i].b, k.box));
      }
      // In place
      std::vector<std::uint8_t> again(lines.size());
      clip_batch(lines, k.box, lines, again);
      ASSERT_EQ(again, accepted);
      for (std::size_t i = 0; i < lines.size(); ++i) ASSERT_TRUE(test::same_bits(lines[i], clipped[i])) << i;
    }
  });
  std::printf("%d targets: %lld lines, %lld kept, %lld cut, %lld past the box\n", targets,
              static_cast<long long>(ran), static_cast<long long>(kept), static_cast<long long>(cut),
              static_cast<long long>(missed));
  EXPECT_GE(targets, 2);
  EXPECT_GE(ran, 40'000 * targets);
  EXPECT_GE(kept, ran / 4);
  EXPECT_GE(cut, ran / 5);
  EXPECT_GE(missed, ran / 20);
}

// The batch alone against rationals
TEST(CohenSutherland3dProperty, TheBatchAgreesWithRationalsOnEveryTarget) {
  test::BoxCases cases(test::seed() + 8);
  std::int64_t ran = 0, kept = 0;
  const int targets = on_every_target([&] {
    for (int round = 0; round < 160; ++round) {
      SCOPED_TRACE(where(round));
      const int kind = round % test::BoxCases::kinds;
      const test::BoxCase k = round % 3 ? cases(kind) : stretched(cases(kind), cases.random);
      const std::vector<Space> lines = like(k, kind, cases, 8);
      std::vector<Space> clipped;
      const auto accepted = batched(lines, k.box, clipped);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        ++ran;
        const auto exact = test::exact_clip(lines[i], k.box);
        ASSERT_EQ(accepted[i], exact.has_value()) << i;
        if (!exact) {
          ASSERT_TRUE(test::same_bits(clipped[i], lines[i])) << i;
          continue;
        }
        ++kept;
        for (std::size_t j = 0; j < 3; ++j) {
          ASSERT_TRUE(test::is_nearest(clipped[i].a[static_cast<int>(j)], exact->a[j])) << i;
          ASSERT_TRUE(test::is_nearest(clipped[i].b[static_cast<int>(j)], exact->b[j])) << i;
        }
      }
    }
  });
  EXPECT_EQ(ran, 1'280 * targets);
  EXPECT_GE(kept, ran / 4);
}

// The same lines, one box: as the pipeline and the benchmark use it; some lie along the axes, through 0
TEST(CohenSutherland3dProperty, ABatchOfManyLines) {
  test::BoxCases cases(test::seed() + 9);
  std::vector<Space> lines;
  for (int i = 0; i < 20'000; ++i) {
    Space line = cases(i % 50 == 49 ? 3 : 0).line;
    if (i % 5 == 0) line.b[i % 3] = line.a[i % 3] = i % 2 ? -0.0 : 250;
    if (i % 7 == 0) line.b[(i + 1) % 3] = line.a[(i + 1) % 3];
    lines.push_back(line);
  }
  const AxisBox<3, double> box{{-300, -200, 0}, {250, 400, 700}};
  int targets = 0;
  targets = on_every_target([&] {
    std::vector<Space> clipped;
    const auto accepted = batched(lines, box, clipped);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto line = correctly_rounded(lines[i], box);
      ASSERT_EQ(accepted[i], line.has_value()) << i;
      ASSERT_TRUE(test::same_bits(clipped[i], line ? *line : lines[i])) << i;
    }
  });
  EXPECT_GE(targets, 2);
}

TEST(CohenSutherland3dProperty, ABatchRefusesWhatTheScalarMethodRefuses) {
  on_every_target([&] {
    std::vector<Space> lines(9, Space{{1, 1, 1}, {2, 2, 2}}), clipped(9);
    std::vector<std::uint8_t> accepted(9);
    const AxisBox<3, double> ten{dvec3(0), dvec3(10)};
    EXPECT_EQ(clip_batch(lines, ten, clipped, accepted), 9u);
    for (const std::size_t bad : {0u, 5u, 8u}) {
      for (int i = 0; i < 6; ++i) {
        std::vector<Space> some = lines;
        (&some[bad].a.x)[i] = i % 2 ? std::nan("") : -std::numeric_limits<double>::infinity();
        EXPECT_THROW(clip_batch(some, ten, clipped, accepted), ContractViolation);
      }
    }
    for (int i = 0; i < 3; ++i) {
      AxisBox<3, double> broken = ten;
      broken.lower[i] = 11;
      EXPECT_THROW(clip_batch(lines, broken, clipped, accepted), ContractViolation);
      EXPECT_THROW(clip_batch({}, broken, {}, {}), ContractViolation);
      broken.lower[i] = std::nan("");
      EXPECT_THROW(clip_batch(lines, broken, clipped, accepted), ContractViolation);
    }
    EXPECT_THROW(clip_batch(lines, ten, std::span(clipped).first(8), accepted), ContractViolation);
    EXPECT_THROW(clip_batch(lines, ten, clipped, std::span(accepted).first(8)), ContractViolation);
    EXPECT_EQ(clip_batch({}, ten, {}, {}), 0u);
  });
}

// --- The view volume -------------------------------------------------------------------------------------

bool clippable(const Segment<4, double>& line) {
  return line.a != dvec4(0) && line.b != dvec4(0) && !opposite(line.a, line.b);
}

TEST(CohenSutherland3dProperty, ViewVolumesAgreeWithRationals) {
  test::VolumeCases cases(test::seed() + 4);
  const ViewVolume volume;
  const auto wanted = test::cases(7'000, 400'000);
  std::int64_t ran = 0, kept = 0, slow = 0, past = 0, behind = 0, most = 0, refused = 0, divided = 0;
  for (; ran < wanted; ++ran) {
    const Segment<4, double> line = cases(static_cast<int>(ran % test::VolumeCases::kinds));
    if (!clippable(line)) {
      ++refused;
      continue;
    }
    Counter<4> counter{line};
    const auto part = correctly_rounded(line, volume, usual_order<3>(), counter);
    const auto whole = test::exact_part(line);
    const auto exact = test::representable<double>(whole);
    ASSERT_EQ(part.has_value(), exact.has_value()) << "case " << ran;
    ASSERT_LE(counter.cuts, 6) << "case " << ran;
    most = std::max<std::int64_t>(most, counter.cuts);
    slow += counter.slow > 0;
    const auto back = correctly_rounded(test::reversed(line), volume);
    ASSERT_EQ(back.has_value(), part.has_value()) << "case " << ran;
    ASSERT_EQ(correctly_rounded(line, volume, random_order(cases.random)), part) << "case " << ran;
    ASSERT_TRUE(test::same_bits(correctly_rounded(line, volume), part)) << "case " << ran;
    behind += line.a.w <= 0 && line.b.w <= 0;
    if (line.a.w <= 0 && line.b.w <= 0) ASSERT_FALSE(part) << "case " << ran;
    if (!part) continue;
    ++kept;
    past += (line.a.w <= 0) != (line.b.w <= 0);
    ASSERT_TRUE(test::same_bits(test::reversed(*back), *part)) << "case " << ran;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(test::is_nearest(part->a[static_cast<int>(i)], exact->a[i])) << "case " << ran;
      ASSERT_TRUE(test::is_nearest(part->b[static_cast<int>(i)], exact->b[i])) << "case " << ran;
    }
    ASSERT_EQ(region_code(part->a, volume) | region_code(part->b, volume), 0) << "case " << ran;
    ASSERT_TRUE(test::same_bits(correctly_rounded(*part, volume), part)) << "case " << ran;
    ASSERT_GT(part->a.w, 0) << "case " << ran;
    ASSERT_GT(part->b.w, 0) << "case " << ran;
    divided += exact->a != whole->a || exact->b != whole->b;
  }
  std::printf(
      "%lld volumes (%lld refused), %lld parts, %lld of them past the eye, %lld divided, %lld behind it, "
      "%lld "
      "on the slow path, at most %lld cuts\n",
      static_cast<long long>(ran), static_cast<long long>(refused), static_cast<long long>(kept),
      static_cast<long long>(past), static_cast<long long>(divided), static_cast<long long>(behind),
      static_cast<long long>(slow), static_cast<long long>(most));
  EXPECT_EQ(ran, wanted);
  EXPECT_LT(refused, ran / 10);
  EXPECT_GT(divided, ran / 200);
  EXPECT_GT(kept, ran / 5);
  EXPECT_GT(past, ran / 50);
  EXPECT_GT(behind, ran / 100);
  EXPECT_GT(slow, ran / 10);
}

TEST(CohenSutherland3dProperty, FloatVolumesAreTheNearestFloats) {
  test::VolumeCases cases(test::seed() + 7);
  const ViewVolume volume;
  const auto wanted = test::cases(5'000, 200'000);
  std::int64_t ran = 0, kept = 0, past = 0;
  for (; ran < wanted; ++ran) {
    constexpr std::array<int, 5> kinds{0, 1, 2, 4, 6};  // the others leave the range of float
    const Segment<4, double> drawn =
        ran % 6 == 5 ? cases.past_nothing(-149) : cases(kinds[static_cast<std::size_t>(ran % 6)]);
    const Segment<4, float> line{glm::vec4(drawn.a), glm::vec4(drawn.b)};
    const Segment<4, double> same{dvec4(line.a), dvec4(line.b)};
    if (!clippable(same)) continue;
    int cuts = 0;
    const auto count = [&]<class Step>(const Step&) { cuts += std::same_as<Step, Cut<4, float>>; };
    const auto part = correctly_rounded(line, volume, usual_order<3>(), count);
    const auto exact = test::representable<float>(test::exact_part(same));
    ASSERT_LE(cuts, 6) << "case " << ran;
    ASSERT_EQ(part.has_value(), exact.has_value()) << "case " << ran;
    ASSERT_EQ(correctly_rounded(line, volume, random_order(cases.random)), part) << "case " << ran;
    const auto back = correctly_rounded(Segment<4, float>{line.b, line.a}, volume);
    ASSERT_EQ(back.has_value(), part.has_value()) << "case " << ran;
    if (!part) continue;
    ++kept;
    past += (line.a.w <= 0) != (line.b.w <= 0);
    ASSERT_EQ(*back, (Segment<4, float>{part->b, part->a})) << "case " << ran;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(test::is_nearest(part->a[static_cast<int>(i)], exact->a[i])) << "case " << ran;
      ASSERT_TRUE(test::is_nearest(part->b[static_cast<int>(i)], exact->b[i])) << "case " << ran;
    }
    ASSERT_EQ(region_code(part->a, volume) | region_code(part->b, volume), 0) << "case " << ran;
    ASSERT_EQ(correctly_rounded(*part, volume), part) << "case " << ran;
  }
  std::printf("%lld volumes of floats, %lld parts, %lld of them past the eye\n", static_cast<long long>(ran),
              static_cast<long long>(kept), static_cast<long long>(past));
  EXPECT_EQ(ran, wanted);
  EXPECT_GT(kept, ran / 5);
  EXPECT_GT(past, ran / 50);
}

// Coordinates that lie midway between two floats, but for less than a double shows
TEST(CohenSutherland3dProperty, FloatsMidwayGoByTheExactPoint) {
  Random random(test::seed() + 8);
  int above = 0, below = 0, ties = 0;
  for (int i = 0; i < 3'000; ++i) {
    // Depths -2 and 2 - e at the left side: y comes to 1 + (k + 1/2) steps, and e/16 of a step more
    const float e = std::ldexp(static_cast<float>(random.uniform_int(-3, 3)), -40);
    const float k = static_cast<float>(random.uniform_int(0, 1000));
    const float y = 1 + std::ldexp(k, -23), step = std::ldexp(1.0F, -23);
    const Segment<4, float> line{{-4, y, 0.5F, 2}, {-e, y + step, 0.5F, 2}};
    const auto part = correctly_rounded(line, ViewVolume{});
    const auto exact = test::exact_part({dvec4(line.a), dvec4(line.b)});
    ASSERT_TRUE(part && exact) << "case " << i;
    ASSERT_TRUE(test::is_nearest(part->a.y, exact->a[1])) << "case " << i;
    const Rational midway = Rational(double{y}) + Rational(double{step}) / 2;
    above += exact->a[1] > midway;
    below += exact->a[1] < midway;
    ties += exact->a[1] == midway;
  }
  EXPECT_GT(above, 500);
  EXPECT_GT(below, 500);
  EXPECT_GT(ties, 100);
}

// x/w of a part against the exact projection of the segment, clipped to the box -1 <= x, y <= 1, 0 <= z <= 1
TEST(CohenSutherland3dProperty, DividingTheLastAgreesWithClippingExactProjections) {
  test::VolumeCases cases(test::seed() + 5);
  const ViewVolume volume;
  int compared = 0;
  double worst = 0, worst_taught = 0;
  for (int i = 0; i < 8'000; ++i) {
    const Segment<4, double> line = cases(i % 2);
    if (line.a.w <= 0 || line.b.w <= 0) continue;  // else there is nothing to divide by at the ends
    // The same segment in NDC, rational, clipped to the box there
    std::array<Rational, 3> a, b;
    for (int k = 0; k < 3; ++k) {
      a[static_cast<std::size_t>(k)] = Rational(line.a[k]) / Rational(line.a.w);
      b[static_cast<std::size_t>(k)] = Rational(line.b[k]) / Rational(line.b.w);
    }
    Rational enter = 0, leave = 1;
    bool missed = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational lower = k < 2 ? -1 : 0, upper = 1, d = b[k] - a[k];
      if (d == 0) {
        missed = missed || a[k] < lower || upper < a[k];
        continue;
      }
      const Rational s = (lower - a[k]) / d, t = (upper - a[k]) / d;
      enter = std::max(enter, std::min(s, t));
      leave = std::min(leave, std::max(s, t));
    }
    missed = missed || leave < enter;
    const auto part = correctly_rounded(line, volume);
    ASSERT_EQ(part.has_value(), !missed) << "case " << i;
    if (!part) continue;
    ++compared;
    const auto taught = cut_of_a_cut(line, volume);
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const Rational at_a = a[k] + enter * (b[k] - a[k]), at_b = a[k] + leave * (b[k] - a[k]);
      worst = std::max({worst, test::error_in_ulp(part->a[axis] / part->a.w, at_a),
                        test::error_in_ulp(part->b[axis] / part->b.w, at_b)});
      if (!taught) continue;
      worst_taught = std::max({worst_taught, test::error_in_ulp(taught->a[axis] / taught->a.w, at_a),
                               test::error_in_ulp(taught->b[axis] / taught->b.w, at_b)});
    }
  }
  std::printf("%d parts divided: worst %.2f ulp; cut of a cut: worst %.0f ulp\n", compared, worst,
              worst_taught);
  EXPECT_GT(compared, 1500);
  EXPECT_LE(worst, 3);
  EXPECT_GT(worst_taught, 20);
}

TEST(CohenSutherland3dProperty, TheTextbooksVolumeIsExactInRationals) {
  test::VolumeCases cases(test::seed() + 6);
  int kept = 0;
  for (int i = 0; i < 2'000; ++i) {
    const ExactScope scope;
    const Segment<4, double> line = cases(i % 7 == 5 ? 0 : i % 7);
    if (!clippable(line)) continue;
    const auto exactly = [](const dvec4& p) {
      return glm::vec<4, Exact>(Exact(p.x), Exact(p.y), Exact(p.z), Exact(p.w));
    };
    const Segment<4, Exact> same{exactly(line.a), exactly(line.b)};
    const auto taught = cut_of_a_cut(same, ViewVolume{});
    const auto part = correctly_rounded(line, ViewVolume{});
    ASSERT_EQ(taught, correctly_rounded(same, ViewVolume{})) << "case " << i;
    ASSERT_EQ(taught.has_value(), part.has_value()) << "case " << i;
    if (!part) continue;
    ++kept;
    for (int k = 0; k < 4; ++k) ASSERT_EQ(to_double(taught->a[k]), part->a[k]) << "case " << i;
  }
  EXPECT_GT(kept, 300);
}

}  // namespace
}  // namespace gradus::cohen_sutherland_3d
