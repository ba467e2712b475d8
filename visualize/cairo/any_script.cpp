#include "cairo/any_script.hpp"

#include <pango/pangocairo.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>

#include "cairo/cairo_output.hpp"
#include "cairo/handles.hpp"
#include "figure/metrics.hpp"

namespace gradus {
namespace {

struct Release {
  void operator()(void* object) const { g_object_unref(object); }
  void operator()(PangoFontDescription* description) const { pango_font_description_free(description); }
};
template <class Object>
using Owned = std::unique_ptr<Object, Release>;

PangoFontMap* fonts() {
  static const Owned<PangoFontMap> map = [] {
    // Signs that several languages share, such as those of Chinese and Japanese, are drawn alike under every
    // user's locale; who wants another's says so by this variable
    setenv("PANGO_LANGUAGE", "en", 0);
    return Owned<PangoFontMap>(pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
  }();
  return map.get();
}

/// Pango's maps of fonts are for one thread at a time.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

/// One line in the figures' fonts, and in others for what those lack.
Owned<PangoLayout> line_of(PangoContext* context, std::string_view text, double size) {
  pango_context_set_language(context, pango_language_from_string("en"));
  pango_context_set_round_glyph_positions(context, FALSE);
  Owned<PangoLayout> layout(pango_layout_new(context));
  const Owned<PangoFontDescription> font(pango_font_description_from_string("Inter, DejaVu Sans"));
  pango_font_description_set_absolute_size(font.get(), size * PANGO_SCALE);
  pango_layout_set_font_description(layout.get(), font.get());
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
  return layout;
}

bool has_fonts(std::string_view text) {
  const Owned<PangoContext> context(pango_font_map_create_context(fonts()));
  return pango_layout_get_unknown_glyphs_count(line_of(context.get(), text, 16).get()) == 0;
}

}  // namespace

std::optional<char32_t> character_without_font(std::string_view text) {
  const std::lock_guard lock(one_at_a_time());
  if (has_fonts(text)) return std::nullopt;
  const std::u32string characters = code_points(text);
  for (const char32_t character : characters) {
    if (!has_fonts(utf8_of({&character, 1}))) return character;
  }
  return characters.front();  // none alone, but joined
}

void show_in_any_script(cairo_t* context, std::string_view text, double size, dvec2 at, double width) {
  const std::lock_guard lock(one_at_a_time());
  const Owned<PangoContext> setting(pango_font_map_create_context(fonts()));
  const FontOptions options(cairo_font_options_create());
  cairo_get_font_options(context, options.get());
  pango_cairo_context_set_font_options(setting.get(), options.get());
  pango_cairo_update_context(context, setting.get());
  const Owned<PangoLayout> layout = line_of(setting.get(), text, size);
  pango_layout_set_width(layout.get(), static_cast<int>(std::floor(width * PANGO_SCALE)));
  pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  cairo_move_to(context, at.x, at.y);
  // The line itself, which begins at the left whatever its direction
  pango_cairo_show_layout_line(context, pango_layout_get_line_readonly(layout.get(), 0));
}

}  // namespace gradus
