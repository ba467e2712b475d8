// The stories of transformations in space: a product and its reverse side by side, a turn round any axis by
// parts, and the same by vectors.

#include "transformation/affine_3d/affine_3d.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/record.hpp"
#include "stories/matrix_drawing.hpp"
#include "stories/paper.hpp"
#include "stories/side_by_side.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"
#include "transformation/affine_3d/affine_3d_notes.hpp"

namespace gradus::affine_3d {
namespace {

using fmt::arg;
using Mat = Matrix<double>;
using Shape = std::vector<dvec3>;
using Chain = std::span<const Mat>;

constexpr std::string_view folder = "algorithms/transformation/affine_3d/";
const std::vector<std::string> coordinates{"x", "y", "z"};

dvec3 point_of(const Tuple& tuple) { return {tuple[0].value, tuple[1].value, tuple[2].value}; }

Mat matrix_of(const FactorText& text) {
  const dvec3 pivot = text.pivot.empty() ? dvec3{0} : point_of(text.pivot);
  const dvec3 amount = text.amount.size() == 1 ? dvec3{text.amount[0].value} : point_of(text.amount);
  if (text.kind == FactorText::Kind::translate) return translation(amount);
  if (text.kind == FactorText::Kind::scale) return about(pivot, scaling(amount));
  const Turn<double> turn = turn_degrees(text.amount[0].value);
  return about(pivot, rodrigues(direction_of(point_of(text.axis)), turn));
}

struct Task {
  std::vector<FactorText> texts;
  std::vector<Mat> factors;
  dvec3 axis, through, point, size;
  double angle;  ///< degrees
  bool compare;
};

Task task_of(const Arguments& arguments) {
  Task task{.texts = factors_of(arguments, "factors", coordinates),
            .factors = {},
            .axis = *arguments.place("axis"),
            .through = *arguments.place("through"),
            .point = *arguments.place("point"),
            .size = *arguments.place("box"),
            .angle = *arguments.number("angle"),
            .compare = arguments.text("compare") == "reversed"};
  for (const FactorText& text : task.texts) task.factors.push_back(matrix_of(text));
  if (task.axis == dvec3{0}) throw ArgumentError("axis", "expected an axis, not the zero vector 0,0,0");
  for (const int i : {0, 1, 2}) {
    if (!(task.size[i] > 0))
      throw ArgumentError("box", "expected three numbers above 0: width, height and depth");
  }
  return task;
}

// --- The box with an F
// ------------------------------------------------------------------------------------------------------------

/// Corner i lies at x, y, z = its bits 0, 1, 2; the F stands on the face z = 1, which looks to the reader.
Shape box_of(dvec3 size) {
  Shape corners;
  for (int i = 0; i < 8; ++i) corners.push_back(size * dvec3{i & 1, i >> 1 & 1, i >> 2 & 1});
  for (const auto& [x, y] : {std::pair{0.3, 0.15}, {0.3, 0.85}, {0.75, 0.85}, {0.3, 0.52}, {0.62, 0.52}}) {
    corners.push_back(size * dvec3{x, y, 1});
  }
  return corners;
}
constexpr std::size_t front = 1;  ///< of these faces, the one with the F
/// Counter-clockwise from outside.
constexpr std::array<std::array<std::size_t, 4>, 6> faces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
/// Corner A, on the front, from where the F is read.
constexpr std::size_t corner_a = 7;

/// Of length 1, whatever its size; 0 stays.
template <class Vector>
Vector unit(Vector v) {
  const double length = length_between(Vector(0), v);
  return length > 0 ? v / length : v;
}

double doubled_area(const std::vector<dvec2>& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 p = ring[i], q = ring[(i + 1) % ring.size()];
    area += p.x * q.y - q.x * p.y;
  }
  return area;
}

/// A box in an oblique view: edges of faces that look away are dashed.
void add_box(View& view, const Panel& panel, const std::string& id, Role role, const Shape& shape,
             bool filled) {
  std::vector<dvec2> at;
  for (const dvec3 p : shape) at.push_back(panel.at(oblique(p)));
  const dvec3 x = unit(shape[1] - shape[0]), y = unit(shape[2] - shape[0]), z = unit(shape[4] - shape[0]);
  const bool mirrored = glm::dot(x, glm::cross(y, z)) < 0;
  std::array<bool, 6> seen{};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<dvec2> ring;
    for (const std::size_t c : faces[f]) ring.push_back(at[c]);
    const double area = doubled_area(ring);
    seen[f] = mirrored ? area < 0 : area > 0;
    if (filled && seen[f]) view.add({fmt::format("a {} face {}", id, f), role, Area{{ring}}});
  }
  for (std::size_t a = 0; a < 8; ++a) {
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const std::size_t b = a | bit;
      if (b == a) continue;
      bool visible = false;
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& ring = faces[f];
        visible = visible || (seen[f] && std::ranges::count(ring, a) && std::ranges::count(ring, b));
      }
      view.add({fmt::format("b {} edge {}{}", id, a, b), role, Stroke{at[a], at[b], false, !visible}});
    }
  }
  view.add({"c " + id + " F", role, Path{{at[8], at[9], at[10]}, false, !seen[front]}});
  view.add({"c " + id + " F bar", role, Path{{at[11], at[12]}, false, !seen[front]}});
}

