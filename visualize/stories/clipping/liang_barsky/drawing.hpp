#pragma once
// A segment a + t d, drawn in a window or in a box: what stands above the scale of t.

#include "clipping/liang_barsky/liang_barsky.hpp"
#include "stories/clipping/box_view.hpp"
#include "stories/clipping/window_view.hpp"

namespace gradus::liang_barsky {

template <int N>
struct Subject {
  Segment<N, double> line;
  AxisBox<N, double> box;

  glm::vec<N, double> point(double t) const { return line.a * (1 - t) + line.b * t; }
  bool crosses(Border border) const { return line.a[axis_of(border)] != line.b[axis_of(border)]; }
  bool enters(Border border) const {
    return (line.a[axis_of(border)] < line.b[axis_of(border)]) != is_upper(border);
  }
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

/// The scale of t: from the least to the greatest value that is not far away. Those that are stand beyond a
/// break, at its ends.
class Scale {
 public:
  Scale(double least, double most, const std::vector<double>& values)
      : least_(least),
        most_(most),
        low_(std::ranges::any_of(values, [&](double t) { return t < least; })),
        high_(std::ranges::any_of(values, [&](double t) { return t > most; })),
        line_({low_ ? from + off : from, height}, {high_ ? to - off : to, height}, least, most) {}

  bool holds(double t) const { return least_ <= t && t <= most_; }
  dvec2 at(double t) const {
    return t < least_ ? dvec2{from, height} : t > most_ ? dvec2{to, height} : line_.at(t);
  }
  void add_to(View& view, std::string_view symbol) const {
    line_.add_to(view, "t", symbol);
    // Of several drawings none has room for numbers
    for (auto& [id, mark] : view.marks) {
      auto* const text = std::get_if<Text>(&mark.shape);
      if (text && id.starts_with("scale t")) text->aside = true;
    }
    if (low_) add_end(view, "t low", {from, height}, line_.at(least_));
    if (high_) add_end(view, "t high", {to, height}, line_.at(most_) + dvec2{name_room, 0});
  }

 private:
  static constexpr double from = 7, to = 29, height = 2.3, off = 4, name_room = 2.4;
  /// The axis goes on behind a break.
  static void add_end(View& view, const std::string& id, dvec2 end, dvec2 scale) {
    const dvec2 way = scale - end, middle = end + 0.5 * way;
    view.add({id + " 1", Role::guide, Stroke{end, middle - 0.08 * way}});
    view.add({id + " 2", Role::guide, Stroke{middle + 0.08 * way, scale}});
    add_break(view, id + " break", Role::guide, middle, {1, 0});
  }

  double least_, most_;
  bool low_, high_;
  NumberLine line_;
};

/// Texts over the scale, each on a stem, in as few rows as keep them apart: no text lies on another one, and
/// no stem crosses a text.
class Rows {
 public:
  /// A text and where its stem stands.
  struct Entry {
    double x;
    std::string text;
  };
  struct Place {
    double height = 1.5;  ///< over the scale
    Align align = Align::centre;
  };

  /// Of all values that there will be, so that a text keeps its place from step to step.
  explicit Rows(std::vector<Entry> entries) : entries_(std::move(entries)), placed_(entries_.size()) {
    // Those that can lie beside the other stems first, the others above them
    for (const bool beside : {true, false}) {
      for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (!placed_[i]) place(i, beside);
      }
    }
  }
  Place of(const std::string& text) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].text == text && placed_[i]) return {1.5 + 1.6 * placed_[i]->row, placed_[i]->align};
    }
    return {};
  }

 private:
  struct Placed {
    int row;
    Align align;
    double from, to;
  };

  Placed at(std::size_t i, int row, Align align) const {
    const double x = entries_[i].x,
                 width = 0.72 * static_cast<double>(without_notes(entries_[i].text).size()) + 0.6;
    const double from = align == Align::left ? x : align == Align::right ? x - width : x - width / 2;
    return {row, align, from, from + width};
  }
  static bool on_paper(const Placed& text) {
    return 0.5 <= text.from && text.to <= window_view::paper_width - 0.5;
  }
  bool over_a_stem(const Placed& text, std::size_t own) const {
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const double x = entries_[k].x;
      if (k != own && text.from + 0.2 < x && x < text.to - 0.2) return true;
    }
    return false;
  }
  bool on_a_text(const Placed& text) const {
    return std::ranges::any_of(placed_, [&](const auto& other) {
      return other && other->row == text.row && text.from < other->to && other->from < text.to;
    });
  }
  void place(std::size_t i, bool beside) {
    int above = 0;
    for (const auto& other : placed_) above = other && !beside ? std::max(above, other->row + 1) : above;
    for (int row = above; !placed_[i] && row <= above + static_cast<int>(entries_.size()); ++row) {
      for (const Align align : {Align::centre, Align::right, Align::left}) {
        const Placed text = at(i, row, align);
        if (!on_paper(text) || (beside && over_a_stem(text, i)) || on_a_text(text)) continue;
        placed_[i] = text;
        break;
      }
    }
  }

  std::vector<Entry> entries_;
  std::vector<std::optional<Placed>> placed_;
};

