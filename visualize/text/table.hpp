#pragma once
// Tables of plain text, for terminals.

#include <cstddef>
#include <string>
#include <vector>

namespace gradus {

/// Columns that a text takes in a terminal (every character in figures is one wide).
std::size_t columns(const std::string& text);

/// The text with blanks behind it, or before it, up to so many columns.
std::string padded(const std::string& text, std::size_t width, bool right);

/// Rows whose cells stand below one another, two blanks apart, a line each; those of columns that `right`
/// names stand to the right. Nothing is cut off. rows: each has a cell per column.
std::string table_of(const std::vector<std::vector<std::string>>& rows, const std::vector<bool>& right);

}  // namespace gradus
