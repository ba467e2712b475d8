// The story of a product of transformations in the plane: which factor acts first, and where the shape goes.

#include "stories/parameters.hpp"
#include "stories/transformation/affine_2d/checking.hpp"
#include "stories/transformation/affine_2d/drawing.hpp"
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
  Story(const Words& words, const Subject& subject, Way way)
      : words_(words),
        subject_(subject),
        way_(way),
        stages_{first_stage()},
        layout_(words.wording(), subject, way == Way::undo, world(), largest_shape()) {}

  const Panel& panel() const { return layout_.panel(); }
  /// Where the first drawing shows a point of the polygon.
  dvec2 shown_first(dvec2 p) const { return frames(false).before.at(first(p)); }

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
      const bool shear = is_shear(subject_.factors[m.factor]);
      event.decides =
          yes_or_no(words_, "question.shear", {{"name", name_of(m.factor)}}, shear, "shear", "other");
    }
    return event;
  }

  void show(Board& board, const Acted<double>& a) {
    shown_ = matrix(subject_.factors[a.factor]);
    matrix_ = shown_ * matrix_;
    one_matrix_ = false;
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
    const auto [before, after, apart] = frames(true);
    const dvec2 to = after.at(m.to);
    view.add({"h moved", Role::candidate, Stroke{before.at(m.from), to, true}});
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

  void show(Board& board, const Reversed&) { board.milestone(drawing(Role::result, true)); }
  Event say(const Reversed&) const {
    const dvec2 other = subject_.reversed()[0];
    const bool same = length_between(other, corner(done_)) <= 1e-9 * size_of(world());
    return {.text = same ? "reversed.same" : "reversed",
            .facts = fields_of(matrix_),
            .words = {{"other", other}, {"to", corner(done_)}},
            .ends = true,
            .level = Level::step};
  }

 private:
  std::size_t count() const { return subject_.factors.size(); }
  std::string name_of(std::size_t factor) const { return factor_name(words_.wording(), factor); }
  /// Where corner A stands after so many steps.
  dvec2 corner(std::size_t stage) const { return stages_[stage][0]; }
  dvec2 origin() const { return way_ == Way::local ? subject_.factors[0].pivot : dvec2{0}; }

  // --- What is told

  /// The matrix as it stands, and a row of it.
  Event standing(Event event) const {
    event.facts = fields_of(matrix_);
    const dvec2 a = corner(done_);
    event.row = {done_, a.x, a.y, determinant(matrix_)};
    return event;
  }
  Event acted(std::string_view text, std::size_t factor) const {
    return standing(
        {.text = text,
         .words = {{"factor", factor_words(words_.wording(), subject_.texts[factor])},
                   {"name", name_of(factor)},
                   {"from", corner(done_ - 1)},
                   {"to", corner(done_)}},
         .phase = name_of(factor) + ": " + factor_words(words_.wording(), subject_.texts[factor])});
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
    if (way_ == Way::undo) return {.text = "back", .words = {{"error", furthest(subject_.shape)}}};
    if (way_ == Way::local) {
      Shape global = subject_.shape;
      one_matrix(subject_.chain(), std::span(global));
      for (dvec2& p : global) p -= origin();
      return {.text = "local", .words = {{"origin", origin()}, {"to", to}, {"error", furthest(global)}}};
    }
    if (way_ == Way::centre_added) {
      const dvec2 right = subject_.after(count())[0];
      return {.text = figure_place(right) == figure_place(to) ? "nothing_wrong" : "went_wrong",
              .words = {{"to", to}, {"right", right}}};
    }
    const double det = determinant(matrix_);
    const bool flat = std::ranges::any_of(
        subject_.factors, [](const Factor<double>& factor) { return flattens(factor.linear); });
    const bool same = figure_real(det) == "1";
    return {.text = flat      ? "flat"
                    : det < 0 ? "mirrored"
                    : same    ? "done_same"
                              : "done",
            .words = {{"det", det}}};
  }

  // --- The drawing

  /// The shape before the first step.
  Shape first_stage() const {
    Shape shape = subject_.shape;
    for (dvec2& p : shape) p = first(p);
    return shape;
  }
  dvec2 first(dvec2 p) const {
    if (way_ == Way::undo) factor_by_factor(subject_.chain(), std::span(&p, 1));
    return p - origin();
  }
  /// What the panel has to show.
  Extent world() const {
    Extent world;
    for (std::size_t k = 0; k <= count(); ++k) {
      for (const dvec2 p : subject_.after(k)) world.add(p - origin());
    }
    for (const FactorText& text : subject_.texts) {
      if (!text.pivot.empty()) world.add(point_of(text.pivot) - origin());
      for (const Tuple& p : text.line) world.add(point_of(p) - origin());
    }
    if (subject_.compare) {
      for (const dvec2 p : subject_.reversed()) world.add(p - origin());
    }
    for (std::size_t k = 1; way_ == Way::centre_added && k <= count(); ++k) {
      Shape points = subject_.shape;
      centre_added(subject_.chain().first(k), std::span(points));
      for (const dvec2 p : points) world.add(p);
    }
    return world;
  }
  /// The largest coordinate of all.
  static double size_of(const Extent& world) {
    return std::max(
        {std::abs(world.lower.x), std::abs(world.lower.y), std::abs(world.upper.x), std::abs(world.upper.y)});
  }
  /// The length or height of the largest shape on the way.
  double largest_shape() const {
    double most = 0;
    for (std::size_t k = 0; k <= count(); ++k)
      most = std::max(most, longer_side(extent_of(subject_.after(k))));
    return most;
  }

  void milestone(Board& board, Role role) const { board.milestone(drawing(role, false)); }
  void go_on(Board& board, Shape points) {
    ++done_;
    stages_.push_back(std::move(points));
    milestone(board, Role::current);
  }

  /// Where this drawing shows the shape before and after: in one panel, unless they are far apart.
  Layout::Frames frames(bool whole) const {
    const Shape& before = stages_[whole || done_ == 0 ? 0 : done_ - 1];
    return layout_.frames(extent_of(before), extent_of(stages_[done_]));
  }

  /// whole: all factors at once, not what one of them does.
  View drawing(Role role, bool whole) const {
    View view;
    const Layout::Frames at = frames(whole);
    layout_.add_frames(view, at, {words_.symbol("x"), words_.symbol("y")});
    add_matrices(view, whole);
    for (std::size_t k = 0; k < done_ || k == 0; ++k)
      add_stage(view, at, k, k == 0 ? Role::input : Role::past);
    add_corners(view, at, role);
    if (done_ == 0) return view;
    if (subject_.compare && done_ == count()) add_reversed(view, at.after);
    add_stage(view, at, done_, role);
    view.add({"a inside", role, Area{{at.after.at(stages_[done_])}}});
    if (whole) return view;
    add_way(view, at);
    if (!at.apart) keep_still(view, at.after);
    return view;
  }

  /// Where the shape would be with the factors in the reverse order.
  void add_reversed(View& view, const Panel& panel) const {
    const Shape other = subject_.reversed();
    if (!panel.shown().holds(other[0])) return;
    view.add({"b reversed", Role::rejected, Path{panel.at(other), true}});
    view.add({"k reversed", Role::rejected, Label{panel.at(other[0]), words_.say("reversed.name")}});
  }

  /// The outline of the shape after so many steps, where it is shown.
  void add_stage(View& view, const Layout::Frames& at, std::size_t k, Role role) const {
    for (const Panel* panel : {&at.before, &at.after}) {
      const Extent shown = widened(panel->shown(), 1e-9);
      const auto is_shown = [&](dvec2 p) { return shown.holds(p); };
      if (!std::ranges::all_of(stages_[k], is_shown)) continue;
      view.add({fmt::format("b stage {:02}", k), role, Path{panel->at(stages_[k]), true}});
    }
  }

  /// Corner A with the number of each stage; of many the first and the last ones, and where it stood still
  /// the last one alone.
  void add_corners(View& view, const Layout::Frames& at, Role role) const {
    const double near = 1e-6 * longer_side(at.after.shown());
    for (std::size_t k = 0; k <= done_; ++k) {
      const dvec2 a = corner(k);
      const auto stays = [&](const Shape& later) { return length_between(later[0], a) <= near; };
      const bool last = k == done_, many = k > 0 && k + 3 < done_;
      const Panel& panel = last || at.after.shown().holds(a) ? at.after : at.before;
      if (!last && (many || std::any_of(stages_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                        stages_.begin() + static_cast<std::ptrdiff_t>(done_) + 1, stays)))
        continue;
      if (!panel.shown().holds(a)) continue;
      const std::string id = last && done_ > 0 ? "corner" : fmt::format("corner {:02}", k);
      view.add_named("j " + id, "k " + id,
                     last && k > 0 ? role
                     : k == 0      ? Role::input
                                   : Role::past,
                     panel.at(a), k == 0 ? letter(0) : fmt::format("{}{}", letter(0), k));
    }
  }

  /// How corner A has come from where it was: straight, or round the pivot.
  void add_way(View& view, const Layout::Frames& at) const {
    const dvec2 from = corner(done_ - 1), to = corner(done_);
    if (from == to) return;
    const FactorText& text = subject_.texts[factor()];
    if (at.apart || text.kind != FactorText::Kind::rotate) {
      view.add({"h way", Role::measure, Stroke{at.before.at(from), at.after.at(to), true}});
      return;
    }
    const dvec2 pivot = (text.pivot.empty() ? dvec2{0} : point_of(text.pivot)) - origin();
    const double degrees = (way_ == Way::undo ? -1 : 1) * text.amount[0].value;
    Path arc{arc_round(pivot, from, std::remainder(degrees, 720))};
    arc.points = at.after.at(arc.points);
    const dvec2 last = arc.points[arc.points.size() - 2], tip = arc.points.back(),
                middle = arc.points[arc.points.size() / 2];
    for (const dvec2 end : {from, to}) {
      view.add({end == from ? "c arm from" : "c arm to", Role::guide,
                Stroke{at.after.at(pivot), at.after.at(end)}});
    }
    view.add({"h way", Role::measure, std::move(arc)});
    view.add({"h way tip", Role::measure, Stroke{last, tip, true}});
    view.add({"k way", Role::measure, Label{middle, figure_real(degrees) + "°"}});
  }

  /// The factor of the last step.
  std::size_t factor() const { return way_ == Way::undo ? count() - done_ : done_ - 1; }

  /// What the current factor leaves where it is: a pivot, or a mirror.
  void keep_still(View& view, const Panel& panel) const {
    const FactorText& text = subject_.texts[factor()];
    const auto at = [&](const Tuple& place) { return panel.at(point_of(place) - origin()); };
    if (!text.pivot.empty())
      view.add_named("j pivot", "k pivot", Role::boundary, at(text.pivot), words_.say("pivot"), true);
    if (text.kind == FactorText::Kind::reflect) add_mirror(view, panel, text);
  }
  /// All of the mirror that the panel shows.
  void add_mirror(View& view, const Panel& panel, const FactorText& text) const {
    dvec2 a{0}, b{text.mirror != Mirror::y_axis, text.mirror != Mirror::x_axis};
    if (text.mirror == Mirror::line) a = point_of(text.line[0]), b = point_of(text.line[1]);
    a -= origin(), b -= origin();
    if (text.mirror == Mirror::origin)
      return view.add_named("j pivot", "k pivot", Role::boundary, panel.at(a), words_.say("pivot"), true);
    constexpr double any = std::numeric_limits<double>::max();
    const auto [from, to] = span_in(panel.shown(), a, b - a, -any, any);
    if (from >= to) return;
    const dvec2 end = panel.at(a + to * (b - a));
    view.add({"d mirror", Role::boundary, Stroke{panel.at(a + from * (b - a)), end}});
    view.add({"k mirror", Role::boundary, Label{end, words_.say("mirror")}});
  }

  /// The names of the factors that have acted, the last one first, as a product.
  std::string product_so_far() const {
    if (way_ != Way::undo) return product_name(words_.wording(), done_);
    std::vector<std::string> names;
    for (std::size_t k = count() - done_; k < count(); ++k) names.push_back(name_of(k) + "⁻¹");
    return chained(words_.wording(), std::move(names));
  }

  /// The matrix of the last factor, and the product so far; whole: only this.
  void add_matrices(View& view, bool whole) const {
    const std::string inverse = way_ == Way::undo ? "⁻¹" : "";
    const std::string product = words_.symbol("M") + inverse;
    std::vector<Layout::Named> matrices;
    if (done_ > 0 && !whole)
      matrices.push_back({name_of(factor()) + inverse, rows_of(shown_), Role::current});
    if (done_ == 0) matrices.push_back({product, rows_of(matrix_), Role::guide});
    if (done_ > 0 && (whole || (one_matrix_ && done_ > 1)))
      matrices.push_back({(whole ? product + " = " : "") + product_so_far(), rows_of(matrix_),
                          whole ? Role::result : Role::guide});
    layout_.add_matrices(view, matrices);
  }

  const Words& words_;
  const Subject& subject_;
  const Way way_;
  std::vector<Shape> stages_;  ///< the shape, and where it stood after each step
  const Layout layout_;
  std::size_t done_ = 0;    ///< steps
  bool one_matrix_ = true;  ///< the factors are multiplied, not used one by one
  Matrix<double> matrix_{1.0}, shown_{1.0};
};

