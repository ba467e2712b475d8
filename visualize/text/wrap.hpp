#pragma once
// Lines as long as a terminal is wide.

#include <cstddef>
#include <string>
#include <string_view>

namespace gradus {

/// The text with its longer lines broken at blanks. What goes on stands below the line's last column: behind
/// its last two blanks, or where that leaves too little room, indented. Colours take no room. Commands to
/// paste ("  gradus …") and single words stay whole, however long. width 0: nothing is broken.
std::string wrapped(std::string_view text, std::size_t width);

}  // namespace gradus
