#pragma once
// The parts of laying out a figure that its files share.
//
// Sizes are in units: a slide's shorter side is 720 of them, at any size; on a handout they are
// smaller.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figure/figure.hpp"
#include "figure/layout/boxes.hpp"
#include "figure/sheet.hpp"
#include "figure/text/metrics.hpp"

namespace gradus::layout {

inline constexpr double text_size = 20;      ///< 1/36 of a slide's shorter side: nothing is smaller
inline constexpr double sentence_size = 26;  ///< 1/28 and a little
inline constexpr double title_size = 34;
inline constexpr double least_cell = 24;  ///< on a slide a cell is never smaller
inline constexpr double line_height = 30, row_height = 34, heading_height = 38, panel_padding = 8;
inline constexpr double paragraph_line = 26;  ///< from a text of a drawing to the one below it
inline constexpr double sentence_line = 33, footer_line = 28;

/// Pixels for one unit.
double unit_of(const Look& look);

/// Collects shapes of one slot; knows the scale.
class Pen {
 public:
  Pen(Sheet& sheet, Slot slot, double scale) : sheet_(sheet), slot_(slot), scale_(scale) {}

  void rect(std::string id, RectShape shape) { add(std::move(id), std::move(shape)); }
  void area(std::string id, AreaShape shape) { add(std::move(id), std::move(shape)); }
  void line(std::string id, LineShape shape) { add(std::move(id), std::move(shape)); }
  void strokes(std::string id, StrokesShape shape) { add(std::move(id), std::move(shape)); }
  void disc(std::string id, DiscShape shape) { add(std::move(id), std::move(shape)); }
  void text(std::string id, TextShape shape) { add(std::move(id), std::move(shape)); }
  void image(std::string id, ImageShape shape) { add(std::move(id), std::move(shape)); }
  double scale() const { return scale_; }

 private:
  template <class S>
  void add(std::string id, S shape) {
    sheet_.shapes.push_back({slot_, std::move(id), std::move(shape)});
  }

