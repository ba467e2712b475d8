// A font file written from outlines: OpenType with a CFF table of Type 2 charstrings, wrapped as WOFF 1.
// https://learn.microsoft.com/typography/opentype/spec/, Adobe's Technical Notes 5176 and 5177,
// https://www.w3.org/TR/WOFF/

#include "cairo/web_font.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "cairo/deflated.hpp"
#include "cairo/fonts.hpp"
#include "figure/text/markup.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {

const std::string_view font_notice =
    "Letters: Inter, Copyright 2020 The Inter Project Authors (https://github.com/rsms/inter); JetBrains "
    "Mono, "
    "Copyright 2020 The JetBrains Mono Project Authors (https://github.com/JetBrains/JetBrainsMono). Only "
    "those "
    "used here, under other names, as the SIL Open Font License, Version 1.1, allows: this licence holds for "
    "them on (https://openfontlicense.org). What these lack: DejaVu, Copyright (c) 2003 Bitstream, Inc. "
    "(https://dejavu-fonts.github.io/License.html).";

namespace {

constexpr int em = 1000;  // fewer digits than 2048, and a tenth of a pixel in letters of 100
constexpr int ascent = 969, descent = 241;  // Inter's, for all faces: lines keep their height

/// Big-endian numbers, one after the other.
class Bytes {
 public:
  Bytes& u8(unsigned value) {
    text_ += static_cast<char>(static_cast<unsigned char>(value));
    return *this;
  }
  Bytes& u16(unsigned value) { return u8(value >> 8 & 255).u8(value & 255); }
  Bytes& i16(int value) { return u16(static_cast<unsigned>(value) & 0xffff); }
  Bytes& u32(std::uint32_t value) { return u16(value >> 16).u16(value & 0xffff); }
  Bytes& add(std::string_view bytes) {
    text_ += bytes;
    return *this;
  }
  Bytes& pad() {
    while (text_.size() % 4 != 0) u8(0);
    return *this;
  }
  std::size_t size() const { return text_.size(); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct Hull {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

struct Glyph {
  char32_t character = 0;
  int advance = em / 2;
  std::string charstring{};
  std::optional<Hull> bounds{};
};

// --- CFF -------------------------------------------------------------------------------------------------

/// A whole number as charstrings and dictionaries have it.
void put_operand(Bytes& out, int value) {
  if (-107 <= value && value <= 107) {
    out.u8(static_cast<unsigned>(value + 139));
  } else if (108 <= value && value <= 1131) {
    out.u8(static_cast<unsigned>((value - 108) / 256 + 247)).u8(static_cast<unsigned>((value - 108) % 256));
  } else if (-1131 <= value && value <= -108) {
    out.u8(static_cast<unsigned>((-value - 108) / 256 + 251)).u8(static_cast<unsigned>((-value - 108) % 256));
  } else {
    out.u8(28).i16(value);
  }
}

/// Outlines as a charstring. Operators of one kind that follow each other become one.
class Charstring {
 public:
  explicit Charstring(const std::vector<OutlinePiece>& pieces) {
    for (const OutlinePiece& piece : pieces) add(piece);
    flush();
    out_.u8(14);  // endchar
  }
  const std::string& text() const { return out_.text(); }
  const std::optional<Hull>& bounds() const { return bounds_; }

 private:
  static constexpr unsigned line = 5, curve = 8, move = 21;  // rlineto, rrcurveto, rmoveto
  static constexpr std::size_t most_operands = 48;

  void add(const OutlinePiece& piece) {
    switch (piece.kind) {
      case OutlinePiece::Kind::move:
        flush();
        return put(move, piece);
      case OutlinePiece::Kind::line:
        return put(line, piece);
      case OutlinePiece::Kind::curve:
        return put(curve, piece);
      case OutlinePiece::Kind::close:
        return;  // every move closes what was before it
    }
  }

  void put(unsigned kind, const OutlinePiece& piece) {
    if (kind != kind_ || operands_.size() + 2 * piece.points.size() > most_operands) flush();
    kind_ = kind;
    for (const dvec2 p : piece.points) {
      const ivec2 at{static_cast<int>(std::lround(p.x * em / units_per_em)),
                     static_cast<int>(std::lround(-p.y * em / units_per_em))};
      operands_.push_back(at.x - last_.x);
      operands_.push_back(at.y - last_.y);
      last_ = at;
      if (!bounds_) bounds_ = Hull{at.x, at.y, at.x, at.y};
      bounds_ = Hull{std::min(bounds_->x0, at.x), std::min(bounds_->y0, at.y), std::max(bounds_->x1, at.x),
                     std::max(bounds_->y1, at.y)};
    }
  }

  void flush() {
    if (operands_.empty()) return;
    for (const int operand : operands_) put_operand(out_, operand);
    out_.u8(kind_);
    operands_.clear();
  }

  Bytes out_;
  unsigned kind_ = 0;
  std::vector<int> operands_;
  ivec2 last_{0, 0};
  std::optional<Hull> bounds_;
};

std::string index_of(const std::vector<std::string>& items) {
  Bytes out;
  out.u16(static_cast<unsigned>(items.size()));
  if (items.empty()) return out.text();
  std::uint32_t offset = 1;
  out.u8(4).u32(offset);
  for (const std::string& item : items) out.u32(offset += static_cast<std::uint32_t>(item.size()));
  for (const std::string& item : items) out.add(item);
  return out.text();
}

/// A number that always takes five bytes: where offsets stand does not move them.
void put_offset(Bytes& out, std::size_t value) { out.u8(29).u32(static_cast<std::uint32_t>(value)); }

std::string cff_of(const std::string& name, const std::vector<Glyph>& glyphs, const Hull& bounds) {
  // Glyphs are called as the standard's first strings, and where those end by numbers; nobody asks for the
  // names
  constexpr std::size_t standard_strings = 391;
  std::vector<std::string> names, charstrings;
  for (std::size_t i = standard_strings; i < glyphs.size(); ++i) names.push_back(fmt::format("g{}", i));
  for (const Glyph& glyph : glyphs) charstrings.push_back(glyph.charstring);
  const std::string head = Bytes().u8(1).u8(0).u8(4).u8(4).text() + index_of({name}),
                    strings = index_of(names), no_subroutines = index_of({}),
                    charset = Bytes().u8(2).u16(1).u16(static_cast<unsigned>(glyphs.size() - 2)).text(),
                    outlines = index_of(charstrings),
                    priv = Bytes().u8(139).u8(20).text();  // default width 0
  const auto dictionary = [&](std::size_t from) {
    Bytes out;
    for (const int side : {bounds.x0, bounds.y0, bounds.x1, bounds.y1}) put_operand(out, side);
    out.u8(5);
    put_offset(out, from);
    out.u8(15);
    put_offset(out, from + charset.size());
    out.u8(17);
    put_offset(out, priv.size());
    put_offset(out, from + charset.size() + outlines.size());
    out.u8(18);
    return index_of({out.text()});
  };
  const std::size_t tables = head.size() + dictionary(0).size() + strings.size() + no_subroutines.size();
  return head + dictionary(tables) + strings + no_subroutines + charset + outlines + priv;
}

// --- The other tables ------------------------------------------------------------------------------------

/// Format 4: stretches of characters whose glyphs follow each other, too.
std::string cmap_of(const std::vector<Glyph>& glyphs) {
  struct Stretch {
    unsigned first, last, glyph;
  };
  std::vector<Stretch> all;
  for (std::size_t i = 1; i < glyphs.size(); ++i) {
    const auto character = static_cast<unsigned>(glyphs[i].character);
    if (!all.empty() && all.back().last + 1 == character) {
      all.back().last = character;
    } else {
      all.push_back({character, character, static_cast<unsigned>(i)});
    }
  }
  all.push_back({0xffff, 0xffff, 0});
  const auto count = static_cast<unsigned>(all.size());
  unsigned power = 1, exponent = 0;
  for (; 2 * power <= count; power *= 2) ++exponent;
  Bytes table;
  table.u16(4)
      .u16(16 + 8 * count)
      .u16(0)
      .u16(2 * count)
      .u16(2 * power)
      .u16(exponent)
      .u16(2 * (count - power));
  for (const Stretch& s : all) table.u16(s.last);
  table.u16(0);
  for (const Stretch& s : all) table.u16(s.first);
  for (const Stretch& s : all) table.u16((s.first == 0xffff ? 1 : s.glyph - s.first) & 0xffff);
  for (std::size_t i = 0; i < all.size(); ++i) table.u16(0);
  return Bytes().u16(0).u16(1).u16(3).u16(1).u32(12).add(table.text()).text();
}

std::string names_of(const std::string& family, std::string_view style) {
  const auto wide = [](std::string_view text) {  // UTF-16
    Bytes out;
    for (const char c : text) out.u16(static_cast<unsigned char>(c));
    return out.text();
  };
  const std::string full = fmt::format("{} {}", family, style);
  std::string plain = full;
  std::erase(plain, ' ');
  const std::array<std::pair<unsigned, std::string>, 6> names{
      {{0, wide(font_notice)},
       {1, wide(family)},
       {2, wide(style)},
       {4, wide(full)},
       {6, wide(plain)},
       {13, wide("SIL Open Font License, Version 1.1")}}};
  Bytes head, texts;
  head.u16(0).u16(names.size()).u16(6 + 12 * names.size());
  for (const auto& [id, text] : names) {
    head.u16(3).u16(1).u16(0x409).u16(id).u16(static_cast<unsigned>(text.size()));
    head.u16(static_cast<unsigned>(texts.size()));
    texts.add(text);
  }
  return head.text() + texts.text();
}

struct Style {
  std::string family;
  std::string_view name;
  bool bold = false, italic = false;
};

Style style_of(Face face) {
  switch (face) {
    case Face::sans:
      break;
    case Face::bold:
      return {"Gradus Sans", "Bold", true, false};
    case Face::italic:
      return {"Gradus Sans", "Italic", false, true};
    case Face::mono:
      return {"Gradus Mono", "Regular", false, false};
    case Face::mono_bold:
      return {"Gradus Mono", "Bold", true, false};
    case Face::bold_italic:
      return {"Gradus Sans", "Bold Italic", true, true};
  }
  return {"Gradus Sans", "Regular", false, false};
}

Hull hull_of(const std::vector<Glyph>& glyphs) {
  Hull all;
  for (const Glyph& glyph : glyphs) {
    if (!glyph.bounds) continue;
    all = {std::min(all.x0, glyph.bounds->x0), std::min(all.y0, glyph.bounds->y0),
           std::max(all.x1, glyph.bounds->x1), std::max(all.y1, glyph.bounds->y1)};
  }
  return all;
}

int widest(const std::vector<Glyph>& glyphs) {
  return std::ranges::max_element(glyphs, {}, &Glyph::advance)->advance;
}

std::string head_of(const Style& style, const Hull& b) {
  const unsigned look = (style.bold ? 1u : 0u) | (style.italic ? 2u : 0u);
  Bytes out;
  out.u32(0x00010000).u32(0x00010000).u32(0).u32(0x5f0f3cf5).u16(3).u16(em);
  out.add(std::string(16, '\0'));  // made and changed: no time, so that the bytes are the same
  out.i16(b.x0).i16(b.y0).i16(b.x1).i16(b.y1).u16(look).u16(8).i16(2).i16(0).i16(0);
  return out.text();
}

std::string hhea_of(const std::vector<Glyph>& glyphs, const Hull& b) {
  Bytes out;
  out.u32(0x00010000).i16(ascent).i16(-descent).i16(0).u16(static_cast<unsigned>(widest(glyphs)));
  out.i16(b.x0).i16(0).i16(b.x1).i16(1).i16(0).add(std::string(12, '\0'));
  return out.u16(static_cast<unsigned>(glyphs.size())).text();
}

std::string os2_of(const Style& style, const std::vector<Glyph>& glyphs) {
  const unsigned selection = 1u << 7 | (style.bold ? 1u << 5 : 0u) | (style.italic ? 1u : 0u) |
                             (style.bold || style.italic ? 0u : 1u << 6);
  Bytes out;
  out.u16(4).i16(em / 2).u16(style.bold ? 700 : 400).u16(5).u16(0);
  for (const int script : {650, 600, 0, 75, 650, 600, 0, 350, 50, 300}) out.i16(script);
  out.add(std::string(2 + 10 + 16, '\0'));  // class, PANOSE, ranges of Unicode: none is claimed
  out.add("    ").u16(selection).u16(static_cast<unsigned>(glyphs[1].character));
  out.u16(static_cast<unsigned>(glyphs.back().character));
  out.i16(ascent).i16(-descent).i16(0).u16(ascent).u16(descent).u32(1).u32(0).i16(546).i16(727);
  return out.u16(0).u16(32).u16(0).text();
}

// --- The file --------------------------------------------------------------------------------------------

struct Table {
  std::string_view tag;
  std::string data;
};

std::uint32_t checksum_of(const std::string& table) {
  const std::string padded = Bytes().add(table).pad().text();
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < padded.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k) word = word << 8 | static_cast<unsigned char>(padded[i + k]);
    sum += word;
  }
  return sum;
}

/// Packed by zlib, or as it is where that is no longer.
std::string packed(const std::string& table) {
  std::string out = deflated(table);
  return out.size() < table.size() ? out : table;
}

std::string woff_of(const std::vector<Table>& tables) {
  const auto count = static_cast<unsigned>(tables.size());
  Bytes directory, data;
  std::size_t unpacked = 12 + 16 * tables.size();
  for (const Table& table : tables) {
    const std::string body = packed(table.data);
    directory.add(table.tag).u32(static_cast<std::uint32_t>(44 + 20 * tables.size() + data.size()));
    directory.u32(static_cast<std::uint32_t>(body.size())).u32(static_cast<std::uint32_t>(table.data.size()));
    directory.u32(checksum_of(table.data));
    data.add(body).pad();
    unpacked += (table.data.size() + 3) / 4 * 4;
  }
  Bytes out;
  out.add("wOFFOTTO").u32(static_cast<std::uint32_t>(44 + directory.size() + data.size())).u16(count).u16(0);
  out.u32(static_cast<std::uint32_t>(unpacked)).u16(1).u16(0);
  out.add(std::string(20, '\0'));  // neither metadata nor private data
  return out.add(directory.text()).add(data.text()).text();
}

Glyph glyph_of(char32_t character, Face face) {
  const Charstring outline(outline_pieces(character, face));
  const double width = text_width(utf8_of({&character, 1}), face, em);
  return {character, static_cast<int>(std::lround(width)), outline.text(), outline.bounds()};
}

}  // namespace

std::string web_font(Face face, std::u32string_view characters) {
  check_fonts();
  std::set<char32_t> wanted{U' '};
  for (const char32_t c : characters) {
    if (c < 0xffff && missing_characters(utf8_of({&c, 1}), face).empty()) wanted.insert(c);
  }
  std::vector<Glyph> glyphs{Glyph{0, em / 2, Charstring({}).text()}};
  for (const char32_t c : wanted) glyphs.push_back(glyph_of(c, face));
  const Style style = style_of(face);
  const Hull bounds = hull_of(glyphs);
  Bytes widths;
  for (const Glyph& glyph : glyphs) {
    widths.u16(static_cast<unsigned>(glyph.advance)).i16(glyph.bounds ? glyph.bounds->x0 : 0);
  }
  std::string plain = style.family + "-" + std::string(style.name);
  std::erase(plain, ' ');
  return woff_of(
      {{"CFF ", cff_of(plain, glyphs, bounds)},
       {"OS/2", os2_of(style, glyphs)},
       {"cmap", cmap_of(glyphs)},
       {"head", head_of(style, bounds)},
       {"hhea", hhea_of(glyphs, bounds)},
       {"hmtx", widths.text()},
       {"maxp", Bytes().u32(0x00005000).u16(static_cast<unsigned>(glyphs.size())).text()},
       {"name", names_of(style.family, style.name)},
       {"post", Bytes().u32(0x00030000).u32(0).i16(-100).i16(50).u32(0).add(std::string(16, '\0')).text()}});
}

std::string font_rules(std::u32string_view characters) {
  std::string rules = fmt::format("/* {} */\n", font_notice);
  for (const Face face : all_faces) {
    const Style style = style_of(face);
    rules += fmt::format(
        "@font-face {{ font-family: \"{}\"; font-weight: {}; font-style: {}; src: "
        "url(data:font/woff;base64,{}) format(\"woff\"); }}\n",
        style.family, style.bold ? 700 : 400, style.italic ? "italic" : "normal",
        base64(web_font(face, characters)));
  }
  return rules;
}

}  // namespace gradus
