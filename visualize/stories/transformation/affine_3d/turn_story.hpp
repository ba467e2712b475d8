#pragma once
// The stories of a turn round any axis: by parts, and by vectors.

#include "core/record.hpp"
#include "stories/transformation/affine_3d/drawing.hpp"
#include "stories/transformation/affine_3d/subject.hpp"
#include "transformation/affine_3d/affine_3d_notes.hpp"

namespace gradus::affine_3d {

// --- A turn by parts

class PartsStory {
 public:
  PartsStory(const Words& words, const Subject& subject)
      : words_(words),
        subject_(subject),
        align_(alignment(subject.axis)),
        box_(box_of(subject.size)),
        n_(direction_of(subject.axis)) {
    Recorder<Decomposed<double>> seen;
    decomposition(subject.through, align_, turn_degrees(subject.angle), seen);
    Extent world = world_of_axes(reach());
    add_to(world, box_);
    add_to(world, axis(Mat(1)));
    for (const auto& d : all<Decomposed<double>>(seen)) {
      add_to(world, moved(d.product, box_));
      add_to(world, axis(d.product));
      parts_.push_back(name_of(d.part));
    }
    panel_.emplace(single_place, widened(world, 0.03));
  }
  const Panel& panel() const { return *panel_; }
  /// Where the first drawing has the ends of an axis of this direction through this point.
  Stroke axis_at(dvec3 through, dvec3 direction) const {
    const auto [from, to] = axis_along(through, direction_of(direction));
    return {on_paper(from), on_paper(to)};
  }

  void show(Board& board, const Input&) { milestone(board, Role::input); }
  Event say(const Input&) const {
    return standing({.text = "input",
                     .words = {{"angle", subject_.angle},
                               {"axis", subject_.axis},
                               {"through", subject_.through},
                               {"count", parts_.size()}},
                     .begins = true});
  }

  void show(Board& board, const Decomposed<double>& d) {
    ++done_;
    product_ = d.product;
    milestone(board, Role::current);
  }
  Event say(const Decomposed<double>& d) const {
    constexpr std::array<std::string_view, 7> keys{"part.to_origin", "part.into_plane", "part.onto_z",
                                                   "part.turn",      "part.off_z",      "part.out_of_plane",
                                                   "part.back"};
    const Mat& m = d.matrix;
    const bool round_x = d.part == Part::into_plane || d.part == Part::out_of_plane;
    const bool round_z = d.part == Part::turn;
    const double sin = round_x ? m[1][2] : round_z ? m[0][1] : m[2][0];
    const double cos = round_x ? m[1][1] : round_z ? m[0][0] : m[2][2];
    return standing({.text = keys[static_cast<std::size_t>(d.part)],
                     .words = {{"name", name_of(d.part)},
                               {"by", dvec3(m[3])},
                               {"sin", sin},
                               {"cos", cos},
                               {"axis", clean(dvec3(product_ * glm::dvec4(subject_.axis, 0)))}},
                     .phase = round_z ? "" : words_.say("phase"),
                     .decides = decision(d.part)});
  }

  void show(Board& board, const steps::Finished&) { milestone(board, Role::result); }
  Event say(const steps::Finished&) const {
    const Mat whole = about(subject_.through, rodrigues(n_, turn_degrees(subject_.angle)));
    double apart = 0;
    for (int i = 0; i < 16; ++i)
      apart = std::max(apart, std::abs(whole[i / 4][i % 4] - product_[i / 4][i % 4]));
    return {.text = "parts_done",
            .facts = fields_of(corner()),
            .words = {{"angle", subject_.angle}, {"apart", apart}},
            .level = Level::step};
  }

