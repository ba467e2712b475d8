// The story of a triangle's pixels: three edge functions, their signs, and who owns a centre on an edge.

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

#include "scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"
#include "stories/checking.hpp"
#include "stories/scan_conversion/triangle_coverage/drawing.hpp"

namespace gradus::triangle_coverage {
namespace {

/// The colours of several triangles: told apart by every eye and on grey paper.
constexpr Rgba8 color_of(std::size_t triangle) {
  constexpr std::array<Rgba8, 4> all{Rgba8{86, 180, 233, 255}, Rgba8{240, 228, 66, 255},
                                     Rgba8{0, 158, 115, 255}, Rgba8{204, 121, 167, 255}};
  return all[triangle % 4];
}

/// What a story tells besides the method's steps.
struct EdgeShown {
  std::size_t edge;
};
struct SignsShown {};
/// A triangle without area.
struct LeftOut {};

enum class Way { right, closed, expanded };

class Story {
 public:
  Story(const Words& words, const Subject& subject, Way way) : words_(words), subject_(subject), way_(way) {}

  /// The step that tells most: one that goes wrong, or, not too early, where an edge decides; else the last.
  std::optional<StepNumber> telling() const {
    return worth_ == 2 && last_covered_ && 4 * telling_->step < milestones_ ? last_covered_ : telling_;
  }
  std::int64_t wrong() const { return std::ssize(wrong_); }
  std::int64_t twice() const { return std::ssize(twice_); }
  void turn_to(std::size_t triangle) { triangle_ = triangle; }

  void show(Board& board, const LeftOut&) { stand(board, corners()); }
  Event say(const LeftOut&) const {
    return {.text = "flat",
            .words = {{"corners", subject_.corners_text(triangle_)}},
            .key = figure_number(number())};
  }

  void show(Board& board, const Prepared& p) {
    edges_ = p.edges;
    right_ = owners_of(corners(), p.box);
    stand(board, p.triangle);
    for (std::size_t i = 0; i < 3; ++i) draw_edge(board, i);
  }
  Event say(const Prepared& p) const {
    const std::int64_t columns = std::max(0, p.box.upper.x - p.box.lower.x + 1),
                       rows = std::max(0, p.box.upper.y - p.box.lower.y + 1);
    Event event{.text = subject_.samples == Samples::lattice ? "prepared_lattice" : "prepared",
                .facts = {{"doubled_area", square_pixels(p.doubled_area), "area"}},
                .words = {{"corners", subject_.corners_text(triangle_)},
                          {"area", std::abs(square_pixels(p.doubled_area))}},
                .count = columns * rows,
                .key = figure_number(number())};
    event.begins = triangle_ == 0;
    if (way_ == Way::expanded) {
      event.text = "prepared_far";
      event.words.push_back({"origin", subject_.origin});
    }
    return event;
  }

  void show(Board& board, const EdgeShown& e) {
    count(board);
    board.mark("above", Role::candidate, Area{{drawing_->above(e.edge)}, 2});
    if (const auto line = drawing_->line(e.edge)) board.mark("line at hand", Role::current, *line);
    for (const ivec2 p : pixels_of(subject_.window)) {
      board.put(p, Role::guide);
      const std::string value = subject_.number(edges_[e.edge].at(centre_of(p)));
      if (!subject_.crowded()) board.mark("value " + pixel_key(p), Role::input, Text{dvec2(p), value});
    }
  }
  Event say(const EdgeShown& e) const {
    const Edge& edge = edges_[e.edge];
    const dvec2 way = subject_.place(edge.to) - subject_.place(edge.from), from = subject_.place(edge.from);
    return {.text = "edge",
            .facts = {{"x", -way.y}, {"y", way.x}, {"constant", way.y * from.x - way.x * from.y}},
            .words = {{"edge", name(e.edge)},
                      {"from", from},
                      {"to", from + way},
                      {"formula", formula(-way.y, way.x, way.y * from.x - way.x * from.y)},
                      {"right", signed_text(-way.y)},
                      {"down", signed_text(way.x)},
                      {"kind", kind(edge)}},
            .key = std::string(names[e.edge]),
            .phase = words_.shared("words", "set_up")};
  }

