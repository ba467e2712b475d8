#pragma once
// One step of a trace as slots of plain data, and its layout on a sheet.

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// How a line of the listing or a row of the table stands to this step.
enum class Emphasis : std::uint8_t { none, weak, strong };

struct Figure {
  std::string title, subtitle, sentence;
  std::string position, phase;  ///< "step 4 / 7", "main loop"
  const Trace* trace = nullptr;
  const Canvas* canvas = nullptr;  ///< the drawing after this step
  ivec2 focus{0, 0};
  StepNumber number;

  struct ListingLine {
    SourceLine line;
    Emphasis emphasis;
  };
  std::vector<ListingLine> listing;  ///< shown_listing of the trace

  struct TableRow {
    Row cells;
    Emphasis emphasis = Emphasis::none;
    std::vector<bool> changed;  ///< a cell per column: changed by this step
  };
  std::vector<TableRow> rows;  ///< all rows so far; the layout shows the last ones that fit
};

/// A slide is read from the last row; a handout lies on the table: smaller letters, more of everything.
enum class Layout : std::uint8_t { slide, handout };

/// What stands before a line of the listing: its place in the listing, in the source file, or nothing.
enum class LineNumbers : std::uint8_t { listing, source, none };

/// What the reader asked for.
struct Look {
  double width = 1280, height = 720;  ///< CSS pixels, 96 per inch
  std::set<Slot> slots{all_slots.begin(), all_slots.end()};
  Layout layout = Layout::slide;
  bool crop = false;           ///< the sheet ends where the slots end, the same for all steps
  std::optional<Window> view;  ///< the cells to show; none: all, or a view that follows the step
  std::optional<bool> y_up;    ///< turns the drawing; none: the topic's own direction
  std::string title;           ///< instead of the trace's; empty: that
  LineNumbers line_numbers = LineNumbers::listing;
  double least_text = 0;  ///< pixels: a handout's letters are no smaller, however small its box
};

/// The slots of one recorded step. `playhead` must be of the same trace; both must outlive the figure.
Figure figure_of(const Trace& trace, Playhead& playhead, StepNumber number);

/// Puts the slots in their places. What does not fit is shortened (elided rows, a window of lines, a view
/// that follows the step), never shrunk. Places depend on the trace and the look only, not on the step.
/// Throws ContractViolation, saying what was expected and found, when the look's view misses the grid or
/// has more cells than fit.
Sheet lay_out(const Figure& figure, const Look& look);

/// Columns and rows of the largest view that this look has room for with cells that can be seen from the last
/// row; the numbers along the axes are those of look.view, if there is one.
ivec2 largest_view(const Trace& trace, const Look& look);

/// "step 4 of 7", or from first to last: "steps 2 to 5 of 7". At least one step.
std::string steps_text(const Trace& trace, std::span<const StepNumber> steps);
/// What a file or page is called: "Bresenham line (faulty: …), step 4 of 7".
std::string heading_of(const Trace& trace, std::span<const StepNumber> steps);
/// What a file of several steps shows: "<heading>, decision parameter. <goal> Input: <subtitle>."
std::string summary_of(const Trace& trace, std::span<const StepNumber> steps);
/// "Bresenham line, decision parameter, step 4 of 7: <sentence> Input: <subtitle>." — caption and alt text.
std::string caption_of(const Figure& figure);

}  // namespace gradus
