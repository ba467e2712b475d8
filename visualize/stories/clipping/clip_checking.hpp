#pragma once
// What follows from a step of line clipping, right or wrong as it is.

#include <algorithm>
#include <cmath>

#include "stories/checking.hpp"

namespace gradus {

/// Liang and Barsky's table: t is q / p, and t moves the last entering value on, or the first leaving one.
inline Follows follows_in_table_of_t(const OwnSteps& steps, std::size_t i) {
  const Values &before = steps.theirs[i - 1], &now = steps.theirs[i];
  const auto enter = value_as<double>(now, "enter"), leave = value_as<double>(now, "leave");
  const auto p = value_as<double>(now, "p"), q = value_as<double>(now, "q"), t = value_as<double>(now, "t");
  const bool first = steps.ours[i - 1]->number.step == 0;
  const auto last_enter = first ? std::optional(0.0) : value_as<double>(before, "enter");
  const auto last_leave = first ? std::optional(1.0) : value_as<double>(before, "leave");
  if (!p || !enter || !leave || !last_enter || !last_leave || (!q && !t)) return Follows::untold;
  const auto same = [&](double a, double b) { return a == b || std::abs(a - b) <= steps.tolerance; };
  const double crossing = *p == 0 ? 0 : t ? *t : *q / *p;
  if (*p != 0 && q && t && !same(*q / *p, *t)) return Follows::no;
  const double enters = *p < 0 ? std::max(*last_enter, crossing) : *last_enter;
  const double leaves = *p > 0 ? std::min(*last_leave, crossing) : *last_leave;
  return same(*enter, enters) && same(*leave, leaves) ? Follows::yes : Follows::no;
}

/// Along a border, which belongs to the window, and in a single point.
inline bool is_tie_in_table_of_t(const TraceStep& step) {
  if (step.type != "Tested") return false;
  const auto p = value_as<double>(step.fields, "p"), q = value_as<double>(step.fields, "q");
  const auto enter = value_as<double>(step.fields, "enter"), leave = value_as<double>(step.fields, "leave");
  return (p == 0.0 && q == 0.0) || (enter && enter == leave);
}

/// Cohen and Sutherland's cuts in a window: each lies on its border and on the line through the ends as they
/// were before, and the codes are those of the ends as they are then.
inline Follows follows_by_cuts(const OwnSteps& steps, std::size_t i) {
  const auto line = steps.arguments.numbers("line"), window = steps.arguments.numbers("window");
  dvec2 ends[2]{{line[0], line[1]}, {line[2], line[3]}}, before[2]{};
  for (std::size_t k = 0; k <= i; ++k) {
    std::ranges::copy(ends, before);
    if (steps.ours[k]->type != "Cut") continue;
    const auto of_a = value_as<bool>(steps.theirs[k], "of_a");
    const auto x = value_as<double>(steps.theirs[k], "x"), y = value_as<double>(steps.theirs[k], "y");
    if (!of_a || !x || !y) return Follows::untold;
    ends[*of_a ? 0 : 1] = {*x, *y};
  }
  if (steps.ours[i]->type != "Cut") return Follows::untold;
  const auto border = value_as<std::string>(steps.theirs[i], "border");
  if (!border) return Follows::untold;
  const int axis = *border == "left" || *border == "right" ? 0 : 1;
  const double at = window[*border == "left" ? 0 : *border == "bottom" ? 1 : *border == "right" ? 2 : 3];
  const dvec2 cut = ends[*value_as<bool>(steps.theirs[i], "of_a") ? 0 : 1], way = before[1] - before[0];
  if (way[axis] == 0) return Follows::no;
  const dvec2 right = before[0] + (at - before[0][axis]) / way[axis] * way;
  const auto same = [&](double a, double b) { return std::abs(a - b) <= steps.tolerance; };
  if (!same(cut.x, right.x) || !same(cut.y, right.y)) return Follows::no;
  const auto code = [&](dvec2 p) {
    const auto beyond = [&](double a, double b) { return a < b && !same(a, b); };
    return std::int64_t{beyond(p.x, window[0])} | std::int64_t{beyond(window[2], p.x)} << 1 |
           std::int64_t{beyond(p.y, window[1])} << 2 | std::int64_t{beyond(window[3], p.y)} << 3;
  };
  const auto code_a = value_as<std::int64_t>(steps.theirs[i], "code_a");
  const auto code_b = value_as<std::int64_t>(steps.theirs[i], "code_b");
  const bool codes = (!code_a || *code_a == code(ends[0])) && (!code_b || *code_b == code(ends[1]));
  return codes ? Follows::yes : Follows::no;
}

}  // namespace gradus
