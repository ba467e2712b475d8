#pragma once
// The same ends along a ray, without asking leaves that can't change them: boxes of nodes, made once for a
// tree, say on which part of the ray a node matters.

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "modeling/csg_tree/csg_tree.hpp"

namespace gradus::csg_tree {

/// A box round a node's solid, a little too large; endless where the solid is.
template <class T>
using Boxes = std::vector<Box<T>>;

/// More than roundings along a ray come to, in parts of the numbers that are rounded.
template <class T>
inline constexpr T skipping_margin = T(4096) * std::numeric_limits<T>::epsilon();

template <class T>
Box<T> endless_box() {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  return {Point<T>(-infinity), Point<T>(infinity)};
}
template <class T>
T largest_of(const Point<T>& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
template <class T>
Box<T> grown(const Box<T>& box, T by) {
  return {box.lower - by, box.upper + by};
}

template <class T>
Box<T> box_of(const HalfSpace<T>&) {
  return endless_box<T>();
}
template <class T>
Box<T> box_of(const Box<T>& box) {
  return grown(box, skipping_margin<T> * std::max(largest_of(box.lower), largest_of(box.upper)));
}
template <class T>
Box<T> box_of(const Ball<T>& ball) {
  const T margin = skipping_margin<T> * (largest_of(ball.centre) + ball.radius);
  return grown<T>({ball.centre, ball.centre}, ball.radius + margin);
}
template <class T>
Box<T> box_of(const Cylinder<T>& c) {
  Box<T> box = box_of(Ball<T>{c.centre, c.radius});
  box.lower[c.axis] = endless_box<T>().lower.x;
  box.upper[c.axis] = endless_box<T>().upper.x;
  return box;
}

/// Of each node, from the leaves to the root.
template <class T>
Boxes<T> boxes_of(Tree<T> tree) {
  expect_tree(tree);
  Boxes<T> boxes;
  for (const Node<T>& node : tree) {
    if (is_leaf(node)) {
      boxes.push_back(std::visit([](const auto& solid) { return box_of(solid); }, node.solid));
      continue;
    }
    const Box<T>&a = boxes[node.a], &b = boxes[node.b];
    if (node.op == Op::unite)
      boxes.push_back({glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)});
    else if (node.op == Op::intersect)
      boxes.push_back({glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)});
    else
      boxes.push_back(Box<T>(a));
  }
  return boxes;
}

/// A part of a ray; none where last < first.
template <class T>
struct Part {
  T first, last;
};
/// What of it a box holds. All of the box is a little too large, so that rounding loses nothing.
template <class T>
Part<T> part_in(const Box<T>& box, const Ray<T>& ray, Part<T> part) {
  const T margin = skipping_margin<T> * largest_of(ray.from);
  for (int i = 0; i < 3; ++i) {
    const T lower = box.lower[i] - margin, upper = box.upper[i] + margin;
    const T from = ray.from[i], way = ray.way[i];
    if (way == 0 && !(lower <= from && from <= upper)) return {T(1), T(0)};
    if (way == 0) continue;
    const T a = (lower - from) / way, b = (upper - from) / way;
    part.first = std::max(part.first, std::min(a, b));
    part.last = std::min(part.last, std::max(a, b));
  }
  return part;
}

/// As along_ray, with the boxes that boxes_of has made of the tree.
///
/// Domain: that of along_ray; each node but the root is an operand of one other.
/// Accuracy: the ends of along_ray, bit for bit.
/// Cost: from the root down, a box for each node that matters; then only those leaves and nodes.
template <std::floating_point T>
Ends<T> skipping(Tree<T> tree, std::span<const Box<T>> boxes, const Ray<T>& ray) {
  expect_ray(ray);
  expects(boxes.size() == tree.size(), "{} boxes for {} nodes", boxes.size(), tree.size());
  std::vector<Part<T>> parts(tree.size(), {T(1), T(0)});
  parts.back() = {T(0), ray.last};
  for (Index i = tree.size(); i-- > 0;) {
    Part<T>& part = parts[i];
    if (part.last < part.first) continue;
    part = part_in(boxes[i], ray, part);
    if (is_leaf(tree[i])) continue;
    // What is taken away, or kept in common, matters where the node has something
    parts[tree[i].a] = parts[tree[i].b] = part;
  }
  std::vector<Ends<T>> on(tree.size());
  for (Index i = 0; i < tree.size(); ++i) {
    if (parts[i].last < parts[i].first) continue;
    const auto& [op, a, b, solid] = tree[i];
    if (op == Op::leaf)
      on[i] = ends_in(solid, ray);
    else if (on[b].empty())
      on[i] = op == Op::intersect ? Ends<T>{} : std::move(on[a]);
    else if (on[a].empty())
      on[i] = op == Op::unite ? std::move(on[b]) : Ends<T>{};
    else
      on[i] = merged(op, on[a], on[b]);
  }
  return std::move(on.back());
}

}  // namespace gradus::csg_tree
