// Where the slots go: one of a few arrangements, by the shape of the sheet and of the grid.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract.hpp"
#include "figure/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double wide = 1200;            ///< units: from here on a slide has room to spare
constexpr double column_width = 604;     ///< of listing and table: 44 characters and the line numbers
constexpr double comfortable_cell = 48;  ///< larger cells are given up for more lines and rows
constexpr double large_cell = 60;        ///< larger ones are no reason to choose an arrangement
constexpr double worthwhile = 1.25;      ///< so much larger must the cells be for a less usual arrangement
constexpr double least_drawing = 200, least_column = 420;
constexpr int most_rows = 40;
constexpr double rounding = 1e-6;  ///< units: so much more than needed, that a sum may be rounded down

// --- What the slots ask for ----------------------------------------------------------------------

struct Wants {
  bool drawing = false, listing = false, table = false;
  double listing_width = 0, table_width = 0;
  int lines = 0, rows = 0;  ///< all there are
  std::size_t columns = 0;
  double whole_grid = 0;  ///< width of a drawing that shows all columns in cells just large enough
  double gutter = 20, column_gap = 24;
};

/// The widest line of the listing without trailing comments, which may be dropped.
double listing_width(const Trace& trace) {
  std::size_t most = 0;
  for (const SourceLine& line : trace.listing) {
    const std::size_t comment = line.text.find("//");
    const bool trails = comment != std::string::npos && line.text.find_first_not_of(' ') < comment;
    const std::string_view shown(line.text.data(), trails ? comment : line.text.size());
    most = std::max(most, code_points(shown.substr(0, shown.find_last_not_of(' ') + 1)).size());
  }
  return listing_indent + 6 + static_cast<double>(most) * text_width("0", Face::mono, text_size);
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

Wants wants_of(const Trace& trace, const Look& look, const Stage& stage, double margin) {
  Wants wants;
  wants.drawing = look.slots.contains(Slot::drawing);
  wants.listing = look.slots.contains(Slot::listing) && !trace.listing.empty();
  wants.table = look.slots.contains(Slot::table) && !trace.columns.empty();
  if (wants.listing) wants.listing_width = listing_width(trace);
  if (wants.table) wants.table_width = sum(column_widths(trace)) + 12;
  wants.lines = static_cast<int>(trace.listing.size());
  wants.rows = static_cast<int>(std::clamp<std::int64_t>(trace.last + 1, 2, most_rows));
  wants.columns = trace.columns.size();
  wants.whole_grid =
      stage.left + stage.right + stage.least_cell * static_cast<double>(stage.cells.width()) + rounding;
  wants.gutter = margin / 2;
  wants.column_gap = margin * 0.6;
  return wants;
}

// --- Arrangements --------------------------------------------------------------------------------

/// The three slots in the middle.
struct Body {
  Box drawing, listing, table;
  int lines = 0, rows = 0;
};

/// The fewest lines and rows that the text slots are content with.
struct Least {
  int lines, rows;
};

double height_of_lines(int lines) { return lines * line_height + 2 * panel_padding; }
double height_of_rows(int rows) { return heading_height + rows * row_height; }
// How many fit; what was made just high enough for them is, whatever a sum was rounded to
int lines_in(double height) {
  return static_cast<int>((height - 2 * panel_padding + rounding) / line_height);
}
int rows_in(double height) { return static_cast<int>((height - heading_height + rounding) / row_height); }

void put_listing(Body& body, Box box, int most) {
  body.lines = std::min(lines_in(box.height), most);
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
    const int rows = std::min(least.rows, wants.rows);
    const double below = wants.table ? height_of_rows(rows) + wants.gutter : 0;
    put_listing(body, {box.x, top, box.width, box.height - below}, wants.lines);
    top = body.listing.bottom() + wants.gutter;
  }
  if (wants.table) put_table(body, {box.x, top, box.width, box.bottom() - top}, wants.rows);
}

/// Listing and table side by side, as wide as they ask for and what is left shared; or the only one of them.
void put_row(Body& body, const Box& box, const Wants& wants) {
  Box left = box, right = box;
  if (wants.listing && wants.table) {
    const double spare = box.width - wants.gutter - wants.listing_width - wants.table_width;
    left.width = wants.listing_width + spare / 2;
    right.x = left.right() + wants.gutter;
    right.width = box.right() - right.x;
  }
  if (wants.listing) put_listing(body, left, wants.lines);
  if (wants.table) put_table(body, right, wants.rows);
}

