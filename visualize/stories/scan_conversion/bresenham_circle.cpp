// The story of a circle: one octant step by step, and its mirror images with it.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::bresenham_circle {
namespace {

using fmt::arg;

constexpr std::string_view folder = "algorithms/scan_conversion/bresenham_circle/";

/// Up to this radius a run is watched from its start; the exact method jumps into longer ones, and is told
/// for so many columns.
constexpr int longest_watched = 20'000;
/// So many pixels of a circle a window may show.
constexpr std::int64_t most_in_window = 1'000'000;

struct Circle {
  ivec2 center;
  int radius;
  std::optional<Window> window;  ///< only what lies in it is drawn
  std::int64_t first = 0;        ///< the first column that is told, when the run starts in the middle
};

dvec2 middle(ivec2 p) { return {p.x, p.y}; }

/// A point of an octant, between pixels too.
dvec2 point_of(ivec2 center, const Octant& octant, double x, double y) {
  return middle(center) + x * middle(octant.right) + y * middle(octant.up);
}

/// x² + y² - r²: positive outside the circle.
std::int64_t outside(int radius, ivec2 at) {
  return std::int64_t{at.x} * at.x + std::int64_t{at.y} * at.y - std::int64_t{radius} * radius;
}

/// How far a place lies from the circle along the radius, in pixels. The quotient keeps digits that the
/// difference of two lengths would lose.
double radial_error(int radius, ivec2 at) {
  if (outside(radius, at) == 0) return 0;
  const double length = std::sqrt(double{1} * at.x * at.x + double{1} * at.y * at.y);
  return std::abs(static_cast<double>(outside(radius, at))) / (length + radius);
}

/// The ideal arc of an octant over columns `from` to `to`, its first point included, its last one not.
/// Chords this short leave it by less than 1/50 pixel.
void add_arc(std::vector<dvec2>& points, const Circle& circle, const Octant& octant, double from, double to) {
  const double r = circle.radius;
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) * 6 / std::sqrt(r))));
  for (int i = 0; i < chords; ++i) {
    const double x = from + (to - from) * i / chords;
    points.push_back(point_of(circle.center, octant, x, std::sqrt((r - x) * (r + x))));
  }
}

/// The columns of an octant, and a little more, as a chain of points.
Path ideal_arc(const Circle& circle, const Octant& octant, Stretch shown) {
  const double end = circle.radius * std::sqrt(0.5);
  const double from = std::clamp(static_cast<double>(shown.first) - 1, 0.0, end);
  const double to = std::clamp(static_cast<double>(shown.last) + 1, from, end);
  Path path;
  add_arc(path.points, circle, octant, from, to);
  path.points.push_back(
      point_of(circle.center, octant, to, std::sqrt((circle.radius - to) * (circle.radius + to))));
  return path;
}

/// The whole circle, clockwise: every second octant runs back from its diagonal.
Path ideal_circle(const Circle& circle) {
  const double end = circle.radius * std::sqrt(0.5);
  Path path;
  for (const Octant& octant : octants) {
    add_arc(path.points, circle, octant, octant.has_borders() ? 0 : end, octant.has_borders() ? end : 0);
  }
  path.closed = true;
  return path;
}

/// The cells of the circle, as far as they are in the plane.
Window scene_of(const Circle& circle) {
  return {circle.center - circle.radius, circle.center + circle.radius};
}

void draw_ideal(Trace& trace, const Circle& circle) {
  std::optional<dvec2> named;
  if (circle.window) {
    for (const auto& [octant, shown] : visible(circle.center, circle.radius, *circle.window)) {
      if (shown.count() == 0) continue;
      Path arc = ideal_arc(circle, octant, shown);
      if (!named) named = arc.points[arc.points.size() / 2];
      trace.backdrop.push_back(
          {fmt::format("ideal circle, octant {}", octant.number), Role::boundary, std::move(arc)});
    }
  } else if (circle.radius > longest_watched) {
    const std::int64_t first = std::max<std::int64_t>(0, circle.first - 100);
    trace.backdrop.push_back({"ideal circle", Role::boundary,
                              ideal_arc(circle, octants[0], {first, circle.first + longest_watched})});
  } else {
    trace.backdrop.push_back({"ideal circle", Role::boundary, ideal_circle(circle)});
    const double there = circle.radius * std::sqrt(0.5);
    named = point_of(circle.center, octants[4], there, there);
  }
  if (named) {
    trace.backdrop.push_back(
        {"ideal circle name", Role::boundary, Label{*named, trace.wording.say("bresenham_circle.ideal")}});
  }
}