  Sheet& sheet_;
  Slot slot_;
  double scale_;
};

// --- Marks ---------------------------------------------------------------------------------------

/// Of a line of this role, in units.
double line_width(Role role);
/// Whether lines of this role are dashed.
constexpr bool is_dashed(Role role) { return role == Role::candidate || role == Role::rejected; }

/// What a chain of points looks like beside its role.
struct ChainLook {
  bool closed = false, arrow = false, dashed = false;
  bool thin = false;  ///< of thin_width
};
/// A line of this role through pixels.
LineShape line_through(std::vector<dvec2> points, Role role, const ChainLook& look, double scale);
/// What a mark's dot and its text are painted with: its quantity's colour, else its role's.
Paint mark_paint(const Trace& trace, const Mark& mark);
Paint text_paint(const Trace& trace, const Mark& mark);
/// A round marker at a pixel, as its paint's role has it.
DiscShape disc_at(dvec2 at, Paint paint, bool ring, double scale);
/// Of a thin line in any role, in units.
inline constexpr double thin_width = 1.6;
/// The inside of rings of pixels; shade: of an Area.
AreaShape area_in(std::vector<std::vector<dvec2>> rings, Role role, int shade = 0);

/// A cell's look, `box` being the cell. The outline comes apart, since it is drawn over the grid lines.
void draw_cell_ground(Pen& pen, const std::string& id, Role role, const Box& box);
/// `most`: its width as a share of the cell's height.
void draw_cell_outline(Pen& pen, const std::string& id, Role role, const Box& box, double most = 0.2);

/// The mark that stands for a role in the legend.
struct LegendMark {
  Sample sample = Sample::line;
  bool dashed = false;
  bool outlined = false;      ///< an area whose rim is drawn, too
  int shade = 0;              ///< of an area
  bool thin = false;          ///< a line as thin as a guide
  std::vector<Paint> dots{};  ///< of dots and rings: each look there is
  std::optional<Rgba8> color{};
  friend bool operator==(const LegendMark&, const LegendMark&) = default;
};
/// How the drawing shows the role; nothing where it does not.
std::optional<LegendMark> legend_mark(const Figure& figure, const Window& view, const LegendEntry& entry);
/// The entries that a drawing shows.
using ShownLegend = std::vector<std::pair<LegendEntry, LegendMark>>;
ShownLegend shown_legend(const Figure& figure, const Window& view);
void draw_legend_mark(Pen& pen, const std::string& id, Role role, const LegendMark& mark, const Box& box);

// --- The drawing ---------------------------------------------------------------------------------

/// What there is to show of the grid.
struct Stage {
  Window cells;        ///< the grid's, or the reader's view of them
  Window own;          ///< those of them that a view follows the step in: all but a shelf's
  bool fixed = false;  ///< the reader chose the cells: all of them are shown, or none
  bool y_up = true;
  dvec2 lower{0}, size{0};                  ///< what is shown: the cells, or of a paper what is drawn on it
  dvec2 core{0};                            ///< how much of it the marks fill
  const Grid* axes = nullptr;               ///< whose numbers and names stand beside the cells; or nullptr
  double numbers = 0;                       ///< width of the widest number beside the rows
  double column_numbers = 0;                ///< and of that below the columns
  const Content* content = nullptr;         ///< of a paper: what else needs room beside it
  double least_cell = 0, largest_cell = 0;  ///< units
  double easy_cell = 0;                     ///< from here on no text is given up for larger cells
  double lines = 0;              ///< as Grid::lines: with smaller cells what is aside would lie on itself
  bool bare = false;             ///< without what is aside
  std::optional<Window> part{};  ///< cells that are shown with the whole beside them
};
/// Throws ContractViolation when the look's view misses the grid.
Stage stage_of(const Trace& trace, const Look& look);
/// The same without what is aside. `content`: what there was, kept for as long as the stage is used.
Stage bare(Stage stage, Content& content);

/// Units beside what is shown, for axes and texts.
struct Margins {
  double left = 0, right = 0, above = 0, below = 0;
};

/// How a drawing of some size shows its stage.
struct Fit {
  double cell = 0;  ///< units
  std::int64_t columns = 0, rows = 0;
  bool follows = false;  ///< not all cells: a view that follows the step, and an overview
  bool beside = false;   ///< the overview stands beside the view, not above it
  Margins margins{};
  bool part = false;  ///< the stage's, which doesn't move
};
/// Nothing: the drawing is too small for any cell, or for the cells that the reader chose. Sizes in units.
std::optional<Fit> fit(const Stage& stage, double width, double height);
/// Columns and rows of least cells that a drawing of this size could show.
Fit capacity(const Stage& stage, double width, double height);

/// From the grid's coordinates to pixels: cell (x, y) is the square round the point (x, y).
struct Frame {
  Window view;      ///< the cells that may be seen
  dvec2 origin{0};  ///< the grid's coordinates of the box's left border and of its lower row's
  Box box;          ///< of the visible part
  double cell = 0;
  bool y_up = true;

  double column(double x) const { return box.x + (x - origin.x) * cell; }
  double row(double y) const {
    const double from_lower = (y - origin.y) * cell;
    return y_up ? box.bottom() - from_lower : box.y + from_lower;
  }
  dvec2 point(dvec2 p) const { return {column(p.x), row(p.y)}; }
  /// The inverse of `point`.
  dvec2 place(dvec2 pixel) const {
    const double up = (y_up ? box.bottom() - pixel.y : pixel.y - box.y) / cell;
    return {origin.x + (pixel.x - box.x) / cell, origin.y + up};
  }
  Box square(ivec2 p) const {
    const dvec2 centre = point({p.x, p.y});
    return {centre.x - cell / 2, centre.y - cell / 2, cell, cell};
  }
};
/// The whole pixels of a picture that lie in the frame.
ImageShape image_in(const Frame& frame, const Picture& picture);

/// Where the parts of the drawing lie, in pixels: over all steps only the cells in view may change.
struct Scene {
  Frame frame;
  double left = 0, right = 0;            ///< where the axes' numbers and names may begin, and end
  bool follows = false, beside = false;  ///< as in Fit
  Box inset;                             ///< of the overview, where there is one
  Box settled;                           ///< what the drawing fills in every step: cells, axes, overview
  Box labels;                            ///< where labels may stand
  bool bare = false;                     ///< without what is aside
  bool numbered = true;                  ///< with numbers and names beside its cells
  bool among_many = false;    ///< one of many drawings: names have no leaders but what the step points at
  std::optional<dvec2> ring;  ///< of the grid: what is pointed at

