// The stories of transformations in space: a product and its reverse side by side, a turn round any axis by
// parts, and the same by vectors.

#include "stories/parameters.hpp"
#include "stories/side_by_side.hpp"
#include "stories/transformation/affine_3d/turn_story.hpp"

namespace gradus::affine_3d {
namespace {

using Chain = std::span<const Mat>;

// --- A product, and its reverse beside it

class ProductStory {
 public:
  /// rows: points as rows, and beside them as columns.
  ProductStory(const Words& words, const Subject& subject, bool rows)
      : words_(words), subject_(subject), by_rows_(rows), stages_(stages(subject.factors, rows)) {
    if (rows) {
      others_ = stages(subject.factors, false);
    } else if (subject.compare && subject.factors.size() > 1) {
      reversed_.assign(subject.factors.rbegin(), subject.factors.rend());
      others_ = stages(reversed_, false);
    }
    Extent world = world_of_axes(reach());
    for (const auto* list : {&stages_, &others_}) {
      for (const Shape& shape : *list) far_ = std::max(far_, 1.5 * length_between(shape[0], shape[7]));
    }
    for (const auto* list : {&stages_, &others_}) {
      for (const Shape& shape : *list) add_to(world, nearer(shape, far_));
    }
    world = widened(world, 0.005);
    panels_.push_back(others_.empty() ? Panel(single_place, world) : at_the_top(left_place, world));
    if (!others_.empty()) panels_.push_back(at_the_top(right_place, world));
  }
  const Panel& panel() const { return panels_[0]; }

  void show(Board& board, const Started<double>&) { milestone(board, Role::input); }
  Event say(const Started<double>&) const {
    return standing({.text = by_rows_ ? "started_rows" : "started",
                     .words = {{"product", product_name(words_.wording(), subject_.factors.size())}}});
  }

  void show(Board& board, const Multiplied<double>& m) {
    done_ = m.factor + 1;
    product_ = m.product;
    milestone(board, Role::current);
  }
  Event say(const Multiplied<double>& m) const {
    return standing({.text = "multiplied",
                     .words = {{"factor", factor_words(words_.wording(), subject_.texts[m.factor])},
                               {"name", factor_name(words_.wording(), m.factor)},
                               {"from", stages_[done_ - 1][corner_a]},
                               {"to", stages_[done_][corner_a]}},
                     .phase = factor_name(words_.wording(), m.factor) + ": " +
                              factor_words(words_.wording(), subject_.texts[m.factor])});
  }

  // The corners are drawn with each factor
  void show(Board&, const Transformed<double>&) {}
  void show(Board&, const RowTransformed<double>&) {}
  Event say(const Transformed<double>&) const { return {}; }
  Event say(const RowTransformed<double>&) const { return {}; }

  void show(Board& board, const steps::Finished&) { milestone(board, Role::result); }
  Event say(const steps::Finished&) const {
    const dvec3 to = stages_.back()[corner_a];
    Event event{.text = "done", .facts = fields_of(to), .words = {{"to", to}}, .level = Level::step};
    if (others_.empty()) return event;
    const dvec3 other = others_.back()[corner_a];
    event.text = by_rows_ ? "rows" : same_place(to, other) ? "same" : "orders";
    event.words.insert(
        event.words.end(),
        {{"w", transform_row(stages_[0][corner_a], product_).w}, {"right", other}, {"other", other}});
    return event;
  }

 private:
  /// Near the matrix above it, also where it is as wide as its place.
  static Panel at_the_top(Extent place, const Extent& world) {
    place.lower.y = place.upper.y - Panel(place, world).scale().y * world.size().y;
    return {place, world};
  }
  /// The box after each factor.
  std::vector<Shape> stages(const std::vector<Mat>& factors, bool rows) const {
    const Shape box = box_of(subject_.size);
    std::vector<Shape> list{box};
    Mat product(1);
    for (const Mat& m : factors) {
      product = m * product;
      list.push_back(rows ? Shape{} : moved(product, box));
      if (!rows) continue;
      for (const dvec3 p : box) list.back().emplace_back(transform_row(p, product));
    }
    return list;
  }
  /// But for rounding, as far as A comes in either order.
  bool same_place(dvec3 a, dvec3 b) const {
    double size = 0;
    for (const auto* list : {&stages_, &others_}) {
      for (const Shape& shape : *list) size = std::max(size, length_between(shape[corner_a], dvec3(0)));
    }
    return length_between(a, b) <= 1e-9 * size;
  }
  Event standing(Event event) const {
    const dvec3 a = stages_[done_][corner_a];
    event.facts = fields_of(a);
    event.row = row_of(done_, a);
    return event;
  }