/// The centre as a cross, the radius, and the diagonal that ends the octant.
void draw_octant(Trace& trace, const Circle& circle) {
  const dvec2 center = middle(circle.center);
  const double arm = 0.3, end = circle.radius * std::sqrt(0.5);
  trace.backdrop.push_back(
      {"centre, across", Role::input, Stroke{center - dvec2{arm, 0}, center + dvec2{arm, 0}}});
  trace.backdrop.push_back(
      {"centre, up", Role::input, Stroke{center - dvec2{0, arm}, center + dvec2{0, arm}}});
  if (circle.radius < 2) return;
  const dvec2 top = center + dvec2{0, circle.radius}, corner = center + dvec2{end, end};
  trace.backdrop.push_back({"radius", Role::input, Stroke{center, top}});
  trace.backdrop.push_back({"diagonal", Role::boundary, Stroke{center, corner}});
  if (circle.radius < 4) return;
  trace.backdrop.push_back({"radius name", Role::input,
                            Label{0.5 * (center + top), trace.wording.say("bresenham_circle.radius",
                                                                          arg("radius", circle.radius))}});
  trace.backdrop.push_back(
      {"diagonal name", Role::boundary,
       Label{center + 0.45 * (corner - center), trace.wording.say("bresenham_circle.diagonal")}});
}

/// What stands unchanged behind all steps.
void set_scene(Trace& trace, const Circle& circle, bool late) {
  const auto say = [&trace](std::string_view key) { return trace.wording.say(key); };
  trace.grid.cells = circle.window ? *circle.window : scene_of(circle);
  trace.grid.y_up = true;
  trace.grid.x_name = trace.wording.symbol("x");
  trace.grid.y_name = trace.wording.symbol("y");
  if (!circle.window || circle.window->contains(circle.center)) draw_octant(trace, circle);
  if (circle.radius > 0) draw_ideal(trace, circle);
  trace.legend = {
      {Role::past, say("bresenham_circle.legend.past")},
      {Role::current, say("bresenham_circle.legend.current")},
      {Role::accepted, say(late ? "bresenham_circle.legend.right" : "bresenham_circle.legend.mirrored")},
      {Role::candidate, say("bresenham_circle.legend.candidate")},
      {Role::rejected, say("bresenham_circle.legend.rejected")},
      {Role::result, say("bresenham_circle.legend.result")},
      {Role::measure, say("bresenham_circle.legend.error")}};
  trace.columns = {{"k"}, {"x"}, {"y"}, {"p"}, {"test", false}, {"step", false}};
}

/// What all tellers of circles share: which octant is told, and the cells and marks of its places.
class CircleTeller {
 public:
  CircleTeller(TraceWriter& writer, const Circle& circle)
      : writer_(writer), words_(writer.trace().wording), circle_(circle) {}

 protected:
  template <class... Values>
  std::string say(std::string_view key, const Values&... values) const {
    return words_.say(key, values...);
  }

  ivec2 pixel(ivec2 at) const { return pixel_of(circle_.center, octant_, at.x, at.y); }
  dvec2 point(double x, double y) const { return point_of(circle_.center, octant_, x, y); }

  /// What the reader calls a move, as it looks in the octant that is told.
  std::string named(bool east) const {
    return words_.symbol(compass(east ? octant_.right : octant_.right - octant_.up));
  }
  ivec2 next(ivec2 at, bool east) const { return at + (east ? ivec2{1, 0} : ivec2{1, -1}); }

