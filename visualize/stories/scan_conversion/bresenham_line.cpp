// The story of a line: which pixel comes next, and why.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "scan_conversion/bresenham_line/bresenham_line_batch.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_notes.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::bresenham_line {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/scan_conversion/bresenham_line/";

/// Up to this many pixels a run is watched from its start; the exact methods jump into longer ones.
constexpr std::int64_t longest_watched = 1'000'000;

struct Line {
  ivec2 from, to;
  Extent size;
  Moves go;
  std::optional<Window> window;  ///< only what lies in it is drawn
  Stretch shown;                 ///< the pixels to draw: all, or those in the window
};
Line line_of(const Arguments& arguments) {
  const ivec2 from = arguments.cell("from"), to = arguments.cell("to");
  const Extent size = extent(from, to);
  const std::optional<Window> window = arguments.window("window");
  return {from, to, size, moves(from, to), window, window ? visible(from, to, *window) : Stretch{0, size.dx}};
}

/// The number of the step that reaches pixel k: k itself, or, in a window, counted from the first visible
/// pixel, which step 1 jumps to.
std::int64_t step_of(const Line& line, std::int64_t k) {
  return line.shown.first > 0 ? k - line.shown.first + 1 : k;
}

dvec2 centre(ivec2 p) { return {p.x, p.y}; }

/// The exact line's point at the k-th pixel's place along the leading axis.
dvec2 ideal_at(const Line& line, std::int64_t k) {
  const double along = line.size.dx == 0 ? 0 : static_cast<double>(k) / static_cast<double>(line.size.dx);
  const dvec2 way{static_cast<double>(line.to.x) - line.from.x, static_cast<double>(line.to.y) - line.from.y};
  return centre(line.from) + along * way;
}

/// |ideal line - pixel| along the axis that does not lead, times dx: exact.
std::int64_t miss_times_dx(const Line& line, ivec2 p, std::int64_t k) {
  const std::int64_t row = steep(line.from, line.to) ? distance_x(line.from, p) : distance_y(line.from, p);
  const int128_t miss = int128_t{k} * line.size.dy - int128_t{row} * line.size.dx;
  return static_cast<std::int64_t>(miss < 0 ? -miss : miss);
}

/// The cells of the line, and one row more for the diagonal neighbour that is turned down at the end.
Window scene_of(const Line& line) {
  Window cells = window_around(line.from, line.to);
  const ivec2 aside = line.go.diagonal - line.go.straight;
  for (const int axis : {0, 1}) {
    if (aside[axis] > 0 && cells.upper[axis] < INT32_MAX) ++cells.upper[axis];
    if (aside[axis] < 0 && cells.lower[axis] > INT32_MIN) --cells.lower[axis];
  }
  return cells;
}

std::string ideal_name(const Wording& words, const Line& line) {
  if (line.size.dx == 0) return words.say("bresenham_line.ideal.point");
  if (line.from.x == line.to.x) {
    return words.say("bresenham_line.ideal.vertical", arg("x", figure_number(line.from.x)));
  }
  if (line.from.y == line.to.y) {
    return words.say("bresenham_line.ideal.horizontal", arg("y", figure_number(line.from.y)));
  }
  const std::int64_t dy = std::int64_t{line.to.y} - line.from.y, dx = std::int64_t{line.to.x} - line.from.x;
  const std::string sign = (dy < 0) != (dx < 0) ? "−" : "";
  const std::int64_t common = std::gcd(dy, dx), a = std::abs(dy / common), b = std::abs(dx / common);
  if (line.from == ivec2{0, 0}) {
    const std::string x = a == 1 ? words.symbol("x") : fmt::format("{}{}", a, words.symbol("x"));
    return words.say("bresenham_line.ideal.through_origin",
                     arg("slope", sign + (b == 1 ? x : fmt::format("{}/{}", x, b))));
  }
  return words.say("bresenham_line.ideal.sloped", arg("slope", sign + figure_fraction(a, b)));
}

