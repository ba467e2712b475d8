#include "scene/models/subdivided.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "modeling/mesh_structures/mesh_structures.hpp"
#include "modeling/subdivision_surface/subdivision_surface_batch.hpp"

namespace gradus::pipeline {
namespace {

/// What the corners of a face carry besides their places: none, or one each.
using FaceTextures = std::vector<dvec2>;

std::vector<FaceTextures> textures_of(const Mesh& mesh) {
  std::vector<FaceTextures> all;
  for (const MeshFace& face : mesh.faces) {
    FaceTextures own;
    for (const Corner& corner : corners_of(mesh, face)) {
      if (corner.texture >= 0) own.push_back(mesh.textures[static_cast<std::size_t>(corner.texture)]);
    }
    if (own.size() != corners_of(mesh, face).size()) own.clear();
    all.push_back(std::move(own));
  }
  return all;
}

/// Those of the quadrilaterals that a face becomes, in their order.
void add_quads(const FaceTextures& of, std::vector<FaceTextures>& all, std::size_t corners) {
  dvec2 middle{0};
  for (const dvec2 at : of) middle += at / static_cast<double>(of.size());
  for (std::size_t i = 0; i < corners; ++i) {
    if (of.empty()) {
      all.emplace_back();
      continue;
    }
    const dvec2 at = of[i], next = of[(i + 1) % corners], before = of[(i + corners - 1) % corners];
    all.push_back({at, 0.5 * (at + next), middle, 0.5 * (at + before)});
  }
}

/// Its faces, and of its positions those that are corners of some.
subdivision_surface::Surface<double> surface_of(const Mesh& mesh) {
  subdivision_surface::Surface<double> surface;
  std::vector<std::int32_t> numbers(mesh.positions.size(), -1);
  for (const MeshFace& face : mesh.faces) {
    std::vector<std::int32_t> ring;
    for (const Corner& corner : corners_of(mesh, face)) {
      std::int32_t& number = numbers[static_cast<std::size_t>(corner.position)];
      if (number < 0) {
        number = static_cast<std::int32_t>(surface.points.size());
        surface.points.push_back(position_of(mesh, corner));
      }
      ring.push_back(number);
    }
    surface.faces.add(ring);
  }
  return surface;
}

}  // namespace

Mesh subdivided(const Mesh& control, int levels) {
  auto surface = subdivision_surface::catmull_clark_batch(surface_of(control), levels);
  std::vector<FaceTextures> textures = textures_of(control);
  std::vector<MeshFace> parents = control.faces;
  for (int level = 0; level < levels; ++level) {
    std::vector<FaceTextures> finer;
    std::vector<MeshFace> theirs;
    for (std::size_t f = 0; f < textures.size(); ++f) {
      // A face of n corners makes n quadrilaterals
      const auto corners = static_cast<std::size_t>(level == 0 ? control.faces[f].count : 4);
      add_quads(textures[f], finer, corners);
      theirs.insert(theirs.end(), corners, parents[f]);
    }
    textures = std::move(finer);
    parents = std::move(theirs);
  }
  Mesh mesh;
  mesh.positions = std::move(surface.points);
  mesh.materials = control.materials;
  mesh.files = control.files;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::vector<Corner> corners;
    for (const std::int32_t vertex : surface.faces[f]) {
      const bool textured = !textures[f].empty();
      if (textured) mesh.textures.push_back(textures[f][corners.size()]);
      corners.push_back({vertex, textured ? static_cast<int>(mesh.textures.size()) - 1 : -1});
    }
    add_face(mesh, corners, parents[f].material, parents[f].file, parents[f].line);
  }
  add_missing_normals(mesh);
  return mesh;
}

std::optional<std::string> why_not_subdivided(const Mesh& control) {
  using namespace mesh_structures;
  const auto surface = surface_of(control);
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const auto ring = surface.faces[f];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (std::ranges::count(ring.first(i), ring[i]) > 0) return "a face that has a corner twice";
    }
  }
  std::optional<std::string> problem;
  const auto watch = [&problem]<class Step>(const Step& step) {
    if constexpr (std::is_same_v<Step, EdgeJoined>) {
      if (step.fit == Fit::crowded) problem = fmt::format("an edge of {} faces", step.sides.size());
      if (step.fit == Fit::same_way) problem = "two faces that run along an edge the same way";
    }
  };
  const auto mesh = half_edges(surface.faces, surface.points.size(), watch);
  for (std::size_t v = 0; mesh && v < surface.points.size(); ++v) {
    if (mesh->fans[static_cast<Index>(v)].size() > 1) problem = "faces that meet in a corner alone";
  }
  return problem;
}

}  // namespace gradus::pipeline