// --- What the tellers share
// ------------------------------------------------------------------------------------------------------------

class Paper {
 public:
  Paper(TraceWriter& writer, const Task& task) : writer_(writer), words_(writer.wording()), task_(task) {}

 protected:
  template <class... Values>
  std::string say(std::string_view key, const Values&... values) const {
    return words_.say(key, values...);
  }

  /// The axes of space, as long as the box and what is near it need.
  double reach() const { return 1.35 * std::max({task_.size.x, task_.size.y, task_.size.z}); }
  void add_axes_of_space(View& view, const Panel& panel, const std::string& id) const {
    for (int i = 0; i < 3; ++i) {
      dvec3 tip{0};
      tip[i] = reach();
      const std::string name = words_.symbol(coordinates[static_cast<std::size_t>(i)]);
      const dvec2 to = panel.at(oblique(tip));
      view.add({fmt::format("0 {} axis {}", id, i), Role::guide, Stroke{panel.at({0, 0}), to, true}});
      const dvec2 out = unit(to - panel.at({0, 0}));
      view.add({fmt::format("0 {} axis name {}", id, i), Role::guide, Text{to + 1.0 * out, name}});
    }
  }
  void reach_of_axes(Extent& world) const {
    world.add({0, 0});
    for (int i = 0; i < 3; ++i) {
      dvec3 tip{0};
      tip[i] = 1.1 * reach();
      world.add(oblique(tip));
    }
  }
  static void add_to(Extent& world, const Shape& shape) {
    for (const dvec3 p : shape) world.add(oblique(p));
  }
  static Shape moved(const Mat& m, const Shape& shape) {
    Shape points = shape;
    for (dvec3& p : points) p = transform(m, p);
    return points;
  }
  /// A straight line of space with a head, named.
  void add_arrow(View& view, const Panel& panel, const std::string& id, Role role, dvec3 from, dvec3 to,
                 const std::string& name, bool dashed = false) const {
    const dvec2 a = panel.at(oblique(from)), b = panel.at(oblique(to));
    if (a == b) return;
    view.add({"d " + id, role, Stroke{a, b, true, dashed}});
    if (!name.empty()) view.add({"k " + id, role, Label{0.5 * (a + b), name}});
  }
  static MatrixRows rows_of(const Mat& m, int rows = 4, int columns = 4) {
    MatrixRows made;
    for (int y = 0; y < rows; ++y) {
      made.emplace_back();
      for (int x = 0; x < columns; ++x) made.back().push_back(m[x][y]);
    }
    return made;
  }
  static std::vector<Field> fields_of(dvec3 p) { return {{"x", p.x}, {"y", p.y}, {"z", p.z}}; }

  void step(View view, std::string type, int line, std::string_view phase, std::string sentence, Row row,
            std::vector<Field> fields) {
    writer_.step(before_.change_to(std::move(view)), {}, line, [&](TraceStep& step) {
      step.type = std::move(type);
      step.phase = say(phase);
      step.sentence = std::move(sentence);
      step.row = std::move(row);
      step.fields = std::move(fields);
    });
  }

  TraceWriter& writer_;
  const Wording& words_;
  const Task& task_;
  Shown before_;
};

