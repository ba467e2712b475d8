// The arrangements of drawing, listing and table.

#include <algorithm>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double least_drawing = 200;
constexpr double rounding = 1e-6;  ///< units: so much more than needed, that a sum may be rounded down
/// Of a listing beside a table, and beside one that gave columns up.
constexpr std::size_t fewest_characters = 30, fewest_beside_few_columns = 24;
constexpr int rows_beside_a_fault = 3;  ///< of the table: dots, before and after the step

double height_of_lines(int lines) { return lines * line_height + 2 * panel_padding; }
double height_of_rows(int rows) { return heading_height + rows * row_height; }
// How many fit; what was made just high enough for them is, whatever a sum was rounded to
int lines_in(double height) {
  return static_cast<int>((height - 2 * panel_padding + rounding) / line_height);
}
int rows_in(double height) { return static_cast<int>((height - heading_height + rounding) / row_height); }

/// The listing's rows in a slot of this width.
ListingRows::Count rows_asked(const Wants& wants, double width) {
  return wants.listing_rows->at(listing_columns(*wants.trace, *wants.look, width, wants.spacing));
}

/// Without these rows the listing is not shown: a loop's head stays above the line at hand.
int least_lines(const Wants& wants, double width, Least least) {
  const ListingRows::Count rows = rows_asked(wants, width);
  return std::min(rows.all, std::max(least.lines, rows.of_a_loop));
}

/// Without these rows the table is not shown: what a fault changes is worth more than older ones.
int least_rows(const Wants& wants, Least least) {
  const int rows = std::min(least.rows, wants.rows);
  return wants.trace->struck.empty() ? rows : std::min(rows, rows_beside_a_fault);
}

/// What the listing asks for: no line is broken.
double whole_listing(const Wants& wants) {
  return listing_width(*wants.trace, *wants.look, longest_line(*wants.trace));
}

void put_listing(Body& body, Box box, const Wants& wants) {
  body.spacing = wants.spacing;
  body.lines = std::min(lines_in(box.height), rows_asked(wants, box.width).all);
  box.height = height_of_lines(body.lines);
  body.listing = box;
}
void put_table(Body& body, Box box, int most) {
  body.rows = std::min(rows_in(box.height), most);
  box.height = height_of_rows(body.rows);
  body.table = box;
}

/// The listing above the table, which gets its least rows at least.
void put_column(Body& body, const Box& box, const Wants& wants, Least least) {
  double top = box.y;
  if (wants.listing) {
    const int rows = least_rows(wants, least);
    const double below = wants.table ? height_of_rows(rows) + wants.gutter : 0;
    put_listing(body, {box.x, top, box.width, box.height - below}, wants);
    top = body.listing.bottom() + wants.gutter;
  }
  if (wants.table) put_table(body, {box.x, top, box.width, box.bottom() - top}, wants.rows);
}

/// How wide the listing is beside the table: what it asks for where there is room, else what is left; less
/// than nothing where that is too little.
double listing_beside_table(const Box& box, const Wants& wants) {
  if (wants.characters > 0) {
    const double listing = listing_width(*wants.trace, *wants.look, wants.characters, wants.spacing);
    const double table = least_table_width(*wants.trace, wants.columns_to_spare, wants.spacing);
    return listing + wants.row_gutter + table <= box.width + rounding ? listing : -1;
  }
  const double asked = whole_listing(wants);
  const double spare = box.width - wants.row_gutter - asked - table_width(*wants.trace);
  if (spare >= 0) return asked + spare / 2;
  const double left = box.width - wants.row_gutter - least_table_width(*wants.trace, wants.columns_to_spare);
  const std::size_t fewest = wants.columns_to_spare > 0 ? fewest_beside_few_columns : fewest_characters;
  const double least = listing_width(*wants.trace, *wants.look, std::min(fewest, longest_line(*wants.trace)));
  return left >= least ? std::min(left, asked) : -1;
}

