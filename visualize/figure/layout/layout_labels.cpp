// Where labels go: near their point, off what matters; a leader only where that is impossible, and none that
// leads over a mark or a text.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry.hpp"
#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

/// Beside, above, below, and between these.
constexpr std::array<std::pair<double, double>, 16> ways{{{-1.0, 0.0},
                                                          {1.0, 0.0},
                                                          {-1.0, -1.0},
                                                          {1.0, -1.0},
                                                          {-1.0, 1.0},
                                                          {1.0, 1.0},
                                                          {0.0, -1.0},
                                                          {0.0, 1.0},
                                                          {-1.0, -0.5},
                                                          {1.0, -0.5},
                                                          {-1.0, 0.5},
                                                          {1.0, 0.5},
                                                          {-0.5, -1.0},
                                                          {0.5, -1.0},
                                                          {-0.5, 1.0},
                                                          {0.5, 1.0}}};
/// Units beyond the nearest place; from the second on with a leader.
constexpr std::array further{0.0, 22.0, 44.0, 70.0, 105.0, 150.0, 210.0};

class LabelPlacer {
 public:
  LabelPlacer(const Obstacles& obstacles, const Box& room, dvec2 anchor, double clear, double scale)
      : obstacles_(obstacles), room_(room), anchor_(anchor), clear_(clear), s_(scale) {}

  std::optional<PlacedLabel> place(dvec2 size, double gap) const {
    std::optional<PlacedLabel> best;
    double least = std::numeric_limits<double>::infinity();
    for (const double more : further) {
      const double distance = gap + more * s_;
      if (distance >= least) break;
      for (const auto& [dx, dy] : ways) {
        const double x = anchor_.x + dx * distance - (dx < 0 ? size.x : dx > 0 ? 0 : size.x / 2);
        const Box at{x, anchor_.y + dy * distance - size.y / 2, size.x, size.y};
        auto cost = badness(at, distance, least);
        if (!cost) continue;
        *cost += ambiguity(at);
        PlacedLabel placed{at, {}};
        if (more > 0) {
          placed.leader = leader_to(at);
          if (crosses_something(*placed.leader)) continue;
          *cost += 2 * more * s_;
        }
        if (*cost >= least) continue;
        best = placed;
        least = *cost;
      }
    }
    return best;
  }

 private:
  /// How bad a place is: covering what matters, lying on lines, being far away. Nothing: impossible, or no
  /// better than `least`.
  std::optional<double> badness(const Box& at, double distance, double least) const {
    if (!inside(at, room_)) return std::nullopt;
    const Box apart = grown(at, 3 * s_);
    if (std::ranges::any_of(obstacles_.texts, [&](const Box& text) { return overlap(apart, text); }))
      return std::nullopt;
    if (std::ranges::any_of(obstacles_.leaders,
                            [&](const auto& l) { return clipped(l.a, l.b, apart).has_value(); }))
      return std::nullopt;
    double cost = distance;
    // Beside a number of an axis, a label would seem to go on with it
    for (const Box& tick : obstacles_.ticks) cost += overlap(at, tick) ? 90 * s_ : 0;
    const double area = at.width * at.height;
    for (const Box& box : obstacles_.taken) {
      // Half of a dot is as bad as half of the label, and a touch already covers it or seems to name it
      const double covered = overlap_area(at, box), own = std::max(box.width * box.height, 1.0);
      cost += 900 * s_ * covered / std::min(own, std::max(area, 1.0));
      if (covered > 0 && own < area) cost += 300 * s_;
    }
    for (const auto& [box, weight] : obstacles_.crowded) cost += weight * s_ * overlap_area(at, box) / area;
    // Each cost adds, so that a place that lost already need not be counted to its end
    const Box clearing = grown(at, clear_);
    // Beside a line whose cells are still to come, a label would soon be covered
    const double nearness = (clear_ > 20 * s_ ? 320 : 160) * s_;
    for (const auto& [a, b] : obstacles_.strokes) {
      if (cost >= least) return std::nullopt;
      if (clipped(a, b, clearing)) cost += nearness;
    }
    return cost < least ? std::optional(cost) : std::nullopt;
  }

  /// A label that touches another marked cell than its own, or stands in its row, seems to name that one.
  double ambiguity(const Box& label) const {
    double cost = 0;
    const double row = label.y + label.height / 2;
    for (const Box& cell : obstacles_.taken) {
      if (inside(anchor_, cell)) continue;
      const bool in_its_row = cell.y < row && row < cell.bottom() && overlap(grown(label, 16 * s_), cell);
      if (in_its_row || overlap(grown(label, 7 * s_), cell)) cost += (in_its_row ? 150 : 60) * s_;
    }
    return cost;
  }

  Segment<2, double> leader_to(const Box& label) const {
    return {{std::clamp(anchor_.x, label.x, label.right()), std::clamp(anchor_.y, label.y, label.bottom())},
            anchor_};
  }

  bool crosses_something(const Segment<2, double>& leader) const {
    // What the anchor itself lies on is crossed there, and may be
    const dvec2 way = leader.a - leader.b;
    const double length = length_of(way), off = std::min(9 * s_, 0.9 * length);
    const Segment<2, double> outer{leader.a, leader.b + way * (off / std::max(length, 1e-9))};
    const auto hits = [&outer](const Box& box) { return clipped(outer.a, outer.b, box).has_value(); };
    const auto strikes = [&leader](const Box& text) { return clipped(leader.a, leader.b, text).has_value(); };
    return std::ranges::any_of(obstacles_.texts, strikes) ||
           std::ranges::any_of(
               obstacles_.taken,
               [&](const Box& box) { return !inside(anchor_, box) && hits(grown(box, -2 * s_)); }) ||
           std::ranges::any_of(obstacles_.leaders, [&](const auto& other) { return cross(outer, other); }) ||
           std::ranges::any_of(obstacles_.strokes, [&](const auto& other) { return cross(outer, other); });
  }

  const Obstacles& obstacles_;
  const Box& room_;
  dvec2 anchor_;
  double clear_, s_;
};

}  // namespace

std::optional<PlacedLabel> place_label(const Obstacles& obstacles, const Box& room, dvec2 anchor, dvec2 size,
                                       double gap, double clear, double scale) {
  return LabelPlacer(obstacles, room, anchor, clear, scale).place(size, gap);
}

double ring_radius(const Obstacles& obstacles, dvec2 at, double most, double scale) {
  double radius = most;
  for (const Box& text : obstacles.texts) {
    const dvec2 upper{text.x, text.y}, lower{text.right(), text.bottom()};
    const double nearest = glm::distance(at, glm::clamp(at, upper, lower)),
                 farthest = glm::length(glm::max(glm::abs(upper - at), glm::abs(lower - at)));
    // A number in a cell, which the ring surrounds, is no obstacle
    if (farthest + 4 * scale > radius) radius = std::min(radius, nearest - 6 * scale);
  }
  return radius < 10 * scale ? 0 : radius;
}

}  // namespace gradus::layout
