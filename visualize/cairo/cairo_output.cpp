#include "cairo/cairo_output.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "cairo/metadata.hpp"
#include "core/image.hpp"
#include "figure/metrics.hpp"

namespace gradus {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(fmt::format("Cairo: {}", cairo_status_to_string(status)));
  }
}

/// Hinting off: the same outlines and places on every surface and machine.
void set_font_options(cairo_t* context) {
  const std::unique_ptr<cairo_font_options_t, Destroy> options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options.get());
}

void select_face(cairo_t* context, Face face, double size) {
  const bool mono = face == Face::mono || face == Face::mono_bold;
  const bool bold = face == Face::bold || face == Face::mono_bold;
  cairo_select_font_face(context, mono ? "DejaVu Sans Mono" : "DejaVu Sans",
                         face == Face::italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

/// Without transparency a PDF needs no second image for the mask.
bool is_opaque(const ImageShape& shape) {
  return std::ranges::all_of(shape.image.cells(), [](const Rgba8& c) { return c.a == 255; });
}

class Painter {
 public:
  Painter(cairo_t* context, const Theme& theme) : context_(context), theme_(theme) {
    set_font_options(context);
  }

  void paint(const Sheet& sheet) {
    use(Paint::of(Tone::paper));
    cairo_rectangle(context_, 0, 0, sheet.width, sheet.height);
    cairo_fill(context_);
    unit_ = sheet.unit;
    for (const Shape& shape : sheet.shapes) {
      std::visit([this](const auto& what) { draw(what); }, shape.what);
    }
  }

 private:
  void use(Paint paint) {
    const Rgb color = color_of(paint, theme_);
    cairo_set_source_rgb(context_, color.red(), color.green(), color.blue());
  }

  void stroke(double width, bool dashed) {
    const double dash[] = {3 * width, 2 * width};
    cairo_set_line_width(context_, width);
    cairo_set_dash(context_, dash, dashed ? 2 : 0, 0);
    cairo_stroke(context_);
  }

  void rectangle(const Box& b, double radius) {
    if (radius == 0) return cairo_rectangle(context_, b.x, b.y, b.width, b.height);
    const double quarter = std::numbers::pi / 2;
    cairo_new_sub_path(context_);
    cairo_arc(context_, b.right() - radius, b.y + radius, radius, -quarter, 0);
    cairo_arc(context_, b.right() - radius, b.bottom() - radius, radius, 0, quarter);
    cairo_arc(context_, b.x + radius, b.bottom() - radius, radius, quarter, 2 * quarter);
    cairo_arc(context_, b.x + radius, b.y + radius, radius, 2 * quarter, 3 * quarter);
    cairo_close_path(context_);
  }

  void draw(const RectShape& rect) {
    if (rect.fill.part != Paint::Part::none) {
      use(rect.fill);
      rectangle(rect.box, rect.radius);
      cairo_fill(context_);
    }
    if (rect.hatch != Hatch::none) hatch(rect);
    if (rect.stroke.part != Paint::Part::none && rect.stroke_width > 0) {
      use(rect.stroke);
      rectangle(rect.box, rect.radius);
      stroke(rect.stroke_width, rect.dashed);
    }
  }

  /// Diagonal lines cut to the box by hand: no clip path, so vector files stay small.
  void hatch(const RectShape& rect) {
    const double gap = 10 * unit_;
    use(rect.hatch_paint);
    if (rect.hatch != Hatch::falling) diagonals(rect.box, gap, true);
    if (rect.hatch != Hatch::rising) diagonals(rect.box, gap, false);
    stroke(0.9 * unit_, false);
  }
  void diagonals(const Box& b, double gap, bool rising) {
    // Lines x + y = k (rising on a y-down page) or x - y = k, k a multiple of the gap so that neighbours join
    // up
    const double low = rising ? b.x + b.y : b.x - b.bottom();
    const double high = rising ? b.right() + b.bottom() : b.right() - b.y;
    for (double k = std::ceil(low / gap) * gap; k < high; k += gap) {
      const double x0 = rising ? std::max(b.x, k - b.bottom()) : std::max(b.x, k + b.y);
      const double x1 = rising ? std::min(b.right(), k - b.y) : std::min(b.right(), k + b.bottom());
      cairo_move_to(context_, x0, rising ? k - x0 : x0 - k);
      cairo_line_to(context_, x1, rising ? k - x1 : x1 - k);
    }
  }

  void draw(const LineShape& line) {
    if (line.points.size() < 2) return;
    use(line.stroke);
    cairo_move_to(context_, line.points[0].x, line.points[0].y);
    for (std::size_t i = 1; i < line.points.size(); ++i)
      cairo_line_to(context_, line.points[i].x, line.points[i].y);
    if (line.closed) cairo_close_path(context_);
    stroke(line.width, line.dashed);
    if (line.arrow) arrow_head(line.points[line.points.size() - 2], line.points.back(), line.width);
  }

  void arrow_head(dvec2 from, dvec2 to, double width) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length == 0) return;
    const dvec2 along = (to - from) / length * (3 * width + 6 * unit_);
    const dvec2 aside{-along.y * 0.4, along.x * 0.4};
    cairo_move_to(context_, to.x, to.y);
    cairo_line_to(context_, to.x - along.x + aside.x, to.y - along.y + aside.y);
    cairo_line_to(context_, to.x - along.x - aside.x, to.y - along.y - aside.y);
    cairo_close_path(context_);
    cairo_fill(context_);
  }

  void draw(const StrokesShape& strokes) {
    use(strokes.stroke);
    for (const auto& [from, to] : strokes.segments) {
      cairo_move_to(context_, from.x, from.y);
      cairo_line_to(context_, to.x, to.y);
    }
    cairo_set_line_cap(context_, strokes.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    stroke(strokes.width, false);
    cairo_set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
  }

  void draw(const DiscShape& disc) {
    cairo_new_sub_path(context_);
    cairo_arc(context_, disc.centre.x, disc.centre.y, disc.radius, 0, 2 * std::numbers::pi);
    if (disc.fill.part != Paint::Part::none) {
      use(disc.fill);
      cairo_fill_preserve(context_);
    }
    if (disc.stroke.part != Paint::Part::none && disc.stroke_width > 0) {
      use(disc.stroke);
      stroke(disc.stroke_width, false);
    }
    cairo_new_path(context_);
  }

  void draw(const TextShape& text) {
    select_face(context_, text.face, text.size);
    const double x = text.box().x;
    if (text.halo) {
      cairo_move_to(context_, x, text.baseline.y);
      cairo_text_path(context_, text.text.c_str());
      use(text.ground);
      cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
      stroke(5 * unit_, false);
      cairo_set_line_join(context_, CAIRO_LINE_JOIN_MITER);
    }
    use(text.paint);
    cairo_move_to(context_, x, text.baseline.y);
    cairo_show_text(context_, text.text.c_str());
  }

  void draw(const ImageShape& shape) {
    if (shape.image.width() == 0 || shape.image.height() == 0) return;
    Surface pixels(cairo_image_surface_create(is_opaque(shape) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                              shape.image.width(), shape.image.height()));
    check(cairo_surface_status(pixels.get()));
    unsigned char* data = cairo_image_surface_get_data(pixels.get());
    const int stride = cairo_image_surface_get_stride(pixels.get());
    for (int y = 0; y < shape.image.height(); ++y) {
      auto* row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
      for (int x = 0; x < shape.image.width(); ++x) row[x] = premultiplied(shape, {x, y});
    }
    cairo_surface_mark_dirty(pixels.get());
    cairo_save(context_);
    cairo_translate(context_, shape.box.x, shape.box.y);
    cairo_scale(context_, shape.box.width / shape.image.width(), shape.box.height / shape.image.height());
    cairo_set_source_surface(context_, pixels.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context_), CAIRO_FILTER_NEAREST);
    cairo_rectangle(context_, 0, 0, shape.image.width(), shape.image.height());
    cairo_fill(context_);
    cairo_restore(context_);
  }

  std::uint32_t premultiplied(const ImageShape& shape, ivec2 p) const {
    if (shape.roles.contains(p) && shape.roles[p] != 0) {
      return 0xff000000u | theme_[static_cast<Role>(shape.roles[p] - 1)].mark.hex;
    }
    const Rgba8 c = shape.image[p];
    const auto times_alpha = [&c](std::uint8_t v) { return (std::uint32_t{v} * c.a + 127) / 255; };
    return std::uint32_t{c.a} << 24 | times_alpha(c.r) << 16 | times_alpha(c.g) << 8 | times_alpha(c.b);
  }

  cairo_t* context_;
  const Theme& theme_;
  double unit_ = 1;
};

