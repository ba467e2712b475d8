#pragma once
// Which of two triangles is seen at a place that both cover, where single precision does not decide.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "engine/geometry.hpp"
#include "scan_conversion/triangle_coverage/screen_triangle.hpp"

namespace gradus::pipeline::engine {

inline PieceId piece_of(const Frame& frame, const FrameTriangle& t, std::int32_t id) {
  if (t.cut) return frame.cut_triangle(id).id;
  const FrameObject& object = frame.object_of(t);
  const MeshPiece& piece = object.pieces->of_faces[static_cast<std::size_t>(t.piece)];
  return {object.number, piece.face, piece.piece};
}

/// How deep a triangle is at places of the picture by the textbook's arithmetic.
class TextbookDepth {
 public:
  TextbookDepth() = default;
  TextbookDepth(const Frame& frame, const FrameTriangle& t)
      : depth_(depth_of(frame, t)),
        edges_(triangle_coverage::edges_of(t.grid)),
        is_own_(t.plane == no_plane) {}

  /// place: in 1/256 pixel.
  double at(ivec2 place) const {
    // A shared plane asks for no weights
    return depth_.at(place, is_own_ ? weights_at_place(edges_, place) : triangle_coverage::Weights{});
  }

 private:
  triangle_coverage::Depth depth_{{}};
  triangle_coverage::Edges edges_{};
  bool is_own_ = false;
};

/// The depths that a triangle of a shared plane keeps to.
struct KeptDepths {
  double least, most;

  bool holds(const KeptDepths& others) const { return least <= others.least && others.most <= most; }
  double clamped(double depth) const { return std::clamp(depth, least, most); }
};

/// The depths of a shared plane for which one triangle's, kept to its range, is never more than another's.
inline KeptDepths not_deeper_within(const KeptDepths& one, const KeptDepths& other) {
  constexpr double any = std::numeric_limits<double>::infinity();
  return {one.least <= other.least ? -any : one.least, one.most <= other.most ? any : other.most};
}

inline KeptDepths kept_depths(const dvec3& corners) {
  const auto [least, most] = std::minmax({corners.x, corners.y, corners.z});
  constexpr double slack = triangle_coverage::Depth::slack;
  return {least - slack, most + slack};
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

/// How deep a triangle is over a tile, by a plane in double precision and by the textbook's arithmetic.
struct TileDepth {
  std::int32_t id = -1;
  double at = 0, right = 0, down = 0;  ///< in the tile's upper left, and what 1/256 pixel adds
  double off = 0;                      ///< by how much the textbook's depth may differ, at most
  PlaneDepth plane{};                  ///< a shared one
  KeptDepths kept{};                   ///< then the depths that it keeps to
  TextbookDepth exact;

  /// Whether the plane alone tells the depth at all of these places.
  bool is_plane_at(const Places& places) const { return !plane || kept.holds(depths_over(*plane, places)); }
};

/// Which of two triangles is seen where both lie, at one place of a tile or at many at once.
class TileTies {
 public:
  enum class Order : std::uint8_t { before, after, open };

  /// origin: the tile's first pixel.
  TileTies(const Frame& frame, ivec2 origin)
      : frame_(frame), origin_(origin * triangle_coverage::subpixels) {}

  /// Whether a triangle comes before another one at a place, in 1/256 pixel: it is nearer by the textbook's
  /// arithmetic, or as near and its face comes first.
  bool is_before(std::int32_t id, std::int32_t other, ivec2 place) {
    if (id != id_ || other != other_) set_pair(id, other);
    const auto [one, two] = depths_at(place);
    return one < two || (one == two && by_faces_ == Order::before);
  }

  /// Whether a triangle comes before another one, or after it, at all of these places: by the order of their
  /// faces where both have the same depth to the bit, else by planes in double precision as far as these
  /// surely differ. What is left open is for is_before. Domain: in the tile.
  Order order(std::int32_t id, std::int32_t other, const Places& places) {
    if (id != id_ || other != other_) set_pair(id, other);
    if (plane_) return by_faces_within_.holds(depths_over(*plane_, places)) ? by_faces_ : Order::open;
    return are_alike_ ? by_faces_ : order_by_planes(known(id, ones_), known(other, others_), places);
  }

 private:
  /// By the last bits of their numbers; none as long as nothing is asked for, as in most tiles.
  using Known = std::vector<TileDepth>;
  static constexpr std::size_t most_known = 32;

  const TileDepth& known(std::int32_t id, Known& all) {
    const std::size_t place = static_cast<std::size_t>(id) % most_known;
    if (all.empty() || all[place].id != id) learn(id, all);
    return all[place];
  }
  void learn(std::int32_t id, Known& all) const;
  void set_pair(std::int32_t id, std::int32_t other);
  Order order_by_planes(const TileDepth& one, const TileDepth& two, const Places& places) const;
  /// Those of the two that were asked for last.
  std::pair<double, double> depths_at(ivec2 place) {
    if (!plane_) return {known(id_, ones_).exact.at(place), known(other_, others_).exact.at(place)};
    const double depth = plane_->at(place);
    return {one_kept_.clamped(depth), two_kept_.clamped(depth)};
  }

  const Frame& frame_;
  ivec2 origin_;
  Known ones_, others_;
  // Of the two that were asked for last
  std::int32_t id_ = -1, other_ = -1;
  PlaneDepth plane_{};  ///< in which both lie
  KeptDepths one_kept_{}, two_kept_{};
  KeptDepths by_faces_within_{};   ///< depths of the plane where faces tell the order
  bool are_alike_ = false;         ///< they have the same corners
  Order by_faces_ = Order::after;  ///< where both are as deep
};

}  // namespace gradus::pipeline::engine
