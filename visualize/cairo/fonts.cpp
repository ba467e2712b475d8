#include "cairo/fonts.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "cairo/handles.hpp"
#include "figure/metrics.hpp"

namespace gradus {
namespace {

/// Cairo's path as path data with relative whole numbers. The fonts' curves are quadratic; Cairo hands them
/// out as cubic ones, which are written as what they were.
class Outline {
 public:
  explicit Outline(const cairo_path_t& path) {
    for (int i = 0; i < path.num_data; i += path.data[i].header.length) {
      const auto count = static_cast<std::size_t>(path.data[i].header.length);
      add(path.data[i].header.type, {path.data + i + 1, count - 1});
    }
  }

  std::string take() { return std::move(text_); }

 private:
  struct Point {
    double x = 0, y = 0;
  };
  using Points = std::span<const cairo_path_data_t>;
  static Point point(const cairo_path_data_t& data) { return {data.point.x, data.point.y}; }

  void add(cairo_path_data_type_t type, Points points) {
    switch (type) {
      case CAIRO_PATH_MOVE_TO:
        last_ = {};  // Cairo closes, then moves: absolute coordinates need no memory of where that left off
        put('M', {point(points[0])});
        start_ = last_;
        break;
      case CAIRO_PATH_LINE_TO:
        put('l', {point(points[0])});
        break;
      case CAIRO_PATH_CURVE_TO:
        curve(point(points[0]), point(points[1]), point(points[2]));
        break;
      case CAIRO_PATH_CLOSE_PATH:
        text_ += 'z';
        last_ = start_;
        break;
    }
  }

  void curve(Point a, Point b, Point end) {
    const Point from_a{(3 * a.x - last_.x) / 2, (3 * a.y - last_.y) / 2},
        from_b{(3 * b.x - end.x) / 2, (3 * b.y - end.y) / 2};
    if (std::hypot(from_a.x - from_b.x, from_a.y - from_b.y) < 1) return put('q', {from_a, end});
    put('c', {a, b, end});
  }

  /// Numbers apart only where digits would run together.
  void put(char command, std::initializer_list<Point> points) {
    text_ += command;
    bool first = true;
    const Point from = last_;
    for (const Point& p : points) {
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
  Point last_, start_;
};

std::string drawn_outline(char32_t character, Face face) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo_create(surface.get()));
  set_font_options(context.get());
  select_face(context.get(), face, units_per_em);
  cairo_move_to(context.get(), 0, 0);
  cairo_text_path(context.get(), utf8_of(std::u32string(1, character)).c_str());
  check(cairo_status(context.get()));
  const CairoPath path(cairo_copy_path(context.get()));
  check(path->status);
  // A space, and the move to where the next letter would begin, draw nothing
  std::string data = Outline(*path).take();
  data.erase(data.find_last_of('z') == std::string::npos ? 0 : data.find_last_of('z') + 1);
  return data;
}

}  // namespace

void set_font_options(cairo_t* context) {
  const FontOptions options(cairo_font_options_create());
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

double drawn_width(const std::string& text, Face face, double size) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo_create(surface.get()));
  set_font_options(context.get());
  select_face(context.get(), face, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void check_fonts() {
  static std::once_flag once;
  std::call_once(once, [] {
    for (const Face face : {Face::sans, Face::bold, Face::italic, Face::mono, Face::mono_bold}) {
      const std::string text = "gradus Σ≥";  // whose width is known
      if (std::abs(drawn_width(text, face, 100) - text_width(text, face, 100)) > 1) {
        throw std::runtime_error(
            "the DejaVu fonts are missing: install fonts-dejavu-core and fonts-dejavu-extra");
      }
    }
  });
}

const std::string& outline_of(char32_t character, Face face) {
  static std::mutex mutex;
  static std::map<std::pair<Face, char32_t>, std::string> known;
  const std::lock_guard lock(mutex);
  const auto [entry, added] = known.try_emplace({face, character});
  if (added) entry->second = drawn_outline(character, face);
  return entry->second;
}

}  // namespace gradus