/// Without the DejaVu fonts Cairo draws boxes and says nothing: measure a text whose width is known.
void check_fonts() {
  static std::once_flag once;
  std::call_once(once, [] {
    for (const Face face : {Face::sans, Face::bold, Face::italic, Face::mono, Face::mono_bold}) {
      const std::string text = "gradus Σ≥";
      if (std::abs(drawn_width(text, face, 100) - text_width(text, face, 100)) > 1) {
        throw std::runtime_error(
            "the DejaVu fonts are missing: install fonts-dejavu-core and fonts-dejavu-extra");
      }
    }
  });
}

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void paint_on(cairo_surface_t* surface, const Sheet& sheet, const Theme& theme) {
  check(cairo_surface_status(surface));
  const Context context(cairo_create(surface));
  Painter(context.get(), theme).paint(sheet);
  check(cairo_status(context.get()));
}

void complete(cairo_surface_t* surface) {
  cairo_surface_finish(surface);
  check(cairo_surface_status(surface));
}

}  // namespace

double drawn_width(const std::string& text, Face face, double size) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo_create(surface.get()));
  set_font_options(context.get());
  select_face(context.get(), face, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents.x_advance;
}

std::string svg_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon) {
  check_fonts();
  std::string text;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &text, sheet.width, sheet.height));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  paint_on(surface.get(), sheet, finish.theme);
  complete(surface.get());
  return with_colophon(renumbered(text), colophon);
}

