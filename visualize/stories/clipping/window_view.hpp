#pragma once
// What stories of segments in a window draw alike: the plane round the window, the segment, its parts.

#include <bit>
#include <cstdint>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"
#include "core/geometry.hpp"
#include "stories/clipping/axis_arguments.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::window_view {

using Line = Segment<2, double>;
using Rectangle = AxisBox<2, double>;

inline constexpr int paper_width = 36, paper_height = 27;

/// Sizes of what can be drawn, and of what the methods that round can be watched with: products of three of
/// these numbers' differences neither overflow nor underflow.
inline constexpr Sizes line_sizes{1e-100, 8e307}, window_sizes{1e-100, 1e150}, rounded_sizes{1e-75, 1e75};

inline Line line_in(const Arguments& arguments) { return segment_in<2>(arguments, "line"); }
inline Rectangle window_in(const Arguments& arguments) { return box_in<2>(arguments, "window"); }

/// What of the plane is shown: the window with room round it, and ends of the segment that are not far away.
/// rim: of this place, so much of the paper round the window.
inline Extent world_of(const Line& line, const Rectangle& window, const Extent& place = {}, dvec2 rim = {}) {
  Extent world{window.lower, window.upper};
  const dvec2 size = world.size();
  double room = std::max(size.x, size.y);
  if (room == 0) room = 1e-3 * std::max(std::abs(window.lower.x), std::abs(window.lower.y));
  if (room == 0) room = 1;
  const Rectangle near{window.lower - 1.6 * room, window.upper + 1.6 * room};
  world = {window.lower - 0.24 * room, window.upper + 0.24 * room};
  for (const dvec2 end : {line.a, line.b}) {
    if (cohen_sutherland_2d::region_code(end, near) == 0) world.add(end);
  }
  // Of a segment that passes by, so much that its way is seen
  const auto seen = cohen_sutherland_2d::correctly_rounded(line, Rectangle{world.lower, world.upper});
  if (!seen || length_between(seen->a, seen->b) < 0.3 * room) {
    const Rectangle beside{window.lower - 0.8 * room, window.upper + 0.8 * room};
    if (const auto part = cohen_sutherland_2d::correctly_rounded(line, beside)) {
      world.add(part->a);
      world.add(part->b);
    }
  }
  // The rim takes room from what it is measured by
  for (int i = 0; i < 3 && rim.x > 0; ++i) {
    const dvec2 units = world.size() / place.size();
    const double unit = std::max(units.x, units.y);
    world.add(window.lower - unit * rim);
    world.add(window.upper + unit * rim);
  }
  return widened(world, 0.015);
}

/// Refuses a window that no paper can show.
inline void require_scale(const Arguments& arguments, const Line& line, const Rectangle& window) {
  const Extent paper{{0, 0}, {paper_width, paper_height}};
  gradus::require_scale(Panel(paper, world_of(line, window)), arguments, {"window"});
}

/// The plane in a part of the paper.
class DrawnPlane {
 public:
  DrawnPlane(const Line& line, const Rectangle& window, Extent place, dvec2 rim = {})
      : panel_(tight_panel(place, world_of(line, window, place, rim))), window_(window) {
    const Extent shown = panel_.shown();
    shown_ = {shown.lower, shown.upper};
  }
  const Panel& panel() const { return panel_; }
  const Rectangle& shown() const { return shown_; }

  /// A place for a text of this size within a part of the plane: as far as can be from a segment, and rather
  /// in the middle. Nothing where the part is too small.
  std::optional<dvec2> clear_place(const Rectangle& part, const Line& line, dvec2 size) const {
    const dvec2 lower = panel_.at(part.lower) + 0.5 * size, upper = panel_.at(part.upper) - 0.5 * size;
    if (!(lower.x <= upper.x && lower.y <= upper.y)) return std::nullopt;
    const auto drawn = cohen_sutherland_2d::correctly_rounded(line, shown_);
    std::optional<dvec2> best;
    double most = 0;
    constexpr int places = 6;
    for (int i = 0; i <= places; ++i) {
      for (int k = 0; k <= places; ++k) {
        const dvec2 off{static_cast<double>(i) / places, static_cast<double>(k) / places};
        const dvec2 at = lower + off * (upper - lower);
        const double clear = drawn ? distance_to(panel_.at(drawn->a), panel_.at(drawn->b), at) : 9;
        const double worth = std::min(clear, 0.75 * size.x) - 0.4 * length_of(off - 0.5);
        if (best && worth <= most) continue;
        best = at;
        most = worth;
      }
    }
    return best;
  }

  /// Axes, the window, and its borders on and on.
  void add_window(View& view, const Words& words) const {
    add_axes(view, panel_, "plane", {words.symbol("x"), words.symbol("y")});
    const std::vector<dvec2> corners = Extent{window_.lower, window_.upper}.corners();
    view.add({"window", Role::boundary, Path{panel_.at(corners), true}});
    for (const Border border : usual_order<2>()) {
      dvec2 from = shown_.lower, to = shown_.upper;
      from[axis_of(border)] = to[axis_of(border)] = coordinate(window_, border);
      view.add({fmt::format("border {}", static_cast<int>(border)), Role::guide,
                Stroke{panel_.at(from), panel_.at(to), false, true}});
    }
  }

