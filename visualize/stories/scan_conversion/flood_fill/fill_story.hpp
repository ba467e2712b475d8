#pragma once
// The steps of a fill: which pixel is painted next, and what still waits.

#include "scan_conversion/flood_fill/flood_fill_notes.hpp"
#include "stories/scan_conversion/flood_fill/shelf.hpp"
#include "stories/scan_conversion/flood_fill/subject.hpp"
#include "stories/telling.hpp"

namespace gradus::flood_fill {

/// How far outside the picture a seed is drawn, in cells.
constexpr int margin = 2;

/// What the number in a painted cell of a maze counts.
enum class Counts { order, distance, calls };
constexpr std::string_view name_of(Counts counts) {
  constexpr std::array<std::string_view, 3> names{"order", "distance", "calls"};
  return names[static_cast<std::size_t>(counts)];
}

/// How a method is told.
struct Way {
  std::string_view waiting;  ///< the method whose words say what holds the pixels that wait
  std::string_view column;   ///< of their number in the table; spans have a table of their own
  Counts counts = Counts::order;
  std::string_view framed = "measure";  ///< what the frame is, for the legend

  constexpr bool calls() const { return counts == Counts::calls; }
  constexpr bool queue() const { return counts == Counts::distance; }
};
constexpr Way on_path{"depth_first", "path"}, in_queue{"breadth_first", "queue", Counts::distance},
    as_spans{"span", ""}, as_calls{"recursive", "calls", Counts::calls},
    unchecked{"breadth_first", "queue", Counts::distance, "picture"};

/// The outline of a window's cells.
inline Path border(const Window& w) {
  return {gradus::Extent{dvec2(w.lower) - 0.5, dvec2(w.upper) + 0.5}.corners(), true};
}

/// The picture's cells, and those up to a seed a little outside a maze.
inline Window fill_cells(const Subject& subject) {
  const Window cells = subject.image().window();
  const Window around{cells.lower - margin, cells.upper + margin};
  if (!subject.is_maze || !around.contains(subject.seed)) return cells;
  return {glm::min(cells.lower, subject.seed), glm::max(cells.upper, subject.seed)};
}

/// Rows above a maze for what waits: where all of them are drawn in cells with room for a text.
inline int shelf_rows(const Subject& subject) {
  constexpr std::int64_t most_columns = 24, most_rows = 16;
  const Window cells = fill_cells(subject);
  return subject.is_maze && cells.width() <= most_columns && cells.height() <= most_rows ? Shelf::rows : 0;
}

/// The cells that are drawn.
inline Window shown_cells(const Subject& subject) {
  Window cells = fill_cells(subject);
  cells.lower.y -= shelf_rows(subject);
  return cells;
}

/// Whether a fill in waves colours an image by the distance from the seed: where it is not too large for
/// that.
inline bool shows_waves(const Subject& subject, const Way& way) {
  constexpr std::int64_t most_pixels = std::int64_t{1} << 22;
  const Image& image = subject.image();
  return !subject.is_maze && way.queue() && std::int64_t{image.width()} * image.height() <= most_pixels;
}

/// "above (3, 4)": where a neighbour lies, rows counting downwards.
inline std::string place(const Words& words, ivec2 from, ivec2 to) {
  constexpr std::string_view keys[3][3] = {{"place.above_left", "place.above", "place.above_right"},
                                           {"place.left", "place.same", "place.right"},
                                           {"place.below_left", "place.below", "place.below_right"}};
  const ivec2 way = glm::clamp(to - from, -1, 1);
  return words.say(keys[way.y + 1][way.x + 1], {{"pixel", from}});
}

/// A pixel painted is a milestone, as is a span; looking is finer.
class Story {
 public:
  /// paint: what the pixels of an image become.
  Story(const Words& words, const Subject& subject, const Way& way, Rgba8 paint)
      : words_(words), subject_(subject), way_(way), paint_(paint) {
    if (shows_waves(subject, way))
      waves_ = Raster<std::int32_t>(subject.image().width(), subject.image().height());
    if (!subject.is_maze) return;
    numbers_ = Raster<std::int64_t>(subject.image().width(), subject.image().height(), none);
    if (shelf_rows(subject) == 0) return;
    const Window cells = shown_cells(subject);
    // A pixel's column and row, or the row alone of a span that is to be looked at
    const std::string row = fmt::format("{}", cells.upper.y);
    const std::string entry = way.column.empty() ? row : fmt::format("{},{}", cells.upper.x, row);
    shelf_ = Shelf(cells.lower, static_cast<int>(cells.width()), entry.size(), way.queue(),
                   words.say(fmt::format("next.{}", way.waiting)));
  }
  /// The pixels painted, in order, as far as a trace keeps steps.
  const std::vector<ivec2>& pixels() const { return pixels_; }
  const Subject& subject() const { return subject_; }

