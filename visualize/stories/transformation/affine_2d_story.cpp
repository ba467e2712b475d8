// The story of a product of transformations in the plane: which factor acts first, and where the shape goes.

#include "stories/parameters.hpp"
#include "stories/transformation/affine_2d_task.hpp"
#include "transformation/affine_2d/affine_2d_notes.hpp"

namespace gradus::affine_2d {
namespace {

// --- The steps

/// How the factors act: all of them as one matrix, or one by one; the same from the first pivot; backwards;
/// with the notes' shears.
enum class Way { forwards, local, undo, centre_added };

/// What would come out in the reverse order: told after the run.
struct Reversed {};

class Story {
 public:
  Story(const Words& words, const Task& task, Way way)
      : words_(words), task_(task), way_(way), stages_{first_stage()}, panel_(panel_for(world())) {}

  const Panel& panel() const { return panel_; }

  void show(Board& board, const Started<double>& s) {
    matrix_ = s.product;
    milestone(board, Role::input);
  }
  Event say(const Started<double>&) const {
    return standing({.text = way_ == Way::undo ? "started_undo" : "started",
                     .words = {{"product", product_name(words_.wording(), count())}}});
  }

  void show(Board& board, const Rebased<double>&) {
    matrix_ = Matrix<double>(1.0);
    milestone(board, Role::input);
  }
  Event say(const Rebased<double>& r) const {
    return standing(
        {.text = "rebased", .words = {{"origin", r.origin}, {"local", r.points[0]}}, .begins = true});
  }

  void show(Board& board, const Multiplied<double>& m) {
    matrix_ = m.product;
    shown_ = m.matrix;
    Shape points = stages_[0];
    for (dvec2& p : points) p = transform(m.product, p);
    go_on(board, std::move(points));
  }
  Event say(const Multiplied<double>& m) const {
    Event event = acted("multiplied", m.factor);
    if (way_ == Way::centre_added) {
      const bool shear = is_shear(task_.factors[m.factor]);
      event.decides =
          yes_or_no(words_, "question.shear", {{"name", name_of(m.factor)}}, shear, "shear", "other");
    }
    return event;
  }

  void show(Board& board, const Acted<double>& a) {
    shown_ = matrix(task_.factors[a.factor]);
    matrix_ = shown_ * matrix_;
    go_on(board, a.points);
  }
  Event say(const Acted<double>& a) const { return acted("acted", a.factor); }

  void show(Board& board, const Undone<double>& u) {
    shown_ = u.matrix;
    matrix_ = u.matrix * matrix_;
    go_on(board, u.points);
  }
  Event say(const Undone<double>& u) const {
    Event event = acted("undone", u.factor);
    event.decides = yes_or_no(words_, "question.inverse", {{"name", name_of(u.factor)}}, true, "invertible");
    return event;
  }

  void show(Board&, const Stuck&) {}  // refused before the run
  Event say(const Stuck&) const { return {}; }

  void show(Board& board, const Moved<double>& m) {
    shown_ = matrix_;
    View view = drawing(Role::current, true);
    const dvec2 from = panel_.at(m.from), to = panel_.at(m.to);
    view.add({"h moved", Role::candidate, Stroke{from, to, true}});
    view.add({"i moved", Role::candidate, Dot{to}});
    board.detail(std::move(view));
  }
  Event say(const Moved<double>& m) const {
    const auto sum = [&](int y) {
      return sum_text({matrix_[0][y], matrix_[1][y], matrix_[2][y]}, {m.from.x, m.from.y});
    };
    return {.text = "moved",
            .facts = {{"x", m.to.x}, {"y", m.to.y}},
            .words = {{"corner", letter(m.point)}, {"x_sum", sum(0)}, {"y_sum", sum(1)}},
            .key = letter(m.point)};
  }

  void show(Board& board, const steps::Finished&) {
    shown_ = matrix_;
    board.milestone(drawing(Role::result, true));
  }
  Event say(const steps::Finished&) const {
    Event event = ending();
    event.facts = fields_of(matrix_);
    event.level = Level::step;
    return event;
  }

