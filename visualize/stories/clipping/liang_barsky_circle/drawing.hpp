#pragma once
// A segment in a circle as it is drawn: in the plane, and below it what t is on the segment's line.

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/telling.hpp"

namespace gradus::liang_barsky_circle {

using Ends = Segment<2, double>;
using Disc = Circle<double>;

inline constexpr int paper_width = 36, paper_height = 27;

/// What all steps are drawn from.
struct Subject {
  Ends segment;
  Disc circle;
  bool has_line;              ///< the method knows values of t
  Panel panel;                ///< the plane
  Extent t;                   ///< the values that the number line shows
  NumberLine line;            ///< t
  std::optional<Ends> right;  ///< what is really kept
};

/// The plane: the circle, and the segment where that is not much larger.
inline Extent world_of(const Ends& s, const Disc& c) {
  Extent around;
  around.add(c.centre - c.radius);
  around.add(c.centre + c.radius);
  Extent all = around;
  all.add(s.a);
  all.add(s.b);
  const bool fits = c.radius == 0 || std::max(all.size().x, all.size().y) <= 12 * c.radius;
  return widened(fits ? all : widened(around, 0.5), 0.015);
}

/// The values of t to show, moderate ones.
inline Extent scale_of(const Ends& s, const Disc& c) {
  const Quadratic<double> q = quadratic(s, c);
  Extent t;
  t.add({0, 0});
  t.add({1, 0});
  if (q.A > 0) {
    const double foot = -q.B / q.A, half = std::sqrt(std::max(0.0, q.D)) / q.A;
    for (const double value : {foot - half, foot, foot + half}) {
      if (std::isfinite(value)) t.add({std::clamp(value, -1.0, 2.0), 0});
    }
  }
  return {t.lower - 0.15, t.upper + 0.15};
}

inline Subject subject_of(const Ends& s, const Disc& c, bool has_line) {
  const Extent t = scale_of(s, c);
  return {
      .segment = s,
      .circle = c,
      .has_line = has_line,
      .panel = tight_panel({{3, has_line ? 8.5 : 3}, {paper_width - 2, paper_height - 1.5}}, world_of(s, c)),
      .t = t,
      .line = NumberLine({2, 3}, {paper_width - 3.5, 3}, t.lower.x, t.upper.x),
      .right = exact_decision(s, c)};
}

/// The drawing, as steps add to it.
class ChordDrawing {
 public:
  ChordDrawing(const Words& words, const Subject& subject) : words_(words), subject_(subject) {}
  const View& view() const { return view_; }

  void add_input() {
    const auto& [a, b] = subject_.segment;
    view_.add(
        {"a circle", Role::boundary, Path{subject_.panel.at(circle_drawing::whole(subject_.circle)), true}});
    add_point("a centre", Role::boundary, subject_.circle.centre, words_.say("centre"));
    add_stroke("b segment", Role::input, a, b, true);
    add_point("b from", Role::input, a, words_.say("from"));
    if (a != b) add_point("b to", Role::input, b, words_.say("to"));
    add_axes(view_, subject_.panel, "plane", {words_.symbol("x"), words_.symbol("y")});
    if (!subject_.has_line) return;
    subject_.line.add_to(view_, "t", words_.symbol("t"));
    view_.add({"c segment t", Role::input, Stroke{subject_.line.at(0), subject_.line.at(1)}});
    view_.add({"c from t", Role::input, Dot{subject_.line.at(0)}});
    view_.add({"c to t", Role::input, Dot{subject_.line.at(1)}});
  }

  /// The whole line, dashed, and the perpendicular from the centre.
  void add_perpendicular() {
    const dvec2 d = subject_.segment.b - subject_.segment.a, centre = subject_.circle.centre;
    const double size = std::max(std::abs(d.x), std::abs(d.y));
    if (!(size > 0)) return;
    const Chord chord = chord_of(subject_.segment, {centre, 0}, 0);
    const dvec2 foot = centre + dvec2(chord.foot_x.value, chord.foot_y.value);
    const Extent shown = subject_.panel.shown();
    const dvec2 reach = (shown.size().x + shown.size().y) * glm::normalize(d / size);
    add_stroke("b line", Role::guide, foot - reach, foot + reach, false, true);
    add_stroke("e perpendicular", Role::measure, centre, foot);
    add_point("e foot", Role::measure, foot, words_.say("foot"), true);
  }

  void add_chord(double foot, double half) {
    // A tangent touches at the foot, which needs no second name
    if (half == 0) return void(view_.marks.erase("e foot name"));
    const dvec2 d = subject_.segment.b - subject_.segment.a, middle = subject_.segment.a + foot * d;
    view_.marks.erase("b line");
    add_stroke("b line", Role::guide, middle - 1.4 * half * d, middle + 1.4 * half * d, false, true);
    add_stroke("e half", Role::measure, middle, middle + half * d);
    if (const dvec2 name = middle + 0.5 * half * d; subject_.panel.shown().holds(name)) {
      view_.add({"e half name", Role::measure, Label{subject_.panel.at(name), words_.say("half")}});
    }
    if (shown(foot)) add_t("foot", Role::measure, foot, words_.say("foot"), true);
  }