  /// The cells in view that are the grid's own: those of a shelf are not.
  Window own_cells(const Grid& grid) const { return intersection(frame.view, grid.own()); }
};
Scene scene_of(const Figure& figure, const Look& look, const Stage& stage, const Box& box, double scale);

void lay_out_drawing(Pen& pen, const Figure& figure, const Scene& scene);
/// The whole grid, small, with the part that the view shows. Returns where its texts stand.
std::vector<Box> draw_overview(Pen& pen, const Figure& figure, const Scene& scene);

/// What a label should keep from, in pixels.
struct Obstacles {
  std::vector<Box> texts;                       ///< placed so far: nothing may overlap them
  std::vector<Box> ticks;                       ///< the axes' numbers and some space round them
  std::vector<Box> taken;                       ///< cells and dots that a label must not cover
  std::vector<std::pair<Box, double>> crowded;  ///< cells and pictures that it should not, how much
  std::vector<Segment<2, double>> strokes;
  std::vector<Segment<2, double>> leaders;  ///< drawn so far: nothing may cross them
};
/// From here on, in units, the name of the rows may stand among their numbers.
inline constexpr double high_cell = 64;
/// Between it and the numbers where it stands aside, and above the upper number then.
inline constexpr double name_gap = 8;
/// The numbers and names beside the cells, which are taken then.
void lay_out_axes(Pen& pen, const Grid& grid, const Scene& scene, Obstacles& taken);
/// A label's place, and the line from it to its point where it does not stand beside it.
struct PlacedLabel {
  Box box;
  std::optional<Segment<2, double>> leader;
};
/// Tries places round the anchor, near ones first. `gap`: the nearest, `clear`: how far from lines.
std::optional<PlacedLabel> place_label(const Obstacles& obstacles, const Box& room, dvec2 anchor, dvec2 size,
                                       double gap, double clear, double scale);

/// The largest ring round a point, at most of this radius, that leaves the texts placed so far free; 0: none.
double ring_radius(const Obstacles& obstacles, dvec2 at, double most, double scale);

// --- Listing and table ---------------------------------------------------------------------------

/// How close to each other a listing's numbers, its code and its border come, and the columns of a table.
enum class Spacing : std::uint8_t { usual, tight };

/// Characters that fit in a line of a listing of this width, and the width that so many need.
std::size_t listing_columns(const Trace& trace, const Look& look, double width,
                            Spacing spacing = Spacing::usual);
double listing_width(const Trace& trace, const Look& look, std::size_t columns,
                     Spacing spacing = Spacing::usual);
/// Of the longest line without its trailing comment.
std::size_t longest_line(const Trace& trace);
/// A line as rows of at most so many characters: without its trailing comment where that is enough, else
/// broken after a comma or an opening parenthesis or before an operator.
std::vector<std::string> source_rows(const std::string& line, std::size_t columns);
/// How many rows the listing has, by the characters that fit in one: counted once for each width, since a
/// choice among arrangements asks for a few widths again and again.
class ListingRows {
 public:
  struct Count {
    int all = 0;
    int of_a_loop = 0;  ///< so many show any line that reports steps, and above it the head of its loop
  };
  explicit ListingRows(const Trace& trace) : trace_(&trace), lines_(shown_listing(trace)) {}
  Count at(std::size_t columns);
  /// Whether some step shows a line that is broken, where so many rows are shown.
  bool break_a_shown_line(std::size_t columns, int rows);

