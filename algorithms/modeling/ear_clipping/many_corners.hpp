#pragma once
// Ear clipping for polygons of very many corners: the same triangles in the same order as triangulate finds,
// from a tree of the corners instead of a walk round the ring for each.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <glm/common.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"

namespace gradus::ear_clipping {

/// The corners that are left, in a k-d tree: halves by the longer side of their box, down to a few.
/// J. L. Bentley, Multidimensional binary search trees used for associative searching, Communications of the
/// ACM 18, 1975, 509-517.
class CornerTree {
 public:
  /// polygon: must outlive this.
  explicit CornerTree(std::span<const dvec2> polygon)
      : polygon_(polygon), order_(polygon.size()), place_(polygon.size()), left_(polygon.size(), true) {
    std::iota(order_.begin(), order_.end(), 0);
    build(1, {0, order_.size()});
    for (std::size_t i = 0; i < order_.size(); ++i) place_[static_cast<std::size_t>(order_[i])] = i;
  }

  bool has(int corner) const { return left_[static_cast<std::size_t>(corner)]; }

  void remove(int corner) {
    left_[static_cast<std::size_t>(corner)] = false;
    const std::size_t at = place_[static_cast<std::size_t>(corner)];
    Part part{0, order_.size()};
    for (std::size_t node = 1;; node = 2 * node + (at < part.middle() ? 0 : 1)) {
      if (node > 1) part = node % 2 == 0 ? part.first_half() : part.second_half();
      --nodes_[node].left;
      if (part.is_leaf()) return;
    }
  }

  /// A corner that is left, lies in the triangle or on its border and is at none of its places.
  std::optional<int> inside(dvec2 a, dvec2 b, dvec2 c) const {
    return inside(1, {0, order_.size()}, {a, b, c});
  }

 private:
  /// A triangle and its box.
  struct Asked {
    std::array<dvec2, 3> places;
    dvec2 low, high;

    Asked(dvec2 a, dvec2 b, dvec2 c)
        : places{a, b, c}, low(glm::min(glm::min(a, b), c)), high(glm::max(glm::max(a, b), c)) {}
    bool is_place(dvec2 p) const { return p == places[0] || p == places[1] || p == places[2]; }
  };

  struct Node {
    dvec2 low{0}, high{0};  ///< the box of all that were there
    int left = 0;
  };

  /// A part of order_.
  struct Part {
    std::size_t first, last;

    std::size_t middle() const { return first + (last - first) / 2; }
    bool is_leaf() const { return last - first <= 8; }
    Part first_half() const { return {first, middle()}; }
    Part second_half() const { return {middle(), last}; }
  };

  dvec2 at(int corner) const { return polygon_[static_cast<std::size_t>(corner)]; }

  void build(std::size_t number, Part part) {
    if (nodes_.size() <= number) nodes_.resize(number + 1);
    Node node{at(order_[part.first]), at(order_[part.first]), static_cast<int>(part.last - part.first)};
    for (std::size_t i = part.first; i < part.last; ++i) {
      const dvec2 p = at(order_[i]);
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
    }
    nodes_[number] = node;
    if (part.is_leaf()) return;
    // Halves of the sides: their difference may be too large for a double
    const int axis = node.high.x / 2 - node.low.x / 2 < node.high.y / 2 - node.low.y / 2 ? 1 : 0;
    const auto begin = order_.begin();
    const auto place = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(part.first), place(part.middle()), place(part.last),
                     [&](int i, int k) { return at(i)[axis] < at(k)[axis]; });
    build(2 * number, part.first_half());
    build(2 * number + 1, part.second_half());
  }

  /// Whether a box lies right of the line from p to q: whether its corner that is farthest left does.
  static bool right_of(const Node& box, dvec2 p, dvec2 q) {
    const dvec2 farthest{q.y < p.y ? box.high.x : box.low.x, q.x > p.x ? box.high.y : box.low.y};
    return orient2d(p, q, farthest) < 0;
  }

  /// Whether no place of a box could be the answer.
  static bool outside(const Node& box, const Asked& asked) {
    const auto& t = asked.places;
    if (box.high.x < asked.low.x || asked.high.x < box.low.x || box.high.y < asked.low.y ||
        asked.high.y < box.low.y || (box.low == box.high && asked.is_place(box.low)))
      return true;
    return right_of(box, t[0], t[1]) || right_of(box, t[1], t[2]) || right_of(box, t[2], t[0]);
  }