bool fit_side_by_side(const Box& area, const Wants& wants) {
  return area.width >= wants.listing_width + wants.gutter + wants.table_width;
}

/// What the table can do with.
double least_table_width(const Wants& wants) {
  return wants.table_width - squeezable * static_cast<double>(wants.columns);
}

/// The drawing on the left, listing and table in a column of this width on the right.
std::optional<Body> with_column(const Box& area, const Wants& wants, Least least, double width) {
  Body body;
  body.drawing = {area.x, area.y, area.width - width - wants.column_gap, area.height};
  put_column(body, {area.right() - width, area.y, width, area.height}, wants, least);
  const bool least_given = (!wants.listing || body.lines >= std::min(least.lines, wants.lines)) &&
                           (!wants.table || body.rows >= std::min(least.rows, wants.rows));
  return body.drawing.width >= least_drawing && least_given ? std::optional(body) : std::nullopt;
}

/// The usual one: the column is as wide as listing and table ask for.
std::optional<Body> column(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing && !wants.table) return std::nullopt;
  if (wants.listing && area.width >= wide) return with_column(area, wants, least, column_width);
  const double asked = wants.listing ? std::max(wants.listing_width, least_table_width(wants))
                                     : std::max(wants.table_width + 60, 320.0);
  return with_column(area, wants, least, std::min(asked, column_width));
}

/// For grids that nothing else shows whole: the column gets what they leave, longer lines are shortened.
std::optional<Body> narrow_column(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing) return std::nullopt;
  const double most = area.width - wants.column_gap - std::max(least_column, least_table_width(wants));
  if (most < least_drawing) return std::nullopt;
  const double drawing =
      wants.whole_grid <= most + 2 * rounding ? std::max(wants.whole_grid, least_drawing) : least_drawing;
  const double width = area.width - wants.column_gap - drawing;
  return with_column(area, wants, least, std::min(width, wants.listing_width));
}

/// Drawing and table side by side, the listing over the full width below.
std::optional<Body> shelf(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  Body body;
  const double below = height_of_lines(std::min(least.lines, wants.lines));
  const double height = area.height - below - wants.gutter;
  const double width = std::min(wants.table_width - 4 * static_cast<double>(wants.columns),
                                area.width - wants.column_gap - std::max(280.0, area.width * 0.4));
  if (width < least_table_width(wants) || rows_in(height) < std::min(least.rows, wants.rows))
    return std::nullopt;
  body.drawing = {area.x, area.y, area.width - width - wants.column_gap, height};
  put_table(body, {area.right() - width, area.y, width, height}, wants.rows);
  put_listing(body, {area.x, area.bottom() - below, area.width, below}, wants.lines);
  return body;
}

/// The drawing over the full width, what there is of listing and table side by side below.
std::optional<Body> ledge(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing && !wants.table) return std::nullopt;
  if (wants.listing && wants.table && !fit_side_by_side(area, wants)) return std::nullopt;
  double below = 0;
  if (wants.listing) below = height_of_lines(std::min(least.lines, wants.lines));
  if (wants.table) below = std::max(below, height_of_rows(std::min(least.rows, wants.rows)));
  Body body;
  body.drawing = {area.x, area.y, area.width, area.height - below - wants.gutter};
  put_row(body, {area.x, area.bottom() - below, area.width, below}, wants);
  return body;
}

/// Drawing, listing and table below one another.
std::optional<Body> stack(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  const double below = height_of_lines(std::min(least.lines, wants.lines)) + wants.gutter +
                       height_of_rows(std::min(least.rows, wants.rows));
  Body body;
  body.drawing = {area.x, area.y, area.width, area.height - below - wants.gutter};
  put_column(body, {area.x, area.bottom() - below, area.width, below}, wants, least);
  return body;
}

