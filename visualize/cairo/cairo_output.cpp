#include "cairo/cairo_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "cairo/any_script.hpp"
#include "cairo/fonts.hpp"
#include "cairo/handles.hpp"
#include "cairo/metadata.hpp"
#include "cairo/shapes.hpp"
#include "core/image.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

bool is_opaque(const Image& image) {
  return std::ranges::all_of(image.cells(), [](const Rgba8& c) { return c.a == 255; });
}

std::uint32_t premultiplied(const Rgba8& c) {
  const auto times_alpha = [&c](std::uint8_t v) { return (std::uint32_t{v} * c.a + 127) / 255; };
  return std::uint32_t{c.a} << 24 | times_alpha(c.r) << 16 | times_alpha(c.g) << 8 | times_alpha(c.b);
}

Rgba8 unpremultiplied(std::uint32_t pixel) {
  const auto channel = [pixel](int shift) { return static_cast<std::uint8_t>(pixel >> shift); };
  const std::uint32_t alpha = channel(24);
  if (alpha == 255) return {channel(16), channel(8), channel(0), 255};
  if (alpha == 0) return {0, 0, 0, 0};
  const auto over_alpha = [&](int shift) {
    return static_cast<std::uint8_t>(std::min(255u, (channel(shift) * 255u + alpha / 2) / alpha));
  };
  return {over_alpha(16), over_alpha(8), over_alpha(0), channel(24)};
}

/// RGB24 leaves the alpha byte undefined.
Rgba8 without_alpha(std::uint32_t pixel) {
  return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
          static_cast<std::uint8_t>(pixel), 255};
}

Surface surface_of(const Image& image) {
  // Without transparency a PDF needs no second image for the mask
  Surface pixels(cairo().image_surface_create(is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                              image.width(), image.height()));
  check(cairo().surface_status(pixels.get()));
  unsigned char* data = cairo().image_surface_get_data(pixels.get());
  const int stride = cairo().image_surface_get_stride(pixels.get());
  for (int y = 0; y < image.height(); ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    std::ranges::transform(image.row(y), row, premultiplied);
  }
  cairo().surface_mark_dirty(pixels.get());
  return pixels;
}

/// A picture as Cairo's pixels, which it puts into a document but once, on however many pages it lies.
struct SharedPicture {
  Image image;
  Surface pixels;
};

/// Pixels of one colour in a row of a picture, in its pixels, by colours.
using Runs = std::map<std::array<std::uint8_t, 3>, std::vector<Box>>;

/// The pixels in which `image` is another one than `ground`, none of them transparent. Nothing: they are
/// many, or the pictures have two sizes, or are so small that drawing both saves nothing. Runs, not a second
/// picture with transparency: viewers that make that smaller mix its colours with those of its empty pixels.
std::optional<Runs> runs_over(const Image& ground, const Image& image) {
  constexpr int small = 10'000, most = 3'000;
  if (image.width() != ground.width() || image.height() != ground.height()) return {};
  if (image.width() * image.height() < small) return {};
  Runs runs;
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    const auto row = image.row(y), below = ground.row(y);
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t from = x;
      while (x < row.size() && row[x] == row[from] && row[x] != below[x]) ++x;
      if (x == from) {
        ++x;
        continue;
      }
      const Rgba8 c = row[from];
      if (c.a != 255 || ++count > most) return {};
      runs[{c.r, c.g, c.b}].push_back(
          {static_cast<double>(from), static_cast<double>(y), static_cast<double>(x - from), 1});
    }
  }
  return runs;
}

/// The latest pictures of a document.
class SharedPictures {
 public:
  /// One that lies below the image, and what the image has over it: nothing where it is smoothed as a whole.
  std::pair<cairo_surface_t*, Runs> split(const Image& image, bool smooth) {
    for (auto known = kept_.begin(); known != kept_.end(); ++known) {
      std::optional<Runs> over;
      if (known->image == image)
        over = Runs{};
      else if (!smooth)
        over = runs_over(known->image, image);
      if (!over) continue;
      std::rotate(kept_.begin(), known, known + 1);
      return {kept_.front().pixels.get(), *std::move(over)};
    }
    if (kept_.size() == most) kept_.pop_back();
    kept_.insert(kept_.begin(), SharedPicture{image, surface_of(image)});
    return {kept_.front().pixels.get(), {}};
  }

