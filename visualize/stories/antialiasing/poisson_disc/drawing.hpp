#pragma once
// The area of the samples on paper: its grid, circles about places, copies round a tile, the radius below.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "core/arithmetic/elementary.hpp"
#include "stories/antialiasing/ring_cut.hpp"
#include "stories/telling.hpp"

namespace gradus::poisson_disc {

inline constexpr int width = 37, height = 26;

/// The area on the paper above a line of text; round a tile some room for its copies.
class Sheet {
 public:
  Sheet(const Area& area, double margin)
      : area_(area),
        panel_({{-0.2, 1.5}, {width - 0.8, height - 0.8}}, {-dvec2(margin), area.size + margin}),
        shown_(area.wraps ? panel_.place() : Extent{panel_.at(dvec2(0)), panel_.at(area.size)}) {}

  dvec2 at(dvec2 place) const { return panel_.at(place); }
  const Panel& panel() const { return panel_; }

  std::vector<dvec2> box(dvec2 lower, dvec2 upper) const {
    return {at(lower), at({upper.x, lower.y}), at(upper), at({lower.x, upper.y})};
  }
  std::vector<dvec2> circle(dvec2 middle, double radius) const {
    static const std::vector<dvec2> unit = unit_circle();
    std::vector<dvec2> ring;
    for (const dvec2 corner : unit) ring.push_back(at(middle + radius * corner));
    return ring;
  }
  /// As much of a circle as lies in the area, or of one in a tile as the paper shows.
  std::vector<dvec2> shown_circle(dvec2 middle, double radius) const {
    return ring_within(circle(middle, radius), shown_.lower, shown_.upper);
  }
  /// The way from one place to another; an arrow at the area's border where it leads out of what is shown.
  Stroke shown_way(dvec2 from, dvec2 to) const {
    const dvec2 a = at(from), way = at(to) - a;
    double share = 1;
    for (const int axis : {0, 1}) {
      if (way[axis] > 0) share = std::min(share, (shown_.upper[axis] - a[axis]) / way[axis]);
      if (way[axis] < 0) share = std::min(share, (shown_.lower[axis] - a[axis]) / way[axis]);
    }
    return {a, a + share * way, share < 1};
  }
  /// How long the radius is, below the area.
  void add_radius(View& view, const Words& words, double radius) const {
    const double right = at(area_.size).x, length = radius * panel_.scale().x, y = shown_.lower.y - 1.1;
    const double left = right - length;
    const std::string name = words.say("radius", {{"radius", radius}});
    if (length > 0.6 * width) {
      view.add({"h radius", Role::guide, Text{{0.5 * width, y}, name}});
      return;
    }
    view.add({"h radius", Role::guide, Text{{left - 0.6, y}, name, Align::right}});
    view.add({"h length", Role::measure, Stroke{{left, y}, {right, y}}});
    for (const double x : {left, right})
      view.add(
          {fmt::format("h end {}", x == left ? 0 : 1), Role::measure, Stroke{{x, y - 0.4}, {x, y + 0.4}}});
  }
  void add_frame(View& view) const {
    view.add({"d frame", Role::boundary, Path{box(dvec2(0), area_.size), true}});
  }
  /// The cells that are asked about a place, and the lines between all.
  void add_grid(View& view, const Grid& grid, std::optional<dvec2> asked) const {
    const dvec2 cell = area_.size / dvec2(grid.cells());
    for (int x = 1; x < grid.cells().x; ++x)
      view.add({fmt::format("b x {:03}", x), Role::guide,
                Stroke{at({x * cell.x, 0}), at({x * cell.x, area_.size.y}), false, false, true}});
    for (int y = 1; y < grid.cells().y; ++y)
      view.add({fmt::format("b y {:03}", y), Role::guide,
                Stroke{at({0, y * cell.y}), at({area_.size.x, y * cell.y}), false, false, true}});
    if (!asked) return;
    dvec2 lower = dvec2(grid.cell_of(*asked) - grid.reach()) * cell,
          upper = dvec2(grid.cell_of(*asked) + grid.reach() + 1) * cell;
    if (!area_.wraps) lower = glm::max(lower, dvec2(0)), upper = glm::min(upper, area_.size);
    view.add({"a asked", Role::current, gradus::Area{{box(lower, upper)}, 1}});
  }
  /// What lies round a tile: copies of its samples, as far as they are on the paper.
  void add_copies(View& view, const std::vector<dvec2>& samples) const {
    if (!area_.wraps) return;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (int n = 0; n < 9; ++n) {
        const dvec2 copy = samples[i] + area_.size * dvec2(n % 3 - 1, n / 3 - 1);
        if (n != 4 && shown_.holds(at(copy)))
          view.add({fmt::format("c copy {:03} {}", i, n), Role::guide, Dot{at(copy), true}});
      }
    }
  }

 private:
  static std::vector<dvec2> unit_circle() {
    constexpr int corners = 72;
    std::vector<dvec2> ring;
    for (int i = 0; i < corners; ++i) {
      const SinCos at = sin_cos(2 * 3.14159265358979323846 * i / corners);
      ring.push_back({at.cos, at.sin});
    }
    return ring;
  }

  Area area_;
  Panel panel_;
  Extent shown_;
};

}  // namespace gradus::poisson_disc