/// What rounding has left of zeros is nothing to show.
dvec3 clean(dvec3 p) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(p[i]) < 1e-12 * length_between(dvec3(0), p)) p[i] = 0;
  }
  return p;
}

Row row_of(std::string name, dvec3 place) {
  const dvec3 p = clean(place);
  return {std::move(name), figure_real(p.x), figure_real(p.y), figure_real(p.z)};
}

// --- A product, and its reverse beside it
// ------------------------------------------------------------------------------------------------------------

class ProductTeller : Paper {
 public:
  ProductTeller(TraceWriter& writer, const Task& task, bool rows)
      : Paper(writer, task), by_rows_(rows), box_(box_of(task.size)) {
    writer.trace().columns = {{"k"}, {"x"}, {"y"}, {"z"}};
    stages_ = stages(task.factors);
    std::vector<Mat> back(task.factors.rbegin(), task.factors.rend());
    if (task.compare) others_ = stages(back);
    if (rows) others_ = right_ones(task.factors);
    Extent world;
    reach_of_axes(world);
    for (const auto* list : {&stages_, &others_}) {
      for (const Shape& shape : *list) add_to(world, shape);
    }
    const double top = 15.8;
    panels_.emplace_back(Extent{{0.6, 2.2}, {others_.empty() ? 25.4 : 12.6, top}}, widened(world, 0.03));
    if (!others_.empty()) panels_.emplace_back(Extent{{13.4, 2.2}, {25.4, top}}, widened(world, 0.03));
  }
  const Panel& panel() const { return panels_[0]; }

  void operator()(const Started<double>&, int line = __builtin_LINE(), const char* = nullptr) {
    const std::string product = product_name(words_, task_.factors.size());
    tell("Started", line, "words.set_up",
         say(by_rows_ ? "affine_3d.started_rows" : "affine_3d.started", arg("product", product)),
         Role::input);
  }
  void operator()(const Multiplied<double>& m, int line = __builtin_LINE(), const char* = nullptr) {
    done_ = m.factor + 1;
    product_ = m.product;
    tell("Multiplied", line, "words.main_loop",
         say("affine_3d.multiplied", arg("factor", factor_words(words_, task_.texts[m.factor])),
             arg("name", factor_name(words_, m.factor)),
             arg("from", figure_place(stages_[done_ - 1][corner_a])),
             arg("to", figure_place(stages_[done_][corner_a]))),
         Role::current);
  }
  void operator()(const Transformed<double>&) const {}  // the corners are drawn with each factor
  void operator()(const RowTransformed<double>& t) { last_ = t; }

  void finish(int line) {
    const dvec3 to = stages_.back()[corner_a];
    std::string sentence = say("affine_3d.done", arg("to", figure_place(to)));
    if (by_rows_) {
      const glm::dvec4 row = transform_row(box_[corner_a], product_);
      sentence = say("affine_3d.rows", arg("to", figure_place(dvec3(row))), arg("w", figure_real(row.w)),
                     arg("right", figure_place(others_.back()[corner_a])));
    } else if (task_.compare) {
      const dvec3 other = others_.back()[corner_a];
      double size = 0;
      for (const auto* list : {&stages_, &others_}) {
        for (const Shape& shape : *list) size = std::max(size, length_between(shape[corner_a], dvec3(0)));
      }
      const bool same = length_between(to, other) <= 1e-9 * size;
      sentence = say(same ? "affine_3d.same" : "affine_3d.orders", arg("to", figure_place(to)),
                     arg("other", figure_place(other)));
    }
    tell("Finished", line, "words.result", sentence, Role::result);
  }

 private:
  std::vector<Shape> stages(const std::vector<Mat>& factors) const {
    std::vector<Shape> list{box_};
    Mat product(1);
    for (const Mat& m : factors) {
      product = m * product;
      list.push_back(by_rows_ ? by_rows(product) : moved(product, box_));
    }
    return list;
  }
  std::vector<Shape> right_ones(const std::vector<Mat>& factors) const {
    std::vector<Shape> list{box_};
    Mat product(1);
    for (const Mat& m : factors) list.push_back(moved(product = m * product, box_));
    return list;
  }
  Shape by_rows(const Mat& product) const {
    Shape points;
    for (const dvec3 p : box_) points.emplace_back(transform_row(p, product));
    return points;
  }

