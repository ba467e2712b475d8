#pragma once
// Widths of texts in the figures' fonts, from a table: the layout needs no font library.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "figure/sheet.hpp"

namespace gradus {

/// Width in pixels of a UTF-8 text set in this face at this size (no kerning, as the figures are drawn).
/// A character the table lacks counts as one em: see `missing_characters`.
double text_width(std::string_view text, Face face, double size);

/// A stretch of a text shape that is of one face and paint.
struct TextPiece {
  std::string_view text;  ///< lives as long as the shape
  Face face;
  Paint paint;
  double x, width;  ///< from the text's left end
};
std::vector<TextPiece> pieces_of(const TextShape& shape);

/// The characters of a text that the face can't draw.
std::vector<char32_t> missing_characters(std::string_view text, Face face);

/// A character that its face can't draw: it would be a box.
struct MissingGlyph {
  std::string text;  ///< the whole text that holds it
  char32_t character;
};
/// The first one of a text; nothing when all can be drawn. Sans, bold and italic can draw the same
/// characters.
std::optional<MissingGlyph> missing_glyph(std::string_view text, Face face);
/// The first one of a whole figure, but for texts in any script.
std::optional<MissingGlyph> missing_glyph(const Sheet& sheet);
/// "the figures' fonts have no glyph for U+4E2D": what to say after the text.
std::string explained(const MissingGlyph& missing);

/// The text, shortened with "…" in the middle if it is wider than `width`.
std::string elided(std::string_view text, Face face, double size, double width);

/// The text broken at spaces into lines no wider than `width`.
std::vector<std::string> wrapped(std::string_view text, Face face, double size, double width);

/// Code points of a UTF-8 text; a byte that is not UTF-8 becomes U+FFFD.
std::u32string code_points(std::string_view text);
std::size_t count_of_code_points(std::string_view text);
std::string utf8_of(std::u32string_view characters);

}  // namespace gradus
