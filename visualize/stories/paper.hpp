#pragma once
// Drawings in a plane without cells: geometry in coordinates of its own, shown in one panel of the paper or
// in several. A story says what each step looks like as a whole; the step's delta is the difference of two
// such views.

#include <cmath>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry.hpp"
#include "figure/drawing.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// A whole drawing.
struct View {
  std::map<std::string, Mark> marks{};
  std::map<std::pair<int, int>, CellLook> cells{};  ///< by (row, column)
  bool plane = true;

  void add(Mark mark) { marks.insert_or_assign(mark.id, mark); }
  /// A dot, or a ring, with its name beside it; the name is a mark of its own.
  void add_named(const std::string& id, std::string name_id, Role role, dvec2 at, std::string name,
                 bool ring = false, const std::string& quantity = {}) {
    add({id, role, Dot{at, ring}, quantity});
    add({std::move(name_id), role, Label{at, std::move(name)}, quantity});
  }
  void add_named(const std::string& id, Role role, dvec2 at, std::string name, bool ring = false,
                 const std::string& quantity = {}) {
    add_named(id, id + " name", role, at, std::move(name), ring, quantity);
  }
};

/// What turns one drawing into the other.
Delta difference(const View& before, const View& after);

/// What a drawing starts from: a grid's bare cells.
inline View bare_grid() { return {.plane = false}; }

/// The drawing that is shown, from step to step.
class Shown {
 public:
  /// Shows another drawing; what that changes.
  Delta change_to(View view) {
    Delta delta = difference(view_, view);
    view_ = std::move(view);
    return delta;
  }

 private:
  View view_ = bare_grid();
};

/// A paper of so many units, y up, the origin in its lower left corner; all of it is always shown. Texts are
/// about 1.3 units high where it is 36 x 27 and fills a slide's drawing. Domain: width, height >= 1.
Grid paper_grid(int width, int height);

/// A rectangle of some plane; without any point in it until one is added.
struct Extent {
  dvec2 lower{std::numeric_limits<double>::max()}, upper{std::numeric_limits<double>::lowest()};

  void add(dvec2 p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  dvec2 size() const { return upper - lower; }
  dvec2 centre() const { return (lower + upper) * 0.5; }
  bool holds(dvec2 p) const { return p == glm::clamp(p, lower, upper); }
  /// From `lower` on, all round.
  std::vector<dvec2> corners() const { return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}; }
};

/// Lengths of any size: no square overflows or underflows.
inline double length_between(dvec2 a, dvec2 b) { return length_of(b - a); }
inline double length_between(dvec3 a, dvec3 b) { return length_of(b - a); }

/// The rectangle with a margin all round, in parts of its larger side.
Extent widened(Extent extent, double part);

/// The values of t from `first` to `last` for which a rectangle holds a + t way; none where the first of the
/// two is above the second.
std::pair<double, double> span_in(const Extent& frame, dvec2 a, dvec2 way, double first, double last);

/// The part of a segment that a rectangle shows, or nothing.
std::optional<Stroke> shown_part(const Extent& frame, dvec2 a, dvec2 b);

/// Where a corner of a ring can be taken hold of in a rectangle: at its place, or where the first of its two
/// sides that are seen there comes in; or nothing. The corner may have been moved a little: it is the ring's
/// nearest one.
std::optional<dvec2> grip(const Extent& frame, const std::vector<dvec2>& ring, dvec2 corner);

/// A part of the paper that shows a rectangle of some plane, y up there.
class Panel {
 public:
  /// How a plane is fitted into its place: with one scale for both axes, or stretched along each.
  enum class Fit { same_scale, stretched };

  /// place: in paper units, of a paper whose y points up or, as pictures' do, down. world: what is shown. One
  /// of no size across an axis (a point, a line) is shown in the middle there.
  Panel(Extent place, Extent world, Fit fit = Fit::same_scale, bool paper_y_up = true);

