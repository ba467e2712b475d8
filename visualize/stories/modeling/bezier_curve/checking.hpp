#pragma once
// What is right of others' rounds: each point between two of the round before, as those are.

#include <map>

#include "stories/checking.hpp"

namespace gradus::bezier_curve {

/// The point that a step of theirs has found.
inline std::optional<dvec2> point_in(const Values& values) {
  const auto x = value_as<double>(values, "x"), y = value_as<double>(values, "y");
  return x && y ? std::optional(dvec2{*x, *y}) : std::nullopt;
}

/// At t between their own two points of the round before, right or wrong as those are.
inline Follows follows(const OwnSteps& steps, std::size_t i) {
  using Place = std::pair<std::int64_t, std::int64_t>;
  std::map<Place, dvec2> points;
  const std::vector<dvec2> control = steps.arguments.points("control");
  for (std::size_t k = 0; k < control.size(); ++k) points[{0, static_cast<std::int64_t>(k)}] = control[k];
  for (std::size_t k = 0; k <= i; ++k) {
    if (steps.ours[k]->type != "Mixed") continue;
    const auto round = value_as<std::int64_t>(steps.ours[k]->fields, "round");
    const auto number = value_as<std::int64_t>(steps.ours[k]->fields, "i");
    const auto point = point_in(steps.theirs[k]);
    if (!round || !number || !point) continue;
    if (k < i) {
      points[{*round, *number}] = *point;
      continue;
    }
    const auto a = points.find({*round - 1, *number}), c = points.find({*round - 1, *number + 1});
    if (a == points.end() || c == points.end()) return Follows::untold;
    const double t = *steps.arguments.number("t");
    const dvec2 off = glm::abs((1 - t) * a->second + t * c->second - *point);
    return std::max(off.x, off.y) <= steps.tolerance ? Follows::yes : Follows::no;
  }
  return Follows::untold;
}

/// The points of the rounds, in their order.
inline const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "points", .same = SameList::order, .type = "Mixed", .fields = {"x", "y"}}},
      .follows = follows};
  return known;
}

}  // namespace gradus::bezier_curve