/// What stands unchanged behind all steps.
void set_scene(Trace& trace, const Line& line) {
  const Wording& words = trace.wording;
  trace.grid.x_name = words.symbol("x");
  trace.grid.y_name = words.symbol("y");
  trace.grid.cells = line.window ? *line.window : scene_of(line);
  trace.grid.y_up = true;
  if (line.size.dx > 0) {
    trace.backdrop.push_back({"ideal line", Role::boundary, Stroke{centre(line.from), centre(line.to)}});
  }
  trace.backdrop.push_back({"from", Role::input, Dot{centre(line.from)}});
  trace.backdrop.push_back({"to", Role::input, Dot{centre(line.to)}});
  if (line.size.dx > 0) {
    trace.backdrop.push_back({"ideal line name", Role::boundary,
                              Label{ideal_at(line, line.size.dx * 5 / 6), ideal_name(words, line)}});
  }
  trace.legend = {{Role::past, words.say("bresenham_line.legend.past")},
                  {Role::current, words.say("bresenham_line.legend.current")},
                  {Role::candidate, words.say("bresenham_line.legend.candidate")},
                  {Role::rejected, words.say("bresenham_line.legend.rejected")},
                  {Role::result, words.say("bresenham_line.legend.result")},
                  {Role::measure, words.say("bresenham_line.legend.error")}};
}

/// Tells the steps of the integer methods: the taught one, the jump into a window, the notes' listings.
class DecisionTeller {
 public:
  DecisionTeller(TraceWriter& writer, const Line& line, bool faulty)
      : writer_(writer),
        words_(writer.wording()),
        line_(line),
        faulty_(faulty),
        misprinted_(writer.trace().method == "misprinted_derivation") {
    writer.trace().columns = {{"k"}, {"x"}, {"y"}, {"p"}, {"test", false}, {"step", false}};
  }

