// The story of a product of transformations in the plane: which factor acts first, and where the shape goes.

#include "transformation/affine_2d/affine_2d.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "stories/matrix_drawing.hpp"
#include "stories/paper.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"
#include "transformation/affine_2d/affine_2d_notes.hpp"

namespace gradus::affine_2d {
namespace {

using fmt::arg;
using Shape = std::vector<dvec2>;
using Chain = std::span<const Factor<double>>;

constexpr std::string_view folder = "algorithms/transformation/affine_2d/";
const std::vector<std::string> coordinates{"x", "y"};

dvec2 point_of(const Tuple& tuple) { return {tuple[0].value, tuple[1].value}; }

Factor<double> factor_of(const FactorText& text) {
  using Kind = FactorText::Kind;
  const dvec2 pivot = text.pivot.empty() ? dvec2{0} : point_of(text.pivot);
  const auto both = [&] {
    return text.amount.size() == 1 ? dvec2{text.amount[0].value} : point_of(text.amount);
  };
  switch (text.kind) {
    case Kind::translate:
      return translation(both());
    case Kind::scale:
      return scaling(both(), pivot);
    case Kind::rotate:
      return rotation(turn_degrees(text.amount[0].value), pivot);
    case Kind::shear:
      return shearing(both(), pivot);
    case Kind::reflect:
      break;
  }
  switch (text.mirror) {
    case Mirror::x_axis:
      return reflection_in_x_axis<double>();
    case Mirror::y_axis:
      return reflection_in_y_axis<double>();
    case Mirror::origin:
      return reflection_in_origin<double>();
    case Mirror::diagonal:
      return reflection_in_diagonal<double>();
    case Mirror::line:
      break;
  }
  return reflection_in_line(point_of(text.line[0]), point_of(text.line[1]));
}

/// What a run is about.
struct Task {
  std::vector<FactorText> texts;
  std::vector<Factor<double>> factors;
  Shape shape;
  bool compare;  ///< with the reverse order

  Chain chain() const { return factors; }
  /// Where the shape stands after so many factors, each applied by itself.
  Shape after(std::size_t count) const {
    Shape points = shape;
    factor_by_factor(chain().first(count), std::span(points));
    return points;
  }
  /// The same shape with the factors in the reverse order.
  Shape reversed() const {
    const std::vector<Factor<double>> back(factors.rbegin(), factors.rend());
    Shape points = shape;
    one_matrix(Chain(back), std::span(points));
    return points;
  }
};

Task task_of(const Arguments& arguments) {
  Task task;
  task.texts = factors_of(arguments, "factors", coordinates);
  if (arguments.text("pivots") == "split") task.texts = split_at_pivots(task.texts);
  for (const FactorText& text : task.texts) task.factors.push_back(factor_of(text));
  task.shape = arguments.points("polygon");
  task.compare = arguments.text("compare") == "reversed";
  return task;
}

MatrixRows rows_of(const Matrix<double>& m) {
  MatrixRows rows(3);
  for (int y = 0; y < 3; ++y) rows[static_cast<std::size_t>(y)] = {m[0][y], m[1][y], m[2][y]};
  return rows;
}

std::vector<Field> fields_of(const Matrix<double>& m) {
  return {{"xx", m[0].x}, {"xy", m[1].x}, {"x0", m[2].x}, {"yx", m[0].y}, {"yy", m[1].y}, {"y0", m[2].y}};
}

std::string letter(std::size_t corner) {
  return corner < 26 ? std::string(1, static_cast<char>('A' + corner)) : fmt::format("P{}", corner + 1);
}

class Teller {
 public:
  Teller(TraceWriter& writer, const Task& task, const Method& method)
      : writer_(writer), words_(writer.wording()), task_(task), method_(method) {
    writer.trace().columns = {{"k"}, {"xx"}, {"xy"}, {"x0"}, {"yx"}, {"yy"}, {"y0"}};
    set_up();
  }

