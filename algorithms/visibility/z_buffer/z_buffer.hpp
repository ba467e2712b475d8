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
  /// The pixels that are held, row by row from the top, each row from the left.
  auto pixels() const { return Held(*this, box_); }
  /// Those of row y alone.
  auto row(int y) const { return Held(*this, {{box_.lower.x, y}, {box_.upper.x, y}}); }

 private:
  /// The pixels of a rectangle that an outline holds, as a range.
  class Held {
   public:
    Held(const Outline& outline, const Window& window)
        : outline_(outline), window_(intersection(window, outline.box_)) {}
    Held begin() const {
      Held first = *this;
      first.at_ = window_.lower;
      if (window_.width() <= 0) first.at_.y = window_.upper.y + 1;
      first.find();
      return first;
    }
    std::default_sentinel_t end() const { return {}; }
    ivec2 operator*() const { return at_; }
    Held& operator++() {
      step();
      find();
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return at_.y > window_.upper.y; }

   private:
    void find() {
      while (*this != end() && !outline_.holds(at_)) step();
    }
    void step() {
      if (++at_.x <= window_.upper.x) return;
      at_ = {window_.lower.x, at_.y + 1};
    }

    const Outline& outline_;
    const Window window_;
    ivec2 at_{};
  };
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