 private:
  std::string name_of(Part part) const {
    const std::string round_x = "R" + words_.symbol("x"), round_y = "R" + words_.symbol("y");
    const std::string names[] = {
        "T(−P)",          round_x + "(α)",  round_y + "(β)", "R" + words_.symbol("z") + "(θ)",
        round_y + "(−β)", round_x + "(−α)", "T(P)"};
    return names[static_cast<std::size_t>(part)];
  }
  /// What was asked last before this part: whether a turn is needed at all.
  std::optional<Decision> decision(Part part) const {
    const auto asked = [&](std::string_view question, bool needed) {
      return yes_or_no(words_, question, {}, needed, "turned", "skipped");
    };
    const bool x = align_.x.has_value(), y = align_.y.has_value();
    if (part == Part::into_plane || part == Part::out_of_plane || (part == Part::back && !x))
      return asked("question.round_x", x);
    if (part == Part::onto_z || part == Part::off_z || (part == Part::turn && !y))
      return asked("question.round_y", y);
    return std::nullopt;
  }
  /// The ends of the axis as it is drawn.
  Shape axis(const Mat& m) const {
    const auto [from, to] = axis_along(subject_.through, n_);
    return moved(m, {from, to});
  }
  std::pair<dvec3, dvec3> axis_along(dvec3 through, dvec3 n) const {
    const double reach = reach_of(subject_.size);
    return {through - 0.5 * reach * n, through + reach * n};
  }
  dvec2 on_paper(dvec3 p) const { return panel_->at(oblique(p)); }
  /// Of the axes of space: z comes out of what lies before it.
  dvec3 reach() const {
    const double all = reach_of(subject_.size), beyond = all / 5;
    return {subject_.size.x + beyond, subject_.size.y + beyond, all};
  }
  dvec3 corner() const { return transform(product_, box_[corner_a]); }
  Event standing(Event event) const {
    event.facts = fields_of(corner());
    event.row = row_of(done_, corner());
    return event;
  }
  std::string formula() const {
    if (done_ == 0) return words_.symbol("M");
    const std::vector<std::string> newest_first(parts_.rend() - static_cast<std::ptrdiff_t>(done_),
                                                parts_.rend());
    return words_.symbol("M") + " = " + chained(words_.wording(), newest_first);
  }

  void milestone(Board& board, Role role) const {
    View view;
    SpaceDrawing space = drawing_in(*panel_);
    add_axes_of_space(view, space, *panel_, "space", reach(), words_);
    if (done_ > 0) add_given(space, "input", box_);
    add_box(space, "now", done_ > 0 ? role : Role::input, moved(product_, box_));
    const Shape ends = axis(product_);
    space.add(SpaceEdge{.id = "b axis", .role = Role::boundary, .a = ends[0], .b = ends[1], .arrow = true});
    space.add_to(view, "a box");
    view.add({"k axis", Role::boundary, Label{on_paper(ends[1]), words_.say("axis")}});
    add_dot(view, *panel_, "corner", done_ ? role : Role::input, corner(), "A");
    add_product(view, "m", {26.6, 17.6}, 17.2, product_, formula() + " =", done_ > 0 ? role : Role::input,
                words_);
    board.milestone(std::move(view));
  }

  const Words& words_;
  const Subject& subject_;
  const Alignment<double> align_;
  const Shape box_;
  const dvec3 n_;
  std::vector<std::string> parts_;
  std::optional<Panel> panel_;
  std::size_t done_ = 0;
  Mat product_{1};
};

// --- A turn by vectors

class VectorStory {
 public:
  /// constant: the offset of a camera from its car is added as it is.
  VectorStory(const Words& words, const Subject& subject, bool constant)
      : words_(words),
        subject_(subject),
        constant_(constant),
        n_(direction_of(subject.axis)),
        turn_(turn_degrees(subject.angle)) {
    for (int i = 0; i <= 72; ++i) circle_.push_back(turned_by(5.0 * i));
    for (int i = 0; i <= 24; ++i) arc_.push_back(turned_by(subject.angle * i / 24.0));
    axis_ = axis_along(n_);
    Extent world;
    world.add({0, 0});
    add_to(world, circle_);
    add_to(world, axis_);
    panel_.emplace(whole_place, widened(world, 0.05));
  }
  const Panel& panel() const { return *panel_; }
  /// Where the first drawing has a point, and the tip of an axis of this direction.
  dvec2 at(dvec3 p) const { return panel_->at(oblique(p)); }
  dvec2 tip_at(dvec3 direction) const { return at(axis_along(direction_of(direction))[1]); }

  void show(Board& board, const Input&) { milestone(board); }
  Event say(const Input&) const {
    Event event = told("vector_input",
                       {{"point", subject_.point},
                        {"angle", subject_.angle},
                        {"axis", subject_.axis},
                        {"through", subject_.through}},
                       "n", n_);
    event.begins = true;
    return event;
  }