  dvec2 at(dvec2 world) const {
    return middle_ + (world - world_.centre()) * dvec2{scale_.x, paper_y_up_ ? scale_.y : -scale_.y};
  }
  /// The same of a point that is shown.
  std::optional<dvec2> shown_at(dvec2 world) const {
    return shown().holds(world) ? std::optional(at(world)) : std::nullopt;
  }
  /// Paper units per unit of the plane.
  dvec2 scale() const { return scale_; }
  const Extent& place() const { return place_; }
  /// What the whole place shows: at least the world that was asked for.
  Extent shown() const;

  std::vector<dvec2> at(std::span<const dvec2> world) const;

 private:
  Extent place_, world_;
  dvec2 middle_, scale_;
  bool paper_y_up_;
};

/// The distance between ticks: 1, 2 or 5 times a power of ten, so that `length` has at most `most` of them.
/// Domain: 0 < length, finite; most >= 1.
double tick_distance(double length, int most);

/// Whether a scale from `least` to `most` can show where a number on it lies: it is neither too short for
/// the doubles there nor so long or short that lengths on paper leave their range.
bool can_be_told_apart(double least, double most);

/// Refuses what the panel can't show, in the name of the parameter among these that was given.
void require_scale(const Panel& panel, const Arguments& arguments,
                   std::initializer_list<std::string_view> parameters);

/// A panel no larger than what it is to show, in the middle of its place and at its foot, so that nothing
/// beside it keeps a drawing small. A narrow world keeps room for texts beside what is drawn there.
Panel tight_panel(const Extent& place, const Extent& world);

/// Names of a panel's axes; an empty one leaves the axis away.
struct AxisNames {
  std::string x = "x", y = "y";
};

/// Axes with round numbers along the panel's lower and left border. `name` begins the ids of their marks.
void add_axes(View& view, const Panel& panel, std::string_view name, const AxisNames& names = {},
              int most = 6);

/// A straight scale from `from` to `to` of the paper with round numbers below it, that shows the values from
/// `least` to `most`.
class NumberLine {
 public:
  NumberLine(dvec2 from, dvec2 to, double least, double most)
      : from_(from), to_(to), least_(least), most_(most) {}
  dvec2 at(double value) const { return from_ + (value - least_) / (most_ - least_) * (to_ - from_); }
  void add_to(View& view, std::string_view name, std::string_view symbol, int ticks = 6) const;

 private:
  dvec2 from_, to_;
  double least_, most_;
};

/// Space to paper, oblique: x to the right, y up, z towards the reader down to the left, shortened.
constexpr dvec2 oblique(dvec3 p) { return {p.x - 0.42 * p.z, p.y - 0.3 * p.z}; }
/// From any point there to the reader.
inline constexpr dvec3 towards_oblique{0.42, 0.3, 1};

/// A number as figures show it: four significant digits or so, the typographic minus.
std::string figure_real(double value);
/// The same of what is no more than a rounding error below `noise`: then it is 0.
inline std::string figure_real(double value, double noise) {
  return figure_real(std::abs(value) < noise ? 0 : value);
}
/// A number's text as a later term or factor: "(−4)" when negative.
inline std::string figure_factor(std::string number) {
  return number.starts_with("−") ? "(" + number + ")" : number;
}
inline std::string figure_factor(double value) { return figure_factor(figure_real(value)); }

/// Two slanted strokes across a line of this direction, a unit vector: what goes on there is left out.
inline void add_break(View& view, const std::string& id, Role role, dvec2 at, dvec2 along) {
  const dvec2 slanted = 0.45 * dvec2{along.x * 0.5 - along.y, along.x + along.y * 0.5};
  for (const double aside : {-0.2, 0.2}) {
    const dvec2 middle = at + aside * along;
    view.add({fmt::format("{} {}", id, aside < 0 ? 1 : 2), role, Stroke{middle - slanted, middle + slanted}});
  }
}

/// "(1, −0.5)", "(1, −0.5, 2)", with no-break spaces: a point's numbers as `text` has them.
template <int N, class Text>
std::string figure_place(const glm::vec<N, double>& p, Text text) {
  std::string place = "(";
  for (int i = 0; i < N; ++i) place += (i > 0 ? ",\u00a0" : "") + text(p[i]);
  return place + ")";
}
template <int N>
std::string figure_place(const glm::vec<N, double>& p) {
  return figure_place(p, [](double number) { return figure_real(number); });
}

}  // namespace gradus
