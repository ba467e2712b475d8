#include "cairo/shapes.hpp"

#include <algorithm>
#include <cmath>

#include "figure/tone_of.hpp"

namespace gradus {
namespace {

void add_diagonals(std::vector<Segment<2, double>>& lines, const Box& b, double gap, bool rising) {
  // Lines x + y = k (rising on a y-down page) or x - y = k, k a multiple of the gap so that neighbours join
  // up
  const double low = rising ? b.x + b.y : b.x - b.bottom();
  const double high = rising ? b.right() + b.bottom() : b.right() - b.y;
  for (double k = std::ceil(low / gap) * gap; k < high; k += gap) {
    const double x0 = rising ? std::max(b.x, k - b.bottom()) : std::max(b.x, k + b.y);
    const double x1 = rising ? std::min(b.right(), k - b.y) : std::min(b.right(), k + b.bottom());
    lines.push_back({{x0, rising ? k - x0 : x0 - k}, {x1, rising ? k - x1 : x1 - k}});
  }
}

/// Diagonals of an area: each is cut where it meets an edge, and every other part lies inside.
void add_diagonals(std::vector<Segment<2, double>>& lines, const AreaShape& area, double gap, bool rising) {
  const auto across = [rising](dvec2 p) { return rising ? p.x + p.y : p.x - p.y; };
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& ring : area.rings) {
    for (const dvec2 p : ring) {
      low = std::min(low, across(p));
      high = std::max(high, across(p));
    }
  }
  for (double k = std::ceil(low / gap) * gap; k < high; k += gap) {
    std::vector<double> cuts;  // x
    for (const auto& ring : area.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double from = across(a) - k, to = across(b) - k;
        if ((from < 0) != (to < 0)) cuts.push_back(a.x + from / (from - to) * (b.x - a.x));
      }
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      const auto at = [&](double x) { return dvec2{x, rising ? k - x : x - k}; };
      lines.push_back({at(cuts[i]), at(cuts[i + 1])});
    }
  }
}

/// The diagonals that make up a hatching.
template <class Shape, class Where>
std::vector<Segment<2, double>> diagonals_of(const Shape& shape, const Where& where, double unit) {
  std::vector<Segment<2, double>> lines;
  if (shape.hatch == Hatch::none) return lines;
  if (shape.hatch != Hatch::falling) add_diagonals(lines, where, shape.hatch_gap * unit, true);
  if (shape.hatch != Hatch::rising) add_diagonals(lines, where, shape.hatch_gap * unit, false);
  return lines;
}

template <class Shape>
void hatch(const Theme& theme, Shape& shape) {
  const HatchLook look = hatch_on(shape.fill, shape.hatch, theme);
  shape.hatch = look.hatch;
  if (look.hatch == Hatch::none) return;
  shape.hatch_gap = look.gap;
  shape.hatch_paint = Paint::mark(shape.fill.role);
}

}  // namespace

RectShape shown_in(const Theme& theme, RectShape rect, double unit) {
  if (!theme.hatched) return rect;
  // The current cell's outline is enough: what lies in it shall be seen
  if (rect.fill != Paint::fill(Role::current)) hatch(theme, rect);
  const bool strong = rect.fill == Paint::of(Tone::strong), weak = rect.fill == Paint::of(Tone::weak);
  if ((strong || weak) && rect.stroke.part == Paint::Part::none) {
    rect.stroke = Paint::of(Tone::ink);
    rect.stroke_width = (strong ? 2 : 1) * unit;
    rect.dashed = weak;
  }
  return rect;
}

AreaShape shown_in(const Theme& theme, AreaShape area) {
  if (theme.hatched) hatch(theme, area);
  return area;
}

std::vector<Segment<2, double>> hatch_lines(const RectShape& rect, double unit) {
  return diagonals_of(rect, rect.box, unit);
}

std::vector<Segment<2, double>> hatch_lines(const AreaShape& area, double unit) {
  return diagonals_of(area, area, unit);
}

double hatch_width(double unit) { return 0.9 * unit; }

std::optional<ArrowHead> arrow_head(const LineShape& line, double unit) {
  if (!line.arrow || line.points.size() < 2) return std::nullopt;
  const dvec2 from = line.points[line.points.size() - 2], to = line.points.back();
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length == 0) return std::nullopt;
  const dvec2 along = (to - from) / length * (3 * line.width + 6 * unit);
  const dvec2 aside{-along.y * 0.4, along.x * 0.4};
  return ArrowHead{to, to - along + aside, to - along - aside};
}

std::optional<Underline> underline(const TextPiece& piece, const TextShape& text, const Theme& theme) {
  if (!theme.quantities_underlined || text.spans.empty() || piece.paint.part != Paint::Part::quantity)
    return std::nullopt;
  const double left = text.box().x + piece.x, y = text.baseline.y + 0.14 * text.size;
  const bool thick = piece.paint.number >= 2, dashed = piece.paint.number % 2 != 0;
  return Underline{{{left, y}, {left + piece.width, y}}, text.size / (thick ? 8 : 14), dashed};
}

double halo_width(const TextShape& text) { return text.size / 4; }

std::pair<double, double> dashes(double width) { return {3 * width, 2 * width}; }

Image pixels_of(const ImageShape& shape, const Theme& theme) {
  Image pixels = shape.image;
  for (int y = 0; y < pixels.height(); ++y) {
    for (int x = 0; x < pixels.width(); ++x) {
      const ivec2 p{x, y};
      if (!shape.roles.contains(p) || shape.roles[p] == 0) continue;
      const std::uint32_t mark = theme[static_cast<Role>(shape.roles[p] - 1)].mark.hex;
      pixels[p] = {static_cast<std::uint8_t>(mark >> 16), static_cast<std::uint8_t>(mark >> 8),
                   static_cast<std::uint8_t>(mark), 255};
    }
  }
  if (!theme.grey) return pixels;
  for (int y = 0; y < pixels.height(); ++y) {
    for (int x = 0; x < pixels.width(); ++x) {
      Rgba8& pixel = pixels[{x, y}];
      const LinearRgb light = linear_from_srgb8(pixel);
      const Rgba8 grey = tone_of(0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z);
      pixel = {grey.r, grey.g, grey.b, pixel.a};
    }
  }
  return pixels;
}

}  // namespace gradus
