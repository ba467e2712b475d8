#pragma once
// Cairo's objects as owners, and its statuses as exceptions.

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "cairo/cairo_library.hpp"

namespace gradus {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo().surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo().destroy(context); }
  void operator()(cairo_font_options_t* options) const { cairo().font_options_destroy(options); }
  void operator()(cairo_path_t* path) const { cairo().path_destroy(path); }
  void operator()(cairo_font_face_t* face) const { cairo().font_face_destroy(face); }
  void operator()(cairo_scaled_font_t* font) const { cairo().scaled_font_destroy(font); }
  void operator()(FcPattern* pattern) const { cairo().FcPatternDestroy(pattern); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Destroy>;
using FontFace = std::unique_ptr<cairo_font_face_t, Destroy>;
using ScaledFont = std::unique_ptr<cairo_scaled_font_t, Destroy>;
using FontPattern = std::unique_ptr<FcPattern, Destroy>;
using CairoPath = std::unique_ptr<cairo_path_t, Destroy>;

inline void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("Cairo: {}", cairo().status_to_string(status)));
  }
}

}  // namespace gradus