  void half(View& view, std::size_t i, const std::vector<Shape>& list, Role role) const {
    const std::string id = i == 0 ? "left" : "right";
    add_axes_of_space(view, panels_[i], id);
    add_box(view, panels_[i], id + " 0", Role::input, list[0], false);
    if (done_ > 1) add_box(view, panels_[i], id + " 1", Role::past, list[done_ - 1], false);
    if (done_ > 0) add_box(view, panels_[i], id + " 2", role, list[done_], true);
    const dvec2 a = panels_[i].at(oblique(list[done_][corner_a]));
    view.add({"j " + id + " corner", done_ ? role : Role::input, Dot{a}});
    view.add({"k " + id + " corner", done_ ? role : Role::input, Label{a, "A"}});
    const dvec2 middle{panels_[i].place().centre().x, 0.9};
    view.add({"l " + id + " caption", Role::guide, Text{middle, caption(i)}});
  }
  std::string caption(std::size_t half) const {
    if (by_rows_) return say(half == 0 ? "affine_3d.as_row" : "affine_3d.as_column");
    const std::size_t n = task_.factors.size();
    if (half == 0) return product_name(words_, n);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < n; ++k) names.push_back(factor_name(words_, k));
    return chained(names);
  }

  void tell(std::string type, int line, std::string_view phase, std::string sentence, Role role) {
    View view;
    half(view, 0, stages_, role);
    if (!others_.empty()) half(view, 1, others_, role);
    add_matrix(view, "m", {25, 21.1}, words_.symbol("M"), rows_of(product_), done_ ? role : Role::guide);
    const dvec3 a = stages_[done_][corner_a];
    const Row row = role == Role::result ? Row{} : row_of(figure_number(static_cast<std::int64_t>(done_)), a);
    step(std::move(view), std::move(type), line, phase, std::move(sentence), row, fields_of(a));
  }

  bool by_rows_;
  Shape box_;
  std::vector<Shape> stages_, others_;
  std::vector<Panel> panels_;
  std::size_t done_ = 0;
  Mat product_{1};
  RowTransformed<double> last_{};
};

// --- A turn by parts
// ------------------------------------------------------------------------------------------------------------

class PartsTeller : Paper {
 public:
  PartsTeller(TraceWriter& writer, const Task& task, const Turn<double>& turn)
      : Paper(writer, task), box_(box_of(task.size)), n_(direction_of(task.axis)) {
    writer.trace().columns = {{"k"}, {"x"}, {"y"}, {"z"}};
    Recorder<Decomposed<double>> seen;
    decomposition(task.through, alignment(task.axis), turn, seen);
    Extent world;
    reach_of_axes(world);
    add_to(world, box_);
    add_to(world, axis(Mat(1)));
    for (const auto& d : all<Decomposed<double>>(seen)) {
      add_to(world, moved(d.product, box_));
      add_to(world, axis(d.product));
      parts_.push_back(part_name(d.part));
    }
    panel_.emplace(Extent{{0.6, 2.2}, {25.4, 15.8}}, widened(world, 0.03));
    tell("Input", 0, "words.set_up",
         say("affine_3d.input", arg("angle", figure_real(task.angle)), arg("axis", figure_place(task.axis)),
             arg("through", figure_place(task.through)), arg("count", parts_.size())),
         Role::input);
  }
  const Panel& panel() const { return *panel_; }

  void operator()(const Decomposed<double>& d, int line = __builtin_LINE(), const char* = nullptr) {
    ++done_;
    product_ = d.product;
    const Mat& m = d.matrix;
    const dvec3 now(product_ * glm::dvec4(task_.axis, 0));
    constexpr std::string_view keys[] = {"to_origin", "into_plane",   "onto_z", "turn",
                                         "off_z",     "out_of_plane", "back"};
    const bool round_x = d.part == Part::into_plane || d.part == Part::out_of_plane;
    const bool moves = d.part == Part::to_origin || d.part == Part::back;
    const double sin = round_x ? m[1][2] : d.part == Part::turn ? m[0][1] : m[2][0];
    const double cos = round_x ? m[1][1] : d.part == Part::turn ? m[0][0] : m[2][2];
    const std::string part = part_name(d.part),
                      key = fmt::format("affine_3d.part.{}", keys[static_cast<int>(d.part)]);
    const std::string sentence =
        moves ? say(key, arg("name", part), arg("by", figure_place(dvec3(m[3]))))
              : say(key, arg("name", part), arg("sin", figure_real(sin)), arg("cos", figure_real(cos)),
                    arg("axis", figure_place(clean(now))));
    tell("Decomposed", line, d.part == Part::turn ? "words.main_loop" : "affine_3d.phase", sentence,
         Role::current);
  }