  void show(Board& board, const Reversed&) {
    View view = drawing(Role::result, true);
    const Shape other = task_.reversed();
    view.add({"b reversed", Role::rejected, Path{panel_.at(other), true}});
    view.add({"k reversed", Role::rejected, Label{panel_.at(other[0]), words_.say("reversed.name")}});
    board.milestone(std::move(view));
  }
  Event say(const Reversed&) const {
    const dvec2 other = task_.reversed()[0];
    const bool same = length_between(other, corner(done_)) <= 1e-9 * size_of(world());
    return {.text = same ? "reversed.same" : "reversed",
            .facts = fields_of(matrix_),
            .words = {{"other", other}, {"to", corner(done_)}},
            .ends = true,
            .level = Level::step};
  }

 private:
  std::size_t count() const { return task_.factors.size(); }
  std::string name_of(std::size_t factor) const { return factor_name(words_.wording(), factor); }
  /// Where corner A stands after so many steps.
  dvec2 corner(std::size_t stage) const { return stages_[stage][0]; }
  dvec2 origin() const { return way_ == Way::local ? task_.factors[0].pivot : dvec2{0}; }

  // --- What is told

  /// The matrix as it stands, and a row of it.
  Event standing(Event event) const {
    event.facts = fields_of(matrix_);
    event.row.push_back(done_);
    for (const int y : {0, 1}) {
      for (const int x : {0, 1, 2}) event.row.push_back(matrix_[x][y]);
    }
    return event;
  }
  Event acted(std::string_view text, std::size_t factor) const {
    return standing({.text = text,
                     .words = {{"factor", factor_words(words_.wording(), task_.texts[factor])},
                               {"name", name_of(factor)},
                               {"from", corner(done_ - 1)},
                               {"to", corner(done_)}}});
  }

  /// The distance from the corner that has come out farthest off.
  double furthest(const Shape& right) const {
    double most = 0;
    for (std::size_t i = 0; i < right.size(); ++i)
      most = std::max(most, length_between(right[i], stages_.back()[i]));
    return most;
  }
  Event ending() const {
    const dvec2 to = corner(done_);
    if (way_ == Way::undo) return {.text = "back", .words = {{"error", furthest(task_.shape)}}};
    if (way_ == Way::local) {
      Shape global = task_.shape;
      one_matrix(task_.chain(), std::span(global));
      for (dvec2& p : global) p -= origin();
      return {.text = "local", .words = {{"origin", origin()}, {"to", to}, {"error", furthest(global)}}};
    }
    if (way_ == Way::centre_added) {
      const dvec2 right = task_.after(count())[0];
      return {.text = figure_place(right) == figure_place(to) ? "nothing_wrong" : "went_wrong",
              .words = {{"to", to}, {"right", right}}};
    }
    const double det = determinant(matrix_);
    const bool flat = std::ranges::any_of(
        task_.factors, [](const Factor<double>& factor) { return flattens(factor.linear); });
    return {.text = flat ? "flat" : det < 0 ? "mirrored" : "done", .words = {{"det", det}}};
  }

  // --- The drawing

  /// The shape before the first step.
  Shape first_stage() const {
    Shape first = way_ == Way::undo ? task_.after(count()) : task_.shape;
    for (dvec2& p : first) p -= origin();
    return first;
  }
  /// What the panel has to show.
  Extent world() const {
    Extent world;
    for (std::size_t k = 0; k <= count(); ++k) {
      for (const dvec2 p : task_.after(k)) world.add(p - origin());
    }
    for (const FactorText& text : task_.texts) {
      if (!text.pivot.empty()) world.add(point_of(text.pivot) - origin());
      for (const Tuple& p : text.line) world.add(point_of(p) - origin());
    }
    if (task_.compare) {
      for (const dvec2 p : task_.reversed()) world.add(p - origin());
    }
    if (way_ == Way::centre_added) {
      Shape points = task_.shape;
      centre_added(task_.chain(), std::span(points));
      for (const dvec2 p : points) world.add(p);
    }
    return world;
  }
  /// The largest coordinate of all.
  static double size_of(const Extent& world) {
    return std::max(
        {std::abs(world.lower.x), std::abs(world.lower.y), std::abs(world.upper.x), std::abs(world.upper.y)});
  }
  static Panel panel_for(Extent world) {
    if (world.size() == dvec2{0}) {
      const double room = std::max(1.0, 0.01 * size_of(world));
      world = {world.lower - room, world.upper + room};
    }
    return {Extent{{3.6, 4.6}, {25, 17.4}}, widened(world, 0.08)};
  }

