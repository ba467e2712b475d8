#pragma once
// The z-buffer: for every pixel the nearest thing seen so far, in any order of things. A
// cell holds what two buffers hold: a depth, and whose colour the pixel has.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "visibility/z_buffer/face_plane.hpp"

namespace gradus::z_buffer {

/// A depth was compared with what the pixel held.
template <class T, class Key>
struct Compared {
  ivec2 pixel;
  T depth;
  Key key;
  std::optional<T> before;  ///< the depth that the pixel held; nothing when it was free
  bool nearer;              ///< whether the newcomer takes its place
};

/// What a pixel holds: its depth and who it is. Free while `taken` is false.
template <class T, class Key>
struct Cell {
  T depth{};
  Key key{};
  bool taken = false;
};

/// The depth that a cell holds, nothing when it is free.
template <class T, class Key>
constexpr std::optional<T> held(const Cell<T, Key>& cell) {
  return cell.taken ? std::optional<T>(cell.depth) : std::nullopt;
}

/// Whether (depth, key) goes before what the cell holds: it is nearer, or as near with the lower key. A depth
/// that is no number goes before nothing.
template <class T, class Key>
constexpr bool beats(const Cell<T, Key>& cell, T depth, const Key& key) {
  if (!(depth == depth)) return false;
  if (!cell.taken) return true;
  if (depth < cell.depth) return true;
  return depth == cell.depth && key < cell.key;
}

/// The cell holds this from now on.
template <class T, class Key>
constexpr void take(Cell<T, Key>& cell, T depth, const Key& key) {
  cell = {depth, key, true};
}

/// Tests a depth at a pixel and keeps it when it is the nearest so far. Returns whether it was kept.
/// Source: W. Straßer, Schnelle Kurven- und Flächendarstellung auf grafischen Sichtgeräten, 1974; E. Catmull,
/// A subdivision algorithm for computer display of curved surfaces, 1974.
///
/// buffer: a cell a pixel. pixel: in the buffer. depth: smaller is nearer. key: who it is, e.g. (object,
///   face); at equal depth the lower one is kept.
///
/// Domain: buffer.contains(pixel), not checked. A NaN depth is never kept.
/// Steps: Compared.
/// Accuracy: exact. The result is the least (depth, key) of all that were tested, in any order.
/// Cost: two or three comparisons; the memory is the buffer's, however much is drawn.
/// Errors: none.
template <class T, class Key, Observer<Compared<T, Key>> O = Unobserved>
constexpr bool keep_nearest(Raster<Cell<T, Key>>& buffer, ivec2 pixel, T depth, const Key& key,
                            O&& observer = {}) {
  auto& cell = buffer[pixel];
  const bool nearer = beats(cell, depth, key);
  if constexpr (observed<O>) observer(Compared<T, Key>{pixel, depth, key, held(cell), nearer});
  if (nearer) take(cell, depth, key);
  return nearer;
}

// --- Faces -------------------------------------------------------

/// How far a corner may lie from the picture's first one, in pixels.
inline constexpr int farthest = 1 << 15;

/// The pixels whose centres a convex polygon holds. Corners are snapped to 1/256 pixel, as those of
/// triangle_coverage are, and centres on an edge belong to the face right of it or below. Snapping may bend
/// the ring inwards at a short edge, so that its turns about a centre are counted, not its edges' sides.
class Outline {
 public:
  explicit Outline(const Face& face, const Window& picture) {
    const auto& c = face.corners;
    expects(c.size() >= 3, "a face has at least three corners, not {}", c.size());
    std::vector<ivec2> at;
    for (const dvec3& corner : c) {
      expects(near_enough(corner), "a corner lies at ({}, {}, {}), farther than {} pixels out or nowhere",
              corner.x, corner.y, corner.z, farthest);
      at.push_back(triangle_coverage::snap(dvec2(corner)));
    }
    std::int64_t area = 0;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      area += triangle_coverage::doubled_area({at[0], at[i], at[i + 1]});
    }
    if (area == 0) return;
    for (std::size_t i = 0; i < at.size(); ++i) add_edge(at[i], at[i + 1 < at.size() ? i + 1 : 0]);
    box_ = intersection(box_of(at), picture);
  }

  /// The pixels that are worth asking; empty for a face without area.
  const Window& box() const { return box_; }
  bool holds(ivec2 pixel) const {
    const ivec2 centre = triangle_coverage::centre_of(pixel);
    int turns = 0;
    for (const auto& edge : edges_) turns += turn(edge, centre);
    return turns != 0;
  }
  /// visit(pixel) for each pixel of row y that is held, from left to right.
  template <class Visit>
  void visit_row(int y, Visit&& visit) const {
    if (y < box_.lower.y || y > box_.upper.y) return;
    for (int x = box_.lower.x; x <= box_.upper.x; ++x) {
      if (holds({x, y})) visit(ivec2{x, y});
    }
  }
  /// The same for all rows, from top to bottom.
  template <class Visit>
  void visit(Visit&& visit_pixel) const {
    for (int y = box_.lower.y; y <= box_.upper.y; ++y) visit_row(y, visit_pixel);
  }