  void finish() {
    const Mat whole = about(task_.through, rodrigues(n_, turn_degrees(task_.angle)));
    double apart = 0;
    for (int i = 0; i < 16; ++i)
      apart = std::max(apart, std::abs(whole[i / 4][i % 4] - product_[i / 4][i % 4]));
    tell(
        "Finished", 0, "words.result",
        say("affine_3d.parts_done", arg("angle", figure_real(task_.angle)), arg("apart", figure_real(apart))),
        Role::result);
  }

 private:
  std::string part_name(Part part) const {
    const std::string round_x = "R" + words_.symbol("x"), round_y = "R" + words_.symbol("y");
    const std::string names[] = {
        "T(−P)",          round_x + "(α)",  round_y + "(β)", "R" + words_.symbol("z") + "(θ)",
        round_y + "(−β)", round_x + "(−α)", "T(P)"};
    return names[static_cast<std::size_t>(part)];
  }
  /// The ends of the axis as it is drawn.
  Shape axis(const Mat& m) const {
    return moved(m, {task_.through - 0.5 * reach() * n_, task_.through + reach() * n_});
  }
  std::string formula() const {
    if (done_ == 0) return words_.symbol("M");
    const std::vector<std::string> newest_first(parts_.rend() - static_cast<std::ptrdiff_t>(done_),
                                                parts_.rend());
    return words_.symbol("M") + " = " + chained(newest_first);
  }

  void tell(std::string type, int line, std::string_view phase, std::string sentence, Role role) {
    View view;
    add_axes_of_space(view, *panel_, "space");
    add_box(view, *panel_, "input", Role::input, box_, false);
    const Shape box = moved(product_, box_);
    if (done_ > 0) add_box(view, *panel_, "now", role, box, true);
    const Shape line_now = axis(product_);
    add_arrow(view, *panel_, "axis", Role::boundary, line_now[0], line_now[1], say("affine_3d.axis"));
    const dvec2 a = panel_->at(oblique(box[corner_a]));
    view.add({"j corner", done_ ? role : Role::input, Dot{a}});
    view.add({"k corner", done_ ? role : Role::input, Label{a, "A"}});
    view.add({"l formula", Role::guide, Text{{13, 0.9}, formula()}});
    add_matrix(view, "m", {25, 21.1}, words_.symbol("M"), rows_of(product_), done_ ? role : Role::guide);
    const dvec3 at = box[corner_a];
    const Row row =
        role == Role::result ? Row{} : row_of(figure_number(static_cast<std::int64_t>(done_)), at);
    step(std::move(view), std::move(type), line, phase, std::move(sentence), row, fields_of(at));
  }

  Shape box_;
  dvec3 n_;
  std::vector<std::string> parts_;
  std::optional<Panel> panel_;
  std::size_t done_ = 0;
  Mat product_{1};
};

// --- A turn by vectors
// ------------------------------------------------------------------------------------------------------------

class VectorTeller : Paper {
 public:
  VectorTeller(TraceWriter& writer, const Task& task, bool constant)
      : Paper(writer, task),
        constant_(constant),
        n_(direction_of(task.axis)),
        turn_(turn_degrees(task.angle)) {
    writer.trace().columns = {{"vector", false}, {"x"}, {"y"}, {"z"}};
    for (int i = 0; i <= 72; ++i)
      circle_.push_back(turn_vector(n_, task.through, turn_degrees(5.0 * i), task.point));
    for (int i = 0; i <= 24; ++i) {
      arc_.push_back(turn_vector(n_, task.through, turn_degrees(task.angle * i / 24.0), task.point));
    }
    p_ = task.point - task.through;
    const double along = std::max(glm::dot(p_, n_), 0.0), back = std::min(glm::dot(p_, n_), 0.0);
    const double radius = std::sqrt(std::max(0.0, glm::dot(p_, p_) - along * along - back * back));
    axis_ = {task.through + (back - 0.35 * (radius + 1)) * n_,
             task.through + (along + 0.6 * (radius + 1)) * n_};
    Extent world;
    world.add({0, 0});
    add_to(world, circle_);
    add_to(world, axis_);
    panel_.emplace(Extent{{0.8, 2.6}, {25.2, 25.4}}, widened(world, 0.05));
    tell("Input", 0, "words.set_up",
         say("affine_3d.vector_input", arg("point", figure_place(task.point)),
             arg("angle", figure_real(task.angle)), arg("axis", figure_place(task.axis)),
             arg("through", figure_place(task.through))),
         row_of("n", n_));
  }
  const Panel& panel() const { return *panel_; }

