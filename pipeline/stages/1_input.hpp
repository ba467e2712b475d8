#pragma once
// Stage 1, input model: the vertices of every object, and its faces cut into triangles.

#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "core/contract.hpp"
#include "core/mesh.hpp"
#include "core/observe.hpp"
#include "scene/models/triangles.hpp"
#include "scene/scene.hpp"
#include "scene/shared_planes.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A vertex of an object came in.
struct VertexRead {
  VertexId id;
  ObjectPoint point;
};

/// A face came in, and was cut into pieces.
struct FaceRead {
  int object, face;
  std::vector<int> vertices;  ///< of its object, in order
  std::vector<Piece> pieces;  ///< one less than corners - 1
  int material;
  int file, line;  ///< where the face stands; file -1: in none
};

/// The normal, flat, of a face whose corner lacks one.
inline dvec3 flat_normal(const Mesh& mesh, const MeshFace& face) {
  return unit_vector(area_vector(mesh, face, unit_scale(bounds_of(mesh, face))));
}

/// A corner with what its face gives it. first: where its object's vertices begin.
inline PieceCorner corner_of(const Mesh& mesh, const MeshFace& face, int i, int first) {
  const Corner& corner = corners_of(mesh, face)[static_cast<std::size_t>(i)];
  return {first + corner.position,
          corner.normal < 0 ? flat_normal(mesh, face) : mesh.normals[static_cast<std::size_t>(corner.normal)],
          corner.texture < 0 ? dvec2{0, 0} : mesh.textures[static_cast<std::size_t>(corner.texture)]};
}

/// The triangles of a face, as pieces.
inline std::vector<Piece> cut(const Mesh& mesh, PieceId id, int first) {
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(id.face)];
  std::vector<Piece> pieces;
  triangulate(mesh, face, [&](const ear_clipping::Triangle& t) {
    pieces.push_back({id,
                      {corner_of(mesh, face, t[0], first), corner_of(mesh, face, t[1], first),
                       corner_of(mesh, face, t[2], first)}});
    ++id.piece;
  });
  return pieces;
}

/// What is told of a face.
inline FaceRead face_read(const Mesh& mesh, int object, int id, const std::vector<Piece>& pieces) {
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(id)];
  std::vector<int> vertices;
  for (const Corner& corner : corners_of(mesh, face)) vertices.push_back(corner.position);
  return {object, id, vertices, pieces, face.material, face.file, face.line};
}

/// Tells the pieces of an object, from `first` on, which planes they share.
inline void share_planes(const Mesh& mesh, int first_vertex, std::size_t first, Model<ObjectPoint>& model) {
  const auto pieces = std::span(model.pieces).subspan(first);
  std::vector<Triple> triangles;
  triangles.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    const auto& [a, b, c] = piece.corners;
    triangles.push_back({a.vertex - first_vertex, b.vertex - first_vertex, c.vertex - first_vertex});
  }
  const SharedPlanes shared = shared_planes(mesh.positions, triangles);
  const int first_plane = size_of(model.planes);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (shared.of[i] != SharedPlanes::none) pieces[i].plane = first_plane + shared.of[i];
  for (const auto& [a, b, c] : shared.planes)
    model.planes.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
}

/// Brings in one object: its vertices, then the pieces of its faces.
/// Steps: VertexRead* FaceRead*.
template <Observer<VertexRead, FaceRead> O = Unobserved>
void bring_in(const Mesh& mesh, int object, Model<ObjectPoint>& model, O&& observer = {}) {
  // Its faces count them from here
  int v = size_of(model.vertices);
  int vertex = 0;
  for (dvec3 at : mesh.positions) {
    VertexId id{object, vertex++};
    model.add(id, {at});
    if constexpr (observed<O>) observer(VertexRead{id, {at}});
  }
  // Larger faces lose their ears
  int faces = size_of(mesh.faces);
  auto n = model.pieces.size();
  for (int i = 0; i < faces; ++i) {
    const PieceId id{object, i, 0};
    auto pieces = cut(mesh, id, v);
    append(model.pieces, pieces);
    if constexpr (observed<O>) observer(face_read(mesh, object, i, pieces));
  }
  // One depth for all in a plane
  share_planes(mesh, v, n, model);
}

/// Brings in every object of the scene, in order.
///
/// Domain: coordinates are finite.
/// Steps: (VertexRead* FaceRead*)*, for each object.
/// Accuracy: coordinates are copied.
/// Cost: the size of the model, ear clipping for faces of more than 3 corners, and shared_planes.
/// Errors: ContractViolation for coordinates that are not finite, in faces of more than 3 corners.
template <Observer<VertexRead, FaceRead> O = Unobserved>
Model<ObjectPoint> input(const Scene& scene, O&& observer = {}) {
  Model<ObjectPoint> model;
  int number = 0;
  for (const Object& object : scene.objects) {
    bring_in(*object.mesh, number, model, observer);
    ++number;
  }
  return model;
}

}  // namespace gradus::pipeline