  void milestone(Board& board, Role role) const {
    View view;
    half(view, 0, stages_, role);
    if (!others_.empty()) half(view, 1, others_, role);
    const Role now = done_ > 0 ? role : Role::input;
    if (others_.empty()) {
      const double x = 0.5 * (single_place.upper.x + paper_width) - 0.4;
      add_product(view, "m 0", {x, 24.1}, 16.8, product_, product(0), now, words_);
    } else {
      add_titled(view, 0, product_, now);
      add_titled(view, 1, by_rows_ ? product_ : product_of(reversed_), now);
    }
    board.milestone(std::move(view));
  }
  /// The matrix over a half, its name and what the half shows beside it; where it is wide, above.
  void add_titled(View& view, std::size_t i, const Mat& m, Role role) const {
    constexpr double wide = 16.8, top = 25, middle = top - 3.25, beside = 8.2;
    const Extent& place = i == 0 ? left_place : right_place;
    const MatrixRows rows = gradus::fitted(rows_of(m, words_), wide);
    const dvec2 size = matrix_size(rows);
    const std::string id = fmt::format("m {}", i);
    if (size.x > wide - beside) {
      add_product(view, id, {place.centre().x, top + 2}, wide, m, title(i) + ": " + product(i), role, words_);
      return;
    }
    const dvec2 at{place.upper.x - size.x - 1.1, middle - 1};
    add_matrix(view, id, {place.upper.x - 0.5, middle}, "", rows, role, true);
    view.add({id + " name", role, Text{at, product(i), Align::right, true}});
    view.add({id + " above", role, Text{at, title(i), Align::right, false, -1}});
  }
  void half(View& view, std::size_t i, const std::vector<Shape>& list, Role role) const {
    const std::string id = i == 0 ? "left" : "right";
    const Panel& panel = panels_[i];
    SpaceDrawing space = drawing_in(panel);
    add_axes_of_space(view, space, panel, id, reach(), words_);
    if (done_ > 0) add_given(space, id + " 0", list[0]);
    if (done_ > 1) add_outline(space, id + " 1", Role::past, nearer(list[done_ - 1], far_));
    const Shape now = nearer(list[done_], far_);
    add_box(space, id + " 2", done_ > 0 ? role : Role::input, now);
    space.add_to(view, "a " + id);
    add_dot(view, panel, id + " corner", done_ ? role : Role::input, now[corner_a], "A");
    if (now != list[done_]) add_broken_way(view, panel, id, middle_of(now), words_.say("nearer"));
  }
  /// Of the factors that have acted.
  Mat product_of(const std::vector<Mat>& factors) const {
    Mat product(1);
    for (std::size_t k = 0; k < done_; ++k) product = factors[k] * product;
    return product;
  }
  /// What tells one half from the other.
  std::string title(std::size_t half) const {
    if (by_rows_) return words_.say(half == 0 ? "as_row" : "as_column");
    return words_.say(half == 0 ? "as_given" : "reversed");
  }
  /// What acts on the points of this picture by now: "M2·M1 =".
  std::string product(std::size_t half) const {
    const std::size_t n = subject_.factors.size();
    if (half == 0 || by_rows_ || done_ == 0) return product_name(words_.wording(), done_) + " =";
    std::vector<std::string> names;
    for (std::size_t k = n - done_; k < n; ++k) names.push_back(factor_name(words_.wording(), k));
    return chained(words_.wording(), std::move(names)) + " =";
  }
  /// The axis of x ends beyond what lies along it, that of y below the matrix.
  dvec3 reach() const { return reach_of(subject_.size) * dvec3{1.06, 0.95, 1}; }

