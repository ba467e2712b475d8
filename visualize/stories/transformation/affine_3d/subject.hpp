#pragma once
// What a run of transformations in space is about.

#include "stories/matrix_drawing.hpp"
#include "stories/telling.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::affine_3d {

using Mat = Matrix<double>;

inline const std::vector<std::string> coordinates{"x", "y", "z"};

inline dvec3 point_of(const Tuple& tuple) { return {tuple[0].value, tuple[1].value, tuple[2].value}; }

inline Mat matrix_of(const FactorText& text) {
  const dvec3 pivot = text.pivot.empty() ? dvec3{0} : point_of(text.pivot);
  const dvec3 amount = text.amount.size() == 1 ? dvec3{text.amount[0].value} : point_of(text.amount);
  if (text.kind == FactorText::Kind::translate) return translation(amount);
  if (text.kind == FactorText::Kind::scale) return about(pivot, scaling(amount));
  const Turn<double> turn = turn_degrees(text.amount[0].value);
  return about(pivot, rodrigues(direction_of(point_of(text.axis)), turn));
}

struct Subject {
  std::vector<FactorText> texts;
  std::vector<Mat> factors;
  dvec3 axis, through, point, size;
  double angle;  ///< degrees
  bool compare;
};

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{.texts = arguments.factors("factors"),
                  .factors = {},
                  .axis = *arguments.place("axis"),
                  .through = *arguments.place("through"),
                  .point = *arguments.place("point"),
                  .size = *arguments.place("box"),
                  .angle = *arguments.number("angle"),
                  .compare = arguments.text("orders") == "both"};
  for (const FactorText& text : subject.texts) subject.factors.push_back(matrix_of(text));
  if (subject.axis == dvec3{0}) refuse("axis", "expected an axis, not the zero vector 0,0,0");
  for (const int i : {0, 1, 2}) {
    if (!(subject.size[i] > 0)) refuse("box", "expected three numbers above 0: width, height and depth");
  }
  return subject;
}

/// What rounding has left of zeros is nothing to show.
inline dvec3 clean(dvec3 p) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(p[i]) < 1e-12 * length_between(dvec3(0), p)) p[i] = 0;
  }
  return p;
}

inline std::vector<Said> row_of(Said name, dvec3 place) {
  const dvec3 p = clean(place);
  return {std::move(name), p.x, p.y, p.z};
}

/// What is given, before the first step of a turn.
struct Input {};

}  // namespace gradus::affine_3d
