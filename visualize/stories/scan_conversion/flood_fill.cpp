// The story of a fill: which pixel is painted next, and what still waits.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <algorithm>

#include "core/shown.hpp"
#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::flood_fill {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/scan_conversion/flood_fill/";

/// Cells that the notes' recursion may fill here: what it leaves of the machine's stack is enough on every
/// machine.
constexpr std::int64_t most_recursive_cells = 1024;

/// How far outside the picture a seed is drawn, in cells.
constexpr int margin = 2;

/// A small maze with a corner to turn, a dead end and a diagonal gap: 4- and 8-connected fills differ.
constexpr std::string_view example_maze =
    "##########/#....#...#/#.##.#.#.#/#.#....#.#/#.#.####.#/#...#..#.#/##########";

/// What is filled: an image, or the letters of a maze.
struct Subject {
  Image image;  ///< the picture to fill; for a maze: one colour a kind of cell
  bool is_maze = false;
  Maze maze;
};

constexpr Rgba8 default_color{0, 0x72, 0xb2, 255};
constexpr char default_letter = 'x';

Rgba8 maze_color(char cell) {
  // Only equality matters to the fill: every kind of cell gets a colour of its own
  const auto code = static_cast<std::uint8_t>(cell);
  return {code, code, code, 255};
}

Subject subject_of(const Arguments& arguments) {
  Subject subject;
  if (arguments.has("image") && !arguments.text("image").empty()) {
    subject.image = arguments.entry("image").image.value();
    return subject;
  }
  const Arguments::Entry& entry = arguments.entry("maze");
  const auto parsed =
      parse_maze(entry.content, entry.hash.empty() ? "--maze" : shown_name(entry.text), entry.quotable);
  if (const MazeError* error = std::get_if<MazeError>(&parsed)) throw InputError(error->what);
  subject.is_maze = true;
  subject.maze = std::get<Maze>(parsed);
  subject.image = Image(subject.maze.width(), subject.maze.height());
  for (int y = 0; y < subject.maze.height(); ++y) {
    for (int x = 0; x < subject.maze.width(); ++x) subject.image[{x, y}] = maze_color(subject.maze[{x, y}]);
  }
  return subject;
}

/// What a maze shows behind all steps: its walls and letters.
Delta maze_cells(const Maze& maze) {
  Delta delta;
  for (int y = 0; y < maze.height(); ++y) {
    for (int x = 0; x < maze.width(); ++x) {
      const char cell = maze[{x, y}];
      if (cell == wall) delta.cells.push_back({{x, y}, CellLook{Role::boundary, ""}});
      if (is_color(cell)) delta.cells.push_back({{x, y}, CellLook{Role::input, std::string(1, cell)}});
    }
  }
  return delta;
}

/// The outline of a window's cells.
Path border(const Window& w) {
  const double left = w.lower.x - 0.5, right = w.upper.x + 0.5, top = w.lower.y - 0.5,
               bottom = w.upper.y + 0.5;
  return {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}, true};
}

/// The cells that are drawn: the picture's, and those up to a seed a little outside a maze.
Window shown_cells(const Subject& subject, ivec2 seed) {
  const Window cells = subject.image.window();
  const Window around{cells.lower - margin, cells.upper + margin};
  if (!subject.is_maze || !around.contains(seed)) return cells;
  return {{std::min(cells.lower.x, seed.x), std::min(cells.lower.y, seed.y)},
          {std::max(cells.upper.x, seed.x), std::max(cells.upper.y, seed.y)}};
}

/// "above (3, 4)": where a neighbour lies, rows counting downwards.
std::string place(const Wording& words, ivec2 from, ivec2 to) {
  constexpr std::string_view keys[3][3] = {
      {"flood_fill.place.above_left", "flood_fill.place.above", "flood_fill.place.above_right"},
      {"flood_fill.place.left", "flood_fill.place.same", "flood_fill.place.right"},
      {"flood_fill.place.below_left", "flood_fill.place.below", "flood_fill.place.below_right"}};
  const ivec2 way{std::clamp(to.x - from.x, -1, 1), std::clamp(to.y - from.y, -1, 1)};
  return words.say(keys[way.y + 1][way.x + 1], arg("pixel", figure_point(from)));
}

/// What holds the pixels that wait, by the name of a method that is right.
std::string kept_as(const std::string& method) {
  return method == "unchecked_seed" ? "breadth_first" : method;
}

