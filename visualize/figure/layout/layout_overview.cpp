// The overview: the whole grid, small, with the part that the view shows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/geometry.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::layout {
namespace {

class OverviewLayout {
 public:
  OverviewLayout(Pen& pen, const Figure& figure, const Scene& scene)
      : pen_(pen), figure_(figure), trace_(*figure.trace), s_(pen.scale()), at_(scene), frame_(scene.frame) {}

  void draw() {
    const Window all = trace_.grid.own();
    const double ratio = static_cast<double>(all.width()) / static_cast<double>(all.height());
    const double most_width = (at_.beside ? 1 : 0.55) * at_.inset.width;
    const bool captions = !at_.beside || at_.inset.height > 160 * s_;
    const double most_height = trace_.grid.picture ? at_.inset.height : 150 * s_;
    aside_ = !at_.beside || (trace_.grid.picture && at_.inset.width - at_.inset.height * ratio > 160 * s_);
    const double height = std::min(at_.inset.height - (!aside_ && captions ? 90 * s_ : 0), most_height);
    Box whole{at_.inset.x, at_.inset.y, height * ratio, height};
    if (whole.width > most_width) {
      whole.width = most_width;
      whole.height = std::max(most_width / ratio, 6 * s_);
    }
    whole.width = std::max(whole.width, 6 * s_);
    draw_overview_cells(whole);
    pen_.rect("overview frame", {whole, {}, Paint::of(Tone::muted), 1.5 * s_, 0, false, Hatch::none, {}});
    const auto to_whole = [&](dvec2 p) {
      const double x = (p.x - all.lower.x + 0.5) / static_cast<double>(all.width());
      const double y = (p.y - all.lower.y + 0.5) / static_cast<double>(all.height());
      return dvec2{whole.x + x * whole.width,
                   frame_.y_up ? whole.bottom() - y * whole.height : whole.y + y * whole.height};
    };
    for (const Mark& mark : trace_.backdrop) {
      if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
        draw_overview_chain(mark, {to_whole(stroke->a), to_whole(stroke->b)}, whole);
      } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
        std::vector<dvec2> points;
        std::ranges::transform(path->points, std::back_inserter(points), to_whole);
        if (path->closed) points.push_back(points.front());
        draw_overview_chain(mark, points, whole);
      }
    }
    for (const auto& [id, mark] : figure_.canvas->marks()) {
      if (const Dot* dot = std::get_if<Dot>(&mark.shape))
        pen_.disc("overview " + id, disc_at(to_whole(dot->at), mark_paint(trace_, mark), dot->ring, s_));
    }
    const Window& view = frame_.view;
    const dvec2 a = to_whole({view.lower.x - 0.5, view.lower.y - 0.5});
    const dvec2 b = to_whole({view.upper.x + 0.5, view.upper.y + 0.5});
    Box part{std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
    if (part.width < 8 * s_) part = {part.x + part.width / 2 - 4 * s_, part.y, 8 * s_, part.height};
    if (part.height < 8 * s_) part = {part.x, part.y + part.height / 2 - 4 * s_, part.width, 8 * s_};
    pen_.rect("overview view", {part, {}, Paint::mark(Role::current), 3 * s_, 0, false, Hatch::none, {}});
    if (captions) caption_overview(whole);
  }

  std::vector<Box> texts() && { return std::move(texts_); }

 private:
  /// A line or a curve; of a curve's points those a pixel apart are enough here.
  void draw_overview_chain(const Mark& mark, const std::vector<dvec2>& points, const Box& whole) {
    StrokesShape shape{{}, Paint::mark(mark.role), 2 * s_, false};
    dvec2 from = points.front();
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (i + 1 < points.size() && length_of(points[i] - from) < s_) continue;
      if (const auto part = clipped(from, points[i], whole)) shape.segments.push_back(*part);
      from = points[i];
    }
    if (!shape.segments.empty()) pen_.strokes("overview " + mark.id, std::move(shape));
  }

  void draw_overview_cells(const Box& whole) {
    const Window all = trace_.grid.own();
    const int most = trace_.grid.picture ? 512 : 208;  // samples per side: more than it has at 720 lines
    if (!trace_.grid.picture && static_cast<double>(all.width()) * static_cast<double>(all.height()) > 4e6)
      return;
    const int width = static_cast<int>(std::min<std::int64_t>(all.width(), most));
    const int height = static_cast<int>(std::min<std::int64_t>(all.height(), most));
    pen_.image("overview", overview_image(whole, width, height));
  }

  /// One sample per cell of the small picture; cells with a role win over the input picture.
  ImageShape overview_image(const Box& whole, int width, int height) const {
    const Window all = trace_.grid.own();
    ImageShape small{whole, Image(width, height, Rgba8{0, 0, 0, 0}), Raster<std::uint8_t>(width, height)};
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const ivec2 p{static_cast<int>(all.lower.x + column * all.width() / width),
                      static_cast<int>(all.lower.y + row * all.height() / height)};
        const ivec2 to{column, frame_.y_up ? height - 1 - row : row};
        if (trace_.grid.picture) small.image[to] = (*trace_.grid.picture)[p - all.lower];
        const auto look = figure_.canvas->at(p);
        if (look && look->color) {
          small.image[to] = *look->color;
        } else if (look) {
          small.roles[to] = static_cast<std::uint8_t>(1 + static_cast<int>(look->role));
        }
      }
    }
    return small;
  }

  /// Beside or below the small picture: its size, and which part of it is in view. What doesn't fit is left
  /// out: the axes say it too.
  void caption_overview(const Box& whole) {
    const Window all = trace_.grid.own();
    const Window& view = frame_.view;
    const double x = aside_ ? whole.right() + 14 * s_ : at_.inset.x;
    const double room = at_.inset.right() - x;
    double y = aside_ ? whole.y + 20 * s_ : whole.bottom() + 24 * s_;
    const auto fits = [&](const std::string& text) {
      return text_width(text, Face::sans, text_size * s_) <= room;
    };
    const auto line = [&](std::string id, const std::string& text) {
      if (!fits(text)) return;
      TextShape shape{{x, y}, text, Face::sans, text_size * s_, Align::left, Paint::of(Tone::muted)};
      texts_.push_back(shape.box());
      pen_.text(std::move(id), std::move(shape));
      y += 28 * s_;
    };
    const std::string size =
        trace_.wording.say("figure.whole", fmt::arg("width", all.width()), fmt::arg("height", all.height()));
    line("overview size", fits(size) ? size : fmt::format("{} × {}", all.width(), all.height()));
    line("overview columns", fmt::format("{} {} … {}", trace_.grid.x_name, figure_number(view.lower.x),
                                         figure_number(view.upper.x)));
    line("overview rows", fmt::format("{} {} … {}", trace_.grid.y_name, figure_number(view.lower.y),
                                      figure_number(view.upper.y)));
  }

  Pen& pen_;
  const Figure& figure_;
  const Trace& trace_;
  double s_;
  const Scene& at_;
  const Frame& frame_;
  bool aside_ = false;  ///< words stand beside the small picture, not below it
  std::vector<Box> texts_;
};

}  // namespace

std::vector<Box> draw_overview(Pen& pen, const Figure& figure, const Scene& scene) {
  OverviewLayout overview(pen, figure, scene);
  overview.draw();
  return std::move(overview).texts();
}

}  // namespace gradus::layout