 private:
  const Trace* trace_;
  std::vector<SourceLine> lines_;
  std::map<std::size_t, Count> counts_;  ///< by columns
  std::map<std::pair<std::size_t, int>, bool> broken_;
};
void lay_out_listing(Pen& pen, const Figure& figure, const Look& look, const Box& box, int rows,
                     Spacing spacing);

/// The columns of the table that fit in this width, in their order: those that tell least are left out.
std::vector<std::size_t> table_columns(const Trace& trace, double width, Spacing spacing = Spacing::usual);
/// What the table asks for, and what it can do with when so many columns are left out.
double table_width(const Trace& trace);
double least_table_width(const Trace& trace, std::size_t left_out, Spacing spacing = Spacing::usual);
/// How many columns may be left out.
std::size_t spare_columns(const Trace& trace);
void lay_out_table(Pen& pen, const Figure& figure, const Box& box, int rows, Spacing spacing);

// --- Places --------------------------------------------------------------------------------------

/// The lines above the drawing: the title, below it the input, the method at the right.
struct Heading {
  std::vector<std::string> title;
  std::string input, method;
  std::vector<std::string> fault;
  int method_line = 0;  ///< 0: the title's last line; 1: the input's; 2: one of its own
  double first_baseline = 0, height = 0;
};
Heading heading_of(const Trace& trace, const Look& look, double width, double height);

/// Where the slots lie, in units. Depends on the trace and the look only, so that a deck flips without
/// jumping.
struct Places {
  Box title, drawing, listing, table, sentence, footer;
  int lines = 0, rows = 0;  ///< that the listing and the table can show
  Spacing spacing = Spacing::usual;
  int sentence_lines = 2, footer_lines = 1;
  bool bare = false;  ///< the drawing is without what is aside, for which there is no room
  Heading heading;
};
/// Throws ContractViolation when the look's view has more cells than fit.
Places places_of(const Trace& trace, const Look& look, const Stage& stage);

/// The sheet in units, its margins and what the bands above and below leave in the middle.
struct Page {
  double width, height, margin;
  Places at;
  Box middle;
};
Page page_of(const Trace& trace, const Look& look);

/// The three slots in the middle.
struct Body {
  Box drawing, listing, table;
  int lines = 0, rows = 0;
  Spacing spacing = Spacing::usual;
};
/// What the slots ask for.
struct Wants {
  const Trace* trace = nullptr;
  const Look* look = nullptr;
  ListingRows* listing_rows = nullptr;
  bool listing = false, table = false;
  int rows = 0;                      ///< of the table: all there can be
  std::size_t columns_to_spare = 0;  ///< that the table may leave out beside a listing
  double column_width = 0;           ///< of listing and table beside the drawing
  bool whole_lines = false;          ///< no line that is shown may be broken
  std::size_t characters = 0;  ///< in a line of a listing beside a table; 0: as many as there is room for
  Spacing spacing = Spacing::usual;
  double gutter = 20, column_gap = 24;
  double row_gutter = 20;  ///< between listing and table side by side
  double overhang = 0;     ///< of a drawing beside a column, over the sheet's margin
};
/// The fewest lines and rows that the text slots are content with.
struct Least {
  int lines, rows;
};
using Arrange = std::optional<Body> (*)(const Box&, const Wants&, Least);
/// The drawing alone; listing and table in a column on its right; the table on its right and the listing
/// below; both below, side by side or one below the other; all three abreast.
std::optional<Body> alone(const Box& area, const Wants& wants, Least least);
std::optional<Body> beside(const Box& area, const Wants& wants, Least least);
std::optional<Body> shelf(const Box& area, const Wants& wants, Least least);
std::optional<Body> ledge(const Box& area, const Wants& wants, Least least);
std::optional<Body> stack(const Box& area, const Wants& wants, Least least);
std::optional<Body> abreast(const Box& area, const Wants& wants, Least least);
/// The text slots alone.
Body without_drawing(const Box& area, const Wants& wants);

/// The text in at most `most` lines; the last one is shortened.
std::vector<std::string> lines_of(const std::string& text, Face face, double size, double room, int most);
/// The same for a sentence, which is broken between cause and effect where both fit.
std::vector<std::string> sentence_lines(const std::string& sentence, double size, double room, int most);

/// The position of the step, and the legend.
/// Lines that the footer takes so that the whole legend has room.
int footer_lines(const Trace& trace, double room);
void lay_out_footer(Pen& pen, const Figure& figure, const Box& box, const ShownLegend& legend, int lines);

void lay_out_title(Pen& pen, const Heading& heading, const Box& box);
/// The figure's sentence in at most so many lines.
void lay_out_sentence(Pen& pen, const Figure& figure, const Box& box, int most);
/// What the slots fill in every step, with a small margin, in whole pixels so that lines stay as sharp.
/// `drawing`: what the drawing fills, in pixels.
Box crop_box(const Places& at, const Box& drawing, const Look& look, double s);

/// The cells that the figure's drawing shows.
Window visible_cells(const Figure& figure, const Look& look);

}  // namespace gradus::layout