  Row row(ivec2 at, std::int64_t p) const {
    return {figure_number(k_), figure_number(at.x), figure_number(at.y), figure_number(p), "", ""};
  }
  Row read_row(const Compared& c) const {
    Row completed = row(c.at, c.p);
    completed[4] = say(c.p < 0 ? "bresenham_circle.sign.negative" : "bresenham_circle.sign.positive");
    completed[5] = named(c.east);
    return completed;
  }
  std::string test(std::int64_t p) const {
    return say(p < 0 ? "bresenham_circle.test.negative" : "bresenham_circle.test.positive",
               arg("p", figure_number(p)));
  }

  /// A pixel that was plotted and will look so from the next step on.
  void plotted(Delta& delta, ivec2 p, Role role) {
    delta.cells.push_back({p, CellLook{role, ""}});
    fresh_.push_back(p);
    if (drawn_.insert(key_of(p)).second) writer_.trace().pixels.push_back(p);
  }
  /// Takes away what the last step pointed at, and makes its pixels past ones where `settle` says so.
  Delta cleared(bool settle) {
    Delta delta;
    for (const ivec2 p : pointed_) {
      delta.cells.push_back({p, std::nullopt});
      if (drawn_.contains(key_of(p))) delta.cells.push_back({p, CellLook{Role::past, ""}});
    }
    pointed_.clear();
    delta.removed = {"midpoint",      "midpoint name", "straight name", "diagonal move name", "chosen name",
                     "rejected name", "error",         "error name",    "right name"};
    if (!settle) return delta;
    for (const ivec2 p : fresh_) delta.cells.push_back({p, CellLook{Role::past, ""}});
    fresh_.clear();
    return delta;
  }

  bool on_grid(ivec2 p) const { return writer_.trace().grid.cells.contains(p); }
  bool on_grid(dvec2 at) const {
    const Window& cells = writer_.trace().grid.cells;
    return at.x >= cells.lower.x && at.x <= cells.upper.x && at.y >= cells.lower.y && at.y <= cells.upper.y;
  }
  /// A pixel that is only looked at. It may lie outside the plane, and then outside the grid.
  void point_at(Delta& delta, ivec2 at, Role role, std::string id, std::string text) {
    const dvec2 place = point(at.x, at.y);
    if (!on_grid(place)) return;
    pointed_.push_back(pixel(at));
    delta.cells.push_back({pixel(at), CellLook{role, ""}});
    delta.set.push_back({std::move(id), role, Label{place, std::move(text)}});
  }
  void compare(Delta& delta, const Compared& c) {
    point_at(delta, next(c.at, true), Role::candidate, "straight name", named(true));
    point_at(delta, next(c.at, false), Role::candidate, "diagonal move name", named(false));
    const dvec2 between = point(c.at.x + 1, c.at.y - 0.5);
    delta.set.push_back({"midpoint", Role::candidate, Dot{between, true}});
    delta.set.push_back({"midpoint name", Role::candidate, Label{between, say("bresenham_circle.midpoint")}});
  }
  /// The distance from a place's centre to the circle, along the radius.
  void measure(Delta& delta, ivec2 at) {
    if (outside(circle_.radius, at) == 0) return;
    const double length = std::sqrt(double{1} * at.x * at.x + double{1} * at.y * at.y);
    const dvec2 pixel_centre = point(at.x, at.y);
    const dvec2 foot = point(at.x * (circle_.radius / length), at.y * (circle_.radius / length));
    delta.set.push_back({"error", Role::measure, Stroke{pixel_centre, foot}});
    delta.set.push_back(
        {"error name", Role::measure,
         Label{0.5 * (pixel_centre + foot), say("bresenham_circle.error", arg("error", error_text(at)))}});
  }
  /// Names the pixel that a step has gone to.
  void name_chosen(Delta& delta, const Stepped& s) {
    delta.set.push_back(
        {"chosen name", Role::current,
         Label{point(s.at.x, s.at.y), say("bresenham_circle.chosen", arg("step", named(s.east)))}});
  }