/// Tells the steps of all methods. A pixel painted is a milestone, as is a span; looking is finer.
class FillTeller {
 public:
  FillTeller(TraceWriter& writer, const Subject& subject, const std::string& method,
             std::optional<Window> window)
      : writer_(writer),
        words_(writer.wording()),
        subject_(subject),
        method_(kept_as(method)),
        window_(window) {
    const std::string waiting = method == "depth_first" ? "path" : method == "recursive" ? "calls" : "queue";
    if (method == "recursive") calls_ = Raster<std::int64_t>(subject.image.width(), subject.image.height());
    writer.trace().columns = {{"n"}, {"column"}, {"row"}, {"from", false}, {waiting}, {"painted"}};
    if (method == "span") {
      writer.trace().columns = {{"n"}, {"row"}, {"left"}, {"right"}, {"pixels"}, {"painted"}};
    }
  }

  void operator()(const Started& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = at_start(s.seed);
    writer_.step(std::move(delta), s.seed, line, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(s.seed);
      step.fields = {{"seed", s.seed},
                     {"connectivity", std::int64_t{static_cast<int>(s.connectivity)}},
                     {"inside", s.inside}};
      step.sentence = words_.say(s.inside ? "flood_fill.started" : "flood_fill.nothing_to_do",
                                 arg("seed", figure_point(s.seed)),
                                 arg("connectivity", static_cast<int>(s.connectivity)));
    });
  }

  /// The notes' listing reads the seed wherever it lies: the picture's border and what is read are shown.
  void operator()(const SeedRead& s, int line = __builtin_LINE(), const char* = nullptr) {
    read_ = s;
    Delta delta = at_start(s.seed);
    if (!on_grid(s.seed)) {
      delta.set.push_back({"picture", Role::measure, border(subject_.image.window())});
      if (s.lands) {
        const dvec2 from{s.seed.x, s.seed.y}, to{s.lands->x, s.lands->y};
        delta.set.push_back({"lands", Role::input, Stroke{from, to, true, true}});
        delta.set.push_back({"lands name", Role::input, Label{to, words_.say("flood_fill.read_here")}});
      }
    }
    const std::string where = on_grid(s.seed) ? "inside" : s.lands ? "elsewhere" : "nowhere";
    writer_.step(std::move(delta), cell_of(s.seed), line, [&](TraceStep& step) {
      step.type = "SeedRead";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(s.seed);
      step.fields = {{"seed", s.seed}, {"index", s.index}};
      if (s.lands) step.fields.push_back({"lands", *s.lands});
      step.sentence = words_.say("flood_fill.seed_read." + where, arg("seed", figure_point(s.seed)),
                                 arg("row", figure_factor(s.seed.y)), arg("width", subject_.image.width()),
                                 arg("column", figure_factor(s.seed.x)), arg("index", figure_number(s.index)),
                                 arg("lands", figure_point(cell_of(s.seed))),
                                 arg("cells", subject_.image.cells().size()));
    });
  }

  void operator()(const Painted& p, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    if (painted_ == 0) delta.removed.push_back("seed name");
    if (painted_ == 0 && read_) delta.removed.push_back("lands name");
    const ivec2 cell = cell_of(p.pixel);
    if (calls_.contains(cell)) {
      calls_[cell] = static_cast<std::int64_t>(p.waiting);
      delta.removed.push_back("seed");  // its number says the same
    }
    retire(delta);
    make_current(delta, cell);
    ++painted_;
    note(cell);
    writer_.step(std::move(delta), cell, line, [&](TraceStep& step) {
      step.type = "Painted";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(cell);
      step.fields = {{"from", p.from}, {"pixel", p.pixel}, {waiting_name(), std::int64_t(p.waiting)}};
      const bool seed = p.from == p.pixel;
      const std::string what = !seed ? "next" : cell == p.pixel ? "seed" : "elsewhere";
      step.sentence = words_.say("flood_fill.painted." + what, arg("pixel", figure_point(p.pixel)),
                                 arg("place", place(words_, p.from, p.pixel)),
                                 arg("cell", figure_point(cell)), arg("holds", holds(p.waiting)));
      step.row = {figure_number(painted_),
                  figure_number(cell.x),
                  figure_number(cell.y),
                  seed ? words_.say("flood_fill.seed") : figure_point(p.from),
                  figure_number(std::int64_t(p.waiting)),
                  figure_number(painted_)};
    });
  }

  void operator()(const Examined& e, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    point_at(delta, e.pixel, e.inside);
    writer_.fine(std::move(delta), cell_of(e.from), line, [&](TraceStep& step) {
      step.type = "Examined";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(e.pixel);
      step.fields = {{"from", e.from}, {"pixel", e.pixel}, {"inside", e.inside}};
      step.sentence =
          words_.say("flood_fill.examined." + (e.inside ? "free" : why_not(e.pixel)),
                     arg("pixel", figure_point(e.pixel)), arg("place", place(words_, e.from, e.pixel)));
    });
  }

  void operator()(const Retreated& r, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    put(delta, r.pixel, Role::past);
    if (current_ == r.pixel) current_.reset();
    writer_.fine(std::move(delta), r.pixel, line, [&](TraceStep& step) {
      step.type = "Retreated";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(r.pixel);
      step.fields = {{"pixel", r.pixel}, {waiting_name(), std::int64_t(r.waiting)}};
      step.sentence = words_.say(recursive() ? "flood_fill.call_returned" : "flood_fill.retreated",
                                 arg("pixel", figure_point(r.pixel)), arg("holds", holds(r.waiting)));
    });
  }

  void operator()(const Dequeued& d, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    retire(delta);
    const ivec2 cell = cell_of(d.pixel);
    put(delta, cell, Role::current);
    current_ = cell;
    current_waits_ = false;
    writer_.fine(std::move(delta), cell, line, [&](TraceStep& step) {
      step.type = "Dequeued";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(cell);
      step.fields = {{"pixel", d.pixel}, {"waiting", std::int64_t(d.waiting)}};
      step.sentence = words_.count("flood_fill.dequeued", static_cast<std::int64_t>(d.waiting),
                                   arg("pixel", figure_point(d.pixel)));
    });
  }

  void operator()(const SpanFilled& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    if (painted_ == 0) delta.removed.push_back("seed name");
    for (const ivec2 p : run_) put(delta, p, Role::past);
    run_.clear();
    for (int x = s.span.left; x <= s.span.right; ++x) {
      run_.push_back({x, s.span.row});
      note(run_.back());
      put(delta, run_.back(), Role::current);
    }
    painted_ += s.span.length();
    ++spans_;
    focus_ = s.found;
    writer_.step(std::move(delta), s.found, line, [&](TraceStep& step) {
      step.type = "SpanFilled";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key(s.found);
      step.fields = {{"row", std::int64_t{s.span.row}},
                     {"left", std::int64_t{s.span.left}},
                     {"right", std::int64_t{s.span.right}},
                     {"found", s.found}};
      step.sentence =
          words_.say("flood_fill.span_filled", arg("found", figure_point(s.found)), arg("row", s.span.row),
                     arg("left", s.span.left), arg("right", s.span.right));
      step.row = {figure_number(spans_),       figure_number(s.span.row),      figure_number(s.span.left),
                  figure_number(s.span.right), figure_number(s.span.length()), figure_number(painted_)};
    });
  }

  void operator()(const SpanQueued& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    arrow(delta, "waiting span", Role::candidate, s.span);
    writer_.fine(std::move(delta), {s.span.left, s.span.row}, line, [&](TraceStep& step) {
      step.type = "SpanQueued";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key({s.span.left, s.span.row});
      step.fields = span_fields(s.span, s.waiting);
      step.sentence =
          words_.say("flood_fill.span_queued", arg("row", s.span.row + s.span.way), arg("left", s.span.left),
                     arg("right", s.span.right), arg("holds", holds(s.waiting)));
    });
  }

  void operator()(const SpanTaken& s, int line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    for (const ivec2 p : run_) put(delta, p, Role::past);
    run_.clear();
    arrow(delta, "taken span", Role::current, s.span);
    taken_ = true;
    writer_.fine(std::move(delta), {s.span.left, s.span.row}, line, [&](TraceStep& step) {
      step.type = "SpanTaken";
      step.phase = words_.say("flood_fill.filling");
      step.key = pixel_key({s.span.left, s.span.row});
      step.fields = span_fields(s.span, s.waiting);
      step.sentence = words_.count("flood_fill.span_taken", static_cast<std::int64_t>(s.waiting),
                                   arg("row", s.span.row + s.span.way), arg("left", s.span.left),
                                   arg("right", s.span.right));
    });
  }

  void operator()(const Returned& r, int line = __builtin_LINE(), const char* = nullptr) {
    writer_.fine(at_end(), focus_, line, [&](TraceStep& step) {
      step.type = "Returned";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"painted", r.depth.painted}, {"peak_calls", r.depth.peak}};
      step.sentence =
          words_.count("flood_fill.returned", r.depth.painted, arg("most", figure_number(r.depth.peak)));
    });
  }

  void operator()(const Finished& f, int line = __builtin_LINE(), const char* = nullptr) {
    writer_.fine(at_end(), focus_, line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"painted", f.filled.painted},
                     {"peak_waiting", std::int64_t(f.filled.peak_waiting)},
                     {"peak_bytes", std::int64_t(f.filled.peak_bytes)}};
      step.sentence = words_.count(
          "flood_fill.finished", f.filled.painted,
          arg("held", words_.say("flood_fill.held." + method_, arg("most", f.filled.peak_waiting))),
          arg("bytes", f.filled.peak_bytes));
    });
  }

 private:
  bool recursive() const { return method_ == "recursive"; }
  /// What the number of pixels that wait is called: of the recursion it is that of open calls.
  std::string waiting_name() const { return recursive() ? "calls" : "waiting"; }

  /// Where in the picture a pixel is painted: a seed outside lies in another row's memory.
  ivec2 cell_of(ivec2 p) const { return read_ && read_->lands && p == read_->seed ? *read_->lands : p; }

  Delta at_start(ivec2 seed) {
    Delta delta = subject_.is_maze ? maze_cells(subject_.maze) : Delta{};
    if (window_) delta.set.push_back({"window", Role::measure, border(*window_)});
    if (shown_cells(subject_, seed).contains(seed)) {
      delta.set.push_back({"seed", Role::input, Dot{{seed.x, seed.y}}});
      delta.set.push_back({"seed name", Role::input, Label{{seed.x, seed.y}, words_.say("flood_fill.seed")}});
    }
    focus_ = cell_of(seed);
    return delta;
  }
  Delta at_end() {
    Delta delta = cleared();
    delta.removed.push_back("taken span");
    if (painted_ <= Recording::default_most) {
      for (const ivec2 p : writer_.trace().pixels) put(delta, p, Role::result);
    }
    return delta;
  }

  static std::vector<Field> span_fields(const Span& s, std::size_t waiting) {
    return {{"row", std::int64_t{s.row}},
            {"left", std::int64_t{s.left}},
            {"right", std::int64_t{s.right}},
            {"way", std::int64_t{s.way}},
            {"waiting", std::int64_t(waiting)}};
  }

  /// Keeps the pixels in order, as far as a trace keeps steps.
  void note(ivec2 p) {
    auto& pixels = writer_.trace().pixels;
    if (static_cast<std::int64_t>(pixels.size()) < Recording::default_most) pixels.push_back(p);
  }

  bool on_grid(ivec2 p) const { return subject_.image.contains(p); }

  /// A cell that the recursion has come to has the number of calls that were open then.
  void put(Delta& delta, ivec2 p, Role role) {
    const std::int64_t calls = calls_.contains(p) ? calls_[p] : 0;
    delta.cells.push_back({p, CellLook{role, calls > 0 ? figure_number(calls) : ""}});
  }

  /// The pixel painted last is one of those that wait, from now on.
  void retire(Delta& delta) {
    if (current_) put(delta, *current_, current_waits_ ? Role::candidate : Role::past);
  }
  void make_current(Delta& delta, ivec2 p) {
    put(delta, p, Role::current);
    current_ = p;
    current_waits_ = true;
  }

  /// What holds the pixels that wait, and how many.
  std::string holds(std::size_t waiting) const {
    return words_.say("flood_fill.holds." + method_, arg("waiting", waiting));
  }
  std::string why_not(ivec2 p) const {
    if (!on_grid(p)) return "outside";
    return subject_.is_maze && subject_.maze[p] == wall ? "wall" : "other";
  }

  /// Shows what was looked at without changing how its cell looks.
  void point_at(Delta& delta, ivec2 p, bool free) {
    if (!on_grid(p)) return;
    const dvec2 at{p.x, p.y};
    if (free) {
      delta.set.push_back({"looked at", Role::accepted, Dot{at, true}});
      return;
    }
    delta.set.push_back(
        {"looked at", Role::rejected, Stroke{at - dvec2{0.25, 0.25}, at + dvec2{0.25, 0.25}}});
    delta.set.push_back(
        {"looked at too", Role::rejected, Stroke{at + dvec2{-0.25, 0.25}, at + dvec2{0.25, -0.25}}});
  }

  void arrow(Delta& delta, std::string id, Role role, const Span& s) {
    const double middle = (s.left + s.right) / 2.0;
    delta.set.push_back(
        {std::move(id), role, Stroke{{middle, double(s.row)}, {middle, s.row + 0.75 * s.way}, true}});
  }

  Delta cleared() {
    Delta delta;
    delta.removed = {"looked at", "looked at too", "waiting span"};
    if (taken_) delta.removed.push_back("taken span");
    taken_ = false;
    return delta;
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Subject& subject_;
  std::string method_;
  std::optional<Window> window_;
  std::int64_t painted_ = 0, spans_ = 0;
  ivec2 focus_{0, 0};
  std::optional<ivec2> current_;
  bool current_waits_ = true;
  bool taken_ = false;
  std::vector<ivec2> run_;
  std::optional<SeedRead> read_;
  Raster<std::int64_t> calls_;  ///< open when each cell was painted; of the recursion only
};