  void operator()(const Started& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    size_ = {s.dx, s.dy};
    pixel_ = s.from;
    p_ = s.p;
    Delta delta;
    delta.cells.push_back({s.from, CellLook{Role::current, ""}});
    current_ = s.from;
    writer_.step(std::move(delta), s.from, source_line, [&](TraceStep& step) {
      step.type = "Started";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(s.from);
      step.fields = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}, {"p", s.p}};
      step.sentence = words_.say("bresenham_line.started", arg("from", figure_point(s.from)),
                                 arg("dx", figure_number(s.dx)), arg("dy", figure_number(s.dy)),
                                 arg("dx_factor", figure_factor(s.dx)), arg("dy_factor", figure_factor(s.dy)),
                                 arg("p", figure_number(s.p)));
      step.row = row();
    });
    writer_.trace().pixels.push_back(s.from);
  }

  /// The run goes on in the middle: pixels before are drawn, as far back as a view can reach.
  void operator()(const Jumped& j, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    delta.cells.push_back({current_, CellLook{Role::past, ""}});
    for (std::int64_t k = std::max<std::int64_t>(0, j.shown.first - 100); k < j.shown.first; ++k) {
      delta.cells.push_back({pixel_at(line_.from, line_.to, k), CellLook{Role::past, ""}});
    }
    delta.cells.push_back({j.pixel, CellLook{Role::current, ""}});
    current_ = j.pixel;
    pixel_ = j.pixel;
    p_ = j.p;
    k_ = j.shown.first;
    if (j.shown.first == 0) return;
    writer_.skip_to(step_of(line_, j.shown.first));
    writer_.step(std::move(delta), j.pixel, source_line, [&](TraceStep& step) {
      step.type = "Jumped";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(j.pixel);
      step.fields = {{"pixel", j.pixel}, {"p", j.p}};
      step.sentence = words_.say("bresenham_line.jumped", arg("k", j.shown.first),
                                 arg("pixel", figure_point(j.pixel)), arg("p", figure_number(j.p)));
      step.row = row();
    });
    writer_.trace().pixels.push_back(j.pixel);
  }

  void operator()(const Compared& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    compared_ = c;
    Delta delta = cleared();
    const dvec2 straight = centre(c.pixel) + centre(c.moves.straight);
    const dvec2 diagonal = centre(c.pixel) + centre(c.moves.diagonal);
    for (const dvec2 at : {straight, diagonal}) candidate(delta, at);
    delta.set.push_back({"midpoint", Role::candidate, Dot{0.5 * (straight + diagonal), true}});
    delta.set.push_back({"midpoint name", Role::candidate,
                         Label{0.5 * (straight + diagonal), words_.say("bresenham_line.midpoint")}});
    delta.set.push_back({"straight name", Role::candidate, Label{straight, named(c.moves.straight)}});
    delta.set.push_back({"diagonal name", Role::candidate, Label{diagonal, named(c.moves.diagonal)}});
    writer_.fine(std::move(delta), c.pixel, source_line, [&](TraceStep& step) {
      step.type = "Compared";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(c.pixel);
      step.fields = {{"pixel", c.pixel}, {"p", c.p}, {"straight", c.straight}};
      step.sentence =
          words_.say("bresenham_line.compared", arg("straight", named(c.moves.straight)),
                     arg("diagonal", named(c.moves.diagonal)), arg("test", test()), arg("reason", reason()));
      step.read = read_row();
    });
  }

  void operator()(const Stepped& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Row read = read_row();
    Delta delta = cleared();
    delta.cells.push_back({s.from, CellLook{Role::past, ""}});
    const ivec2 taken = s.straight ? compared_.moves.straight : compared_.moves.diagonal;
    const ivec2 other = s.straight ? compared_.moves.diagonal : compared_.moves.straight;
    reject(delta, s.from, other);
    delta.cells.push_back({s.pixel, CellLook{Role::current, ""}});
    delta.set.push_back(
        {"chosen name", Role::current,
         Label{centre(s.pixel), words_.say("bresenham_line.chosen", arg("step", named(taken)))}});
    ++k_;
    measure(delta, s.pixel);
    current_ = s.pixel;
    pixel_ = s.pixel;
    p_ = s.p;
    writer_.step(std::move(delta), s.pixel, source_line, [&](TraceStep& step) {
      step.type = "Stepped";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(s.pixel);
      step.fields = {{"from", s.from},
                     {"pixel", s.pixel},
                     {"p_before", s.p_before},
                     {"p", s.p},
                     {"straight", s.straight}};
      step.sentence = words_.say("bresenham_line.stepped", arg("test", test()), arg("reason", reason()),
                                 arg("step", named(taken)), arg("pixel", figure_point(s.pixel)),
                                 arg("update", update(s)));
      step.read = read;
      step.row = row();
    });
    writer_.trace().pixels.push_back(s.pixel);
  }

  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    if (!faulty_ && k_ < line_.shown.last) return;  // only a part was watched
    Delta delta = cleared();
    for (const ivec2 p : writer_.trace().pixels) delta.cells.push_back({p, CellLook{Role::result, ""}});
    writer_.fine(std::move(delta), pixel_, source_line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"pixels", f.pixels}};
      step.sentence = ending(f.pixels);
    });
  }

 private:
  Row row() const {
    return {figure_number(k_), figure_number(pixel_.x), figure_number(pixel_.y), figure_number(p_), "", ""};
  }
  Row read_row() const {
    Row completed = row();
    completed[4] = words_.say("bresenham_line.sign." + sign());
    completed[5] = named(compared_.straight ? compared_.moves.straight : compared_.moves.diagonal);
    return completed;
  }

  std::string named(ivec2 move) const { return move_name(words_, move); }
  std::string sign() const { return compared_.p < 0 ? "negative" : compared_.p > 0 ? "positive" : "zero"; }
  std::string test() const {
    return words_.say("bresenham_line.test." + sign(), arg("p", figure_number(compared_.p)));
  }
  std::string reason() const {
    if (misprinted_ && compared_.pixel != line_.from) {
      const ivec2 side = compared_.straight ? compared_.moves.straight : compared_.moves.diagonal;
      return words_.say("bresenham_line.reason.misprinted", arg("step", named(side)));
    }
    if (compared_.p == 0) {
      const bool tall = compared_.moves.straight.x == 0;
      return words_.say(tall ? "bresenham_line.reason.smaller_x" : "bresenham_line.reason.smaller_y");
    }
    const ivec2 side = compared_.p < 0 ? compared_.moves.straight : compared_.moves.diagonal;
    return words_.say("bresenham_line.reason.side", arg("step", named(side)));
  }
  std::string update(const Stepped& s) const {
    const std::string before = figure_number(s.p_before), after = figure_number(s.p);
    if (misprinted_) {
      return fmt::format("{} + 2·{} − {}{} = {}", before, figure_number(size_.dy), s.straight ? "" : "3·",
                         figure_number(size_.dx), after);
    }
    if (s.straight) return fmt::format("{} + 2·{} = {}", before, figure_factor(size_.dy), after);
    return fmt::format("{} + 2·({} − {}) = {}", before, figure_number(size_.dy), figure_number(size_.dx),
                       after);
  }
  std::string ending(std::int64_t pixels) const {
    if (pixels == 0) return words_.say("bresenham_line.missed");
    const std::string to = figure_point(line_.to);
    if (faulty_) {
      return words_.count("bresenham_line.went_wrong", pixels, arg("last", figure_point(pixel_)),
                          arg("to", to));
    }
    return words_.count("bresenham_line.done", pixels, arg("from", figure_point(line_.from)), arg("to", to));
  }

  /// Takes away what the last step pointed at.
  Delta cleared() {
    Delta delta;
    for (const ivec2 p : pointed_) delta.cells.push_back({p, std::nullopt});
    pointed_.clear();
    delta.removed = {"midpoint",    "midpoint name", "straight name", "diagonal name",
                     "chosen name", "rejected name", "error",         "error name"};
    return delta;
  }
  bool on_grid(dvec2 at) const {
    const Window& cells = writer_.trace().grid.cells;
    return at.x >= cells.lower.x && at.x <= cells.upper.x && at.y >= cells.lower.y && at.y <= cells.upper.y;
  }
  void candidate(Delta& delta, dvec2 at) {
    if (!on_grid(at)) return;
    pointed_.push_back({static_cast<int>(at.x), static_cast<int>(at.y)});
    delta.cells.push_back({pointed_.back(), CellLook{Role::candidate, ""}});
  }
  void reject(Delta& delta, ivec2 from, ivec2 move) {
    const dvec2 at = centre(from) + centre(move);
    if (!on_grid(at)) return;
    pointed_.push_back(from + move);
    delta.cells.push_back({from + move, CellLook{Role::rejected, ""}});
    delta.set.push_back({"rejected name", Role::rejected,
                         Label{at, words_.say("bresenham_line.rejected", arg("step", named(move)))}});
  }
  /// The distance from the pixel's centre to the exact line, along the axis that does not lead.
  void measure(Delta& delta, ivec2 pixel) {
    if (faulty_ || size_.dx == 0) return;
    const std::int64_t miss = miss_times_dx(line_, pixel, k_);
    if (miss == 0) return;
    const dvec2 ideal = ideal_at(line_, k_);
    delta.set.push_back({"error", Role::measure, Stroke{centre(pixel), ideal}});
    const std::string name =
        words_.say("bresenham_line.error", arg("error", figure_fraction(miss, size_.dx)));
    delta.set.push_back({"error name", Role::measure, Label{0.5 * (centre(pixel) + ideal), name}});
  }

  TraceWriter& writer_;
  const Wording& words_;
  Line line_;
  bool faulty_, misprinted_;
  Extent size_{};
  ivec2 pixel_{}, current_{};
  std::int64_t p_ = 0, k_ = 0;
  Compared compared_{};
  std::vector<ivec2> pointed_;
};

