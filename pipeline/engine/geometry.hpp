#pragma once
// Stages 2 to 5 in batches: each vertex goes through the camera once, pieces are chosen by whole numbers, and
// only those with a vertex beyond a plane are clipped.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/buffers.hpp"
#include "engine/vertices_batch.hpp"
#include "plan/plan.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"
#include "scene/scene.hpp"
#include "stages/5_clipping.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline::engine {

/// An object that is drawn, and where its vertices, pieces and shared planes begin among those of all.
struct FrameObject {
  int number = 0;
  std::int64_t first_vertex = 0, first_piece = 0, first_plane = 0;
  const MeshPieces* pieces = nullptr;
  glm::dmat3 normal_matrix{1};
  bool mirrored = false;  ///< the placement mirrors: the order of corners is reversed
  bool two_sided = false;
};

/// A triangle that covers something, as pixels ask for it.
struct FrameTriangle {
  triangle_coverage::Triangle grid;
  dvec3 depth{0};
  std::int32_t object = 0;  ///< place among the frame's
  std::int32_t piece = 0;   ///< of the object's mesh; of a triangle that was cut: its place among those
  bool cut = false;
  bool seen_from_behind = false;
  std::int32_t plane = no_plane;  ///< place among the frame's, where it has the depths of a shared one
};

/// What came of some of the pieces, in the order of the frame's objects and of theirs.
struct Batch {
  PieceCount count;               ///< of all pieces, but for those that were clipped away
  std::int64_t clipped = 0;       ///< pieces with corners on both sides of a plane
  std::int64_t clipped_away = 0;  ///< of those the ones of which nothing was left
  std::int64_t more = 0;          ///< triangles beyond one per piece that clipping has made
  std::vector<FrameTriangle> triangles;
  std::vector<Triangle> cut;  ///< what clipping left of pieces that reach beyond a plane
  /// The triangles that may touch a tile: places in `triangles` from first[tile] up to first[tile + 1].
  std::vector<std::int32_t> first, in_tile;
};

/// Pieces of a batch.
inline constexpr std::int64_t batch_pieces = 4096;
/// Triangles of a batch, at most: clipping by six planes makes up to seven of a piece.
inline constexpr std::int64_t batch_triangles = 1 << 15;

/// The pixels that a triangle is asked for by.
enum class Touch {
  centres,     ///< those in its box by their centres
  neighbours,  ///< all that its box meets, and those beside them
};

/// The pixels of a window that the box of a triangle touches.
Window touched(const triangle_coverage::Triangle& triangle, const Window& window, Touch touch);

/// The pixels of a window whose squares the box of a triangle touches.
inline Window squares_of(const triangle_coverage::Triangle& t, const Window& window) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return intersection({{left >> 8, top >> 8}, {right >> 8, bottom >> 8}}, window);
}

/// All that is drawn of a scene in one picture. Its memory can serve the next one.
struct Frame {
  VertexPath path;
  std::vector<FrameObject> objects;
  std::vector<ivec2> grid;         ///< of all vertices: see place_vertices
  std::vector<double> depths;      ///< of the same
  std::vector<PlaneDepth> planes;  ///< that triangles share
  std::vector<Batch> batches;

  const FrameTriangle& triangle(std::int32_t id) const {
    return batches[static_cast<std::size_t>(id / batch_triangles)]
        .triangles[static_cast<std::size_t>(id % batch_triangles)];
  }
  /// What a triangle is that was cut.
  const Triangle& cut_triangle(std::int32_t id) const {
    return batches[static_cast<std::size_t>(id / batch_triangles)]
        .cut[static_cast<std::size_t>(triangle(id).piece)];
  }
  const FrameObject& object_of(const FrameTriangle& t) const {
    return objects[static_cast<std::size_t>(t.object)];
  }
  /// The shared plane that a triangle has its depths from.
  PlaneDepth plane_of(const FrameTriangle& t) const {
    return t.plane == no_plane ? PlaneDepth{} : planes[static_cast<std::size_t>(t.plane)];
  }
};

/// How deep a triangle is at places of the picture.
inline triangle_coverage::Depth depth_of(const Frame& frame, const FrameTriangle& t) {
  return triangle_coverage::Depth({t.grid, t.depth, frame.plane_of(t)});
}

/// Stages 2 to 5 for the objects that a plan draws. Triangles are numbered by batch and place: those of an
/// object in the order of stage 5, objects from front to back. Runs on the threads of the arena that it is
/// called in.
///
/// touch: triangles that touch no pixel of the plan's window so are left out. frame: is made anew.
///
/// Domain, Errors: those of the stages.
/// Accuracy: the triangles of `clip` that stage 6 draws, to the bit.
/// Cost: memory of 16 bytes per vertex, 64 per triangle that touches a pixel, 360 more for one that was cut.
void make_frame(const Scene& scene, const Buffers& buffers, const Plan& plan, Touch touch, Frame& frame);

/// The triangle that a frame's triangle is, with all that shading asks for: one of those that `clip` gives.
Triangle whole_triangle(const Scene& scene, const Frame& frame, std::int32_t id);

}  // namespace gradus::pipeline::engine