/// All three side by side, for low and wide sheets.
std::optional<Body> abreast(const Box& area, const Wants& wants, Least least) {
  if (!wants.listing || !wants.table) return std::nullopt;
  const double table = wants.table_width + 24;
  const double drawing = area.width - wants.listing_width - table - 2 * wants.column_gap;
  if (drawing < least_drawing || lines_in(area.height) < std::min(least.lines, wants.lines) ||
      rows_in(area.height) < std::min(least.rows, wants.rows)) {
    return std::nullopt;
  }
  Body body;
  body.drawing = {area.x, area.y, drawing, area.height};
  const double x = body.drawing.right() + wants.column_gap;
  put_listing(body, {x, area.y, wants.listing_width, area.height}, wants.lines);
  put_table(body, {area.right() - table, area.y, table, area.height}, wants.rows);
  return body;
}

/// The drawing where there is no text beside it.
std::optional<Body> alone(const Box& area, const Wants& wants, Least) {
  if (wants.listing || wants.table) return std::nullopt;
  return Body{area, {}, {}, 0, 0};
}

using Arrange = std::optional<Body> (*)(const Box&, const Wants&, Least);
/// In order of preference.
constexpr std::array<Arrange, 7> arrangements{alone, column, shelf, ledge, stack, abreast, narrow_column};

/// The text slots alone.
Body without_drawing(const Box& area, const Wants& wants) {
  Body body;
  if (fit_side_by_side(area, wants)) {
    put_row(body, area, wants);
  } else {
    put_column(body, area, wants, {6, 4});
  }
  return body;
}

// --- The choice ----------------------------------------------------------------------------------

/// How well a drawing shows its grid: all of it before a part; larger cells, more of them in view.
struct Worth {
  bool whole = false;
  double size = 0;  ///< units of a cell of the whole; cells along a side of a part

  bool clearly_above(const Worth& other) const {
    if (whole != other.whole) return whole;
    const double most = whole ? large_cell : 1e9;
    return std::min(size, most) > worthwhile * std::min(other.size, most);
  }
  /// Whether a reader would not miss what the other shows more.
  bool as_good_as(const Worth& other) const {
    if (whole != other.whole) return false;
    return size >= (whole ? std::min(other.size, comfortable_cell) : 0.9 * other.size);
  }
  bool legible() const { return whole || size >= 6; }
  bool easily_legible(const Stage& stage) const { return whole ? size >= stage.easy_cell : size >= 6; }
};

Worth worth_of(const Fit& fit) {
  if (!fit.follows) return {true, fit.cell};
  const auto columns = static_cast<double>(fit.columns), rows = static_cast<double>(fit.rows);
  return {false, std::sqrt(std::min(columns, 2 * rows) * std::min(rows, 2 * columns))};
}

struct Choice {
  Body body;
  Worth worth;
};

std::optional<Choice> choice_of(Arrange arrange, const Box& area, const Wants& wants, Least least,
                                const Stage& stage) {
  const std::optional<Body> body = arrange(area, wants, least);
  if (!body) return std::nullopt;
  const std::optional<Fit> shown = fit(stage, body->drawing.width, body->drawing.height);
  return shown ? std::optional(Choice{*body, worth_of(*shown)}) : std::nullopt;
}

/// The arrangement whose drawing is the largest while listing and table have their least.
std::optional<Choice> best_with(const Box& area, const Wants& wants, Least least, const Stage& stage) {
  std::optional<Choice> best;
  Arrange chosen = nullptr;
  for (const Arrange arrange : arrangements) {
    if (arrange == narrow_column && best && best->worth.whole) continue;
    const auto choice = choice_of(arrange, area, wants, least, stage);
    if (!choice || (best && !choice->worth.clearly_above(best->worth))) continue;
    best = choice;
    chosen = arrange;
  }
  // Then as many lines and rows as do the drawing no harm; columns have them already
  for (int more = most_rows; best && chosen != column && chosen != narrow_column && more > 0; --more) {
    const auto choice = choice_of(chosen, area, wants, {least.lines + more, least.rows + more}, stage);
    if (choice && choice->worth.as_good_as(best->worth)) return choice;
  }
  return best;
}

constexpr std::array<Least, 4> content_with{Least{12, 4}, Least{6, 4}, Least{4, 3}, Least{3, 2}};
constexpr std::size_t on_a_slide = 1;  ///< the first that a slide tries; a handout has room for more text