// --- The methods

/// What stands around the steps.
void introduce(Narrator& narrator, const Subject& subject, const Story& story) {
  require_scale(story.panel(), narrator.arguments(), {"polygon", "factors"});
  narrator.handles("polygon", [&](dvec2 p) { return story.shown_first(p); });
  narrator.shows_matrices();
  narrator.trace().subtitle = factors_words(narrator.words().wording(), subject.texts);
  narrator.paper(36, 24);
  narrator.legend({Role::input, Role::past, Role::current, Role::result, Role::measure, Role::rejected});
  narrator.telling({static_cast<std::int64_t>(subject.factors.size()), 0});
}

/// What has come out.
void conclude(Narrator& narrator, Story& story, const Subject& subject, const Shape& points) {
  const auto tell = narrator.watcher(story);
  tell(steps::Finished{}, 0);
  if (subject.compare) tell(Reversed{}, 0);
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
  const Subject subject = subject_of(narrator.arguments());
  Story story(narrator.words(), subject, way);
  introduce(narrator, subject, story);
  Shape points = subject.shape;
  act(subject.chain(), std::span(points), narrator.watcher(story));
  conclude(narrator, story, subject, points);
  tell_side_by_side<Numbers>(narrator,
                             [subject]<class T>(T, const auto& watch) { run_in<T>(subject, act, watch); });
}

