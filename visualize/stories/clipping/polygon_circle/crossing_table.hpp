#pragma once
// The crossings of a polygon and a circle as a table in the drawing: a dot for those that enter or a ring,
// name, angle; in the order in which edges find them, then in that round the circle.

#include <algorithm>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clipping/polygon_circle/polygon_circle.hpp"
#include "stories/clipping/circle_drawing.hpp"
#include "stories/paper.hpp"

namespace gradus::polygon_circle {

/// Whether there is one to list.
inline bool any_crossing(const std::vector<dvec2>& polygon, const Circle<double>& circle) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Run run = run_of(edge_of(polygon, i), circle);
    if (run.enters() || run.leaves()) return true;
  }
  return false;
}

class CrossingTable {
 public:
  static constexpr double width = 9;  ///< units of the paper
  static constexpr double least_unit =
      9.6;  ///< of a slide: in smaller ones its texts would lie on each other

  /// A crossing that an edge has found; its name. Names stay when the rows are sorted.
  std::string add(std::size_t edge, dvec2 at, bool leaves, const Circle<double>& circle) {
    const dvec2 way = seen_from(circle.centre, at, unit_of(circle.radius));
    const double degrees = atan2(way.y, way.x) * 180 / std::numbers::pi;
    const int whole = static_cast<int>(std::round(degrees < 0 ? degrees + 360 : degrees)) % 360;
    rows_.push_back({edge, leaves, letter(rows_.size()), whole});
    return rows_.back().name;
  }
  void sort(std::span<const Crossing> crossings) {
    std::vector<Row> sorted;
    for (const Crossing& c : crossings) {
      const auto row =
          std::ranges::find_if(rows_, [&](const Row& r) { return r.edge == c.edge && r.leaves == c.leaves; });
      if (row != rows_.end()) sorted.push_back(*row);
    }
    rows_ = std::move(sorted);
  }
  const std::string& name(std::size_t number) const { return rows_.at(number).name; }
  std::size_t size() const { return rows_.size(); }

  /// upper: the table's upper right corner. Of two rows that are marked an arrow beside them leads from the
  /// first to the second. Of many rows those about the last one marked.
  void add_to(View& view, const std::string& id, const Words& words, std::string_view title, dvec2 upper,
              const std::vector<std::size_t>& marked) const {
    if (rows_.empty()) return;
    constexpr std::size_t most = 9;
    const std::size_t shown = std::min(rows_.size(), most), last = marked.empty() ? 0 : marked.back();
    const std::size_t first = std::min(last < most / 2 ? 0 : last - most / 2, rows_.size() - shown);
    const auto middle = [&](std::size_t i) {
      return upper.y - pitch * (static_cast<double>(i) - static_cast<double>(first) + 1.7);
    };
    const double left = upper.x - width;
    view.add(
        {id + " title", Role::guide, Text{{upper.x, upper.y - 0.5 * pitch}, words.say(title), Align::right}});
    for (std::size_t i = first; i < first + shown; ++i) {
      const Row& row = rows_[i];
      const std::string own = fmt::format("{} {:03}", id, i);
      const double y = middle(i);
      const bool now = std::ranges::find(marked, i) != marked.end();
      const Role role = row.leaves ? Role::past : Role::candidate, text = now ? Role::current : role;
      if (now) {
        const Extent box{{left, y - 0.46 * pitch}, {upper.x, y + 0.46 * pitch}};
        view.add({own + " ground", Role::current, Area{{box.corners()}}});
        view.add({own + " now", Role::current, Path{box.corners(), true}});
      }
      view.add({own + " dot", role, Dot{{left + 0.9, y}, row.leaves}});
      view.add({own + " name", text, Text{{left + 2.7, y}, row.name}});
      view.add(
          {own + " angle", text, Text{{upper.x - 0.4, y}, fmt::format("{}°", row.degrees), Align::right}});
    }
    const auto seen = [&](std::size_t i) { return first <= i && i < first + shown; };
    if (marked.size() == 2 && marked[0] != marked[1] && seen(marked[0]) && seen(marked[1]))
      view.add({id + " way", Role::current,
                Stroke{{upper.x + 0.8, middle(marked[0])}, {upper.x + 0.8, middle(marked[1])}, true}});
  }

 private:
  static constexpr double pitch = 2.5;
  struct Row {
    std::size_t edge;
    bool leaves;
    std::string name;
    int degrees;
  };
  std::vector<Row> rows_;
};

}  // namespace gradus::polygon_circle