  void show(Board& board, const Started& s) {
    board.milestone(s.seed);
    set_up(board);
  }
  Event say(const Started& s) const {
    return {
        .text = s.inside ? "started" : "nothing_to_do",
        .facts = {{"seed", s.seed}, {"connectivity", static_cast<int>(s.connectivity)}, {"inside", s.inside}},
        .key = pixel_key(s.seed),
        .decides = is_free(s.seed, s.inside)};
  }

  /// The notes' listing reads the seed wherever it lies: the picture's border and what is read are shown.
  void show(Board& board, const SeedRead& s) {
    read_ = s;
    board.milestone(cell_of(s.seed));
    set_up(board);
    if (on_grid(s.seed)) return;
    board.keep("picture", Role::measure, border(subject_.image().window()));
    if (!s.lands) return;
    board.keep("lands", Role::input, Stroke{dvec2(s.seed), dvec2(*s.lands), true, true});
    board.keep("lands name", Role::input, Label{dvec2(*s.lands), words_.say("read_here")});
  }
  Event say(const SeedRead& s) const {
    Event event{.text = on_grid(s.seed) ? "seed_read.inside"
                        : s.lands       ? "seed_read.elsewhere"
                                        : "seed_read.nowhere",
                .facts = {{"seed", s.seed}, {"index", s.index}},
                .words = {{"row", figure_factor(s.seed.y)},
                          {"column", figure_factor(s.seed.x)},
                          {"width", subject_.image().width()},
                          {"cells", subject_.image().cells().size()}},
                .key = pixel_key(s.seed),
                .phase = words_.shared("words", "set_up")};
    if (s.lands) event.facts.push_back({"lands", *s.lands, "pixel"});
    return event;
  }

  void show(Board& board, const Painted& p) {
    const ivec2 cell = cell_of(p.pixel);
    board.milestone(cell);
    remove_names(board);
    retire(board);
    leaks_ = leaks(cell.y, cell.x, cell.x);
    if (leaks_) board.tells(1);
    ++painted_;
    if (waves_.contains(cell) && waves_.contains(p.from) && p.from != p.pixel)
      waves_[cell] = waves_[p.from] + 1;
    number(board, cell,
           way_.calls()    ? static_cast<std::int64_t>(p.waiting)
           : !way_.queue() ? painted_
                           : distance(p));
    put(board, cell, Role::current);
    current_ = cell;
    current_waits_ = true;
    note(cell);
    shelf_.push(board, fmt::format("{},{}", cell.x, cell.y));
  }
  Event say(const Painted& p) const {
    const bool seed = p.from == p.pixel;
    const ivec2 cell = cell_of(p.pixel);
    Event event{
        .text = leaks_            ? "painted.leak"
                : !seed           ? "painted.next"
                : cell == p.pixel ? "painted.seed"
                                  : "painted.elsewhere",
        .facts = {{"from", p.from, "pixel"}, {"pixel", p.pixel}, waiting(p.waiting)},
        .words = {{"place", place(words_, p.from, p.pixel)}, {"cell", cell}, {"holds", holds(p.waiting)}},
        .row = {painted_, cell.x, cell.y, seed ? Said(words_.say("seed")) : Said(p.from)},
        .decides = is_free(p.pixel, true)};
    if (way_.queue() && subject_.is_maze) event.row.push_back(distance(p));
    if (way_.queue() && subject_.is_maze && !seed && !leaks_) {
      event.text = "painted.wave";
      event.count = distance(p);
    }
    event.row.push_back(p.waiting);
    return filling(cell, std::move(event));
  }

  void show(Board& board, const Examined& e) {
    board.detail(cell_of(e.from));
    if (on_grid(e.pixel)) point_at(board, dvec2(e.pixel), e.inside);
  }
  Event say(const Examined& e) const {
    return filling(e.pixel, {.text = e.inside ? "examined.free" : why_not(e.pixel),
                             .facts = {{"from", e.from, "pixel"}, {"pixel", e.pixel}, {"inside", e.inside}},
                             .words = {{"place", place(words_, e.from, e.pixel)}},
                             .decides = is_free(e.pixel, e.inside)});
  }