  std::optional<int> inside(std::size_t number, Part part, const Asked& asked) const {
    if (nodes_[number].left == 0 || outside(nodes_[number], asked)) return std::nullopt;
    if (!part.is_leaf()) {
      const auto found = inside(2 * number, part.first_half(), asked);
      return found ? found : inside(2 * number + 1, part.second_half(), asked);
    }
    const auto& t = asked.places;
    for (std::size_t i = part.first; i < part.last; ++i) {
      const int corner = order_[i];
      const dvec2 p = at(corner);
      if (has(corner) && !asked.is_place(p) && orient2d(t[0], t[1], p) >= 0 && orient2d(t[1], t[2], p) >= 0 &&
          orient2d(t[2], t[0], p) >= 0)
        return corner;
    }
    return std::nullopt;
  }

  std::span<const dvec2> polygon_;
  std::vector<int> order_;          ///< the corners as the tree has them
  std::vector<std::size_t> place_;  ///< of each corner in order_
  std::vector<bool> left_;
  std::vector<Node> nodes_;  ///< from 1; the halves of node i are 2i and 2i + 1
};

/// The first of these from a corner on, and round.
inline std::optional<int> first_from(const std::set<int>& corners, int at) {
  if (corners.empty()) return std::nullopt;
  const auto found = corners.lower_bound(at);
  return found == corners.end() ? *corners.begin() : *found;
}

/// Cuts a polygon of the plane into the triangles of triangulate, in their order.
///
/// A corner that was no ear is none until a neighbour is cut off, or the corner that was found in its
/// triangle: only then it is tested again.
///
/// Domain, Accuracy, Errors: as triangulate.
/// Cost: O(n log n) usually: 100,000 corners take some tenths of a second.
template <std::invocable<const Triangle&> Emit>
void triangulate_many(std::span<const dvec2> polygon, Emit&& emit) {
  expect_polygon(polygon);
  const int n = int(polygon.size());
  const auto place = [&polygon](int i) { return polygon[static_cast<std::size_t>(i)]; };
  Ring ring(n);
  CornerTree tree(polygon);
  std::set<int> open, straight;  // not known to be no ears; known to be straight
  for (int i = 0; i < n; ++i) open.insert(open.end(), i);
  std::vector<std::vector<int>> blocked_by(polygon.size());

  const auto is_ear = [&](int corner) {
    const int turn = turn_at(polygon, ring, corner);
    if (turn == 0) straight.insert(corner);
    if (turn <= 0) return false;
    const auto blocker = tree.inside(place(ring.before(corner)), place(corner), place(ring.next(corner)));
    if (blocker) blocked_by[static_cast<std::size_t>(*blocker)].push_back(corner);
    return !blocker;
  };
  const auto next_ear = [&](int at) -> std::optional<int> {
    while (const std::optional<int> corner = first_from(open, at)) {
      open.erase(*corner);
      if (is_ear(*corner)) return corner;
    }
    return std::nullopt;
  };
  const auto reopen = [&](int corner) {
    if (!tree.has(corner)) return;
    open.insert(corner);
    straight.erase(corner);
  };

  for (int at = 1; ring.size() > 2;) {
    const auto found = next_ear(at);
    const int corner = found ? *found : first_from(straight, ring.any()).value_or(ring.any());
    const Triangle ear = ring.triangle(corner);
    emit(ear);
    ring.remove(corner);
    tree.remove(corner);
    straight.erase(corner);
    reopen(ear[0]);
    reopen(ear[2]);
    for (const int blocked : std::exchange(blocked_by[static_cast<std::size_t>(corner)], {})) reopen(blocked);
    at = ear[2];
  }
}

/// The same for a flat polygon in space, as triangulate has it.
template <std::invocable<const Triangle&> Emit>
void triangulate_many(std::span<const dvec3> polygon, Emit&& emit) {
  expect_polygon(polygon);
  const std::vector<dvec2> flat = flattened(polygon);
  triangulate_many(std::span<const dvec2>(flat), emit);
}

}  // namespace gradus::ear_clipping
