// The attacker itself: it finds a planted fault, makes its input small, and repeats itself.

#include "stress/attack.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stress/last.hpp"

namespace gradus::stress {
namespace {

/// A sum of two numbers that is wrong by 1 when the first is above 1000.
Property planted() {
  return {.name = "sum",
          .states = "is exact",
          .unit = "units",
          .bound = 0,
          .numbers = 2,
          .kinds = {Kind::random, Kind::huge},
          .generate =
              [](Kind kind, Random& random) {
                const double most = kind == Kind::huge ? 1e6 : 100;
                return Input{random.uniform(-most, most), random.uniform(-most, most)};
              },
          .error = [](const Input& i) { return i[0] > 1000 ? 1.0 : 0.0; },
          .traps = {{"a trap", {3, 4}}}};
}

const auto some = [](std::uint64_t i) { return i < 1000; };

TEST(Attack, FindsWhatIsPlanted) {
  const Property property = planted();
  const Finding finding = attack(property, 1, some);
  EXPECT_TRUE(finding.broken());
  EXPECT_EQ(finding.cases, 1001u);
  EXPECT_EQ(finding.by_kind.at(Kind::random), 500u);
  EXPECT_EQ(finding.by_kind.at(Kind::huge), 500u);
  EXPECT_TRUE(finding.origin.starts_with("huge, case ")) << finding.origin;
  EXPECT_EQ(property.error(finding.input), 1);
}

TEST(Attack, CountsTheSharesOfItsCases) {
  Property property = planted();
  property.error = [](const Input&) { return 0.0; };
  property.shares = {{"above 100", 0.1, [](const Input& i) { return i[0] > 100; }},
                     {"always", 1, [](const Input&) { return true; }},
                     {"never", 0, [](const Input&) { return false; }}};
  const Finding finding = attack(property, 1, some);
  ASSERT_EQ(finding.by_share.size(), 3u);
  // A huge case's first number is above 100 in nearly every second one, a random case's never; traps do not
  // count
  EXPECT_GT(finding.by_share[0], 200u);
  EXPECT_LT(finding.by_share[0], 300u);
  EXPECT_EQ(finding.by_share[1], 1000u);
  EXPECT_EQ(finding.by_share[2], 0u);
}

int computed = 0;
bool is_negative(const Input& input) {
  ++computed;
  return std::signbit(input[0]);
}

TEST(Attack, KeepsWhatWasComputedForTheSameBits) {
  computed = 0;
  EXPECT_FALSE(last_of<is_negative>({0.0}));
  EXPECT_TRUE(last_of<is_negative>({-0.0})) << "-0 is another input";
  EXPECT_FALSE(last_of<is_negative>({std::nan("")}));
  EXPECT_FALSE(last_of<is_negative>({std::nan("")}));
  EXPECT_EQ(computed, 3) << "NaN is the same one as before";
}

TEST(Attack, MakesTheInputSmall) {
  const Property property = planted();
  const Finding finding = attack(property, 1, some);
  const Input small = shrunk(property, finding.input, 1);
  EXPECT_EQ(property.error(small), 1);
  EXPECT_EQ(small[1], 0);
  // Nothing simpler is left: a power of two
  int exponent = 0;
  EXPECT_EQ(std::frexp(small[0], &exponent), 0.5);
  EXPECT_LE(small[0], finding.input[0]);
}

TEST(Attack, RepeatsItselfAndTellsOfOtherSeeds) {
  const Property property = planted();
  EXPECT_EQ(attack(property, 7, some).input, attack(property, 7, some).input);
  EXPECT_NE(attack(property, 7, some).input, attack(property, 8, some).input);
}

TEST(Attack, TriesTrapsFirstAndTakesNoNumberForTheWorst) {
  Property property = planted();
  property.error = [](const Input& i) { return i[0] == 3 ? std::nan("") : 0.0; };
  const Finding finding = attack(property, 1, some);
  EXPECT_EQ(finding.origin, "a trap");
  EXPECT_EQ(finding.worst, wrong);
  EXPECT_TRUE(finding.broken());
}

TEST(Attack, InputsReadBackBitForBit) {
  const Input input{0.1, -0.0, 5e-324, 1.7976931348623157e308, -1};
  const auto read = input_in(text_of(input));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, input);
  EXPECT_TRUE(std::signbit((*read)[1]));
  EXPECT_TRUE(std::isnan(input_in("nan,1").value()[0]));
  EXPECT_TRUE(std::isinf(input_in("-inf").value()[0]));
  for (const char* text : {"", "x", "1,", "1;2", "1, two"}) EXPECT_FALSE(input_in(text)) << text;
}

}  // namespace
}  // namespace gradus::stress
