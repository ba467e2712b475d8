// SVG of our own: Cairo's has neither groups nor ids, and takes its time over numbers.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "cairo/cairo_output.hpp"
#include "cairo/fonts.hpp"
#include "cairo/metadata.hpp"
#include "cairo/shapes.hpp"
#include "cairo/web_font.hpp"
#include "figure/text/markup.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

constexpr std::string_view name_of(Tone tone) {
  constexpr std::array<std::string_view, 9> names{"paper", "panel", "header", "weak",  "strong",
                                                  "rule",  "ink",   "muted",  "accent"};
  return names[static_cast<std::size_t>(tone)];
}

constexpr std::string_view name_of(Face face) {
  constexpr std::array<std::string_view, 6> names{"sans", "bold",      "italic",
                                                  "mono", "mono-bold", "bold-italic"};
  return names[static_cast<std::size_t>(face)];
}

/// Two decimals at most, without trailing zeros: a hundredth of a pixel is not seen.
void put(std::string& text, double value) {
  auto hundredths = static_cast<std::int64_t>(std::llround(value * 100));
  if (hundredths < 0) text += '-', hundredths = -hundredths;
  char digits[24];
  char* const end = digits + sizeof digits;
  char* at = end;
  const auto fraction = hundredths % 100;
  if (fraction != 0) {
    if (fraction % 10 != 0) *--at = static_cast<char>('0' + fraction % 10);
    *--at = static_cast<char>('0' + fraction / 10);
    *--at = '.';
  }
  auto whole = hundredths / 100;
  do {
    *--at = static_cast<char>('0' + whole % 10);
    whole /= 10;
  } while (whole != 0);
  text.append(at, end);
}

std::string_view text_of(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Every cell repeated until one is no wider than two pixels of the figure: librsvg and others smooth
/// pictures whatever the file says, and so smooth the rims only.
Image enlarged(const Image& image, const Box& box) {
  const int times = std::clamp(static_cast<int>(box.width / image.width() / 2), 1, 32);
  if (times == 1) return image;
  Image large(times * image.width(), times * image.height());
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) large[{x, y}] = image[{x / times, y / times}];
  }
  return large;
}

/// What a shape shows: the role it is painted in, else the furniture's tone.
struct Subject {
  std::string_view kind, name;  ///< "role", "current"
  friend bool operator==(const Subject&, const Subject&) = default;
};

Subject subject_of(std::initializer_list<Paint> paints) {
  for (const Paint& paint : paints) {
    if (paint.part != Paint::Part::none && paint.part != Paint::Part::tone)
      return {"role", name_of(paint.role)};
  }
  for (const Paint& paint : paints) {
    if (paint.part == Paint::Part::tone) return {"tone", name_of(paint.tone)};
  }
  return {"tone", name_of(Tone::paper)};
}

struct SubjectOf {
  Subject operator()(const RectShape& s) const { return subject_of({s.fill, s.stroke}); }
  Subject operator()(const AreaShape& s) const { return subject_of({s.fill}); }
  Subject operator()(const LineShape& s) const { return subject_of({s.stroke}); }
  Subject operator()(const StrokesShape& s) const { return subject_of({s.stroke}); }
  Subject operator()(const DiscShape& s) const { return subject_of({s.fill, s.stroke}); }
  Subject operator()(const TextShape& s) const { return subject_of({s.paint}); }
  Subject operator()(const ImageShape&) const { return {"tone", "picture"}; }
};

class SvgWriter {
 public:
  SvgWriter(const Sheet& sheet, const Finish& finish) : sheet_(sheet), finish_(finish), unit_(sheet.unit) {}

