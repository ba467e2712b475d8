#pragma once
// Other libraries that draw lines and circles into pictures, each as little of it as draws one: Cairo, and
// where they are there, AGG and Mesa. OpenCV's calls are short and stand where they are measured.

#include <cairo.h>

#include <memory>
#include <numbers>

#include "benchmark/scan_conversion/drawings.hpp"

#ifdef GRADUS_HAS_AGG
#include <agg_pixfmt_gray.h>
#include <agg_renderer_base.h>
#include <agg_renderer_primitives.h>
#include <agg_rendering_buffer.h>
#endif
#ifdef GRADUS_HAS_OSMESA
#include <GL/gl.h>
#include <GL/osmesa.h>
#endif

namespace gradus::bench::peers {

using drawings::Canvas;

/// Releases what a C library has made.
template <auto release>
struct With {
  void operator()(auto* made) const { release(made); }
};

/// Cairo strokes a pixel wide, without antialiasing, on a canvas as its surface of alphas.
class CairoPen {
 public:
  /// Domain: a width of whole words, as Cairo's rows have.
  explicit CairoPen(Canvas& canvas)
      : surface_(cairo_image_surface_create_for_data(canvas.cells().data(), CAIRO_FORMAT_A8, canvas.width(),
                                                     canvas.height(), canvas.width())),
        context_(cairo_create(surface_.get())) {
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);
    cairo_set_line_width(context_.get(), 1);
    cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_SQUARE);
  }
  void line(ivec2 from, ivec2 to) {
    cairo_move_to(context_.get(), from.x + 0.5, from.y + 0.5);
    cairo_line_to(context_.get(), to.x + 0.5, to.y + 0.5);
    cairo_stroke(context_.get());
  }
  void circle(ivec2 center, int radius) {
    cairo_arc(context_.get(), center.x + 0.5, center.y + 0.5, radius, 0, 2 * std::numbers::pi);
    cairo_stroke(context_.get());
  }

 private:
  std::unique_ptr<cairo_surface_t, With<cairo_surface_destroy>> surface_;
  std::unique_ptr<cairo_t, With<cairo_destroy>> context_;
};

#ifdef GRADUS_HAS_AGG
/// The primitives of Anti-Grain Geometry that know whole pixels only.
class AggPen {
 public:
  explicit AggPen(Canvas& canvas)
      : buffer_(canvas.cells().data(), static_cast<unsigned>(canvas.width()),
                static_cast<unsigned>(canvas.height()), canvas.width()) {
    primitives_.line_color(agg::gray8(1));
  }
  AggPen(const AggPen&) = delete;
  AggPen& operator=(const AggPen&) = delete;

  void line(ivec2 from, ivec2 to) {
    using Steps = agg::line_bresenham_interpolator;  // of 1/256 pixel
    const auto at = [](int x) { return x * int{Steps::subpixel_scale} + int{Steps::subpixel_scale} / 2; };
    primitives_.line(at(from.x), at(from.y), at(to.x), at(to.y), true);
  }
  void circle(ivec2 center, int radius) { primitives_.ellipse(center.x, center.y, radius, radius); }

 private:
  using Base = agg::renderer_base<agg::pixfmt_gray8>;
  agg::rendering_buffer buffer_;
  agg::pixfmt_gray8 pixels_{buffer_};
  Base base_{pixels_};
  agg::renderer_primitives<Base> primitives_{base_};
};
#endif

#ifdef GRADUS_HAS_OSMESA
/// OpenGL's lines, drawn by Mesa on the processor, into a picture of its own with four bytes per pixel.
class MesaPicture {
 public:
  explicit MesaPicture(int side) : picture_(side, side), context_(OSMesaCreateContext(OSMESA_RGBA, nullptr)) {
    OSMesaMakeCurrent(context_.get(), picture_.cells().data(), GL_UNSIGNED_BYTE, side, side);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, side, 0, side, -1, 1);
    glColor3f(1, 1, 1);
  }
  template <class Lines>
  void lines(const Lines& lines) {
    glBegin(GL_LINES);
    for (const auto& [from, to] : lines) {
      glVertex2f(static_cast<float>(from.x) + 0.5F, static_cast<float>(from.y) + 0.5F);
      glVertex2f(static_cast<float>(to.x) + 0.5F, static_cast<float>(to.y) + 0.5F);
    }
    glEnd();
    glFinish();
  }
  /// Hands over what has been drawn within a window, and begins anew.
  void give_to(Canvas& canvas, const Window& window) {
    for (int y = std::max(window.lower.y, 0); y <= std::min(window.upper.y, canvas.height() - 1); ++y) {
      for (int x = std::max(window.lower.x, 0); x <= std::min(window.upper.x, canvas.width() - 1); ++x) {
        if ((picture_[{x, y}] & 0xff) != 0) canvas[{x, y}] = 1;
      }
    }
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
  }

 private:
  Raster<std::uint32_t> picture_;
  std::unique_ptr<osmesa_context, With<OSMesaDestroyContext>> context_;
};
#endif

}  // namespace gradus::bench::peers
