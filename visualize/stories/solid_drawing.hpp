#pragma once
// Convex solids on the paper: faces lit by where they look, hidden edges thin and dashed, and where two lines
// of space cross a gap in the one behind.

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stories/space_drawing.hpp"

namespace gradus {

/// Corners of a face, counter-clockwise from outside.
using SolidFace = std::vector<std::size_t>;

/// A convex solid as it is drawn.
struct FlatSolid {
  std::vector<dvec2> corners;  ///< on the paper
  std::vector<SolidFace> faces;
  std::vector<int> shades;  ///< one a face
};

inline dvec3 normal_of(const std::vector<dvec3>& corners, const SolidFace& face) {
  const dvec3 a = corners[face[0]];
  return glm::cross(corners[face[1]] - a, corners[face[2]] - a);
}

/// corners: as the reader has them: right, up, towards him. faces: their corners may run either way.
/// at(p): a corner's place on the paper.
template <class At>
FlatSolid flat_solid(const std::vector<dvec3>& corners, std::vector<SolidFace> faces, At at) {
  FlatSolid flat;
  dvec3 middle{0};
  for (const dvec3 p : corners) {
    flat.corners.push_back(at(p));
    middle += p / static_cast<double>(corners.size());
  }
  for (SolidFace& face : faces) {
    if (glm::dot(normal_of(corners, face), corners[face[0]] - middle) < 0) std::ranges::reverse(face);
    flat.shades.push_back(shade_of(normal_of(corners, face)));
  }
  flat.faces = std::move(faces);
  return flat;
}

/// The faces of a box whose corner i lies at x, y, z = its bits 0, 1, 2.
inline std::vector<SolidFace> faces_of_box() {
  return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}

/// Twice the area inside a ring, negative where it runs clockwise.
inline double doubled_area(const std::vector<dvec2>& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 p = ring[i] - ring[0], q = ring[(i + 1) % ring.size()] - ring[0];
    area += p.x * q.y - q.x * p.y;
  }
  return area;
}

inline std::vector<dvec2> ring_of(const FlatSolid& solid, const SolidFace& face) {
  std::vector<dvec2> ring;
  for (const std::size_t corner : face) ring.push_back(solid.corners[corner]);
  return ring;
}

/// Whether a face looks to the reader: its corners run counter-clockwise. One that is but a line does not.
inline bool is_seen(const FlatSolid& solid, const SolidFace& face) {
  return doubled_area(ring_of(solid, face)) > 1e-9;
}

/// An edge, and whether it lies behind the solid: no face beside it looks to the reader.
struct FlatEdge {
  std::size_t a, b;
  bool hidden;
};
inline std::vector<FlatEdge> edges_of(const FlatSolid& solid) {
  std::map<std::pair<std::size_t, std::size_t>, bool> hidden;
  for (const SolidFace& face : solid.faces) {
    const bool seen = is_seen(solid, face);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto ends = std::minmax(face[i], face[(i + 1) % face.size()]);
      const auto [edge, first] = hidden.try_emplace({ends.first, ends.second}, true);
      if (seen) edge->second = false;
    }
  }
  std::vector<FlatEdge> edges;
  for (const auto& [ends, behind] : hidden) edges.push_back({ends.first, ends.second, behind});
  return edges;
}

/// The faces that look to the reader.
inline void add_faces(View& view, const std::string& id, Role role, const FlatSolid& solid) {
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    if (!is_seen(solid, solid.faces[i])) continue;
    view.add(
        {fmt::format("{} face {}", id, i), role, Area{{ring_of(solid, solid.faces[i])}, solid.shades[i]}});
  }
}

/// A straight line of space on the paper.
struct SpaceLine {
  std::string id;
  Role role;
  dvec2 a, b;
  double near_a, near_b;  ///< how near to the reader the ends are: the nearer, the greater
  bool dashed = false;
  bool thin = false;   ///< then it is crossed without a gap
  bool arrow = false;  ///< a head at b
};

/// Where two lines cross, as parts of their lengths; nothing where they do not, or meet at an end.
struct LineCrossing {
  double of_first, of_second;
};
inline std::optional<LineCrossing> crossing_of(const SpaceLine& first, const SpaceLine& second) {
  const dvec2 d = first.b - first.a, e = second.b - second.a, way = second.a - first.a;
  const double turn = d.x * e.y - d.y * e.x;
  const double lengths = length_between(first.a, first.b) * length_between(second.a, second.b);
  if (std::abs(turn) <= 0.05 * lengths) return std::nullopt;
  const LineCrossing found{(way.x * e.y - way.y * e.x) / turn, (way.x * d.y - way.y * d.x) / turn};
  const auto inside = [](double part) { return 0.01 < part && part < 0.99; };
  if (!inside(found.of_first) || !inside(found.of_second)) return std::nullopt;
  return found;
}

/// A short piece of the line round this part of its length, with a gap on both sides of it.
inline Mark gap_at(const SpaceLine& line, double part, std::string id) {
  constexpr double half = 0.55;  // of the piece, in units of the paper
  const double length = length_between(line.a, line.b), reach = half / length;
  const double from = std::max(0.0, part - reach), to = std::min(1.0, part + reach);
  Stroke piece{line.a + from * (line.b - line.a), line.a + to * (line.b - line.a), false, line.dashed};
  piece.gap = true;
  return {std::move(id), line.role, piece};
}

/// Lines of space; where two cross, the nearer one passes with a gap on both sides.
/// gaps: begins the ids of these, which must come behind those of the lines.
inline void add_lines(View& view, const std::string& gaps, const std::vector<SpaceLine>& lines) {
  for (const SpaceLine& line : lines) {
    Stroke stroke{line.a, line.b, line.arrow, line.dashed};
    stroke.thin = line.thin;
    view.add({line.id, line.role, stroke});
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      const SpaceLine &first = lines[i], &second = lines[k];
      if (first.thin || second.thin) continue;
      const std::optional<LineCrossing> at = crossing_of(first, second);
      if (!at) continue;
      const double ahead = first.near_a + at->of_first * (first.near_b - first.near_a) -
                           (second.near_a + at->of_second * (second.near_b - second.near_a));
      if (std::abs(ahead) < 1e-6) continue;  // they meet
      const std::string id = fmt::format("{} {} {}", gaps, first.id, second.id);
      view.add(ahead > 0 ? gap_at(first, at->of_first, id) : gap_at(second, at->of_second, id));
    }
  }
}

/// A solid's edges as lines of space; near(i): how near corner i is.
template <class Near>
void append_edges(std::vector<SpaceLine>& lines, const std::string& id, Role role, const FlatSolid& solid,
                  Near near) {
  for (const auto& [a, b, hidden] : edges_of(solid)) {
    lines.push_back({fmt::format("{} {} {:02} {:02}", id, hidden ? "behind" : "edge", a, b), role,
                     solid.corners[a], solid.corners[b], near(a), near(b), hidden, hidden});
  }
}

}  // namespace gradus
