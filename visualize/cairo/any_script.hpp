#pragma once
// Texts in any script, as names are: Pango picks among the fonts that are installed, joins letters and turns
// directions. What is laid out by the table of widths needs none of this. The same fonts draw the same.

#include <cairo.h>

#include <string_view>

#include "core/geometry.hpp"

namespace gradus {

/// Draws a text from this place of its baseline on, in a size of so many pixels, shortened with "…" at its
/// end if it is wider than `width`. In a PDF it can be searched.
void show_in_any_script(cairo_t* context, std::string_view text, double size, dvec2 at, double width);

}  // namespace gradus
