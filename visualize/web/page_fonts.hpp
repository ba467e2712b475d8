#pragma once
// The letters of a page, in the page: it looks the same on a machine without our fonts.

#include <string>

#include "web/html.hpp"

namespace gradus {

/// The rules of style with the letters of these parts and all of ASCII: see cairo/web_font.hpp.
std::string fonts_of(const Parts& parts);

}  // namespace gradus
