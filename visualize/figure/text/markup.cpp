#include "figure/text/markup.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "core/shown.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

bool fits_xml(char32_t c) {
  if (c == '\t' || c == '\n' || c == '\r') return true;
  return c >= 0x20 && !(0xd800 <= c && c <= 0xdfff) && c != 0xfffe && c != 0xffff && c <= 0x10ffff;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  for (const char32_t c : code_points(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        // Written out, so that the file's readers are not fooled; line ends and tabs are fine
        if (is_control(c) && fits_xml(c) && c != '\t' && c != '\n') {
          safe += fmt::format("&#x{:x};", static_cast<std::uint32_t>(c));
          break;
        }
        const char32_t shown = fits_xml(c) ? c : U'\xfffd';
        safe += shown < 0x80 ? std::string(1, static_cast<char>(shown)) : utf8_of({&shown, 1});
    }
  }
  return safe;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace gradus