 private:
  static bool near_enough(const dvec3& c) {
    return std::abs(c.x) <= farthest && std::abs(c.y) <= farthest && std::isfinite(c.z);
  }
  /// What an edge adds to the turns: one way or the other where it crosses the row at the place or left of
  /// it.
  static int turn(const triangle_coverage::Edge& edge, ivec2 place) {
    const bool up = edge.to.y <= place.y, down = edge.from.y <= place.y;
    if (up == down) return 0;
    const std::int64_t side = edge.at(place);
    return up ? side >= 0 : -(side <= 0);
  }
  void add_edge(ivec2 from, ivec2 to) {
    if (from != to) edges_.push_back({from, to, triangle_coverage::top_or_left(from, to)});
  }
  static Window box_of(const std::vector<ivec2>& at) {
    ivec2 lower = at[0], upper = at[0];
    for (const ivec2 p : at) lower = glm::min(lower, p), upper = glm::max(upper, p);
    return {{lower.x >> 8, lower.y >> 8}, {upper.x >> 8, upper.y >> 8}};
  }

  std::vector<triangle_coverage::Edge> edges_;
  Window box_{{0, 0}, {-1, -1}};
};

// --- How a depth is stored ---------------------------------------

/// The depths that a buffer can hold.
struct Range {
  double near, far;
};

/// As it is.
struct Exactly {
  constexpr double operator()(double z) const { return z; }
};
/// A float from 0 at the near plane to 1 at the far one: finest near the viewer.
struct AsFloat {
  Range range;
  constexpr float operator()(double z) const {
    return static_cast<float>((z - range.near) / (range.far - range.near));
  }
};
/// The nearest of 2^24 whole numbers, 0 at the near plane: equally fine everywhere. Depths outside the
/// range get the code of the end they lie beyond.
struct AsFixed24 {
  Range range;
  static constexpr std::int32_t most = (1 << 24) - 1;
  std::int32_t operator()(double z) const {
    const double share = std::clamp((z - range.near) / (range.far - range.near), 0.0, 1.0);
    return static_cast<std::int32_t>(std::floor(share * most + 0.5));
  }
};
/// A float from 1 at the near plane to 0 at the far one: finest far from the viewer, where a perspective
/// depth needs it. It has its sign turned here, so that less is nearer as everywhere.
struct AsReversedFloat {
  Range range;
  constexpr float operator()(double z) const {
    return -static_cast<float>((range.far - z) / (range.far - range.near));
  }
};

/// Depth after a perspective projection, 0 at the near plane and 1 at the far one: linear on the screen where
/// a face's z is not. Domain: 0 < near < far, z > 0.
constexpr double perspective_depth(double z, const Range& range) {
  return range.far / (range.far - range.near) * (1 - range.near / z);
}

// --- Steps of the walks ------------------------------------------

/// A face is taken; its pixels come next.
struct FaceTaken {
  Id id;
  std::optional<Plane> plane;  ///< nothing when it is seen edge on
};
/// All pixels of the face were compared.
struct FaceDone {
  Id id;
  std::int64_t compared, kept;
};
/// A row begins with nothing in its line of depths.
struct RowBegun {
  int y;
};
/// All faces have been through the row: its colours are final.
struct RowDone {
  int y;
  std::int64_t compared, kept;
};
/// Everything was drawn.
struct Finished {
  std::int64_t compared, kept;  ///< kept: how often a pixel changed
  std::int64_t bytes;           ///< of the depths and ids that were held at once
};

/// Pixels that were compared, and those that changed hands.
struct Work {
  std::int64_t compared = 0, kept = 0;

  constexpr void count(bool wins) {
    ++compared;
    kept += wins;
  }
  constexpr void add(const Work& more) {
    compared += more.compared;
    kept += more.kept;
  }
};
/// What each row of scanline asks a face for.
struct Prepared {
  Id id;
  std::optional<Plane> plane;
  Outline outline;
};
inline std::vector<Prepared> prepare(std::span<const Face> faces, const Window& picture) {
  std::vector<Prepared> all;
  for (const Face& face : faces) all.push_back({face.id, plane_of(face), Outline(face, picture)});
  return all;
}
template <class T, class Key>
constexpr std::int64_t bytes_of(std::span<Cell<T, Key>> cells) {
  return static_cast<std::int64_t>(cells.size_bytes());
}
/// Nothing is in the line yet.
template <class T, class Key>
constexpr void clear(std::span<Cell<T, Key>> line) {
  std::ranges::fill(line, Cell<T, Key>{});
}
template <class T, class Key>
constexpr Cell<T, Key>& at(std::span<Cell<T, Key>> line, int column) {
  return line[static_cast<std::size_t>(column)];
}

