#pragma once
// A trace as plain text: the step table for terminals, spreadsheets and documents.

#include <string>

#include "figure/trace.hpp"

namespace gradus {

/// A field's value as people read it: "(3, 4)", "yes", the shortest decimal that gives a number back; -0 is
/// 0.
std::string value_text(const Value& value);

/// Title, the step table (number, columns, sentence) and the result. `color`: ANSI emphasis.
std::string text_of(const Trace& trace, bool color);

/// The table as CSV (RFC 4180): step, type, line, the columns, sentence. The headings are the same in every
/// wording: programs read them.
std::string csv_of(const Trace& trace);

/// The decision table as a Markdown table: its columns, a row per step.
std::string markdown_of(const Trace& trace);

/// The decision table as a LaTeX tabular with the rules of the package booktabs.
std::string latex_of(const Trace& trace);

}  // namespace gradus
