#pragma once
// Stages 2 to 5 in batches: each vertex goes through the camera once, by the functions of the stages; only
// pieces with a vertex beyond a plane are clipped.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/buffers.hpp"
#include "plan/plan.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline::engine {

/// A vertex in the world, in clip space and, where it is inside of all planes, in the picture.
struct FrameVertex {
  dvec3 world{0};
  glm::dvec4 clip{0};
  double depth = 0;  ///< after division
  ivec2 grid{0};     ///< in 1/256 pixel
  bool inside = false;
};

/// An object that is drawn, and where its vertices and pieces begin among those of all.
struct FrameObject {
  int number = 0;
  std::int64_t first_vertex = 0, first_piece = 0;
  std::span<const MeshPiece> pieces;
  glm::dmat3 normal_matrix{1};
  bool mirrored = false;  ///< the placement mirrors: the order of corners is reversed
};

/// A triangle that covers something, as pixels ask for it.
struct FrameTriangle {
  triangle_coverage::Triangle grid;
  dvec3 depth{0};
  std::int32_t object = 0;  ///< place among the frame's
  std::int32_t piece = 0;   ///< of the object's mesh; of a triangle that was cut: its place among those
  bool cut = false;
  bool seen_from_behind = false;
};

/// What came of some of the pieces, in their order.
struct Batch {
  std::vector<FrameTriangle> triangles;
  std::vector<Triangle> cut;  ///< what clipping left of pieces that reach beyond a plane
  /// The triangles that may touch a tile: places in `triangles` from first[tile] up to first[tile + 1].
  std::vector<std::int32_t> first, in_tile;
};

/// Pieces of a batch.
inline constexpr std::int64_t batch_pieces = 4096;
/// Triangles of a batch, at most: clipping by six planes makes up to seven of a piece.
inline constexpr std::int64_t batch_triangles = 1 << 15;

/// All that is drawn of a scene in one picture.
struct Frame {
  std::vector<FrameObject> objects;
  std::vector<FrameVertex> vertices;
  std::vector<Batch> batches;

  const FrameTriangle& triangle(std::int32_t id) const {
    return batches[static_cast<std::size_t>(id / batch_triangles)]
        .triangles[static_cast<std::size_t>(id % batch_triangles)];
  }
};

/// Stages 2 to 5 for the objects that a plan draws. Triangles are numbered by batch and place, which is the
/// order of stage 5. Runs on the threads of the arena that it is called in.
///
/// Domain, Errors: those of the stages.
/// Accuracy: the triangles of `clip` that stage 6 draws, to the bit.
/// Cost: a vertex 88 bytes, a triangle 72, a triangle that was cut 400.
Frame frame_of(const Scene& scene, const Buffers& buffers, const Plan& plan);

/// A triangle of a frame with all that shading asks for: one of those that `clip` gives.
Triangle whole_triangle(const Scene& scene, const Frame& frame, std::int32_t id);

}  // namespace gradus::pipeline::engine
