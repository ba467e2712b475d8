#pragma once
// A segment a + t d, drawn in a window or in a box: what stands above the scale of t.

#include "clipping/liang_barsky/liang_barsky.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/clipping/window_view.hpp"

namespace gradus::liang_barsky {

template <int N>
struct Task {
  Segment<N, double> line;
  AxisBox<N, double> box;

  glm::vec<N, double> point(double t) const { return line.a * (1 - t) + line.b * t; }
  /// Where the line crosses a border, for the drawing.
  double value_at(Border border) const {
    const int axis = axis_of(border);
    const double d = line.b[axis] * 0.5 - line.a[axis] * 0.5;
    const double way = coordinate(box, border) * 0.5 - line.a[axis] * 0.5;
    return d == 0 ? 0 : way / d;
  }
};

/// A border that the line crosses at t, as the drawing names it.
struct Crossed {
  Border border;
  Crossing crossing;
  double t;

  bool crosses() const { return enters() || leaves(); }
  bool enters() const { return crossing == Crossing::enters; }
  bool leaves() const { return crossing == Crossing::leaves; }
  std::string id() const { return fmt::format("value {}", name_of(border)); }
};

/// The values of t that the scale shows.
struct Values {
  double least, most;
  double clamped(double t) const { return std::clamp(t, least, most); }
  bool hold(double t) const { return least <= t && t <= most; }
};

/// The plane or the space round the line.
template <int N>
class Ground;

template <>
class Ground<2> {
 public:
  explicit Ground(const Task<2>& task) : task_(task), scene_(task.line, task.box, {{3.2, 9.8}, {35, 26}}) {}

  /// All crossings that are not far away.
  Values shown() const {
    Values shown{-0.05, 1.05};
    for (const Border border : usual_order<2>()) {
      const double t = task_.value_at(border);
      shown = {std::min(shown.least, t - 0.05), std::max(shown.most, t + 0.05)};
    }
    return {std::max(shown.least, -1.0), std::min(shown.most, 2.0)};
  }
  void add_box_and_ends(View& view, const Words& words) const {
    scene_.add_window(view, words);
    scene_.add_point(view, "end a", Role::input, task_.line.a, task_.line.b, "a");
    scene_.add_point(view, "end b", Role::input, task_.line.b, task_.line.a, "b");
  }
  void add_part(View& view, std::string id, Role role, double from, double to, bool dashed) const {
    scene_.add_line(view, std::move(id), role, {task_.point(from), task_.point(to)}, dashed);
  }
  /// Two rows of texts above the scale, entering below leaving, so that they don't meet.
  void add_crossing(View& view, const Crossed& c, Role role, const std::string& name, const std::string& text,
                    dvec2 foot) const {
    const dvec2 at = task_.point(c.t);
    scene_.add_point(view, c.id(), role, at, at, name, c.leaves());
    view.add({c.id() + " text", role, Text{foot + dvec2{0, c.enters() ? 1.7 : 3.8}, text}});
    view.add({c.id() + " stem", Role::guide, Stroke{foot, foot + dvec2{0, c.enters() ? 1.0 : 3.1}}});
  }
  /// The borders are lines that are always shown.
  static void add_border(View&, Border) {}

 private:
  const Task<2>& task_;
  const window_view::Scene scene_;
};

template <>
class Ground<3> {
 public:
  explicit Ground(const Task<3>& task) : task_(task), space_({{3, 9}, {33, 26}}, corners_and_ends(task)) {}

  static Values shown() { return {-0.5, 1.5}; }
  void add_box_and_ends(View& view, const Words& words) const {
    add_box(view, space_, task_.box);
    add_directions(view, {1.2, 22.4}, {words.symbol("x"), words.symbol("y"), words.symbol("z")});
    view.add_named("end a", Role::input, at(0), "a");
    view.add_named("end b", Role::input, at(1), "b");
  }
  void add_part(View& view, std::string id, Role role, double from, double to, bool dashed) const {
    view.add({std::move(id), role, Stroke{at(from), at(to), false, dashed}});
  }
  void add_crossing(View& view, const Crossed& c, Role role, const std::string& name, const std::string& text,
                    dvec2 foot) const {
    view.add({c.id() + " text", role, Label{foot, text}});
    if (c.t < 0 || 1 < c.t) return;
    view.add_named(c.id(), role, at(c.t), name, c.leaves());
  }
  void add_border(View& view, Border face) const { add_face(view, space_, box_face(task_.box, face)); }

 private:
  static std::vector<dvec3> corners_and_ends(const Task<3>& task) {
    std::vector<dvec3> points{task.line.a, task.line.b};
    for (int corner = 0; corner < 8; ++corner) points.push_back(box_corner(task.box, corner));
    return points;
  }
  dvec2 at(double t) const { return space_.at(task_.point(t)); }

  const Task<3>& task_;
  const SpaceView space_;
};

}  // namespace gradus::liang_barsky
