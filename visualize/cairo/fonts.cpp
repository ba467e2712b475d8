#include "cairo/fonts.hpp"

#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "cairo/handles.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

// --- Fonts -----------------------------------------------------------------------------------------------

/// By Face, as fontconfig calls them: the font, the one that it borrows some letters from, and the one that
/// stands in for letters that these lack (see tests/support/font_metrics.py). Cairo's own words for weights
/// know none between medium and bold. At most ten font files in all: Cairo 1.16 keeps as many open, and when
/// it needs one more closes another, even while a second thread is about to read it.
using FontNames = std::array<const char*, 3>;
constexpr std::array<FontNames, 6> font_names{{
    {"Inter:regular", "Inter:regular", "DejaVu Sans:book"},
    {"Inter:bold", "Inter:regular", "DejaVu Sans:bold"},
    {"Inter:regular:italic", "Inter:regular:italic", "DejaVu Sans:book:oblique"},
    {"JetBrains Mono:regular", "Inter:regular", "DejaVu Sans Mono:book"},
    {"JetBrains Mono:bold", "Inter:bold", "DejaVu Sans Mono:book"},
    {"Inter:bold:italic", "Inter:regular:italic", "DejaVu Sans:bold"},
}};

bool is_mono(Face face) { return face == Face::mono || face == Face::mono_bold; }
bool is_raised(char32_t c) { return c == U'²' || c == U'³' || c == U'¹' || (0x2070 <= c && c <= 0x209c); }

/// Raised letters need no typewriter's room: 10⁻⁴ would fall apart. Inter's bold space is so narrow that
/// words run together.
bool is_borrowed(char32_t c, Face face) {
  if (face == Face::bold || face == Face::bold_italic) return c == U' ' || c == U'\u00a0';
  return is_mono(face) && is_raised(c);
}

FontOptions unhinted() {
  FontOptions options(cairo().font_options_create());
  cairo().font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo().font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo().font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  return options;
}

/// A font, and at a size of one em in units.
struct Font {
  FontFace face;
  ScaledFont scaled;

  explicit Font(const char* name) {
    const FontPattern pattern(cairo().FcNameParse(reinterpret_cast<const FcChar8*>(name)));
    face.reset(cairo().ft_font_face_create_for_pattern(pattern.get()));
    check(cairo().font_face_status(face.get()));
    cairo_matrix_t size, page;
    cairo().matrix_init_scale(&size, units_per_em, units_per_em);
    cairo().matrix_init_identity(&page);
    scaled.reset(cairo().scaled_font_create(face.get(), &size, &page, unhinted().get()));
    check(cairo().scaled_font_status(scaled.get()));
  }

  /// 0 where the font lacks the letter.
  unsigned long glyph_of(char32_t character) const {
    const std::string text = utf8_of({&character, 1});
    cairo_glyph_t one{};
    cairo_glyph_t* glyphs = &one;
    int count = 1;
    check(cairo().scaled_font_text_to_glyphs(scaled.get(), 0, 0, text.c_str(), static_cast<int>(text.size()),
                                             &glyphs, &count, nullptr, nullptr, nullptr));
    const unsigned long index = count > 0 ? glyphs[0].index : 0;
    if (glyphs != &one) cairo().glyph_free(glyphs);
    return index;
  }

  double advance_of(unsigned long glyph) const {
    const cairo_glyph_t glyphs{glyph, 0, 0};
    cairo_text_extents_t extents;
    cairo().scaled_font_glyph_extents(scaled.get(), &glyphs, 1, &extents);
    return extents.x_advance;
  }
};

/// What draws a letter.
struct Letter {
  const Font* font;
  unsigned long glyph;
  double advance;  ///< by the table of widths, in units
};

/// The fonts of a face and its letters met so far. Safe in threads.
class Typeface {
 public:
  explicit Typeface(Face face) : Typeface(face, font_names[static_cast<std::size_t>(face)]) {}

  static Typeface& of(Face face) {
    static std::array<Typeface, 6> all{Typeface(Face::sans),      Typeface(Face::bold),
                                       Typeface(Face::italic),    Typeface(Face::mono),
                                       Typeface(Face::mono_bold), Typeface(Face::bold_italic)};
    return all[static_cast<std::size_t>(face)];
  }

