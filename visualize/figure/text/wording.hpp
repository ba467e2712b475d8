#pragma once
// In whose words a run is told: the templates of a language, and the reader's own names for symbols.
//
// A language is figure/language/<code>.txt, for what all figures say, and T.<code>.txt beside each story:
//
//   [bresenham_line]
//   started = Start at {from}; [p] = {p}.
//
// Where the reader's vectors are rows, a text "rows.started" of the section stands in the place of "started".
//
// {name} is replaced by a value; [p] is a symbol, shown as itself unless the reader has a label for it: a
// name in brackets; other brackets, as in [0, 1], stand for themselves. The key of that text is
// "bresenham_line.started". Every language has the same keys, and in each text the same values and symbols
// (a test compares them). docs/adding_a_language.md tells more.

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/text/language.hpp"  // IWYU pragma: export
#include "figure/text/notation.hpp"  // IWYU pragma: export

namespace gradus {

/// A value by the name that a template knows it by: {name}.
struct NamedText {
  std::string name, text;
};

/// How numbers that are not whole are shown.
enum class Numbers : std::uint8_t {
  decimals,   ///< 7.667
  fractions,  ///< 23/3, where a number is the nearest one to a fraction of a denominator up to 1000
};

class Wording {
 public:
  /// English, every symbol under its own name.
  Wording();
  explicit Wording(const Language& language, std::vector<SymbolLabel> labels = {},
                   Numbers numbers = Numbers::decimals)
      : language_(&language), labels_(std::move(labels)), numbers_(numbers) {}

  const Language& language() const { return *language_; }
  const std::vector<SymbolLabel>& labels() const { return labels_; }
  Numbers numbers() const { return numbers_; }
  const Notation& notation() const { return notation_; }

  Wording with(const Language& language) const;
  Wording with(std::vector<SymbolLabel> labels) const;
  Wording with(Numbers numbers) const;
  Wording with(Notation notation) const;
  /// The same for a run of this topic: from now on the notation's symbols for it are known.
  Wording about(std::string_view topic) const;

  /// Whether numbers are 2,333, and points (2,333; 0): the language's text "decimal_point".
  bool decimal_comma() const { return language_->text("decimal_point") == ","; }

  /// What the reader calls this symbol: by a label, else as the notation has it.
  std::string symbol(std::string_view name) const;
  /// Whether the reader calls it otherwise than the code does.
  bool renames(std::string_view name) const { return symbol(name) != name; }
  /// All symbols that are renamed, sorted.
  std::vector<SymbolLabel> renamed() const;

  /// Whether there is a text of this key.
  bool has(std::string_view key) const;
  /// The text of this key with its values put in: say("figure.step", fmt::arg("number", "4")). Values and
  /// labels are taken as they are. Throws ContractViolation for a key that doesn't exist
  /// or a text that asks for another value.
  template <class... Values>
  std::string say(std::string_view key, const Values&... values) const {
    return filled(key, fmt::make_format_args(values...));
  }
  /// The same with values that are known at run time; more may be given than the text asks for.
  std::string fill(std::string_view key, std::span<const NamedText> values) const;
  /// The same for a count: the key is "<key>.one" for 1 and "<key>.many" for all others; the value is {n}.
  template <class... Values>
  std::string count(std::string_view key, long long n, const Values&... values) const {
    return say(fmt::format("{}.{}", key, n == 1 ? "one" : "many"), fmt::arg("n", n), values...);
  }

 private:
  std::string filled(std::string_view key, fmt::format_args values) const;
  std::string_view text(std::string_view key) const;

  const Language* language_;
  std::vector<SymbolLabel> labels_;
  Numbers numbers_ = Numbers::decimals;
  Notation notation_{};
  std::string topic_{};
};

/// The symbols that a template names, in the order of their first use.
std::vector<std::string> symbols_in(std::string_view text);
/// The values that a template asks for, likewise.
std::vector<std::string> values_in(std::string_view text);

/// All symbols of a topic, sorted: those that the texts of its section name. A text "symbols" there lists
/// those that only drawing or table show.
std::vector<std::string> topic_symbols(std::string_view topic);

}  // namespace gradus
