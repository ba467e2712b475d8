// The story of a line: which pixel comes next, and why.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stories/scan_conversion/bresenham_line/checking.hpp"
#include "stories/scan_conversion/bresenham_line/dda_story.hpp"
#include "stories/scan_conversion/bresenham_line/drawing.hpp"

namespace gradus::bresenham_line {
namespace {

constexpr auto drop = [](ivec2) {};

// --- The integer methods

/// Which run is told: the right one and its jump into a window, a listing of the notes, or the one of these
/// whose decisions follow a misprint.
enum class Way { right, faulty, misprinted };

class DecisionStory {
 public:
  DecisionStory(const Words& words, const Line& line, Way way) : words_(words), line_(line), way_(way) {}

  void show(Board& board, const Started& s) {
    size_ = {s.dx, s.dy};
    stand(s.from, s.p);
    board.milestone(s.from);
    board.plot(s.from, Role::current);
  }
  Event say(const Started& s) const {
    return standing({.text = steep(s.from, s.to) ? "started_steep" : "started",
                     .facts = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}, {"p", s.p}},
                     .words = {{"dx_factor", figure_factor(s.dx)}, {"dy_factor", figure_factor(s.dy)}}});
  }

  /// The run goes on in the middle: pixels before are drawn, as far back as a view can reach.
  void show(Board& board, const Jumped& j) {
    k_ = j.shown.first;
    stand(j.pixel, j.p);
    if (k_ == 0) return;
    board.skip_to(step_of(line_, k_));
    board.milestone(j.pixel);
    for (std::int64_t k = std::max<std::int64_t>(0, k_ - 100); k < k_; ++k) {
      board.put(pixel_at(line_.from, line_.to, k), Role::past);
    }
    board.plot(j.pixel, Role::current);
  }
  Event say(const Jumped& j) const {
    return standing({.text = "jumped", .facts = {{"pixel", j.pixel}, {"p", j.p}}, .words = {{"k", k_}}});
  }

  void show(Board& board, const Compared& c) {
    compared_ = c;
    const dvec2 straight = dvec2(c.pixel) + dvec2(c.moves.straight);
    const dvec2 diagonal = dvec2(c.pixel) + dvec2(c.moves.diagonal);
    board.detail(c.pixel);
    for (const dvec2 at : {straight, diagonal}) {
      if (board.holds(at)) board.look_at(ivec2(at), Role::candidate);
    }
    mark_midpoint(board);
    board.mark("straight name", Role::candidate, Label{straight, named(true)});
    board.mark("diagonal name", Role::candidate, Label{diagonal, named(false)});
  }
  Event say(const Compared& c) const {
    return {.text = "compared",
            .facts = {{"pixel", c.pixel}, {"p", c.p}, {"straight", c.straight}},
            .words = {{"straight", named(true)},
                      {"diagonal", named(false)},
                      {"test", test()},
                      {"reason", reason()}},
            .read = read(k_),
            .key = pixel_key(c.pixel),
            .decides = decision()};
  }

  void show(Board& board, const Stepped& s) {
    ++k_;
    stand(s.pixel, s.p);
    board.milestone(s.pixel);
    const dvec2 other = dvec2(s.from) + dvec2(move(!s.straight));
    if (board.holds(other)) {
      board.look_at(ivec2(other), Role::rejected);
      board.mark("rejected name", Role::rejected,
                 Label{other, words_.say("rejected", {{"step", named(!s.straight)}})});
    }
    mark_midpoint(board);
    board.plot(s.pixel, Role::current);
    board.mark("chosen name", Role::current,
               Label{dvec2(s.pixel), words_.say("chosen", {{"step", named(s.straight)}})});
    measure(board, s.pixel);
  }
  Event say(const Stepped& s) const {
    return standing({.text = "stepped",
                     .facts = {{"from", s.from, "pixel"},
                               {"pixel", s.pixel},
                               {"p_before", s.p_before, "p"},
                               {"p", s.p},
                               {"straight", s.straight}},
                     .words = {{"test", test()},
                               {"reason", reason()},
                               {"step", named(s.straight)},
                               {"update", update(s)}},
                     .read = read(k_ - 1),
                     .decides = decision()});
  }

  void show(Board& board, const Finished&) {
    if (way_ == Way::right && k_ < line_.shown.last) return;  // only a part was watched
    board.detail(pixel_);
    board.all_plotted(Role::result);
  }
  Event say(const Finished& f) const {
    Event event{.text = "missed", .facts = {{"pixels", f.pixels}}};
    if (f.pixels == 0) return event;
    event.text = way_ == Way::right ? "done" : "went_wrong";
    event.words = {{"from", line_.from}, {"to", line_.to}, {"last", pixel_}};
    event.count = f.pixels;
    return event;
  }