  std::vector<Letter> letters_of(std::u32string_view text) {
    const std::lock_guard lock(*mutex_);
    std::vector<Letter> letters;
    letters.reserve(text.size());
    for (const char32_t character : text) {
      const auto [entry, added] = known_.try_emplace(character);
      if (added) entry->second = find(character);
      letters.push_back(entry->second);
    }
    return letters;
  }

  /// As wide as Cairo draws it; a letter that stands in among a typewriter's takes the room of one of them.
  double advance_of(const Letter& letter) const {
    if (is_mono(face_) && letter.font == &stand_in_) return own_.advance_of(own_.glyph_of(U'm'));
    return letter.font->advance_of(letter.glyph);
  }

 private:
  Typeface(Face face, const FontNames& names)
      : face_(face), own_(names[0]), lender_(names[1]), stand_in_(names[2]) {}

  Letter find(char32_t character) const {
    const double advance = text_width(utf8_of({&character, 1}), face_, units_per_em);
    const Font& first = is_borrowed(character, face_) ? lender_ : own_;
    for (const Font* font : {&first, &own_}) {
      if (const unsigned long glyph = font->glyph_of(character)) return {font, glyph, advance};
    }
    return {&stand_in_, stand_in_.glyph_of(character), advance};
  }

  Face face_;
  Font own_, lender_, stand_in_;
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  std::map<char32_t, Letter> known_;
};

/// Neighbouring letters of one font, with the text they stand for.
struct Run {
  const Font* font = nullptr;
  std::string text{};
  std::vector<cairo_glyph_t> glyphs{};
  std::vector<cairo_text_cluster_t> clusters{};
};

std::vector<Run> runs_of(std::string_view text, Face face, double size, dvec2 at) {
  const std::u32string characters = code_points(text);
  const std::vector<Letter> letters = Typeface::of(face).letters_of(characters);
  std::vector<Run> runs;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (runs.empty() || runs.back().font != letters[i].font) runs.push_back({letters[i].font});
    const std::string one = utf8_of({&characters[i], 1});
    runs.back().text += one;
    runs.back().glyphs.push_back({letters[i].glyph, at.x, at.y});
    runs.back().clusters.push_back({static_cast<int>(one.size()), 1});
    at.x += letters[i].advance * size / units_per_em;
  }
  return runs;
}

// --- Outlines --------------------------------------------------------------------------------------------

/// An outline as path data with relative whole numbers. Curves of fonts that have quadratic ones come as
/// cubic ones from Cairo, and are written as what they were.
class PathData {
 public:
  void add(const OutlinePiece& piece) {
    const std::vector<dvec2>& p = piece.points;
    switch (piece.kind) {
      case OutlinePiece::Kind::move:
        last_ = {};  // Cairo closes, then moves: absolute coordinates need no memory of where that left off
        put('M', {p[0]});
        start_ = last_;
        break;
      case OutlinePiece::Kind::line:
        put('l', {p[0]});
        break;
      case OutlinePiece::Kind::curve:
        curve(p[0], p[1], p[2]);
        break;
      case OutlinePiece::Kind::close:
        text_ += 'z';
        last_ = start_;
        break;
    }
  }

  std::string take() { return std::move(text_); }

 private:
  void curve(dvec2 a, dvec2 b, dvec2 end) {
    const dvec2 from_a = (3.0 * a - last_) / 2.0, from_b = (3.0 * b - end) / 2.0;
    if (std::hypot(from_a.x - from_b.x, from_a.y - from_b.y) < 1) return put('q', {from_a, end});
    put('c', {a, b, end});
  }

  /// Numbers apart only where digits would run together.
  void put(char command, std::initializer_list<dvec2> points) {
    text_ += command;
    bool first = true;
    const dvec2 from = last_;
    for (const dvec2& p : points) {
      for (const double offset : {std::round(p.x) - from.x, std::round(p.y) - from.y}) {
        const long value = std::lround(offset);
        if (!first && value >= 0) text_ += ' ';
        text_ += std::to_string(value);
        first = false;
      }
      last_ = {std::round(p.x), std::round(p.y)};
    }
  }

  std::string text_;
  dvec2 last_{}, start_{};
};