/// With as much text as leaves a drawing that can be read.
std::optional<Choice> best_of(const Box& area, const Wants& wants, const Look& look, const Stage& stage) {
  std::optional<Choice> best;
  for (std::size_t i = look.layout == Layout::slide ? on_a_slide : 0; i < content_with.size(); ++i) {
    const auto choice = best_with(area, wants, content_with[i], stage);
    if (choice && (!best || choice->worth.clearly_above(best->worth))) best = choice;
    if (best && best->worth.easily_legible(stage)) return best;
  }
  return best;
}

/// In the small boxes of a handout's page the listing gives way, then the table.
bool may_give_way(const Look& look) { return look.layout == Layout::handout && look.least_text > 0; }

ivec2 largest_in(const Box& area, Wants wants, const Look& look, const Stage& stage) {
  if (may_give_way(look)) wants.listing = wants.table = false;
  wants.whole_grid = area.width - wants.column_gap - std::max(least_column, least_table_width(wants));
  ivec2 largest{0, 0};
  const auto cells = [](ivec2 size) { return std::int64_t{size.x} * size.y; };
  for (const Arrange arrange : arrangements) {
    const auto body = arrange(area, wants, content_with.back());
    if (!body) continue;
    const Fit room = capacity(stage, body->drawing.width, body->drawing.height);
    const ivec2 size{static_cast<int>(room.columns), static_cast<int>(room.rows)};
    if (cells(size) > cells(largest)) largest = size;
  }
  return largest;
}

Body body_of(const Box& area, Wants wants, const Look& look, const Stage& stage) {
  if (!wants.drawing) return without_drawing(area, wants);
  auto choice = best_of(area, wants, look, stage);
  for (bool* slot : {&wants.listing, &wants.table}) {
    if (!may_give_way(look) || (choice && choice->worth.legible())) break;
    *slot = false;
    choice = best_of(area, wants, look, stage);
  }
  if (choice) return choice->body;
  if (!stage.fixed) return without_drawing(area, wants);
  const ivec2 most = largest_in(area, wants, look, stage);
  contract_violated(fmt::format("expected at most {} x {} cells for this size, found {} x {}", most.x, most.y,
                                stage.cells.width(), stage.cells.height()));
}

// --- The bands above and below -------------------------------------------------------------------

/// The sheet in units, its margins and what the bands leave in the middle.
struct Page {
  double width, height, margin;
  Places at;
  Box middle;
};

/// Lines that the footer may take: a second one where a narrow sheet would cut the legend.
int footer_lines(const Trace& trace, double room) {
  double asked = 280;
  for (const LegendEntry& entry : trace.legend) asked += 60 + text_width(entry.text, Face::sans, text_size);
  return room < 1000 && asked > room ? 2 : 1;
}

/// Two lines, or as many as the longest sentence needs.
int lines_for_sentences(const Trace& trace, double room) {
  const int most = room < 800 ? 4 : 3;
  const auto lines = sentence_lines(trace.longest_sentence, sentence_size, room, most);
  return std::max(2, static_cast<int>(lines.size()));
}

Page page_of(const Trace& trace, const Look& look) {
  const auto has = [&look](Slot slot) { return look.slots.contains(slot); };
  const double unit = unit_of(look);
  Page page{look.width / unit, look.height / unit, 0, {}, {}};
  page.margin = std::clamp(page.width / 32, 22.0, 40.0);
  const double width = page.width - 2 * page.margin;
  double top = page.margin / 2, bottom = page.height - page.margin / 2;
  if (has(Slot::title)) {
    page.at.heading = heading_of(trace, look, width, page.height);
    top = page.at.heading.height;
    page.at.title = {page.margin, 0, width, top};
  }
  if (has(Slot::footer)) {
    page.at.footer_lines = footer_lines(trace, width);
    const double height = (width < 1000 ? 42 : 54) + (page.at.footer_lines - 1) * footer_line;
    bottom = page.height - height;
    page.at.footer = {page.margin, bottom, width, height};
  }
  if (has(Slot::sentence)) {
    page.at.sentence_lines = lines_for_sentences(trace, width - 40);
    const double height = 14 + page.at.sentence_lines * sentence_line;
    page.at.sentence = {page.margin, bottom - 4 - height, width, height};
    bottom -= height + (width < 1000 ? 10 : 16);
  }
  page.middle = {page.margin, top, width, bottom - top - 4};
  return page;
}

}  // namespace

