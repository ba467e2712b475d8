#pragma once
// What all stories of the sphere draw: the sphere with its lines of longitude and latitude, and the rectangle
// of its parameters.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "modeling/parametric_surface/parametric_surface.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::parametric_surface {

constexpr int paper_width = 36, paper_height = 27;
/// The sphere on the left, its parameters on the right.
inline constexpr Extent sphere_place{{0.2, 2}, {21.8, 25}}, chart_place{{25, 9}, {34.4, 17}};

/// What a run is about.
struct Subject {
  double radius, s, t;  ///< angles in degrees
  int n, m;

  SurfacePoint<double> at() const { return point(radius, angle(s), angle(t)); }
  /// s as the rectangle has it: at least 0, below 360.
  double s_shown() const {
    const double s_there = 360 * part_of_turn(s);
    return s_there < 360 ? s_there : 0;
  }
};

inline Subject subject_of(const Arguments& arguments) {
  const double radius = *arguments.number("radius");
  if (!(radius > 0)) refuse("radius", "expected a radius above 0, found {}", radius);
  const std::vector<double> angles = arguments.numbers("angles");
  if (std::abs(angles[1]) > 90)
    refuse(arguments, {"angles"},
           fmt::format("expected a latitude t from -90 to 90 degrees, found {}", angles[1]));
  return {radius, angles[0], angles[1], static_cast<int>(arguments.integer("n")),
          static_cast<int>(arguments.integer("m"))};
}

/// "30°".
inline std::string degrees(double angle) { return figure_real(angle) + "°"; }
/// What explains the drawing beside it: among several panels it gives way to that.
inline void add_aside(View& view, const View& part) {
  for (auto [id, mark] : part.marks) {
    mark.id = "aside " + id;
    view.add(std::move(mark));
  }
}  /// A text off the end of something that leads there from another place.
inline void add_beyond(View& view, const std::string& id, Role role, dvec2 from, dvec2 end,
                       std::string text) {
  const double length = length_between(from, end);
  const dvec2 way = length > 0 ? (end - from) / length : dvec2{0, 1};
  const Align align = way.x > 0.5 ? Align::left : way.x < -0.5 ? Align::right : Align::centre;
  view.add({id, role, Text{end + (align == Align::centre ? 1.0 : 0.5) * way, std::move(text), align}});
}

/// Which way a reader's drawing has x, y, z: its own y points up where space has z.
inline dvec3 upright(dvec3 p) { return {p.y, p.z, p.x}; }

/// A reader who has the point before him, a little to the right, and looks from above, or from below where
/// that is south: so high that the normal and both tangents have directions of their own on the paper. For s
/// near 60 degrees he stays where he is.
inline faces_subject::Reader reader_of(const Subject& subject) {
  constexpr double usual = 60, stays = 10, aside = 32, high = 50, low = 20, steep = 43;
  const double s = std::abs(subject.s - usual) <= stays ? usual : subject.s;
  const double latitude = std::abs(subject.t) < steep ? high : low;
  const Turn<double> up = angle(subject.t < 0 ? -latitude : latitude);
  return faces_subject::Reader(upright(point(1.0, angle(s - aside), up).point));
}

