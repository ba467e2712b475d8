#pragma once
// Shapes of the tour's drawings: parts of polygons that can be drawn, and edges of faces in parts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/axis_cut.hpp"
#include "stories/paper.hpp"
#include "stories/pipeline/textbook_chain/solid_cells.hpp"

namespace gradus::textbook_chain {

/// Models with more faces are drawn without edges, which would only hide them.
inline constexpr std::size_t most_faces = 100;

inline std::string padded(std::string_view name, int number) { return fmt::format("{} {:05}", name, number); }

/// The part of a polygon with w >= least as points (x / w, y / w, z / w): for drawing what lies before the
/// eye.
inline std::vector<dvec3> before_eye(const std::vector<glm::dvec4>& corners, double least) {
  std::vector<dvec3> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec4 a = corners[i], b = corners[(i + 1) % corners.size()];
    if (a.w >= least) points.emplace_back(dvec3(a) / a.w);
    if ((a.w < least) == (b.w < least)) continue;
    const glm::dvec4 cut = a + (least - a.w) / (b.w - a.w) * (b - a);
    points.emplace_back(dvec3(cut) / least);
  }
  return points;
}

/// A polygon as far as it lies round the paper: what divides by next to nothing flies off.
inline std::vector<dvec2> near_paper(const std::vector<dvec2>& points) {
  constexpr double far = 1e6;
  const auto flies = [](dvec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > far; };
  if (std::ranges::none_of(points, flies)) return points;
  const AxisBox<2, double> room{{-far, -far}, {far, far}};
  std::vector<dvec2> kept;
  for (const auto& corner : sutherland_hodgman::clip_to_window(points, room)) kept.push_back(corner.at);
  return kept;
}

inline bool has_edge(const SolidPart& part, dvec3 a, dvec3 b) {
  const auto same = [](dvec3 p, dvec3 q) { return length_between(p, q) < 1e-9; };
  const auto& ring = part.ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (same(ring[i], a) && same(ring[(i + 1) % ring.size()], b)) return true;
  }
  return false;
}

/// The edges of the parts of faces but for those between two parts of one.
inline std::vector<std::pair<dvec3, dvec3>> rims_of(const std::vector<SolidPart>& parts) {
  std::vector<std::pair<dvec3, dvec3>> rims;
  for (const auto& [face, ring, followed] : parts) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
      const auto goes_on = [&](const SolidPart& part) { return part.face == face && has_edge(part, b, a); };
      if (std::ranges::none_of(parts, goes_on)) rims.emplace_back(a, b);
    }
  }
  return rims;
}

}  // namespace gradus::textbook_chain
