// The table slot: the rows of decisions so far, the last ones that fit.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double side_padding = 6;  ///< left and right of all columns
/// Between the texts of two columns; tight beside a listing whose lines would be broken else.
constexpr double easy_gap = 22, least_gap = 9, closest_gap = 5;
constexpr std::size_t fewest_columns = 3;

/// The width of a column's widest text.
double text_room(const Trace& trace, std::size_t column) {
  const Column& c = trace.columns[column];
  const double heading = text_width(c.name, Face::bold, text_size);
  const Face face = c.numeric ? Face::mono_bold : Face::bold;
  return std::max(heading, text_width(trace.widest[column], face, text_size));
}

double width_of(const Trace& trace, const std::vector<std::size_t>& columns, double gap) {
  double sum = 2 * side_padding;
  for (const std::size_t c : columns) sum += text_room(trace, c) + gap;
  return sum;
}

double least_gap_of(Spacing spacing) { return spacing == Spacing::tight ? closest_gap : least_gap; }

std::vector<std::size_t> all_columns(const Trace& trace) {
  std::vector<std::size_t> columns(trace.columns.size());
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  return columns;
}

/// Leaves out the column whose texts change least; the first one names the row and stays.
void leave_one_out(const Trace& trace, std::vector<std::size_t>& columns) {
  const auto changes = [&trace](std::size_t c) { return c < trace.changes.size() ? trace.changes[c] : 0; };
  columns.erase(std::ranges::min_element(columns.begin() + 1, columns.end(), {}, changes));
}

/// Left edge and width of each column: as wide as its widest text asks for, the rest shared evenly.
std::vector<std::pair<double, double>> column_places(const Trace& trace, const Box& box, double s,
                                                     const std::vector<std::size_t>& columns) {
  const double sum = width_of(trace, columns, 0) * s;
  const double gap = (box.width - sum) / static_cast<double>(columns.size());
  std::vector<std::pair<double, double>> places;
  double x = box.x + side_padding * s;
  for (const std::size_t c : columns) {
    const double given = text_room(trace, c) * s + gap;
    places.emplace_back(x, given);
    x += given;
  }
  return places;
}

class TableLayout {
 public:
  TableLayout(Pen& pen, const Figure& figure, const Box& box, Spacing spacing)
      : pen_(pen),
        figure_(figure),
        trace_(*figure.trace),
        s_(pen.scale()),
        box_(box),
        columns_(table_columns(trace_, box.width / s_, spacing)),
        places_(column_places(trace_, box, s_, columns_)) {}

  void draw(int room) {
    draw_heading();
    // The last rows that fit; a row of dots stands for those before them
    const std::size_t fitting = static_cast<std::size_t>(std::max(room, 1));
    const bool cut = figure_.rows.size() > fitting;
    const std::size_t shown = cut ? fitting - 1 : figure_.rows.size();
    double y = box_.y + heading_height * s_;
    int index = 0;
    if (cut) {
      pen_.text("rows left out", {{places_[0].first + places_[0].second / 2, y + 24 * s_},
                                  "⋮",
                                  Face::sans,
                                  text_size * s_,
                                  Align::centre,
                                  Paint::of(Tone::muted)});
      y += row_height * s_;
      ++index;
    }
    for (std::size_t i = figure_.rows.size() - shown; i < figure_.rows.size(); ++i, ++index) {
      if (index > 0) {
        pen_.line(fmt::format("rule {}", index),
                  {{{box_.x, y}, {box_.right(), y}}, Paint::of(Tone::rule), 1.5 * s_, false, false, false});
      }
      draw_row(figure_.rows[i], {box_.x, y, box_.width, row_height * s_}, index);
      y += row_height * s_;
    }
    const Box frame{box_.x, box_.y, box_.width, std::max(y - box_.y, heading_height * s_)};
    pen_.rect("frame", {frame, {}, Paint::of(Tone::rule), 1.5 * s_, 0, false, Hatch::none, {}});
  }

