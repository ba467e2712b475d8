#pragma once
// Widths of texts in the DejaVu fonts, from a table: the layout needs no font library.

#include <string_view>
#include <vector>

#include "figure/sheet.hpp"

namespace gradus {

/// Width in pixels of a UTF-8 text set in this face at this size (no kerning, as the figures are drawn).
/// A character the table lacks counts as one em: see `missing_characters`.
double text_width(std::string_view text, Face face, double size);

/// The characters of a text that the face can't draw.
std::vector<char32_t> missing_characters(std::string_view text, Face face);

/// The text, shortened with "…" in the middle if it is wider than `width`.
std::string elided(std::string_view text, Face face, double size, double width);

/// The text broken at spaces into lines no wider than `width`.
std::vector<std::string> wrapped(std::string_view text, Face face, double size, double width);

/// Code points of a UTF-8 text; a byte that is not UTF-8 becomes U+FFFD.
std::u32string code_points(std::string_view text);
std::string utf8_of(std::u32string_view characters);

}  // namespace gradus