  // What a step holds whoever tells it; phase and sentence are the teller's own.
  static void describe(TraceStep& step, const Started& s) {
    step.type = "Started";
    step.fields = {{"center", s.center}, {"radius", std::int64_t{s.radius}}, {"p", s.p}};
  }
  void describe(TraceStep& step, const Compared& c) const {
    step.type = "Compared";
    step.key = pixel_key(pixel(c.at));
    step.fields = {{"at", c.at}, {"p", c.p}, {"east", c.east}};
    step.read = read_row(c);
  }
  void describe(TraceStep& step, const Stepped& s, const Row& read) const {
    step.type = "Stepped";
    step.key = pixel_key(pixel(s.at));
    step.fields = {{"from", s.from()}, {"at", s.at}, {"p_before", s.p_before}, {"p", s.p}, {"east", s.east}};
    step.read = read;
    step.row = row(s.at, s.p);
  }

  /// A whole circle begins at its top.
  void tell_start(Delta delta, const Started& s, int source_line) {
    const ivec2 at{0, s.radius};
    writer_.step(std::move(delta), pixel(at), source_line, [&](TraceStep& step) {
      describe(step, s);
      step.phase = say("words.set_up");
      step.key = pixel_key(pixel(at));
      step.sentence = s.radius == 0 ? say("bresenham_circle.started_at_centre", arg("p", figure_number(s.p)))
                                    : say("bresenham_circle.started", arg("radius", figure_number(s.radius)),
                                          arg("p", figure_number(s.p)));
      step.row = row(at, s.p);
    });
  }
  void tell_end(const Finished& f, ivec2 focus, const std::string& sentence, int source_line) {
    Delta delta = cleared(true);
    for (const ivec2 p : writer_.trace().pixels) delta.cells.push_back({p, CellLook{Role::result, ""}});
    writer_.fine(std::move(delta), focus, source_line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = say("words.result");
      step.level = Level::idea;
      step.fields = {{"pixels", f.pixels}};
      step.sentence = sentence;
    });
  }

  std::string error_text(ivec2 at) const { return fmt::format("{:.3f}", radial_error(circle_.radius, at)); }

  static std::uint64_t key_of(ivec2 p) {
    return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32 | static_cast<std::uint32_t>(p.y);
  }

  TraceWriter& writer_;
  const Wording words_;
  const Circle circle_;
  Octant octant_ = octants[0];
  std::int64_t k_ = 0;
  Compared compared_{};
  std::unordered_set<std::uint64_t> drawn_;

 private:
  std::vector<ivec2> pointed_, fresh_;
};

/// Tells the taught method: the whole circle, eight pixels a step.
class WholeTeller : public CircleTeller {
 public:
  using CircleTeller::CircleTeller;

  void operator()(const Started& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    plot_images(delta, {0, s.radius});
    tell_start(std::move(delta), s, source_line);
  }

  /// The run goes on in the middle: places before are drawn, as far back as a view can reach.
  void operator()(const Jumped& j, int source_line = __builtin_LINE(), const char* = nullptr) {
    k_ = j.at.x;
    if (k_ == 0) return;
    Delta delta = cleared(true);
    for (std::int64_t x = std::max<std::int64_t>(1, k_ - 100); x < k_; ++x) {
      plot_images(delta, place(x, height_at(circle_.radius, x)));
    }
    for (CellChange& change : delta.cells) change.look = CellLook{Role::past, ""};
    plot_images(delta, j.at);
    writer_.skip_to(k_);
    writer_.step(std::move(delta), pixel(j.at), source_line, [&](TraceStep& step) {
      step.type = "Jumped";
      step.phase = say("words.main_loop");
      step.key = pixel_key(pixel(j.at));
      step.fields = {{"at", j.at}, {"p", j.p}};
      step.sentence =
          say("bresenham_circle.jumped", arg("k", figure_number(k_)), arg("x", figure_number(j.at.x)),
              arg("y", figure_number(j.at.y)), arg("p", figure_number(j.p)));
      step.row = row(j.at, j.p);
    });
  }

  void operator()(const Compared& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    compared_ = c;
    Delta delta = cleared(false);
    compare(delta, c);
    writer_.fine(std::move(delta), pixel(c.at), source_line, [&](TraceStep& step) {
      describe(step, c);
      step.phase = say("words.main_loop");
      step.sentence =
          say("bresenham_circle.compared", arg("straight", named(true)), arg("diagonal", named(false)),
              arg("e", figure_number(outside(circle_.radius, next(c.at, true)))),
              arg("se", figure_number(outside(circle_.radius, next(c.at, false)))), arg("test", test(c.p)),
              arg("step", named(c.east)));
    });
  }