/// The shortest decimal text that gives the float back.
std::string scalar_text(float value) { return fmt::format("{}", value); }

/// Tells the steps of the digital differential analyser.
class AnalyserTeller {
 public:
  AnalyserTeller(TraceWriter& writer, const Line& line)
      : writer_(writer), words_(writer.wording()), line_(line) {
    writer.trace().columns = {{"k"}, {"offset"}, {"row"}, {"x"}, {"y"}, {"right", false}};
    writer.trace().legend = {{Role::past, words_.say("bresenham_line.legend.past")},
                             {Role::current, words_.say("bresenham_line.legend.current")},
                             {Role::accepted, words_.say("bresenham_line.legend.accepted")},
                             {Role::result, words_.say("bresenham_line.legend.result")},
                             {Role::measure, words_.say("bresenham_line.legend.sum")}};
  }
  /// Number of the first pixel that is not the nearest one.
  std::optional<std::int64_t> first_wrong() const { return first_wrong_; }

  void operator()(const Divided<float>& d, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    delta.cells.push_back({d.from, CellLook{Role::current, ""}});
    current_ = d.from;
    writer_.step(std::move(delta), d.from, source_line, [&](TraceStep& step) {
      step.type = "Divided";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(d.from);
      step.fields = {{"from", d.from}, {"to", d.to}, {"dx", d.dx}, {"dy", d.dy}, {"slope", double{d.slope}}};
      step.sentence = words_.say("bresenham_line.divided", arg("dy", d.dy), arg("dx", d.dx),
                                 arg("slope", scalar_text(d.slope)));
      step.row = {"0", "0", "0", figure_number(d.from.x), figure_number(d.from.y), words_.say("words.yes")};
    });
    writer_.trace().pixels.push_back(d.from);
    slope_ = d.slope;
  }
  void operator()(const Added<float>& a, int source_line = __builtin_LINE(), const char* = nullptr) {
    added_ = a;
    Delta delta = cleared();
    writer_.fine(std::move(delta), current_, source_line, [&](TraceStep& step) {
      step.type = "Added";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(current_);
      step.fields = {{"k", a.k}, {"before", double{a.before}}, {"offset", double{a.offset}}};
      step.sentence = words_.say("bresenham_line.added", arg("before", scalar_text(a.before)),
                                 arg("slope", scalar_text(slope_)), arg("offset", scalar_text(a.offset)));
    });
  }
  void operator()(const Rounded<float>& r, int source_line = __builtin_LINE(), const char* = nullptr) {
    const ivec2 right = pixel_at(line_.from, line_.to, r.k);
    const bool wrong = right != r.pixel;
    if (wrong && !first_wrong_) first_wrong_ = r.k;
    Delta delta = cleared();
    delta.cells.push_back({current_, CellLook{Role::past, ""}});
    if (wrong) {
      delta.cells.push_back({right, CellLook{Role::accepted, ""}});
      delta.set.push_back(
          {"right name", Role::accepted, Label{centre(right), words_.say("bresenham_line.right_pixel")}});
      pointed_.push_back(right);
    }
    delta.cells.push_back({r.pixel, CellLook{Role::current, ""}});
    delta.set.push_back({"offset", Role::measure, Dot{offset_place(r), false}});
    const std::string sum = words_.say("bresenham_line.offset", arg("offset", scalar_text(r.offset)));
    delta.set.push_back({"offset name", Role::measure, Label{offset_place(r), sum}});
    current_ = r.pixel;
    writer_.step(std::move(delta), r.pixel, source_line, [&](TraceStep& step) {
      step.type = "Rounded";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(r.pixel);
      step.fields = {{"k", r.k}, {"offset", double{r.offset}}, {"row", r.row}, {"pixel", r.pixel}};
      step.sentence = words_.say("bresenham_line.rounded." + verdict(right, r),
                                 arg("before", scalar_text(added_.before)), arg("slope", scalar_text(slope_)),
                                 arg("offset", scalar_text(r.offset)), arg("row", r.row),
                                 arg("pixel", figure_point(r.pixel)), arg("right", figure_point(right)));
      step.row = {figure_number(r.k),       scalar_text(r.offset),
                  figure_number(r.row),     figure_number(r.pixel.x),
                  figure_number(r.pixel.y), words_.say(wrong ? "words.no" : "words.yes")};
    });
    writer_.trace().pixels.push_back(r.pixel);
  }
  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared();
    for (const ivec2 p : writer_.trace().pixels) delta.cells.push_back({p, CellLook{Role::result, ""}});
    writer_.fine(std::move(delta), current_, source_line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"pixels", f.pixels}};
      step.sentence = first_wrong_ ? words_.say("bresenham_line.drifted", arg("pixels", f.pixels),
                                                arg("k", *first_wrong_))
                                   : words_.count("bresenham_line.all_right", f.pixels);
    });
  }

 private:
  /// What exact arithmetic says of the pixel that was taken: "right", a "tie" or "wrong".
  std::string verdict(ivec2 right, const Rounded<float>& r) const {
    if (right == r.pixel) return "right";
    return miss_times_dx(line_, right, r.k) == miss_times_dx(line_, r.pixel, r.k) ? "tie" : "wrong";
  }
  dvec2 offset_place(const Rounded<float>& r) const {
    const dvec2 aside = centre(line_.go.diagonal) - centre(line_.go.straight);
    return centre(line_.from) + static_cast<double>(r.k) * centre(line_.go.straight) +
           double{r.offset} * aside;
  }
  Delta cleared() {
    Delta delta;
    for (const ivec2 p : pointed_) delta.cells.push_back({p, std::nullopt});
    pointed_.clear();
    delta.removed = {"offset", "offset name", "right name"};
    return delta;
  }

  TraceWriter& writer_;
  const Wording& words_;
  Line line_;
  float slope_ = 0;
  Added<float> added_{};
  ivec2 current_{};
  std::optional<std::int64_t> first_wrong_;
  std::vector<ivec2> pointed_;
};

