#include "stories/paper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/contract.hpp"

namespace gradus {

namespace {
/// take(key, value, that of the other map or null) for all entries. Both maps are walked once: a drawing may
/// have thousands of cells.
template <class Map, class Take>
void each_beside(const Map& map, const Map& other, Take take) {
  auto beside = other.begin();
  for (const auto& [key, value] : map) {
    while (beside != other.end() && beside->first < key) ++beside;
    const bool in_both = beside != other.end() && beside->first == key;
    take(key, value, in_both ? &beside->second : nullptr);
  }
}
}  // namespace

Delta difference(const View& before, const View& after) {
  Delta delta;
  if (before.plane != after.plane) delta.plane = after.plane;
  each_beside(before.marks, after.marks, [&](const std::string& id, const Mark&, const Mark* now) {
    if (!now) delta.removed.push_back(id);
  });
  using At = std::pair<int, int>;
  std::vector<std::pair<At, const CellLook*>> cells;  // moved more cheaply than their looks
  each_beside(before.cells, after.cells, [&](const At& at, const CellLook&, const CellLook* now) {
    if (!now) cells.emplace_back(at, nullptr);
  });
  each_beside(after.cells, before.cells, [&](const At& at, const CellLook& look, const CellLook* old) {
    if (!old || *old != look) cells.emplace_back(at, &look);
  });
  delta.cells.reserve(cells.size());
  for (const auto& [at, look] : cells)
    delta.cells.push_back({{at.second, at.first}, look ? std::optional(*look) : std::nullopt});
  each_beside(after.marks, before.marks, [&](const std::string&, const Mark& mark, const Mark* old) {
    if (!old || *old != mark) delta.set.push_back(mark);
  });
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

std::pair<double, double> span_in(const Extent& frame, dvec2 a, dvec2 way, double first, double last) {
  for (const int axis : {0, 1}) {
    if (way[axis] == 0) {
      if (a[axis] < frame.lower[axis] || frame.upper[axis] < a[axis]) return {1, 0};
      continue;
    }
    const double low = (frame.lower[axis] - a[axis]) / way[axis];
    const double high = (frame.upper[axis] - a[axis]) / way[axis];
    first = std::max(first, std::min(low, high));
    last = std::min(last, std::max(low, high));
  }
  return {first, last};
}

std::optional<Stroke> shown_part(const Extent& frame, dvec2 a, dvec2 b) {
  const auto [enters, leaves] = span_in(frame, a, b - a, 0, 1);
  if (enters >= leaves) return std::nullopt;
  return Stroke{a + enters * (b - a), a + leaves * (b - a)};
}

std::optional<dvec2> grip(const Extent& frame, const std::vector<dvec2>& ring, dvec2 corner) {
  if (frame.holds(corner)) return corner;
  const auto nearest = std::ranges::min_element(ring, {}, [&](dvec2 p) { return length_between(p, corner); });
  const auto number = static_cast<std::size_t>(nearest - ring.begin()), count = ring.size();
  for (const std::size_t side : {count - 1, std::size_t{1}}) {
    const std::optional<Stroke> part = shown_part(frame, corner, ring[(number + side) % count]);
    if (part && part->a != part->b) return part->a;
  }
  return std::nullopt;
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

Panel tight_panel(const Extent& place, const Extent& world) {
  constexpr dvec2 least{12, 9};
  const Panel loose(place, world);
  const dvec2 size = glm::clamp(world.size() * loose.scale(), glm::min(least, place.size()), place.size());
  const double left = place.centre().x - size.x / 2;
  return Panel({{left, place.lower.y}, {left + size.x, place.lower.y + size.y}}, world);
}

std::vector<dvec2> Panel::at(std::span<const dvec2> world) const {
  std::vector<dvec2> points;
  for (const dvec2 p : world) points.push_back(at(p));
  return points;
}

double tick_distance(double length, int most) {
  expects(length > 0 && std::isfinite(length) && most >= 1, "a scale of length {} with {} ticks", length,
          most);
  const double least = length / most;
  // The power of ten below it as it is written: libraries differ in the last bit of pow
  const std::string written = fmt::format("{:.17e}", least);
  const double power = std::strtod(("1" + written.substr(written.find('e'))).c_str(), nullptr);
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= least * (1 - 1e-9)) return step * power;
  }
  return 10 * power;
}

bool can_be_told_apart(double least, double most) {
  // A thousand doubles from end to end: then each place on the paper has one of its own
  constexpr double steps = 0x1p-42, tiny = 1e-290, huge = 1e290;
  const double size = most - least;
  return tiny <= size && size <= huge && size >= steps * std::max(std::abs(least), std::abs(most));
}

void require_scale(const Panel& panel, const Arguments& arguments,
                   std::initializer_list<std::string_view> parameters) {
  const Extent shown = panel.shown();
  for (const int axis : {0, 1}) {
    const double least = shown.lower[axis], most = shown.upper[axis];
    if (can_be_told_apart(least, most)) continue;
    refuse(arguments, parameters,
           fmt::format("expected numbers that a scale can tell apart, found a scale from {} to {}", least,
                       most));
  }
}

namespace {

struct Tick {
  double value;
  std::string text;
};

/// The round numbers along a scale, and what they are counted from: 0 unless they would be too long.
struct Ticks {
  std::vector<Tick> all{};
  double from = 0;

