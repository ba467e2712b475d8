// Numbers in sentences: what a calculator says of them.

#include "figure/text/number_text.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <set>

#include "figure/text/metrics.hpp"
#include "stories/paper.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"

namespace gradus {
namespace {

using Rational = boost::multiprecision::cpp_rational;

std::string in_english(std::string_view text) { return settled(text, {}); }
std::string in_german(std::string_view text) { return settled(text, {Numbers::decimals, true}); }
std::string in_fractions(std::string_view text) { return settled(text, {Numbers::fractions, false}); }

TEST(NumberText, ARoundedValueIsOnlyAboutEqual) {
  EXPECT_EQ(in_english("x = " + figure_real(7.5)), "x = 7.5");
  EXPECT_EQ(in_english("x = " + figure_real(23.0 / 3)), "x ≈ 7.667");
  EXPECT_EQ(in_english("x = " + figure_real(-1.0 / 3) + " < 0"), "x ≈ −0.333 < 0");
  EXPECT_EQ(in_english("C = " + figure_place(dvec2{10, 11.0 / 7})), "C ≈ (10,\u00a01.571)");
  EXPECT_EQ(in_english("t = 2/3 = " + figure_real(2.0 / 3)), "t = 2/3 ≈ 0.667");
  EXPECT_EQ(in_english("x = 16·" + figure_real(23.0 / 3) + "/" + figure_real(32.0 / 3) + " = 11.5"),
            "x ≈ 16·7.667/10.667 ≈ 11.5");
  EXPECT_EQ(in_english("p = 3 + 2·(3 − 7) = −5."), "p = 3 + 2·(3 − 7) = −5.");
  // Noise of the last bits is not what a figure tells of
  EXPECT_EQ(in_english("c = " + figure_real(0.5 + 0x1p-53)), "c = 0.5");
  EXPECT_EQ(in_english("a = " + figure_real(0.1) + ", b = " + figure_real(1.0 / 7)), "a = 0.1, b ≈ 0.143");
  EXPECT_EQ(in_english("from " + figure_real(1.0 / 7) + " on it is k = 3"), "from 0.143 on it is k = 3");
}

TEST(NumberText, WithoutANoteACalculatorDecides) {
  EXPECT_EQ(in_english("16·7.667/10.667 = 11.5"), "16·7.667/10.667 ≈ 11.5");
  EXPECT_EQ(in_english("2·4 − 7 = 1"), "2·4 − 7 = 1");
  EXPECT_EQ(in_english("(1 − 0.7) / 2 = 0.15 of it"), "(1 − 0.7) / 2 = 0.15 of it");
  EXPECT_EQ(in_english("1/3 = 0.333"), "1/3 ≈ 0.333");
  EXPECT_EQ(in_english("3/0 = 1"), "3/0 = 1");  // no number on the left
  EXPECT_EQ(in_english("y = 3x/7"), "y = 3x/7");
  EXPECT_EQ(in_english("2·2147483647 = 4294967294"), "2·2147483647 = 4294967294");
}

TEST(NumberText, FractionsWhereTheyAreShort) {
  EXPECT_EQ(in_fractions("x = " + figure_real(23.0 / 3)), "x = 23/3");
  EXPECT_EQ(in_fractions("x = " + figure_real(-2.0 / 3)), "x = −2/3");
  EXPECT_EQ(in_fractions("x = 16·" + figure_real(23.0 / 3) + "/" + figure_real(32.0 / 3) + " = 11.5"),
            "x = 16·(23/3)/(32/3) = 11.5");
  EXPECT_EQ(in_fractions("x = " + figure_real(0.75)), "x = 0.75");  // exact as it is
  EXPECT_EQ(in_fractions("x = " + figure_real(std::sqrt(2.0))), "x ≈ 1.414");
  EXPECT_EQ(in_fractions("x = " + figure_real(1.0 / 1009)), "x ≈ " + without_notes(figure_real(1.0 / 1009)));
  for (int below = 2; below <= 1000; ++below) {
    for (int above = 1; above < below; above += 1 + below / 7) {
      const std::string text = in_fractions(figure_real(static_cast<double>(above) / below));
      const std::size_t slash = text.find('/');
      if (slash == text.npos) {  // printed as it is
        EXPECT_NEAR(std::stod(text), static_cast<double>(above) / below, 1e-12) << text;
        continue;
      }
      EXPECT_EQ(std::stoll(text) * below, std::stoll(text.substr(slash + 1)) * above) << text;
    }
  }
}

TEST(NumberText, GermanHasACommaAndPointsHaveSemicolons) {
  EXPECT_EQ(in_german("C = " + figure_place(dvec2{7.0 / 3, 0})), "C ≈ (2,333;\u00a00)");
  EXPECT_EQ(in_german("von 0.5 bis 1.25, also weiter"), "von 0,5 bis 1,25, also weiter");
  EXPECT_EQ(in_german("Schritt 3."), "Schritt 3.");
  EXPECT_EQ(with_decimal_points(in_german("(0.5,\u00a01.25)")), "(0.5,\u00a01.25)");
}

// --- A calculator of its own -----------------------------------------------------------------------------

/// A number, and by how much what was printed as it may be off.
struct Amount {
  Rational value, slack;
};

/// Evaluates "16·7.667/10.667": numbers, + − · / and parentheses, nothing else.
class Calculator {
 public:
  Calculator(std::u32string text, char32_t point) : text_(std::move(text)), point_(point) {}

  std::optional<Amount> result() {
    const auto value = sum();
    skip();
    return at_ == text_.size() ? value : std::nullopt;
  }

