#pragma once
// The z-buffer: for every pixel the nearest thing seen so far, in any order of things. A
// cell holds what two buffers hold: a depth, and whose colour the pixel has.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"
#include "core/tally.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "visibility/z_buffer/face_plane.hpp"
#include "visibility/z_buffer/outline.hpp"

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

/// The depth of what is free: behind all others.
template <class T>
constexpr T behind_all() {
  using Limits = std::numeric_limits<T>;
  static_assert(Limits::is_specialized, "depths are numbers");
  return Limits::has_infinity ? Limits::infinity() : Limits::max();
}

/// What a pixel holds: its depth and who it is. Free while `taken` is false; then its depth is behind all.
template <class T, class Key>
struct Cell {
  T depth = behind_all<T>();
  Key key{};
  bool taken = false;
};

/// The depth that a cell holds, nothing when it is free.
template <class T, class Key>
constexpr std::optional<T> held(const Cell<T, Key>& cell) {
  return cell.taken ? std::optional<T>(cell.depth) : std::nullopt;
}

/// What the cells of a buffer hold.
template <class Cells>
using DepthIn = decltype(std::declval<Cells&>()[ivec2{}].depth);
template <class Cells>
using KeyIn = decltype(std::declval<Cells&>()[ivec2{}].key);

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

/// Pixels that were compared, and those that changed hands: of the face or row at hand, and of all before.
struct Work {
  std::int64_t compared = 0, kept = 0;
  std::int64_t compared_before = 0, kept_before = 0;

  /// A step as it is told.
  template <class Step>
  constexpr Step operator()(Step step) {
    if constexpr (requires { step.nearer; }) {
      ++compared;
      kept += step.nearer;
    } else if constexpr (requires { step.bytes; }) {
      step.compared = compared_before;
      step.kept = kept_before;
    } else {
      step.compared = compared;
      step.kept = kept;
      compared_before += std::exchange(compared, 0);
      kept_before += std::exchange(kept, 0);
    }
    return step;
  }
};

/// A face as the walks take it: which pixels it covers, and how deep it lies there. Seen edge on it covers
/// none.
struct Shape {
  Id id;
  std::optional<Plane> plane;
  Outline outline;

  Shape(const Face& face, const Window& window)
      : id(face.id), plane(plane_of(face)), outline(face, plane ? window : Window{{0, 0}, {-1, -1}}) {}

  double z_at(ivec2 pixel) const { return plane->at(pixel); }
  auto pixels() const { return outline.pixels(); }
  auto row(int y) const { return outline.row(y); }
};
inline std::vector<Shape> shapes(std::span<const Face> faces, const Window& window) {
  std::vector<Shape> all;
  for (const Face& face : faces) all.emplace_back(face, window);
  return all;
}

template <class T, class Key>
constexpr std::int64_t bytes_of(std::span<Cell<T, Key>> cells) {
  return static_cast<std::int64_t>(cells.size_bytes());
}

/// The cells of one row at a time, from the column `left` on.
template <class T, class Key>
struct Row {
  std::span<Cell<T, Key>> line;
  int left;

  constexpr Row(std::span<Cell<T, Key>> cells, int first) : line(cells), left(first) {}
  constexpr Cell<T, Key>& operator[](ivec2 p) const { return line[static_cast<std::size_t>(p.x - left)]; }
  /// Nothing is in it yet.
  constexpr void clear() const { std::ranges::fill(line, Cell<T, Key>{}); }
  /// paint(pixel, key) for each pixel of row y that has one.
  template <class Paint>
  constexpr void paint(int y, Paint&& paint) const {
    ivec2 p{left, y};
    for (const auto& [depth, key, taken] : line) {
      if (taken) paint(p, key);
      ++p.x;
    }
  }
};

// --- The walks ---------------------------------------------------

/// Draws face after face: at each pixel that it covers its depth is compared with the one there, and the
/// nearer one stays.
/// Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
///
/// faces: in any order. cells: the depth buffer and, as ids, the colour buffer; what is in it already counts.
///   store(double): the depth as the buffer holds it, growing with z.
///
/// Domain: faces plane and convex, corners at most `farthest` pixels out, of finite depth.
/// Steps: (FaceTaken Compared* FaceDone)* Finished; Compared row by row, once for each pixel covered.
/// Accuracy: depths are the nearest doubles before they are stored; the result is the least (stored depth,
///   id) of each pixel in any order of the faces.
/// Cost: a depth and a comparison per covered pixel; bytes by the size of the picture alone.
/// Errors: ContractViolation for a face outside the domain.
template <class Depth, class Store = Exactly,
          Observer<FaceTaken, Compared<Depth, Id>, FaceDone, Finished> O = Unobserved>