  void operator()(const Started<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    matrix_ = s.product;
    milestone("Started", line,
              say(undoing() ? "affine_2d.started_undo" : "affine_2d.started",
                  arg("product", product_name(words_, count()))),
              Role::input);
  }

  void operator()(const Rebased<double>& r, int line = __builtin_LINE(), const char* = nullptr) {
    matrix_ = Matrix<double>(1.0);
    const std::string key = "affine_2d.rebased";
    milestone("Rebased", line,
              say(key, arg("origin", figure_place(r.origin)), arg("local", figure_place(r.points[0]))),
              Role::input);
  }

  void operator()(const Multiplied<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    matrix_ = m.product;
    shown_ = m.matrix;
    done_ = m.factor + 1;
    Shape points = stages_[0];
    for (dvec2& p : points) p = transform(m.product, p);
    stages_.push_back(points);
    milestone("Multiplied", line,
              say("affine_2d.multiplied", arg("factor", factor_words(words_, task_.texts[m.factor])),
                  arg("name", factor_name(words_, m.factor)), arg("from", figure_place(corner(done_ - 1))),
                  arg("to", figure_place(corner(done_)))),
              Role::current);
  }

  void operator()(const Acted<double>& a, int line = __builtin_LINE(), const char* = nullptr) {
    shown_ = matrix(task_.factors[a.factor]);
    matrix_ = shown_ * matrix_;
    done_ = a.factor + 1;
    stages_.push_back(a.points);
    milestone("Acted", line,
              say("affine_2d.acted", arg("factor", factor_words(words_, task_.texts[a.factor])),
                  arg("from", figure_place(corner(done_ - 1))), arg("to", figure_place(corner(done_)))),
              Role::current);
  }

  void operator()(const Moved<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    shown_ = matrix_;
    const std::string name = letter(m.point);
    const auto row = [&](int y) {
      return sum_text({matrix_[0][y], matrix_[1][y], matrix_[2][y]}, {m.from.x, m.from.y});
    };
    View view = drawing(Role::current, count(), true);
    const dvec2 from = panel_->at(m.from), to = panel_->at(m.to);
    view.add({"h moved", Role::candidate, Stroke{from, to, true}});
    view.add({"i moved", Role::candidate, Dot{to}});
    fine(std::move(view), "Moved", name, line,
         say("affine_2d.moved", arg("corner", name), arg("x_sum", row(0)), arg("x", figure_real(m.to.x)),
             arg("y_sum", row(1)), arg("y", figure_real(m.to.y))),
         {{"x", m.to.x}, {"y", m.to.y}});
  }

  void operator()(const Undone<double>& u, int line = __builtin_LINE(), const char* = nullptr) {
    shown_ = u.matrix;
    matrix_ = u.matrix * matrix_;
    ++done_;
    stages_.push_back(u.points);
    milestone("Undone", line,
              say("affine_2d.undone", arg("factor", factor_words(words_, task_.texts[u.factor])),
                  arg("name", factor_name(words_, u.factor)), arg("from", figure_place(corner(done_ - 1))),
                  arg("to", figure_place(corner(done_)))),
              Role::current);
  }
  void operator()(const Stuck&) const {}  // refused before the run

  const Panel& panel() const { return *panel_; }

  /// The last step: what has come out.
  void finish() {
    shown_ = matrix_;
    milestone("Finished", 0, ending(), Role::result, true);
    if (!task_.compare) return;
    View view = drawing(Role::result, count(), true);
    const Shape other = task_.reversed();
    view.add({"b reversed", Role::rejected, Path{panel_->at(other), true}});
    view.add({"k reversed", Role::rejected, Label{panel_->at(other[0]), say("affine_2d.reversed.name")}});
    const bool same = length_between(other[0], corner(done_)) <= 1e-9 * size_;
    step(std::move(view), "Reversed", 0,
         say(same ? "affine_2d.reversed.same" : "affine_2d.reversed", arg("other", figure_place(other[0])),
             arg("to", figure_place(corner(done_)))),
         {});
  }

