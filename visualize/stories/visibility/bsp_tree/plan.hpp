#pragma once
// Polygons that all contain one direction, walls say, seen along it: each is a stroke, each plane a line, and
// what the planes leave of space is a region of the plan.

#include "stories/visibility/bsp_tree/drawing.hpp"

namespace gradus::bsp_tree {

/// The one direction along which all polygons are seen edge-on, if there is just one.
inline std::optional<dvec3> direction_of_walls(const std::vector<DPolygon>& polygons) {
  constexpr double noise = 1e-9, least_turn = 1e-3;
  const auto normals =
      mapped(polygons, [](const DPolygon& p) { return unit_vector(area_vector(p.corners)); });
  for (const dvec3 n : normals) {
    dvec3 along = glm::cross(normals.front(), n);
    if (glm::length(along) < least_turn) continue;
    along = unit_vector(along);
    if (std::ranges::any_of(normals, [&](dvec3 m) { return std::abs(glm::dot(m, along)) > noise; })) break;
    // From above, or from where its longest coordinate is positive
    int longest = 2;
    for (const int axis : {1, 0}) {
      if (std::abs(along[axis]) > std::abs(along[longest]) + noise) longest = axis;
    }
    return along[longest] < 0 ? -along : along;
  }
  return std::nullopt;
}

class Plan {
 public:
  /// towards: the eye, infinitely far away.
  Plan(dvec3 along, const Extent& place, const DTree& tree, const std::vector<dvec3>& points, dvec3 towards)
      : tree_(tree), reader_(along), cells_(tree.size()) {
    const Extent walls = extent_around(mapped(points, [&](dvec3 p) { return reader_.flat(p); }));
    box_ = widened(walls, 0.13);
    panel_ = Panel(place, widened(box_, 0.08));
    if (!tree.empty()) divide(0, box_.corners());
    // As far out as the eye is drawn, whatever the direction's length
    const double length = glm::length(reader_.flat(towards));
    const dvec2 half = 0.5 * box_.size(), way = glm::abs(reader_.flat(towards));
    if (length > 1e-9 * glm::length(towards))
      reach_ =
          1.06 * std::min(half.x / std::max(way.x, 1e-9 * length), half.y / std::max(way.y, 1e-9 * length));
  }

  /// Where the eye is drawn that lies in this direction; nowhere if it looks along all planes.
  std::optional<dvec2> eye_at(dvec3 towards) const {
    if (reach_ == 0) return std::nullopt;
    return panel_.at(box_.centre() + reach_ * reader_.flat(towards));
  }
  void add_eye(View& view, dvec3 towards, const std::string& name) const {
    const auto at = eye_at(towards);
    if (!at) return;
    const dvec2 way = glm::normalize(panel_.at(box_.centre()) - *at);
    view.add({"p eye way", Role::measure, Stroke{*at, *at + 3.0 * way, true}});
    view.add_named("p eye", Role::measure, *at, name);
  }

  /// What lies on one side of a node's plane, of what the planes above it have left.
  Ring2 part(std::size_t node, bool in_front) const {
    const auto [origin, normal] = line_of(node);
    Ring2 kept;
    for (const auto& [a, b] : sides_of(cells_[node])) {
      const double sign = in_front ? 1 : -1;
      const double da = sign * glm::dot(a - origin, normal), db = sign * glm::dot(b - origin, normal);
      if (da >= 0) kept.push_back(a);
      if ((da < 0) != (db < 0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    return kept;
  }
  void add_region(View& view, std::size_t node, bool in_front, Role role,
                  const std::string& name = "") const {
    const Ring2 ring = part(node, in_front);
    if (ring.size() < 3) return;
    const std::string id = fmt::format("p region {:02} {}", node, in_front ? "+" : "-");
    // The other side stays plain, so that they are told apart without colour
    if (role == Role::accepted) view.add({id, role, Area{{panel_.at(ring)}, 3}});
    if (!name.empty()) view.add({id + " name", role, Text{panel_.at(middle_of(ring)), name}});
  }
  void add_border(View& view) const {
    view.add({"p border", Role::guide, Path{panel_.at(box_.corners()), true}});
  }
  /// A node's plane as far as it parts something; with the signs of its sides at one end.
  void add_line(View& view, std::size_t node, Role role, bool signs = false) const {
    const auto [origin, normal] = line_of(node);
    Ring2 ends;
    for (const dvec2 p : part(node, true)) {
      if (std::abs(glm::dot(p - origin, normal)) <= 1e-9 * box_.size().x) ends.push_back(p);
    }
    if (ends.size() < 2) return;
    const dvec2 a = panel_.at(ends.front()), b = panel_.at(ends.back());
    view.add({fmt::format("p line {:02}", node), role, Stroke{a, b, false, true, true}});
    if (!signs) return;
    const dvec2 high = a.y > b.y ? a : b, down = glm::normalize(a + b - 2.0 * high);
    const dvec2 beside = high + 0.9 * down;
    view.add({"p sign +", Role::guide, Text{beside + 1.1 * normal, "+"}});
    view.add({"p sign -", Role::guide, Text{beside - 1.1 * normal, "−"}});
  }
  /// A polygon edge-on, with its name; `ends`: its corners are marked.
  void add_wall(View& view, const DPolygon& polygon, Role role, const std::string& name,
                bool ends = false) const {
    const dvec2 normal = flat_normal(polygon.plane), along{-normal.y, normal.x};
    Ring2 flat = mapped(polygon.corners, [&](dvec3 p) { return reader_.flat(p); });
    std::ranges::sort(flat, {}, [&](dvec2 p) { return glm::dot(p, along); });
    const dvec2 a = panel_.at(flat.front()), b = panel_.at(flat.back());
    const std::string id = fmt::format("q {} {}", polygon.face, name);
    view.add({id, role, Stroke{a, b}});
    for (const dvec2 end : {a, b}) {
      if (ends) view.add({id + (end == a ? " a" : " b"), role, Dot{end}});
    }
    view.add({"r " + id, role, Label{0.5 * (a + b), name}});
  }
  void add_dot(View& view, const std::string& id, Role role, dvec3 p) const {
    view.add({id, role, Dot{panel_.at(reader_.flat(p))}});
  }

 private:
  void divide(std::size_t node, Ring2 cell) {
    cells_[node] = std::move(cell);
    const auto& [plane, polygons, in_front, behind] = tree_[node];
    if (in_front != none) divide(in_front, part(node, true));
    if (behind != none) divide(behind, part(node, false));
  }
  dvec2 flat_normal(const Plane<double>& plane) const {
    return glm::normalize(reader_.flat(unit_vector(glm::cross(plane.b - plane.a, plane.c - plane.a))));
  }
  std::pair<dvec2, dvec2> line_of(std::size_t node) const {
    return {reader_.flat(tree_[node].plane.a), flat_normal(tree_[node].plane)};
  }

  const DTree& tree_;
  faces_subject::Reader reader_;
  Extent box_;
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
  std::vector<Ring2> cells_;  ///< what each node's plane parts
  double reach_ = 0;
};

}  // namespace gradus::bsp_tree
