#pragma once
// What the engine keeps of a scene from picture to picture: its faces as triangles of vertex numbers, and
// its textures in linear light. Nothing in it depends on a camera.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/mesh.hpp"
#include "scene/scene.hpp"
#include "stages/textures.hpp"

namespace gradus::pipeline::engine {

/// A piece of a face: which of its face's corners it has, and their vertices.
struct MeshPiece {
  std::int32_t face = 0, piece = 0;
  std::array<std::int32_t, 3> corners;   ///< of the face
  std::array<std::int32_t, 3> vertices;  ///< of the mesh
};

/// The buffers of a scene. The scene's meshes and materials must outlive them and stay as they are.
struct Buffers {
  /// By object: the pieces of its mesh, which objects of one mesh share.
  std::vector<std::shared_ptr<const std::vector<MeshPiece>>> pieces;
  LinearTextures textures;
};

/// Stage 1 for all objects, and every texture with its levels.
///
/// Domain: coordinates are finite.
/// Accuracy: the pieces of `input`, in its order.
/// Cost: ear clipping for faces of more than 3 corners; memory of 32 bytes a piece and mesh, 16 bytes a
/// texel. Errors: ContractViolation for coordinates that are not finite, in faces of more than 3 corners.
Buffers buffers_of(const Scene& scene);

}  // namespace gradus::pipeline::engine