 private:
  template <class... Values>
  std::string say(std::string_view key, const Values&... values) const {
    return words_.say(key, values...);
  }
  std::size_t count() const { return task_.factors.size(); }
  bool undoing() const { return method_.name == "undo"; }
  bool local() const { return method_.name == "local_coordinates"; }
  /// Where corner A stands after so many steps.
  dvec2 corner(std::size_t stage) const { return stages_[stage][0]; }
  dvec2 origin() const { return local() ? task_.factors[0].pivot : dvec2{0}; }

  /// The shape before the first step, and what the panel has to show.
  void set_up() {
    Shape first = undoing() ? task_.after(count()) : task_.shape;
    for (dvec2& p : first) p -= origin();
    stages_ = {first};
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
    if (method_.standing == Standing::faulty) {
      Shape points = task_.shape;
      centre_added(task_.chain(), std::span(points));
      for (const dvec2 p : points) world.add(p);
    }
    for (const double c : {world.lower.x, world.lower.y, world.upper.x, world.upper.y})
      size_ = std::max(size_, std::abs(c));
    if (world.size() == dvec2{0}) {
      const double room = std::max(1.0, 0.01 * size_);
      world = {world.lower - room, world.upper + room};
    }
    panel_.emplace(Extent{{3.6, 4.6}, {25, 17.4}}, widened(world, 0.08));
  }

  std::string ending() const {
    const std::string to = figure_place(corner(done_));
    const auto furthest = [&](const Shape& right) {
      double most = 0;
      for (std::size_t i = 0; i < right.size(); ++i)
        most = std::max(most, length_between(right[i], stages_.back()[i]));
      return most;
    };
    if (undoing()) return say("affine_2d.back", arg("error", figure_real(furthest(task_.shape))));
    if (local()) {
      Shape global = task_.shape;
      one_matrix(task_.chain(), std::span(global));
      for (dvec2& p : global) p -= origin();
      return say("affine_2d.local", arg("origin", figure_place(origin())), arg("to", to),
                 arg("error", figure_real(furthest(global))));
    }
    if (method_.standing == Standing::faulty) {
      const std::string right = figure_place(task_.after(count())[0]);
      if (right == to) return say("affine_2d.nothing_wrong", arg("to", to));
      return say("affine_2d.went_wrong", arg("to", to), arg("right", right));
    }
    const double det = determinant(matrix_);
    bool flat = false;
    for (const Factor<double>& factor : task_.factors) flat = flat || flattens(factor.linear);
    if (flat) return say("affine_2d.flat");
    return say(det < 0 ? "affine_2d.mirrored" : "affine_2d.done", arg("det", figure_real(det)));
  }

  // --- Drawing
  // ------------------------------------------------------------------------------------------------------------

  void outline(View& view, std::string id, Role role, const Shape& shape) const {
    view.add({std::move(id), role, Path{panel_->at(shape), true}});
  }

  View drawing(Role role, std::size_t factor_count, bool whole = false) const {
    View view;
    add_axes(view, *panel_, "plane", {words_.symbol("x"), words_.symbol("y")});
    formula(view, factor_count, whole);
    outline(view, "b stage 00", Role::input, stages_[0]);
    view.add({"j corner 00", Role::input, Dot{panel_->at(corner(0))}});
    view.add({"k corner 00", Role::input, Label{panel_->at(corner(0)), letter(0)}});
    for (std::size_t k = 1; k < stages_.size(); ++k) {
      const bool last = k + 1 == stages_.size();
      if (last) view.add({"a inside", role, Area{{panel_->at(stages_[k])}}});
      outline(view, fmt::format("b stage {:02}", k), last ? role : Role::past, stages_[k]);
      if (!last) continue;
      const dvec2 from = panel_->at(corner(k - 1)), to = panel_->at(corner(k));
      view.add({"j corner", role, Dot{to}});
      view.add({"k corner", role, Label{to, fmt::format("{}{}", letter(0), k)}});
      if (!whole && from != to) view.add({"h way", Role::measure, Stroke{from, to, true, true}});
    }
    if (!whole && done_ > 0) keep_still(view);
    return view;
  }