  void show(Board& board, const Retreated& r) {
    board.detail(r.pixel);
    put(board, r.pixel, Role::past);
    if (current_ == r.pixel) current_.reset();
    shelf_.take(board);
  }
  Event say(const Retreated& r) const {
    return filling(r.pixel, {.text = way_.calls() ? "call_returned" : "retreated",
                             .facts = {{"pixel", r.pixel}, waiting(r.waiting)},
                             .words = {{"holds", holds(r.waiting)}},
                             .decides = yes_or_no(words_, "question_neighbour", {{"pixel", r.pixel}}, false,
                                                  "", "back")});
  }

  void show(Board& board, const Dequeued& d) {
    const ivec2 cell = cell_of(d.pixel);
    board.detail(cell);
    retire(board);
    put(board, cell, Role::current);
    current_ = cell;
    current_waits_ = false;
    shelf_.take(board);
  }
  Event say(const Dequeued& d) const {
    return filling(cell_of(d.pixel), {.text = "dequeued",
                                      .facts = {{"pixel", d.pixel}, waiting(d.waiting)},
                                      .count = static_cast<std::int64_t>(d.waiting)});
  }

  void show(Board& board, const SpanFilled& s) {
    board.milestone(s.found);
    remove_names(board);
    retire_run(board);
    focus_ = s.found;
    way_filled_ = s.span.way;
    leaks_ = leaks(s.span.row, s.span.left, s.span.right);
    // The run's figure is of a leak, else of a long run, rather a late one
    constexpr double longest = 1e10;
    if (subject_.is_maze)
      board.tells((leaks_ ? longest : static_cast<double>(s.span.length())) +
                  1e-6 * static_cast<double>(spans_));
    ++spans_;
    painted_ += s.span.length();
    for (int x = s.span.left; x <= s.span.right; ++x) {
      run_.push_back({x, s.span.row});
      number(board, run_.back(), spans_);
      put(board, run_.back(), Role::current);
      note(run_.back());
    }
  }
  Event say(const SpanFilled& s) const {
    std::vector<Field> facts = ends_of(s.span);
    facts.push_back({"found", s.found, "pixel"});
    return filling(s.found,
                   {.text = leaks_                 ? "span_leaked"
                            : s.span.length() == 1 ? "pixel_filled"
                                                   : "span_filled",
                    .facts = facts,
                    .words = {{"columns", columns_of(s.span)}},
                    .row = {spans_, s.span.row, s.span.left, s.span.right, s.span.length(), painted_},
                    .decides = is_free(s.found, true)});
  }

  void show(Board& board, const SpanQueued& s) {
    board.detail({s.span.left, s.span.row});
    if (numbers_.cells().empty()) return board.mark("waiting span", Role::candidate, arrow_from(s.span));
    board.keep(arrow_id(s.waiting), Role::candidate, arrow_from(s.span));
    shelf_.push(board, fmt::format("{}", s.span.row + s.span.way));
  }
  Event say(const SpanQueued& s) const {
    Event event{.text = "span_queued", .words = {{"holds", holds(s.waiting)}}};
    const bool back = spans_ > 1 && s.span.way != way_filled_;  // to the row that it was reached from
    if (back) event.decides = yes_or_no(words_, "question_span", {}, true, "beyond");
    return beside(s.span, s.waiting, std::move(event));
  }

  void show(Board& board, const SpanTaken& s) {
    board.detail({s.span.left, s.span.row});
    retire_run(board);
    board.mark("taken span", Role::current, arrow_from(s.span));
    if (numbers_.cells().empty()) return;
    board.remove(arrow_id(s.waiting + 1));
    shelf_.take(board);
  }
  Event say(const SpanTaken& s) const {
    return beside(s.span, s.waiting, {.text = "span_taken", .count = static_cast<std::int64_t>(s.waiting)});
  }

  void show(Board& board, const Returned&) { show_result(board); }
  Event say(const Returned& r) const {
    return {.text = "returned",
            .facts = {{"painted", r.depth.painted}, {"peak_calls", r.depth.peak, "calls"}},
            .words = {{"most", r.depth.peak}},
            .count = r.depth.painted,
            .phase = words_.shared("words", "result"),
            .level = Level::idea};
  }

