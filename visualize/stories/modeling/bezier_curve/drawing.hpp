#pragma once
// What all stories of Bézier curves draw: the control points with their polygon, the whole curve, t on a
// scale.

#include "core/arithmetic/exact.hpp"
#include "modeling/bezier_curve/bezier_curve.hpp"
#include "stories/telling.hpp"

namespace gradus::bezier_curve {

using Control = Points<2, double>;

constexpr int paper_width = 36, paper_height = 27;

/// What a run is about.
struct Subject {
  Control control;
  double t, tolerance;
  int times;

  Index degree() const { return control.size() - 1; }
};

/// "P2", "Q1", "R0": the point i of a round.
inline std::string name_of(Index round, Index i) {
  return fmt::format("{}{}", static_cast<char>('P' + static_cast<char>(round)), i);
}

inline dvec2 point_at(const Control& control, double t) { return de_casteljau<2, double>(control, t); }

/// A coordinate that is nothing but roundings is 0.
inline dvec2 without_dust(dvec2 p, const Control& control) {
  const double least = 0x1p-49 * largest_of<2, double>(control);
  return {std::abs(p.x) < least ? 0 : p.x, std::abs(p.y) < least ? 0 : p.y};
}

/// The points of a curve from t = a to b.
inline Control points_of(const Control& control, double a = 0, double b = 1) {
  constexpr int pieces = 64;
  Control points;
  for (int k = 0; k <= pieces; ++k)
    points.push_back(point_at(control, std::clamp(a + (b - a) * k / pieces, a, b)));
  return points;
}

/// The corners of the convex hull, counter-clockwise.
inline Control hull_of(Control points) {
  std::ranges::sort(points, {}, [](dvec2 p) { return std::pair(p.x, p.y); });
  Control hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const dvec2 p : points) {
      while (hull.size() >= begin + 2 && orient2d(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

/// The shortest way to a segment.
inline double distance_to(dvec2 p, dvec2 a, dvec2 b) {
  const double square = glm::dot(b - a, b - a);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0;
  return length_between(p, a + share * (b - a));
}

/// Where a curve is farthest from its chord, and how far.
struct Farthest {
  dvec2 point;
  double distance;
};
inline Farthest farthest_of(const Control& control) {
  constexpr int tried = 1024;
  Farthest most{control.front(), 0};
  for (int k = 0; k <= tried; ++k) {
    const dvec2 p = point_at(control, static_cast<double>(k) / tried);
    const double distance = distance_to(p, control.front(), control.back());
    if (distance > most.distance) most = {p, distance};
  }
  return most;
}

inline double length_of_polygon(const Control& control) {
  double length = 0;
  for (std::size_t i = 1; i < control.size(); ++i) length += length_between(control[i - 1], control[i]);
  return length;
}

/// The curve with its polygon in one panel.
class CurveDrawing {
 public:
  CurveDrawing(const Subject& subject, const Extent& place) : subject_(subject), panel_(place, {}) {
    Extent extent;
    for (const dvec2 p : subject.control) extent.add(p);
    panel_ = Panel(place, extent);
  }

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec2 p) const { return panel_.at(p); }
  Path path(const Control& points, bool dashed = false) const { return {panel_.at(points), false, dashed}; }

  void add_polygon(View& view) const {
    view.add({"a polygon", Role::input, path(subject_.control)});
    for (Index i = 0; i <= subject_.degree(); ++i)
      view.add_named(fmt::format("a point {:02}", i), Role::input, at(subject_.control[i]), name_of(0, i),
                     true);
  }
  void add_curve(View& view, const std::string& id, Role role, double from = 0, double to = 1) const {
    view.add({id, role, path(points_of(subject_.control, from, to))});
  }
  /// The ground of some points: the inside of their hull.
  void add_hull(View& view, const std::string& id, Role role, const Control& points) const {
    view.add({id, role, Area{{panel_.at(hull_of(points))}, 2}});
  }

 private:
  const Subject& subject_;
  Panel panel_;
};

/// Where t is taken hold of: a scale from 0 to 1 below the drawing.
class Slider {
 public:
  Slider(double t, Role role) : t_(t), role_(role) {}

  void add_to(View& view, const std::string& symbol) const {
    line_.add_to(view, "x t", symbol, 5);
    if (t_ > 0) view.add({"y t", role_, Stroke{line_.at(0), line_.at(t_), true}});
    view.add({"z t", role_, Dot{line_.at(t_)}});
  }
  void let_drag(Narrator& narrator) const {
    narrator.handle("t", 0, line_.at(t_), line_.at(1) - line_.at(0));
  }

 private:
  double t_;
  Role role_;
  NumberLine line_{{7, 2.6}, {29, 2.6}, 0, 1};
};

}  // namespace gradus::bezier_curve