 private:
  void skip() {
    while (at_ < text_.size() && text_[at_] == U' ') ++at_;
  }
  bool take(char32_t c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::optional<Amount> sum() {
    auto left = product();
    while (left) {
      const bool plus = take(U'+');
      if (!plus && !take(U'−')) return left;
      const auto right = product();
      if (!right) return std::nullopt;
      left = Amount{plus ? Rational(left->value + right->value) : Rational(left->value - right->value),
                    left->slack + right->slack};
    }
    return left;
  }
  std::optional<Amount> product() {
    auto left = factor();
    while (left) {
      const bool times = take(U'·');
      if (!times && !take(U'/')) return left;
      auto right = factor();
      if (!right) return std::nullopt;
      if (!times) {
        if (abs(right->value) <= right->slack) return std::nullopt;
        const Rational least = abs(right->value) - right->slack;
        right = Amount{1 / right->value, right->slack / (abs(right->value) * least)};
      }
      left = Amount{
          left->value * right->value,
          abs(left->value) * right->slack + abs(right->value) * left->slack + left->slack * right->slack};
    }
    return left;
  }
  std::optional<Amount> factor() {
    if (take(U'−')) {
      auto value = factor();
      if (value) value->value = -value->value;
      return value;
    }
    if (take(U'(')) {
      const auto value = sum();
      return value && take(U')') ? value : std::nullopt;
    }
    return number();
  }
  std::optional<Amount> number() {
    skip();
    boost::multiprecision::cpp_int digits = 0, scale = 1;
    bool any = false, behind = false;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == point_ && any && !behind) {
        behind = true;
      } else if (U'0' <= text_[at_] && text_[at_] <= U'9') {
        any = true;
        digits = 10 * digits + static_cast<int>(text_[at_] - U'0');
        if (behind) scale *= 10;
      } else {
        break;
      }
    }
    if (!any) return std::nullopt;
    const Rational slack = behind ? Rational(1, 2 * scale) : Rational(0);
    return Amount{Rational(digits, scale), slack};
  }

  std::u32string text_;
  char32_t point_;
  std::size_t at_ = 0;
};

struct Judged {
  int equal = 0, about = 0;
};

/// Looks at each sign of a text that has arithmetic of numbers on both sides.
void judge(const std::string& text, char32_t point, Judged& judged) {
  const std::u32string c = code_points(text);
  const auto belongs = [&](std::size_t i) {
    const bool between_digits =
        c[i] == point && i > 0 && i + 1 < c.size() && U'0' <= c[i + 1] && c[i + 1] <= U'9';
    return between_digits ||
           std::u32string_view(U"0123456789+−·/() ").find(c[i]) != std::u32string_view::npos;
  };
  for (std::size_t at = 0; at < c.size(); ++at) {
    if (c[at] != U'=' && c[at] != U'≈') continue;
    std::size_t left = at, right = at + 1;
    while (left > 0 && belongs(left - 1)) --left;
    while (right < c.size() && belongs(right)) ++right;
    const auto is_end = [&](std::size_t i, std::u32string_view ends) { return ends.find(c[i]) != ends.npos; };
    // Only what stands alone: between the text's ends, signs, commas and colons
    if (left > 0 && !is_end(left - 1, U"=≈,:;")) continue;
    if (right < c.size() && !is_end(right, U"=≈<>≤≥,:;.")) continue;
    const auto a = Calculator(c.substr(left, at - left), point).result();
    const auto b = Calculator(c.substr(at + 1, right - at - 1), point).result();
    if (!a || !b) continue;
    if (c[at] == U'=') {
      ++judged.equal;
      EXPECT_EQ(a->value, b->value) << text;
    } else {
      ++judged.about;
      EXPECT_LE(abs(a->value - b->value), a->slack + b->slack + abs(b->value) / 1000) << text;
    }
  }
}

Judged judge_all(const Wording& wording) {
  const char32_t point = wording.decimal_comma() ? U',' : U'.';
  Judged judged;
  std::set<std::string> seen;
  for (const Trace& trace : test::telling_traces(wording)) {
    for (const TraceStep& step : trace.steps) {
      if (seen.insert(step.sentence).second) judge(step.sentence, point, judged);
      for (const Mark& mark : step.delta.set) {
        const Label* label = std::get_if<Label>(&mark.shape);
        if (label && seen.insert(label->text).second) judge(label->text, point, judged);
      }
    }
  }
  return judged;
}

TEST(NumberText, ACalculatorAgreesWithEverySentence) {
  std::size_t next = 0;
  for (const Language& language : languages()) {
    for (const Numbers numbers : {Numbers::decimals, Numbers::fractions}) {
      // Each of both once, or the other way round
      if (const std::size_t pair = next++; !test::in_share(pair == 0 || pair == 3 ? 0 : 1, 2)) continue;
      const Judged judged = judge_all(Wording(language, {}, numbers));
      EXPECT_GT(judged.equal, 100) << language.code();
      EXPECT_GT(judged.about, 10) << language.code();
    }
  }
}

TEST(NumberText, NoNoteIsLeftAnywhere) {
  if (test::sanitized) return;
  std::size_t next = 0;
  for (const Language& language : languages()) {
    if (!test::in_share(next++, 2)) continue;
    for (const Trace& trace : test::telling_traces(Wording(language))) {
      Playhead playhead(trace);
      for (const TraceStep& step : trace.steps) {
        EXPECT_EQ(without_notes(step.sentence), step.sentence);
        for (const std::string& cell : step.row) EXPECT_EQ(without_notes(cell), cell);
      }
      for (const auto& [id, mark] : playhead.at(trace.steps.size() - 1).marks()) {
        const Text* text = std::get_if<Text>(&mark.shape);
        const Label* label = std::get_if<Label>(&mark.shape);
        const std::string shown = text ? text->text : label ? label->text : "";
        EXPECT_EQ(without_notes(shown), shown);
      }
    }
  }
}

}  // namespace
}  // namespace gradus
