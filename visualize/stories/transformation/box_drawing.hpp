#pragma once
// A box with an F on its front, and the axes of space, as the stories of space draw them: obliquely.

#include "stories/transformation/affine_3d_task.hpp"

namespace gradus::affine_3d {

using Shape = std::vector<dvec3>;

/// Corner i lies at x, y, z = its bits 0, 1, 2; the F stands on the face z = 1, which looks to the reader.
inline Shape box_of(dvec3 size) {
  Shape corners;
  for (int i = 0; i < 8; ++i) corners.push_back(size * dvec3{i & 1, i >> 1 & 1, i >> 2 & 1});
  for (const auto& [x, y] : {std::pair{0.3, 0.15}, {0.3, 0.85}, {0.75, 0.85}, {0.3, 0.52}, {0.62, 0.52}}) {
    corners.push_back(size * dvec3{x, y, 1});
  }
  return corners;
}
constexpr std::size_t front = 1;  ///< of these faces, the one with the F
/// Counter-clockwise from outside.
constexpr std::array<std::array<std::size_t, 4>, 6> faces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
/// Corner A, on the front, from where the F is read.
constexpr std::size_t corner_a = 7;

inline Shape moved(const Mat& m, Shape points) {
  for (dvec3& p : points) p = transform(m, p);
  return points;
}

/// Of length 1, whatever its size; 0 stays.
template <class Vector>
Vector unit(Vector v) {
  const double length = length_between(Vector(0), v);
  return length > 0 ? v / length : v;
}

inline double doubled_area(const std::vector<dvec2>& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 p = ring[i], q = ring[(i + 1) % ring.size()];
    area += p.x * q.y - q.x * p.y;
  }
  return area;
}

inline std::vector<dvec2> on_paper(const Panel& panel, const Shape& shape) {
  std::vector<dvec2> points;
  for (const dvec3 p : shape) points.push_back(panel.at(oblique(p)));
  return points;
}
inline void add_to(Extent& world, const Shape& shape) {
  for (const dvec3 p : shape) world.add(oblique(p));
}

/// A box in an oblique view: edges of faces that look away are dashed.
inline void add_box(View& view, const Panel& panel, const std::string& id, Role role, const Shape& shape,
                    bool filled) {
  const std::vector<dvec2> at = on_paper(panel, shape);
  const dvec3 x = unit(shape[1] - shape[0]), y = unit(shape[2] - shape[0]), z = unit(shape[4] - shape[0]);
  const bool mirrored = glm::dot(x, glm::cross(y, z)) < 0;
  std::array<bool, 6> seen{};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<dvec2> ring;
    for (const std::size_t c : faces[f]) ring.push_back(at[c]);
    const double area = doubled_area(ring);
    seen[f] = mirrored ? area < 0 : area > 0;
    if (filled && seen[f]) view.add({fmt::format("a {} face {}", id, f), role, Area{{ring}}});
  }
  for (std::size_t a = 0; a < 8; ++a) {
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const std::size_t b = a | bit;
      if (b == a) continue;
      bool visible = false;
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& ring = faces[f];
        visible = visible || (seen[f] && std::ranges::count(ring, a) && std::ranges::count(ring, b));
      }
      view.add({fmt::format("b {} edge {}{}", id, a, b), role, Stroke{at[a], at[b], false, !visible}});
    }
  }
  view.add({"c " + id + " F", role, Path{{at[8], at[9], at[10]}, false, !seen[front]}});
  view.add({"c " + id + " F bar", role, Path{{at[11], at[12]}, false, !seen[front]}});
}

/// A point with its name.
inline void add_dot(View& view, const Panel& panel, const std::string& id, Role role, dvec3 at,
                    const std::string& name) {
  view.add_named("j " + id, "k " + id, role, panel.at(oblique(at)), name);
}

/// A straight line of space with a head, named.
inline void add_arrow(View& view, const Panel& panel, const std::string& id, Role role, dvec3 from, dvec3 to,
                      const std::string& name) {
  const dvec2 a = panel.at(oblique(from)), b = panel.at(oblique(to));
  if (a == b) return;
  view.add({"d " + id, role, Stroke{a, b, true}});
  if (!name.empty()) view.add({"k " + id, role, Label{0.5 * (a + b), name}});
}

/// How far the axes of space reach, for a box and what is near it.
inline double reach_of(dvec3 box) { return 1.35 * std::max({box.x, box.y, box.z}); }

inline Shape tips_of_axes(double reach) { return {{reach, 0, 0}, {0, reach, 0}, {0, 0, reach}}; }

inline void add_axes_of_space(View& view, const Panel& panel, const std::string& id, double reach,
                              const Words& words) {
  const std::vector<dvec2> tips = on_paper(panel, tips_of_axes(reach));
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 name = tips[i] + unit(tips[i] - panel.at({0, 0}));
    view.add({fmt::format("0 {} axis {}", id, i), Role::guide, Stroke{panel.at({0, 0}), tips[i], true}});
    view.add(
        {fmt::format("0 {} axis name {}", id, i), Role::guide, Text{name, words.axis(static_cast<int>(i))}});
  }
}

/// What a panel has to show at least: the axes of space and their names.
inline Extent world_of_axes(double reach) {
  Extent world;
  world.add({0, 0});
  add_to(world, tips_of_axes(1.1 * reach));
  return world;
}

/// A matrix of space, upper right.
inline void add_product(View& view, const Mat& m, Role role, const Words& words) {
  MatrixRows rows(4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) rows[static_cast<std::size_t>(y)].push_back(m[x][y]);
  }
  add_matrix(view, "m", {25, 21.1}, words.symbol("M"), rows, role);
}

}  // namespace gradus::affine_3d
