// The footer: where in the run the step is, and what the marks mean.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double to_text = 8, to_legend = 40;

constexpr double largest_swatch = 32, smallest_swatch = 18;

/// Where the legend begins in its first line, unless the position is longer, and how far its entries are
/// apart; units.
struct Setting {
  double left, gap;
  bool phase = true;  ///< the position tells it
};
/// The roomiest first. The last begins behind the longest number of a step.
std::array<Setting, 3> settings_of(const Trace& trace) {
  constexpr double left = 280;
  const std::string longest = fmt::format("{}.888", trace.last);
  const std::string step =
      trace.wording.say("figure.step", fmt::arg("number", longest), fmt::arg("last", trace.last));
  const double behind = trace.steps.empty() ? left : text_width(step, Face::sans, text_size) + to_legend;
  return {{{left, 28}, {left, 14}, {std::min(left, behind), 14, false}}};
}

/// Puts things of some widths into lines one after another; units or pixels.
struct Lines {
  double left, right, x;
  int line = 1;
  /// Where the next one begins.
  double place(double width, double gap) {
    if (x + width > right && x > left) {
      ++line;
      x = left;
    }
    const double at = x;
    x += width + gap;
    return at;
  }
};

/// Pixels: of the mark, and with its text.
struct Widths {
  double swatch, all;
};
Widths widths_of(const LegendEntry& entry, const LegendMark& mark, double s) {
  const bool round = (mark.sample == Sample::dot || mark.sample == Sample::ring) && mark.dots.size() == 1;
  const double swatch = (round || mark.sample == Sample::cross ? smallest_swatch : largest_swatch) * s;
  return {swatch, swatch + to_text * s + text_width(entry.text, Face::sans, text_size * s)};
}

int lines_for(const ShownLegend& legend, Lines lines, double gap, double s) {
  for (const auto& [entry, mark] : legend) lines.place(widths_of(entry, mark, s).all, gap);
  return lines.line;
}

}  // namespace

int footer_lines(const Trace& trace, double room) {
  constexpr int most = 3;
  const auto settings = settings_of(trace);
  const auto lines_with = [&](auto is_shown) {
    int fewest = most;
    for (const Setting& setting : settings) {
      Lines lines{0, room, setting.left};
      for (std::size_t i = 0; i < trace.legend.size(); ++i) {
        const double text = text_width(trace.legend[i].text, Face::sans, text_size);
        if (is_shown(i)) lines.place(largest_swatch + to_text + text, setting.gap);
      }
      fewest = std::min(fewest, lines.line);
    }
    return fewest;
  };
  if (trace.legends.empty()) return lines_with([](std::size_t) { return true; });
  int lines = 1;
  for (const LegendEntries shown : trace.legends)
    lines = std::max(lines, lines_with([shown](std::size_t i) { return (shown >> i & 1) != 0; }));
  return lines;
}

void lay_out_footer(Pen& pen, const Figure& figure, const Box& box, const ShownLegend& entries, int lines) {
  const double s = pen.scale(), size = text_size * s;
  const double baseline = box.y + (box.width < 1000 * s ? 28 : 32) * s;
  std::string place;
  Lines legend{};
  double gap = 0;
  for (const Setting& setting : settings_of(*figure.trace)) {
    const bool phase = setting.phase && !figure.phase.empty();
    place =
        elided(phase ? figure.position + " · " + figure.phase : figure.position, Face::sans, size, box.width);
    // The longest position there is decides where the legend starts, so that it keeps still
    const double left = std::max(setting.left * s, text_width(place, Face::sans, size) + to_legend * s);
    legend = {box.x, box.right(), box.x + left};
    gap = setting.gap * s;
    if (lines_for(entries, legend, gap, s) <= lines) break;
  }
  pen.text("position", {{box.x, baseline}, place, Face::sans, size, Align::left, Paint::of(Tone::muted)});
  for (const auto& [entry, mark] : entries) {
    const auto [swatch_width, width] = widths_of(entry, mark, s);
    const double x = legend.place(width, gap);
    if (legend.line > lines || x + width > box.right()) break;  // a text longer than the sheet is wide
    const double y = baseline + (legend.line - 1) * footer_line * s;
    const std::string id = std::string(name_of(entry.role));
    const Box swatch{x, y - 16 * s, swatch_width, 18 * s};
    draw_legend_mark(pen, "legend " + id, entry.role, mark, swatch);
    pen.text("legend text " + id, {{swatch.right() + to_text * s, y},
                                   entry.text,
                                   Face::sans,
                                   size,
                                   Align::left,
                                   Paint::of(Tone::muted)});
  }
}

}  // namespace gradus::layout
