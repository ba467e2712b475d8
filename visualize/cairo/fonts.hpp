#pragma once
// The DejaVu faces as Cairo draws them, and their letters as outlines.

#include <cairo.h>

#include <string>

#include "figure/sheet.hpp"

namespace gradus {

/// Hinting off: the same outlines and places on every surface and machine.
void set_font_options(cairo_t* context);

void select_face(cairo_t* context, Face face, double size);

/// Without the DejaVu fonts Cairo draws boxes and says nothing: throws std::runtime_error.
void check_fonts();

/// A letter as SVG path data in units of 1/2048 em, y down, starting on the baseline at 0; empty for a space.
/// Taken from Cairo once per process; safe in threads.
const std::string& outline_of(char32_t character, Face face);

inline constexpr double units_per_em = 2048;

/// The width in pixels that Cairo draws a text with: what the layout's own table must agree with.
double drawn_width(const std::string& text, Face face, double size);

}  // namespace gradus