  void show(Board& board, const Finished&) { show_result(board); }
  Event say(const Finished& f) const {
    const Filled& filled = f.filled;
    return {
        .text = "finished",
        .facts = {{"painted", filled.painted},
                  {"peak_waiting", std::int64_t(filled.peak_waiting), "waiting"},
                  {"peak_bytes", std::int64_t(filled.peak_bytes), "bytes"}},
        .words = {{"held", words_.say(fmt::format("held.{}", way_.waiting), {{"most", filled.peak_waiting}})},
                  {"bytes", filled.peak_bytes}},
        .count = filled.painted};
  }

  // What remains of a step when the recording is full: pictures have far more pixels than it has steps

  void count(Board& board, const Painted& p) {
    ++painted_;
    note(cell_of(p.pixel));
    board.count_milestone();
  }
  void count(Board& board, const SpanFilled& s) {
    painted_ += s.span.length();
    for (int x = s.span.left; x <= s.span.right && has_room(); ++x) note({x, s.span.row});
    board.count_milestone();
  }
  template <class Finer>
  void count(Board&, const Finer&) {}

 private:
  /// Where in the picture a pixel is painted: a seed outside lies in another row's memory.
  ivec2 cell_of(ivec2 p) const { return read_ && read_->lands && p == read_->seed ? *read_->lands : p; }
  bool on_grid(ivec2 p) const { return subject_.image().contains(p); }

  bool has_room() const { return std::ssize(pixels_) < Recording::default_most; }
  void note(ivec2 p) {
    if (has_room()) pixels_.push_back(p);
  }

  // What is said

  Event filling(ivec2 about, Event event) const {
    event.key = pixel_key(about);
    event.phase = words_.say("filling");
    return event;
  }
  /// Of a span whose row beside it is to be looked at.
  Event beside(const Span& s, std::size_t n, Event event) const {
    event.facts = ends_of(s);
    event.facts.insert(event.facts.end(), {{"way", s.way}, waiting(n)});
    event.words.insert(event.words.end(),
                       {{"row", figure_number(s.row + s.way)}, {"columns", columns_of(s)}});
    return filling({s.left, s.row}, std::move(event));
  }
  Field waiting(std::size_t n) const { return {way_.calls() ? "calls" : "waiting", std::int64_t(n)}; }
  /// What holds the pixels that wait, and how many.
  std::string holds(std::size_t n) const {
    return words_.say(fmt::format("holds.{}", way_.waiting), {{"waiting", n}});
  }
  std::string_view why_not(ivec2 p) const {
    if (!on_grid(p)) return "examined.outside";
    return subject_.is_maze && subject_.maze[p] == wall ? "examined.wall" : "examined.other";
  }
  Decision is_free(ivec2 p, bool free) const {
    return yes_or_no(words_, "question", {{"pixel", p}}, free, "inside", "outside");
  }
  /// "column 5", "columns 3 to 6".
  std::string columns_of(const Span& s) const {
    return words_.count("columns", s.length(), {{"left", s.left}, {"right", s.right}});
  }
  static std::vector<Field> ends_of(const Span& s) {
    return {{"row", s.row}, {"left", s.left}, {"right", s.right}};
  }

  // What is drawn

  void set_up(Board& board) {
    if (subject_.is_maze) put_maze(board);
    if (subject_.window) board.keep("window", Role::measure, border(*subject_.window));
    const ivec2 seed = subject_.seed;
    focus_ = cell_of(seed);
    if (!shown_cells(subject_).contains(seed)) return;
    if (subject_.is_maze) board.keep("seed frame", Role::input, border({seed, seed}));
    board.keep("seed", Role::input, Dot{dvec2(seed)});
    board.keep("seed name", Role::input, Label{dvec2(seed), words_.say("seed")});
  }
  /// What a maze shows behind all steps: its walls and letters.
  void put_maze(Board& board) const {
    const Maze& maze = subject_.maze;
    for (ivec2 p{0, 0}; p.y < maze.height(); ++p.y) {
      for (p.x = 0; p.x < maze.width(); ++p.x) {
        if (maze[p] == wall) board.put(p, Role::boundary);
        if (is_color(maze[p])) board.put(p, Role::input, std::string(1, maze[p]));
      }
    }
  }
  void remove_names(Board& board) const {
    if (painted_ > 0) return;
    board.remove("seed name");
    board.remove("lands name");
  }
  void show_result(Board& board) {
    board.detail(focus_);
    if (!subject_.is_maze) {
      retire(board);
      return retire_run(board);
    }
    if (painted_ > Recording::default_most) return;
    for (const ivec2 p : pixels_) put(board, p, Role::result);
  }

