#pragma once
// What the stories of circles draw alike.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clipping/liang_barsky_circle/circle_and_line.hpp"
#include "core/arithmetic/elementary.hpp"
#include "stories/paper.hpp"
#include "stories/telling.hpp"

namespace gradus::circle_drawing {

/// An arc as a chain of points close enough for the eye: from an angle on, counter-clockwise, in radians.
inline std::vector<dvec2> arc(const Circle<double>& circle, double from, double sweep) {
  const int chords = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) * 20)));
  std::vector<dvec2> points;
  for (int i = 0; i <= chords; ++i) {
    const SinCos at = sin_cos(from + sweep * i / chords);
    points.push_back(circle.centre + circle.radius * dvec2(at.cos, at.sin));
  }
  return points;
}

/// The circle as a closed chain, without its first point again.
inline std::vector<dvec2> whole(const Circle<double>& circle) {
  std::vector<dvec2> points = arc(circle, 0, 0x1.921fb54442d18p2);
  points.pop_back();
  return points;
}

/// The point of a segment nearest to another: the foot of the perpendicular, or an end. Accuracy: a few ulp
/// of the larger of its distance and that point's coordinates, however far the ends.
inline dvec2 nearest_on(const Segment<2, double>& s, dvec2 to) {
  if (!liang_barsky_circle::foot_between(s, to))
    return liang_barsky_circle::past_foot(s.a, s, to) >= 0 ? s.a : s.b;
  const auto chord = liang_barsky_circle::chord_of(s, {to, 0}, 0);  // of a point: its foot is what is asked
  return to + dvec2(chord.foot_x.value, chord.foot_y.value);
}

/// The part of the way from a to b that a rectangle holds, as far as doubles have it near a; or nothing.
inline std::optional<std::pair<dvec2, dvec2>> part_in(const Extent& box, dvec2 a, dvec2 b) {
  const auto [first, last] = span_in(box, a, b - a, 0, 1);
  if (first > last) return std::nullopt;
  const auto at = [&](double t) { return t == 0 ? a : t == 1 ? b : a + t * (b - a); };
  return std::pair{at(first), at(last)};
}

/// The part of the way from a to b that the panel shows; nothing where it shows none. From the point nearest
/// to the panel's middle to both sides, for seen from a far end all of the panel is one number.
inline std::optional<std::pair<dvec2, dvec2>> shown_part(const Panel& panel, dvec2 a, dvec2 b) {
  const Extent box = panel.shown();
  const dvec2 near = nearest_on({a, b}, box.centre()), off = glm::abs(near - box.centre());
  const double most = box.size().x + box.size().y;
  if (!(off.x <= most && off.y <= most)) return std::nullopt;
  const auto to_a = part_in(box, near, a), to_b = part_in(box, near, b);
  if (to_a && to_b) return std::pair{to_a->second, to_b->second};
  if (to_a) return std::pair{to_a->second, to_a->first};
  return to_b;
}

inline void add_stroke(View& view, const Panel& panel, std::string id, Role role, dvec2 a, dvec2 b,
                       bool arrow = false, bool dashed = false) {
  const auto part = shown_part(panel, a, b);
  if (!part) return;
  view.add({std::move(id), role,
            Stroke{panel.at(part->first), panel.at(part->second), arrow && part->second == b, dashed}});
}

/// A dot with a name beside it.
inline void add_point(View& view, const Panel& panel, const std::string& id, Role role, dvec2 at,
                      const std::string& name, bool ring = false) {
  if (panel.shown().holds(at)) view.add_named(id, role, panel.at(at), name, ring);
}

/// What can be dragged: the corners or ends, the circle by its point farthest to the left, or by its centre
/// where that is drawn, and its radius by the point farthest to the right.
inline void let_drag(Narrator& narrator, std::string_view points, const Circle<double>& circle,
                     const Panel& panel, bool by_centre) {
  narrator.handles(points, shown_in(panel));
  const dvec2 right{circle.radius, 0}, grip = by_centre ? dvec2{0} : -right;
  narrator.handles("circle", [&](dvec2 centre) { return panel.at(centre + grip); });
  narrator.handle("circle", 2, panel.at(circle.centre + right), {panel.scale().x, 0});
}

/// Coordinates that a figure can show: differences and their sums are finite.
inline void expect_coordinates(std::string_view flag, std::initializer_list<dvec2> points) {
  for (const dvec2 p : points) {
    for (const double x : {p.x, p.y}) {
      if (std::abs(x) > 1e300) refuse(flag, "coordinates up to 1e300 in size expected, found {}", x);
    }
  }
}

/// The circle of the numbers cx, cy, r, as far as a figure can show it.
inline Circle<double> circle_in(const Arguments& arguments) {
  const std::vector<double> numbers = arguments.numbers("circle");
  const double r = numbers[2];
  if (!(r >= 0)) refuse("circle", "a radius of 0 or more expected, the third number");
  if (r != 0 && !(1e-290 <= r && r <= 1e290)) {
    refuse("circle", "a radius of 0 or from 1e-290 to 1e290 expected, found {}", r);
  }
  expect_coordinates("circle", {{numbers[0], numbers[1]}});
  return {{numbers[0], numbers[1]}, r};
}

/// A number value * 2^exponent as figures show numbers, also one beyond doubles.
inline std::string scaled_real(double value, int exponent) {
  const double whole = std::ldexp(value, exponent);
  if (value == 0 || (1e-290 <= std::abs(whole) && std::isfinite(whole))) return figure_real(whole);
  double digits = std::abs(value);
  int power = 0;
  for (; digits >= 10; digits /= 10) ++power;
  for (; digits < 1; digits *= 10) --power;
  for (; exponent > 0; --exponent) {
    digits *= 2;
    if (digits >= 10) digits /= 10, ++power;
  }
  for (; exponent < 0; ++exponent) {
    digits /= 2;
    if (digits < 1) digits *= 10, --power;
  }
  // 9.996 has one digit more when it is rounded
  if (digits >= 9.995) digits /= 10, ++power;
  return fmt::format("{}{:.3g}e{:+03}", value < 0 ? "−" : "", digits, power);
}
/// The same of a double: one near the smallest is not 0.
inline std::string real(double value) { return scaled_real(value, 0); }

}  // namespace gradus::circle_drawing
