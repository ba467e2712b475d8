#pragma once
// The parts of laying out a figure that its files share.
//
// Sizes are in units: a slide's shorter side is 720 of them, whatever its size; on a handout they are
// smaller.

#include <optional>
#include <string>
#include <vector>

#include "figure/figure.hpp"
#include "figure/metrics.hpp"
#include "figure/sheet.hpp"

namespace gradus::layout {

inline constexpr double text_size = 20;      ///< 1/36 of a slide's shorter side: nothing is smaller
inline constexpr double sentence_size = 26;  ///< 1/28 and a little
inline constexpr double title_size = 34;
inline constexpr double least_cell = 24;  ///< on a slide a cell is never smaller
inline constexpr double line_height = 30, row_height = 34, heading_height = 38, panel_padding = 8;
inline constexpr double listing_indent = 62;  ///< of the source text, behind the line numbers
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

// --- The drawing ---------------------------------------------------------------------------------

/// What there is to show of the grid, and the room that its axes take.
struct Stage {
  Window cells;        ///< the grid's, or the reader's view of them
  bool fixed = false;  ///< the reader chose the cells: all of them are shown, or none
  bool y_up = true;
  double left = 0, right = 0;  ///< units beside the cells, for their axes
  double above = 0, below = 0;
  double least_cell = 0, largest_cell = 0;  ///< units
  double easy_cell = 0;                     ///< from here on no text is given up for larger cells
};
/// Throws ContractViolation when the look's view misses the grid.
Stage stage_of(const Trace& trace, const Look& look);

/// How a drawing of some size shows its stage.
struct Fit {
  double cell = 0;  ///< units
  std::int64_t columns = 0, rows = 0;
  bool follows = false;  ///< not all cells: a view that follows the step, and an overview
  bool beside = false;   ///< the overview stands beside the view, not above it
};
/// Nothing: the drawing is too small for any cell, or for the cells that the reader chose. Sizes in units.
std::optional<Fit> fit(const Stage& stage, double width, double height);
/// Columns and rows of least cells that a drawing of this size could show.
Fit capacity(const Stage& stage, double width, double height);

/// From the grid's coordinates to pixels: cell (x, y) is the square round the point (x, y).
struct Frame {
  Window view;
  Box box;  ///< of the visible cells
  double cell = 0;
  bool y_up = true;

  double column(double x) const { return box.x + (x - view.lower.x + 0.5) * cell; }
  double row(double y) const {
    const double from_lower = (y - view.lower.y + 0.5) * cell;
    return y_up ? box.bottom() - from_lower : box.y + from_lower;
  }
  dvec2 point(dvec2 p) const { return {column(p.x), row(p.y)}; }
  Box square(ivec2 p) const {
    const dvec2 centre = point({p.x, p.y});
    return {centre.x - cell / 2, centre.y - cell / 2, cell, cell};
  }
};

/// Where the parts of the drawing lie, in pixels: over all steps only the cells in view may change.
struct Scene {
  Frame frame;
  double left = 0;                       ///< where the numbers of the rows may begin
  bool follows = false, beside = false;  ///< as in Fit
  Box inset;                             ///< of the overview, where there is one
  Box settled;                           ///< what the drawing fills in every step: cells, axes, overview
  Box labels;                            ///< where labels may stand
};
Scene scene_of(const Figure& figure, const Look& look, const Stage& stage, const Box& box, double scale);

/// Of a line of this role, in units.
constexpr double line_width(Role role) { return role == Role::measure ? 7 : role == Role::guide ? 1.4 : 2.6; }
/// Whether lines of this role are dashed.
constexpr bool is_dashed(Role role) { return role == Role::candidate || role == Role::rejected; }

void lay_out_drawing(Pen& pen, const Figure& figure, const Scene& scene);

/// A cell's look, `box` being the cell; in the drawing and, small, in the legend. The outline comes apart,
/// since it is drawn over the grid lines.
void draw_cell_ground(Pen& pen, const std::string& id, Role role, const Box& box);
void draw_cell_outline(Pen& pen, const std::string& id, Role role, const Box& box);

// --- Places --------------------------------------------------------------------------------------

/// The lines above the drawing: what stands beside the title where it fits, else below it.
struct Heading {
  std::vector<std::string> title;
  std::string input, method;
  std::vector<std::string> fault;
  int input_line = 0, method_line = 0;  ///< 0: the title's last line; 1, 2: below it
  double first_baseline = 0, height = 0;
};
Heading heading_of(const Trace& trace, const Look& look, double width, double height);

/// Where the slots lie, in units. Depends on the trace and the look only, so that a deck flips without
/// jumping.
struct Places {
  Box title, drawing, listing, table, sentence, footer;
  int lines = 0, rows = 0;  ///< that the listing and the table can show
  int sentence_lines = 2, footer_lines = 1;
  Heading heading;
};
/// Throws ContractViolation when the look's view has more cells than fit.
Places places_of(const Trace& trace, const Look& look, const Stage& stage);

/// What the columns of the table ask for, in units: the widest text and some air, of which they can spare
/// `squeezable`.
inline constexpr double squeezable = 12;
std::vector<double> column_widths(const Trace& trace);

/// The text in at most `most` lines; the last one is shortened.
std::vector<std::string> lines_of(const std::string& text, Face face, double size, double room, int most);
/// The same for a sentence, which is broken between cause and effect where both fit.
std::vector<std::string> sentence_lines(const std::string& sentence, double size, double room, int most);

/// The cells that the figure's drawing shows.
Window visible_cells(const Figure& figure, const Look& look);

}  // namespace gradus::layout