void per_polygon(std::span<const Face> faces, Raster<Cell<Depth, Id>>& cells, Store store = {},
                 O&& observer = {}) {
  Tally<O, Work> tally(observer);
  auto window = cells.window();
  for (const Face& face : faces) {
    const Shape shape(face, window);
    const auto id = shape.id;
    if constexpr (observed<O>) observer(FaceTaken{id, shape.plane});
    for (ivec2 p : shape.pixels()) {
      // Its depth at the centre
      auto z = store(shape.z_at(p));
      keep_nearest(cells, p, z, id, tally);
    }
    if constexpr (observed<O>) observer(tally.count(FaceDone{id, 0, 0}));
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0, bytes_of(cells.cells())}));
}

/// The same picture row by row, with the depths of one row alone. Every face is asked for its pixels of the
/// row before the next row begins.
/// Source: A. J. Myers, An efficient visible surface program, 1975.
///
/// faces, store: as for per_polygon. window: the pixels that are asked for. line: a cell per column of it;
///   what is in it is overwritten. paint(pixel, id) is called once for each pixel that a face covers.
///
/// Domain: that of per_polygon; line.size() is the window's width.
/// Steps: (RowBegun Compared* RowDone)* Finished; Compared face by face in each row.
/// Accuracy: the ids are those that per_polygon leaves in its buffer.
/// Cost: the comparisons of per_polygon; the bytes of one row.
/// Errors: ContractViolation for a face outside the domain, or a line of another size.
template <class Depth, class Store, class Paint,
          Observer<RowBegun, Compared<Depth, Id>, RowDone, Finished> O = Unobserved>
void scanline(std::span<const Face> faces, const Window& window, std::span<Cell<Depth, Id>> line, Store store,
              Paint&& paint, O&& observer = {}) {
  expects(std::ssize(line) == window.width(), "a line of {} cells is not as wide as the picture",
          line.size());
  Tally<O, Work> tally(observer);
  auto all = shapes(faces, window);
  const int top = window.lower.y;
  const int end = window.upper.y;
  Row row(line, window.lower.x);
  for (int y = top; y <= end; ++y) {
    // All depths are free again
    row.clear();
    if constexpr (observed<O>) observer(RowBegun{y});
    for (const auto& s : all) {
      const auto id = s.id;
      for (ivec2 p : s.row(y)) {
        auto z = store(s.z_at(p));
        keep_nearest(row, p, z, id, tally);
      }
    }
    // The row's colours are final
    row.paint(y, paint);
    if constexpr (observed<O>) observer(tally.count(RowDone{y, 0, 0}));
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0, bytes_of(line)}));
}

// --- The comparison ----------------------------------------------

/// Tests a depth at a pixel and keeps it when it is the nearest so far. Returns whether it was kept.
/// Source: W. Straßer, Schnelle Kurven- und Flächendarstellung auf grafischen Sichtgeräten, 1974; E. Catmull,
/// A subdivision algorithm for computer display of curved surfaces, 1974.
///
/// cells: one per pixel. p: in them. z: smaller is nearer. key: who it is, e.g. (object, face); at equal
///   depth the lower one is kept.
///
/// Domain: cells.contains(p), not checked. A NaN depth is never kept.
/// Steps: Compared.
/// Accuracy: exact. The result is the least (depth, key) of all that were tested, in any order.
/// Cost: two or three comparisons; the memory is the buffer's, however much is drawn.
/// Errors: none.
template <class Cells, class T = DepthIn<Cells>, class Key = KeyIn<Cells>,
          Observer<Compared<T, Key>> O = Unobserved>
constexpr bool keep_nearest(Cells& cells, ivec2 p, std::type_identity_t<T> z,
                            const std::type_identity_t<Key>& key, O&& observer = {}) {
  auto& [d, who, taken] = cells[p];
  bool nearer = z < d;
  // As near: the lower key stays
  if (z == d) {
    nearer = !taken || key < who;
  }
  if constexpr (observed<O>) observer(Compared<T, Key>{p, z, key, held(cells[p]), nearer});
  if (nearer) {
    d = z;
    who = key;
    taken = true;
  }
  return nearer;
}

}  // namespace gradus::z_buffer
