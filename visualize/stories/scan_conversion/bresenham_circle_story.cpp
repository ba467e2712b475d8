// The story of a circle: one octant step by step, and its mirror images with it.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include "scan_conversion/bresenham_circle/bresenham_circle_notes.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"
#include "stories/checking.hpp"
#include "stories/scan_conversion/bresenham_circle/drawing.hpp"

namespace gradus::bresenham_circle {
namespace {

/// Up to this radius a run is watched from its start; the exact method jumps into longer ones,
/// and is told for so many columns.
constexpr int longest_watched = 20'000;
/// So many pixels of a circle a window may show.
constexpr std::int64_t most_in_window = 1'000'000;

constexpr auto drop = [](ivec2) {};

/// x² + y² - r²: positive outside the circle.
std::int64_t outside(int radius, ivec2 at) {
  return std::int64_t{at.x} * at.x + std::int64_t{at.y} * at.y - std::int64_t{radius} * radius;
}

double length(ivec2 at) { return std::sqrt(double{1} * at.x * at.x + double{1} * at.y * at.y); }

/// How far a place lies from the circle along the radius, in pixels. The quotient keeps digits that the
/// difference of two lengths would lose.
double radial_error(int radius, ivec2 at) {
  const std::int64_t square = outside(radius, at);
  return square == 0 ? 0 : std::abs(static_cast<double>(square)) / (length(at) + radius);
}

// --- The steps

/// How a run is told: all of a circle eight pixels per step, what a window shows of it one pixel per step,
/// the notes' listing and where the circle would have been, or their way of plotting and what it sets again.
enum class Way { whole, windowed, late, eight };

class Story {
 public:
  Story(const Words& words, const Circle& circle, Way way)
      : words_(words),
        circle_(circle),
        windowed_(way == Way::windowed),
        late_(way == Way::late),
        eight_(way == Way::eight) {}

  /// The number of the step that strays farthest from the circle.
  std::int64_t worst_step() const { return worst_step_; }
  /// The number of the last step.
  std::int64_t last_step() const { return k_; }
  /// So many plots fell on pixels that had been set.
  std::int64_t plotted_again() const { return plotted_again_; }

  void show(Board& board, const Started& s) {
    if (windowed_) return board.milestone(clamped(s.center));
    board.milestone(pixel({0, s.radius}));
    plot(board, {0, s.radius});
  }
  Event say(const Started& s) const {
    if (eight_) {
      const Event event{.text = "started_with_eight",
                        .facts = {{"center", s.center}, {"radius", s.radius}, {"p", s.p}, {"again", again_}},
                        .count = images - again_};
      return standing(event, {0, s.radius}, s.p);
    }
    Event event{.text = windowed_       ? "started_in_window"
                        : s.radius == 0 ? "started_at_centre"
                                        : "started",
                .facts = {{"center", s.center}, {"radius", s.radius}, {"p", s.p}}};
    return windowed_ ? event : standing(event, {0, s.radius}, s.p);
  }

  void show(Board& board, const Jumped& j) {
    octant_ = j.octant;
    if (!windowed_) return go_on(board, j.at);
    ++k_;
    board.milestone(pixel(j.at));
    plot(board, j.at);
    measure(board, j.at);
  }
  Event say(const Jumped& j) const {
    Event event{.text = "jumped", .facts = {{"at", j.at}, {"p", j.p}}};
    if (windowed_) {
      event.text = "entered";
      event.facts.insert(event.facts.begin(), {"octant", octant_.number});
    }
    return standing(event, j.at, j.p);
  }

  void show(Board& board, const Compared& c) {
    board.detail(pixel(c.at));
    point_at(board, next(c.at, true), Role::candidate, "straight name", named(true));
    point_at(board, next(c.at, false), Role::candidate, "diagonal move name", named(false));
    mark_midpoint(board, c.at);
  }
  Event say(const Compared& c) const {
    const std::int64_t right = decision_at(circle_.radius, c.at.x, c.at.y);
    return {.text = windowed_      ? "compared_in_window"
                    : !late_       ? "compared"
                    : c.p == right ? "compared_late.right"
                                   : "compared_late.wrong",
            .facts = {{"at", c.at}, {"p", c.p}, {"east", c.east}},
            .words = {{"straight", named(true)},
                      {"diagonal", named(false)},
                      {"step", named(c.east)},
                      {"e", outside(circle_.radius, next(c.at, true))},
                      {"se", outside(circle_.radius, next(c.at, false))},
                      {"test", test(c.p)},
                      {"side", side(c.p)},
                      {"right", right}},
            .read = read(row(k_, c.at, c.p, again_), c.p, c.east),
            .key = pixel_key(pixel(c.at)),
            .phase = phase(),
            .decides = decision(c.p, c.east)};
  }