  void operator()(const Projected<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    r_ = s.r;
    level_ = 1;
    tell("Projected", line, "words.main_loop",
         say("affine_3d.projected", arg("dot", figure_real(glm::dot(s.p, n_))), arg("p", figure_place(s.p)),
             arg("r", figure_place(clean(s.r)))),
         row_of("r", s.r));
  }
  void operator()(const Rejected<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    s_ = s.s;
    level_ = 2;
    tell("Rejected", line, "words.main_loop", say("affine_3d.rejected", arg("s", figure_place(clean(s.s)))),
         row_of("s", s.s));
  }
  void operator()(const Crossed<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    v_ = s.v;
    level_ = 3;
    tell("Crossed", line, "words.main_loop",
         say("affine_3d.crossed", arg("v", figure_place(clean(s.v))),
             arg("length", figure_real(length_between(s.v, dvec3(0))))),
         row_of("v", s.v));
  }
  void operator()(const Turned<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    to_ = s.to;
    level_ = 4;
    tell("Turned", line, "words.result",
         say("affine_3d.turned", arg("cos", figure_real(turn_.cos)), arg("sin", figure_real(turn_.sin)),
             arg("to", figure_place(clean(s.to)))),
         row_of("P′", s.to));
  }
  void operator()(const OffsetAdded<double>& s, int line = __builtin_LINE(), const char* = nullptr) {
    to_ = s.to;
    left_behind_ = true;
    tell("OffsetAdded", line, "words.result",
         say("affine_3d.offset_added", arg("offset", figure_place(clean(s.offset))),
             arg("to", figure_place(clean(s.to))), arg("right", figure_place(clean(belongs())))),
         row_of("P′", s.to));
  }

 private:
  Role role(int level) const { return level == level_ ? Role::current : Role::past; }
  dvec3 belongs() const { return turn_vector(n_, task_.through, turn_, task_.point); }

  void tell(std::string type, int line, std::string_view phase, std::string sentence, Row row) {
    View view;
    const Panel& panel = *panel_;
    const dvec3 foot = task_.through + r_;
    add_arrow(view, panel, "axis", Role::boundary, axis_[0], axis_[1], say("affine_3d.axis"));
    std::vector<dvec2> ring;
    for (const dvec3 p : circle_) ring.push_back(panel.at(oblique(p)));
    view.add({"b circle", Role::guide, Path{ring, false, true}});
    dot(view, "through", Role::boundary, task_.through, "Q");
    dot(view, "point", left_behind_ ? Role::rejected : Role::input, task_.point,
        left_behind_ ? "P = P′" : "P");
    add_arrow(view, panel, "p", Role::input, task_.through, task_.point, words_.symbol("p"));
    if (level_ >= 1) add_arrow(view, panel, "r", role(1), task_.through, foot, "r");
    if (level_ >= 2) add_arrow(view, panel, "s", role(2), foot, task_.point, "s");
    if (level_ >= 3) add_arrow(view, panel, "v", role(3), foot, foot + v_, "v");
    if (level_ >= 4 || left_behind_) {
      std::vector<dvec2> arc;
      for (const dvec3 p : arc_) arc.push_back(panel.at(oblique(p)));
      view.add({"e arc", Role::measure, Path{arc}});
      view.add({"k arc", Role::measure, Label{arc[12], "θ"}});
    }
    if (left_behind_) dot(view, "belongs", Role::accepted, belongs(), say("affine_3d.belongs"));
    if (level_ >= 4) {
      add_arrow(view, panel, "t", Role::result, foot, to_, "");
      dot(view, "to", Role::result, to_, "P′");
    }
    const std::string formula = constant_ ? "P′ = Q + (P − Q)" : "P′ = Q + r + cos θ · s + sin θ · v";
    view.add({"l formula", Role::guide, Text{{13, 0.9}, formula}});
    const dvec3 at = level_ == 4 ? to_ : task_.point;
    step(std::move(view), std::move(type), line, phase, std::move(sentence), std::move(row), fields_of(at));
  }
  void dot(View& view, const std::string& id, Role role, dvec3 at, const std::string& name) const {
    view.add({"j " + id, role, Dot{panel_->at(oblique(at))}});
    view.add({"k " + id, role, Label{panel_->at(oblique(at)), name}});
  }

