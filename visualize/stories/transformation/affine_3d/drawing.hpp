#pragma once
// A box with an F on its front, and the axes of space, as the stories of space draw them: obliquely.

#include "stories/space_drawing.hpp"
#include "stories/transformation/affine_3d/subject.hpp"

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
/// Corner A, on the front, from where the F is read.
constexpr std::size_t corner_a = 7;

inline Shape moved(const Mat& m, Shape points) {
  for (dvec3& p : points) p = transform(m, p);
  return points;
}

/// Scaled to length 1; 0 stays.
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

/// Space as a panel shows it: obliquely.
inline SpaceDrawing drawing_in(const Panel& panel) {
  return SpaceDrawing({.viewer = distant_viewer(towards_oblique),
                       .at = [&panel](dvec3 p) { return std::optional(panel.at(oblique(p))); }});
}

inline dvec3 middle_of(const Shape& shape) {
  dvec3 middle{0};
  for (std::size_t i = 0; i < 8; ++i) middle += shape[i] / 8.0;
  return middle;
}
/// A box's faces, each counter-clockwise from outside, whichever way a matrix has turned them.
inline std::vector<std::vector<dvec3>> faces_of(const Shape& shape) {
  const dvec3 middle = middle_of(shape);
  std::vector<std::vector<dvec3>> rings;
  for (const auto& face : faces_of_box()) {
    std::vector<dvec3>& ring = rings.emplace_back();
    for (const std::size_t corner : face) ring.push_back(shape[corner]);
    if (glm::dot(area_vector(ring), ring[0] - middle) < 0) std::ranges::reverse(ring);
  }
  return rings;
}

/// The edges of a box, then the lines of its F.
inline std::vector<std::pair<dvec3, dvec3>> lines_of(const Shape& shape) {
  std::vector<std::pair<dvec3, dvec3>> lines;
  for (std::size_t a = 0; a < 8; ++a) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((a & bit) == 0) lines.emplace_back(shape[a], shape[a | bit]);
    }
  }
  for (const auto& [from, to] : {std::pair{8, 9}, {9, 10}, {11, 12}})
    lines.emplace_back(shape[static_cast<std::size_t>(from)], shape[static_cast<std::size_t>(to)]);
  return lines;
}

/// A box as a solid.
inline void add_box(SpaceDrawing& space, const std::string& id, Role role, const Shape& shape) {
  int number = 0;
  for (auto& ring : faces_of(shape))
    space.add(SpaceFace{.id = fmt::format("{} {}", id, number++), .role = role, .ring = std::move(ring)});
  for (const auto& [a, b] : lines_of(shape))
    space.add(SpaceEdge{.id = fmt::format("b {} {:02}", id, number++), .role = role, .a = a, .b = b});
}

/// What a box was: the lines of it that were seen.
inline void add_outline(SpaceDrawing& space, const std::string& id, Role role, const Shape& shape) {
  const HiddenLines own(faces_of(shape), distant_viewer(towards_oblique), length_between(shape[0], shape[7]));
  int number = 0;
  for (const auto& [a, b] : lines_of(shape)) {
    for (const auto& [from, to, hidden] : own.pieces(a, b)) {
      if (hidden) continue;
      space.add(SpaceEdge{.id = fmt::format("b {} {:02}", id, number++),
                          .role = role,
                          .a = a + from * (b - a),
                          .b = a + to * (b - a),
                          .thin = true,
                          .behind = false});
    }
  }
}

/// The box that is given, as a solid without its hidden lines.
inline void add_given(SpaceDrawing& space, const std::string& id, const Shape& shape) {
  int number = 0;
  for (auto& ring : faces_of(shape)) {
    space.add(
        SpaceFace{.id = fmt::format("{} {}", id, number++), .role = Role::input, .ring = std::move(ring)});
  }
  add_outline(space, id, Role::input, shape);
}

/// A box far from the origin, drawn nearer: beyond `far` ever less of its way there is left, at last as much
/// again.
inline Shape nearer(Shape shape, double far) {
  const dvec3 middle = middle_of(shape);
  const double away = length_between(dvec3(0), middle);
  if (away <= far) return shape;
  const double part = far / away * (2 - far / away);
  for (dvec3& p : shape) p += (part - 1) * middle;
  return shape;
}
/// The way from the origin to what is drawn nearer, with a break across it.
inline void add_broken_way(View& view, const Panel& panel, const std::string& id, dvec3 to,
                           const std::string& words) {
  const dvec2 a = panel.at({0, 0}), b = panel.at(oblique(to)), middle = 0.5 * (a + b);
  view.add({"c way " + id, Role::guide, Stroke{a, b, false, true}});
  add_break(view, "c break " + id, Role::guide, middle, unit(b - a));
  view.add({"k break " + id, Role::guide, Label{middle, words}});
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

constexpr int paper_width = 37, paper_height = 28;
/// Of a slide: in smaller units the rows of a matrix of space would lie on each other.
constexpr double least_unit_of_four_rows = 14.4;
/// Where space is drawn: alone, beside the matrix, or twice, each below its own.
constexpr Extent whole_place{{0.8, 2.2}, {35.2, 24.4}}, single_place{{0.4, 0.8}, {18, 24.2}},
    left_place{{0.3, 0}, {17.7, 18.8}}, right_place{{18.3, 0}, {35.7, 18.8}};

inline Shape tips_of_axes(dvec3 reach) { return {{reach.x, 0, 0}, {0, reach.y, 0}, {0, 0, reach.z}}; }

inline void add_axes_of_space(View& view, SpaceDrawing& space, const Panel& panel, const std::string& id,
                              dvec3 reach, const Words& words) {
  const Shape tips = tips_of_axes(reach);
  const std::vector<dvec2> at = on_paper(panel, tips);
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 name = at[i] + unit(at[i] - panel.at({0, 0}));
    space.add(SpaceEdge{.id = fmt::format("0 {} axis {}", id, i),
                        .role = Role::guide,
                        .a = dvec3{0},
                        .b = tips[i],
                        .arrow = true,
                        .behind = false});
    view.add(
        {fmt::format("0 {} axis name {}", id, i), Role::guide, Text{name, words.axis(static_cast<int>(i))}});
  }
}

/// What a panel has to show at least: the axes of space and their names.
inline Extent world_of_axes(dvec3 reach) {
  Extent world;
  world.add({0, 0});
  add_to(world, tips_of_axes(1.08 * reach));
  return world;
}

/// As the reader's notation has it.
inline MatrixRows rows_of(const Mat& m, const Words& words) {
  MatrixRows rows(4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) rows[static_cast<std::size_t>(y)].push_back(m[x][y]);
  }
  return oriented(words.wording(), std::move(rows));
}

/// A matrix of space below its name, in the middle of a part of the paper this wide; `top` is where its name
/// stands. What is too wide has fewer decimals; numbers too long for any are left to the steps.
inline void add_product(View& view, const std::string& id, dvec2 top, double wide, const Mat& m,
                        const std::string& name, Role role, const Words& words) {
  const MatrixRows rows = gradus::fitted(rows_of(m, words), wide);
  view.add({id + " name", role, Text{top, name, Align::centre, true}});
  const dvec2 size = matrix_size(rows);
  if (size.x <= wide) add_matrix(view, id, top + dvec2{size.x / 2, -0.9 - size.y / 2}, "", rows, role, true);
}

}  // namespace gradus::affine_3d