  void show(Board& board, const SignsShown&) {
    count(board);
    for (const ivec2 p : pixels_of(subject_.window))
      board.look_at(p, Role::guide, seen_through(weights_at(edges_, p)));
    for (const auto& [signs, at] : drawing_->regions())
      board.mark("signs " + signs, Role::input, Text{at, signs});
  }
  Event say(const SignsShown&) const {
    return {.text = "signs", .key = "signs", .phase = words_.shared("words", "set_up")};
  }

  void show(Board& board, const Tested& t) {
    count(board, t.pixel);
    settle(board);
    drawn_before_ = covered_[place(t.pixel)] > 0;
    covered_[place(t.pixel)] += t.covered;
    if (drawn_before_ && t.covered) twice_.push_back(t.pixel);
    if (way_ != Way::closed && t.covered != is_right(t.pixel)) wrong_.push_back(t.pixel);
    note_telling(t);
    at_hand_ = {t.pixel, look_of(t)};
    board.put(t.pixel, at_hand_->second.role, "", at_hand_->second.color);
    board.mark("at", t.covered ? Role::current : Role::rejected, square(t.pixel));
    board.mark("tie or not", Role::current, Dot{dvec2(t.pixel)});
    if (const auto edge = decisive(t.weights)) {
      if (const auto line = drawing_->line(*edge)) board.mark("line at hand", Role::measure, *line);
    }
    for (std::size_t i = 0; i < 3; ++i) name_edge(board, i, subject_.number(t.weights[i]));
  }
  Event say(const Tested& t) const {
    Event event = verdict(t);
    event.facts = {{"pixel", t.pixel},
                   {"ea", square_pixels(t.weights[0])},
                   {"eb", square_pixels(t.weights[1])},
                   {"ec", square_pixels(t.weights[2])},
                   {"covered", t.covered}};
    event.row = {t.pixel.x,
                 t.pixel.y,
                 subject_.number(t.weights[0]),
                 subject_.number(t.weights[1]),
                 subject_.number(t.weights[2]),
                 words_.shared("words", t.covered ? "yes" : "no")};
    event.key = pixel_key(t.pixel);
    return event;
  }

  void show(Board& board, const Finished& f) {
    found_ += f.covered;
    rest(board);
    if (triangle_ + 1 == subject_.triangles.size()) board.detail();
  }
  Event say(const Finished& f) const {
    const std::int64_t in_all = std::ranges::count_if(covered_, [](const auto& p) { return p.second > 0; });
    const bool lattice = subject_.samples == Samples::lattice;
    Event event{.text = way_ == Way::expanded ? "finished_far"
                        : twice() > 0         ? "finished_twice"
                        : lattice             ? "finished_lattice"
                        : triangle_ > 0       ? "finished_all"
                                              : "finished",
                .facts = {{"tested", f.tested}, {"covered", f.covered}},
                .words = {{"covered", in_all},
                          {"triangles", subject_.triangles.size()},
                          {"found", found_},
                          {"strict", strict_},
                          {"on_edges", found_ - strict_}},
                .count = in_all};
    if (way_ == Way::expanded) event.count = wrong();
    if (twice() > 0) event.count = twice();
    return event;
  }

 private:
  static constexpr std::array<std::string_view, 3> names{"ea", "eb", "ec"};

  static std::pair<int, int> place(ivec2 p) { return {p.x, p.y}; }
  std::int64_t number() const { return static_cast<std::int64_t>(triangle_) + 1; }
  const Triangle& corners() const { return subject_.triangles[triangle_]; }
  std::string name(std::size_t edge) const { return words_.symbol(names[edge]); }
  void count(Board& board, ivec2 focus = {}) {
    ++milestones_;
    board.milestone(focus);
  }

  // --- What is drawn