  const Words& words_;
  const Subject& subject_;
  const bool by_rows_;
  std::vector<Shape> stages_, others_;
  std::vector<Mat> reversed_;  ///< the factors, where their reverse order is shown
  std::vector<Panel> panels_;
  double far_ = 0;  ///< from there on boxes are drawn nearer
  std::size_t done_ = 0;
  Mat product_{1};
};

// --- Side by side with exact numbers

/// What the steps of turn_vector hold, and of products of matrices.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>&, const Started<T>&) const {}
  template <class T>
  void operator()(NumericStep<T>& to, const Multiplied<T>& m) const {
    constexpr std::array<std::string_view, 4> columns{"x", "y", "z", "0"};
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        to.number(fmt::format("{}{}", "xyz"[row], columns[static_cast<std::size_t>(column)]),
                  m.product[column][row]);
      }
    }
  }
  template <class T>
  void operator()(NumericStep<T>&, const Transformed<T>&) const {}  // told with each factor, none alone
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.point("r", p.r);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rejected<T>& r) const {
    to.point("s", r.s);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Crossed<T>& c) const {
    to.point("v", c.v);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Turned<T>& t) const {
    to.point("P′", t.to);
  }
};

template <class T>
Matrix<T> matrix_in(const Mat& m) {
  Matrix<T> result(T(1));
  for (int column = 0; column < 4; ++column) result[column] = in_scalar<T>(m[column]);
  return result;
}

/// The factors are the doubles' in all three.
template <class T>
void one_matrix_in(const Subject& subject, const auto& observer) {
  std::vector<Matrix<T>> factors;
  for (const Mat& m : subject.factors) factors.push_back(matrix_in<T>(m));
  std::vector<Point<T>> corners;
  for (const dvec3 p : box_of(subject.size)) corners.push_back(in_scalar<T>(p));
  one_matrix(std::span<const Matrix<T>>(factors), std::span(corners), observer);
}
/// The axis of length 1 and the turn are.
template <class T>
void turn_vector_in(const Subject& subject, const auto& observer) {
  const Turn<double> turn = turn_degrees(subject.angle);
  turn_vector(in_scalar<T>(direction_of(subject.axis)), in_scalar<T>(subject.through),
              Turn<T>{T(turn.sin), T(turn.cos), T(turn.versine)}, in_scalar<T>(subject.point), observer);
}

// --- The methods

/// What stands around the steps.
void introduce(Narrator& narrator) {
  narrator.paper(paper_width, paper_height);
  narrator.legend({Role::input, Role::past, Role::current, Role::result});
}
void introduce_turn(Narrator& narrator, const Subject& subject) {
  introduce(narrator);
  narrator.subtitle("subtitle",
                    {{"angle", subject.angle}, {"axis", subject.axis}, {"through", subject.through}});
}

void tell_product(Narrator& narrator, const Subject& subject, bool rows) {
  introduce(narrator);
  narrator.shows_matrices();
  narrator.trace().grid.lines = least_unit_of_four_rows;
  narrator.trace().subtitle = factors_words(narrator.words().wording(), subject.texts);
  ProductStory story(narrator.words(), subject, rows);
  require_scale(story.panel(), narrator.arguments(), {"box", "factors"});
  narrator.handles("box", [&](dvec3 corner) { return story.panel().at(oblique(corner)); });
  narrator.telling({std::ssize(subject.factors), 0});  // all factors have acted
  const auto watch = narrator.watcher(story);
  Shape box = box_of(subject.size);
  rows ? row_vectors(Chain(subject.factors), std::span(box), watch)
       : one_matrix(Chain(subject.factors), std::span(box), watch);
  watch(steps::Finished{}, 0);
  narrator.result(fields_of(box[corner_a]));
}
void tell_one_matrix(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  tell_product(narrator, subject, false);
  tell_side_by_side<Numbers>(narrator,
                             [subject]<class T>(T, const auto& watch) { one_matrix_in<T>(subject, watch); });
}
void tell_row_vectors(Narrator& narrator) { tell_product(narrator, subject_of(narrator.arguments()), true); }