  bool constant_, left_behind_ = false;
  dvec3 n_;
  Turn<double> turn_;
  Shape circle_, arc_, axis_;
  dvec3 p_{0}, r_{0}, s_{0}, v_{0}, to_{0};
  std::optional<Panel> panel_;
  int level_ = 0;
};

// --- The entry
// ------------------------------------------------------------------------------------------------------------

std::vector<Method> all_methods() {
  return {method_in_english("affine_3d", "one_matrix", Standing::taught),
          method_in_english("affine_3d", "decomposition", Standing::plain),
          method_in_english("affine_3d", "turn_vector", Standing::plain),
          method_in_english("affine_3d", "row_vectors", Standing::faulty),
          method_in_english("affine_3d", "constant_offset", Standing::faulty)};
}

void describe(Trace& trace, const Arguments& arguments, const Task& task, const Method& method) {
  const Wording& words = trace.wording;
  introduce(trace, "affine_3d", arguments, method.standing == Standing::faulty);
  const bool chain = method.name == "one_matrix" || method.name == "row_vectors";
  std::vector<std::string> factors;
  for (const FactorText& text : task.texts) factors.push_back(factor_words(words, text));
  trace.subtitle =
      chain ? fmt::format("{}", fmt::join(factors, "; "))
            : words.say("affine_3d.subtitle", arg("angle", figure_real(task.angle)),
                        arg("axis", figure_place(task.axis)), arg("through", figure_place(task.through)));
  trace.source_file =
      std::string(folder) + (method.standing == Standing::faulty ? "affine_3d_notes.hpp" : "affine_3d.hpp");
  trace.listing = listing_of(source_text(trace.source_file), method.name);
  trace.grid = paper_grid(26, 26);
  trace.legend = {{Role::input, words.say("affine_3d.legend.input")},
                  {Role::past, words.say("affine_3d.legend.past")},
                  {Role::current, words.say("affine_3d.legend.current")},
                  {Role::result, words.say("affine_3d.legend.result")}};
  if (method.name == "constant_offset")
    trace.legend.push_back({Role::rejected, words.say("affine_3d.legend.rejected")});
}

/// What the steps of turn_vector hold, and of products of matrices.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Started<T>&) const {
    to.type = "Started";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Multiplied<T>& m) const {
    to.type = "Multiplied";
    constexpr std::array<std::string_view, 4> columns{"x", "y", "z", "0"};
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        to.number(fmt::format("{}{}", "xyz"[row], columns[static_cast<std::size_t>(column)]),
                  m.product[column][row]);
      }
    }
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Transformed<T>&) const {
    to.type = "Transformed";  // the story draws the corners with each factor and tells none alone
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Projected<T>& p) const {
    to.type = "Projected";
    to.point("r", p.r);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rejected<T>& r) const {
    to.type = "Rejected";
    to.point("s", r.s);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Crossed<T>& c) const {
    to.type = "Crossed";
    to.point("v", c.v);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Turned<T>& t) const {
    to.type = "Turned";
    to.point("P′", t.to);
  }
};

template <class T>
Matrix<T> matrix_in(const Mat& m) {
  Matrix<T> result(T(1));
  for (int column = 0; column < 4; ++column) result[column] = in_scalar<T>(m[column]);
  return result;
}

