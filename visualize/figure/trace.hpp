#pragma once
// A recorded run: the only thing figures, player, tables and JSON are made from.
//
// Steps are numbered 0 (the input) to `last` (the result); finer events between step n and n + 1 are n.1, n.2
// … Footer, table, address bar, --step, file names, PDF pages and JSON all use these numbers.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "figure/content.hpp"
#include "figure/drawing.hpp"
#include "figure/text/wording.hpp"

namespace gradus {

struct PolygonMesh;

/// The version of the trace's JSON form; raised when a reader of the old one would go wrong.
inline constexpr int trace_schema = 1;

/// How much a step tells: the idea (first, last, phases), a step, or the arithmetic inside one.
enum class Level : std::uint8_t { idea, step, arithmetic };

struct StepNumber {
  std::int64_t step = 0;
  int fine = 0;  ///< 0: the step itself; k: the k-th finer event after it
  friend auto operator<=>(const StepNumber&, const StepNumber&) = default;
};
/// "7" or "7.2".
std::string text_of(StepNumber number);

/// The value of a field, as JSON will show it.
using Value = std::variant<std::int64_t, double, bool, std::string, ivec2>;
struct Field {
  std::string name;
  Value value;
  std::string quantity{};  ///< what it is a value of, where its name does not say it: p for p_before
};

/// A question that a step answers, and which way the run goes on.
struct Decision {
  std::string question;              ///< for the reader: "p < 0?"
  std::vector<std::string> answers;  ///< all there are
  std::size_t answer = 0;            ///< which of them was given
  std::string branch{};              ///< its kind, for programs: straight, diagonal, inside, outside, cut, …
};

/// The cells of one table row, one text per column of the trace; empty where there is none.
using Row = std::vector<std::string>;

/// One thing that happened.
struct TraceStep {
  StepNumber number;
  Level level = Level::step;
  std::string type;                    ///< the step type's name in the algorithm: "Stepped"
  std::string phase;                   ///< part of the run: "set up", "main loop"
  std::string key;                     ///< what it is about: "4,2" for a pixel
  int line = 0;                        ///< the listed source line that it marks; 0: none (line_that_ran)
  std::vector<Field> fields;           ///< the step's data
  std::string sentence;                ///< cause, then effect, with the numbers put in
  std::string note{};                  ///< its effect in two or three words, where a story says it
  std::optional<Decision> decision{};  ///< what is decided here, if anything is
  /// The table after this step: `read` completes the row in which the test was read (the last one so far),
  /// `row` is the row that the step produced. Either may be empty.
  Row read, row;
  Delta delta;       ///< what changed in the drawing
  ivec2 focus;       ///< the cell that a view which cannot show all should follow
  double tells = 0;  ///< how much its figure tells, where the story says it: more is better
};

/// A column of the decision table.
struct Column {
  std::string id;       ///< the same in every wording, for programs: the variable's name as in the source
  bool numeric = true;  ///< right-aligned digits; else centred text
  std::string name =
      {};  ///< what the reader sees; empty until the trace is finished: see TraceWriter::finish
  std::string quantity{};  ///< what its cells are values of, where its id does not say it: a for code_a
};

/// What a fault does to a line of the taught listing.
enum class Change : std::uint8_t { none, struck, added };

/// One shown line of an algorithm's real source.
struct SourceLine {
  int number;
  std::string text;  ///< without the function's own indentation
  Change change = Change::none;
};

/// Whether a line of a listing is the heading of one of its functions: "divide(point, view):".
inline bool is_heading(std::string_view line) { return !line.starts_with(' ') && line.ends_with("):"); }

/// A parameter's name with the value used, in the canonical spelling.
struct Argument {
  std::string name, value;
};

/// A place of step 0's drawing that numbers of an argument move: where a page lets its reader drag them.
struct Handle {
  std::string parameter;
  std::vector<int> numbers;  ///< which of the argument's, counted from 0 as they stand in its text
  dvec2 at;                  ///< in the drawing's coordinates
  std::vector<dvec2> along;  ///< of each number: how far the place goes when it grows by 1
};

/// The kind of mark that stands for a role in the legend.
enum class Sample : std::uint8_t { line, outline, arrow, cross, dot, ring, area, cell };

/// What a role means in this topic, for the legend.
struct LegendEntry {
  Role role;
  std::string text;
  std::optional<Sample> sample{};  ///< without it: as the drawing shows the role in this step
  std::optional<Rgba8> color{};    ///< it stands for cells of this colour
};

struct Trace {
  std::string topic, title, subtitle;  ///< "bresenham_line", "Bresenham line", "(0, 0) to (7, 3)"
  std::string method, method_title;
  std::string faulty;  ///< empty, or what is wrong with this run; goes into title, caption and JSON
  std::string goal;    ///< the idea in one sentence
  Wording wording;     ///< in which all these texts are told
  std::vector<SymbolLabel> named_in_the_code{};  ///< besides labels of what the listing has
  std::vector<std::string> in_the_code{};        ///< what the code has otherwise than the reader's notation
  std::vector<Argument> arguments;               ///< canonical: the command that makes this trace again
  std::string input_hash;                        ///< of input files' contents; empty where there were none