  /// A triangle comes. All are drawn from the start, and which centres lie on their edges.
  void stand(Board& board, const Triangle& t) {
    count(board);
    settle(board);
    if (triangle_ == 0) draw_all(board);
    for (const ivec2 p : pixels_of(subject_.window)) {
      if (covered_[place(p)] == 0) board.bare(p);
    }
    drawing_.emplace(subject_, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "ABC"[i]);
      board.remove("corner " + name);
      const std::optional<dvec2> at = drawing_->beside_corner(i);
      if (at) board.keep("corner " + name, Role::input, Text{*at, name});
    }
  }
  void draw_all(Board& board) const {
    for (std::size_t i = 0; i < subject_.triangles.size(); ++i) {
      const Triangle& t = subject_.triangles[i];
      const std::vector<dvec2> seen = TriangleDrawing(subject_, t).outline();
      if (seen.size() > 1) board.keep(fmt::format("triangle {}", i), Role::input, Path{seen, true});
    }
    for (const ivec2 p : on_edges(subject_))
      board.keep("tie " + pixel_key(p), Role::input, Dot{dvec2(p), true});
  }
  void draw_edge(Board& board, std::size_t i) const {
    const std::string id(names[i]);
    board.remove(id + " line");
    board.remove(id + " name");
    std::optional<Stroke> line = drawing_->line(i);
    if (!line || subject_.triangles.size() > 1) return;
    line->dashed = line->thin = true;
    board.keep(id + " line", Role::boundary, *line);
    name_edge(board, i);
  }
  /// Beside an edge stands its name, and its function's value at the pixel that is asked for.
  void name_edge(Board& board, std::size_t i, std::string_view value = {}) const {
    const auto place = drawing_->beside_edge(i);
    if (!place) return;
    const auto [at, is_left] = *place;
    const std::string text = value.empty() ? name(i) : fmt::format("{} = {}", name(i), value);
    const Align align = value.empty() ? Align::centre : is_left ? Align::right : Align::left;
    board.keep(fmt::format("{} name", names[i]), Role::input, Text{at, text, align});
  }
  static Path square(ivec2 pixel) {
    const dvec2 p(pixel);
    return {{p + dvec2{-0.5, -0.5}, p + dvec2{0.5, -0.5}, p + dvec2{0.5, 0.5}, p + dvec2{-0.5, 0.5}}, true};
  }
  /// How a pixel that has been tested looks from now on: one of several triangles is told by its colour.
  CellLook look_of(const Tested& t) {
    const bool tie = std::ranges::min(t.weights) == 0, wrong = is_wrong(t.pixel);
    const int times = covered_[place(t.pixel)];
    if (t.covered && !tie) ++strict_;
    if (times > 1 || (wrong && t.covered)) return {Role::measure, ""};
    if (wrong) return {Role::rejected, ""};
    if (t.covered) owner_[place(t.pixel)] = triangle_;
    if (times == 0) return {Role::past, ""};
    if (subject_.triangles.size() == 1) return {tie ? Role::accepted : Role::result, ""};
    return {Role::result, "", color_of(owner_[place(t.pixel)])};
  }
  /// Nothing is asked any more.
  void rest(Board& board) {
    settle(board);
    for (std::size_t i = 0; i < 3; ++i) name_edge(board, i);
  }
  void settle(Board& board) {
    if (at_hand_) board.put(at_hand_->first, at_hand_->second.role, "", at_hand_->second.color);
    at_hand_.reset();
  }

  // --- What is said