/// The factors, the axis of length 1 and the turn are the doubles' in all three.
void put_side_by_side(Trace& trace, const Task& task, const Shape& box, const std::string& method) {
  show_side_by_side<Numbers>(trace, [&]<class T>(T, const auto& observer) {
    if (method == "turn_vector") {
      const Turn<double> turn = turn_degrees(task.angle);
      turn_vector(in_scalar<T>(direction_of(task.axis)), in_scalar<T>(task.through),
                  Turn<T>{T(turn.sin), T(turn.cos), T(turn.versine)}, in_scalar<T>(task.point), observer);
      return;
    }
    std::vector<Matrix<T>> factors;
    for (const Mat& m : task.factors) factors.push_back(matrix_in<T>(m));
    std::vector<Point<T>> corners;
    for (const dvec3 p : box) corners.push_back(in_scalar<T>(p));
    one_matrix(std::span<const Matrix<T>>(factors), std::span(corners), observer);
  });
}

Trace run(const Arguments& arguments, Recording recording) {
  static const std::vector<Method> methods = all_methods();
  const Method& method = *std::ranges::find(methods, arguments.text("method"), &Method::name);
  const Task task = task_of(arguments);
  TraceWriter writer(std::move(recording));
  describe(writer.trace(), arguments, task, method);
  Shape box = box_of(task.size);
  dvec3 result;
  if (method.name == "one_matrix") {
    ProductTeller teller(writer, task, false);
    require_scale(teller.panel(), arguments, {"box", "factors"});
    one_matrix(Chain(task.factors), std::span(box), teller);
    teller.finish(0);
    result = box[corner_a];
  } else if (method.name == "row_vectors") {
    ProductTeller teller(writer, task, true);
    require_scale(teller.panel(), arguments, {"box", "factors"});
    row_vectors(Chain(task.factors), std::span(box), teller);
    teller.finish(0);
    result = box[corner_a];
  } else if (method.name == "decomposition") {
    const Turn<double> turn = turn_degrees(task.angle);
    PartsTeller teller(writer, task, turn);
    require_scale(teller.panel(), arguments, {"box", "through"});
    const Mat m = decomposition(task.through, alignment(task.axis), turn, teller);
    teller.finish();
    result = transform(m, box[corner_a]);
  } else {
    const bool constant = method.name == "constant_offset";
    const dvec3 n = direction_of(task.axis);
    const Turn<double> turn = turn_degrees(task.angle);
    VectorTeller teller(writer, task, constant);
    require_scale(teller.panel(), arguments, {"point", "through"});
    result = constant ? constant_offset(n, task.through, turn, task.point, teller)
                      : turn_vector(n, task.through, turn, task.point, teller);
  }
  Trace trace = std::move(writer).finish();
  trace.telling = {trace.last, 0};
  trace.result = {{"x", result.x}, {"y", result.y}, {"z", result.z}};
  if (side_by_side(arguments)) {
    require_method(arguments, {"one_matrix", "turn_vector"});
    put_side_by_side(trace, task, box_of(task.size), method.name);
  }
  return trace;
}

Parameter triple(std::string name, std::string value, std::string help) {
  return {.name = std::move(name),
          .type = ParameterType::numbers,
          .default_value = value,
          .example = value,
          .help = std::move(help),
          .parts = coordinates,
          .sizes = {1e-100, 1e100}};
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "affine_3d",
      .title = Wording().say("affine_3d.title"),
      .chapter = "transformation",
      .aliases = {"3d transformation", "rodrigues", "rotation about an axis", "4x4 matrices"},
      .summary = "move, scale and turn in space; turns round any axis, by parts and by vectors",
      .methods = all_methods(),
      .default_method = "one_matrix",
      .parameters =
          {{.name = "factors",
            .type = ParameterType::factors,
            .default_value = "rotate 90 about x; rotate 90 about y",
            .example = "rotate 30 about 0,1,1 through 1,1,0; translate 0,0,1",
            .help = "one_matrix, row_vectors: what is done, in the order of doing; angles in degrees",
            .parts = coordinates},
           {.name = "compare",
            .type = ParameterType::choice,
            .default_value = "reversed",
            .example = "none",
            .help = "one_matrix: the factors in the reverse order beside it",
            .choices = {"none", "reversed"}},
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
                   "--method turn_vector --axis 1,2,3 --angle 60"},
      .run = run};
  return topic;
}

}  // namespace gradus::affine_3d