  void show(Board& board, const Stepped& s) {
    ++k_;
    board.milestone(pixel(s.at));
    if (const ivec2 right = right_place(s.at); late_ && right != s.at) {
      point_at(board, right, Role::accepted, "right name", words_.say("right_pixel"));
    } else if (!late_ && !eight_) {
      point_at(board, next(s.from(), !s.east), Role::rejected, "rejected name",
               words_.say("rejected", {{"step", named(!s.east)}}));
    }
    if (!eight_) mark_midpoint(board, s.from());
    if (past_diagonal(s)) {
      return point_at(board, s.at, Role::accepted, "chosen name", words_.say("mirrored"));
    }
    plot(board, s.at);
    board.mark("chosen name", Role::current,
               Label{point(s.at), words_.say("chosen", {{"step", named(s.east)}})});
    if (!eight_) measure(board, s.at);
    if (radial_error(circle_.radius, s.at) > radial_error(circle_.radius, worst_)) {
      worst_ = s.at;
      worst_step_ = k_;
    }
  }
  Event say(const Stepped& s) const {
    Event event{.text = past_diagonal(s) ? "past_diagonal"
                        : again_ > 0     ? "stepped_again"
                        : windowed_      ? "stepped_in_window"
                        : late_          ? "stepped_late"
                        : is_aside()     ? "stepped_aside"
                                         : "stepped",
                .facts = {{"from", s.from()},
                          {"at", s.at},
                          {"p_before", s.p_before, "p"},
                          {"p", s.p},
                          {"east", s.east}},
                .words = {{"test", test(s.p_before)},
                          {"side", side(s.p_before)},
                          {"step", named(s.east)},
                          {"before", s.from()},
                          {"update", update(s)},
                          {"change", s.p - s.p_before},
                          {"excess", s.east ? 4 : 8}},
                .read = read(row(k_ - 1, s.from(), s.p_before, again_before_), s.p_before, s.east),
                .decides = decision(s.p_before, s.east)};
    if (eight_) event.facts.push_back({"again", again_});
    return standing(event, s.at, s.p);
  }

  void show(Board& board, const Finished&) {
    const bool to_the_end = windowed_ || late_ || eight_;
    if (!to_the_end && k_ < last_column(circle_.radius)) return;  // a part was watched
    board.detail(late_       ? pixel(worst_)
                 : windowed_ ? board.last_plotted(clamped(circle_.center))
                             : pixel({0, circle_.radius}));
    board.all_plotted(Role::result);
    plotted_ = board.plotted();
    show_again(board);
    if (late_ && worst_.y > 0) measure(board, worst_);
  }
  Event say(const Finished& f) const {
    if (late_) {
      return {.text = "went_wrong",
              .facts = {{"plots", f.pixels}, {"pixels", plotted_}},
              .words = {{"error", error_text(worst_)}}};
    }
    if (eight_) {
      return {.text = "plotted_again",
              .facts = {{"plots", f.pixels}, {"again", plotted_again_}},
              .count = plotted_};
    }
    if (f.pixels == 0) return {.text = "missed", .facts = {{"pixels", f.pixels}}};
    return {.text = "done", .facts = {{"pixels", f.pixels}}, .count = f.pixels};
  }

 private:
  bool is_aside() const { return circle_.center != ivec2{0, 0}; }
  ivec2 pixel(ivec2 at) const { return pixel_of(circle_.center, octant_, at.x, at.y); }
  dvec2 point(dvec2 at) const { return point_of(circle_.center, octant_, at); }
  ivec2 clamped(ivec2 p) const {
    return {std::clamp(p.x, circle_.window->lower.x, circle_.window->upper.x),
            std::clamp(p.y, circle_.window->lower.y, circle_.window->upper.y)};
  }
  static ivec2 next(ivec2 at, bool east) { return at + (east ? ivec2{1, 0} : ivec2{1, -1}); }
  bool past_diagonal(const Stepped& s) const { return !windowed_ && !late_ && !eight_ && s.at.x > s.at.y; }
  /// The right place in this column, as far as the octant goes.
  ivec2 right_place(ivec2 at) const {
    return at.x <= last_column(circle_.radius) ? place(at.x, height_at(circle_.radius, at.x)) : at;
  }