/// The sphere as a reader far away sees it: all of it, as if of glass.
class Globe {
 public:
  explicit Globe(const Subject& subject)
      : radius_(subject.radius),
        reader_(reader_of(subject)),
        panel_(sphere_place, {dvec2(-1.28 * radius_), dvec2(1.28 * radius_)}) {}

  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(upright(p))); }
  bool seen(dvec3 p) const { return glm::dot(reader_.towards, upright(p)) >= 0; }
  const Panel& panel() const { return panel_; }
  const faces_subject::Reader& reader() const { return reader_; }
  double radius() const { return radius_; }
  dvec3 on(double s, double t) const { return point(radius_, angle(s), angle(t)).point; }

  /// The disc, its lines 30 degrees apart on the near side, all of the equator, the axes.
  void add_to(View& view) const {
    Ring2 disc;
    for (int k = 0; k < 60; ++k) {
      const Turn<double> a = longitude<double>(k, 60);
      disc.push_back(panel_.at({radius_ * a.cos, radius_ * a.sin}));
    }
    view.add({"a disc", Role::past, Area{{disc}, 1}});
    view.add({"b outline", Role::past, Path{disc, true}});
    for (int k = 1; k < 12; ++k)
      add_curve(
          view, fmt::format("b m {:02}", k), Role::guide, -90, 90, [&](double t) { return on(30 * k, t); },
          false);
    for (int k = -2; k <= 2; ++k)
      add_curve(
          view, fmt::format("b p {}", k), Role::guide, 0, 360, [&](double s) { return on(s, 30 * k); },
          k == 0);
    add_axes(view);
  }
  /// Where parameters that differ have one point: the meridian at s = 0 and 360, and the poles.
  void add_seam(View& view) const {
    add_curve(view, "c seam", Role::boundary, -90, 90, [&](double t) { return on(0, t); });
    for (const double t : {-90.0, 90.0})
      view.add({t < 0 ? "c south" : "c north", Role::accepted, Dot{at(on(0, t)), !seen(on(0, t))}});
  }
  /// A line on the sphere; its part on the far side is dashed, or left away.
  template <class Line>
  void add_curve(View& view, const std::string& id, Role role, double from, double to, const Line& line,
                 bool behind = true) const {
    if (from == to) return;
    constexpr double most = 7.5;
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / most)));
    std::vector<dvec2> part{at(line(from))};
    bool in_front = seen(line(from + (to - from) / (2 * pieces)));
    int number = 0;
    const auto end = [&] {
      if (in_front || behind)
        view.add({fmt::format("{} {}", id, number++), role, Path{part, false, !in_front}});
    };
    for (int k = 1; k <= pieces; ++k) {
      const dvec3 p = line(from + (to - from) * k / pieces);
      part.push_back(at(p));
      const bool next = k < pieces ? seen(line(from + (to - from) * (k + 0.5) / pieces)) : in_front;
      if (next == in_front) continue;
      end();
      part = {at(p)};
      in_front = next;
    }
    end();
  }

 private:
  void add_axes(View& view) const {
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 tip{0};
      tip[axis] = 1.25 * radius_;
      const std::string id = fmt::format("aside axis {}", axis);
      view.add({id, Role::past, Stroke{at({0, 0, 0}), at(tip), true, false, true}});
      view.add({id + " name", Role::past, Label{at(tip), std::string(1, "xyz"[axis])}});
    }
  }

  double radius_;
  faces_subject::Reader reader_;
  Panel panel_;
};

/// The rectangle of the parameters, s to the right, t upwards.
class Chart {
 public:
  dvec2 at(double s, double t) const { return panel_.at({s, t}); }
  /// In columns and rows of equal width.
  void add_to(View& view, const Words& words, int columns, int rows, bool joined) const {
    for (int k = 1; k < columns; ++k) add_line(view, fmt::format("k s {:02}", k), 360.0 * k / columns, true);
    for (int k = 1; k < rows; ++k) add_line(view, fmt::format("k t {:02}", k), 180.0 * k / rows - 90, false);
    const Role seam = joined ? Role::boundary : Role::rejected, pole = joined ? Role::past : Role::rejected;
    for (const double s : {0.0, 360.0})
      view.add({s > 0 ? "l right" : "l left", seam, Path{{at(s, -90), at(s, 90)}}});
    for (const double t : {-90.0, 90.0})
      view.add({t < 0 ? "l south" : "l north", pole, Stroke{at(0, t), at(360, t)}});
    for (const double s : {0.0, 90.0, 180.0, 270.0, 360.0})
      view.add({fmt::format("n s {}", s), Role::guide,
                Text{at(s, -90) - dvec2{0, 1.1}, degrees(s), Align::centre, true}});
    for (const double t : {-90.0, 0.0, 90.0})
      view.add({fmt::format("n t {}", t), Role::guide,
                Text{at(0, t) - dvec2{0.5, 0}, degrees(t), Align::right, true}});
    view.add({"n s", Role::guide, Text{at(180, -90) - dvec2{0, 2.6}, words.symbol("s")}});
    view.add({"n t", Role::guide, Text{at(0, 45) - dvec2{1.2, 0}, words.symbol("t"), Align::right}});
  }

 private:
  void add_line(View& view, const std::string& id, double value, bool upright_line) const {
    const dvec2 a = upright_line ? at(value, -90) : at(0, value),
                b = upright_line ? at(value, 90) : at(360, value);
    view.add({id, Role::guide, Stroke{a, b, false, false, true}});
  }

  Panel panel_{chart_place, {{0, -90}, {360, 90}}, Panel::Fit::stretched};
};

}  // namespace gradus::parametric_surface
