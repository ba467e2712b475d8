#pragma once
// The figures' letters as Cairo draws them, and as outlines: Inter and JetBrains Mono, and DejaVu for what
// they lack. Every letter stands where the table of widths says, without kerning and ligatures.

#include <cairo.h>

#include <string>
#include <string_view>
#include <vector>

#include "figure/sheet.hpp"

namespace gradus {

/// Hinting off: the same outlines and places on every surface and machine.
void set_font_options(cairo_t* context);

/// Draws a text from this place of its baseline on; in a PDF it can be searched.
void show_text(cairo_t* context, std::string_view text, Face face, double size, dvec2 at);
/// Adds its outlines to the current path.
void trace_text(cairo_t* context, std::string_view text, Face face, double size, dvec2 at);

/// Without its fonts Cairo draws boxes and says nothing: throws std::runtime_error.
void check_fonts();

inline constexpr double units_per_em = 2048;

/// A piece of a letter's outline in units of 1/2048 em, y down, from the baseline at 0.
struct OutlinePiece {
  enum class Kind : std::uint8_t { move, line, curve, close };
  Kind kind;
  std::vector<dvec2> points;  ///< one, or the three of a cubic curve; none of `close`
};
/// Empty for a space. Taken from Cairo.
std::vector<OutlinePiece> outline_pieces(char32_t character, Face face);

/// The same as SVG path data. Taken once per process; safe in threads.
const std::string& outline_of(char32_t character, Face face);

/// The width in pixels that Cairo draws a text with: what the layout's own table must agree with.
double drawn_width(std::string_view text, Face face, double size);

}  // namespace gradus
