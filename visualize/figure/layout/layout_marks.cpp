// What marks look like, in the drawing and, small, in the legend.

#include <algorithm>
#include <set>

#include "figure/layout/layout.hpp"

namespace gradus::layout {

double line_width(Role role) {
  switch (role) {
    case Role::current:
      return 6;
    case Role::result:
    case Role::measure:
      return 5;
    case Role::boundary:
    case Role::accepted:
    case Role::candidate:
      return 4;
    case Role::input:
    case Role::rejected:
      return 3;
    case Role::past:
      return 2.2;
    case Role::guide:
      break;
  }
  return 1.4;
}

LineShape line_through(std::vector<dvec2> points, Role role, const ChainLook& look, double scale) {
  return {std::move(points),
          Paint::mark(role),
          (look.thin ? thin_width : line_width(role)) * scale,
          look.dashed || is_dashed(role),
          look.closed,
          look.arrow};
}

namespace {
Paint paint_of(const Trace& trace, const Mark& mark, Paint otherwise) {
  const auto quantity = color_of_quantity(trace, mark.quantity);
  return quantity ? Paint::quantity(*quantity, mark.role) : otherwise;
}
}  // namespace

Paint mark_paint(const Trace& trace, const Mark& mark) {
  return paint_of(trace, mark, Paint::mark(mark.role));
}
Paint text_paint(const Trace& trace, const Mark& mark) {
  return paint_of(trace, mark, Paint::text(mark.role));
}

DiscShape disc_at(dvec2 at, Paint paint, bool ring, double scale) {
  const double radius = (paint.role == Role::current ? 8 : 7) * scale;
  if (ring) return {at, radius, Paint::of(Tone::paper), paint, 3 * scale};
  return {at, radius, paint, Paint::of(Tone::paper), 2 * scale};
}

AreaShape area_in(std::vector<std::vector<dvec2>> rings, Role role, int shade) {
  if (shade > 0) return {std::move(rings), Paint::tint(role, shade), Hatch::none, {}};
  return {std::move(rings), Paint::fill(role), area_hatch(role), Paint::mark(role)};
}

void draw_cell_ground(Pen& pen, const std::string& id, Role role, const Box& box) {
  const Channel channel = channel_of(role);
  pen.rect(id, {box, Paint::fill(role), {}, 0, 0, false, channel.hatch, Paint::mark(role)});
}

void draw_cell_outline(Pen& pen, const std::string& id, Role role, const Box& box, double most) {
  const Channel channel = channel_of(role);
  if (channel.outline == 0) return;
  const double s = pen.scale(), inset = channel.outline * s / 2;
  const double width = std::min(channel.outline * s, box.height * most);
  pen.rect(id, {grown(box, -inset), {}, Paint::mark(role), width, 0, channel.dashed, Hatch::none, {}});
  if (!channel.cross) return;
  const Box in = grown(box, -box.height * 0.3);
  pen.line(id, {{{in.x, in.y}, {in.right(), in.bottom()}}, Paint::mark(role), 2 * s, false, false, false});
  pen.line(id, {{{in.x, in.bottom()}, {in.right(), in.y}}, Paint::mark(role), 2 * s, false, false, false});
}

// --- The legend ----------------------------------------------------------------------------------

namespace {

/// The kinds of marks that show a role.
struct Kinds {
  bool cell = false, area = false, line = false, outline = false, arrow = false, dot = false, ring = false;
  bool solid = false;                ///< a line that is not dashed
  bool full = false;                 ///< a line that is not thin
  int lightest = 3, darkest = 0;     ///< shades of its areas; 0: its fill
  std::set<std::string> quantities;  ///< of its dots

  void add(const Mark& mark) {
    if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
      (stroke->arrow ? arrow : line) = true;
      solid |= !stroke->dashed;
      full |= !stroke->thin;
    } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
      (path->closed ? outline : line) = true;
      solid |= !path->dashed;
      full = true;
    } else if (const Dot* found = std::get_if<Dot>(&mark.shape)) {
      (found->ring ? ring : dot) = true;
      quantities.insert(mark.quantity);
    } else if (const Area* inside = std::get_if<Area>(&mark.shape)) {
      area = true;
      lightest = std::min(lightest, inside->shade);
      darkest = std::max(darkest, inside->shade);
    }
  }
  /// Of a solid's the middle one.
  int shade() const { return std::clamp(2, std::min(lightest, darkest), darkest); }
  bool lines() const { return line || outline || arrow; }
  std::optional<Sample> sample() const {
    if (cell) return Sample::cell;
    if (area) return Sample::area;
    if (line) return Sample::line;
    if (outline) return Sample::outline;
    if (arrow) return Sample::arrow;
    if (dot) return Sample::dot;
    return ring ? std::optional(Sample::ring) : std::nullopt;
  }
};

/// Whether a cell in view has this role, or this colour of its own.
bool has_cell(const Figure& figure, const Window& view, Role role, std::optional<Rgba8> color) {
  for (std::int64_t y = view.lower.y; y <= view.upper.y; ++y) {
    for (std::int64_t x = view.lower.x; x <= view.upper.x; ++x) {
      const auto look = figure.canvas->at({static_cast<int>(x), static_cast<int>(y)});
      if (look && look->role == role && look->color == color) return true;
    }
  }
  return false;
}