  static std::string signed_text(double number) { return (number < 0 ? "" : "+") + figure_real(number); }
  /// "2·x + 3·y − 11", without what is 0
  std::string formula(double x, double y, double constant) const {
    std::string text;
    const auto add = [&](double factor, std::string_view of) {
      if (factor == 0) return;
      const bool first = text.empty(), one = std::abs(factor) == 1 && !of.empty();
      text += factor < 0 ? (first ? "−" : " − ") : (first ? "" : " + ");
      text += one ? "" : figure_real(std::abs(factor));
      if (!of.empty()) text += (one ? "" : "·") + words_.symbol(of);
    };
    add(x, "x");
    add(y, "y");
    add(constant, "");
    return text;
  }
  std::string kind(const Edge& edge) const {
    const bool level = edge.from.y == edge.to.y;
    return words_.say(edge.owns ? (level ? "kind.top" : "kind.left")
                                : (level ? "kind.bottom" : "kind.right"));
  }
  /// The edge that decides: one that lies beyond, or one through the centre that leaves it to its neighbour,
  /// or one through it at all.
  std::optional<std::size_t> decisive(const Weights& e) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (e[i] < 0) return i;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (e[i] == 0 && !edges_[i].owns) return i;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (e[i] == 0) return i;
    }
    return std::nullopt;
  }
  Event verdict(const Tested& t) const {
    const std::optional<std::size_t> edge = decisive(t.weights);
    const std::size_t i = edge.value_or(0);
    const bool tie = edge && t.weights[i] == 0, strays = way_ == Way::expanded && is_wrong(t.pixel);
    Event event{.text = !edge                 ? "inside"
                        : t.weights[i] < 0    ? "outside"
                        : way_ == Way::closed ? (drawn_before_ ? "again" : "on_closed")
                        : t.covered           ? "on_owned"
                                              : "on_left",
                .words = {{"pixel", t.pixel},
                          {"centre", subject_.place(centre_of(t.pixel))},
                          {"ea", subject_.number(t.weights[0])},
                          {"eb", subject_.number(t.weights[1])},
                          {"ec", subject_.number(t.weights[2])},
                          {"edge", name(i)},
                          {"value", subject_.number(t.weights[i])},
                          {"kind", kind(edges_[i])}}};
    if (strays) {
      event.text = t.covered ? "strays_in" : "strays_out";
      const Weights exact = weights_at(edges_, t.pixel);
      const std::size_t off = t.covered ? decisive(exact).value_or(0) : i;
      event.words.push_back({"off", name(off)});
      event.words.push_back({"got", subject_.number(t.weights[off])});
      event.words.push_back({"exact", subject_.number(exact[off])});
    }
    const bool asks_owner = tie && way_ != Way::closed;
    event.decides =
        yes_or_no(words_, asks_owner ? "question.owner" : "question", {{"edge", name(i)}}, t.covered,
                  tie ? "on edge" : "inside", tie ? "on the edge of a neighbour" : "outside");
    return event;
  }

  // --- What is right

  static std::map<std::pair<int, int>, int> owners_of(const Triangle& t, const Window& box) {
    std::map<std::pair<int, int>, int> owned;
    cover(t, box, [&](ivec2 p, const Weights&) { ++owned[place(p)]; });
    return owned;
  }
  bool is_right(ivec2 pixel) const { return right_.contains(place(pixel)); }
  bool is_wrong(ivec2 pixel) const { return !wrong_.empty() && wrong_.back() == pixel; }
  void note_telling(const Tested& t) {
    const auto zeros = std::ranges::count(t.weights, 0);
    const bool goes_wrong = is_wrong(t.pixel) || (way_ == Way::closed && drawn_before_ && t.covered);
    const int worth = goes_wrong ? 3 : zeros == 1 && none_negative(t.weights) ? 2 : t.covered ? 1 : 0;
    if (t.covered) last_covered_ = {milestones_, 0};
    if (worth < worth_) return;
    worth_ = worth;
    telling_ = {milestones_, 0};
  }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  std::size_t triangle_ = 0;
  std::optional<TriangleDrawing> drawing_;
  Edges edges_{};
  std::map<std::pair<int, int>, int> covered_, right_;
  std::map<std::pair<int, int>, std::size_t> owner_;
  std::vector<ivec2> twice_, wrong_;
  bool drawn_before_ = false;
  std::int64_t strict_ = 0, found_ = 0, milestones_ = -1;
  int worth_ = 0;
  std::optional<std::pair<ivec2, CellLook>> at_hand_;
  std::optional<StepNumber> telling_, last_covered_;
};

// --- The methods

/// What stands unchanged behind all steps.
void set_scene(Narrator& narrator, const Subject& subject) {
  const Words& words = narrator.words();
  const bool lattice = subject.samples == Samples::lattice;
  narrator.trace().subtitle =
      words.count(lattice ? "subtitle_lattice" : "subtitle", std::ssize(subject.triangles),
                  {{"corners", subject.corners_text(0)}});
  Grid& grid = narrator.trace().grid;
  grid.cells = subject.window;
  grid.y_up = false;
  grid.x_name = words.symbol("x");
  grid.y_name = words.symbol("y");
  grid.whole = true;
  grid.on_lines = !lattice;
  narrator.handles("triangles", [&](dvec2 p) { return subject.shown_at(p); }, 1);
  narrator.handles("window", as_it_is_in(subject.window));
}

