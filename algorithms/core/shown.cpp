#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gradus {
namespace {

/// Domain: one well-formed character.
char32_t code_of(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  char32_t code = character.size() == 1 ? lead : lead & (0x3fu >> (character.size() - 1));
  for (const char c : character.substr(1)) code = (code << 6) | (static_cast<unsigned char>(c) & 0x3fu);
  return code;
}

std::string escaped(std::string_view bytes) {
  if (bytes == "\n") return "\\n";
  if (bytes == "\t") return "\\t";
  std::string text;
  for (const char c : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  return text;
}

/// Takes the first character, well-formed or not, off the text; as it may be shown.
std::string take_visible(std::string_view& text) {
  const std::size_t size = character_size(text);
  const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
  text.remove_prefix(character.size());
  return size == 0 || is_control(code_of(character)) ? escaped(character) : std::string(character);
}

}  // namespace

std::size_t character_size(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t size = lead < 0x80   ? 1
                           : lead < 0xc2 ? 0
                           : lead < 0xe0 ? 2
                           : lead < 0xf0 ? 3
                           : lead < 0xf5 ? 4
                                         : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  // Overlong forms, surrogates and what lies beyond U+10FFFF
  if (size > 2) {
    const unsigned char next = byte(1);
    if ((lead == 0xe0 && next < 0xa0) || (lead == 0xed && next > 0x9f)) return 0;
    if ((lead == 0xf0 && next < 0x90) || (lead == 0xf4 && next > 0x8f)) return 0;
  }
  return size;
}

std::string visible(std::string_view text) {
  std::string safe;
  while (!text.empty()) safe += take_visible(text);
  return safe;
}

std::string shown(std::string_view text) {
  constexpr std::size_t most = 80;
  std::string safe = "'";
  while (!text.empty()) {
    if (safe.size() > most) return safe + "…'";
    safe += take_visible(text);
  }
  return safe + "'";
}

std::string shown_name(std::string_view name) {
  return visible(name) == name ? std::string(name) : shown(name);
}

}  // namespace gradus
