// Users' texts in messages: what a terminal would act on is spelled out.

#include "core/shown.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gradus {
namespace {

TEST(Shown, SpellsOutWhatATerminalWouldActOn) {
  EXPECT_EQ(visible("größe ≤ 1 \"<b>\""), "größe ≤ 1 \"<b>\"");
  EXPECT_EQ(visible("a\nb\tc\r"), "a\\nb\\tc\\x0d");
  EXPECT_EQ(visible("\x1b]0;title\x07"), "\\x1b]0;title\\x07");
  EXPECT_EQ(visible("\xc2\x9b"), "\\xc2\\x9b") << "the 8-bit form of ESC [";
  EXPECT_EQ(visible("\xff\xed\xa0\x80"), "\\xff\\xed\\xa0\\x80") << "no UTF-8";
  EXPECT_EQ(visible(std::string(300, 'x')), std::string(300, 'x'));
}

TEST(Shown, SpellsOutMarksThatTurnTheDirection) {
  for (const char* mark : {"\u200e", "\u200f", "\u202a", "\u202b", "\u202c", "\u202d", "\u202e", "\u2066",
                           "\u2067", "\u2068", "\u2069", "\u061c", "\u2028", "\u2029", "\ufeff"}) {
    EXPECT_EQ(visible(mark).substr(0, 2), "\\x");
    EXPECT_EQ(visible(mark).size(), 4 * std::string(mark).size());
  }
}

TEST(Shown, QuotesAndShortens) {
  EXPECT_EQ(shown("a b"), "'a b'");
  EXPECT_EQ(shown(std::string(100, 'x')), "'" + std::string(80, 'x') + "…'");
  EXPECT_EQ(shown_name("a b.obj"), "a b.obj");
  EXPECT_EQ(shown_name("a\x1b[31m.obj"), "'a\\x1b[31m.obj'");
}

}  // namespace
}  // namespace gradus
