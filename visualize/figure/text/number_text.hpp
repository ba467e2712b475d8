#pragma once
// Numbers as figures show them, and the signs between them.
//
// A number that is printed with fewer digits than it has carries a note of that, unseen, until its trace is
// whole. Then the note decides, in one place and for every text: "=" before or behind a rounded number
// becomes "≈", a number of a small fraction may be shown as that, and each language has its own decimal
// point.

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "figure/text/wording.hpp"

namespace gradus {

struct Delta;
struct Trace;
struct TraceStep;

/// A number with the typographic minus, as figures show it.
inline std::string figure_number(std::int64_t value) {
  const std::string digits = fmt::format("{}", value);
  return value < 0 ? "−" + digits.substr(1) : digits;
}

/// The text of a number, with the note where it is not all of the value: text as C writes numbers, but for
/// the minus.
std::string with_note(std::string text, double value);
/// The same text as it was.
std::string without_notes(std::string_view text);

/// How texts are written in the end.
struct NumberStyle {
  Numbers numbers = Numbers::decimals;
  bool decimal_comma = false;  ///< then points are (2,333; 0)
};
/// The text as the reader sees it.
std::string settled(std::string_view text, NumberStyle style);

/// Settles the texts of what changes a drawing; of a step, but for its drawing; of a trace, but for its
/// steps.
void settle_numbers(Delta& delta, const Wording& wording);
void settle_numbers(TraceStep& step, const Wording& wording);
void settle_numbers(Trace& trace);

/// A text that `settled` wrote with decimal commas, with points: for tables that programs read.
std::string with_decimal_points(std::string_view text);

}  // namespace gradus