 private:
  void stand(ivec2 pixel, std::int64_t p) {
    pixel_ = pixel;
    p_ = p;
  }
  /// Where the line stands now: what the step is about, and a row of its own.
  Event standing(Event event) const {
    event.key = pixel_key(pixel_);
    event.row = {k_, pixel_.x, pixel_.y, p_};
    return event;
  }
  /// The row in which the last test was read.
  std::vector<Said> read(std::int64_t k) const {
    const Compared& c = compared_;
    return {k, c.pixel.x, c.pixel.y, c.p, words_.say(fmt::format("sign.{}", sign())), named(c.straight)};
  }

  ivec2 move(bool straight) const { return straight ? compared_.moves.straight : compared_.moves.diagonal; }
  /// What the reader calls that move.
  std::string named(bool straight) const { return words_.move(move(straight)); }
  std::string_view sign() const {
    return compared_.p < 0 ? "negative" : compared_.p > 0 ? "positive" : "zero";
  }
  std::string test() const { return words_.say(fmt::format("test.{}", sign()), {{"p", compared_.p}}); }
  /// What the sign of p says of the line and the midpoint, be it true or not.
  std::string reason() const {
    if (compared_.p == 0 && way_ == Way::faulty) return words_.say("reason.aside");
    if (compared_.p == 0)
      return words_.say(compared_.moves.straight.x == 0 ? "reason.smaller_x" : "reason.smaller_y");
    const ivec2 aside = compared_.moves.diagonal - compared_.moves.straight;
    const ivec2 side = compared_.p < 0 ? -aside : aside;
    const std::string where = words_.say(side.y > 0   ? "side.above"
                                         : side.y < 0 ? "side.below"
                                         : side.x < 0 ? "side.left"
                                                      : "side.right");
    return words_.say(passes(side) ? "reason.side" : "reason.by_p", {{"side", where}});
  }
  /// Twice the midpoint between the two pixels to choose from.
  glm::i64vec2 twice_midpoint() const {
    const auto& [pixel, moves, p, straight] = compared_;
    return std::int64_t{2} * glm::i64vec2(pixel) + glm::i64vec2(moves.straight) +
           glm::i64vec2(moves.diagonal);
  }
  /// Whether the exact line passes the midpoint on this side: seen from the line, they lie on opposite ones.
  bool passes(ivec2 side) const {
    const auto cross = [](glm::i64vec2 a, glm::i64vec2 b) {
      return int128_t{a.x} * b.y - int128_t{a.y} * b.x;
    };
    const glm::i64vec2 from(line_.from), way = glm::i64vec2(line_.to) - from;
    return cross(way, twice_midpoint() - std::int64_t{2} * from) * cross(way, glm::i64vec2(side)) < 0;
  }
  void mark_midpoint(Board& board) const {
    const dvec2 midpoint = 0.5 * dvec2(twice_midpoint());
    if (!board.holds(midpoint)) return;
    board.mark("midpoint", Role::boundary, Dot{midpoint, true});
    board.mark("midpoint name", Role::boundary, Label{midpoint, words_.say("midpoint")});
  }
  Decision decision() const {
    return {words_.say("question", {{"p", compared_.p}}),
            {named(true), named(false)},
            compared_.straight ? 0u : 1u,
            compared_.straight ? "straight" : "diagonal"};
  }
  /// "−1 + 2·3 = 5"
  std::string update(const Stepped& s) const {
    const std::string before = figure_number(s.p_before), after = figure_number(s.p);
    const std::string dx = figure_number(size_.dx), dy = figure_number(size_.dy);
    if (way_ == Way::misprinted) {
      return fmt::format("{} + 2·{} − {}{} = {}", before, dy, s.straight ? "" : "3·", dx, after);
    }
    if (s.straight) return fmt::format("{} + 2·{} = {}", before, figure_factor(size_.dy), after);
    return fmt::format("{} + 2·({} − {}) = {}", before, dy, dx, after);
  }