/// Listing and table side by side, or the only one of them.
void put_row(Body& body, const Box& box, const Wants& wants) {
  Box left = box, right = box;
  if (wants.listing && wants.table) {
    left.width = listing_beside_table(box, wants);
    right.x = left.right() + wants.row_gutter;
    right.width = box.right() - right.x;
  }
  if (wants.listing) put_listing(body, left, wants);
  if (wants.table) put_table(body, right, wants.rows);
}

/// Whether the text slots got what they are content with.
bool content(const Body& body, const Wants& wants, Least least) {
  if (body.drawing.width < least_drawing || body.drawing.height <= 0) return false;
  const bool lines = !wants.listing || body.lines >= least_lines(wants, body.listing.width, least);
  return lines && (!wants.table || body.rows >= least_rows(wants, least));
}

std::optional<Body> if_content(const Body& body, const Wants& wants, Least least) {
  return content(body, wants, least) ? std::optional(body) : std::nullopt;
}

}  // namespace

std::optional<Body> alone(const Box& area, const Wants& wants, Least) {
  if (wants.listing || wants.table) return std::nullopt;
  return Body{area, {}, {}, 0, 0};
}

std::optional<Body> beside(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing && !wants.table) return std::nullopt;
  Body body;
  const double width = wants.column_width;
  body.drawing = {area.x - wants.overhang, area.y, area.width - width - wants.column_gap + wants.overhang,
                  area.height};
  put_column(body, {area.right() - width, area.y, width, area.height}, wants, least);
  return if_content(body, wants, least);
}

std::optional<Body> shelf(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  Body body;
  const double below = height_of_lines(least_lines(wants, area.width, least));
  const double height = area.height - below - wants.gutter;
  const double width = std::min((table_width(*wants.trace) + least_table_width(*wants.trace, 0)) / 2,
                                area.width - wants.column_gap - std::max(280.0, area.width * 0.45));
  if (width < least_table_width(*wants.trace, spare_columns(*wants.trace))) return std::nullopt;
  body.drawing = {area.x, area.y, area.width - width - wants.column_gap, height};
  put_table(body, {area.right() - width, area.y, width, height}, wants.rows);
  put_listing(body, {area.x, area.bottom() - below, area.width, below}, wants);
  return if_content(body, wants, least);
}

std::optional<Body> ledge(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing && !wants.table) return std::nullopt;
  double below = 0, listing = area.width;
  if (wants.listing && wants.table) listing = listing_beside_table(area, wants);
  if (listing < 0) return std::nullopt;
  if (wants.listing) below = height_of_lines(least_lines(wants, listing, least));
  if (wants.table) below = std::max(below, height_of_rows(std::min(least.rows, wants.rows)));
  Body body;
  body.drawing = {area.x, area.y, area.width, area.height - below - wants.gutter};
  put_row(body, {area.x, area.bottom() - below, area.width, below}, wants);
  return if_content(body, wants, least);
}

std::optional<Body> stack(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  const double below = height_of_lines(least_lines(wants, area.width, least)) + wants.gutter +
                       height_of_rows(std::min(least.rows, wants.rows));
  Body body;
  body.drawing = {area.x, area.y, area.width, area.height - below - wants.gutter};
  put_column(body, {area.x, area.bottom() - below, area.width, below}, wants, least);
  return if_content(body, wants, least);
}

std::optional<Body> abreast(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  const double table = table_width(*wants.trace), listing = whole_listing(wants);
  Body body;
  body.drawing = {area.x, area.y, area.width - listing - table - 2 * wants.column_gap, area.height};
  if (body.drawing.width < least_drawing) return std::nullopt;
  const double x = body.drawing.right() + wants.column_gap;
  put_listing(body, {x, area.y, listing, area.height}, wants);
  put_table(body, {area.right() - table, area.y, table, area.height}, wants.rows);
  return if_content(body, wants, least);
}

Body without_drawing(const Box& area, const Wants& wants) {
  Body body;
  const bool both = wants.listing && wants.table;
  if (!both || listing_beside_table(area, wants) >= 0) {
    put_row(body, area, wants);
  } else {
    put_column(body, area, wants, {6, 4});
  }
  return body;
}

}  // namespace gradus::layout
