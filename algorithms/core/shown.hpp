#pragma once
// Texts of users as messages show them: nothing in them may move a terminal's cursor, colour what follows,
// turn its direction or end the line.

#include <cstddef>
#include <string>
#include <string_view>

#include "core/language.hpp"

namespace gradus {

/// Bytes of the well-formed UTF-8 character that a text, not empty, begins with; 0 when there is none.
std::size_t character_size(std::string_view text);

/// Characters that move the cursor, or turn the text's direction, instead of showing anything.
constexpr bool is_control(char32_t c) {
  return c < 0x20 || (0x7f <= c && c < 0xa0) || c == 0x61c || (0x200b <= c && c <= 0x200f) ||
         (0x2028 <= c && c <= 0x202e) || (0x2066 <= c && c <= 0x206f) || c == 0xfeff;
}

/// The text with control characters, marks that turn the direction of text and broken UTF-8 escaped: "\n",
/// "\x1b". All else stays, at any length. Domain: any bytes. Cost: O(length).
std::string visible(std::string_view text);

/// The same in quotes and cut short, as it may stand inside a message. Domain: any bytes.
std::string shown(std::string_view text);

/// A name as a message begins with: itself, and in quotes only where that is needed to see what it is.
std::string shown_name(std::string_view name);

}  // namespace gradus
