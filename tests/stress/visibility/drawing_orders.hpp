#pragma once
// Orders in which polygons are drawn, judged along rays; and whether two of them are one.

#include <algorithm>
#include <concepts>
#include <optional>
#include <vector>

#include "stress/domain.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus::stress {

template <class T>
using Parts = std::vector<bsp_tree::Polygon<T>>;

/// Adds to what is drawn.
template <class T>
auto into(Parts<T>& order) {
  return [&order](const bsp_tree::Polygon<T>& part) { order.push_back(part); };
}
/// Adds what steps of a type tell of it.
template <class Told, class T>
auto as_told(Parts<T>& order) {
  return [&order]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Told>) order.push_back(step.polygon);
  };
}

template <class T>
bool are_same(const Parts<T>& one, const Parts<T>& other) {
  return std::ranges::equal(
      one, other, [](const auto& a, const auto& b) { return a.face == b.face && a.corners == b.corners; });
}

/// Whether along rays to the middle of every part no later polygon lies farther than an earlier one, by more
/// than a little. hit: where the ray from a place along a way meets a polygon, if it does in front of the
/// eye.
template <class T, class Hit>
bool covers_none(const Parts<T>& order, const glm::vec<4, T>& eye, const T& little, const Hit& hit) {
  const bool distant = eye.w == T{0};
  const glm::vec<3, T> at(eye);
  for (const auto& part : order) {
    const auto middle = (part.corners[0] + part.corners[1] + part.corners[2]) / T(3);
    const auto from = distant ? middle : at, way = distant ? -at : middle - at;
    std::optional<T> before;
    for (const auto& polygon : order) {
      const auto t = hit(polygon, from, way);
      if (!t) continue;
      if (before && *t > *before + little) return false;
      before = t;
    }
  }
  return true;
}

}  // namespace gradus::stress