/// What the steps of the digital differential analyser hold.
struct DdaNumbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Divided<T>& d) const {
    to.type = "Divided";
    to.number("slope", d.slope);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Added<T>&) const {
    to.type = "Added";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rounded<T>& r) const {
    to.type = "Rounded";
    to.number("offset", r.offset);
    to.decision(r.row);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Finished&) const {
    to.type = "Finished";
  }
};

/// Tells the runs of the batch method.
class RunTeller {
 public:
  RunTeller(TraceWriter& writer, const Line& line) : writer_(writer), words_(writer.wording()), line_(line) {
    writer.trace().columns = {{"run"}, {"x"}, {"y"}, {"count"}, {"pixels_so_far"}};
  }

  void operator()(const RunsStarted& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    writer_.step({}, s.from, source_line, [&](TraceStep& step) {
      step.type = "RunsStarted";
      step.phase = words_.say("words.set_up");
      step.key = pixel_key(s.from);
      step.fields = {{"from", s.from}, {"to", s.to}, {"dx", s.dx}, {"dy", s.dy}, {"shortest", s.shortest}};
      step.sentence = s.dy == 0 ? words_.count("bresenham_line.single_run", s.dx + 1)
                                : words_.say("bresenham_line.run_lengths", arg("dx", s.dx), arg("dy", s.dy),
                                             arg("shortest", s.shortest), arg("longer", s.shortest + 1),
                                             arg("rest", s.dx % s.dy));
    });
  }
  void operator()(const RunEmitted& r, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    for (const ivec2 p : current_) delta.cells.push_back({p, CellLook{Role::past, ""}});
    current_.clear();
    for (std::int64_t i = 0; i < r.count; ++i) {
      const ivec2 p = place(r.start, r.moves, i, 0);
      current_.push_back(p);
      delta.cells.push_back({p, CellLook{Role::current, ""}});
      writer_.trace().pixels.push_back(p);
    }
    total_ += r.count;
    ++runs_;
    writer_.step(std::move(delta), r.start, source_line, [&](TraceStep& step) {
      step.type = "RunEmitted";
      step.phase = words_.say("words.main_loop");
      step.key = pixel_key(r.start);
      step.fields = {{"start", r.start}, {"count", r.count}};
      const bool last = total_ == line_.size.dx + 1;
      step.sentence = words_.count(last ? "bresenham_line.last_run" : "bresenham_line.inner_run", r.count,
                                   arg("run", runs_), arg("start", figure_point(r.start)),
                                   arg("step", move_name(words_, r.moves.diagonal)));
      step.row = {figure_number(runs_), figure_number(r.start.x), figure_number(r.start.y),
                  figure_number(r.count), figure_number(total_)};
    });
  }
  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    for (const ivec2 p : writer_.trace().pixels) delta.cells.push_back({p, CellLook{Role::result, ""}});
    writer_.fine(std::move(delta), line_.to, source_line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = words_.say("words.result");
      step.level = Level::idea;
      step.fields = {{"pixels", f.pixels}};
      step.sentence = words_.count("bresenham_line.runs_done", f.pixels,
                                   arg("in_runs", words_.count("bresenham_line.in_runs", runs_)));
    });
  }

 private:
  TraceWriter& writer_;
  const Wording& words_;
  Line line_;
  std::int64_t total_ = 0, runs_ = 0;
  std::vector<ivec2> current_;
};