  /// A fraction of dx, as such where it is short.
  std::string error_text(std::int64_t miss) const {
    constexpr std::int64_t most = 1000;
    if (size_.dx < most) return figure_fraction(miss, size_.dx);
    return fmt::format("≈ {:.3f}", static_cast<double>(miss) / static_cast<double>(size_.dx));
  }
  /// The distance from the pixel's centre to the exact line, along the axis that does not lead.
  void measure(Board& board, ivec2 pixel) const {
    if (way_ != Way::right || size_.dx == 0) return;
    const std::int64_t miss = miss_times_dx(line_, pixel, k_);
    if (miss == 0) return;
    const dvec2 at(pixel), ideal = ideal_at(line_, k_);
    board.mark("error", Role::measure, Stroke{at, ideal});
    // In a large pixel the fraction stands at its tick, on the side where the line goes away from it
    const dvec2 along(line_.go.straight), aside(line_.go.diagonal - line_.go.straight);
    const double ahead = glm::dot(ideal - at, aside) > 0 ? 1 : -1;
    if (size_.dx <= (along.x == 0 ? 5 : 7))
      return board.mark(
          "error name", Role::measure,
          Text{along.x == 0 ? at - 0.27 * ahead * aside : 0.5 * (at + ideal) + 0.26 * ahead * along,
               error_text(miss)});
    board.mark("error name", Role::measure,
               Label{0.5 * (at + ideal), words_.say("error", {{"error", error_text(miss)}})});
  }

  const Words& words_;
  const Line line_;
  const Way way_;
  Extent size_{};
  ivec2 pixel_{};
  std::int64_t p_ = 0, k_ = 0;
  Compared compared_{};
};

// --- Whole runs at once

class RunStory {
 public:
  RunStory(const Words& words, const Line& line) : words_(words), line_(line) {}

  void show(Board& board, const RunsStarted& s) {
    shortest_ = s.shortest;
    board.milestone(s.from);
  }
  Event say(const RunsStarted& s) const {
    Event event{.text = "run_lengths",
                .facts = {{"from", s.from},
                          {"to", s.to},
                          {"dx", s.dx},
                          {"dy", s.dy},
                          {"shortest", s.shortest, "count"}},
                .key = pixel_key(s.from),
                .phase = words_.shared("words", "set_up")};
    if (s.dy == 0) {
      event.text = "single_run";
      event.count = s.dx + 1;
    } else {
      event.words = {{"longer", s.shortest + 1}, {"rest", s.dx % s.dy}};
    }
    return event;
  }

  void show(Board& board, const RunEmitted& r) {
    ++runs_;
    total_ += r.count;
    board.milestone(r.start);
    for (std::int64_t i = 0; i < r.count; ++i) board.plot(place(r.start, r.moves, i, 0), Role::current);
  }
  Event say(const RunEmitted& r) const {
    return {.text = last() ? "last_run" : "inner_run",
            .facts = {{"start", r.start, "pixel"}, {"count", r.count}},
            .words = {{"run", runs_}, {"step", words_.move(r.moves.diagonal)}},
            .count = r.count,
            .row = {runs_, r.start.x, r.start.y, r.count, total_},
            .key = pixel_key(r.start),
            .decides = decision(r)};
  }

  void show(Board& board, const Finished&) {
    board.detail(line_.to);
    board.all_plotted(Role::result);
  }
  Event say(const Finished& f) const {
    return {.text = "runs_done",
            .facts = {{"pixels", f.pixels}},
            .words = {{"in_runs", words_.count("in_runs", runs_)}},
            .count = f.pixels};
  }

 private:
  bool last() const { return total_ == line_.size.dx + 1; }
  /// The first run and the last one are as long as the ends let them be.
  std::optional<Decision> decision(const RunEmitted& r) const {
    if (runs_ == 1 || last()) return std::nullopt;
    const bool is_short = r.count == shortest_;
    return Decision{words_.say("question_run", {{"run", runs_}}),
                    {figure_number(shortest_), figure_number(shortest_ + 1)},
                    is_short ? 0u : 1u,
                    is_short ? "short" : "long"};
  }

  const Words& words_;
  const Line line_;
  std::int64_t shortest_ = 0, total_ = 0, runs_ = 0;
};

// --- The methods

/// What is drawn of a line that a method walks all of.
Line walked(Narrator& narrator) {
  const Line line = line_of(narrator.arguments());
  if (line.size.dx > longest_watched) {
    refuse(narrator.arguments(), {"to", "from"},
           fmt::format("method {} is watched from its start, so at most {} pixels: this line has {}",
                       narrator.method().name, longest_watched + 1, line.size.dx + 1));
  }
  draw_line(narrator, line);
  narrator.result({{"count", line.size.dx + 1}});
  return line;
}