OutlinePiece piece_of(const cairo_path_data_t* data) {
  const auto point = [data](int i) { return dvec2{data[i].point.x, data[i].point.y}; };
  switch (data->header.type) {
    case CAIRO_PATH_MOVE_TO:
      return {OutlinePiece::Kind::move, {point(1)}};
    case CAIRO_PATH_LINE_TO:
      return {OutlinePiece::Kind::line, {point(1)}};
    case CAIRO_PATH_CURVE_TO:
      return {OutlinePiece::Kind::curve, {point(1), point(2), point(3)}};
    case CAIRO_PATH_CLOSE_PATH:
      break;
  }
  return {OutlinePiece::Kind::close, {}};
}

/// From now on the context draws with this font. What Cairo makes of it for the size stays until the program
/// ends: Cairo 1.16 fails an assertion when one thread lets go of the last of such a font while another one
/// finds it again.
void set_font(cairo_t* context, const Font& font, double size) {
  static std::mutex mutex;
  static std::map<cairo_scaled_font_t*, ScaledFont> kept;
  cairo().set_font_face(context, font.face.get());
  cairo().set_font_size(context, size);
  cairo_scaled_font_t* const scaled = cairo().get_scaled_font(context);
  const std::lock_guard lock(mutex);
  const auto [at, is_new] = kept.try_emplace(scaled);
  if (is_new) at->second.reset(cairo().scaled_font_reference(scaled));
}

}  // namespace

void set_font_options(cairo_t* context) { cairo().set_font_options(context, unhinted().get()); }

void show_text(cairo_t* context, std::string_view text, Face face, double size, dvec2 at) {
  for (const Run& run : runs_of(text, face, size, at)) {
    set_font(context, *run.font, size);
    cairo().show_text_glyphs(context, run.text.c_str(), static_cast<int>(run.text.size()), run.glyphs.data(),
                             static_cast<int>(run.glyphs.size()), run.clusters.data(),
                             static_cast<int>(run.clusters.size()), cairo_text_cluster_flags_t{});
  }
}

void trace_text(cairo_t* context, std::string_view text, Face face, double size, dvec2 at) {
  for (const Run& run : runs_of(text, face, size, at)) {
    set_font(context, *run.font, size);
    cairo().glyph_path(context, run.glyphs.data(), static_cast<int>(run.glyphs.size()));
  }
}

double drawn_width(std::string_view text, Face face, double size) {
  Typeface& typeface = Typeface::of(face);
  double units = 0;
  for (const Letter& letter : typeface.letters_of(code_points(text))) units += typeface.advance_of(letter);
  return units * size / units_per_em;
}

void check_fonts() {
  static std::once_flag once;
  std::call_once(once, [] {
    const std::string text = "gradus 0147 Σ≥⋮";  // whose width is known
    for (const Face face : all_faces) {
      if (std::abs(drawn_width(text, face, 100) - text_width(text, face, 100)) > 1) {
        throw std::runtime_error(
            "the figures' fonts are missing or others than expected: install fonts-inter, "
            "fonts-jetbrains-mono, fonts-dejavu-core and fonts-dejavu-extra");
      }
    }
  });
}

std::vector<OutlinePiece> outline_pieces(char32_t character, Face face) {
  const Surface surface(cairo().image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo().create(surface.get()));
  set_font_options(context.get());
  trace_text(context.get(), utf8_of({&character, 1}), face, units_per_em, {0, 0});
  check(cairo().status(context.get()));
  const CairoPath path(cairo().copy_path(context.get()));
  check(path->status);
  std::vector<OutlinePiece> pieces;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    pieces.push_back(piece_of(path->data + i));
  }
  // A space, and the move to where the next letter would begin, draw nothing
  while (!pieces.empty() && pieces.back().kind != OutlinePiece::Kind::close) pieces.pop_back();
  return pieces;
}

const std::string& outline_of(char32_t character, Face face) {
  static std::mutex mutex;
  static std::map<std::pair<Face, char32_t>, std::string> known;
  const std::lock_guard lock(mutex);
  const auto [entry, added] = known.try_emplace({face, character});
  if (added) {
    PathData data;
    for (const OutlinePiece& piece : outline_pieces(character, face)) data.add(piece);
    entry->second = data.take();
  }
  return entry->second;
}

}  // namespace gradus