/// One triangle after the other: run(triangle, observer).
template <Way way, class Run>
void tell_each_triangle(Narrator& narrator, const Subject& subject, const Run& run) {
  set_scene(narrator, subject);
  for (std::size_t i = 0; subject.triangles.size() > 1 && i < subject.triangles.size(); ++i) {
    const std::string name = narrator.words().say("triangle", {{"number", i + 1}});
    narrator.trace().legend.push_back({Role::result, name, {}, color_of(i)});
  }
  Story story(narrator.words(), subject, way);
  const auto watch = narrator.watcher(story);
  const bool alone = subject.triangles.size() == 1 && way != Way::expanded;
  // After the first triangle's edges the signs of their functions, after those of one that stands alone
  // also each function by itself
  bool first = way != Way::expanded;
  const auto with_edges = [&]<class Step>(const Step& step, int line = __builtin_LINE(), const char* = {}) {
    watch(step, line);
    if constexpr (std::same_as<Step, Prepared>) {
      for (std::size_t i = 0; alone && i < 3; ++i) watch(EdgeShown{i}, line);
      if (std::exchange(first, false)) watch(SignsShown{}, line);
    }
  };
  for (std::size_t i = 0; i < subject.triangles.size(); ++i) {
    story.turn_to(i);
    if (doubled_area(subject.triangles[i]) == 0) {
      watch(LeftOut{}, 0);
    } else {
      run(subject.triangles[i], with_edges);
    }
  }
  if (story.telling()) narrator.telling(*story.telling());
  narrator.result({{"twice", story.twice()}, {"wrong", story.wrong()}});
}

void drop(ivec2, const Weights&) {}

void tell_cover(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.legend({{Role::input, "input"},
                   Role::boundary,
                   Role::candidate,
                   Role::current,
                   {Role::rejected, "left_now"},
                   Role::result,
                   {Role::accepted, "on_edge"},
                   Role::past});
  tell_each_triangle<Way::right>(narrator, subject, [&](const Triangle& t, const auto& observer) {
    cover(t, subject.window, drop, observer);
  });
}

void tell_closed(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.legend({{Role::input, "input"},
                   Role::boundary,
                   Role::candidate,
                   Role::current,
                   {Role::rejected, "left_now"},
                   Role::result,
                   {Role::accepted, "on_edge"},
                   {Role::measure, "twice"},
                   Role::past});
  tell_each_triangle<Way::closed>(narrator, subject, [&](const Triangle& t, const auto& observer) {
    closed_half_planes(t, subject.window, drop, observer);
  });
}

void tell_expanded(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.legend({{Role::input, "input"},
                   Role::current,
                   Role::result,
                   {Role::measure, "wrong"},
                   Role::rejected,
                   Role::past});
  tell_each_triangle<Way::expanded>(narrator, subject, [&](const Triangle& t, const auto& observer) {
    expanded_edges(t, subject.origin, subject.window, drop, observer);
  });
}

/// A centre on an edge, and beyond none: it may be in or out.
bool is_on_edge(const TraceStep& step) {
  if (step.type != "Tested") return false;
  double least = std::numeric_limits<double>::max();
  for (const char* name : {"ea", "eb", "ec"})
    least = std::min(least, value_as<double>(step.fields, name).value_or(1));
  return least == 0;
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "covered",
                                         .same = SameList::set,
                                         .type = "Tested",
                                         .fields = {"pixel"},
                                         .where = "covered"}},
                              .is_tie = is_on_edge};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "triangle_coverage",
       .chapter = "scan_conversion",
       .aliases = {"triangle", "edge functions", "triangle rasterization", "top-left rule", "half-planes"},
       .summary = "the pixels whose centres a triangle holds, by the signs of three edge functions",
       .methods = {{.name = "cover", .standing = Standing::taught, .tell = tell_cover, .unread = {"origin"}},
                   {.name = "closed_half_planes",
                    .standing = Standing::faulty,
                    .tell = tell_closed,
                    .unread = {"origin"}},
                   {.name = "expanded_edges", .standing = Standing::faulty, .tell = tell_expanded}},
       .columns = {{"x"}, {"y"}, {"ea"}, {"eb"}, {"ec"}, {"covered", false}},
       .parameters = subject_parameters(),
       .examples = {"--triangles '1,3 4,1 2,5'", "--triangles '2,1 9,2 10,8 4,9 1,5'",
                    "--samples lattice --method closed_half_planes"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::triangle_coverage
