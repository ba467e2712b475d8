#pragma once
// A grid that finds the sample nearest to a place among those in the cells round it: the same one as asking
// all samples, where any is nearer than the radius.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "core/geometry.hpp"

namespace gradus::poisson_disc {

/// Where samples are put.
struct Area {
  dvec2 size{1};
  bool wraps = false;  ///< whether it is a tile, which goes on at the opposite side
};

/// The way from one place to another, the shorter one round a tile.
constexpr dvec2 way_between(const Area& area, dvec2 from, dvec2 to) {
  dvec2 way = to - from;
  if (area.wraps) way -= area.size * glm::round(way / area.size);
  return way;
}

/// The square of a distance. Accuracy: 3 ulp.
constexpr double squared(dvec2 way) { return way.x * way.x + way.y * way.y; }

/// The distance of a place to the nearest of some samples, and which one that is.
struct Nearest {
  double d2 = std::numeric_limits<double>::infinity();  ///< the distance's square
  dvec2 sample{0};

  constexpr void ask(const Area& area, dvec2 place, dvec2 other) {
    const double here = squared(way_between(area, place, other));
    if (here < d2) *this = {here, other};
  }
  double distance() const { return std::sqrt(d2); }
};

/// Whether a place lies in the area.
constexpr bool contains(const Area& area, dvec2 p) {
  return 0 <= p.x && p.x < area.size.x && 0 <= p.y && p.y < area.size.y;
}

/// How many cells an area is cut into, across and up: so small that a diagonal is at most the radius.
inline ivec2 cells_of(const Area& area, double radius) {
  return glm::max(glm::ceil(area.size * (1.4142135623730951 / radius)), 1.0);
}

/// The cell of so many that a place of the area lies in.
inline ivec2 cell_at(const Area& area, ivec2 cells, dvec2 place) {
  return glm::min(ivec2(place / area.size * dvec2(cells)), cells - 1);
}

/// Which sample lies in which cell. A cell's diagonal is at most the radius, so that no cell holds two.
class Grid {
 public:
  Grid(const Area& area, double radius)
      : area_(area),
        cells_(cells_of(area, radius)),
        reach_(glm::ceil(radius * dvec2(cells_) / area.size)),
        samples_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y), dvec2(-1)) {}

  ivec2 cells() const { return cells_; }
  /// How many cells away a sample may lie that is too near.
  ivec2 reach() const { return reach_; }
  ivec2 cell_of(dvec2 place) const { return cell_at(area_, cells_, place); }
  void put(dvec2 sample) { samples_[index(cell_of(sample))] = sample; }
  int samples() const {
    return static_cast<int>(std::ranges::count_if(samples_, [](dvec2 sample) { return sample.x >= 0; }));
  }

  /// The sample nearest to a place, of those in the cells round it; none for one outside the area.
  Nearest nearest(dvec2 place) const {
    Nearest least;
    if (!contains(area_, place)) return least;
    const ivec2 cell = cell_of(place);
    for (int y = cell.y - reach_.y; y <= cell.y + reach_.y; ++y) {
      for (int x = cell.x - reach_.x; x <= cell.x + reach_.x; ++x) ask({x, y}, place, least);
    }
    return least;
  }

 private:
  std::size_t index(ivec2 cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(cell.x);
  }
  /// Of a tile, on which nobody is asked from farther away than once round it.
  static int inside(int cell, int count) {
    return cell < 0 ? cell + count : cell >= count ? cell - count : cell;
  }
  void ask(ivec2 cell, dvec2 place, Nearest& nearest) const {
    if (area_.wraps) cell = {inside(cell.x, cells_.x), inside(cell.y, cells_.y)};
    if (cell.x < 0 || cell.x >= cells_.x || cell.y < 0 || cell.y >= cells_.y) return;
    const dvec2 sample = samples_[index(cell)];
    if (sample.x >= 0) nearest.ask(area_, place, sample);
  }

  Area area_;
  ivec2 cells_, reach_;
  std::vector<dvec2> samples_;  ///< by cell; below 0 where there is none
};

}  // namespace gradus::poisson_disc