  /// What the reader calls a move, as it looks in the octant that is told.
  std::string named(bool east) const {
    return words_.move(east ? octant_.right : octant_.right - octant_.up);
  }
  std::string phase() const {
    return windowed_ ? words_.say("phase.octant", {{"octant", octant_.number}}) : "";
  }
  std::string test(std::int64_t p) const {
    return words_.say(p < 0 ? "test.negative" : "test.positive", {{"p", p}});
  }
  /// Where p says that the midpoint lies.
  std::string side(std::int64_t p) const { return words_.say(p < 0 ? "side.inside" : "side.outside"); }
  std::string error_text(ivec2 at) const { return figure_real(radial_error(circle_.radius, at)); }
  /// "3 + 4·(2 − 8) + 10 = −11": of the place it came from; the late one takes that where it has gone.
  std::string update(const Stepped& s) const {
    const ivec2 at = late_ ? s.at : s.from();
    const std::string x = figure_number(at.x), y = figure_number(at.y);
    return fmt::format("{} + {} = {}", figure_number(s.p_before),
                       s.east ? "4·" + x + " + 6" : fmt::format("4·({} − {}) + 10", x, y),
                       figure_number(s.p));
  }
  Decision decision(std::int64_t p, bool east) const {
    return {words_.say("question", {{"p", p}}),
            {named(true), named(false)},
            east ? 0u : 1u,
            east ? "straight" : "diagonal"};
  }
  std::vector<Said> read(std::vector<Said> cells, std::int64_t p, bool east) const {
    cells.insert(cells.end(), {words_.say(p < 0 ? "sign.negative" : "sign.positive"), named(east)});
    return cells;
  }
  std::vector<Said> row(std::int64_t k, ivec2 at, std::int64_t p, std::int64_t again) const {
    std::vector<Said> cells{k, at.x, at.y, p};
    if (eight_) cells.push_back(again);
    return cells;
  }
  /// Where the octant stands now: what the step is about, and a row of its own.
  Event standing(Event event, ivec2 at, std::int64_t p) const {
    event.key = pixel_key(pixel(at));
    if (event.text != "started") event.phase = phase();
    event.row = row(k_, at, p, again_);
    event.words.insert(event.words.end(), {{"k", k_}, {"x", at.x}, {"y", at.y}, {"pixel", pixel(at)}});
    return event;
  }

  /// The octant's own pixel is this step's; the other seven follow from it.
  void plot(Board& board, ivec2 at) {
    if (eight_) return plot_with_again(board, at);
    auto image = [&](ivec2 p) {
      board.plot(p, p == pixel(at) ? Role::current : late_ ? Role::past : Role::accepted);
    };
    if (windowed_) return image(pixel(at));
    late_ ? plot_eight(circle_.center, at.x, at.y, image) : plot_once(circle_.center, at.x, at.y, image);
  }
  /// All eight of them, and how many are set again.
  void plot_with_again(Board& board, ivec2 at) {
    again_before_ = again_;
    again_ = 0;
    auto image = [&](ivec2 p) {
      board.plot(p, p == pixel(at) ? Role::current : Role::accepted);
      again_ += ++times_[{p.x, p.y}] > 1;
    };
    plot_eight(circle_.center, at.x, at.y, image);
    plotted_again_ += again_;
    show_again(board);
  }
  /// Pixels that have been set more than once, and how often.
  void show_again(Board& board) const {
    constexpr int with_room = 4;  // labels beside smaller circles lie over their pixels
    for (const auto& [at, times] : times_) {
      if (times == 1) continue;
      board.put({at.first, at.second}, Role::rejected,
                circle_.radius < with_room ? "" : figure_number(times));
    }
  }
  /// The run goes on in the middle: places before are drawn, as far back as a view can reach.
  void go_on(Board& board, ivec2 at) {
    k_ = at.x;
    if (k_ == 0) return;
    board.skip_to(k_);
    board.milestone(pixel(at));
    auto past = [&](ivec2 p) { board.plot(p, Role::past); };
    for (std::int64_t x = std::max<std::int64_t>(1, k_ - 100); x < k_; ++x) {
      const ivec2 before = place(x, height_at(circle_.radius, x));
      plot_once(circle_.center, before.x, before.y, past);
    }
    plot(board, at);
  }
  /// Between the two places to choose from.
  void mark_midpoint(Board& board, ivec2 from) const {
    const dvec2 midpoint = point({from.x + 1, from.y - 0.5});
    if (!board.holds(midpoint)) return;
    board.mark("midpoint", Role::boundary, Dot{midpoint, true});
    board.mark("midpoint name", Role::boundary, Label{midpoint, words_.say("midpoint")});
  }
  /// A pixel that is only looked at. It may lie outside the plane, and then outside the grid.
  void point_at(Board& board, ivec2 at, Role role, std::string id, std::string text) const {
    if (!board.holds(point(at))) return;
    board.look_at(pixel(at), role);
    board.mark(std::move(id), role, Label{point(at), std::move(text)});
  }
  /// The distance from a place's centre to the circle, along the radius.
  void measure(Board& board, ivec2 at) const {
    if (outside(circle_.radius, at) == 0) return;
    const dvec2 from = point(at), foot = point(dvec2(at) * (circle_.radius / length(at)));
    board.mark("error", Role::measure, Stroke{from, foot});
    board.mark("error name", Role::measure,
               Label{0.5 * (from + foot), words_.say("error", {{"error", error_text(at)}})});
  }