std::string png_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon) {
  check_fonts();
  const int width = static_cast<int>(std::lround(sheet.width)),
            height = static_cast<int>(std::lround(sheet.height));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  paint_on(surface.get(), sheet, finish.theme);
  cairo_surface_flush(surface.get());
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      const std::uint32_t c = row[x];
      image[{x, y}] = {static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                       static_cast<std::uint8_t>(c), 255};
    }
  }
  const auto texts = png_texts_of(colophon);
  const auto bytes = encode_png(image, texts);
  return {bytes.begin(), bytes.end()};
}

std::string pdf_of(std::size_t pages, const std::function<Sheet(std::size_t)>& page, const Finish& finish,
                   const Colophon& colophon) {
  check_fonts();
  std::string text;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &text, 1, 1));
  set_pdf_metadata(surface.get(), colophon);
  for (std::size_t i = 0; i < pages; ++i) {
    const Sheet sheet = page(i);
    // A CSS pixel is 3/4 of a PDF point
    cairo_pdf_surface_set_size(surface.get(), sheet.width * 0.75, sheet.height * 0.75);
    check(cairo_surface_status(surface.get()));
    const Context context(cairo_create(surface.get()));
    cairo_scale(context.get(), 0.75, 0.75);
    Painter(context.get(), finish.theme).paint(sheet);
    cairo_show_page(context.get());
    check(cairo_status(context.get()));
  }
  complete(surface.get());
  return text;
}

}  // namespace gradus
