#pragma once
// Which of two triangles is seen at a place that both cover, where single precision does not decide.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "engine/geometry.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::pipeline::engine {

/// The depth of a triangle at a place by the textbook's arithmetic, and what decides between equal ones.
struct ExactDepth {
  double depth;
  PieceId piece;
  std::int32_t id;

  friend bool operator<(const ExactDepth& a, const ExactDepth& b) {
    return std::tie(a.depth, a.piece, a.id) < std::tie(b.depth, b.piece, b.id);
  }
};

inline PieceId piece_of(const Frame& frame, const FrameTriangle& t, std::int32_t id) {
  if (t.cut) return frame.cut_triangle(id).id;
  const FrameObject& object = frame.object_of(t);
  const MeshPiece& piece = object.pieces->of_faces[static_cast<std::size_t>(t.piece)];
  return {object.number, piece.face, piece.piece};
}

/// place: in 1/256 pixel.
inline ExactDepth exact_depth(const Frame& frame, std::int32_t id, ivec2 place) {
  const FrameTriangle& t = frame.triangle(id);
  const bool own = t.plane == no_plane;  // a shared plane asks for no weights
  const auto weights =
      own ? weights_at_place(triangle_coverage::edges_of(t.grid), place) : triangle_coverage::Weights{};
  return {depth_of(frame, t).at(place, weights), piece_of(frame, t, id), id};
}

/// The depths that a triangle of a shared plane keeps to.
struct KeptDepths {
  double least, most;

  bool holds(const KeptDepths& others) const { return least <= others.least && others.most <= most; }
};

inline KeptDepths kept_depths(const dvec3& corners) {
  const auto [least, most] = std::minmax({corners.x, corners.y, corners.z});
  constexpr double slack = triangle_coverage::Depth::slack;
  return {least - slack, most + slack};
}

/// Whether a triangle is seen rather than another at a place, in 1/256 pixel: exact_depth of one is less.
inline bool is_before(const Frame& frame, std::int32_t id, std::int32_t other, ivec2 place) {
  return exact_depth(frame, id, place) < exact_depth(frame, other, place);
}

/// A square of places, in 1/256 pixel.
struct Places {
  ivec2 first;
  int side;
};

/// The depths of a plane at some places: rounding keeps their order along rows and columns, so that those of
/// two corners bound all others, to the bit.
inline KeptDepths depths_over(const triangle_coverage::DepthPlane& plane, const Places& places) {
  const ivec2 most{plane.right < 0 ? 0 : places.side, plane.down < 0 ? 0 : places.side};
  return {plane.at(places.first + (places.side - most)), plane.at(places.first + most)};
}

/// How deep a triangle is over a tile, in double precision.
struct TileDepth {
  std::int32_t id = -1;
  double at = 0, right = 0, down = 0;  ///< in the tile's upper left, and what 1/256 pixel adds
  double off = 0;                      ///< by how much exact_depth may differ, at most
  PlaneDepth plane{};                  ///< a shared one
  KeptDepths kept{};                   ///< then the depths that it keeps to

  /// Whether the plane alone tells the depth at all of these places.
  bool is_plane_at(const Places& places) const { return !plane || kept.holds(depths_over(*plane, places)); }
};

/// Which of two triangles is seen where both lie, at many places of a tile at once: by the order of their
/// faces where both have the same depth to the bit, else by planes in double precision as far as these surely
/// differ. What is left open is for is_before.
class TileTies {
 public:
  enum class Order : std::uint8_t { before, after, open };

  /// origin: the tile's first pixel.
  TileTies(const Frame& frame, ivec2 origin)
      : frame_(frame), origin_(origin * triangle_coverage::subpixels) {}

  /// Whether a triangle comes before another one, or after it, at all of these places. Domain: in the tile.
  Order order(std::int32_t id, std::int32_t other, const Places& places) {
    if (id != one_.id || other != two_.id) set(id, other);
    if (!one_.is_plane_at(places) || !two_.is_plane_at(places)) return Order::open;
    if (is_as_deep_) return is_first_ ? Order::before : Order::after;
    const dvec2 from = dvec2(places.first - origin_);
    const double right = two_.right - one_.right, down = two_.down - one_.down,
                 deeper = two_.at - one_.at + right * from.x + down * from.y, off = one_.off + two_.off,
                 least = deeper + (std::min(right, 0.0) + std::min(down, 0.0)) * places.side,
                 most = deeper + (std::max(right, 0.0) + std::max(down, 0.0)) * places.side;
    return least > off ? Order::before : most < -off ? Order::after : Order::open;
  }

 private:
  void set(std::int32_t id, std::int32_t other);
  const TileDepth& known(std::int32_t id);

  const Frame& frame_;
  ivec2 origin_;
  std::array<TileDepth, 32> known_;  ///< by the last bits of their numbers
  // Of the two that were last asked for
  TileDepth one_, two_;
  bool is_as_deep_ = false;  ///< to the bit, wherever their planes tell their depths
  bool is_first_ = false;    ///< of equals
};

}  // namespace gradus::pipeline::engine