  std::string source_file;          ///< "algorithms/scan_conversion/…/….hpp"
  std::vector<SourceLine> listing;  ///< the method's lines, plumbing left out
  std::vector<SourceLine> struck;   ///< those of the taught listing that a fault leaves out or replaces
  std::vector<Column> columns;
  std::vector<LegendEntry> legend;
  /// Symbols with a colour of their own in picture, code, table and sentence, the first ones first; an
  /// empty one leaves its colour out. Where the story names none: those that decisions ask about and answer
  /// with.
  std::vector<std::string> quantities;
  Grid grid;
  std::vector<Mark> backdrop;  ///< stands unchanged through all steps

  std::vector<Handle> handles;  ///< what of the input can be dragged in the drawing

  Canvas before;                    ///< the drawing just before steps.front()
  std::vector<TraceStep> steps;     ///< the recorded part, in order
  std::vector<std::string> widest;  ///< a column each: the longest text it holds, so that tables keep still
  std::vector<int> changes;         ///< a column each: how often its text is another than in the row before
  Content content;                  ///< what the recorded steps draw
  std::vector<LegendEntries> legends;  ///< of the recorded steps: see legends_of
  std::string longest_sentence;        ///< of the recorded steps: for how many lines the sentence needs
  std::vector<int> lines;              ///< the source lines that reported steps, ascending
  std::int64_t last = 0;               ///< number of the run's last step, recorded or not
  bool whole() const;                  ///< whether every step of the run is in `steps`

  std::vector<Field> result;
  std::shared_ptr<const PolygonMesh> mesh{};  ///< the surface that the run has made, for files of models
  std::vector<std::string> counts{};          ///< what runs are compared by: "cuts: 4", of the whole run
  std::vector<ivec2> pixels;  ///< rasters: the pixels that were set, in order (as many as were recorded)

  /// The step whose figure tells most: what a figure shows where no step is named.
  StepNumber telling;
};

/// The listing with what is struck out of it, ascending: what a figure shows.
std::vector<SourceLine> shown_listing(const Trace& trace);

/// The colour of a quantity by its symbol, below quantity_colors; nothing for those without one.
std::optional<int> color_of_quantity(const Trace& trace, std::string_view symbol);
/// The same of a column's cells.
std::optional<int> color_of_quantity(const Trace& trace, const Column& column);

/// Position in trace.steps of a step. The number must be recorded: see `find_step`.
std::size_t index_of(const Trace& trace, StepNumber number);
/// Whether this step is recorded.
bool has_step(const Trace& trace, StepNumber number);

/// The drawing after any recorded step, by keyframes and deltas. Moving back is the same as never having
/// moved on. Cost: O(size of the drawing) for a jump, O(delta) for a step forward; memory linear in the sum
/// of deltas.
class Playhead {
 public:
  explicit Playhead(const Trace& trace);
  /// Goes to trace.steps[index].
  const Canvas& at(std::size_t index);

 private:
  const Trace& trace_;
  std::vector<std::pair<std::size_t, Canvas>> keyframes_;  ///< (index, canvas after it), ascending
  std::size_t position_;                                   ///< steps applied to canvas_
  Canvas canvas_;
};

}  // namespace gradus
