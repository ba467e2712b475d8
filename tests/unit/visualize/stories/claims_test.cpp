// What the test of all sentences reads out of them.

#include "support/claims.hpp"

#include <gtest/gtest.h>

namespace gradus {
namespace {

std::size_t broken(std::string_view sentence) { return test::claims_in(sentence).broken.size(); }
std::size_t checked(std::string_view sentence) { return test::claims_in(sentence).checked; }

TEST(Claims, HoldWithinTheirPrintedRounding) {
  for (const char* right :
       {"Start: p = 2·3 − 7 = −1 < 0, so step E.", "y = 8 + 12·5/8 = 15.5; the new code is 0000.",
        "It passes the centre at |k|/√A = 30/10 = 3 < 5; so it crosses.", "[x]′ = 0.333·3 = 1; fine.",
        "(1, 1, 2.5) + (−1.833)·(1, −1, 1) = (−0.833, 2.833, 0.667)", "1e+06/3 = 333333.3", "5.96e-08 ≥ 0",
        "v = (0, 0, 1) × (1, 0, 0) = (0, 1, 0) turns", "−(0.8·2.8 + 0·3.6 + (−0.6)·3.2) = −0.32",
        "D = (−4)² − 4·1·3 = 4 > 0", "row 3·8 + 2 = 26, and cell 26 is it", "2.3e-208 > 0 ≥ −1",
        "1/3 ≈ 0.333"}) {
    EXPECT_EQ(broken(right), 0u) << right;
    EXPECT_GE(checked(right), 1u) << right;
  }
}

TEST(Claims, AreBrokenWhereNoRoundingExplainsThem) {
  for (const char* wrong :
       {"|k|/√A = 3e+200/1e+160 = 0 = 5; so it touches", "p = 0 < 0, so it enters", "[w] = 0 > 0",
        "y = −3.87e-247 + 1.16e-246·1.45e-247/7.74e-247 = −3.87e-247;", "5000 + 8.61e+53·1.82e-12 = 1.39e+42",
        "(1, 1) + 2·(1, 0) = (2, 1)", "2·3 − 7 = 1", "0.5 ≥ 0.6", "4 > 5 > 3"}) {
    EXPECT_GE(broken(wrong), 1u) << wrong;
  }
}

TEST(Claims, AreNotReadIntoWordsAndSymbols) {
  for (const char* none : {"dx + 3 = 5", "2·dy − 3 = p", "at t = 3 of 7 steps", "in row y = 3, x = 4",
                           "30° = a", "the line [x] = 5 and [y] = [x]", "3 = x + 1", "v3 = (1, 2, 3)"}) {
    EXPECT_EQ(checked(none), 0u) << none;
  }
}

TEST(Claims, NoNumberIsFoundAsAWordOfItsOwn) {
  for (const char* found : {"= nan", "inf/2", "(−inf, 3)", "at nan.", "−nan", "t is NaN", "∞"})
    EXPECT_TRUE(test::names_no_number(found)) << found;
  for (const char* none : {"runs to infinity", "Banane", "information", "Finance"})
    EXPECT_FALSE(test::names_no_number(none)) << none;
}

}  // namespace
}  // namespace gradus
