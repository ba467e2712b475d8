#pragma once
// Curves as texts: rules replace all symbols of a text at once, and a turtle that walks and turns reads what
// comes out.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "modeling/fractal_curve/fractal_curve.hpp"

namespace gradus::fractal_curve {

/// What becomes of a symbol; symbols without a rule stay.
struct Rule {
  char symbol = 0;
  std::string_view to{};
};
using Rules = std::span<const Rule>;

/// A text to begin with, rules for it, and by how many degrees + and - turn.
struct System {
  std::string_view axiom;
  std::array<Rule, 2> rules;
  double degrees;
};
inline constexpr System koch_system{"F", {{{'F', "F+F--F+F"}}}, 60};
inline constexpr System dragon_system{"F", {{{'F', "F+G"}, {'G', "F-G"}}}, 90};
inline constexpr System hilbert_system{"A", {{{'A', "+BF-AFA-FB+"}, {'B', "-AF+BFB+FA-"}}}, 90};
inline constexpr System arrowhead_system{"F", {{{'F', "G-F-G"}, {'G', "F+G+F"}}}, 60};
/// The Algorithmic Beauty of Plants, figure 1.24f; it grows to the right.
inline constexpr System plant_system{"X", {{{'X', "F-[[X]+X]+F[+FX]-X"}, {'F', "FF"}}}, 22.5};

/// As many symbols as one may ask for.
inline constexpr std::int64_t most_symbols = std::int64_t{1} << 24;

// --- Steps -------------------------------------------------------

/// A symbol was replaced, by itself where it has no rule.
struct SymbolReplaced {
  int generation;  ///< from 1 on
  Index at;        ///< in the text before, from 0 on
  char symbol;
  Index begins;    ///< in the new text
  std::string to;  ///< what stands there
};

struct GenerationDone {
  int generation;
  std::int64_t symbols;  ///< of the new text
};

struct TextFinished {
  std::int64_t symbols;
};

/// Where a turtle stands, and how often it has turned to the left, less to the right.
template <class P>
struct Stand {
  P at{0};
  std::int64_t turn = 0;
};

/// The turtle has done what a symbol says.
template <class P>
struct SymbolRead {
  Index at;  ///< in the text, from 0 on
  char symbol;
  P from;  ///< where it stood before
  Stand<P> now;
  Index kept;  ///< how many stands are kept for closing brackets
};

struct WalkFinished {
  std::int64_t symbols;
};

// --- Texts -------------------------------------------------------

/// What becomes of a symbol; it must outlive the answer.
constexpr std::string_view by(Rules rules, const char& symbol) {
  for (const Rule& rule : rules) {
    if (rule.symbol == symbol) return rule.to;
  }
  return {&symbol, 1};
}
/// As which symbol of a text one stands there, from 0 on.
constexpr Index place_in(std::string_view text, const char& symbol) {
  return static_cast<Index>(&symbol - text.data());
}
/// What has happened to a symbol of a text when `next` ends in what became of it.
inline SymbolReplaced replaced(int generation, const std::string& text, const char& symbol,
                               const std::string& next, std::string_view to) {
  return {generation, place_in(text, symbol), symbol, next.size() - to.size(), std::string(to)};
}

/// How long a text will be, found without making it; `most` where it is longer, and where a symbol is not one
/// of ASCII.
inline std::int64_t length_after(std::string_view text, Rules rules, int rounds, std::int64_t most) {
  constexpr Index symbols = 128;
  using Counts = std::array<std::int64_t, symbols>;
  // How many symbols one becomes, round by round from the last one backwards
  Counts lengths;
  lengths.fill(1);
  for (int k = 0; k < rounds; ++k) {
    Counts longer = lengths;
    for (const Rule& rule : rules) {
      if (rule.symbol <= 0) continue;
      std::int64_t sum = 0;
      for (const char s : rule.to) sum = s > 0 ? std::min(most, sum + lengths[static_cast<Index>(s)]) : most;
      longer[static_cast<Index>(rule.symbol)] = sum;
    }
    lengths = longer;
  }
  std::int64_t sum = 0;
  for (const char s : text) sum = s > 0 ? std::min(most, sum + lengths[static_cast<Index>(s)]) : most;
  return sum;
}

inline void expect_size(std::string_view text, Rules rules, int rounds) {
  constexpr int most_rounds = 24;
  expects(0 <= rounds && rounds <= most_rounds, "at most {} rounds, not {}", most_rounds, rounds);
  expects(length_after(text, rules, rounds, most_symbols + 1) <= most_symbols,
          "at most 2^24 symbols of ASCII in the end, not {} rounds from {}", rounds, text.size());
}

/// Replaces all symbols of a text at once by their rules, so many rounds: new symbols wait for the next one.
/// Source: A. Lindenmayer, Mathematical models for cellular interactions in development, 1968;
/// P. Prusinkiewicz and A. Lindenmayer, The algorithmic beauty of plants, 1990, section 1.2.
///
/// text: the axiom, generation 0. rules: at most one per symbol; the first one counts. rounds: how often.
///
/// Domain: 0 <= rounds <= 24; at most 2^24 symbols in the end, all of ASCII.
/// Steps: (SymbolReplaced for each symbol, GenerationDone) for each round, TextFinished.
/// Accuracy: exact.
/// Cost: that of writing all generations.
/// Errors: ContractViolation outside the domain, before any memory is taken.
template <Observer<SymbolReplaced, GenerationDone, TextFinished> O = Unobserved>
std::string rewrite(std::string text, Rules rules, int rounds, O&& observer = {}) {
  expect_size(text, rules, rounds);
  for (int g = 0; g < rounds; ++g) {
    std::string next;
    for (const char& s : text) {
      // New symbols wait in next
      auto to = by(rules, s);
      next += to;
      if constexpr (observed<O>) observer(replaced(g + 1, text, s, next, to));
    }
    swap(text, next);
    if constexpr (observed<O>) observer(GenerationDone{g + 1, std::ssize(text)});
  }
  if constexpr (observed<O>) observer(TextFinished{std::ssize(text)});
  return text;
}

// --- The turtle --------------------------------------------------

constexpr bool draws(char symbol) { return symbol == 'F' || symbol == 'G'; }
constexpr bool walks(char symbol) { return draws(symbol) || symbol == 'f'; }
/// To the left; most symbols make none.
constexpr int turn_of(char symbol) { return symbol == '+' ? 1 : symbol == '-' ? -1 : 0; }

/// The first closing bracket that none was opened for, or the last opening one that stays open, from 0 on;
/// the text's length where there is none.
constexpr Index lonely_bracket(std::string_view text) {
  std::int64_t open = 0;
  for (Index i = 0; i < text.size(); ++i) {
    open += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
    if (open < 0) return i;
  }
  std::int64_t closed = 0;
  for (Index i = text.size(); open > 0 && i-- > 0;) {
    closed += text[i] == ']' ? 1 : text[i] == '[' ? -1 : 0;
    if (closed < 0) return i;
  }
  return text.size();
}

constexpr void expect_pairs(std::string_view text) {
  const Index lonely = lonely_bracket(text);
  expects(lonely == text.size(), "symbol {} is a bracket without its other half", lonely);
}

template <class P>
void push(std::vector<Stand<P>>& kept, const Stand<P>& stand) {
  kept.push_back(stand);
}
template <class P>
Stand<P> pop(std::vector<Stand<P>>& kept) {
  const Stand<P> last = kept.back();
  kept.pop_back();
  return last;
}

/// Walks as a text says: F and G draw a step, f makes one without drawing, + turns to the left and - to the
/// right, [ keeps where the turtle stands and ] puts it back there. All other symbols do nothing.
/// Source: Prusinkiewicz and Lindenmayer, as above, sections 1.3 and 1.6.
///
/// text: what is read, from the first symbol on. way(turns): a step after so many turns, as a P. draw(from,
/// to): for each step that is drawn, in their order.
///
/// Domain: brackets in pairs.
/// Steps: SymbolRead for each symbol, WalkFinished.
/// Accuracy: turns are counted, never added up as angles. Where P's numbers are whole, exact; else each
///   coordinate within n (e + u M) after n steps, where e is the error of way, M the largest coordinate
///   passed and u = 2^-53 in double.
/// Cost: a sum per step; memory for the stands that are kept.
/// Errors: ContractViolation outside the domain.
template <class P, class Way, class Draw, Observer<SymbolRead<P>, WalkFinished> O = Unobserved>
void turtle(std::string_view text, Way&& way, Draw&& draw, O&& observer = {}) {
  expect_pairs(text);
  std::vector<Stand<P>> kept;
  Stand<P> now;
  for (const char& s : text) {
    const P a = now.at;
    if (s == '[') push(kept, now);
    if (s == ']') now = pop(kept);
    if (walks(s)) {
      now.at += way(now.turn);
    }
    if (draws(s)) draw(a, now.at);
    now.turn += turn_of(s);
    if constexpr (observed<O>) observer(SymbolRead<P>{place_in(text, s), s, a, now, kept.size()});
  }
  if constexpr (observed<O>) observer(WalkFinished{std::ssize(text)});
}

/// What turtle's `way` gives on a lattice of triangles, for turns of 60 degrees.
constexpr Corner lattice_way(std::int64_t turns) {
  Corner step{1, 0};
  for (std::int64_t k = (turns % 6 + 6) % 6; k > 0; --k) step = turned(step);
  return step;
}

/// The same in the plane, for turns of any angle. Accuracy: within an ulp, as sin_cos_degrees.
inline dvec2 plane_way(std::int64_t turns, double degrees) {
  const SinCos way = sin_cos_degrees(static_cast<double>(turns) * degrees);
  return {way.cos, way.sin};
}

}  // namespace gradus::fractal_curve
