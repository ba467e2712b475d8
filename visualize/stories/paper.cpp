#include "stories/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/contract.hpp"

namespace gradus {

Delta difference(const View& before, const View& after) {
  Delta delta;
  if (before.plane != after.plane) delta.plane = after.plane;
  for (const auto& [id, mark] : before.marks) {
    if (!after.marks.contains(id)) delta.removed.push_back(id);
  }
  for (const auto& [at, look] : before.cells) {
    if (!after.cells.contains(at)) delta.cells.push_back({{at.second, at.first}, std::nullopt});
  }
  for (const auto& [at, look] : after.cells) {
    const auto old = before.cells.find(at);
    if (old == before.cells.end() || old->second != look)
      delta.cells.push_back({{at.second, at.first}, look});
  }
  for (const auto& [id, mark] : after.marks) {
    const auto old = before.marks.find(id);
    if (old == before.marks.end() || old->second != mark) delta.set.push_back(mark);
  }
  return delta;
}

Grid paper_grid(int width, int height) {
  expects(width >= 1 && height >= 1, "a paper has at least one unit, not {} x {}", width, height);
  Grid grid;
  grid.cells = {{0, 0}, {width - 1, height - 1}};
  grid.whole = true;
  grid.axes = false;
  grid.x_name = grid.y_name = "";
  return grid;
}

Extent widened(Extent extent, double part) {
  const double margin = part * std::max(extent.size().x, extent.size().y);
  return {extent.lower - margin, extent.upper + margin};
}

std::optional<Stroke> shown_part(const Extent& frame, dvec2 a, dvec2 b) {
  double enters = 0, leaves = 1;
  for (const int axis : {0, 1}) {
    const double way = b[axis] - a[axis];
    if (way == 0) {
      if (a[axis] < frame.lower[axis] || a[axis] > frame.upper[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (frame.lower[axis] - a[axis]) / way, t1 = (frame.upper[axis] - a[axis]) / way;
    enters = std::max(enters, std::min(t0, t1));
    leaves = std::min(leaves, std::max(t0, t1));
  }
  if (enters >= leaves) return std::nullopt;
  return Stroke{a + enters * (b - a), a + leaves * (b - a)};
}

Panel::Panel(Extent place, Extent world, Fit fit, bool paper_y_up)
    : place_(place), world_(world), middle_(place.centre()), paper_y_up_(paper_y_up) {
  const dvec2 room = place.size(), size = world.size();
  const dvec2 fitting{size.x > 0 ? room.x / size.x : 0, size.y > 0 ? room.y / size.y : 0};
  const double least =
      size.x > 0 && size.y > 0 ? std::min(fitting.x, fitting.y) : std::max(fitting.x, fitting.y);
  const double same = least > 0 ? least : 1;
  scale_ = fit == Fit::same_scale ? dvec2{same, same}
                                  : dvec2{fitting.x > 0 ? fitting.x : same, fitting.y > 0 ? fitting.y : same};
}

Extent Panel::shown() const {
  const dvec2 half = place_.size() * 0.5 / scale_;
  return {world_.centre() - half, world_.centre() + half};
}

std::vector<dvec2> Panel::at(std::span<const dvec2> world) const {
  std::vector<dvec2> points;
  for (const dvec2 p : world) points.push_back(at(p));
  return points;
}

double tick_distance(double length, int most) {
  expects(length > 0 && most >= 1, "a scale of length {} with {} ticks", length, most);
  const double least = length / most;
  // The power of ten below it as it is written: libraries differ in the last bit of pow
  const std::string written = fmt::format("{:.17e}", least);
  const double power = std::strtod(("1" + written.substr(written.find('e'))).c_str(), nullptr);
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= least * (1 - 1e-9)) return step * power;
  }
  return 10 * power;
}

namespace {

/// The round numbers from `least` to `most`.
std::vector<double> ticks_of(double least, double most, int count) {
  std::vector<double> ticks;
  const double step = tick_distance(most - least, count);
  // Counted, not added up, so that no rounding gathers; -0 is no tick of its own
  const double first = std::ceil(least / step - 1e-9), last = std::floor(most / step + 1e-9);
  for (double i = first; i <= last; ++i) ticks.push_back(i == 0 ? 0 : i * step);
  return ticks;
}

constexpr double tick_length = 0.35, number_gap = 1.3, name_gap = 1.1;

}  // namespace

void add_axes(View& view, const Panel& panel, std::string_view name, const AxisNames& names, int most) {
  const Extent &place = panel.place(), shown = panel.shown();
  const auto mark = [&](std::string_view what, auto shape) {
    view.add({fmt::format("axis {} {}", name, what), Role::guide, std::move(shape)});
  };
  const dvec2 corner = place.lower;
  if (!names.x.empty()) {
    mark("x", Stroke{corner, {place.upper.x, corner.y}, true});
    mark("x name", Text{{place.upper.x, corner.y - number_gap}, std::string(names.x), Align::right});
    for (const double x : ticks_of(shown.lower.x, shown.upper.x, most)) {
      const double at = panel.at({x, 0}).x;
      mark(fmt::format("x tick {:.6g}", x), Stroke{{at, corner.y}, {at, corner.y - tick_length}});
      mark(fmt::format("x value {:.6g}", x), Text{{at, corner.y - number_gap}, figure_real(x)});
    }
  }
  if (names.y.empty()) return;
  mark("y", Stroke{corner, {corner.x, place.upper.y}, true});
  mark("y name", Text{{corner.x - 0.7, place.upper.y + 0.2}, std::string(names.y), Align::right});
  for (const double y : ticks_of(shown.lower.y, shown.upper.y, most)) {
    const double at = panel.at({0, y}).y;
    mark(fmt::format("y tick {:.6g}", y), Stroke{{corner.x, at}, {corner.x - tick_length, at}});
    mark(fmt::format("y value {:.6g}", y), Text{{corner.x - 0.7, at}, figure_real(y), Align::right});
  }
}

void NumberLine::add_to(View& view, std::string_view name, std::string_view symbol, int ticks) const {
  const auto mark = [&](std::string_view what, auto shape) {
    view.add({fmt::format("scale {} {}", name, what), Role::guide, std::move(shape)});
  };
  const dvec2 along = glm::normalize(to_ - from_), below{along.y, -along.x};
  mark("line", Stroke{from_, to_, true});
  mark("name", Text{to_ + along * name_gap, std::string(symbol), Align::left});
  for (const double value : ticks_of(least_, most_, ticks)) {
    mark(fmt::format("tick {:.6g}", value), Stroke{at(value), at(value) + tick_length * below});
    mark(fmt::format("value {:.6g}", value), Text{at(value) + number_gap * below, figure_real(value)});
  }
}

std::string figure_real(double value) {
  const double size = std::abs(value) < 1e-300 ? 0 : std::abs(value);
  std::string text;
  if (size != 0 && (size < 1e-3 || size >= 1e6)) {
    text = fmt::format("{:.3g}", size);
  } else {
    text = fmt::format("{:.{}f}", size, size >= 1000 ? 1 : size >= 100 ? 2 : 3);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return value < 0 && text != "0" ? "−" + text : text;
}

std::string figure_place(dvec2 p) { return fmt::format("({},\u00a0{})", figure_real(p.x), figure_real(p.y)); }

std::string figure_place(dvec3 p) {
  return fmt::format("({},\u00a0{},\u00a0{})", figure_real(p.x), figure_real(p.y), figure_real(p.z));
}

}  // namespace gradus