  void operator()(const Stepped& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Row read = read_row(compared_);
    const bool past_diagonal = s.at.x > s.at.y;
    Delta delta = cleared(true);
    point_at(delta, next(s.from(), !s.east), Role::rejected, "rejected name",
             say("bresenham_circle.rejected", arg("step", named(!s.east))));
    if (past_diagonal) {
      point_at(delta, s.at, Role::accepted, "chosen name", say("bresenham_circle.mirrored"));
    } else {
      plot_images(delta, s.at);
      name_chosen(delta, s);
      measure(delta, s.at);
    }
    ++k_;
    writer_.step(std::move(delta), pixel(s.at), source_line, [&](TraceStep& step) {
      describe(step, s, read);
      step.phase = say("words.main_loop");
      step.sentence = past_diagonal
                          ? say("bresenham_circle.past_diagonal", arg("test", test(s.p_before)),
                                arg("step", named(s.east)), arg("x", figure_number(s.at.x)),
                                arg("y", figure_number(s.at.y)), arg("before", figure_point(s.from())))
                          : say("bresenham_circle.stepped", arg("test", test(s.p_before)),
                                arg("step", named(s.east)), arg("x", figure_number(s.at.x)),
                                arg("y", figure_number(s.at.y)), arg("update", update(s)));
    });
  }

  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    if (k_ < last_column(circle_.radius)) return;  // only a part was watched
    tell_end(f, circle_.center, words_.count("bresenham_circle.done", f.pixels), source_line);
  }

 private:
  /// The octant's own pixel is this step's; the other seven follow from it.
  void plot_images(Delta& delta, ivec2 at) {
    Role role = Role::current;
    auto plot = [&](ivec2 p) {
      plotted(delta, p, role);
      role = Role::accepted;
    };
    plot_mirrored(circle_.center, at.x, at.y, plot);
  }

  static std::string update(const Stepped& s) {
    const std::string before = figure_number(s.p_before), after = figure_number(s.p);
    const ivec2 from = s.from();
    return s.east ? fmt::format("{} + 4·{} + 6 = {}", before, figure_number(from.x), after)
                  : fmt::format("{} + 4·({} − {}) + 10 = {}", before, figure_number(from.x),
                                figure_number(from.y), after);
  }
};

/// Tells the part in a window: one octant after the other, one pixel a step.
class WindowTeller : public CircleTeller {
 public:
  using CircleTeller::CircleTeller;

  void operator()(const Started& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Window& cells = *circle_.window;
    const ivec2 focus = clamped(s.center, cells);
    writer_.step({}, focus, source_line, [&](TraceStep& step) {
      describe(step, s);
      step.phase = say("words.set_up");
      step.sentence = say("bresenham_circle.started_in_window", arg("center", figure_point(s.center)),
                          arg("radius", figure_number(s.radius)));
    });
  }

  void operator()(const Jumped& j, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared(true);
    octant_ = j.octant;
    plotted(delta, pixel(j.at), Role::current);
    measure(delta, j.at);
    ++k_;
    writer_.step(std::move(delta), pixel(j.at), source_line, [&](TraceStep& step) {
      step.type = "Jumped";
      step.phase = say("bresenham_circle.phase.octant", arg("octant", octant_.number));
      step.key = pixel_key(pixel(j.at));
      step.fields = {{"octant", std::int64_t{octant_.number}}, {"at", j.at}, {"p", j.p}};
      step.sentence = say("bresenham_circle.entered", arg("octant", octant_.number),
                          arg("pixel", figure_point(pixel(j.at))), arg("x", figure_number(j.at.x)),
                          arg("y", figure_number(j.at.y)), arg("p", figure_number(j.p)));
      step.row = row(j.at, j.p);
    });
  }