  std::string write(const Colophon& colophon) {
    if (!finish_.transparent) draw_ground();
    for (const Shape& shape : sheet_.shapes) {
      enter(shape.slot, std::visit(SubjectOf{}, shape.what));
      id_ = shape.id;
      opacity_ = shape.opacity;
      std::visit([this](const auto& what) { draw(what); }, shape.what);
    }
    leave();
    const std::string names = name_suffix(colophon);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" {0} "
        "role=\"img\" aria-labelledby=\"title-{1} desc-{1}\" fill=\"none\" stroke-miterlimit=\"10\" "
        "font-family=\"'Gradus Sans',Inter,'DejaVu Sans',Verdana,sans-serif\">\n{2}{3}{4}</svg>\n",
        size(), names, svg_head(colophon, names), finish_.svg_text == SvgText::text ? fonts() : glyphs(),
        body_);
  }

 private:
  std::string size() const {
    std::string width, height;
    put(width, sheet_.width);
    put(height, sheet_.height);
    return fmt::format("width=\"{0}px\" height=\"{1}px\" viewBox=\"0 0 {0} {1}\"", width, height);
  }

  // --- Groups: closed and opened again where the drawing order asks for it ---------------------------------

  void enter(Slot slot, Subject subject) {
    if (slot_ == slot && subject_ == subject) return;
    if (slot_ != slot) {
      leave();
      open(std::string(gradus::name_of(slot)), "slot", gradus::name_of(slot));
    } else {
      body_ += "</g>\n";
    }
    open(fmt::format("{}-{}", gradus::name_of(slot), subject.name), subject.kind, subject.name);
    slot_ = slot;
    subject_ = subject;
  }

  void leave() {
    if (slot_) body_ += "</g>\n</g>\n";
    slot_.reset();
  }

  void open(const std::string& id, std::string_view kind, std::string_view name) {
    const int count = ++opened_[id];
    body_ += fmt::format("<g id=\"{}{}\" class=\"{}-{}\">\n", id, count > 1 ? fmt::format("-{}", count) : "",
                         kind, name);
  }

  // --- Elements --------------------------------------------------------------------------------------------

  void begin(std::string_view element) {
    body_ += '<';
    body_ += element;
    if (!id_.empty()) attribute("data-id", escaped(id_));
    if (opacity_ < 1) attribute("opacity", opacity_);
  }
  void end() { body_ += "/>\n"; }

  void attribute(std::string_view name, std::string_view value) {
    body_ += ' ';
    body_ += name;
    body_ += "=\"";
    body_ += value;
    body_ += '"';
  }
  void attribute(std::string_view name, double value) {
    body_ += ' ';
    body_ += name;
    body_ += "=\"";
    put(body_, value);
    body_ += '"';
  }
  void color(std::string_view name, Paint paint) {
    if (paint.part == Paint::Part::none) return;
    attribute(name, fmt::format("#{:06x}", color_of(paint, finish_.theme).hex));
  }
  void stroke(Paint paint, double width, bool dashed = false) {
    if (paint.part == Paint::Part::none || width <= 0) return;
    color("stroke", paint);
    attribute("stroke-width", width);
    if (!dashed) return;
    const auto [on, off] = dashes(width);
    body_ += " stroke-dasharray=\"";
    pair({on, off});
    body_ += '"';
  }
  void pair(dvec2 p) {
    put(body_, p.x);
    body_ += ' ';
    put(body_, p.y);
  }

  // --- Shapes ----------------------------------------------------------------------------------------------

  void draw_ground() {
    body_ += "<rect id=\"paper\" class=\"tone-paper\"";
    attribute("width", sheet_.width);
    attribute("height", sheet_.height);
    color("fill", Paint::of(Tone::paper));
    end();
  }

  void begin_rectangle(const RectShape& rect) {
    begin("rect");
    attribute("x", rect.box.x);
    attribute("y", rect.box.y);
    attribute("width", rect.box.width);
    attribute("height", rect.box.height);
    if (rect.radius > 0) attribute("rx", rect.radius);
  }

  void draw(const RectShape& plain) {
    const RectShape rect = shown_in(finish_.theme, plain, unit_);
    const bool filled = rect.fill.part != Paint::Part::none, hatched = rect.hatch != Hatch::none,
               stroked = rect.stroke.part != Paint::Part::none && rect.stroke_width > 0;
    if (filled || (stroked && !hatched)) {
      begin_rectangle(rect);
      color("fill", rect.fill);
      if (!hatched) stroke(rect.stroke, rect.stroke_width, rect.dashed);
      end();
    }
    if (!hatched) return;
    segments(hatch_lines(rect, unit_), rect.hatch_paint, hatch_width(unit_), false);
    if (!stroked) return;
    begin_rectangle(rect);
    stroke(rect.stroke, rect.stroke_width, rect.dashed);
    end();
  }

  void draw(const AreaShape& plain) {
    const AreaShape area = shown_in(finish_.theme, plain);
    begin("path");
    color("fill", area.fill);
    attribute("fill-rule", "evenodd");
    body_ += " d=\"";
    for (const auto& ring : area.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        body_ += i == 0 ? 'M' : 'L';
        pair(ring[i]);
      }
      body_ += 'Z';
    }
    body_ += '"';
    end();
    segments(hatch_lines(area, unit_), area.hatch_paint, hatch_width(unit_), false);
  }

  void segments(const std::vector<Segment<2, double>>& lines, Paint paint, double width, bool round) {
    if (lines.empty()) return;
    begin("path");
    stroke(paint, width);
    if (round) attribute("stroke-linecap", "round");
    body_ += " d=\"";
    for (const auto& [from, to] : lines) {
      body_ += 'M';
      pair(from);
      if (from.y == to.y) {
        body_ += 'H';
        put(body_, to.x);
      } else if (from.x == to.x) {
        body_ += 'V';
        put(body_, to.y);
      } else {
        body_ += 'L';
        pair(to);
      }
    }
    body_ += '"';
    end();
  }

  void draw(const StrokesShape& strokes) {
    segments(strokes.segments, strokes.stroke, strokes.width, strokes.round);
  }

  void draw(const LineShape& line) {
    if (line.points.size() < 2) return;
    begin("path");
    stroke(line.stroke, line.width, line.dashed);
    body_ += " d=\"M";
    pair(line.points[0]);
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      body_ += 'L';
      pair(line.points[i]);
    }
    if (line.closed) body_ += 'Z';
    body_ += '"';
    end();
    if (const auto head = arrow_head(line, unit_)) draw(*head, line.stroke);
  }

  void draw(const ArrowHead& head, Paint paint) {
    begin("path");
    color("fill", paint);
    body_ += " d=\"M";
    pair(head.tip);
    body_ += 'L';
    pair(head.left);
    body_ += 'L';
    pair(head.right);
    body_ += "Z\"";
    end();
  }

  void draw(const DiscShape& disc) {
    begin("circle");
    attribute("cx", disc.centre.x);
    attribute("cy", disc.centre.y);
    attribute("r", disc.radius);
    color("fill", disc.fill);
    stroke(disc.stroke, disc.stroke_width);
    end();
  }

  void draw(const ImageShape& shape) {
    if (shape.image.width() == 0 || shape.image.height() == 0) return;
    begin("image");
    attribute("x", shape.box.x);
    attribute("y", shape.box.y);
    attribute("width", shape.box.width);
    attribute("height", shape.box.height);
    body_ += " preserveAspectRatio=\"none\" ";
    // Two words for one wish: browsers know the style, older programs the attribute
    if (!shape.smooth) body_ += "image-rendering=\"optimizeSpeed\" style=\"image-rendering:pixelated\" ";
    body_ += "xlink:href=\"data:image/png;base64,";
    const Image pixels = pixels_of(shape, finish_.theme);
    body_ += base64(text_of(encode_png(shape.smooth ? pixels : enlarged(pixels, shape.box))));
    body_ += '"';
    end();
  }

  void draw(const TextShape& text) {
    const auto show = finish_.svg_text == SvgText::text ? &SvgWriter::letters : &SvgWriter::outlines;
    // The rim below all letters, not below each: it would cut into the one before
    if (text.halo) (this->*show)(text, true);
    if (text.is_rim()) return;
    (this->*show)(text, false);
    for (const TextPiece& piece : pieces_of(text)) {
      if (const auto line = underline(piece, text, finish_.theme)) draw(*line, piece.paint);
    }
  }

  void draw(const Underline& line, Paint paint) {
    begin("path");
    stroke(paint, line.width, line.dashed);
    body_ += " d=\"M";
    pair(line.segment.a);
    body_ += 'H';
    put(body_, line.segment.b.x);
    body_ += '"';
    end();
  }

  /// `rim` scaled to the units the letters are drawn in.
  void ink(const TextShape& text, bool rim, double scale) {
    if (!rim) return color("fill", text.paint);
    stroke(text.ground, halo_width(text) / scale);
    attribute("stroke-linejoin", "round");
  }

  void outlines(const TextShape& text, bool rim) {
    const double scale = text.size / units_per_em;
    begin("g");
    ink(text, rim, scale);
    body_ += " transform=\"translate(";
    pair({text.box().x, text.baseline.y});
    body_ += fmt::format(")scale({:.7g})\">", scale);
    for (const TextPiece& piece : pieces_of(text)) {
      const bool own = !rim && piece.paint != text.paint;
      if (own) {
        body_ += "<g";
        color("fill", piece.paint);
        body_ += '>';
      }
      double x = piece.x / scale;
      for (const char32_t character : code_points(piece.text)) {
        use_glyph(character, piece.face, x);
        x += text_width(utf8_of({&character, 1}), piece.face, units_per_em);
      }
      if (own) body_ += "</g>";
    }
    body_ += "</g>\n";
  }

  void use_glyph(char32_t character, Face face, double x) {
    const auto known = glyphs_.find({face, character});
    const std::string& outline = known != glyphs_.end() ? *known->second : outline_of(character, face);
    if (outline.empty()) return;
    if (known == glyphs_.end()) glyphs_.emplace(std::pair{face, character}, &outline);
    body_ +=
        fmt::format("<use xlink:href=\"#{}-{:x}\"", name_of(face), static_cast<std::uint32_t>(character));
    if (x != 0) attribute("x", x);
    body_ += "/>";
  }

  /// Every letter used, once. A letter's id says what it is, so files that share a page may share them.
  std::string glyphs() const {
    if (glyphs_.empty()) return "";
    std::string text = "<defs>\n";
    for (const auto& [glyph, outline] : glyphs_) {
      text += fmt::format("<path id=\"{}-{:x}\" d=\"{}\"/>\n", name_of(glyph.first),
                          static_cast<std::uint32_t>(glyph.second), *outline);
    }
    return text + "</defs>\n";
  }

  /// The fonts for the letters of all texts: the file opens anywhere without them.
  std::string fonts() const {
    std::u32string characters;
    for (const Shape& shape : sheet_.shapes) {
      if (const auto* text = std::get_if<TextShape>(&shape.what)) characters += code_points(text->text);
    }
    return fmt::format("<style>\n{}</style>\n", font_rules(characters));
  }

  void letters(const TextShape& text, bool rim) {
    begin("text");
    attribute("x", text.baseline.x);
    attribute("y", text.baseline.y);
    attribute("font-size", text.size);
    style(text.face);
    if (text.face == Face::mono || text.face == Face::mono_bold) {
      attribute("font-family", "'Gradus Mono','JetBrains Mono','DejaVu Sans Mono',Menlo,Consolas,monospace");
    }
    if (text.align != Align::left) attribute("text-anchor", text.align == Align::centre ? "middle" : "end");
    // Another machine's font keeps our width
    attribute("textLength", text.box().width);
    attribute("lengthAdjust", "spacingAndGlyphs");
    ink(text, rim, 1);
    if (rim) attribute("aria-hidden", "true");
    // Else the indentation of a listing would be lost
    if (text.text.starts_with(' ') || text.text.find("  ") != std::string::npos)
      attribute("xml:space", "preserve");
    body_ += '>';
    for (const TextPiece& piece : pieces_of(text)) {
      const bool own = piece.face != text.face || piece.paint != text.paint;
      if (own) {
        body_ += "<tspan";
        style(piece.face);
        if (!rim) color("fill", piece.paint);
        body_ += '>';
      }
      body_ += escaped(piece.text);
      if (own) body_ += "</tspan>";
    }
    body_ += "</text>\n";
  }

  void style(Face face) {
    if (face == Face::bold || face == Face::mono_bold || face == Face::bold_italic)
      attribute("font-weight", "bold");
    if (face == Face::italic || face == Face::bold_italic) attribute("font-style", "italic");
  }

  const Sheet& sheet_;
  const Finish& finish_;
  double unit_;
  std::string body_, id_;
  double opacity_ = 1;
  std::optional<Slot> slot_;  ///< of the open groups
  Subject subject_;
  std::map<std::string, int> opened_;  ///< how often each group was
  std::map<std::pair<Face, char32_t>, const std::string*> glyphs_;
};

}  // namespace

std::string svg_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon) {
  check_fonts();
  return SvgWriter(sheet, finish).write(colophon);
}

}  // namespace gradus
