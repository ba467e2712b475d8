#include "cairo/any_script.hpp"

#include <pango/pangocairo.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "cairo/cairo_output.hpp"
#include "cairo/handles.hpp"
#include "cairo/library_on_demand.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

/// Pango's functions, loaded by the first name: its libraries take as long as the rest of a short command.
struct Pango {
  LibraryOnDemand library{GRADUS_PANGO, "names in PDF worksheets"};
  GRADUS_ON_DEMAND(g_object_unref);
  GRADUS_ON_DEMAND(pango_cairo_context_set_font_options);
  GRADUS_ON_DEMAND(pango_cairo_font_map_new_for_font_type);
  GRADUS_ON_DEMAND(pango_cairo_show_layout_line);
  GRADUS_ON_DEMAND(pango_cairo_update_context);
  GRADUS_ON_DEMAND(pango_context_set_language);
  GRADUS_ON_DEMAND(pango_context_set_round_glyph_positions);
  GRADUS_ON_DEMAND(pango_font_description_free);
  GRADUS_ON_DEMAND(pango_font_description_from_string);
  GRADUS_ON_DEMAND(pango_font_description_set_absolute_size);
  GRADUS_ON_DEMAND(pango_font_map_create_context);
  GRADUS_ON_DEMAND(pango_language_from_string);
  GRADUS_ON_DEMAND(pango_layout_get_line_readonly);
  GRADUS_ON_DEMAND(pango_layout_get_unknown_glyphs_count);
  GRADUS_ON_DEMAND(pango_layout_new);
  GRADUS_ON_DEMAND(pango_layout_set_ellipsize);
  GRADUS_ON_DEMAND(pango_layout_set_font_description);
  GRADUS_ON_DEMAND(pango_layout_set_single_paragraph_mode);
  GRADUS_ON_DEMAND(pango_layout_set_text);
  GRADUS_ON_DEMAND(pango_layout_set_width);
};

const Pango& pango() {
  static const Pango functions;
  return functions;
}

struct Release {
  void operator()(void* object) const { pango().g_object_unref(object); }
  void operator()(PangoFontDescription* description) const {
    pango().pango_font_description_free(description);
  }
};
template <class Object>
using Owned = std::unique_ptr<Object, Release>;

PangoFontMap* fonts() {
  static const Owned<PangoFontMap> map = [] {
    // Signs that several languages share, such as those of Chinese and Japanese, are drawn alike under every
    // user's locale; who wants another's says so by this variable
    setenv("PANGO_LANGUAGE", "en", 0);
    return Owned<PangoFontMap>(pango().pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT));
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
  pango().pango_context_set_language(context, pango().pango_language_from_string("en"));
  pango().pango_context_set_round_glyph_positions(context, FALSE);
  Owned<PangoLayout> layout(pango().pango_layout_new(context));
  const Owned<PangoFontDescription> font(pango().pango_font_description_from_string("Inter, DejaVu Sans"));
  pango().pango_font_description_set_absolute_size(font.get(), size * PANGO_SCALE);
  pango().pango_layout_set_font_description(layout.get(), font.get());
  pango().pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  pango().pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
  return layout;
}

bool has_fonts(std::string_view text) {
  const Owned<PangoContext> context(pango().pango_font_map_create_context(fonts()));
  return pango().pango_layout_get_unknown_glyphs_count(line_of(context.get(), text, 16).get()) == 0;
}

}  // namespace

std::string_view cairo_version() { return CAIRO_VERSION_STRING; }
std::string_view pango_version() { return PANGO_VERSION_STRING; }

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
  const Owned<PangoContext> setting(pango().pango_font_map_create_context(fonts()));
  const FontOptions options(cairo().font_options_create());
  cairo().get_font_options(context, options.get());
  pango().pango_cairo_context_set_font_options(setting.get(), options.get());
  pango().pango_cairo_update_context(context, setting.get());
  const Owned<PangoLayout> layout = line_of(setting.get(), text, size);
  pango().pango_layout_set_width(layout.get(), static_cast<int>(std::floor(width * PANGO_SCALE)));
  pango().pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  cairo().move_to(context, at.x, at.y);
  // The line itself, which begins at the left in either direction
  pango().pango_cairo_show_layout_line(context, pango().pango_layout_get_line_readonly(layout.get(), 0));
}

}  // namespace gradus
