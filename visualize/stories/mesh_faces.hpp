#pragma once
// The faces of a mesh on the paper, lit by where they look: those that look to the reader, the far ones
// first, so that the near ones cover them.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "stories/solid_drawing.hpp"
#include "stories/wireframe.hpp"

namespace gradus {

/// How a mesh is looked at.
struct MeshLook {
  SightFrom sight;
  dvec3 right{1, 0, 0}, up{0, 1, 0}, towards{0, 0, 1};  ///< the reader's, in the mesh's space
  bool both_sides = false;                              ///< the mesh is open: backs are seen, too

  /// A normal as the reader has it.
  dvec3 turned(dvec3 normal) const {
    return {glm::dot(normal, right), glm::dot(normal, up), glm::dot(normal, towards)};
  }
};

/// at(p): a point's place on the paper, or nothing where it has none; a face with such a corner is left out.
/// frame: what lies beyond it is cut off.
template <class At>
void add_mesh_faces(View& view, const std::string& id, Role role, const Mesh& mesh, const MeshLook& look,
                    const Extent& frame, At at) {
  std::vector<std::pair<double, const MeshFace*>> faces;
  for (const MeshFace& face : mesh.faces) {
    dvec3 middle{0};
    for (const Corner& corner : corners_of(mesh, face))
      middle += position_of(mesh, corner) / static_cast<double>(face.count);
    const auto [direction, far] = look.sight(middle);
    if (!look.both_sides && glm::dot(area_vector(mesh, face), direction) <= 0) continue;
    faces.emplace_back(glm::dot(middle, look.towards), &face);
  }
  std::ranges::sort(faces, {}, [](const auto& face) { return face.first; });
  const AxisBox<2, double> window{frame.lower, frame.upper};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<dvec2> ring;
    bool whole = true;
    for (const Corner& corner : corners_of(mesh, *faces[i].second)) {
      const std::optional<dvec2> p = at(position_of(mesh, corner));
      whole = whole && p;
      if (p) ring.push_back(*p);
    }
    if (!whole) continue;
    std::vector<dvec2> shown;
    for (const auto& corner : sutherland_hodgman::clip_to_window(ring, window)) shown.push_back(corner.at);
    if (shown.size() < 3) continue;
    const int shade = shade_of(look.turned(area_vector(mesh, *faces[i].second)));
    view.add({fmt::format("{} face {:05}", id, i), role, Area{{std::move(shown)}, shade}});
  }
}

}  // namespace gradus