constexpr auto from_first_pivot = [](auto factors, auto... run) {
  local_coordinates(factors[0].pivot, factors, run...);
};

/// The way back must exist before it is told.
void require_inverses(const Subject& subject) {
  for (std::size_t k = 0; k < subject.factors.size(); ++k) {
    if (inverse(subject.factors[k])) continue;
    const char* why = flattens(subject.factors[k].linear)
                          ? "flattens the plane (its determinant is 0), so it has no inverse"
                          : "has no inverse whose numbers are within the range of double";
    refuse("factors", "factor {}: '{}' {} and can't be undone", k + 1, text_of(subject.texts[k]), why);
  }
}

void tell_undo(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  require_inverses(subject);
  Story story(narrator.words(), subject, Way::undo);
  introduce(narrator, subject, story);
  const auto watch = narrator.watcher(story);
  Shape points = subject.after(subject.factors.size());
  watch(Started<double>{Matrix<double>(1.0), points}, 0);
  undo(subject.chain(), std::span(points), watch);
  conclude(narrator, story, subject, points);
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
       .columns = {{"k"}, {"ax"}, {"ay"}, {"det"}},
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
                      choice("orders", {"one", "both"}, "one", "both",
                             "both: a last step shows the factors in the reverse order"),
                      exact_parameter()},
       .examples = {"--factors 'rotate 30 about 1,1; scale 2 about 1,1'",
                    "--factors 'translate 2,0; rotate 90' --orders both",
                    "--factors 'shear 2,1/2' --polygon '0,0 2,0 2,1 0,1'"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::affine_2d
