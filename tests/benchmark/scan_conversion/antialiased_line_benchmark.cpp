// Lines a pixel wide without stairs: time per pixel, and how far intensities are from the area that the line
// has of each pixel.

#include "scan_conversion/antialiased_line/antialiased_line.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "benchmark/scan_conversion/peers.hpp"
#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace antialiased_line;

constexpr int side = 1024;
using Canvas = Raster<std::uint8_t>;

struct Line {
  ivec2 from, to;
};

std::vector<Line> lines_of(int length) {
  Random random(41);
  std::vector<Line> lines;
  while (lines.size() < static_cast<std::size_t>(16384 / length)) {
    const auto within = [&](int margin) {
      return ivec2(static_cast<int>(random.uniform_int(margin, side - 1 - margin)),
                   static_cast<int>(random.uniform_int(margin, side - 1 - margin)));
    };
    const ivec2 from = within(length + 8);
    const auto along = [&] { return static_cast<int>(random.uniform_int(-length, length)); };
    const ivec2 to = random.unit() < 0.5 ? from + ivec2(length, along()) : from + ivec2(along(), length);
    lines.push_back({from, to});
  }
  return lines;
}

/// One line a canvas, with the area of each of its pixels: what exact_area has, to 1e-12.
struct Right {
  std::vector<Line> lines;
  std::vector<std::vector<std::pair<ivec2, double>>> areas;
  std::int64_t pixels = 0;

  explicit Right(int length) : lines(lines_of(length)) {
    for (const Line& line : lines) {
      areas.emplace_back();
      exact_area(line.from, line.to, [&](ivec2 p, double area) { areas.back().emplace_back(p, area); });
      pixels += std::ssize(areas.back());
    }
  }
};

/// draw(canvas, line) writes intensities; pixels that it leaves out are 0.
template <class Draw>
Case case_of(const std::shared_ptr<const Right>& right, int length, const char* name, Standing standing,
             Draw draw) {
  const auto canvas = std::make_shared<Canvas>(side, side);
  Error::Sum sum;
  for (std::size_t i = 0; i < right->lines.size(); ++i) {
    draw(*canvas, right->lines[i]);
    for (const auto& [p, area] : right->areas[i]) sum.add((*canvas)[p] - 255 * area);
    std::ranges::fill(canvas->cells(), std::uint8_t{0});
  }
  return {.method = name,
          .standing = standing,
          .workload = {fmt::format("{} pixels long", length), static_cast<double>(length)},
          .items = right->pixels,
          .run =
              [=] {
                for (const Line& line : right->lines) draw(*canvas, line);
              },
          .prepare = [=] { std::ranges::fill(canvas->cells(), std::uint8_t{0}); },
          .error = sum.error()};
}

/// Cairo's strokes with butt ends, antialiased as they are by default.
class CairoStroke {
 public:
  void operator()(Canvas& canvas, const Line& line) {
    if (!context_) open(canvas);
    cairo_surface_mark_dirty(surface_.get());
    cairo_move_to(context_.get(), line.from.x + 0.5, line.from.y + 0.5);
    cairo_line_to(context_.get(), line.to.x + 0.5, line.to.y + 0.5);
    cairo_stroke(context_.get());
  }

 private:
  void open(Canvas& canvas) {
    surface_.reset(
        cairo_image_surface_create_for_data(canvas.cells().data(), CAIRO_FORMAT_A8, side, side, side));
    context_.reset(cairo_create(surface_.get()));
    cairo_set_line_width(context_.get(), 1);
  }
  std::unique_ptr<cairo_surface_t, peers::With<cairo_surface_destroy>> surface_;
  std::unique_ptr<cairo_t, peers::With<cairo_destroy>> context_;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int length : {8, 32, 128}) {
    const auto right = std::make_shared<const Right>(length);
    all.push_back(case_of(right, length, "wu", Standing::taught, [](Canvas& canvas, const Line& line) {
      wu(line.from, line.to, [&](ivec2 p, int part) { canvas[p] = static_cast<std::uint8_t>(part); });
    }));
    all.push_back(
        case_of(right, length, "gupta_sproull", Standing::taught, [](Canvas& canvas, const Line& line) {
          gupta_sproull(line.from, line.to,
                        [&](ivec2 p, int part) { canvas[p] = static_cast<std::uint8_t>(part); });
        }));
    all.push_back(
        case_of(right, length, "exact_area", Standing::robust, [](Canvas& canvas, const Line& line) {
          exact_area(line.from, line.to,
                     [&](ivec2 p, double area) { canvas[p] = static_cast<std::uint8_t>(byte_of(area)); });
        }));
    const auto cairo = std::make_shared<CairoStroke>();
    all.push_back(case_of(right, length, "Cairo", Standing::peer,
                          [cairo](Canvas& canvas, const Line& line) { (*cairo)(canvas, line); }));
  }
  return all;
}

}  // namespace

Subject antialiased_line() {
  return {.topic = "antialiased_line",
          .title = "Lines without stairs",
          .item = "pixel",
          .unit = "steps of a byte",
          .measure = "length in pixels",
          .telling = "32 pixels long",
          .cases = cases,
          .choice = {"gupta_sproull", "equally bright in all directions, without the time of exact areas"}};
}

}  // namespace gradus::bench