Connectivity connectivity_of(const Arguments& arguments) {
  return arguments.text("connectivity") == "8" ? Connectivity::eight : Connectivity::four;
}

const std::vector<gradus::Method>& all_methods() {
  static const std::vector<gradus::Method> methods{
      method_in_english("flood_fill", "depth_first", Standing::taught),
      method_in_english("flood_fill", "breadth_first", Standing::plain),
      method_in_english("flood_fill", "span", Standing::fast),
      method_in_english("flood_fill", "recursive", Standing::faulty),
      method_in_english("flood_fill", "unchecked_seed", Standing::faulty)};
  return methods;
}

bool is_faulty(const std::string& method) { return method == "recursive" || method == "unchecked_seed"; }

void describe(Trace& trace, const Subject& subject, const Arguments& arguments) {
  const std::string& method = arguments.text("method");
  const ivec2 seed = arguments.cell("at");
  introduce(trace, "flood_fill", arguments, is_faulty(method));
  const Wording& words = trace.wording;
  trace.subtitle = words.say(subject.is_maze ? "flood_fill.subtitle.maze" : "flood_fill.subtitle.image",
                             arg("width", subject.image.width()), arg("height", subject.image.height()),
                             arg("seed", figure_point(seed)));
  trace.method_title =
      words.say("flood_fill.connected", arg("method", words.say("flood_fill.method." + method)),
                arg("connectivity", arguments.text("connectivity")));
  trace.source_file = std::string(folder) + (is_faulty(method) ? "flood_fill_notes.hpp" : "flood_fill.hpp");
  trace.listing = listing_of(source_text(trace.source_file), method == "recursive" ? "recurse" : method);
  trace.grid.cells = shown_cells(subject, seed);
  trace.grid.y_up = false;
  trace.grid.x_name = words.say("flood_fill.column.column");
  trace.grid.y_name = words.say("flood_fill.column.row");
  if (!subject.is_maze) trace.grid.picture = subject.image;
  trace.legend = {{Role::current, words.say("flood_fill.legend.current")},
                  {Role::candidate, words.say("flood_fill.legend.candidate." + kept_as(method))},
                  {Role::past, words.say("flood_fill.legend.past")},
                  {Role::accepted, words.say("flood_fill.legend.accepted")},
                  {Role::rejected, words.say("flood_fill.legend.rejected")},
                  {Role::result, words.say("flood_fill.legend.result")},
                  {Role::boundary, words.say("flood_fill.legend.boundary")},
                  {Role::measure, words.say(method == "unchecked_seed" ? "flood_fill.legend.picture"
                                                                       : "flood_fill.legend.measure")}};
}

