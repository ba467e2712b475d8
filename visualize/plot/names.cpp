#include "plot/names.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/random.hpp"

namespace gradus::plot {
namespace {

constexpr int orders = 40;
constexpr double gap = 9, clear = 4;  ///< of a name from its marker, and from lines

/// Some names placed, and how well: by the leaders' lengths, and by what was given up.
struct Places {
  std::vector<layout::PlacedLabel> labels;  ///< by the points' numbers
  double cost = std::numeric_limits<double>::infinity();
};

bool covers(const Box& name, const std::vector<Box>& boxes) {
  return std::ranges::any_of(boxes, [&](const Box& box) { return layout::overlap(name, box); });
}

bool meets(const Segment<2, double>& line, const std::vector<Box>& boxes) {
  return std::ranges::any_of(
      boxes, [&](const Box& box) { return layout::clipped(line.a, line.b, box).has_value(); });
}

Segment<2, double> leader_between(const Box& name, dvec2 at) {
  return {{std::clamp(at.x, name.x, name.right()), std::clamp(at.y, name.y, name.bottom())}, at};
}

/// The nearest place that covers no marker and no name; `clean`: no leader either, and its own covers no
/// name.
std::optional<layout::PlacedLabel> nearest_free(const NamedPoint& point, const Box& room,
                                                const layout::Obstacles& around, bool clean, double scale) {
  std::optional<layout::PlacedLabel> best;
  double least = std::numeric_limits<double>::infinity();
  for (double y = room.y; y + point.size.y <= room.bottom(); y += 6 * scale) {
    for (double x = room.x; x + point.size.x <= room.right(); x += 12 * scale) {
      const Box name{x, y, point.size.x, point.size.y}, apart = layout::grown(name, 3 * scale);
      const Segment<2, double> leader = leader_between(name, point.at);
      const double distance = length_of(leader.a - leader.b);
      if (distance >= least || covers(apart, around.taken) || covers(apart, around.texts)) continue;
      const auto over = [&](const auto& other) { return meets(other, {apart}); };
      if (clean && (meets(leader, around.texts) || std::ranges::any_of(around.leaders, over))) continue;
      least = distance;
      best = {name, leader};
    }
  }
  return best;
}

/// The place for one name, and what is given up for it is added to the cost.
layout::PlacedLabel place(const NamedPoint& point, layout::Obstacles& around, const Box& room, double scale,
                          double& cost) {
  const auto label = layout::place_label(around, room, point.at, point.size, point.reach + gap * scale,
                                         clear * scale, scale);
  if (label && !covers(label->box, around.taken)) return *label;
  cost += 1e3;  // a leader over a line
  if (const auto free = nearest_free(point, room, around, true, scale)) return *free;
  cost += 1e5;  // a name and a leader over each other
  if (const auto free = nearest_free(point, room, around, false, scale)) return *free;
  cost += 1e7;
  return {{point.at.x + point.reach + gap * scale, point.at.y - point.size.y / 2, point.size.x, point.size.y},
          std::nullopt};
}

Places placed_in(const std::vector<std::size_t>& order, std::span<const NamedPoint> points,
                 layout::Obstacles around, const Box& room, double scale) {
  Places places{std::vector<layout::PlacedLabel>(points.size()), 0};
  for (const std::size_t i : order) {
    const layout::PlacedLabel& label = places.labels[i] = place(points[i], around, room, scale, places.cost);
    around.texts.push_back(label.box);
    if (!label.leader) continue;
    around.leaders.push_back(*label.leader);
    places.cost += 20 + length_of(label.leader->a - label.leader->b) / scale;
  }
  return places;
}

}  // namespace

std::vector<layout::PlacedLabel> place_names(std::span<const NamedPoint> points,
                                             const layout::Obstacles& around, const Box& room, double scale) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](std::size_t i) { return points[i].at.x; });
  Places best;
  Random random(1);
  for (int round = 0; round < orders; ++round) {
    Places tried = placed_in(order, points, around, room, scale);
    if (tried.cost < best.cost) best = std::move(tried);
    if (round == 0) std::ranges::reverse(order);
    if (round > 0) random.shuffle(order);
  }
  return std::move(best.labels);
}

}  // namespace gradus::plot
