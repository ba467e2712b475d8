#include "figure/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gradus {
namespace {

using namespace layout;

Box scaled(const Box& box, double s) { return {box.x * s, box.y * s, box.width * s, box.height * s}; }

void lay_out_title(Pen& pen, const Heading& heading, const Box& box) {
  const double s = pen.scale();
  const Paint muted = Paint::of(Tone::muted);
  double y = box.y + heading.first_baseline * s;
  for (std::size_t i = 0; i < heading.title.size(); ++i, y += 40 * s) {
    pen.text(i == 0 ? "title" : fmt::format("title {}", i + 1),
             {{box.x, y}, heading.title[i], Face::bold, title_size * s, Align::left, Paint::of(Tone::ink)});
  }
  y -= 40 * s;
  const double title_width = text_width(heading.title.back(), Face::bold, title_size * s);
  if (heading.input_line == 0) {
    pen.text("input",
             {{box.x + title_width + 14 * s, y}, heading.input, Face::sans, 26 * s, Align::left, muted});
  } else {
    pen.text("input", {{box.x, y + 28 * s}, heading.input, Face::sans, text_size * s, Align::left, muted});
  }
  // At the right end beside something else, at the left where it has the line to itself
  const bool beside = heading.method_line == heading.input_line;
  pen.text("method", {{beside ? box.right() : box.x, y + heading.method_line * 28 * s},
                      heading.method,
                      Face::sans,
                      text_size * s,
                      beside ? Align::right : Align::left,
                      muted});
  y += std::max(heading.input_line, heading.method_line) * 28 * s;
  for (std::size_t i = 0; i < heading.fault.size(); ++i) {
    y += 26 * s;
    pen.text(
        i == 0 ? "faulty" : fmt::format("faulty {}", i + 1),
        {{box.x, y}, heading.fault[i], Face::bold, text_size * s, Align::left, Paint::text(Role::measure)});
  }
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
  const double number_right = box.x + 46 * s, text_left = box.x + listing_indent * s;
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

/// The width that no column may pass so that all fit: the widest give way, the others stay whole.
double widest_that_fits(std::vector<double> wanted, double room) {
  std::ranges::sort(wanted);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double share = room / static_cast<double>(wanted.size() - i);
    if (wanted[i] > share) return share;
    room -= wanted[i];
  }
  return wanted.back();
}

/// Left edge and width of each column: as wide as its widest text asks for, the rest shared evenly.
std::vector<std::pair<double, double>> column_places(const Trace& trace, const Box& box, double s) {
  const std::vector<double> wanted = column_widths(trace);
  double sum = 0;
  for (const double width : wanted) sum += width * s;
  double spare = (box.width - 12 * s - sum) / static_cast<double>(wanted.size());
  double most = box.width;
  if (spare < -squeezable * s) {
    most = s * widest_that_fits(wanted, box.width / s - 12);
    spare = 0;
  }
  std::vector<std::pair<double, double>> places;
  double x = box.x + 8 * s;
  for (const double width : wanted) {
    const double given = std::min(width * s, most) + spare;
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

void lay_out_sentence(Pen& pen, const Figure& figure, const Box& box, int most) {
  const double s = pen.scale(), size = sentence_size * s;
  pen.rect("panel", {box, Paint::of(Tone::panel), {}, 0, 4 * s, false, Hatch::none, {}});
  pen.rect("bar",
           {{box.x, box.y, 7 * s, box.height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
  const std::vector<std::string> lines = sentence_lines(figure.sentence, size, box.width - 40 * s, most);
  const double below_first = sentence_line * s * (static_cast<double>(lines.size()) - 1);
  double baseline = box.y + (box.height - below_first) / 2 + (lines.size() < 2 ? 9 : 10.5) * s;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pen.text(fmt::format("sentence {}", i + 1), {{box.x + 24 * s, baseline},
                                                 lines[i],
                                                 Face::sans,
                                                 size,
                                                 Align::left,
                                                 Paint::of(Tone::ink),
                                                 false,
                                                 Paint::of(Tone::panel)});
    baseline += sentence_line * s;
  }
}

/// How a role can be seen in this step: not at all, as lines and dots only, as a tinted area, or as a cell.
enum class Seen : std::uint8_t { no, as_mark, as_area, as_cell };

Seen seen(const Figure& figure, const Window& view, Role role) {
  for (std::int64_t y = view.lower.y; y <= view.upper.y; ++y) {
    for (std::int64_t x = view.lower.x; x <= view.upper.x; ++x) {
      const auto look = figure.canvas->at({static_cast<int>(x), static_cast<int>(y)});
      if (look && look->role == role) return Seen::as_cell;
    }
  }
  Seen how = Seen::no;
  const auto look_at = [&](const Mark& mark) {
    if (mark.role != role || std::holds_alternative<Text>(mark.shape)) return;
    how = std::max(how, std::holds_alternative<Area>(mark.shape) ? Seen::as_area : Seen::as_mark);
  };
  for (const Mark& mark : figure.trace->backdrop) look_at(mark);
  for (const auto& [id, mark] : figure.canvas->marks()) look_at(mark);
  return how;
}

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
    const Seen how = seen(figure, view, entry.role);
    if (how == Seen::no) continue;
    const double width = text_width(entry.text, Face::sans, size);
    if (x + 32 * s + width > box.right() && baseline < last_baseline) {
      baseline += footer_line * s;
      x = box.x;
    }
    if (x + 32 * s + width > box.right()) break;
    const std::string id = std::string(name_of(entry.role));
    const Box swatch{x, baseline - 16 * s, 24 * s, 18 * s};
    if (how == Seen::as_mark) {
      pen.line("legend " + id, {{{swatch.x, baseline - 7 * s}, {swatch.right(), baseline - 7 * s}},
                                Paint::mark(entry.role),
                                (entry.role == Role::measure ? 6 : 3) * s,
                                layout::is_dashed(entry.role),
                                false,
                                false});
    } else {
      draw_cell_ground(pen, "legend " + id, entry.role, swatch);
      if (how == Seen::as_cell) draw_cell_outline(pen, "legend " + id, entry.role, swatch);
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

Box around(const Box& a, const Box& b) {
  if (a.width <= 0) return b;
  if (b.width <= 0) return a;
  const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

/// What the slots fill in every step, with a small margin, in whole pixels so that lines stay as sharp.
Box crop_box(const Places& at, const Box& drawing, const Look& look, double s) {
  Box all = drawing;
  for (const Box& slot : {at.listing, at.table, at.sentence}) all = around(all, scaled(slot, s));
  // Title and footer reach to the sheet's edge: only their letters count
  Box letters = at.title;
  letters.y += at.heading.first_baseline - title_size;
  letters.height = at.title.bottom() - letters.y;
  if (at.title.width > 0) all = around(all, scaled(letters, s));
  letters = at.footer;
  letters.height -= 12;
  if (at.footer.width > 0) all = around(all, scaled(letters, s));
  const double margin = 16 * s;
  const double x = std::max(0.0, std::floor(all.x - margin)), y = std::max(0.0, std::floor(all.y - margin));
  return {x, y, std::min(look.width, std::ceil(all.right() + margin)) - x,
          std::min(look.height, std::ceil(all.bottom() + margin)) - y};
}

}  // namespace

namespace layout {

Window visible_cells(const Figure& figure, const Look& look) {
  const Stage stage = stage_of(*figure.trace, look);
  const Places at = places_of(*figure.trace, look, stage);
  const double s = unit_of(look);
  return scene_of(figure, look, stage, scaled(at.drawing, s), s).frame.view;
}

}  // namespace layout

Sheet lay_out(const Figure& figure, const Look& look) {
  const double s = unit_of(look);
  const Stage stage = stage_of(*figure.trace, look);
  const Places at = places_of(*figure.trace, look, stage);
  Sheet sheet{look.width, look.height, {}, s};
  Scene scene;
  // A slot that was given a place gets its shapes, in this order
  const auto lay_out_slot = [&](Slot slot, const Box& box, auto draw) {
    if (box.width <= 0) return;
    Pen pen(sheet, slot, s);
    draw(pen, scaled(box, s));
  };
  lay_out_slot(Slot::drawing, at.drawing, [&](Pen& pen, const Box& box) {
    scene = scene_of(figure, look, stage, box, s);
    lay_out_drawing(pen, figure, scene);
  });
  lay_out_slot(Slot::title, at.title, [&](Pen& pen, const Box& box) { lay_out_title(pen, at.heading, box); });
  lay_out_slot(Slot::listing, at.listing,
               [&](Pen& pen, const Box& box) { lay_out_listing(pen, figure, box, at.lines); });
  lay_out_slot(Slot::table, at.table,
               [&](Pen& pen, const Box& box) { lay_out_table(pen, figure, box, at.rows); });
  lay_out_slot(Slot::sentence, at.sentence,
               [&](Pen& pen, const Box& box) { lay_out_sentence(pen, figure, box, at.sentence_lines); });
  lay_out_slot(Slot::footer, at.footer, [&](Pen& pen, const Box& box) {
    lay_out_footer(pen, figure, box, scene.frame.view, at.footer_lines);
  });
  if (look.crop) return cropped(std::move(sheet), crop_box(at, scene.settled, look, s));
  return sheet;
}

}  // namespace gradus