int tolerance_of(const Subject& subject, const Arguments& arguments) {
  return subject.is_maze ? 0 : static_cast<int>(arguments.integer("tolerance"));
}

/// The window, where there is one, as far as cells can be numbered; the picture ends long before.
std::optional<Window> window_of(const Arguments& arguments) {
  const auto window = arguments.window("window");
  if (!window) return std::nullopt;
  return Window{glm::clamp(window->lower, room.lower, room.upper),
                glm::clamp(window->upper, room.lower, room.upper)};
}

gradus::flood_fill::Method method_of(const Arguments& arguments) {
  const std::string& name = arguments.text("method");
  if (name == "depth_first") return Method::depth_first;
  return name == "breadth_first" ? Method::breadth_first : Method::span;
}

/// The picture's fill cut to a window, by fill(inside, paint); a mask keeps what is painted, whatever the new
/// colour.
template <class Fill>
auto fill_masked(Image& image, ivec2 seed, Rgba8 color, const Window& window, int tolerance, Fill fill) {
  const Rgba8 old = image[seed];
  Raster<std::uint8_t> visited(image.width(), image.height());
  const auto inside = [&](ivec2 p) {
    return window.contains(p) && image.contains(p) && !visited[p] && alike(image[p], old, tolerance);
  };
  const auto paint = [&](ivec2 p) {
    visited[p] = 1;
    image[p] = color;
  };
  return fill(inside, paint);
}

