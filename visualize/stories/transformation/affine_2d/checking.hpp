#pragma once
// What follows from a step of others' matrices, right or wrong as it is.

#include <algorithm>
#include <array>
#include <cmath>

#include "stories/checking.hpp"

namespace gradus::affine_2d {

inline const std::vector<std::string> matrix_names{"xx", "xy", "x0", "yx", "yy", "y0"};

inline std::optional<std::array<double, 6>> matrix_in(const Values& values) {
  std::array<double, 6> matrix{};
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const auto element = value_as<double>(values, matrix_names[i]);
    if (!element) return std::nullopt;
    matrix[i] = *element;
  }
  return matrix;
}

/// Their matrix is the factor that ours took in this step, times their matrix before. Our own two matrices
/// say what that factor was, unless the one before flattens the plane.
inline Follows follows(const OwnSteps& steps, std::size_t i) {
  const bool multiplied =
      steps.ours[i]->type == "Multiplied" && steps.ours[i]->number.step == steps.ours[i - 1]->number.step + 1;
  const auto ours = matrix_in(steps.ours[i]->fields), ours_before = matrix_in(steps.ours[i - 1]->fields);
  const auto theirs = matrix_in(steps.theirs[i]), before = matrix_in(steps.theirs[i - 1]);
  if (!multiplied || !ours || !ours_before || !theirs || !before) return Follows::untold;
  const auto& [a, b, c, d, e, f] = *ours_before;
  const double determinant = a * e - b * d;
  if (determinant == 0) return Follows::untold;
  const auto times = [](const std::array<double, 6>& m, const std::array<double, 6>& n) {
    return std::array{m[0] * n[0] + m[1] * n[3], m[0] * n[1] + m[1] * n[4], m[0] * n[2] + m[1] * n[5] + m[2],
                      m[3] * n[0] + m[4] * n[3], m[3] * n[1] + m[4] * n[4], m[3] * n[2] + m[4] * n[5] + m[5]};
  };
  const std::array<double, 6> back{e / determinant,  -b / determinant, (b * f - c * e) / determinant,
                                   -d / determinant, a / determinant,  (c * d - a * f) / determinant};
  const auto right = times(times(*ours, back), *before);
  const auto same = [&](double x, double y) { return std::abs(x - y) <= 4 * steps.tolerance; };
  return std::ranges::equal(*theirs, right, same) ? Follows::yes : Follows::no;
}

inline const Checking& checking() {
  static const Checking known{.asked = {{.name = "corners", .same = SameList::order, .fields = {"x", "y"}}},
                              .follows = follows,
                              .matrix = matrix_names,
                              .matrix_columns = 3};
  return known;
}

}  // namespace gradus::affine_2d