void tell_decomposition(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  introduce_turn(narrator, subject);
  narrator.shows_matrices();
  narrator.trace().grid.lines = least_unit_of_matrices;
  PartsStory story(narrator.words(), subject);
  const auto watch = narrator.watcher(story);
  watch(Input{}, 0);
  require_scale(story.panel(), narrator.arguments(), {"box", "through"});
  narrator.handles("axis", [&](dvec3 axis) { return story.axis_at(subject.through, axis).b; });
  narrator.handles("through", [&](dvec3 through) { return story.axis_at(through, subject.axis).a; });
  narrator.handles("box", [&](dvec3 corner) { return story.panel().at(oblique(corner)); });
  const Mat m = decomposition(subject.through, alignment(subject.axis), turn_degrees(subject.angle), watch);
  watch(steps::Finished{}, 0);
  narrator.result(fields_of(transform(m, box_of(subject.size)[corner_a])));
}

void tell_vectors(Narrator& narrator, const Subject& subject, bool constant) {
  introduce_turn(narrator, subject);
  narrator.columns({{"vector", false}, {"x"}, {"y"}, {"z"}});
  VectorStory story(narrator.words(), subject, constant);
  const auto watch = narrator.watcher(story);
  watch(Input{}, 0);
  require_scale(story.panel(), narrator.arguments(), {"point", "through"});
  narrator.handles("axis", [&](dvec3 axis) { return story.tip_at(axis); });
  for (const std::string_view point : {"through", "point"})
    narrator.handles(point, [&](dvec3 p) { return story.at(p); });
  const dvec3 n = direction_of(subject.axis);
  const Turn<double> turn = turn_degrees(subject.angle);
  narrator.result(fields_of(constant ? constant_offset(n, subject.through, turn, subject.point, watch)
                                     : turn_vector(n, subject.through, turn, subject.point, watch)));
}
void tell_turn_vector(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  tell_vectors(narrator, subject, false);
  tell_side_by_side<Numbers>(narrator,
                             [subject]<class T>(T, const auto& watch) { turn_vector_in<T>(subject, watch); });
}
void tell_constant_offset(Narrator& narrator) {
  tell_vectors(narrator, subject_of(narrator.arguments()), true);
  narrator.add_to_legend(Role::rejected, "rejected");
}

Parameter triple(std::string name, std::string value, std::string help) {
  return parameters::numbers(std::move(name), value, value, std::move(help), coordinates, {1e-100, 1e100});
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "affine_3d",
       .chapter = "transformation",
       .aliases = {"3d transformation", "rodrigues", "rotation about an axis", "4x4 matrices"},
       .summary = "move, scale and turn in space; turns round any axis, by parts and by vectors",
       .methods =
           {{.name = "one_matrix", .standing = Standing::taught, .tell = tell_one_matrix, .exact = true},
            {.name = "decomposition", .tell = tell_decomposition},
            {.name = "turn_vector", .tell = tell_turn_vector, .exact = true},
            {.name = "row_vectors",
             .standing = Standing::faulty,
             .tell = tell_row_vectors,
             .of_columns = true},
            {.name = "constant_offset", .standing = Standing::faulty, .tell = tell_constant_offset}},
       .columns = {{"k"}, {"x"}, {"y"}, {"z"}},
       .parameters =
           {{.name = "factors",
             .type = ParameterType::factors,
             .default_value = "rotate 90 about x; rotate 90 about y",
             .example = "rotate 30 about 0,1,1 through 1,1,0; translate 0,0,1",
             .help = "one_matrix, row_vectors: what is done, in the order of doing; angles in degrees",
             .parts = coordinates},
            choice("orders", {"one", "both"}, "both", "one",
                   "one_matrix: the factors in the reverse order beside it"),
            triple("axis", "0,1,1",
                   "decomposition, turn_vector, constant_offset: the direction of the axis, not 0,0,0"),
            triple("through", "1,1,0", "decomposition, turn_vector, constant_offset: a point on the axis"),
            {"angle", ParameterType::number, "30", "60",
             "decomposition, turn_vector, constant_offset: the turn in degrees", -1'000'000, 1'000'000},
            triple("point", "3,1,1", "turn_vector, constant_offset: the point that turns"),
            triple("box", "2,3,1", "width, height and depth of the box with the F, one corner in the origin"),
            exact_parameter()},
       .examples = {"--factors 'rotate 90 about x; rotate 90 about y'",
                    "--method decomposition --axis 0,1,1 --through 1,1,0 --angle 30",
                    "--method turn_vector --axis 1,2,3 --angle 60"}});
  return topic;
}

}  // namespace gradus::affine_3d