/// What pixels are painted with. A maze's walls stay; its other cells become a letter.
Rgba8 paint_of(const Subject& subject, const Arguments& arguments, ivec2 seed) {
  const std::string& given = arguments.has("paint") ? arguments.text("paint") : "";
  const bool letter = given.size() == 1;
  if (!subject.is_maze) {
    if (letter)
      throw ArgumentError("paint", fmt::format("expected a colour for an image, found '{}'", given));
    return given.empty() ? default_color : arguments.color("paint");
  }
  if (!given.empty() && !letter) {
    throw ArgumentError("paint", "expected a letter for a maze, found a colour");
  }
  if (subject.maze[seed] == wall) return maze_color(wall);
  return maze_color(letter ? given[0] : default_letter);
}

/// What a method leaves behind: what it counts, and the picture as painted.
struct Outcome {
  std::vector<Field> counts;
  Image image;
};

/// The notes' recursion. Refused by name for pictures that are too large for it.
Outcome fill_recursively(const Subject& subject, const Arguments& arguments, FillTeller& teller) {
  const Window picture = subject.image.window();
  const Window window = arguments.window("window").value_or(picture);
  const Window cells{{std::max(window.lower.x, picture.lower.x), std::max(window.lower.y, picture.lower.y)},
                     {std::min(window.upper.x, picture.upper.x), std::min(window.upper.y, picture.upper.y)}};
  const std::int64_t count = cells.empty() ? 0 : cells.width() * cells.height();
  if (count > most_recursive_cells) {
    throw ArgumentError(subject.is_maze ? "maze" : "image",
                        fmt::format("method recursive keeps a call open for every pixel of its path, so at "
                                    "most {} cells: found {}",
                                    most_recursive_cells, count));
  }
  Outcome outcome{{}, subject.image};
  const ivec2 seed = arguments.cell("at");
  const Rgba8 color = paint_of(subject, arguments, seed);
  const int tolerance = tolerance_of(subject, arguments);
  const bool nothing_to_do = tolerance == 0 && color == subject.image[seed];
  const Depth depth =
      fill_masked(outcome.image, seed, color, nothing_to_do ? Window{} : cells, tolerance,
                  [&](auto& inside, auto& paint) {
                    return flood_fill::recursive(seed, inside, paint, connectivity_of(arguments), teller);
                  });
  outcome.counts = {{"painted", depth.painted}, {"peak_calls", depth.peak}};
  return outcome;
}