 private:
  static constexpr std::size_t most = 16;  ///< pages have fewer
  std::vector<SharedPicture> kept_;
};

class Painter {
 public:
  /// `shared`: with those that are painted before and after; null: there are none.
  Painter(cairo_t* context, const Finish& finish, SharedPictures* shared = nullptr)
      : context_(context), theme_(finish.theme), transparent_(finish.transparent), shared_(shared) {
    set_font_options(context);
  }

  void paint(const Sheet& sheet) {
    if (!transparent_) {
      use(Paint::of(Tone::paper));
      cairo().rectangle(context_, 0, 0, sheet.width, sheet.height);
      cairo().fill(context_);
    }
    unit_ = sheet.unit;
    for (const Shape& shape : sheet.shapes) {
      if (shape.opacity < 1) {
        draw_faded(shape);
      } else {
        draw_whole(shape);
      }
    }
  }

 private:
  void draw_whole(const Shape& shape) {
    std::visit([this](const auto& what) { draw(what); }, shape.what);
  }

  /// Drawn aside and laid over what is there, so that its own parts do not show through each other.
  void draw_faded(const Shape& shape) {
    const Box box = extents_of(shape);
    const double air = 12 * unit_;  // arrow heads and halos reach beyond
    cairo().save(context_);
    cairo().rectangle(context_, box.x - air, box.y - air, box.width + 2 * air, box.height + 2 * air);
    cairo().clip(context_);
    cairo().push_group(context_);
    draw_whole(shape);
    cairo().pop_group_to_source(context_);
    cairo().paint_with_alpha(context_, shape.opacity);
    cairo().restore(context_);
  }

  void use(Paint paint) {
    const Rgb color = color_of(paint, theme_);
    cairo().set_source_rgb(context_, color.red(), color.green(), color.blue());
  }

  void stroke(double width, bool dashed) {
    const auto [on, off] = dashes(width);
    const double dash[] = {on, off};
    cairo().set_line_width(context_, width);
    cairo().set_dash(context_, dash, dashed ? 2 : 0, 0);
    cairo().stroke(context_);
  }

  void rectangle(const Box& b, double radius) {
    if (radius == 0) return cairo().rectangle(context_, b.x, b.y, b.width, b.height);
    const double quarter = std::numbers::pi / 2;
    cairo().new_sub_path(context_);
    cairo().arc(context_, b.right() - radius, b.y + radius, radius, -quarter, 0);
    cairo().arc(context_, b.right() - radius, b.bottom() - radius, radius, 0, quarter);
    cairo().arc(context_, b.x + radius, b.bottom() - radius, radius, quarter, 2 * quarter);
    cairo().arc(context_, b.x + radius, b.y + radius, radius, 2 * quarter, 3 * quarter);
    cairo().close_path(context_);
  }

  void draw(const RectShape& plain) {
    const RectShape rect = shown_in(theme_, plain, unit_);
    if (rect.fill.part != Paint::Part::none) {
      use(rect.fill);
      rectangle(rect.box, rect.radius);
      cairo().fill(context_);
    }
    hatch(rect);
    if (rect.stroke.part != Paint::Part::none && rect.stroke_width > 0) {
      use(rect.stroke);
      rectangle(rect.box, rect.radius);
      stroke(rect.stroke_width, rect.dashed);
    }
  }

  template <class HatchedShape>
  void hatch(const HatchedShape& shape) {
    if (shape.hatch == Hatch::none) return;
    use(shape.hatch_paint);
    trace(hatch_lines(shape, unit_));
    stroke(hatch_width(unit_), false);
  }

