#pragma once
// An exhibit: a BSP tree that leaves polygons whole, kept so that a figure can show what comes of it. Never
// draw with it; bsp_tree.hpp has the right one.

#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus::bsp_tree {

/// The side of the first corner that lies beside the plane. Domain: there is one.
constexpr Side first_side(std::span<const int> sides) {
  for (const int side : sides) {
    if (side != 0) return side > 0 ? Side::in_front : Side::behind;
  }
  return Side::in_plane;
}

/// FAULTY: a polygon with corners on both sides of a plane goes uncut to the side of its first one that lies
/// beside the plane. What of it lies on the other side is drawn at the wrong time.
///
/// polygons, side: as build.
///
/// Domain: as build.
/// Steps: (PlaneTaken Placed*)* Built
/// Accuracy: no useful bound: the order is right only where no plane cuts a polygon.
/// Cost: as build; as many polygons as were given.
/// Errors: as build.
template <class T, class SideOf = ExactSide, Observer<PlaneTaken<T>, Placed<T>, Built> O = Unobserved>
Tree<T> build_uncut(const std::vector<Polygon<T>>& polygons, const SideOf& side = {}, O&& observer = {}) {
  Tree<T> tree;
  auto rest = whole_space(polygons);
  while (!rest.empty()) {
    const auto space = taken_from(rest);
    if (space.empty()) continue;
    // The first one's plane parts the others
    const auto node = add_node(tree, space);
    const Plane<T> plane = tree[node].plane;
    if constexpr (observed<O>) observer(taken(tree, node, space));
    Subspace<T> front{node, true};
    Subspace<T> back{node, false};
    for (const auto& p : space.others()) {
      const auto on = sides(plane, p, side);
      // Cut? The first corner's side will do
      const Side at = first_side(on);
      if constexpr (observed<O>) observer(Placed<T>{node, p, at});
      if (at == Side::in_front) {
        front.add(p);
      } else if (at == Side::behind) {
        back.add(p);
      } else if (at == Side::in_plane) {
        add_to_node(tree, node, p);
      }
    }
    rest.push_back(back);
    rest.push_back(front);
  }
  if constexpr (observed<O>) observer(Built{tree.size(), polygon_count(tree)});
  return tree;
}

}  // namespace gradus::bsp_tree
