#pragma once
// A box with an F on its front, and the axes of space, as the stories of space draw them: obliquely.

#include "stories/solid_drawing.hpp"
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
constexpr std::size_t front = 1;  ///< of its faces, the one with the F
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

inline std::vector<dvec2> on_paper(const Panel& panel, const Shape& shape) {
  std::vector<dvec2> points;
  for (const dvec3 p : shape) points.push_back(panel.at(oblique(p)));
  return points;
}
inline void add_to(Extent& world, const Shape& shape) {
  for (const dvec3 p : shape) world.add(oblique(p));
}

/// How a box is drawn: as a solid, or as what it was, by the edges that are seen.
enum class BoxLook { solid, outline };

/// A box in an oblique view: its faces and its F are added, its edges appended to the lines of space.
inline void add_box(View& view, std::vector<SpaceLine>& lines, const Panel& panel, const std::string& id,
                    Role role, const Shape& shape, BoxLook look) {
  const std::vector<dvec3> corners(shape.begin(), shape.begin() + 8);
  const FlatSolid solid = flat_solid(corners, faces_of_box(), [&](dvec3 p) { return panel.at(oblique(p)); });
  const bool filled = look == BoxLook::solid, f_seen = is_seen(solid, solid.faces[front]);
  if (filled) add_faces(view, "a " + id, role, solid);
  std::vector<SpaceLine> edges;
  append_edges(edges, "b " + id, role, solid, [&](std::size_t i) { return corners[i].z; });
  for (SpaceLine& edge : edges) {
    if (!filled && edge.dashed) continue;
    edge.thin = edge.thin || !filled;
    lines.push_back(edge);
  }
  if (!filled && !f_seen) return;
  const auto f = on_paper(panel, {shape.begin() + 8, shape.end()});
  if (filled && f_seen) {
    view.add({"c " + id + " F", role, Path{{f[0], f[1], f[2]}}});
    view.add({"c " + id + " F bar", role, Path{{f[3], f[4]}}});
    return;
  }
  for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {3, 4}}) {
    Stroke stroke{f[static_cast<std::size_t>(from)], f[static_cast<std::size_t>(to)], false, !f_seen};
    stroke.thin = true;
    view.add({fmt::format("c {} F {}", id, from), role, stroke});
  }
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
inline double reach_of(dvec3 box) { return 1.2 * std::max({box.x, box.y, box.z}); }

constexpr int paper_width = 36, paper_height = 24;
/// Where space is drawn: alone, beside the matrix, or twice, below it.
constexpr Extent whole_place{{0.8, 2.2}, {35.2, 23.4}}, single_place{{0.8, 2}, {19, 22}},
    left_place{{0.8, 2}, {17.4, 15}}, right_place{{18.6, 2}, {35.2, 15}};

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
inline void add_product(View& view, const Mat& m, const Words& words) {
  MatrixRows rows(4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) rows[static_cast<std::size_t>(y)].push_back(m[x][y]);
  }
  add_matrix(view, "m", {35.2, 19.2}, words.symbol("M"), oriented(words.wording(), std::move(rows)),
             Role::input);
}

}  // namespace gradus::affine_3d