  void operator()(const Compared& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    compared_ = c;
    Delta delta = cleared(false);
    compare(delta, c);
    writer_.fine(std::move(delta), pixel(c.at), source_line, [&](TraceStep& step) {
      describe(step, c);
      step.phase = say("bresenham_circle.phase.octant", arg("octant", octant_.number));
      step.sentence = say("bresenham_circle.compared_in_window", arg("straight", named(true)),
                          arg("diagonal", named(false)), arg("test", test(c.p)), arg("step", named(c.east)));
    });
  }

  void operator()(const Stepped& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Row read = read_row(compared_);
    Delta delta = cleared(true);
    point_at(delta, next(s.from(), !s.east), Role::rejected, "rejected name",
             say("bresenham_circle.rejected", arg("step", named(!s.east))));
    plotted(delta, pixel(s.at), Role::current);
    name_chosen(delta, s);
    measure(delta, s.at);
    ++k_;
    writer_.step(std::move(delta), pixel(s.at), source_line, [&](TraceStep& step) {
      describe(step, s, read);
      step.phase = say("bresenham_circle.phase.octant", arg("octant", octant_.number));
      step.sentence = say("bresenham_circle.stepped_in_window", arg("test", test(s.p_before)),
                          arg("step", named(s.east)), arg("pixel", figure_point(pixel(s.at))),
                          arg("change", figure_number(s.p - s.p_before)), arg("p", figure_number(s.p)));
    });
  }

  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    const auto& pixels = writer_.trace().pixels;
    const ivec2 focus = pixels.empty() ? clamped(circle_.center, *circle_.window) : pixels.back();
    tell_end(f, focus,
             f.pixels == 0 ? say("bresenham_circle.missed") : words_.count("bresenham_circle.done", f.pixels),
             source_line);
  }

 private:
  static ivec2 clamped(ivec2 p, const Window& cells) {
    return {std::clamp(p.x, cells.lower.x, cells.upper.x), std::clamp(p.y, cells.lower.y, cells.upper.y)};
  }
};

/// Tells the notes' listing, and where the circle would have been.
class LateTeller : public CircleTeller {
 public:
  using CircleTeller::CircleTeller;

  void operator()(const Started& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta;
    plot_images(delta, {0, s.radius});
    tell_start(std::move(delta), s, source_line);
  }

  void operator()(const Compared& c, int source_line = __builtin_LINE(), const char* = nullptr) {
    compared_ = c;
    Delta delta = cleared(false);
    compare(delta, c);
    writer_.fine(std::move(delta), pixel(c.at), source_line, [&](TraceStep& step) {
      describe(step, c);
      step.phase = say("words.main_loop");
      const std::int64_t right = decision_at(circle_.radius, c.at.x, c.at.y);
      step.sentence = c.p == right ? say("bresenham_circle.compared_late.right", arg("test", test(c.p)),
                                         arg("step", named(c.east)))
                                   : say("bresenham_circle.compared_late.wrong", arg("test", test(c.p)),
                                         arg("step", named(c.east)), arg("right", figure_number(right)));
    });
  }

  void operator()(const Stepped& s, int source_line = __builtin_LINE(), const char* = nullptr) {
    const Row read = read_row(compared_);
    Delta delta = cleared(true);
    const ivec2 right =
        s.at.x <= last_column(circle_.radius) ? place(s.at.x, height_at(circle_.radius, s.at.x)) : s.at;
    if (right != s.at)
      point_at(delta, right, Role::accepted, "right name", say("bresenham_circle.right_pixel"));
    plot_images(delta, s.at);
    name_chosen(delta, s);
    measure(delta, s.at);
    if (radial_error(circle_.radius, s.at) > radial_error(circle_.radius, worst_)) worst_ = s.at;
    ++k_;
    writer_.step(std::move(delta), pixel(s.at), source_line, [&](TraceStep& step) {
      describe(step, s, read);
      step.phase = say("words.main_loop");
      step.sentence =
          say("bresenham_circle.stepped_late", arg("test", test(s.p_before)), arg("step", named(s.east)),
              arg("x", figure_number(s.at.x)), arg("y", figure_number(s.at.y)), arg("update", update(s)),
              arg("excess", s.east ? 4 : 8));
    });
  }