/// Of a line that starts in the middle only the part that is kept.
void tell_part(Narrator& narrator, const Line& line) {
  narrator.list("in_window", "bresenham_line_window.hpp");
  narrator.retitle(line.window ? "in_window" : "jumped_to_part");
  DecisionStory story(narrator.words(), line, Way::right);
  const Stretch shown = line.shown;
  if (shown.empty()) {
    return in_window(line.from, line.to, *line.window, drop, narrator.watcher(story));
  }
  const Recording& recording = narrator.recording();
  const std::int64_t first = std::clamp(recording.first - step_of(line, 0), shown.first, shown.last);
  const std::int64_t last = std::min(shown.last, first + recording.most / 2);
  const Window part = window_around(pixel_at(line.from, line.to, first), pixel_at(line.from, line.to, last));
  in_window(line.from, line.to, part, drop, narrator.watcher(story));
  narrator.skip_to(step_of(line, shown.last) + 1);
}

void tell_decision(Narrator& narrator) {
  const Line line = line_of(narrator.arguments());
  draw_line(narrator, line);
  narrator.result({{"count", std::max<std::int64_t>(0, line.shown.last - line.shown.first + 1)}});
  if (jumps(line)) return tell_part(narrator, line);
  DecisionStory story(narrator.words(), line, Way::right);
  decision_parameter(line.from, line.to, drop, narrator.watcher(story));
}

void tell_runs(Narrator& narrator) {
  const Line line = walked(narrator);
  narrator.columns({{"run"}, {"x"}, {"y"}, {"count"}, {"pixels_so_far"}});
  RunStory story(narrator.words(), line);
  run_length(line.from, line.to, [](ivec2, std::int64_t) {}, narrator.watcher(story));
}

/// Three arithmetics side by side have a table, a result and a telling step of their own.
void tell_dda(Narrator& narrator) {
  const Line line = walked(narrator);
  narrator.columns({{"k"}, {"offset"}, {"row"}, {"x"}, {"y"}, {"right", false}});
  narrator.legend({Role::past, Role::current, Role::accepted, Role::result, {Role::measure, "sum"}});
  DdaStory story(narrator.words(), line);
  dda<float>(line.from, line.to, drop, narrator.watcher(story));
  const auto wrong = story.first_wrong();
  if (wrong) narrator.trace().faulty = narrator.words().say("drift", {{"k", *wrong}});
  if (side_by_side(narrator.arguments())) {
    narrator.result({});
  } else if (wrong && has_step(narrator.trace(), {*wrong, 0})) {
    narrator.telling({*wrong, 0});
  }
  tell_side_by_side<DdaNumbers>(
      narrator, [line]<class T>(T, const auto& observer) { dda<T>(line.from, line.to, drop, observer); },
      ToldIn::floats);
}

/// A listing of the notes.
template <Way way, auto listing>
void tell_notes(Narrator& narrator) {
  const Line line = walked(narrator);
  DecisionStory story(narrator.words(), line, way);
  listing(line.from, line.to, drop, narrator.watcher(story));
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  const auto faulty = [](std::string name, void (*tell)(Narrator&)) {
    return Method{.name = std::move(name), .standing = Standing::faulty, .tell = tell, .without = {"window"}};
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "bresenham_line",
       .chapter = "scan_conversion",
       .aliases = {"line", "line drawing", "midpoint line", "dda"},
       .summary = "the pixels nearest to a straight line, with integer additions only",
       .methods = {{.name = "decision_parameter", .standing = Standing::taught, .tell = tell_decision},
                   {.name = "run_length",
                    .standing = Standing::fast,
                    .tell = tell_runs,
                    .function = "emit_runs",
                    .file = "bresenham_line_batch.hpp",
                    .without = {"window"}},
                   {.name = "dda", .tell = tell_dda, .without = {"window"}, .exact = true},
                   faulty("first_octant", tell_notes<Way::faulty, [](auto... run) { first_octant(run...); }>),
                   faulty("swapped_ends", tell_notes<Way::faulty, [](auto... run) { swapped_ends(run...); }>),
                   faulty("misprinted_derivation",
                          tell_notes<Way::misprinted, [](auto... run) { misprinted_derivation(run...); }>)},
       .columns = {{"k"}, {"x"}, {"y"}, {"p"}, {"test", false}, {"step", false}},
       .counts = {"Compared", "Divided", "Added", "Rounded", "RunEmitted"},
       .parameters = {{"from", ParameterType::cell, "0,0", "0,0", "first pixel: column,row; y points up"},
                      {"to", ParameterType::cell, "7,3", "7,3", "last pixel"},
                      {"window", ParameterType::window, "", "0,0,15,9",
                       "draw only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"},
                      exact_parameter()},
       .examples = {"--from 0,0 --to 7,3", "--from 2,5 --to -3,-4", "--from 0,0 --to 9,4 --method dda"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bresenham_line