const std::vector<Method>& all_methods() {
  const auto method = [](std::string name, Standing standing) {
    return method_in_english("bresenham_line", std::move(name), standing);
  };
  static const std::vector<Method> methods{method("decision_parameter", Standing::taught),
                                           method("run_length", Standing::fast),
                                           method("dda", Standing::plain),
                                           method("first_octant", Standing::faulty),
                                           method("swapped_ends", Standing::faulty),
                                           method("misprinted_derivation", Standing::faulty)};
  return methods;
}

const Method& method_named(std::string_view name) {
  for (const Method& method : all_methods()) {
    if (method.name == name) return method;
  }
  throw ArgumentError("method", "a method of bresenham_line expected");
}

/// Whether the exact method starts in the middle.
bool jumps(const Line& line) { return line.window.has_value() || line.size.dx > longest_watched; }

void require_whole(const Line& line, std::string_view method) {
  if (line.window) {
    throw ArgumentError("window", fmt::format("method {} has none: it walks to every pixel", method));
  }
}

void require_short(const Line& line, std::string_view method, const Arguments& arguments) {
  if (line.size.dx > longest_watched) {
    refuse(arguments, {"to", "from"},
           fmt::format("method {} is watched from its start, so at most {} pixels: this line has {}", method,
                       longest_watched + 1, line.size.dx + 1));
  }
}