 private:
  void draw_heading() {
    pen_.rect("heading ground", {{box_.x, box_.y, box_.width, heading_height * s_},
                                 Paint::of(Tone::header),
                                 {},
                                 0,
                                 0,
                                 false,
                                 Hatch::none,
                                 {}});
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Column& column = trace_.columns[columns_[i]];
      pen_.text("heading " + column.id, {{places_[i].first + places_[i].second / 2, box_.y + 26 * s_},
                                         column.name,
                                         Face::bold,
                                         text_size * s_,
                                         Align::centre,
                                         Paint::of(Tone::ink),
                                         false,
                                         Paint::of(Tone::header)});
    }
  }

  void draw_row(const Figure::TableRow& row, const Box& at, int index) {
    const bool strong = row.emphasis == Emphasis::strong;
    Paint ground = Paint::of(Tone::paper);
    if (row.emphasis != Emphasis::none) {
      ground = Paint::of(strong ? Tone::strong : Tone::weak);
      pen_.rect(fmt::format("row ground {}", index), {at, ground, {}, 0, 0, false, Hatch::none, {}});
    }
    if (strong) {
      pen_.rect("current row",
                {{at.x, at.y, 6 * s_, at.height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i] < row.cells.size() && !row.cells[columns_[i]].empty())
        draw_cell(row, columns_[i], places_[i], at, index, ground);
    }
  }

  void draw_cell(const Figure::TableRow& row, std::size_t c, const std::pair<double, double>& place,
                 const Box& at, int index, Paint ground) {
    const Column& column = trace_.columns[c];
    const bool changed = c < row.changed.size() && row.changed[c];
    const Face face =
        column.numeric ? (changed ? Face::mono_bold : Face::mono) : (changed ? Face::bold : Face::sans);
    const double size = text_size * s_, baseline = at.y + 24 * s_, centre = place.first + place.second / 2;
    // Texts of steps that are not recorded may be longer
    const std::string text = elided(row.cells[c], face, size, place.second - 2 * s_);
    pen_.text(fmt::format("cell {} {}", index, column.id),
              {{centre, baseline}, text, face, size, Align::centre, Paint::of(Tone::ink), false, ground});
    if (!changed) return;
    const double half = text_width(text, face, size) / 2 + 2 * s_;
    pen_.line(fmt::format("changed {}", column.id),
              {{{centre - half, at.bottom() - 3 * s_}, {centre + half, at.bottom() - 3 * s_}},
               Paint::of(Tone::accent),
               2.5 * s_,
               false,
               false,
               false});
  }

  Pen& pen_;
  const Figure& figure_;
  const Trace& trace_;
  double s_;
  const Box& box_;
  std::vector<std::size_t> columns_;
  std::vector<std::pair<double, double>> places_;
};

}  // namespace

std::size_t spare_columns(const Trace& trace) {
  return trace.columns.size() - std::min(trace.columns.size(), fewest_columns);
}

double table_width(const Trace& trace) { return width_of(trace, all_columns(trace), easy_gap); }

double least_table_width(const Trace& trace, std::size_t left_out, Spacing spacing) {
  std::vector<std::size_t> columns = all_columns(trace);
  for (std::size_t i = 0; i < std::min(left_out, spare_columns(trace)); ++i) leave_one_out(trace, columns);
  return width_of(trace, columns, least_gap_of(spacing));
}

std::vector<std::size_t> table_columns(const Trace& trace, double width, Spacing spacing) {
  std::vector<std::size_t> columns = all_columns(trace);
  while (columns.size() > 1 && width_of(trace, columns, least_gap_of(spacing)) > width + 1e-6)
    leave_one_out(trace, columns);
  return columns;
}

void lay_out_table(Pen& pen, const Figure& figure, const Box& box, int rows, Spacing spacing) {
  TableLayout(pen, figure, box, spacing).draw(rows);
}

}  // namespace gradus::layout