  void milestone(Board& board, Role role) const { board.milestone(drawing(role, false)); }
  void go_on(Board& board, Shape points) {
    ++done_;
    stages_.push_back(std::move(points));
    milestone(board, Role::current);
  }

  /// whole: all factors at once, not what one of them does.
  View drawing(Role role, bool whole) const {
    View view;
    add_axes(view, panel_, "plane", {words_.symbol("x"), words_.symbol("y")});
    formula(view, whole);
    view.add({"b stage 00", Role::input, Path{panel_.at(stages_[0]), true}});
    view.add_named("j corner 00", "k corner 00", Role::input, panel_.at(corner(0)), letter(0));
    for (std::size_t k = 1; k < stages_.size(); ++k) {
      const Role its = k + 1 == stages_.size() ? role : Role::past;
      view.add({fmt::format("b stage {:02}", k), its, Path{panel_.at(stages_[k]), true}});
    }
    if (done_ == 0) return view;
    const dvec2 from = panel_.at(corner(done_ - 1)), to = panel_.at(corner(done_));
    view.add({"a inside", role, Area{{panel_.at(stages_[done_])}}});
    view.add_named("j corner", "k corner", role, to, fmt::format("{}{}", letter(0), done_));
    if (whole) return view;
    if (from != to) view.add({"h way", Role::measure, Stroke{from, to, true, true}});
    keep_still(view);
    return view;
  }

  /// The factor of the last step.
  std::size_t factor() const { return way_ == Way::undo ? count() - done_ : done_ - 1; }

  /// What the current factor leaves where it is: a pivot, or a mirror.
  void keep_still(View& view) const {
    const FactorText& text = task_.texts[factor()];
    const auto at = [&](const Tuple& place) { return panel_.at(point_of(place) - origin()); };
    if (!text.pivot.empty())
      view.add_named("j pivot", "k pivot", Role::boundary, at(text.pivot), words_.say("pivot"), true);
    if (text.line.size() == 2)
      view.add({"d mirror", Role::boundary, Stroke{at(text.line[0]), at(text.line[1])}});
  }

  /// The product as a formula, and a matrix: that of the factor, or the whole.
  void formula(View& view, bool whole) const {
    const std::string m = words_.symbol("M"), inverse = way_ == Way::undo ? "⁻¹" : "";
    std::string product = product_name(words_.wording(), count());
    if (way_ == Way::undo) {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < count(); ++k) names.push_back(name_of(k) + inverse);
      product = chained(names);
    }
    view.add({"l formula", Role::guide, Text{{13, 0.9}, m + inverse + " = " + product}});
    const auto add = [&](const std::string& name, const Matrix<double>& matrix, Role role) {
      add_matrix(view, "m", {25, 22}, name, rows_of(matrix), role);
    };
    if (done_ == 0) return add(m, matrix_, whole ? Role::result : Role::guide);
    if (whole) return add(m + inverse, matrix_, Role::result);
    add(name_of(factor()) + inverse, shown_, Role::current);
  }

  const Words& words_;
  const Task& task_;
  const Way way_;
  std::vector<Shape> stages_;  ///< the shape, and where it stood after each step
  const Panel panel_;
  std::size_t done_ = 0;  ///< steps
  Matrix<double> matrix_{1.0}, shown_{1.0};
};

// --- The methods

/// What stands around the steps.
void introduce(Narrator& narrator, const Task& task, const Panel& panel) {
  require_scale(panel, narrator.arguments(), {"polygon", "factors"});
  narrator.trace().subtitle = factors_words(narrator.words().wording(), task.texts);
  narrator.paper(26, 26);
  narrator.legend({Role::input, Role::past, Role::current, Role::result});
  narrator.last_is_telling();
}

/// What has come out.
void conclude(Narrator& narrator, Story& story, const Task& task, const Shape& points) {
  const auto tell = narrator.watcher(story);
  tell(steps::Finished{}, 0);
  if (task.compare) tell(Reversed{}, 0);
  std::vector<Field> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({fmt::format("{}.x", letter(i)), points[i].x, "x"});
    result.push_back({fmt::format("{}.y", letter(i)), points[i].y, "y"});
  }
  narrator.result(std::move(result));
}