  void operator()(const Finished& f, int source_line = __builtin_LINE(), const char* = nullptr) {
    Delta delta = cleared(true);
    const auto& pixels = writer_.trace().pixels;
    for (const ivec2 p : pixels) delta.cells.push_back({p, CellLook{Role::result, ""}});
    if (worst_.y > 0) measure(delta, worst_);
    writer_.fine(std::move(delta), pixel(worst_), source_line, [&](TraceStep& step) {
      step.type = "Finished";
      step.phase = say("words.result");
      step.level = Level::idea;
      step.fields = {{"plots", f.pixels}, {"pixels", static_cast<std::int64_t>(pixels.size())}};
      step.sentence = say("bresenham_circle.went_wrong", arg("plots", f.pixels), arg("pixels", pixels.size()),
                          arg("error", error_text(worst_)));
    });
  }

 private:
  /// Here the other seven are past at once: the accepted look is kept for the right pixel.
  void plot_images(Delta& delta, ivec2 at) {
    Role role = Role::past;
    auto plot = [&](ivec2 p) { plotted(delta, p, role); };
    plot_eight(circle_.center, at.x, at.y, plot);
    role = Role::current;
    plot(pixel(at));
  }

  static std::string update(const Stepped& s) {
    const std::string before = figure_number(s.p_before), after = figure_number(s.p);
    return s.east ? fmt::format("{} + 4·{} + 6 = {}", before, figure_number(s.at.x), after)
                  : fmt::format("{} + 4·({} − {}) + 10 = {}", before, figure_number(s.at.x),
                                figure_number(s.at.y), after);
  }

  ivec2 worst_{0, circle_.radius};  ///< the place that is farthest off so far
};

const std::vector<Method>& all_methods() {
  static const std::vector<Method> methods{
      method_in_english("bresenham_circle", "decision_parameter", Standing::taught),
      method_in_english("bresenham_circle", "late_update", Standing::faulty)};
  return methods;
}

const Method& method_named(std::string_view name) {
  for (const Method& each : all_methods()) {
    if (each.name == name) return each;
  }
  throw ArgumentError("method", "a method of bresenham_circle expected");
}

/// Without a window all of the circle must be in the plane.
void require_plane(const Circle& circle, const Arguments& arguments) {
  if (fits_plane(circle.center, circle.radius)) return;
  const auto room = [](int c) { return std::min(INT32_MAX - std::int64_t{c}, std::int64_t{c} - INT32_MIN); };
  refuse(arguments, {"radius", "center"},
         fmt::format("a radius of at most {} round {},{} without a window, for pixels are int32, found {}",
                     std::min(room(circle.center.x), room(circle.center.y)), circle.center.x, circle.center.y,
                     circle.radius));
}

void require_few(const Circle& circle) {
  std::int64_t shown = 0;
  for (const Arc& arc : visible(circle.center, circle.radius, *circle.window)) shown += arc.shown.count();
  if (shown > most_in_window) {
    throw ArgumentError("window",
                        fmt::format("at most {} pixels of the circle can be watched, this window shows {}",
                                    most_in_window, shown));
  }
}

/// Whether the exact method starts in the middle.
bool jumps(const Circle& circle) { return circle.window || circle.radius > longest_watched; }

void require_watchable(const Circle& circle, std::string_view method) {
  if (circle.window) {
    throw ArgumentError("window", fmt::format("method {} has none: it walks to every pixel", method));
  }
  if (circle.radius > longest_watched) {
    throw ArgumentError("radius", fmt::format("method {} is watched from its start, so at most {}, found {}",
                                              method, longest_watched, circle.radius));
  }
}

