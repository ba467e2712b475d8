#include "figure/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gradus {
namespace {

using namespace layout;

constexpr double margin = 40, gutter = 20;
constexpr double title_band = 84, footer_band = 54, sentence_band = 96;
constexpr double column_width = 604;  ///< of listing and table: 44 characters and the line numbers
constexpr double line_height = 30, row_height = 34, heading_height = 38, panel_padding = 8;
constexpr int least_rows = 4, most_rows = 7, most_lines = 12;

struct Places {
  Box title, drawing, listing, table, sentence, footer;
  int lines = 0, rows = 0;  ///< that the listing and the table can show
};

int height_in_lines(const Trace& trace, double room) {
  const double left_for_rows = heading_height + least_rows * row_height + gutter;
  const int fitting = static_cast<int>((room - left_for_rows - 2 * panel_padding) / line_height);
  return std::min({static_cast<int>(trace.listing.size()), fitting, most_lines});
}

/// Where the slots go. Depends on the trace and the look only, so that a deck flips without jumping.
Places places_of(const Trace& trace, const Look& look, double s) {
  const auto has = [&look](Slot slot) { return look.slots.contains(slot); };
  const double width = look.width / s, height = look.height / s;
  Places at;
  double top = has(Slot::title) ? title_band : gutter;
  double bottom = height - gutter;
  at.title = {margin, 0, width - 2 * margin, title_band};
  if (has(Slot::footer)) {
    bottom = height - footer_band;
    at.footer = {margin, bottom, width - 2 * margin, footer_band};
  }
  if (has(Slot::sentence)) {
    bottom -= sentence_band;
    at.sentence = {margin, bottom + 12, width - 2 * margin, sentence_band - 16};
  }
  const bool listing = has(Slot::listing) && !trace.listing.empty();
  const bool table = has(Slot::table) && !trace.columns.empty();
  const bool drawing = has(Slot::drawing);
  const double room = bottom - top - 4;

  Box column{margin, top, width - 2 * margin, room};
  if (drawing && (listing || table)) {
    column = {width - margin - column_width, top, column_width, room};
    at.drawing = {margin, top, column.x - margin - 24, room};
  } else if (drawing) {
    at.drawing = {margin, top, width - 2 * margin, room};
  }
  if (listing) {
    at.lines = table ? height_in_lines(trace, room)
                     : std::min(static_cast<int>(trace.listing.size()),
                                static_cast<int>((room - 2 * panel_padding) / line_height));
    at.listing = {column.x, column.y, column.width, at.lines * line_height + 2 * panel_padding};
  }
  if (table) {
    const double y = listing ? at.listing.bottom() + gutter : column.y;
    at.rows = std::min(static_cast<int>((column.bottom() - y - heading_height) / row_height),
                       listing || drawing ? most_rows : 40);
    at.table = {column.x, y, column.width, heading_height + at.rows * row_height};
  }
  return at;
}

Box scaled(const Box& box, double s) { return {box.x * s, box.y * s, box.width * s, box.height * s}; }

void lay_out_title(Pen& pen, const Figure& figure, const Box& box) {
  const double s = pen.scale();
  const Trace& trace = *figure.trace;
  const double baseline = box.y + 52 * s;
  const double method_width = text_width(trace.method_title, Face::sans, text_size * s);
  const double title_width = text_width(figure.title, Face::bold, 34 * s);
  pen.text("title", {{box.x, baseline}, figure.title, Face::bold, 34 * s, Align::left, Paint::of(Tone::ink)});
  pen.text("method", {{box.right(), baseline},
                      trace.method_title,
                      Face::sans,
                      text_size * s,
                      Align::right,
                      Paint::of(Tone::muted)});
  const double room = box.width - title_width - method_width - 40 * s;
  pen.text("input", {{box.x + title_width + 14 * s, baseline},
                     elided(figure.subtitle, Face::sans, 26 * s, room),
                     Face::sans,
                     26 * s,
                     Align::left,
                     Paint::of(Tone::muted)});
  if (trace.faulty.empty()) return;
  pen.text("faulty", {{box.x, baseline + 26 * s},
                      elided(trace.wording.say("figure.faulty", fmt::arg("what", trace.faulty)), Face::bold,
                             text_size * s, box.width),
                      Face::bold,
                      text_size * s,
                      Align::left,
                      Paint::text(Role::measure)});
}

/// Position in the listing of the nearest shown line at or above a source line.
std::size_t place_in(const std::vector<Figure::ListingLine>& lines, int number) {
  const auto after =
      std::ranges::upper_bound(lines, number, {}, [](const Figure::ListingLine& l) { return l.line.number; });
  return after == lines.begin() ? 0 : static_cast<std::size_t>(after - lines.begin()) - 1;
}

/// First line of the window of `count` lines: the one that holds most of the lines that report steps, as long
/// as the current line is in it, so that the listing keeps still; else one round the current line.
std::size_t first_listed(const Figure& figure, std::size_t count) {
  const auto& lines = figure.listing;
  if (lines.size() <= count) return 0;
  const auto held_from = [&](std::size_t first) {
    return std::ranges::count_if(figure.trace->lines, [&](int number) {
      const std::size_t at = place_in(lines, number);
      return first <= at && at < first + count;
    });
  };
  std::size_t best = 0;
  for (std::size_t first = 1; first + count <= lines.size(); ++first) {
    if (held_from(first) > held_from(best)) best = first;
  }
  const auto strong =
      std::ranges::find(lines, Emphasis::strong, [](const Figure::ListingLine& l) { return l.emphasis; });
  const auto current =
      strong == lines.end() ? std::size_t{0} : static_cast<std::size_t>(strong - lines.begin());
  if (best <= current && current < best + count) return best;
  return std::min(current - std::min(current, count / 2), lines.size() - count);
}

/// Source without its trailing comment, which is the first thing to go when a line is too wide.
std::string fitted_source(const std::string& text, double size, double room) {
  if (text_width(text, Face::mono, size) <= room) return text;
  std::string bare = text;
  const std::size_t comment = bare.find("//");
  if (comment != std::string::npos && bare.find_first_not_of(' ') < comment) {
    bare.erase(bare.find_last_not_of(' ', comment - 1) + 1);
  }
  return elided(bare, Face::mono, size, room);
}

void lay_out_listing(Pen& pen, const Figure& figure, const Box& box, int count) {
  const double s = pen.scale(), size = text_size * s;
  pen.rect("panel",
           {box, Paint::of(Tone::panel), Paint::of(Tone::rule), 1.5 * s, 6 * s, false, Hatch::none, {}});
  const std::size_t first = first_listed(figure, static_cast<std::size_t>(count));
  const double number_right = box.x + 46 * s, text_left = box.x + 62 * s;
  for (int i = 0; i < count && first + static_cast<std::size_t>(i) < figure.listing.size(); ++i) {
    const Figure::ListingLine& entry = figure.listing[first + static_cast<std::size_t>(i)];
    const Box row{box.x, box.y + (panel_padding + i * line_height) * s, box.width, line_height * s};
    const bool strong = entry.emphasis == Emphasis::strong;
    Paint ground = Paint::of(Tone::panel);
    if (entry.emphasis != Emphasis::none) {
      ground = Paint::of(strong ? Tone::strong : Tone::weak);
      pen.rect(fmt::format("ground {}", entry.line.number), {row, ground, {}, 0, 0, false, Hatch::none, {}});
    }
    if (strong) {
      pen.rect(
          "current line",
          {{row.x, row.y, 6 * s, row.height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
    }
    const double baseline = row.y + 22 * s;
    pen.text(fmt::format("number {}", entry.line.number), {{number_right, baseline},
                                                           fmt::format("{}", entry.line.number),
                                                           Face::mono,
                                                           size,
                                                           Align::right,
                                                           Paint::of(strong ? Tone::ink : Tone::muted),
                                                           false,
                                                           ground});
    pen.text(fmt::format("line {}", entry.line.number),
             {{text_left, baseline},
              fitted_source(entry.line.text, size, box.right() - 4 * s - text_left),
              strong ? Face::mono_bold : Face::mono,
              size,
              Align::left,
              Paint::of(Tone::ink),
              false,
              ground});
  }
}

/// Left edge and width of each column: as wide as its widest text asks for, the rest shared evenly.
std::vector<std::pair<double, double>> column_places(const Trace& trace, const Box& box, double s) {
  std::vector<double> wanted;
  double sum = 0;
  for (std::size_t c = 0; c < trace.columns.size(); ++c) {
    const double heading = text_width(trace.columns[c].name, Face::bold, text_size * s);
    const double widest = text_width(trace.widest[c], Face::mono_bold, text_size * s);
    wanted.push_back(std::max(heading, widest) + 20 * s);
    sum += wanted.back();
  }
  const double spare = (box.width - 12 * s - sum) / static_cast<double>(wanted.size());
  const double squeeze = spare < 0 ? (box.width - 12 * s) / sum : 1;
  std::vector<std::pair<double, double>> places;
  double x = box.x + 8 * s;
  for (const double width : wanted) {
    const double given = spare < 0 ? width * squeeze : width + spare;
    places.emplace_back(x, given);
    x += given;
  }
  return places;
}

void lay_out_row(Pen& pen, const Figure& figure, const Figure::TableRow& row, const Box& at, int index,
                 const std::vector<std::pair<double, double>>& columns) {
  const double s = pen.scale(), size = text_size * s;
  const bool strong = row.emphasis == Emphasis::strong;
  Paint ground = Paint::of(Tone::paper);
  if (row.emphasis != Emphasis::none) {
    ground = Paint::of(strong ? Tone::strong : Tone::weak);
    pen.rect(fmt::format("row ground {}", index), {at, ground, {}, 0, 0, false, Hatch::none, {}});
  }
  if (strong) {
    pen.rect("current row",
             {{at.x, at.y, 6 * s, at.height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
  }
  for (std::size_t c = 0; c < std::min(columns.size(), row.cells.size()); ++c) {
    if (row.cells[c].empty()) continue;
    const auto [x, width] = columns[c];
    const bool changed = c < row.changed.size() && row.changed[c];
    const Face face = figure.trace->columns[c].numeric ? (changed ? Face::mono_bold : Face::mono)
                                                       : (changed ? Face::bold : Face::sans);
    const std::string text = elided(row.cells[c], face, size, width - 6 * s);
    const double baseline = at.y + 24 * s, centre = x + width / 2;
    pen.text(fmt::format("cell {} {}", index, figure.trace->columns[c].id),
             {{centre, baseline}, text, face, size, Align::centre, Paint::of(Tone::ink), false, ground});
    if (!changed) continue;
    const double half = text_width(text, face, size) / 2 + 2 * s;
    pen.line(fmt::format("changed {}", figure.trace->columns[c].id),
             {{{centre - half, at.bottom() - 3 * s}, {centre + half, at.bottom() - 3 * s}},
              Paint::of(Tone::accent),
              2.5 * s,
              false,
              false,
              false});
  }
}

void lay_out_table(Pen& pen, const Figure& figure, const Box& box, int room) {
  const double s = pen.scale(), size = text_size * s;
  const Trace& trace = *figure.trace;
  const auto columns = column_places(trace, box, s);
  pen.rect("heading ground", {{box.x, box.y, box.width, heading_height * s},
                              Paint::of(Tone::header),
                              {},
                              0,
                              0,
                              false,
                              Hatch::none,
                              {}});
  for (std::size_t c = 0; c < columns.size(); ++c) {
    pen.text("heading " + trace.columns[c].id,
             {{columns[c].first + columns[c].second / 2, box.y + 26 * s},
              elided(trace.columns[c].name, Face::bold, size, columns[c].second - 4 * s),
              Face::bold,
              size,
              Align::centre,
              Paint::of(Tone::ink),
              false,
              Paint::of(Tone::header)});
  }
  // The last rows that fit; a row of dots stands for those before them
  const std::size_t fitting = static_cast<std::size_t>(std::max(room, 1));
  const bool cut = figure.rows.size() > fitting;
  const std::size_t shown = cut ? fitting - 1 : figure.rows.size();
  const std::size_t first = figure.rows.size() - shown;
  double y = box.y + heading_height * s;
  int index = 0;
  if (cut) {
    pen.text("rows left out", {{columns[0].first + columns[0].second / 2, y + 24 * s},
                               "⋮",
                               Face::sans,
                               size,
                               Align::centre,
                               Paint::of(Tone::muted)});
    y += row_height * s;
    ++index;
  }
  for (std::size_t i = first; i < figure.rows.size(); ++i, ++index) {
    if (index > 0) {
      pen.line(fmt::format("rule {}", index),
               {{{box.x, y}, {box.right(), y}}, Paint::of(Tone::rule), 1.5 * s, false, false, false});
    }
    lay_out_row(pen, figure, figure.rows[i], {box.x, y, box.width, row_height * s}, index, columns);
    y += row_height * s;
  }
  const Box frame{box.x, box.y, box.width, std::max(y - box.y, heading_height * s)};
  pen.rect("frame", {frame, {}, Paint::of(Tone::rule), 1.5 * s, 6 * s, false, Hatch::none, {}});
}

/// In one line, or broken between cause and effect where both fit, or where the words end.
std::vector<std::string> sentence_lines(const std::string& sentence, double size, double room) {
  const auto fits = [&](const std::string& text) { return text_width(text, Face::sans, size) <= room; };
  if (fits(sentence)) return {sentence};
  if (const std::size_t at = sentence.find("; "); at != std::string::npos) {
    const std::string cause = sentence.substr(0, at + 1), effect = sentence.substr(at + 2);
    if (fits(cause) && fits(effect)) return {cause, effect};
  }
  return wrapped(sentence, Face::sans, size, room);
}

void lay_out_sentence(Pen& pen, const Figure& figure, const Box& box) {
  const double s = pen.scale(), size = sentence_size * s;
  pen.rect("panel", {box, Paint::of(Tone::panel), {}, 0, 4 * s, false, Hatch::none, {}});
  pen.rect("bar",
           {{box.x, box.y, 7 * s, box.height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
  const double room = box.width - 40 * s;
  std::vector<std::string> lines = sentence_lines(figure.sentence, size, room);
  if (lines.size() > 2) {
    for (std::size_t i = 2; i < lines.size(); ++i) lines[1] += " " + lines[i];
    lines.resize(2);
    lines[1] = elided(lines[1], Face::sans, size, room);
  }
  double baseline = box.y + (lines.size() < 2 ? 49 : 34) * s;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pen.text(fmt::format("sentence {}", i + 1), {{box.x + 24 * s, baseline},
                                                 elided(lines[i], Face::sans, size, room),
                                                 Face::sans,
                                                 size,
                                                 Align::left,
                                                 Paint::of(Tone::ink),
                                                 false,
                                                 Paint::of(Tone::panel)});
    baseline += 33 * s;
  }
}

/// How a role can be seen in this step: not at all, as a mark only, or as a cell.
enum class Seen : std::uint8_t { no, as_mark, as_cell };

Seen seen(const Figure& figure, const Window& view, Role role) {
  for (std::int64_t y = view.lower.y; y <= view.upper.y; ++y) {
    for (std::int64_t x = view.lower.x; x <= view.upper.x; ++x) {
      const auto look = figure.canvas->at({static_cast<int>(x), static_cast<int>(y)});
      if (look && look->role == role) return Seen::as_cell;
    }
  }
  const auto has_role = [role](const Mark& mark) { return mark.role == role; };
  const bool marked =
      std::ranges::any_of(figure.trace->backdrop, has_role) ||
      std::ranges::any_of(figure.canvas->marks(), [&](const auto& m) { return has_role(m.second); });
  return marked ? Seen::as_mark : Seen::no;
}

void lay_out_footer(Pen& pen, const Figure& figure, const Box& box, const Window& view) {
  const double s = pen.scale(), size = text_size * s;
  const double baseline = box.y + 32 * s;
  const std::string place = figure.phase.empty() ? figure.position : figure.position + " · " + figure.phase;
  pen.text("position", {{box.x, baseline}, place, Face::sans, size, Align::left, Paint::of(Tone::muted)});
  // The longest position there is decides where the legend starts, so that it keeps still
  double x = box.x + std::max(280 * s, text_width(place, Face::sans, size) + 40 * s);
  for (const LegendEntry& entry : figure.trace->legend) {
    const Seen how = seen(figure, view, entry.role);
    if (how == Seen::no) continue;
    const double width = text_width(entry.text, Face::sans, size);
    if (x + 32 * s + width > box.right()) break;
    const std::string id = std::string(name_of(entry.role));
    const Box swatch{x, baseline - 16 * s, 24 * s, 18 * s};
    if (how == Seen::as_mark) {
      pen.line("legend " + id, {{{swatch.x, baseline - 7 * s}, {swatch.right(), baseline - 7 * s}},
                                Paint::mark(entry.role),
                                (entry.role == Role::measure ? 6 : 3) * s,
                                false,
                                false,
                                false});
    } else {
      draw_cell_ground(pen, "legend " + id, entry.role, swatch);
      draw_cell_outline(pen, "legend " + id, entry.role, swatch);
    }
    pen.text("legend text " + id, {{swatch.right() + 8 * s, baseline},
                                   entry.text,
                                   Face::sans,
                                   size,
                                   Align::left,
                                   Paint::of(Tone::muted)});
    x = swatch.right() + 8 * s + width + 28 * s;
  }
}

}  // namespace

Sheet lay_out(const Figure& figure, const Look& look) {
  const double s = look.height / 720;
  Sheet sheet{look.width, look.height, {}};
  const Places at = places_of(*figure.trace, look, s);
  const auto pen = [&](Slot slot) { return Pen(sheet, slot, s); };
  const auto wants = [&](Slot slot, const Box& box) { return look.slots.contains(slot) && box.width > 0; };

  Window view = figure.trace->grid.cells;
  if (wants(Slot::drawing, at.drawing)) {
    view = visible_cells(figure, scaled(at.drawing, s), s);
    Pen drawing = pen(Slot::drawing);
    lay_out_drawing(drawing, figure, scaled(at.drawing, s));
  } else {
    view = {};
  }
  if (wants(Slot::title, at.title)) {
    Pen title = pen(Slot::title);
    lay_out_title(title, figure, scaled(at.title, s));
  }
  if (wants(Slot::listing, at.listing)) {
    Pen listing = pen(Slot::listing);
    lay_out_listing(listing, figure, scaled(at.listing, s), at.lines);
  }
  if (wants(Slot::table, at.table)) {
    Pen table = pen(Slot::table);
    lay_out_table(table, figure, scaled(at.table, s), at.rows);
  }
  if (wants(Slot::sentence, at.sentence)) {
    Pen sentence = pen(Slot::sentence);
    lay_out_sentence(sentence, figure, scaled(at.sentence, s));
  }
  if (wants(Slot::footer, at.footer)) {
    Pen footer = pen(Slot::footer);
    lay_out_footer(footer, figure, scaled(at.footer, s), view);
  }
  return sheet;
}

}  // namespace gradus