/// Watches the exact method: from its start, or, through a window or on a long line, only the part that is
/// kept.
void tell_decision(TraceWriter& writer, const Line& line, const Recording& recording) {
  DecisionTeller teller(writer, line, false);
  if (!jumps(line)) {
    decision_parameter(line.from, line.to, [](ivec2) {}, teller);
    return;
  }
  writer.trace().method_title =
      writer.wording().say(line.window ? "bresenham_line.in_window" : "bresenham_line.jumped_to_part",
                           arg("method", writer.trace().method_title));
  if (line.shown.last < line.shown.first) {
    in_window(line.from, line.to, *line.window, [](ivec2) {}, teller);
    return;
  }
  const std::int64_t wanted = recording.first - step_of(line, 0);
  const std::int64_t first = std::clamp(wanted, line.shown.first, line.shown.last);
  const std::int64_t last = std::min(line.shown.last, first + recording.most / 2);
  const Window part = window_around(pixel_at(line.from, line.to, first), pixel_at(line.from, line.to, last));
  in_window(line.from, line.to, part, [](ivec2) {}, teller);
  writer.skip_to(step_of(line, line.shown.last) + 1);
}

void describe(Trace& trace, const Line& line, const Method& method, const Arguments& arguments) {
  introduce(trace, "bresenham_line", arguments, method.standing == Standing::faulty);
  const Wording& words = trace.wording;
  trace.subtitle = words.say("bresenham_line.subtitle", arg("from", figure_point(line.from)),
                             arg("to", figure_point(line.to)));
}