  /// The painted cells of a maze bear a number; of an image they have their new colour, once nothing waits
  /// there.
  void put(Board& board, ivec2 p, Role role) const {
    const std::int64_t number = numbers_.contains(p) ? numbers_[p] : none;
    const bool painted = !subject_.is_maze && role == Role::past;
    board.put(p, role, number == none ? "" : figure_number(number),
              painted ? std::optional(paint_at(p)) : std::nullopt);
  }
  /// In waves it gets lighter for 32 moves away from the seed, then darker again.
  Rgba8 paint_at(ivec2 p) const {
    if (!waves_.contains(p)) return paint_;
    constexpr int half = 32, most = 43;  // at the lightest three quarters are white
    const int part = half - std::abs(waves_[p] % (2 * half) - half);
    const auto lighter = [&](std::uint8_t c) {
      return static_cast<std::uint8_t>(c + (255 - c) * part / most);
    };
    return {lighter(paint_.r), lighter(paint_.g), lighter(paint_.b), 255};
  }
  void number(Board& board, ivec2 cell, std::int64_t value) {
    if (!numbers_.contains(cell)) return;
    numbers_[cell] = value;
    if (cell == subject_.seed) board.remove("seed");  // the number stands where the dot was
  }
  /// Whether what is to be painted in a row of a maze touches what is painted at corners alone.
  bool leaks(int row, int left, int right) const {
    const auto is_painted = [&](int x, int y) {
      return numbers_.contains({x, y}) && numbers_[{x, y}] != none;
    };
    bool beside =
        painted_ == 0 || numbers_.cells().empty() || is_painted(left - 1, row) || is_painted(right + 1, row);
    for (int x = left; x <= right; ++x) beside = beside || is_painted(x, row - 1) || is_painted(x, row + 1);
    return !beside;
  }
  /// In moves, from the seed.
  std::int64_t distance(const Painted& p) const {
    const ivec2 from = cell_of(p.from);
    return p.from == p.pixel || !numbers_.contains(from) ? 0 : numbers_[from] + 1;
  }
  /// The pixel painted last is one of those that wait, from now on.
  void retire(Board& board) const {
    if (current_) put(board, *current_, current_waits_ ? Role::candidate : Role::past);
  }
  void retire_run(Board& board) {
    for (const ivec2 p : run_) put(board, p, Role::past);
    run_.clear();
  }

  /// Shows what was looked at without changing how its cell looks.
  static void point_at(Board& board, dvec2 at, bool free) {
    if (free) return board.mark("looked at", Role::accepted, Dot{at, true});
    const dvec2 down{0.25, 0.25}, up{0.25, -0.25};
    board.mark("looked at", Role::rejected, Stroke{at - down, at + down});
    board.mark("looked at too", Role::rejected, Stroke{at - up, at + up});
  }
  /// From a span into the row beside it.
  static Stroke arrow_from(const Span& s) {
    const double middle = (s.left + s.right) / 2.0;
    return {{middle, s.row + 0.3 * s.way}, {middle, s.row + 0.95 * s.way}, true};
  }
  /// Of an entry of the stack, counted from 1.
  static std::string arrow_id(std::size_t entry) { return fmt::format("waiting span {}", entry); }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  const Rgba8 paint_;
  std::int64_t painted_ = 0, spans_ = 0;
  std::vector<ivec2> pixels_;
  ivec2 focus_{};
  std::optional<ivec2> current_;
  bool current_waits_ = true;
  std::vector<ivec2> run_;
  int way_filled_ = 0;
  bool leaks_ = false;  ///< the last painted, through a gap between corners
  std::optional<SeedRead> read_;
  static constexpr std::int64_t none = -1;
  Raster<std::int32_t> waves_;    ///< moves from the seed to the pixels of an image, where waves are shown
  Raster<std::int64_t> numbers_;  ///< of each cell of a maze, as the way counts; none before it is painted
  Shelf shelf_;
};

}  // namespace gradus::flood_fill