/// Tells a method that takes factors and points.
template <Way way, auto act>
void tell_chain(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  Story story(narrator.words(), task, way);
  introduce(narrator, task, story.panel());
  Shape points = task.shape;
  act(task.chain(), std::span(points), narrator.watcher(story));
  conclude(narrator, story, task, points);
  tell_side_by_side<Numbers>(narrator,
                             [task]<class T>(T, const auto& watch) { run_in<T>(task, act, watch); });
}

constexpr auto from_first_pivot = [](auto factors, auto... run) {
  local_coordinates(factors[0].pivot, factors, run...);
};

/// The way back must exist before it is told.
void require_inverses(const Task& task) {
  for (std::size_t k = 0; k < task.factors.size(); ++k) {
    if (inverse(task.factors[k])) continue;
    const char* why = flattens(task.factors[k].linear)
                          ? "flattens the plane (its determinant is 0), so it has no inverse"
                          : "has no inverse whose numbers are within the range of double";
    refuse("factors", "factor {}: '{}' {} and can't be undone", k + 1, text_of(task.texts[k]), why);
  }
}

void tell_undo(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  require_inverses(task);
  Story story(narrator.words(), task, Way::undo);
  introduce(narrator, task, story.panel());
  const auto watch = narrator.watcher(story);
  Shape points = task.after(task.factors.size());
  watch(Started<double>{Matrix<double>(1.0), points}, 0);
  undo(task.chain(), std::span(points), watch);
  conclude(narrator, story, task, points);
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "affine_2d",
       .chapter = "transformation",
       .aliases = {"2d transformation", "rotation", "scaling", "shear", "reflection",
                   "homogeneous coordinates"},
       .summary = "move, scale, turn, slant and mirror in the plane with one matrix",
       .methods = {{.name = "one_matrix",
                    .standing = Standing::taught,
                    .tell = tell_chain<Way::forwards, [](auto... run) { one_matrix(run...); }>,
                    .exact = true},
                   {.name = "factor_by_factor",
                    .tell = tell_chain<Way::forwards, [](auto... run) { factor_by_factor(run...); }>,
                    .exact = true},
                   {.name = "local_coordinates",
                    .tell = tell_chain<Way::local, from_first_pivot>,
                    .exact = true},
                   {.name = "undo", .tell = tell_undo},
                   {.name = "centre_added",
                    .standing = Standing::faulty,
                    .tell = tell_chain<Way::centre_added, [](auto... run) { centre_added(run...); }>}},
       .columns = {{"k"}, {"xx"}, {"xy"}, {"x0"}, {"yx"}, {"yy"}, {"y0"}},
       .parameters = {{.name = "factors",
                       .type = ParameterType::factors,
                       .default_value = "rotate 30 about 1,1; scale 2 about 1,1",
                       .example = "rotate 30 about 1,1; scale 2 about 1,1",
                       .help = "what is done, in the order of doing; angles in degrees",
                       .parts = coordinates},
                      points(1, 40, "polygon", "3,1 3,2 2,2 2,3 1,3 1,1", "0,0 2,0 2,1 0,1",
                             "the shape's corners", coordinates, {1e-100, 1e100}),
                      choice(
                          "pivots", {"whole", "split"}, "whole", "split",
                          "a factor about a point is one step, or three: there, about the origin, and back"),
                      choice("compare", {"none", "reversed"}, "none", "reversed",
                             "a last step shows the factors in the reverse order"),
                      exact_parameter()},
       .examples = {"--factors 'rotate 30 about 1,1; scale 2 about 1,1'",
                    "--factors 'translate 2,0; rotate 90' --compare reversed",
                    "--factors 'shear 2,1/2' --polygon '0,0 2,0 2,1 0,1'"}});
  return topic;
}

}  // namespace gradus::affine_2d
