#pragma once
// How polygons are drawn that ears are cut off from: corners with their names, triangles with their smallest
// angle.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "stories/rings.hpp"
#include "stories/telling.hpp"

namespace gradus::ear_clipping {

inline constexpr int paper_width = 36, paper_height = 27;
inline constexpr Extent picture_place{{1.8, 1.8}, {34.2, 25.2}};

/// What a run is about: points and rings of their numbers, the outline first.
struct Subject {
  std::vector<dvec2> points;
  std::vector<std::vector<int>> rings;
  bool turned = false;  ///< the outline was given clockwise

  dvec2 at(int number) const { return points[static_cast<std::size_t>(number)]; }
  std::vector<dvec2> places(const std::vector<int>& numbers) const {
    return mapped(numbers, [this](int number) { return at(number); });
  }
};

/// "A" to "Z", "A1" from then on.
inline std::string corner_name(int number) {
  std::string name(1, static_cast<char>('A' + number % 26));
  if (number >= 26) name += fmt::format("{}", number / 26);
  return name;
}
inline std::string names_of(const Triangle& t) {
  return fmt::format("{} {} {}", corner_name(t[0]), corner_name(t[1]), corner_name(t[2]));
}

/// The angle at b from c to a, counter-clockwise, in degrees: the inside of a ring that runs a, b, c.
inline double angle_at(dvec2 a, dvec2 b, dvec2 c) {
  const dvec2 to = c - b, from = a - b;
  const double radians = atan2(to.x * from.y - to.y * from.x, to.x * from.x + to.y * from.y);
  return (radians < 0 ? radians + 0x1.921fb54442d18p2 : radians) * (360 / 0x1.921fb54442d18p2);
}
/// "31.4°", as sentences and drawings have it.
inline std::string degrees(double angle) { return figure_real(std::round(angle * 10) / 10) + "°"; }

/// The smallest angle of a triangle, and where.
struct Smallest {
  Triangle triangle;  ///< from the corner before on
  double angle;
};
inline Smallest smallest_in(const Subject& subject, const Triangle& t) {
  Smallest smallest{t, 361};
  for (std::size_t i = 0; i < 3; ++i) {
    const Triangle turned{t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
    const double way = angle_at(subject.at(turned[0]), subject.at(turned[1]), subject.at(turned[2]));
    const double angle = std::min(way, 360 - way);  // of a triangle that runs clockwise
    if (angle < smallest.angle) smallest = {turned, angle};
  }
  return smallest;
}

class Drawing {
 public:
  explicit Drawing(const Subject& subject)
      : subject_(subject), panel_(picture_place, extent_around(subject.points)) {}

  const Panel& panel() const { return panel_; }
  dvec2 at(int number) const { return panel_.at(subject_.at(number)); }
  std::vector<dvec2> at(const std::vector<int>& numbers) const {
    return mapped(numbers, [this](int number) { return at(number); });
  }

  /// The inside of all rings.
  void add_input(View& view) const {
    Area inside{{}, 1};
    for (const std::vector<int>& ring : subject_.rings) inside.rings.push_back(at(ring));
    view.add({"a inside", Role::past, std::move(inside)});
  }
  void add_ring(View& view, const std::string& id, Role role, const std::vector<int>& ring) const {
    view.add({id, role, Path{at(ring), true}});
  }
  /// role: of each corner; the past ones are hollow.
  template <class RoleOf>
  void add_names(View& view, const RoleOf& role_of) const {
    for (int i = 0; i < std::ssize(subject_.points); ++i) {
      const Role role = role_of(i);
      view.add_named(fmt::format("x corner {:02}", i), role, at(i), corner_name(i), role == Role::past);
    }
  }
  void add_triangle(View& view, const std::string& id, Role role, const Triangle& t, int shade = 0) const {
    view.add({id + " inside", role, Area{{{at(t[0]), at(t[1]), at(t[2])}}, shade}});
    add_sides(view, id, role, t);
  }
  /// One that was cut off: its tint, and thin lines.
  void add_cut_off(View& view, const std::string& id, const Triangle& t) const {
    const std::vector<dvec2> ring{at(t[0]), at(t[1]), at(t[2])};
    view.add({id + " inside", Role::result, Area{{ring}, 2}});
    view.add({id, Role::past, Path{ring, true}});
  }
  /// One of the result.
  void add_result(View& view, const std::string& id, const Triangle& t) const {
    add_triangle(view, id, Role::result, t, 2);
  }
  /// A text in a triangle; false where there is no room.
  bool add_text(View& view, const std::string& id, Role role, const Triangle& t,
                const std::string& text) const {
    const dvec2 a = at(t[0]), b = at(t[1]), c = at(t[2]);
    const double ab = length_between(a, b), bc = length_between(b, c), ca = length_between(c, a);
    const double round = ab + bc + ca,
                 doubled = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    // The circle inside needs a radius of as much
    const double least = 0.7 + 0.25 * static_cast<double>(text.size());
    if (!(doubled > least * round)) return false;
    view.add({id, role, Text{(bc * a + ca * b + ab * c) / round, text}});
    return true;
  }
  /// An arc at a triangle's smallest angle, and how large that is: in the triangle, if that is free and has
  /// room.
  void add_angle(View& view, const std::string& id, const Smallest& smallest, bool free) const {
    const auto& [before, corner, after] = smallest.triangle;
    const dvec2 tip = at(corner), one = at(before), other = at(after);
    const double far = std::min({4.0, 0.6 * length_between(tip, one), 0.6 * length_between(tip, other)});
    if (!(far > 0)) return;
    constexpr int pieces = 8;
    Path arc;
    const dvec2 from = (one - tip) / length_between(tip, one),
                to = (other - tip) / length_between(tip, other);
    for (int k = 0; k <= pieces; ++k) {
      const double part = static_cast<double>(k) / pieces;
      const dvec2 way = (1 - part) * from + part * to;
      arc.points.push_back(tip + far / std::max(length_between({}, way), 0.1) * way);
    }
    const dvec2 middle = arc.points[pieces / 2];
    view.add({id, Role::measure, std::move(arc)});
    const std::string text = degrees(smallest.angle);
    if (free && add_text(view, id + " size", Role::measure, smallest.triangle, text)) return;
    view.add({id + " size", Role::measure, Label{middle, text}});
  }

 private:
  /// Lines of their own, since those of slivers, joined, end in long points.
  void add_sides(View& view, const std::string& id, Role role, const Triangle& t) const {
    for (std::size_t i = 0; i < 3; ++i)
      view.add({fmt::format("{} side {}", id, i), role, Stroke{at(t[i]), at(t[(i + 1) % 3])}});
  }

  const Subject& subject_;
  Panel panel_;
};

}  // namespace gradus::ear_clipping