// --- The walks ---------------------------------------------------

/// Draws face after face: at each pixel that it covers its depth is compared with the one there, and the
/// nearer one stays.
/// Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
///
/// faces: in any order. buffer: the depth buffer and, as ids, the colour buffer; what is in it already
///   counts. store(double): the depth as the buffer holds it, growing with z.
///
/// Domain: faces plane and convex, corners at most `farthest` pixels out, of finite depth.
/// Steps: (FaceTaken Compared* FaceDone)* Finished; Compared row by row, once for each pixel covered.
/// Accuracy: depths are the nearest doubles before they are stored; the result is the least (stored depth,
///   id) of each pixel in any order of the faces.
/// Cost: a depth and a comparison a covered pixel; bytes by the size of the picture alone.
/// Errors: ContractViolation for a face outside the domain.
template <class Depth, class Store = Exactly,
          Observer<FaceTaken, Compared<Depth, Id>, FaceDone, Finished> O = Unobserved>
void per_polygon(std::span<const Face> faces, Raster<Cell<Depth, Id>>& buffer, Store store = {},
                 O&& observer = {}) {
  Work all;
  for (const Face& face : faces) {
    const auto id = face.id;
    const auto plane = plane_of(face);
    const Outline outline(  // convex
        face, buffer.window());
    Work work;
    if constexpr (observed<O>) observer(FaceTaken{id, plane});
    const auto visit = [&](ivec2 p) {
      // Its depth at the pixel's centre
      auto z = store(plane->at(p));
      auto& cell = buffer[p];
      const auto old = held(cell);
      bool wins = beats(cell, z, id);
      if constexpr (observed<O>) observer(Compared<Depth, Id>{p, z, id, old, wins});
      // The nearer one stays
      if (wins) take(cell, z, id);
      work.count(wins);
    };
    if (plane) outline.visit(visit);
    all.add(work);
    if constexpr (observed<O>) observer(FaceDone{id, work.compared, work.kept});
  }
  if constexpr (observed<O>) observer(Finished{all.compared, all.kept, bytes_of(buffer.cells())});
}

/// The same picture row by row, with the depths of one row alone. Every face is asked for its pixels of the
/// row before the next row begins.
/// Source: A. J. Myers, An efficient visible surface program, 1975.
///
/// faces, store: as for per_polygon. picture: the pixels that are asked for. line: a cell a column of it;
///   what is in it is overwritten. paint(pixel, id) is called once for each pixel that a face covers.
///
/// Domain: that of per_polygon; line.size() is the picture's width.
/// Steps: (RowBegun Compared* RowDone)* Finished; Compared face by face in each row.
/// Accuracy: the ids are those that per_polygon leaves in its buffer.
/// Cost: the comparisons of per_polygon; the bytes of one row.
/// Errors: ContractViolation for a face outside the domain, or a line of another size.
template <class Depth, class Store, class Paint,
          Observer<RowBegun, Compared<Depth, Id>, RowDone, Finished> O = Unobserved>
void scanline(std::span<const Face> faces, const Window& picture, std::span<Cell<Depth, Id>> line,
              Store store, Paint&& paint, O&& observer = {}) {
  expects(std::ssize(line) == picture.width(), "a line of {} cells is not as wide as the picture",
          line.size());
  const auto [lower, upper] = picture;
  const int left = lower.x;
  auto prepared = prepare(faces, picture);
  Work all;
  for (int y = lower.y; y <= upper.y; ++y) {
    // All depths are free again
    clear(line);
    Work work;
    if constexpr (observed<O>) observer(RowBegun{y});
    for (auto& face : prepared) {
      auto& [id, plane, outline] = face;
      const auto visit = [&](ivec2 p) {
        auto z = store(plane->at(p));
        auto& cell = at(line, p.x - left);
        const auto old = held(cell);
        bool wins = beats(cell, z, id);
        if constexpr (observed<O>) observer(Compared<Depth, Id>{p, z, id, old, wins});
        if (wins) take(cell, z, id);
        work.count(wins);
      };
      if (plane) outline.visit_row(y, visit);
    }
    // The row's colours are final
    for (int x = left; x <= upper.x; ++x) {
      auto& cell = at(line, x - left);
      const auto [z, id, taken] = cell;
      if (taken) paint(ivec2{x, y}, id);
    }
    all.add(work);
    if constexpr (observed<O>) observer(RowDone{y, work.compared, work.kept});
  }
  if constexpr (observed<O>) observer(Finished{all.compared, all.kept, bytes_of(line)});
}

}  // namespace gradus::z_buffer
