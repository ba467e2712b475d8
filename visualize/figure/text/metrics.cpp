#include "figure/text/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/shown.hpp"

namespace gradus {
namespace {

struct Advance {
  std::uint16_t character;
  std::array<std::uint16_t, 6> units;  ///< by Face, in 1/2048 em
};

constexpr Advance advances[] = {
#include "figure/text/font_metrics.inc"
};
constexpr double units_per_em = 2048;

/// Advance in font units, or 0 where the face lacks the character.
int advance_of(char32_t character, Face face) {
  // The table starts with all of ASCII's letters and signs
  if (U' ' <= character && character <= U'~') {
    return advances[character - U' '].units[static_cast<std::size_t>(face)];
  }
  const auto found = std::ranges::lower_bound(advances, character, {},
                                              [](const Advance& a) { return char32_t{a.character}; });
  if (found == std::end(advances) || found->character != character) return 0;
  return found->units[static_cast<std::size_t>(face)];
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// How many bytes the character has that begins with this one; 0 where none does.
std::size_t length_of(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead < 0xc2) return 0;
  if (lead < 0xe0) return 2;
  if (lead < 0xf0) return 3;
  return lead < 0xf5 ? 4 : 0;
}

/// The code point at a byte, which moves on to the next one. Most of what is measured is ASCII.
char32_t next_code_point(std::string_view text, std::size_t& at) {
  const std::size_t first = at++;
  const auto lead = static_cast<unsigned char>(text[first]);
  if (lead < 0x80) return lead;
  const std::size_t length = length_of(lead);
  bool whole = length > 0 && first + length <= text.size();
  for (std::size_t k = 1; whole && k < length; ++k) whole = is_continuation(text[first + k]);
  if (!whole) return U'\xfffd';
  char32_t character = lead & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    character = (character << 6) | (static_cast<unsigned char>(text[first + k]) & 0x3fu);
  }
  at = first + length;
  const bool half = character >= 0xd800 && character <= 0xdfff;  // of a surrogate pair: no character
  return half ? U'\xfffd' : character;
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string characters;
  characters.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) characters += next_code_point(text, at);
  return characters;
}

std::size_t count_of_code_points(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::ranges::all_of(text, is_ascii)) return text.size();
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++count) next_code_point(text, at);
  return count;
}

std::string utf8_of(std::u32string_view characters) {
  std::string text;
  const auto put = [&text](char32_t bits) { text += static_cast<char>(static_cast<unsigned char>(bits)); };
  for (const char32_t c : characters) {
    if (c < 0x80) {
      put(c);
    } else if (c < 0x800) {
      put(0xc0 | (c >> 6));
      put(0x80 | (c & 0x3f));
    } else if (c < 0x10000) {
      put(0xe0 | (c >> 12));
      put(0x80 | ((c >> 6) & 0x3f));
      put(0x80 | (c & 0x3f));
    } else {
      put(0xf0 | (c >> 18));
      put(0x80 | ((c >> 12) & 0x3f));
      put(0x80 | ((c >> 6) & 0x3f));
      put(0x80 | (c & 0x3f));
    }
  }
  return text;
}

double text_width(std::string_view text, Face face, double size) {
  double units = 0;
  for (std::size_t at = 0; at < text.size();) {
    const int advance = advance_of(next_code_point(text, at), face);
    units += advance > 0 ? advance : units_per_em;
  }
  return units * size / units_per_em;
}

std::vector<char32_t> missing_characters(std::string_view text, Face face) {
  std::vector<char32_t> missing;
  for (const char32_t character : code_points(text)) {
    if (advance_of(character, face) == 0 || is_control(character)) missing.push_back(character);
  }
  return missing;
}

std::optional<MissingGlyph> missing_glyph(std::string_view text, Face face) {
  const std::vector<char32_t> missing = missing_characters(text, face);
  if (missing.empty()) return std::nullopt;
  return MissingGlyph{std::string(text), missing.front()};
}

std::optional<MissingGlyph> missing_glyph(const Sheet& sheet) {
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text || text->any_script_within > 0) continue;
    for (const TextPiece& piece : pieces_of(*text)) {
      if (auto missing = missing_glyph(piece.text, piece.face)) return missing;
    }
  }
  return std::nullopt;
}

std::string explained(const MissingGlyph& missing) {
  if (missing.character == U'\xfffd') return "it is not UTF-8";
  if (is_control(missing.character)) {
    return fmt::format("U+{:04X} is a control character", static_cast<std::uint32_t>(missing.character));
  }
  return fmt::format("the figures' fonts have no glyph for U+{:04X}",
                     static_cast<std::uint32_t>(missing.character));
}

std::string elided(std::string_view text, Face face, double size, double width) {
  if (text_width(text, face, size) <= width) return std::string(text);
  const std::u32string characters = code_points(text);
  for (std::size_t keep = characters.size(); keep > 0; --keep) {
    const std::size_t head = (keep + 1) / 2, tail = keep / 2;
    const std::string shorter =
        utf8_of(characters.substr(0, head)) + "…" + utf8_of(characters.substr(characters.size() - tail));
    if (text_width(shorter, face, size) <= width) return shorter;
  }
  return "…";
}

std::vector<std::string> wrapped(std::string_view text, Face face, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t space = text.find(' ');
    const std::string word(text.substr(0, space));
    text.remove_prefix(space == std::string_view::npos ? text.size() : space + 1);
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && text_width(longer, face, size) > width) {
      lines.push_back(std::move(line));
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(std::move(line));
  return lines;
}

std::vector<TextPiece> pieces_of(const TextShape& shape) {
  std::vector<TextPiece> pieces;
  double x = 0;
  const std::string_view text = shape.text;
  const auto put = [&](std::size_t begin, std::size_t end, Face face, Paint paint) {
    if (begin == end) return;
    const std::string_view part = text.substr(begin, end - begin);
    pieces.push_back({part, face, paint, x, text_width(part, face, shape.size)});
    x += pieces.back().width;
  };
  std::size_t at = 0;
  for (const TextSpan& span : shape.spans) {
    put(at, span.begin, shape.face, shape.paint);
    put(span.begin, span.end, span.face, span.paint);
    at = span.end;
  }
  put(at, text.size(), shape.face, shape.paint);
  return pieces;
}

Box TextShape::box() const {
  double width = any_script_within;
  if (width == 0)
    for (const TextPiece& piece : pieces_of(*this)) width += piece.width;
  const double left = align == Align::left ? 0 : align == Align::centre ? width / 2 : width;
  return {baseline.x - left, baseline.y - 0.78 * size, width, size};
}

}  // namespace gradus
