#pragma once
// What a run is about: one patch and a place on it, or two that are to be joined; from where it is seen.

#include "modeling/bezier_patch/bezier_patch.hpp"
#include "stories/visibility/faces_subject.hpp"

namespace gradus::bezier_patch {

using Net = Patch<double>;

inline constexpr int paper_width = 36, paper_height = 27;

/// With two digits behind the point, as drawings have room for.
inline std::string short_real(double value) {
  return figure_real(std::abs(value) < 0.005 ? 0 : std::round(value * 100) / 100);
}
inline std::string short_place(dvec3 p) { return figure_place(p, short_real); }

/// A net that was given, in rows of --columns.
inline Net net_of(const Arguments& arguments, std::string_view parameter) {
  const auto columns = static_cast<Index>(arguments.integer("columns"));
  Net net{columns, arguments.places(parameter)};
  if (net.points.size() % columns != 0 || net.rows() < 2)
    refuse(arguments, {parameter, "columns"},
           fmt::format("expected at least two rows of {} control points, found {} points", columns,
                       net.points.size()));
  return net;
}

/// The largest side of what some points take.
inline double size_of(const Points<double>& points) {
  Bounds bounds;
  for (const dvec3 p : points) bounds.add(p);
  return 2 * bounds.radius();
}

/// The normals of on_grid's points, so many faces along each side.
inline Points<double> normals_on_grid(const Net& net, int pieces) {
  Points<double> normals;
  for (int j = 0; j <= pieces; ++j) {
    for (int i = 0; i <= pieces; ++i)
      normals.push_back(unit_vector(
          de_casteljau(net, static_cast<double>(i) / pieces, static_cast<double>(j) / pieces).normal));
  }
  return normals;
}

/// The points of a curve with these control points.
inline Points<double> curve_of(const Points<double>& control) {
  constexpr int pieces = 24;
  Points<double> points;
  for (int k = 0; k <= pieces; ++k) points.push_back(reduced(control, static_cast<double>(k) / pieces).point);
  return points;
}

}  // namespace gradus::bezier_patch