  const Words& words_;
  const Circle circle_;
  const bool windowed_, late_, eight_;
  static constexpr std::int64_t images = 8;
  Octant octant_ = octants[0];
  std::int64_t k_ = 0, plotted_ = 0, worst_step_ = 0;
  ivec2 worst_{0, circle_.radius};             ///< the place that is farthest off so far
  std::map<std::pair<int, int>, int> times_;   ///< how often each pixel was set
  std::int64_t again_ = 0, again_before_ = 0;  ///< plots on such pixels, at the last two places
  std::int64_t plotted_again_ = 0;
};

// --- The methods

Circle circle_of(const Arguments& arguments) {
  return {arguments.cell("center"), static_cast<int>(arguments.integer("radius")),
          arguments.window("window")};
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

void tell_window(Narrator& narrator, const Circle& circle) {
  std::int64_t shown = 0;
  for (const Arc& arc : visible({circle.center, circle.radius}, *circle.window)) shown += arc.shown.count();
  if (shown > most_in_window) {
    refuse("window", "at most {} pixels of the circle can be watched, this window shows {}", most_in_window,
           shown);
  }
  narrator.list("in_window", "bresenham_circle_window.hpp");
  Story story(narrator.words(), circle, Way::windowed);
  in_window(circle.center, circle.radius, *circle.window, drop, narrator.watcher(story));
  narrator.result({{"count", narrator.board().plotted()}});
}

/// Of a very large circle only the part that is kept. Its pixels belong to the first octant alone: it turns
/// where the diagonal begins.
void tell_part(Narrator& narrator, const Circle& circle) {
  const std::int64_t end = last_column(circle.radius);
  const std::int64_t last =
      std::min({end, circle.first + narrator.recording().most / 2, circle.first + longest_watched});
  const auto at = [&](std::int64_t x) {
    return pixel_of(circle.center, octants[0], x, height_at(circle.radius, x));
  };
  narrator.list("in_window", "bresenham_circle_window.hpp");
  Story story(narrator.words(), circle, Way::whole);
  in_window(circle.center, circle.radius, window_around(at(circle.first), at(last)), drop,
            narrator.watcher(story));
  narrator.skip_to(end + 1);
}

void tell_decision(Narrator& narrator) {
  Circle circle = circle_of(narrator.arguments());
  if (!circle.window) require_plane(circle, narrator.arguments());
  const bool jumps = !circle.window && circle.radius > longest_watched;
  if (jumps) {
    circle.first = std::clamp<std::int64_t>(narrator.recording().first, 0, last_column(circle.radius));
  }
  draw_circle(narrator, circle, longest_watched, Key::mirrored);
  if (circle.window) return tell_window(narrator, circle);
  narrator.result({{"count", pixel_count(circle.radius)}});
  if (jumps) return tell_part(narrator, circle);
  Story story(narrator.words(), circle, Way::whole);
  decision_parameter(circle.center, circle.radius, drop, narrator.watcher(story));
}

void tell_late(Narrator& narrator) {
  const Circle circle = circle_of(narrator.arguments());
  require_plane(circle, narrator.arguments());
  draw_circle(narrator, circle, longest_watched, Key::right);
  Story story(narrator.words(), circle, Way::late);
  late_update(circle.center, circle.radius, drop, narrator.watcher(story));
  if (has_step(narrator.trace(), {story.worst_step(), 0})) narrator.telling({story.worst_step(), 0});
  narrator.result({{"count", narrator.board().plotted()}});
}

void tell_eight(Narrator& narrator) {
  const Circle circle = circle_of(narrator.arguments());
  require_plane(circle, narrator.arguments());
  draw_circle(narrator, circle, longest_watched, Key::again);
  narrator.columns({{"k"}, {"x"}, {"y"}, {"p"}, {"again"}, {"test", false}, {"step", false}});
  Story story(narrator.words(), circle, Way::eight);
  eight_plots(circle.center, circle.radius, drop, narrator.watcher(story));
  if (has_step(narrator.trace(), {story.last_step(), 0})) narrator.telling({story.last_step(), 0});
  const std::int64_t pixels = narrator.board().plotted(), again = story.plotted_again();
  narrator.result({{"count", pixels}, {"plots", pixels + again}, {"plotted_again", again}});
}

/// One move by the sign of their own p, and p moved on by the same rule.
Follows follows(const OwnSteps& steps, std::size_t i) {
  const Values &before = steps.theirs[i - 1], &now = steps.theirs[i];
  const auto at = [&](const Values& values) -> std::optional<ivec2> {
    if (const auto place = value_as<ivec2>(values, "at")) return place;
    if (const auto pixel = value_as<ivec2>(values, "pixel")) return *pixel - steps.arguments.cell("center");
    const auto x = value_as<std::int64_t>(values, "x"), y = value_as<std::int64_t>(values, "y");
    if (!x || !y) return std::nullopt;
    return ivec2(static_cast<int>(*x), static_cast<int>(*y)) - steps.arguments.cell("center");
  };
  const auto p = value_as<std::int64_t>(before, "p"), moved_on = value_as<std::int64_t>(now, "p");
  const auto stood = at(before), stands = at(now);
  if (!p || !stood || !stands) return Follows::untold;
  const std::int64_t x = stood->x, y = stood->y;
  const auto is = [&](ivec2 move, std::int64_t change) {
    return *stood + move == *stands && (!moved_on || *moved_on == *p + change);
  };
  const bool goes = *p < 0 ? is({1, 0}, 4 * x + 6) : is({1, -1}, 4 * (x - y) + 10);
  return goes ? Follows::yes : Follows::no;
}

/// p is odd, so no two pixels of a column are as near.
const Checking& checking() {
  static const Checking known{.asked = {pixels_that_are(SameList::set)},
                              .is_tie = [](const TraceStep&) { return false; },
                              .follows = follows};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  static const TopicEntry topic = completed<entry>(
      {.name = "bresenham_circle",
       .chapter = "scan_conversion",
       .aliases = {"circle", "circle drawing", "midpoint circle"},
       .summary = "the pixels nearest to a circle, with integer additions only",
       .methods = {{.name = "decision_parameter", .standing = Standing::taught, .tell = tell_decision},
                   {.name = "late_update",
                    .standing = Standing::faulty,
                    .tell = tell_late,
                    .without = {"window"},
                    .within = {{"radius", longest_watched}}},
                   {.name = "eight_plots",
                    .standing = Standing::faulty,
                    .tell = tell_eight,
                    .without = {"window"},
                    .within = {{"radius", longest_watched}}}},
       .columns = {{"k"}, {"x"}, {"y"}, {"p"}, {"test", false}, {"step", false}},
       .counts = {"Compared"},
       .parameters = {{"center", ParameterType::cell, "0,0", "0,0", "middle pixel: column,row; y points up"},
                      {"radius", ParameterType::integer, "8", "10", "in pixels", 0},
                      {"window", ParameterType::window, "", "0,0,15,9",
                       "draw only what lies in these cells: xmin,ymin,xmax,ymax, both corners included"}},
       .examples = {"--center 0,0 --radius 10", "--radius 7 --method late_update",
                    "--center -960383883,-1920767765 --radius 2147483647 --window -8,-6,8,6"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::bresenham_circle