  /// The border that is cut at, and all that lies beyond it.
  void add_cutting_border(View& view, Border border) const {
    const double c = coordinate(window_, border);
    dvec2 from = shown_.lower, to = shown_.upper;
    from[axis_of(border)] = to[axis_of(border)] = c;
    Rectangle beyond = shown_;
    (is_upper(border) ? beyond.lower : beyond.upper)[axis_of(border)] = c;
    view.add({"beyond", Role::measure, Area{{panel_.at(Extent{beyond.lower, beyond.upper}.corners())}}});
    view.add({"border cut at", Role::measure, Stroke{panel_.at(from), panel_.at(to)}});
  }

  /// The part of a segment that the panel shows.
  void add_line(View& view, std::string id, Role role, const Line& line, bool dashed = false) const {
    if (line.a == line.b) return;
    const auto seen = cohen_sutherland_2d::correctly_rounded(line, shown_);
    if (seen && seen->a != seen->b) {
      view.add({std::move(id), role, Stroke{panel_.at(seen->a), panel_.at(seen->b), false, dashed}});
    }
  }

  /// A point with a name. One beyond the panel is named, with its place, where the line to it leaves, behind
  /// a break of that line.
  void add_point(View& view, const std::string& id, Role role, dvec2 at, dvec2 along, const std::string& name,
                 bool ring = false, const std::string& quantity = {}) const {
    if (cohen_sutherland_2d::region_code(at, shown_) == 0) {
      view.add({id, role, Dot{panel_.at(at), ring}, quantity});
      if (!name.empty()) view.add({id + " name", role, Label{panel_.at(at), name}, quantity});
      return;
    }
    const auto seen = cohen_sutherland_2d::correctly_rounded(Line{at, along}, shown_);
    if (!seen || name.empty()) return;
    const dvec2 edge = panel_.at(seen->a), way = panel_.at(seen->b) - edge;
    const double length = length_of(way);
    if (length > 2) add_break(view, id + " break", role, edge + way * (0.9 / length), way / length);
    view.add({id + " name", role, Label{edge, fmt::format("{} {}", name, figure_place(at))}, quantity});
  }

 private:
  static double distance_to(dvec2 a, dvec2 b, dvec2 p) {
    const dvec2 way = b - a;
    const double square = way.x * way.x + way.y * way.y;
    const double t = square > 0 ? ((p.x - a.x) * way.x + (p.y - a.y) * way.y) / square : 0;
    return length_between(p, a + std::clamp(t, 0.0, 1.0) * way);
  }

  Panel panel_;
  Rectangle window_, shown_;
};

/// What of the plane can be dragged: the segment's ends and the window's corners.
inline void let_drag(Narrator& narrator, const DrawnPlane& plane) {
  for (const std::string_view drawn : {"line", "window"}) narrator.handles(drawn, shown_in(plane.panel()));
}

/// How many doubles one is from the other: they have the order of their bits, those below 0 the reverse.
inline std::int64_t doubles_between(double x, double y) {
  const auto number_of = [](double v) {
    const auto bits = std::bit_cast<std::int64_t>(v);
    return bits < 0 ? INT64_MIN - bits : bits;  // 0 and -0 are one
  };
  const auto [low, high] = std::minmax({number_of(x), number_of(y)});
  const auto steps = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  return static_cast<std::int64_t>(std::min<std::uint64_t>(steps, INT64_MAX));
}

/// How far the ends of a piece are from the right ones, each coordinate for itself.
struct Off {
  std::int64_t doubles = 0;  ///< the most that one of them is off
  double distance = 0;
};

inline Off off_by(const Line& found, const Line& right) {
  Off most;
  for (int axis = 0; axis < 2; ++axis) {
    for (const auto& [x, y] : {std::pair{found.a[axis], right.a[axis]}, {found.b[axis], right.b[axis]}}) {
      most.doubles = std::max(most.doubles, doubles_between(x, y));
      most.distance = std::max(most.distance, std::abs(x - y));
    }
  }
  return most;
}

/// A piece that lies in the window is what is left: told with how many doubles rounding has moved its ends
/// by, or, where those are too many to count, next to 0, how far.
inline Event accepted(const Line& piece, const Off& off) {
  constexpr std::int64_t countable = 1'000'000;
  Event event{.text = off.doubles < countable ? "accepted_off" : "accepted_far",
              .facts = {{"x0", piece.a.x, "x"},
                        {"y0", piece.a.y, "y"},
                        {"x1", piece.b.x, "x"},
                        {"y1", piece.b.y, "y"}},
              .words = {{"from", piece.a}, {"to", piece.b}, {"distance", off.distance}},
              .ends = true};
  if (off.doubles == 0) event.text = "accepted";
  if (event.text == "accepted_off") event.count = off.doubles;
  return event;
}

/// The parameters that both topics have.
inline Parameter line_parameter() {
  return parameters::numbers("line", "-1,-2,9,8", "-5,8,3,20",
                             "the segment, from (x0, y0) to (x1, y1); y points up", {"x0", "y0", "x1", "y1"},
                             line_sizes);
}
inline Parameter window_parameter() {
  return parameters::bounds("window", "0,0,8,6", "0,0,10,8", "the window, its borders included",
                            {"xmin", "ymin", "xmax", "ymax"}, window_sizes);
}
inline Parameter order_parameter() {
  return gradus::order_parameter<2>("top,bottom,right,left", "in which order the borders are taken");
}

}  // namespace gradus::window_view
