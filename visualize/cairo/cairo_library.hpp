#pragma once
// Cairo's functions, loaded when a picture is first drawn: with all that they need themselves they take
// longer than a command that draws none.

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>
#include <fontconfig/fontconfig.h>

#include "cairo/library_on_demand.hpp"

namespace gradus {

/// A member: the function of this name, without the "cairo_" before it.
#define GRADUS_CAIRO_FUNCTION(name) GRADUS_ON_DEMAND_AS(name, cairo_##name)

struct CairoLibrary {
  LibraryOnDemand library;

  GRADUS_CAIRO_FUNCTION(arc);
  GRADUS_CAIRO_FUNCTION(clip);
  GRADUS_CAIRO_FUNCTION(close_path);
  GRADUS_CAIRO_FUNCTION(copy_path);
  GRADUS_CAIRO_FUNCTION(create);
  GRADUS_CAIRO_FUNCTION(destroy);
  GRADUS_CAIRO_FUNCTION(fill);
  GRADUS_CAIRO_FUNCTION(fill_preserve);
  GRADUS_CAIRO_FUNCTION(font_face_destroy);
  GRADUS_CAIRO_FUNCTION(font_face_status);
  GRADUS_CAIRO_FUNCTION(font_options_create);
  GRADUS_CAIRO_FUNCTION(font_options_destroy);
  GRADUS_CAIRO_FUNCTION(font_options_set_antialias);
  GRADUS_CAIRO_FUNCTION(font_options_set_hint_metrics);
  GRADUS_CAIRO_FUNCTION(font_options_set_hint_style);
  GRADUS_CAIRO_FUNCTION(ft_font_face_create_for_pattern);
  GRADUS_CAIRO_FUNCTION(get_font_options);
  GRADUS_CAIRO_FUNCTION(get_scaled_font);
  GRADUS_CAIRO_FUNCTION(get_source);
  GRADUS_CAIRO_FUNCTION(glyph_free);
  GRADUS_CAIRO_FUNCTION(glyph_path);
  GRADUS_CAIRO_FUNCTION(image_surface_create);
  GRADUS_CAIRO_FUNCTION(image_surface_get_data);
  GRADUS_CAIRO_FUNCTION(image_surface_get_height);
  GRADUS_CAIRO_FUNCTION(image_surface_get_stride);
  GRADUS_CAIRO_FUNCTION(image_surface_get_width);
  GRADUS_CAIRO_FUNCTION(line_to);
  GRADUS_CAIRO_FUNCTION(matrix_init_identity);
  GRADUS_CAIRO_FUNCTION(matrix_init_scale);
  GRADUS_CAIRO_FUNCTION(move_to);
  GRADUS_CAIRO_FUNCTION(new_path);
  GRADUS_CAIRO_FUNCTION(new_sub_path);
  GRADUS_CAIRO_FUNCTION(paint_with_alpha);
  GRADUS_CAIRO_FUNCTION(path_destroy);
  GRADUS_CAIRO_FUNCTION(pattern_set_filter);
  GRADUS_CAIRO_FUNCTION(pdf_surface_create_for_stream);
  GRADUS_CAIRO_FUNCTION(pdf_surface_set_metadata);
  GRADUS_CAIRO_FUNCTION(pdf_surface_set_size);
  GRADUS_CAIRO_FUNCTION(pop_group_to_source);
  GRADUS_CAIRO_FUNCTION(push_group);
  GRADUS_CAIRO_FUNCTION(rectangle);
  GRADUS_CAIRO_FUNCTION(restore);
  GRADUS_CAIRO_FUNCTION(save);
  GRADUS_CAIRO_FUNCTION(scale);
  GRADUS_CAIRO_FUNCTION(scaled_font_create);
  GRADUS_CAIRO_FUNCTION(scaled_font_destroy);
  GRADUS_CAIRO_FUNCTION(scaled_font_glyph_extents);
  GRADUS_CAIRO_FUNCTION(scaled_font_reference);
  GRADUS_CAIRO_FUNCTION(scaled_font_status);
  GRADUS_CAIRO_FUNCTION(scaled_font_text_to_glyphs);
  GRADUS_CAIRO_FUNCTION(set_dash);
  GRADUS_CAIRO_FUNCTION(set_fill_rule);
  GRADUS_CAIRO_FUNCTION(set_font_face);
  GRADUS_CAIRO_FUNCTION(set_font_options);
  GRADUS_CAIRO_FUNCTION(set_font_size);
  GRADUS_CAIRO_FUNCTION(set_line_cap);
  GRADUS_CAIRO_FUNCTION(set_line_join);
  GRADUS_CAIRO_FUNCTION(set_line_width);
  GRADUS_CAIRO_FUNCTION(set_source_rgb);
  GRADUS_CAIRO_FUNCTION(set_source_surface);
  GRADUS_CAIRO_FUNCTION(show_page);
  GRADUS_CAIRO_FUNCTION(show_text_glyphs);
  GRADUS_CAIRO_FUNCTION(status);
  GRADUS_CAIRO_FUNCTION(status_to_string);
  GRADUS_CAIRO_FUNCTION(stroke);
  GRADUS_CAIRO_FUNCTION(surface_destroy);
  GRADUS_CAIRO_FUNCTION(surface_finish);
  GRADUS_CAIRO_FUNCTION(surface_flush);
  GRADUS_CAIRO_FUNCTION(surface_mark_dirty);
  GRADUS_CAIRO_FUNCTION(surface_status);
  GRADUS_CAIRO_FUNCTION(translate);
  GRADUS_ON_DEMAND(FcNameParse);
  GRADUS_ON_DEMAND(FcPatternDestroy);
};

#undef GRADUS_CAIRO_FUNCTION

/// Throws std::runtime_error where it can't be loaded.
const CairoLibrary& cairo();

}  // namespace gradus