/// The notes' listing that reads the seed wherever it lies.
Outcome fill_unchecked(const Subject& subject, const Arguments& arguments, FillTeller& teller) {
  if (arguments.window("window")) throw ArgumentError("window", "method unchecked_seed has none");
  if (tolerance_of(subject, arguments) != 0)
    throw ArgumentError("tolerance", "method unchecked_seed has none");
  const ivec2 seed = arguments.cell("at");
  if (!room.contains(seed)) throw ArgumentError("at", "expected a cell two away from the ends of int32");
  Outcome outcome{{}, subject.image};
  const std::int64_t index = row_major(subject.image, seed);
  const auto lands = cell_at(subject.image, index);
  const Rgba8 color = lands ? paint_of(subject, arguments, *lands) : default_color;
  const auto done = unchecked_seed(outcome.image, seed, color, connectivity_of(arguments), teller);
  outcome.counts = {
      {"painted", done ? done->painted : 0}, {"index", index}, {"in_memory", lands.has_value()}};
  return outcome;
}

/// The methods that are right.
Outcome fill_rightly(const Subject& subject, const Arguments& arguments, FillTeller& teller) {
  const Options options{tolerance_of(subject, arguments), connectivity_of(arguments), method_of(arguments)};
  const ivec2 seed = arguments.cell("at");
  const auto window = window_of(arguments);
  const Rgba8 color = paint_of(subject, arguments, seed);
  Outcome outcome{{}, subject.image};
  const bool nothing_to_do = options.tolerance == 0 && color == subject.image[seed];
  const Filled done = !window || nothing_to_do
                          ? fill_image(outcome.image, seed, color, options, teller)
                          : fill_masked(outcome.image, seed, color, *window, options.tolerance,
                                        [&](auto& inside, auto& paint) {
                                          return in_window(options.method, seed, *window, inside, paint,
                                                           options.connectivity, teller);
                                        });
  outcome.counts = {{"painted", done.painted},
                    {"peak_waiting", std::int64_t(done.peak_waiting)},
                    {"peak_bytes", std::int64_t(done.peak_bytes)},
                    {"mask_bytes", std::int64_t(done.mask_bytes)}};
  return outcome;
}

