#pragma once
// Letters by what they stand for: variables in italics, quantities in their own colours. Done at the end, to
// the texts of a whole sheet, so that neither stories nor layout think of it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/sheet.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// A word of a text that may be a name: letters with the digits, primes and small letters that follow them.
struct Token {
  std::size_t begin = 0, end = 0;  ///< bytes
};
std::vector<Token> tokens_of(std::string_view text);

/// Whether a name is set in italics where it stands alone: one small letter or d and one, with an index or
/// prime: x, p, dy, x′, t₀. Names of points, matrices and moves (A, M, NE) and words (enter) are not.
bool is_variable(std::string_view name);

/// The variables among the names of a trace's topic, as the reader calls them; sorted.
std::vector<std::string> variables_of(const Trace& trace);

/// Sets variables of the figure's topic and its quantities so, in sentence, table, title, labels and listing.
/// Codes in the sentence have the colour of whose they are by these rows of the table, the step's last ones.
void typeset(Sheet& sheet, const Trace& trace, std::span<const Row> rows = {});

}  // namespace gradus