  void show(Board& board, const Projected<double>& s) { learn(board, 1, r_, s.r); }
  Event say(const Projected<double>& s) const {
    return told("projected", {{"dot", glm::dot(s.p, n_)}, {"p", s.p}, {"r", clean(r_)}}, "r", r_);
  }
  void show(Board& board, const Rejected<double>& s) { learn(board, 2, s_, s.s); }
  Event say(const Rejected<double>&) const { return told("rejected", {{"s", clean(s_)}}, "s", s_); }
  void show(Board& board, const Crossed<double>& s) { learn(board, 3, v_, s.v); }
  Event say(const Crossed<double>&) const {
    return told("crossed", {{"v", clean(v_)}, {"length", length_between(v_, dvec3(0))}}, "v", v_);
  }
  void show(Board& board, const Turned<double>& s) { learn(board, 4, to_, s.to); }
  Event say(const Turned<double>&) const {
    return result("turned", {{"cos", turn_.cos}, {"sin", turn_.sin}, {"to", clean(to_)}});
  }
  void show(Board& board, const OffsetAdded<double>& s) {
    left_behind_ = true;
    learn(board, 0, to_, s.to);
  }
  Event say(const OffsetAdded<double>& s) const {
    return result(
        "offset_added",
        {{"offset", clean(s.offset)}, {"to", clean(to_)}, {"right", clean(turned_by(subject_.angle))}});
  }

 private:
  /// The ends of the axis as it is drawn: beyond the point that turns and beyond Q.
  Shape axis_along(dvec3 n) const {
    const dvec3 p = subject_.point - subject_.through;
    const double along = std::max(glm::dot(p, n), 0.0), back = std::min(glm::dot(p, n), 0.0);
    const double radius = std::sqrt(std::max(0.0, glm::dot(p, p) - along * along - back * back));
    return {subject_.through + (back - 0.35 * (radius + 1)) * n,
            subject_.through + (along + 0.6 * (radius + 1)) * n};
  }
  dvec3 turned_by(double degrees) const {
    return turn_vector(n_, subject_.through, turn_degrees(degrees), subject_.point);
  }
  void learn(Board& board, int level, dvec3& vector, dvec3 value) {
    level_ = level;
    vector = value;
    milestone(board);
  }
  Event told(std::string_view text, std::vector<Word> words, Said name, dvec3 vector) const {
    return {.text = text,
            .facts = fields_of(level_ == 4 ? to_ : subject_.point),
            .words = std::move(words),
            .row = row_of(std::move(name), vector)};
  }
  Event result(std::string_view text, std::vector<Word> words) const {
    Event event = told(text, std::move(words), "P′", to_);
    event.ends = true;
    event.level = Level::step;
    return event;
  }

  void milestone(Board& board) const {
    View view;
    const Panel& panel = *panel_;
    add_arrow(view, panel, "axis", Role::boundary, axis_[0], axis_[1], words_.say("axis"));
    view.add({"a disc", Role::guide, Area{{on_paper(panel, circle_)}, 2}});
    view.add({"b circle", Role::guide, Path{on_paper(panel, circle_), false, true}});
    add_dot(view, panel, "through", Role::boundary, subject_.through, "Q");
    add_dot(view, panel, "point", left_behind_ ? Role::rejected : Role::input, subject_.point,
            left_behind_ ? "P = P′" : "P");
    add_arrow(view, panel, "p", Role::input, subject_.through, subject_.point, words_.symbol("p"));
    add_vectors(view);
    if (level_ >= 4 || left_behind_) {
      const std::vector<dvec2> arc = on_paper(panel, arc_);
      view.add({"e arc", Role::measure, Path{arc}});
      view.add({"k arc", Role::measure, Label{arc[12], "θ"}});
    }
    if (left_behind_)
      add_dot(view, panel, "belongs", Role::accepted, turned_by(subject_.angle), words_.say("belongs"));
    const std::string formula = constant_ ? "P′ = Q + (P − Q)" : "P′ = Q + r + cos θ · s + sin θ · v";
    view.add({"l formula", Role::guide, Text{{18, 0.8}, formula}});
    board.milestone(std::move(view));
  }
  /// As many of r, s and v as are known, and what they make.
  void add_vectors(View& view) const {
    const dvec3 foot = subject_.through + r_;
    const auto add = [&](int level, const std::string& name, dvec3 from, dvec3 to) {
      if (level_ < level) return;
      add_arrow(view, *panel_, name, level == level_ ? Role::current : Role::past, from, to, name);
    };
    add(1, "r", subject_.through, foot);
    add(2, "s", foot, subject_.point);
    add(3, "v", foot, foot + v_);
    if (level_ < 4) return;
    add_arrow(view, *panel_, "t", Role::result, foot, to_, "");
    add_dot(view, *panel_, "to", Role::result, to_, "P′");
  }

  const Words& words_;
  const Subject& subject_;
  const bool constant_;
  bool left_behind_ = false;
  const dvec3 n_;
  const Turn<double> turn_;
  Shape circle_, arc_, axis_;
  dvec3 r_{0}, s_{0}, v_{0}, to_{0};
  std::optional<Panel> panel_;
  int level_ = 0;  ///< so many of r, s, v and P′ are known
};

}  // namespace gradus::affine_3d
