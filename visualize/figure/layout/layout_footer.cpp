// The footer: where in the run the step is, and what the marks mean.

#include <algorithm>

#include "figure/layout/layout.hpp"

namespace gradus::layout {

void lay_out_footer(Pen& pen, const Figure& figure, const Box& box, const Window& view, int lines) {
  const double s = pen.scale(), size = text_size * s;
  double baseline = box.y + (box.width < 1000 * s ? 28 : 32) * s;
  const double last_baseline = baseline + (lines - 1) * footer_line * s;
  const std::string place =
      elided(figure.phase.empty() ? figure.position : figure.position + " · " + figure.phase, Face::sans,
             size, box.width);
  pen.text("position", {{box.x, baseline}, place, Face::sans, size, Align::left, Paint::of(Tone::muted)});
  // The longest position there is decides where the legend starts, so that it keeps still
  double x = box.x + std::max(280 * s, text_width(place, Face::sans, size) + 40 * s);
  for (const LegendEntry& entry : figure.trace->legend) {
    const auto mark = legend_mark(figure, view, entry);
    if (!mark) continue;
    const bool round =
        (mark->sample == Sample::dot || mark->sample == Sample::ring) && mark->dots.size() == 1;
    const double swatch_width = (round || mark->sample == Sample::cross ? 18 : 32) * s,
                 width = text_width(entry.text, Face::sans, size);
    const double needed = swatch_width + 8 * s + width;
    if (x + needed > box.right() && baseline < last_baseline) {
      baseline += footer_line * s;
      x = box.x;
    }
    if (x + needed > box.right()) break;
    const std::string id = std::string(name_of(entry.role));
    const Box swatch{x, baseline - 16 * s, swatch_width, 18 * s};
    draw_legend_mark(pen, "legend " + id, entry.role, *mark, swatch);
    pen.text("legend text " + id, {{swatch.right() + 8 * s, baseline},
                                   entry.text,
                                   Face::sans,
                                   size,
                                   Align::left,
                                   Paint::of(Tone::muted)});
    x += needed + 28 * s;
  }
}

}  // namespace gradus::layout