/// Watches the exact method: from its start, through a window, or, on a very large circle, only the part that
/// is kept.
void tell_decision(TraceWriter& writer, const Circle& circle, const Recording& recording) {
  const auto drop = [](ivec2) {};
  if (circle.window) {
    require_few(circle);
    WindowTeller teller(writer, circle);
    in_window(circle.center, circle.radius, *circle.window, drop, teller);
    return;
  }
  WholeTeller teller(writer, circle);
  if (circle.radius <= longest_watched) {
    decision_parameter(circle.center, circle.radius, drop, teller);
    return;
  }
  // The pixels of this window belong to the first octant alone: it turns where the diagonal begins
  const std::int64_t end = last_column(circle.radius);
  const std::int64_t last =
      std::min({end, circle.first + recording.most / 2, circle.first + longest_watched});
  const Window part =
      window_around(pixel_of(circle.center, octants[0], circle.first, height_at(circle.radius, circle.first)),
                    pixel_of(circle.center, octants[0], last, height_at(circle.radius, last)));
  in_window(circle.center, circle.radius, part, drop, teller);
  writer.skip_to(end + 1);
}

void list_source(Trace& trace, std::string_view file, std::string_view function) {
  trace.source_file = std::string(folder) + std::string(file);
  trace.listing = listing_of(source_text(trace.source_file), function);
}

void describe(Trace& trace, const Circle& circle, const Method& method, const Arguments& arguments) {
  const Wording& words = trace.wording;
  introduce(trace, "bresenham_circle", arguments, method.standing == Standing::faulty);
  trace.subtitle = words.say("bresenham_circle.subtitle", arg("center", figure_point(circle.center)),
                             arg("radius", figure_number(circle.radius)));
  if (circle.window) {
    trace.method_title = words.say("bresenham_circle.in_window", arg("method", trace.method_title));
  } else if (circle.radius > longest_watched) {
    trace.method_title = words.say("bresenham_circle.jumped_to_part", arg("method", trace.method_title));
  }
}

Circle circle_of(const Arguments& arguments, const Recording& recording) {
  Circle circle{arguments.cell("center"), static_cast<int>(arguments.integer("radius")),
                arguments.window("window")};
  if (!circle.window && circle.radius > longest_watched) {
    circle.first = std::clamp<std::int64_t>(recording.first, 0, last_column(circle.radius));
  }
  return circle;
}

Trace run(const Arguments& arguments, Recording recording) {
  const Circle circle = circle_of(arguments, recording);
  const Method& method = method_named(arguments.text("method"));
  const bool late = method.name == "late_update";
  if (late) require_watchable(circle, method.name);
  if (!circle.window) require_plane(circle, arguments);
  TraceWriter writer(recording);
  describe(writer.trace(), circle, method, arguments);
  set_scene(writer.trace(), circle, late);
  if (late) {
    list_source(writer.trace(), "bresenham_circle_notes.hpp", "late_update");
    LateTeller teller(writer, circle);
    late_update(circle.center, circle.radius, [](ivec2) {}, teller);
  } else {
    list_source(writer.trace(), "bresenham_circle.hpp", jumps(circle) ? "in_window" : "decision_parameter");
    tell_decision(writer, circle, recording);
  }
  Trace trace = std::move(writer).finish();
  trace.telling = late && trace.whole() ? StepNumber{trace.last, 0} : middle_step(trace);
  const bool part = !circle.window && !late;
  trace.result = {
      {"count", part ? pixel_count(circle.radius) : static_cast<std::int64_t>(trace.pixels.size())}};
  return trace;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "bresenham_circle",
      .title = Wording().say("bresenham_circle.title"),
      .chapter = "scan_conversion",
      .aliases = {"circle", "circle drawing", "midpoint circle"},
      .summary = "the pixels nearest to a circle, with integer additions only",
      .methods = all_methods(),
      .default_method = "decision_parameter",
      .parameters = {{"center", ParameterType::cell, "0,0", "0,0", "middle pixel: column,row; y points up"},
                     {.name = "radius",
                      .type = ParameterType::integer,
                      .default_value = "8",
                      .example = "10",
                      .help = "in pixels",
                      .least = 0},
                     {"window", ParameterType::window, "", "0,0,15,9",
                      "draw only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"}},
      .examples = {"--center 0,0 --radius 10", "--radius 7 --method late_update",
                   "--center -960383883,-1920767765 --radius 2147483647 --window -8,-6,8,6"},
      .run = run};
  return topic;
}

}  // namespace gradus::bresenham_circle