  /// Where the line enters and leaves, in the plane and on the number line.
  void add_values(double enters, double leaves) {
    const auto at = [](double t) { return " " + figure_real(t); };
    if (enters == leaves) {
      const std::string touches = words_.say("touches_at", {{"t", enters}});
      return add_value("enters", enters, touches, touches, false);
    }
    add_value("enters", enters, words_.say("enters"), words_.say("enters") + at(enters), false);
    add_value("leaves", leaves, words_.say("leaves"), words_.say("leaves") + at(leaves), true);
  }

  void add_limits(double first, double last) {
    add_band("c kept t", Role::accepted, subject_.line.at(first), subject_.line.at(last));
    add_part("d kept", Role::accepted, part(subject_.segment.a, subject_.segment.b, first, last));
  }

  /// An end that was told from the circle looks as it lies.
  void add_end(const std::string& id, dvec2 at, int side, const std::string& name) {
    view_.marks.erase("b " + id);
    view_.marks.erase("b " + id + " name");
    add_point("b " + id, side > 0 ? Role::rejected : Role::accepted, at, name);
  }

  /// Whether of a segment with both ends outside a single point is left.
  bool touches() const {
    const auto& right = subject_.right;
    return right && right->a == right->b && right->a != subject_.segment.a && right->a != subject_.segment.b;
  }
  void add_cut(const Cut<double>& c) {
    if (touches()) return add_point("g enters", Role::candidate, c.at, words_.say("touches"));
    add_point(c.leaves ? "g leaves" : "g enters", c.leaves ? Role::past : Role::candidate, c.at,
              words_.say(c.leaves ? "leaves" : "enters"), c.leaves);
  }

  void add_result(const std::optional<Ends>& kept, bool wrong) {
    std::erase_if(view_.marks, [](const auto& mark) {
      return mark.first.starts_with("d ") || mark.first.starts_with("e ");
    });
    if (!subject_.has_line) {
      view_.marks.erase("b from name");
      view_.marks.erase("b to name");
    }
    if (kept) add_part("h result", Role::result, *kept);
    if (!wrong || !subject_.right) return;
    add_stroke("e right", Role::measure, subject_.right->a, subject_.right->b);
    add_point("e right at", Role::measure, subject_.right->b, words_.say("right"), true);
  }

 private:
  bool shown(double t) const { return subject_.t.lower.x <= t && t <= subject_.t.upper.x; }

  void add_point(const std::string& id, Role role, dvec2 at, const std::string& name, bool ring = false) {
    circle_drawing::add_point(view_, subject_.panel, id, role, at, name, ring);
  }
  void add_stroke(std::string id, Role role, dvec2 a, dvec2 b, bool arrow = false, bool dashed = false) {
    circle_drawing::add_stroke(view_, subject_.panel, std::move(id), role, a, b, arrow, dashed);
  }
  /// A value on the number line.
  void add_t(const std::string& id, Role role, double t, const std::string& name, bool ring = false) {
    constexpr dvec2 name_up{0, 1.5};
    view_.add({"c " + id + " t", role, Dot{subject_.line.at(t), ring}});
    view_.add({"c " + id + " t name", role, Text{subject_.line.at(t) + name_up, name}});
  }
  /// A point of the circle: a dot where the line enters, a ring where it leaves.
  void add_value(const std::string& id, double t, const std::string& name, const std::string& name_of_t,
                 bool leaves) {
    const Role role = leaves ? Role::past : Role::candidate;
    const dvec2 at = subject_.segment.a + t * (subject_.segment.b - subject_.segment.a);
    add_point("g " + id, role, at, name, leaves);
    if (shown(t)) add_t(id, role, t, name_of_t, leaves);
    for (auto& [key, mark] : view_.marks) {
      if (key.starts_with("g " + id) || key.starts_with("c " + id)) mark.quantity = id;
    }
  }

  /// A part of the segment as a band, so that it is seen on the line.
  void add_part(const std::string& id, Role role, const Ends& kept) {
    const auto part = circle_drawing::shown_part(subject_.panel, kept.a, kept.b);
    if (!part) return;
    const dvec2 a = subject_.panel.at(part->first), b = subject_.panel.at(part->second);
    view_.add({id + " from", role, Dot{a}});
    if (a == b) return;
    view_.add({id, role, Stroke{a, b}});
    add_band(id, role, a, b);
    view_.add({id + " to", role, Dot{b}});
  }
  void add_band(const std::string& id, Role role, dvec2 a, dvec2 b) {
    if (a == b) return;
    const dvec2 along = glm::normalize(b - a), aside = 0.35 * dvec2{-along.y, along.x};
    const std::vector<dvec2> ring{a + aside, b + aside, b - aside, a - aside};
    view_.add({id + " band", role, Area{{ring}}});
    view_.add({id + " outline", role, Path{ring, true}});
  }

  const Words& words_;
  const Subject& subject_;
  View view_;
};

}  // namespace gradus::liang_barsky_circle