  /// What the current factor leaves where it is: a pivot, or a mirror.
  void keep_still(View& view) const {
    const FactorText& text = task_.texts[undoing() ? count() - done_ : done_ - 1];
    if (!text.pivot.empty()) {
      const dvec2 at = panel_->at(point_of(text.pivot) - origin());
      view.add({"j pivot", Role::boundary, Dot{at, true}});
      view.add({"k pivot", Role::boundary, Label{at, say("affine_2d.pivot")}});
    }
    if (text.line.size() == 2) {
      view.add({"d mirror", Role::boundary,
                Stroke{panel_->at(point_of(text.line[0]) - origin()),
                       panel_->at(point_of(text.line[1]) - origin())}});
    }
  }

  /// The product as a formula, and a matrix: that of the factor, or the whole.
  void formula(View& view, std::size_t factor_count, bool whole) const {
    const std::string m = words_.symbol("M");
    const std::string inverse = undoing() ? "⁻¹" : "";
    std::string product = m + inverse + " = ";
    if (undoing()) {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < count(); ++k) names.push_back(factor_name(words_, k) + inverse);
      product += chained(names);
    } else {
      product += product_name(words_, factor_count);
    }
    view.add({"l formula", Role::guide, Text{{13, 0.9}, product}});
    const bool none = done_ == 0;
    const std::size_t factor = none ? 0 : undoing() ? count() - done_ : done_ - 1;
    const std::string name =
        whole || none ? m + (none ? "" : inverse) : factor_name(words_, factor) + inverse;
    const Role role = whole ? Role::result : none ? Role::guide : Role::current;
    add_matrix(view, "m", {25, 22}, name, rows_of(whole || none ? matrix_ : shown_), role);
  }

  Row row() const {
    Row cells{figure_number(static_cast<std::int64_t>(done_))};
    for (const int y : {0, 1}) {
      for (const int x : {0, 1, 2}) cells.push_back(figure_real(matrix_[x][y]));
    }
    return cells;
  }