  void draw(const AreaShape& plain) {
    const AreaShape area = shown_in(theme_, plain);
    use(area.fill);
    cairo().new_path(context_);  // text leaves a current point behind
    for (const auto& ring : area.rings) {
      cairo().new_sub_path(context_);
      for (const dvec2& p : ring) cairo().line_to(context_, p.x, p.y);
      cairo().close_path(context_);
    }
    cairo().set_fill_rule(context_, CAIRO_FILL_RULE_EVEN_ODD);
    cairo().fill(context_);
    cairo().set_fill_rule(context_, CAIRO_FILL_RULE_WINDING);
    hatch(area);
  }

  void trace(const std::vector<Segment<2, double>>& segments) {
    for (const auto& [from, to] : segments) {
      cairo().move_to(context_, from.x, from.y);
      cairo().line_to(context_, to.x, to.y);
    }
  }

  void draw(const LineShape& line) {
    if (line.points.size() < 2) return;
    use(line.stroke);
    cairo().move_to(context_, line.points[0].x, line.points[0].y);
    for (std::size_t i = 1; i < line.points.size(); ++i)
      cairo().line_to(context_, line.points[i].x, line.points[i].y);
    if (line.closed) cairo().close_path(context_);
    stroke(line.width, line.dashed);
    const auto head = arrow_head(line, unit_);
    if (!head) return;
    for (const dvec2& p : {head->tip, head->left, head->right}) cairo().line_to(context_, p.x, p.y);
    cairo().close_path(context_);
    cairo().fill(context_);
  }