Kinds kinds_of(const Figure& figure, const Window& view, Role role) {
  Kinds kinds;
  kinds.cell = has_cell(figure, view, role, std::nullopt);
  const auto add = [&](const Mark& mark) {
    if (mark.role == role) kinds.add(mark);
  };
  for (const Mark& mark : figure.trace->backdrop) add(mark);
  for (const auto& [id, mark] : figure.canvas->marks()) add(mark);
  return kinds;
}

}  // namespace

std::optional<LegendMark> legend_mark(const Figure& figure, const Window& view, const LegendEntry& entry) {
  if (entry.color) {
    if (!has_cell(figure, view, entry.role, entry.color)) return std::nullopt;
    return LegendMark{.sample = Sample::cell, .color = entry.color};
  }
  const Kinds kinds = kinds_of(figure, view, entry.role);
  const auto sample = kinds.sample();
  if (!sample) return std::nullopt;
  LegendMark mark{entry.sample.value_or(*sample), kinds.lines() && !kinds.solid, kinds.area && kinds.lines(),
                  kinds.shade(), kinds.lines() && !kinds.full};
  for (const std::string& quantity : kinds.quantities)
    mark.dots.push_back(mark_paint(*figure.trace, {"", entry.role, Dot{}, quantity}));
  if (mark.dots.empty()) mark.dots.push_back(Paint::mark(entry.role));
  return mark;
}

ShownLegend shown_legend(const Figure& figure, const Window& view) {
  ShownLegend shown;
  for (const LegendEntry& entry : figure.trace->legend) {
    if (auto mark = legend_mark(figure, view, entry)) shown.emplace_back(entry, std::move(*mark));
  }
  return shown;
}

namespace {
/// A dot of each look there is, side by side.
void draw_dots(Pen& pen, const std::string& id, const LegendMark& mark, const Box& box) {
  const auto count = static_cast<double>(mark.dots.size());
  double x = box.x + box.width / (2 * count);
  for (const Paint paint : mark.dots) {
    pen.disc(id, disc_at({x, box.y + box.height / 2}, paint, mark.sample == Sample::ring, pen.scale()));
    x += box.width / count;
  }
}
}  // namespace

void draw_legend_mark(Pen& pen, const std::string& id, Role role, const LegendMark& mark, const Box& box) {
  const double s = pen.scale(), middle = box.y + box.height / 2;
  const auto line = [&](std::vector<dvec2> points, ChainLook look) {
    look.dashed = mark.dashed;
    look.thin = mark.thin;
    pen.line(id, line_through(std::move(points), role, look, s));
  };
  const auto corners = [](const Box& b) {
    return std::vector<dvec2>{{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}};
  };
  const Box rim = grown(box, -line_width(role) * s / 2);
  switch (mark.sample) {
    case Sample::line:
      return line({{box.x, middle}, {box.right(), middle}}, {});
    case Sample::outline:
      return line(corners(rim), {.closed = true});
    case Sample::arrow:
      return line({{box.x, middle}, {box.right(), middle}}, {.arrow = true});
    case Sample::cross: {
      const double half = 5 * s, x = box.x + box.width / 2;
      line({{x - half, middle - half}, {x + half, middle + half}}, {});
      return line({{x - half, middle + half}, {x + half, middle - half}}, {});
    }
    case Sample::dot:
    case Sample::ring:
      return draw_dots(pen, id, mark, box);
    case Sample::area:
      pen.area(id, area_in({corners(mark.outlined ? rim : box)}, role, mark.shade));
      if (mark.outlined) line(corners(rim), {.closed = true});
      return;
    case Sample::cell:
      if (mark.color) return pen.image(id, {box, Image(1, 1, *mark.color), {}});
      draw_cell_ground(pen, id, role, box);
      draw_cell_outline(pen, id, role, box, 0.3);  // as heavy as in the drawing
  }
}

ImageShape image_in(const Frame& frame, const Picture& picture) {
  const dvec2 a = frame.point(picture.lower), b = frame.point(picture.upper);
  const dvec2 corner = glm::min(a, b), last = glm::max(a, b),
              size(picture.image->width(), picture.image->height());
  const dvec2 pixel = (last - corner) / size;
  const dvec2 least(frame.box.x, frame.box.y), most(frame.box.right(), frame.box.bottom());
  constexpr double noise = 1e-6;  // of a pixel
  const dvec2 from = glm::ceil(glm::max((least - corner) / pixel, dvec2(0)) - noise);
  const dvec2 to = glm::floor(glm::min((most - corner) / pixel, size) + noise);
  const ivec2 columns_rows(glm::max(to - from, dvec2(0)));
  Image part(columns_rows.x, columns_rows.y);
  for (ivec2 p{0, 0}; p.y < part.height(); ++p.y) {
    for (p.x = 0; p.x < part.width(); ++p.x) part[p] = (*picture.image)[p + ivec2(from)];
  }
  const dvec2 at = corner + from * pixel, reach = dvec2(columns_rows) * pixel;
  return {{at.x, at.y, reach.x, reach.y}, std::move(part), {}, true};
}

}  // namespace gradus::layout