/// The maze after the fill, its rows joined by "/".
std::string filled_maze(const Image& image) {
  std::string rows;
  for (int y = 0; y < image.height(); ++y) {
    if (y > 0) rows += '/';
    for (const Rgba8& cell : image.row(y)) rows += static_cast<char>(cell.r);
  }
  return rows;
}

Trace run(const Arguments& arguments, Recording recording) {
  const Subject subject = subject_of(arguments);
  const std::string& method = arguments.text("method");
  const ivec2 seed = arguments.cell("at");
  if (!subject.image.contains(seed) && method != "unchecked_seed") {
    throw ArgumentError(
        "at", fmt::format("expected a pixel inside the {} × {} picture (columns 0 to {}, rows 0 to {}), "
                          "found {},{}",
                          subject.image.width(), subject.image.height(), subject.image.width() - 1,
                          subject.image.height() - 1, seed.x, seed.y));
  }
  TraceWriter writer(recording);
  describe(writer.trace(), subject, arguments);
  FillTeller teller(writer, subject, method, arguments.window("window"));
  const auto fill = method == "recursive"        ? fill_recursively
                    : method == "unchecked_seed" ? fill_unchecked
                                                 : fill_rightly;
  const Outcome outcome = fill(subject, arguments, teller);
  Trace trace = std::move(writer).finish();
  trace.result = outcome.counts;
  if (subject.is_maze) trace.result.push_back({"maze", filled_maze(outcome.image)});
  trace.telling = middle_step(trace);
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "flood_fill",
      .title = Wording().say("flood_fill.title"),
      .chapter = "scan_conversion",
      .aliases = {"fill", "bucket fill", "seed fill", "paint bucket"},
      .summary = "paint everything that is connected to a seed",
      .methods = all_methods(),
      .default_method = "span",
      .parameters =
          {{"maze", ParameterType::maze, std::string(example_maze), "maze.txt",
            "what to fill: a text file, - or rows joined by /; # wall, . free, letters are colours"},
           {.name = "image",
            .type = ParameterType::picture,
            .default_value = "",
            .example = "photo.png",
            .help = "what to fill instead: a PNG file",
            .instead_of = "maze"},
           {"at", ParameterType::cell, "1,1", "3,4", "seed: column,row from the top left"},
           {"paint", ParameterType::paint, "", "#d55e00",
            "what to paint with: a colour, #0072b2 if not given; in a maze a letter, x if not given"},
           {"tolerance", ParameterType::integer, "0", "12",
            "by how much each channel may differ from the seed's, 0 to 255", 0, 255},
           {"connectivity",
            ParameterType::choice,
            "4",
            "8",
            "neighbours of a pixel: 4 or 8",
            INT32_MIN,
            INT32_MAX,
            {"4", "8"}},
           {"window", ParameterType::window, "", "2,1,6,5",
            "fill only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"}},
      .examples = {"--at 1,1 --method depth_first", "--maze '#####/#...#/#.#.#/#...#/#####' --at 2,1",
                   "--image photo.png --at 40,30 --paint '#d55e00' --tolerance 12"},
      .run = run};
  return topic;
}

}  // namespace gradus::flood_fill