  void describe(TraceStep& step, std::string type, std::string key, std::string sentence,
                std::vector<Field> fields) const {
    step.phase = say(type == "Finished" || type == "Reversed" ? "words.result"
                     : type == "Started" || type == "Rebased" ? "words.set_up"
                                                              : "words.main_loop");
    step.type = std::move(type);
    step.key = std::move(key);
    step.sentence = std::move(sentence);
    step.fields = std::move(fields);
  }
  void step(View view, std::string type, int line, std::string sentence, Row row) {
    writer_.step(before_.change_to(std::move(view)), {}, line, [&](TraceStep& step) {
      describe(step, std::move(type), "", std::move(sentence), fields_of(matrix_));
      step.row = std::move(row);
    });
  }
  void milestone(std::string type, int line, std::string sentence, Role role, bool whole = false) {
    step(drawing(role, count(), whole), std::move(type), line, std::move(sentence), whole ? Row{} : row());
  }
  void fine(View view, std::string type, std::string key, int line, std::string sentence,
            std::vector<Field> fields) {
    writer_.fine(before_.change_to(std::move(view)), {}, line, [&](TraceStep& step) {
      describe(step, std::move(type), std::move(key), std::move(sentence), std::move(fields));
    });
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Task& task_;
  const Method& method_;
  std::optional<Panel> panel_;
  std::vector<Shape> stages_;  ///< the shape, and where it stood after each step
  double size_ = 0;            ///< the largest coordinate of all
  std::size_t done_ = 0;       ///< steps
  Matrix<double> matrix_{1.0}, shown_{1.0};
  Shown before_;
};

std::vector<Method> all_methods() {
  return {method_in_english("affine_2d", "one_matrix", Standing::taught),
          method_in_english("affine_2d", "factor_by_factor", Standing::plain),
          method_in_english("affine_2d", "local_coordinates", Standing::plain),
          method_in_english("affine_2d", "undo", Standing::plain),
          method_in_english("affine_2d", "centre_added", Standing::faulty)};
}

/// The way back must exist before it is told.
void require_inverses(const Task& task) {
  for (std::size_t k = 0; k < task.factors.size(); ++k) {
    if (!inverse(task.factors[k])) {
      const char* why = flattens(task.factors[k].linear)
                            ? "flattens the plane (its determinant is 0), so it has no inverse"
                            : "has no inverse whose numbers are within the range of double";
      throw ArgumentError("factors", fmt::format("factor {}: '{}' {} and can't be undone", k + 1,
                                                 text_of(task.texts[k]), why));
    }
  }
}

void list_source(Trace& trace, std::string_view file, std::string_view function) {
  trace.source_file = std::string(folder) + std::string(file);
  trace.listing = listing_of(source_text(trace.source_file), function);
}

void describe(Trace& trace, const Arguments& arguments, const Task& task, const Method& method) {
  const Wording& words = trace.wording;
  introduce(trace, "affine_2d", arguments, method.standing == Standing::faulty);
  std::vector<std::string> factors;
  for (const FactorText& text : task.texts) factors.push_back(factor_words(words, text));
  trace.subtitle = fmt::format("{}", fmt::join(factors, "; "));
  trace.grid = paper_grid(26, 26);
  trace.legend = {{Role::input, words.say("affine_2d.legend.input")},
                  {Role::past, words.say("affine_2d.legend.past")},
                  {Role::current, words.say("affine_2d.legend.current")},
                  {Role::result, words.say("affine_2d.legend.result")}};
}

/// What the steps of the methods that multiply and move hold. There is nothing to decide.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Started<T>&) const {
    to.type = "Started";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rebased<T>& r) const {
    to.type = "Rebased";
    corners(to, r.points);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Multiplied<T>& m) const {
    to.type = "Multiplied";
    constexpr std::array<std::string_view, 3> columns{"x", "y", "0"};
    for (int column = 0; column < 3; ++column) {
      const auto name = columns[static_cast<std::size_t>(column)];
      to.number(fmt::format("x{}", name), m.product[column].x);
      to.number(fmt::format("y{}", name), m.product[column].y);
    }
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Acted<T>& a) const {
    to.type = "Acted";
    corners(to, a.points);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Moved<T>& m) const {
    to.type = "Moved";
    to.point(letter(m.point), m.to);
  }

 private:
  template <class T>
  static void corners(NumericStep<T>& to, const std::vector<Point<T>>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) to.point(letter(i), points[i]);
  }
};

template <class T>
Factor<T> factor_in(const Factor<double>& factor) {
  const auto& [linear, pivot, shift] = factor;
  return {{in_scalar<T>(linear[0]), in_scalar<T>(linear[1])}, in_scalar<T>(pivot), in_scalar<T>(shift)};
}

/// The factors are the doubles' in all three: what is compared is multiplying and moving.
void put_side_by_side(Trace& trace, const Task& task, const std::string& method) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    std::vector<Factor<T>> factors;
    for (const Factor<double>& factor : task.factors) factors.push_back(factor_in<T>(factor));
    std::vector<Point<T>> points;
    for (const dvec2 p : task.shape) points.push_back(in_scalar<T>(p));
    const std::span<const Factor<T>> chain(factors);
    if (method == "one_matrix") one_matrix(chain, std::span(points), observer);
    if (method == "factor_by_factor") factor_by_factor(chain, std::span(points), observer);
    if (method == "local_coordinates")
      local_coordinates(factors[0].pivot, chain, std::span(points), observer);
  });
}

