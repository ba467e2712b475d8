#pragma once
// What the engine keeps of a scene from picture to picture: its faces as triangles of vertex numbers, and
// its textures in linear light. Nothing in it depends on a camera.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/mesh.hpp"
#include "engine/pieces_batch.hpp"
#include "scene/scene.hpp"
#include "scene/shared_planes.hpp"
#include "stages/textures.hpp"

namespace gradus::pipeline::engine {

/// A piece of a face, which of its face's corners it has, and what shading asks for, side by side.
struct MeshPiece {
  std::int32_t face = 0, piece = 0, material = 0;
  std::array<std::int32_t, 3> corners{};  ///< counted from the face's first
  std::array<std::int32_t, 3> normals{};  ///< of the mesh; -1 - i: the i-th of MeshPieces::flat_normals
  std::array<std::int32_t, 3> textures{};
};

/// The pieces of a mesh, in the order of stage 1.
struct MeshPieces {
  std::vector<PieceVertices> vertices;
  std::vector<MeshPiece> of_faces;
  std::vector<dvec3> flat_normals{};  ///< of faces with corners without normals
  SharedPlanes shared{};              ///< of pieces

  std::int64_t count() const { return std::ssize(vertices); }
};

/// The buffers of a scene. The scene's meshes and materials must outlive them and stay as they are.
struct Buffers {
  std::vector<std::shared_ptr<const MeshPieces>> pieces;  ///< by object; objects of one mesh share them
  LinearTextures textures;
};

/// Stage 1 for all objects, and every texture with its levels.
///
/// Domain: coordinates are finite.
/// Accuracy: the pieces of `input`, in its order.
/// Cost: ear clipping for faces of more than 3 corners, and shared_planes; memory of 60 bytes per piece of a
/// mesh, 16 bytes per texel. Errors: ContractViolation for coordinates that are not finite, in faces of more
/// than 3 corners.
Buffers buffers_of(const Scene& scene);

}  // namespace gradus::pipeline::engine