/// The plane or the space round the line.
template <int N>
class Ground;

template <>
class Ground<2> {
 public:
  explicit Ground(const Subject<2>& subject)
      : subject_(subject), plane_(subject.line, subject.box, {{3.2, 9.8}, {35, 25.4}}) {}

  static constexpr double least = -1, most = 2;  ///< values of t that are not far away
  void add_box_and_ends(View& view, const Words& words) const {
    plane_.add_window(view, words);
    plane_.add_point(view, "end a", Role::input, subject_.line.a, subject_.line.b, "a");
    plane_.add_point(view, "end b", Role::input, subject_.line.b, subject_.line.a, "b");
  }
  /// The line before and behind the segment, where it crosses borders.
  void add_prolonged(View& view) const {
    for (const double t : {least, most}) {
      const window_view::Line part{subject_.point(t), subject_.point(t < 0 ? 0 : 1)};
      if (is_finite(part.a)) plane_.add_line(view, t < 0 ? "line ahead" : "line behind", Role::guide, part);
    }
  }
  void add_part(View& view, std::string id, Role role, double from, double to, bool dashed) const {
    plane_.add_line(view, std::move(id), role, {subject_.point(from), subject_.point(to)}, dashed);
  }
  void add_crossing(View& view, const Crossed& c, Role role, const std::string& name,
                    const std::string& quantity) const {
    const dvec2 at = subject_.point(c.t);
    plane_.add_point(view, c.id(), role, at, at, name, c.leaves(), quantity);
  }
  void add_border(View& view, Border border) const { plane_.add_cutting_border(view, border); }
  void let_drag(Narrator& narrator) const { window_view::let_drag(narrator, plane_); }

 private:
  const Subject<2>& subject_;
  const window_view::DrawnPlane plane_;
};

template <>
class Ground<3> {
 public:
  explicit Ground(const Subject<3>& subject)
      : subject_(subject), space_({{3, 9}, {33, 26}}, corners_and_ends(subject)) {}

  static constexpr double least = -0.5, most = 1.5;
  void add_box_and_ends(View& view, const Words& words) const {
    add_box(view, space_, subject_.box);
    add_directions(view, {1.2, 22.4}, {words.symbol("x"), words.symbol("y"), words.symbol("z")});
    view.add_named("end a", Role::input, at(0), "a");
    view.add_named("end b", Role::input, at(1), "b");
  }
  static void add_prolonged(View&) {}
  void add_part(View& view, std::string id, Role role, double from, double to, bool dashed) const {
    view.add({std::move(id), role, Stroke{at(from), at(to), false, dashed}});
  }
  void add_crossing(View& view, const Crossed& c, Role role, const std::string& name,
                    const std::string& quantity) const {
    if (c.t < 0 || 1 < c.t) return;
    view.add_named(c.id(), role, at(c.t), name, c.leaves(), quantity);
  }
  void add_border(View& view, Border face) const { add_face(view, space_, box_face(subject_.box, face)); }
  void let_drag(Narrator& narrator) const {
    for (const std::string_view drawn : {"space_line", "box"})
      narrator.handles(drawn, [&](dvec3 p) { return space_.at(p); });
  }

 private:
  static std::vector<dvec3> corners_and_ends(const Subject<3>& subject) {
    std::vector<dvec3> points{subject.line.a, subject.line.b};
    for (int corner = 0; corner < 8; ++corner) points.push_back(box_corner(subject.box, corner));
    return points;
  }
  dvec2 at(double t) const { return space_.at(subject_.point(t)); }

  const Subject<3>& subject_;
  const SpaceView space_;
};

}  // namespace gradus::liang_barsky