double unit_of(const Look& look) {
  const double slide = std::min(look.width, look.height) / 720;
  return look.layout == Layout::slide ? slide : std::max(0.7 * slide, look.least_text / text_size);
}

Heading heading_of(const Trace& trace, const Look& look, double width, double height) {
  const std::string& title = look.title.empty() ? trace.title : look.title;
  const bool tight = width < 1000 || height < 720;
  const auto sans = [](const std::string& text, double size) { return text_width(text, Face::sans, size); };
  Heading heading;
  heading.title = lines_of(title, Face::bold, title_size, width, 2);
  const double title_width = text_width(heading.title.back(), Face::bold, title_size);
  const double with_input = title_width + 14 + sans(trace.subtitle, sentence_size);
  const double method_width = sans(trace.method_title, text_size);
  int below = 0;
  if (with_input > width) {
    heading.input_line = below = 1;
    const bool beside = sans(trace.subtitle, text_size) + 40 + method_width <= width;
    heading.method_line = below = beside ? 1 : 2;
  } else if (with_input + 40 + method_width > width) {
    heading.method_line = below = 1;
  }
  heading.input = elided(trace.subtitle, Face::sans, heading.input_line == 0 ? sentence_size : text_size,
                         heading.input_line == 0 ? width - title_width - 14 : width);
  heading.method = elided(trace.method_title, Face::sans, text_size, width);
  if (!trace.faulty.empty()) {
    heading.fault = lines_of(trace.wording.say("figure.faulty", fmt::arg("what", trace.faulty)), Face::bold,
                             text_size, width, 3);
  }
  heading.first_baseline = tight ? 40 : 52;
  const double last_baseline = heading.first_baseline + 40 * (static_cast<double>(heading.title.size()) - 1) +
                               28 * below + 26 * static_cast<double>(heading.fault.size());
  heading.height =
      std::max(last_baseline + (tight || below > 0 ? 12 : 6), heading.first_baseline + (tight ? 20 : 32));
  return heading;
}

Places places_of(const Trace& trace, const Look& look, const Stage& stage) {
  const Page page = page_of(trace, look);
  const Body body = body_of(page.middle, wants_of(trace, look, stage, page.margin), look, stage);
  Places at = page.at;
  at.drawing = body.drawing;
  at.listing = body.listing;
  at.table = body.table;
  at.lines = body.lines;
  at.rows = body.rows;
  return at;
}

std::vector<double> column_widths(const Trace& trace) {
  std::vector<double> widths;
  for (std::size_t c = 0; c < trace.columns.size(); ++c) {
    const double heading = text_width(trace.columns[c].name, Face::bold, text_size);
    widths.push_back(std::max(heading, text_width(trace.widest[c], Face::mono_bold, text_size)) + 20);
  }
  return widths;
}

std::vector<std::string> lines_of(const std::string& text, Face face, double size, double room, int most) {
  std::vector<std::string> lines = wrapped(text, face, size, room);
  const auto count = static_cast<std::size_t>(most);
  for (std::size_t i = count; i < lines.size(); ++i) lines[count - 1] += " " + lines[i];
  if (lines.size() > count) lines.resize(count);
  for (std::string& line : lines) line = elided(line, face, size, room);
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::vector<std::string> sentence_lines(const std::string& sentence, double size, double room, int most) {
  if (text_width(sentence, Face::sans, size) <= room) return {sentence};
  std::vector<std::string> plain = lines_of(sentence, Face::sans, size, room, most);
  const std::size_t at = sentence.find("; ");
  if (at == std::string::npos) return plain;
  std::vector<std::string> lines = lines_of(sentence.substr(0, at + 1), Face::sans, size, room, most);
  for (std::string& line : lines_of(sentence.substr(at + 2), Face::sans, size, room, most)) {
    lines.push_back(std::move(line));
  }
  return lines.size() <= plain.size() ? lines : plain;
}

}  // namespace gradus::layout

namespace gradus {

ivec2 largest_view(const Trace& trace, const Look& look) {
  const layout::Page page = layout::page_of(trace, look);
  const layout::Stage stage = layout::stage_of(trace, look);
  return layout::largest_in(page.middle, layout::wants_of(trace, look, stage, page.margin), look, stage);
}

}  // namespace gradus
