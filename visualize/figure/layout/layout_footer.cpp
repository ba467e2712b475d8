// The footer: where in the run the step is, and what the marks mean.

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double legend_left =
    280;  ///< units: from there on in the first line, unless the position is longer
constexpr double to_text = 8;
/// From an entry to the next; the second where the first takes one line more.
constexpr std::array to_next{28.0, 14.0};
constexpr double largest_swatch = 32, smallest_swatch = 18;

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

struct ShownEntry {
  const LegendEntry* entry;
  LegendMark mark;
  double swatch, width;  ///< pixels: of the mark, and with its text
};

std::vector<ShownEntry> shown_entries(const Figure& figure, const Window& view, double s) {
  std::vector<ShownEntry> entries;
  for (const LegendEntry& entry : figure.trace->legend) {
    const auto mark = legend_mark(figure, view, entry);
    if (!mark) continue;
    const bool round =
        (mark->sample == Sample::dot || mark->sample == Sample::ring) && mark->dots.size() == 1;
    const double swatch = (round || mark->sample == Sample::cross ? smallest_swatch : largest_swatch) * s;
    entries.push_back(
        {&entry, *mark, swatch, swatch + to_text * s + text_width(entry.text, Face::sans, text_size * s)});
  }
  return entries;
}

int lines_for(std::span<const ShownEntry> entries, Lines lines, double gap) {
  for (const ShownEntry& entry : entries) lines.place(entry.width, gap);
  return lines.line;
}

}  // namespace

int footer_lines(const Trace& trace, double room) {
  constexpr int most = 3;
  const auto lines_with = [&](auto is_shown) {
    int fewest = most;
    for (const double gap : to_next) {
      Lines lines{0, room, legend_left};
      for (std::size_t i = 0; i < trace.legend.size(); ++i) {
        const double text = text_width(trace.legend[i].text, Face::sans, text_size);
        if (is_shown(i)) lines.place(largest_swatch + to_text + text, gap);
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

void lay_out_footer(Pen& pen, const Figure& figure, const Box& box, const Window& view, int lines) {
  const double s = pen.scale(), size = text_size * s;
  const double baseline = box.y + (box.width < 1000 * s ? 28 : 32) * s;
  const std::vector<ShownEntry> entries = shown_entries(figure, view, s);
  // The longest position there is decides where the legend starts, so that it keeps still
  const auto legend_from = [&](const std::string& place) {
    return Lines{box.x, box.right(),
                 box.x + std::max(legend_left * s, text_width(place, Face::sans, size) + 40 * s)};
  };
  std::string place = figure.phase.empty() ? figure.position : figure.position + " · " + figure.phase;
  if (lines_for(entries, legend_from(place), to_next[1] * s) > lines) place = figure.position;
  place = elided(place, Face::sans, size, box.width);
  pen.text("position", {{box.x, baseline}, place, Face::sans, size, Align::left, Paint::of(Tone::muted)});
  Lines legend = legend_from(place);
  const double gap = to_next[lines_for(entries, legend, to_next[0] * s) > lines ? 1 : 0] * s;
  for (const auto& [entry, mark, swatch_width, width] : entries) {
    const double x = legend.place(width, gap);
    if (legend.line > lines || x + width > box.right()) break;  // a text longer than the sheet is wide
    const double y = baseline + (legend.line - 1) * footer_line * s;
    const std::string id = std::string(name_of(entry->role));
    const Box swatch{x, y - 16 * s, swatch_width, 18 * s};
    draw_legend_mark(pen, "legend " + id, entry->role, mark, swatch);
    pen.text("legend text " + id, {{swatch.right() + to_text * s, y},
                                   entry->text,
                                   Face::sans,
                                   size,
                                   Align::left,
                                   Paint::of(Tone::muted)});
  }
}

}  // namespace gradus::layout
