#pragma once
// The figures' letters for pages and SVG files, which then open without our fonts.

#include <string>
#include <string_view>

#include "figure/sheet.hpp"

namespace gradus {

/// A WOFF file with these letters of a face, made of the outlines and widths that figures are drawn with:
/// no kerning, no ligatures, and what stands in for a letter is in it. The same letters give the same bytes.
std::string web_font(Face face, std::u32string_view characters);

/// CSS that makes the families "Gradus Sans" (also bold and italic) and "Gradus Mono" (also bold) with these
/// letters, and says whose they are.
std::string font_rules(std::u32string_view characters);

/// What the fonts are and under which licence, for the source of what they are embedded in.
extern const std::string_view font_notice;

}  // namespace gradus