Trace run(const Arguments& arguments, Recording recording) {
  static const std::vector<Method> methods = all_methods();
  const Method& method = *std::ranges::find(methods, arguments.text("method"), &Method::name);
  const Task task = task_of(arguments);
  if (method.name == "undo") require_inverses(task);
  TraceWriter writer(std::move(recording));
  describe(writer.trace(), arguments, task, method);
  list_source(writer.trace(), method.standing == Standing::faulty ? "affine_2d_notes.hpp" : "affine_2d.hpp",
              method.name);
  Teller teller(writer, task, method);
  require_scale(teller.panel(), arguments, {"polygon", "factors"});
  Shape points = task.shape;
  if (method.name == "one_matrix") one_matrix(task.chain(), std::span(points), teller);
  if (method.name == "factor_by_factor") factor_by_factor(task.chain(), std::span(points), teller);
  if (method.name == "local_coordinates")
    local_coordinates(task.factors[0].pivot, task.chain(), std::span(points), teller);
  if (method.name == "centre_added") centre_added(task.chain(), std::span(points), teller);
  if (method.name == "undo") {
    points = task.after(task.factors.size());
    teller(Started<double>{Matrix<double>(1.0), points}, 0);
    undo(task.chain(), std::span(points), teller);
  }
  teller.finish();
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    trace.result.push_back({fmt::format("{}.x", letter(i)), points[i].x});
    trace.result.push_back({fmt::format("{}.y", letter(i)), points[i].y});
  }
  if (side_by_side(arguments)) {
    require_method(arguments, {"one_matrix", "factor_by_factor", "local_coordinates"});
    put_side_by_side(trace, task, method.name);
  }
  return trace;
}

Parameter choice(std::string name, std::string value, std::string example, std::string help,
                 std::vector<std::string> choices) {
  return {.name = std::move(name),
          .type = ParameterType::choice,
          .default_value = std::move(value),
          .example = std::move(example),
          .help = std::move(help),
          .choices = std::move(choices)};
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "affine_2d",
      .title = Wording().say("affine_2d.title"),
      .chapter = "transformation",
      .aliases = {"2d transformation", "rotation", "scaling", "shear", "reflection",
                  "homogeneous coordinates"},
      .summary = "move, scale, turn, slant and mirror in the plane with one matrix",
      .methods = all_methods(),
      .default_method = "one_matrix",
      .parameters = {{.name = "factors",
                      .type = ParameterType::factors,
                      .default_value = "rotate 30 about 1,1; scale 2 about 1,1",
                      .example = "rotate 30 about 1,1; scale 2 about 1,1",
                      .help = "what is done, in the order of doing; angles in degrees",
                      .parts = coordinates},
                     {.name = "polygon",
                      .type = ParameterType::points,
                      .default_value = "3,1 3,2 2,2 2,3 1,3 1,1",
                      .example = "0,0 2,0 2,1 0,1",
                      .help = "the shape's corners",
                      .least = 1,
                      .most = 40,
                      .parts = coordinates,
                      .sizes = {1e-100, 1e100}},
                     choice("pivots", "whole", "split",
                            "a factor about a point is one step, or three: there, about the origin, and back",
                            {"whole", "split"}),
                     choice("compare", "none", "reversed",
                            "a last step shows the factors in the reverse order", {"none", "reversed"}),
                     exact_parameter()},
      .examples = {"--factors 'rotate 30 about 1,1; scale 2 about 1,1'",
                   "--factors 'translate 2,0; rotate 90' --compare reversed",
                   "--factors 'shear 2,1/2' --polygon '0,0 2,0 2,1 0,1'"},
      .run = run};
  return topic;
}

}  // namespace gradus::affine_2d