  /// "x", or where the numbers are counted from elsewhere "x − 1000000000".
  std::string name(const std::string& symbol) const {
    if (from == 0) return symbol;
    return fmt::format("{} {} {:.15g}", symbol, from < 0 ? "+" : "−", std::abs(from));
  }
};

/// Whether the texts of ticks tell them apart and where they lie: to a tenth of their distance.
bool are_clear(const Ticks& ticks, double step) {
  return std::ranges::all_of(ticks.all, [&](const Tick& tick) {
    std::string text = tick.text;
    const double sign = text.starts_with("−") ? -1 : 1;
    if (sign < 0) text.erase(0, std::string_view("−").size());
    return std::abs(sign * std::strtod(text.c_str(), nullptr) - (tick.value - ticks.from)) <= 0.1 * step;
  });
}

std::string with_six_digits(double value) {
  return (value < 0 ? "−" : "") + fmt::format("{:.6g}", std::abs(value));
}

/// The round numbers from `least` to `most`, about so many; none where doubles don't tell them apart.
Ticks ticks_of(double least, double most, int count) {
  if (!can_be_told_apart(least, most)) return {};
  const double step = tick_distance(most - least, count);
  // Counted, not added up, so that no rounding gathers; no number that is counted is beyond 2^53
  const auto first = static_cast<std::int64_t>(std::ceil(least / step - 1e-9));
  const auto last = static_cast<std::int64_t>(std::floor(most / step + 1e-9));
  const auto counted_from = [&](std::int64_t base, std::string (*text_of)(double)) {
    Ticks ticks{{}, static_cast<double>(base) * step};
    for (std::int64_t i = first; i <= last; ++i) {
      const double value = static_cast<double>(i) * step;
      ticks.all.push_back({value, text_of(static_cast<double>(i - base) * step)});
    }
    return ticks;
  };
  for (const auto text_of : {figure_real, with_six_digits}) {
    if (const Ticks ticks = counted_from(0, text_of); are_clear(ticks, step)) return ticks;
  }
  return counted_from(first - first % 10, with_six_digits);
}

/// Ids of ticks: their values, with as many digits as tell them apart.
std::string id_of(std::string_view axis, std::string_view what, const Ticks& ticks, const Tick& tick) {
  return ticks.from == 0 ? fmt::format("{}{} {:.6g}", axis, what, tick.value)
                         : fmt::format("{}{} {:.17g}", axis, what, tick.value);
}

constexpr double tick_length = 0.35, number_gap = 0.9, name_gap = 1.1;

}  // namespace

void add_axes(View& view, const Panel& panel, std::string_view name, const AxisNames& names, int most) {
  const Extent &place = panel.place(), shown = panel.shown();
  const auto mark = [&](std::string_view what, auto shape) {
    view.add({fmt::format("axis {} {}", name, what), Role::guide, std::move(shape)});
  };
  const dvec2 corner = place.lower;
  if (!names.x.empty()) {
    const Ticks ticks = ticks_of(shown.lower.x, shown.upper.x, most);
    mark("x", Stroke{corner, {place.upper.x, corner.y}, true});
    mark("x name", Text{{place.upper.x, corner.y - number_gap}, ticks.name(names.x), Align::right});
    for (const Tick& tick : ticks.all) {
      const double at = panel.at({tick.value, 0}).x;
      mark(id_of("x ", "tick", ticks, tick), Stroke{{at, corner.y}, {at, corner.y - tick_length}});
      mark(id_of("x ", "value", ticks, tick), Text{{at, corner.y - number_gap}, tick.text});
    }
  }
  if (names.y.empty()) return;
  const Ticks ticks = ticks_of(shown.lower.y, shown.upper.y, most);
  mark("y", Stroke{corner, {corner.x, place.upper.y}, true});
  // Beside the arrow, or above the last number where that stands there
  double last = place.lower.y;
  for (const Tick& tick : ticks.all) last = panel.at({0, tick.value}).y;
  const dvec2 top{corner.x - 0.7, std::max(place.upper.y - 0.35, last + 1.25)};
  mark("y name", ticks.from == 0 ? Text{top, names.y, Align::right}
                                 : Text{top - dvec2{1.6, 0}, ticks.name(names.y), Align::left});
  for (const Tick& tick : ticks.all) {
    const double at = panel.at({0, tick.value}).y;
    mark(id_of("y ", "tick", ticks, tick), Stroke{{corner.x, at}, {corner.x - tick_length, at}});
    mark(id_of("y ", "value", ticks, tick), Text{{corner.x - 0.7, at}, tick.text, Align::right});
  }
}

void NumberLine::add_to(View& view, std::string_view name, std::string_view symbol, int count) const {
  const auto mark = [&](std::string_view what, auto shape) {
    view.add({fmt::format("scale {} {}", name, what), Role::guide, std::move(shape)});
  };
  const dvec2 along = glm::normalize(to_ - from_), below{along.y, -along.x};
  const Ticks ticks = ticks_of(least_, most_, count);
  mark("line", Stroke{from_, to_, true});
  mark("name", Text{to_ + along * name_gap, ticks.name(std::string(symbol)), Align::left});
  for (const Tick& tick : ticks.all) {
    const dvec2 at = this->at(tick.value);
    mark(id_of("", "tick", ticks, tick), Stroke{at, at + tick_length * below});
    mark(id_of("", "value", ticks, tick), Text{at + number_gap * below, tick.text});
  }
}

std::string figure_real(double value) {
  const double size = std::abs(value);
  std::string text;
  if (size != 0 && (size < 1e-3 || size >= 1e6)) {
    text = fmt::format("{:.3g}", size);
  } else {
    text = fmt::format("{:.{}f}", size, size >= 1000 ? 1 : size >= 100 ? 2 : 3);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
  }
  return with_note(value < 0 && text != "0" ? "−" + text : text, value);
}

}  // namespace gradus