void list_source(Trace& trace, std::string_view file, std::string_view function) {
  trace.source_file = std::string(folder) + std::string(file);
  trace.listing = listing_of(source_text(trace.source_file), function);
}

Trace run(const Arguments& arguments, Recording recording) {
  const Line line = line_of(arguments);
  const Method& method = method_named(arguments.text("method"));
  TraceWriter writer(recording);
  describe(writer.trace(), line, method, arguments);
  set_scene(writer.trace(), line);
  const auto drop = [](ivec2) {};
  std::optional<std::int64_t> first_wrong;
  if (method.name == "decision_parameter") {
    list_source(writer.trace(), "bresenham_line.hpp", jumps(line) ? "in_window" : "decision_parameter");
    tell_decision(writer, line, recording);
  } else if (method.name == "dda") {
    require_whole(line, method.name);
    require_short(line, method.name, arguments);
    list_source(writer.trace(), "bresenham_line.hpp", "dda");
    AnalyserTeller teller(writer, line);
    dda<float>(line.from, line.to, drop, teller);
    first_wrong = teller.first_wrong();
    if (first_wrong) {
      writer.trace().faulty = writer.wording().say("bresenham_line.drift", arg("k", *first_wrong));
    }
  } else if (method.name == "run_length") {
    require_whole(line, method.name);
    require_short(line, method.name, arguments);
    list_source(writer.trace(), "bresenham_line_batch.hpp", "emit_runs");
    RunTeller teller(writer, line);
    run_length(line.from, line.to, [](ivec2, std::int64_t) {}, teller);
  } else {
    require_whole(line, method.name);
    require_short(line, method.name, arguments);
    list_source(writer.trace(), "bresenham_line_notes.hpp", method.name);
    DecisionTeller teller(writer, line, true);
    if (method.name == "first_octant") first_octant(line.from, line.to, drop, teller);
    if (method.name == "swapped_ends") swapped_ends(line.from, line.to, drop, teller);
    if (method.name == "misprinted_derivation") misprinted_derivation(line.from, line.to, drop, teller);
  }
  Trace trace = std::move(writer).finish();
  trace.telling = middle_step(trace);
  if (side_by_side(arguments)) {
    require_method(arguments, {"dda"});
    const auto method_in = [&]<class T>(T, const auto& observer) {
      dda<T>(line.from, line.to, drop, observer);
    };
    show_side_by_side<DdaNumbers>(trace, method_in, ToldIn::floats);
    return trace;
  }
  if (first_wrong && has_step(trace, {*first_wrong, 0})) trace.telling = {*first_wrong, 0};
  if (method.standing == Standing::faulty && trace.whole()) trace.telling = {trace.last, 0};
  trace.result = {{"count", std::max<std::int64_t>(0, line.shown.last - line.shown.first + 1)}};
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "bresenham_line",
      .title = Wording().say("bresenham_line.title"),
      .chapter = "scan_conversion",
      .aliases = {"line", "line drawing", "midpoint line", "dda"},
      .summary = "the pixels nearest to a straight line, with integer additions only",
      .methods = all_methods(),
      .default_method = "decision_parameter",
      .parameters = {{"from", ParameterType::cell, "0,0", "0,0", "first pixel: column,row; y points up"},
                     {"to", ParameterType::cell, "7,3", "7,3", "last pixel"},
                     {"window", ParameterType::window, "", "0,0,15,9",
                      "draw only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"},
                     exact_parameter()},
      .examples = {"--from 0,0 --to 7,3", "--from 2,5 --to -3,-4", "--from 0,0 --to 9,4 --method dda"},
      .run = run};
  return topic;
}

}  // namespace gradus::bresenham_line