  void draw(const StrokesShape& strokes) {
    use(strokes.stroke);
    trace(strokes.segments);
    cairo().set_line_cap(context_, strokes.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    stroke(strokes.width, false);
    cairo().set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
  }

  void draw(const DiscShape& disc) {
    cairo().new_sub_path(context_);
    cairo().arc(context_, disc.centre.x, disc.centre.y, disc.radius, 0, 2 * std::numbers::pi);
    if (disc.fill.part != Paint::Part::none) {
      use(disc.fill);
      cairo().fill_preserve(context_);
    }
    if (disc.stroke.part != Paint::Part::none && disc.stroke_width > 0) {
      use(disc.stroke);
      stroke(disc.stroke_width, false);
    }
    cairo().new_path(context_);
  }

  void draw(const TextShape& text) {
    if (text.any_script_within > 0) {
      use(text.paint);
      return show_in_any_script(context_, text.text, text.size, text.baseline, text.any_script_within);
    }
    const dvec2 at{text.box().x, text.baseline.y};
    if (text.halo) {
      for (const TextPiece& piece : pieces_of(text))
        trace_text(context_, piece.text, piece.face, text.size, at + dvec2{piece.x, 0});
      use(text.ground);
      cairo().set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
      stroke(halo_width(text), false);
      cairo().set_line_join(context_, CAIRO_LINE_JOIN_MITER);
    }
    if (text.is_rim()) return;
    for (const TextPiece& piece : pieces_of(text)) {
      use(piece.paint);
      show_text(context_, piece.text, piece.face, text.size, at + dvec2{piece.x, 0});
      const auto line = underline(piece, text, theme_);
      if (!line) continue;
      trace({line->segment});
      stroke(line->width, line->dashed);
    }
  }

  void draw(const ImageShape& shape) {
    if (shape.image.width() == 0 || shape.image.height() == 0) return;
    const Image pixels = pixels_of(shape, theme_);
    if (!shared_) return draw(shape, surface_of(pixels).get());
    const auto [ground, over] = shared_->split(pixels, shape.smooth);
    draw(shape, ground);
    in_pixels_of(shape, [&] {
      for (const auto& [color, runs] : over) {
        cairo().set_source_rgb(context_, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
        for (const Box& run : runs) cairo().rectangle(context_, run.x, run.y, run.width, run.height);
        cairo().fill(context_);
      }
    });
  }

  void draw(const ImageShape& shape, cairo_surface_t* pixels) {
    in_pixels_of(shape, [&] {
      cairo().set_source_surface(context_, pixels, 0, 0);
      cairo().pattern_set_filter(cairo().get_source(context_),
                                 shape.smooth ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
      cairo().rectangle(context_, 0, 0, shape.image.width(), shape.image.height());
      cairo().fill(context_);
    });
  }

  template <class Draw>
  void in_pixels_of(const ImageShape& shape, Draw draw) {
    cairo().save(context_);
    cairo().translate(context_, shape.box.x, shape.box.y);
    cairo().scale(context_, shape.box.width / shape.image.width(), shape.box.height / shape.image.height());
    draw();
    cairo().restore(context_);
  }

  cairo_t* context_;
  const Theme& theme_;
  bool transparent_;
  SharedPictures* shared_;
  double unit_ = 1;
};

cairo_status_t append(void* text, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// The sheet as Cairo's pixels; drawn at the scale asked for, so that letters stay sharp.
Surface painted(const Sheet& sheet, const Finish& finish) {
  const double width = std::round(sheet.width * finish.scale),
               height = std::round(sheet.height * finish.scale);
  if (!(1 <= width && width <= longest_side && 1 <= height && height <= longest_side)) {
    throw std::runtime_error(fmt::format("a picture has sides of 1 to {} pixels, not {:.0f} x {:.0f}",
                                         longest_side, width, height));
  }
  Surface surface(cairo().image_surface_create(finish.transparent ? CAIRO_FORMAT_ARGB32 : CAIRO_FORMAT_RGB24,
                                               static_cast<int>(width), static_cast<int>(height)));
  check(cairo().surface_status(surface.get()));
  const Context context(cairo().create(surface.get()));
  // Not finish.scale: the sheet ends with the last pixel, whatever was rounded
  cairo().scale(context.get(), width / sheet.width, height / sheet.height);
  Painter(context.get(), finish).paint(sheet);
  check(cairo().status(context.get()));
  cairo().surface_flush(surface.get());
  return surface;
}

}  // namespace

Image image_of(const Sheet& sheet, const Finish& finish) {
  check_fonts();
  const Surface surface = painted(sheet, finish);
  const unsigned char* data = cairo().image_surface_get_data(surface.get());
  const int stride = cairo().image_surface_get_stride(surface.get());
  Image image(cairo().image_surface_get_width(surface.get()),
              cairo().image_surface_get_height(surface.get()));
  const auto convert = [&](auto to_pixel) {
    for (int y = 0; y < image.height(); ++y) {
      const auto* row =
          reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
      std::transform(row, row + image.width(), image.row(y).begin(), to_pixel);
    }
  };
  if (finish.transparent) {
    convert([](std::uint32_t pixel) { return unpremultiplied(pixel); });
  } else {
    convert([](std::uint32_t pixel) { return without_alpha(pixel); });
  }
  return image;
}

std::string png_of(const Sheet& sheet, const Finish& finish, const Colophon& colophon) {
  const auto bytes = encode_png(image_of(sheet, finish), png_texts_of(colophon));
  return {bytes.begin(), bytes.end()};
}

std::string pdf_of(std::size_t pages, const std::function<Sheet(std::size_t)>& page, const Finish& finish,
                   const Colophon& colophon) {
  check_fonts();
  std::string text;
  const Surface surface(cairo().pdf_surface_create_for_stream(append, &text, 1, 1));
  set_pdf_metadata(surface.get(), colophon);
  SharedPictures shared;
  for (std::size_t i = 0; i < pages; ++i) {
    const Sheet sheet = page(i);
    // A CSS pixel is 3/4 of a PDF point
    cairo().pdf_surface_set_size(surface.get(), sheet.width * 0.75, sheet.height * 0.75);
    check(cairo().surface_status(surface.get()));
    const Context context(cairo().create(surface.get()));
    cairo().scale(context.get(), 0.75, 0.75);
    Painter(context.get(), finish, &shared).paint(sheet);
    cairo().show_page(context.get());
    check(cairo().status(context.get()));
  }
  {
    // It makes fonts of its own, which two threads may not let go of at once (see set_font)
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    cairo().surface_finish(surface.get());
  }
  check(cairo().surface_status(surface.get()));
  return text;
}

}  // namespace gradus
