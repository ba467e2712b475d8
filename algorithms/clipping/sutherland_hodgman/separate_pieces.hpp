#pragma once
// The part of a polygon, with holes or without, that lies in a convex window, as separate pieces: where
// Sutherland and Hodgman let them hang together by bridges, the crossings of a border are put in order along
// it, and each one where the polygon leaves is joined with the next one where it enters.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/rings.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "clipping/sutherland_hodgman/touching_rings.hpp"

namespace gradus::sutherland_hodgman {

/// A connected part of the result. Its rings pass no point twice, and two of them have at most one in common.
template <class T>
struct Piece {
  Ring<T> outline;             ///< counter-clockwise
  std::vector<Ring<T>> holes;  ///< clockwise
};

// --- Steps -------------------------------------------------------

/// Where the inside of a ring meets a border.
template <class T>
struct BorderCrossing {
  Vertex<T> vertex;
  EdgeName edge;  ///< the one by which the ring enters or leaves
  bool enters;
  std::size_t chain;  ///< the chain of vertices inside that begins or ends here
};

/// The crossings of a border are in order along it, the window on its left.
template <class T>
struct CrossingsOrdered {
  int border;
  std::vector<BorderCrossing<T>> crossings;
};

/// A ring was tested against a border, all its vertices.
template <class T>
struct RingTested {
  int border;
  Ring<T> ring;
  std::vector<int> sides;  ///< of its vertices: 1 inside, 0 on the border, -1 outside
};

/// Two crossings were joined: from where a ring leaves the polygon goes along the border to where one enters.
template <class T>
struct CrossingsJoined {
  int border;
  BorderCrossing<T> leaves, enters;
};

/// One border is done with.
template <class T>
struct BorderSplit {
  int border;
  std::vector<Ring<T>> rings;  ///< what is left
};

/// A piece of the result has been traced.
template <class T>
struct PieceTraced {
  std::size_t number;
  Piece<T> piece;
};

// --- What goes on at one border ----------------------------------

/// Whether none of these sides of a border is outside or on it.
inline bool all_inside(std::span<const int> sides) {
  return std::all_of(sides.begin(), sides.end(), [](int side) { return side > 0; });
}

/// Rings, in the course of being cut at one border.
template <class T, class Window>
class BorderCut {
 public:
  BorderCut(const Scene<T, Window>& scene, int border) : scene_(scene), border_(border) {}

  std::vector<int> sides(const Ring<T>& ring) const {
    std::vector<int> sides;
    sides.reserve(ring.size());
    for (const Vertex<T>& vertex : ring) sides.push_back(scene_.side(border_, vertex));
    return sides;
  }

  /// A ring inside stays as it is.
  void keep(const Ring<T>& ring) { kept_.push_back(ring); }
  /// Takes the chains of a ring that lie inside, each from where it enters to where it leaves. A vertex on
  /// the border is not inside: a chain ends there, and the next one may begin there.
  void split(const Ring<T>& ring, std::span<const int> sides) {
    const std::size_t n = ring.size();
    // Begin at a vertex that isn't inside
    std::size_t i = 0;
    while (sides[i] > 0) ++i;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t j = i + 1 < n ? i + 1 : 0;
      const Vertex<T>&last = ring[i], &now = ring[j];
      const bool was = sides[i] > 0, is = sides[j] > 0;
      // Enter, by a cut or at a vertex on the border
      if (!was && is) {
        const Vertex<T> vertex = sides[i] < 0 ? scene_.cut(border_, last) : last;
        chains_.push_back({vertex});
        crossings_.push_back({vertex, last.after, true, chains_.size() - 1});
      }
      // What is inside belongs to the chain
      if (is) chains_.back().push_back(now);
      // Leave, by a cut or at a vertex on the border
      if (was && !is) {
        Vertex<T> vertex = sides[j] < 0 ? scene_.cut(border_, last) : now;
        vertex.after = EdgeName::window(border_);
        chains_.back().push_back(vertex);
        crossings_.push_back({vertex, last.after, false, chains_.size() - 1});
      }
      i = j;
    }
  }

  /// Puts the crossings in order along the border. Two at one point are in the order that they have a little
  /// inside it: the edge that leans back comes first.
  void order() {
    const auto before = [this](const auto& a, const auto& b) { return comes_before(a, b); };
    std::sort(crossings_.begin(), crossings_.end(), before);
  }
  const std::vector<BorderCrossing<T>>& crossings() const { return crossings_; }

  /// Which crossings belong together: the polygon lies ahead of where a ring leaves, up to the next place
  /// where one enters.
  struct Pair {
    BorderCrossing<T> leaves, enters;
  };
  std::vector<Pair> pairs() const {
    std::vector<Pair> all;
    std::vector<BorderCrossing<T>> open;  // more than one only where the polygon lies on itself
    for (const BorderCrossing<T>& now : crossings_) {
      if (open.empty() || open.back().enters == now.enters) {
        open.push_back(now);
        continue;
      }
      all.push_back(now.enters ? Pair{open.back(), now} : Pair{now, open.back()});
      open.pop_back();
    }
    return all;
  }
  void join(const Pair& pair) {
    successor_.resize(chains_.size());
    successor_[pair.leaves.chain] = pair.enters.chain;
  }

  /// The rings that stay, and those that the chains make, each followed by its successor.
  std::vector<Ring<T>> traced() {
    std::vector<Ring<T>> rings = std::move(kept_);
    std::vector<bool> used(chains_.size());
    for (std::size_t first = 0; first < chains_.size(); ++first) {
      if (used[first]) continue;
      Ring<T> ring;
      std::size_t chain = first;
      do {
        used[chain] = true;
        const Ring<T>& now = chains_[chain];
        chain = successor_[chain];
        ring.insert(ring.end(), now.begin(), now.end() - 1);
        // Where it leaves and enters at one point, that is one vertex
        const int order = order_along(scene_, border_, now.back(), chains_[chain].front());
        if (order != 0) ring.push_back(now.back());
      } while (!used[chain]);  // each chain has one successor and is that of one: it comes back to the first
      if (ring.size() >= 3) rings.push_back(std::move(ring));
    }
    return rings;
  }

 private:
  bool comes_before(const BorderCrossing<T>& a, const BorderCrossing<T>& b) const {
    const int order = order_along(scene_, border_, a.vertex, b.vertex);
    if (order != 0) return order < 0;
    // Both edges as they point inside
    const Segment<2, T> line = line_of(scene_.window, border_);
    const Segment<2, T> u = scene_.line(a.edge), v = scene_.line(b.edge);
    return heading(u, v) * heading(line, u) * heading(line, v) < 0;
  }

  const Scene<T, Window>& scene_;
  int border_;
  std::vector<Ring<T>> kept_, chains_;
  std::vector<BorderCrossing<T>> crossings_;
  std::vector<std::size_t> successor_;
};

/// Whether a vertex lies above a height: its exact place, not its rounded one. 1 above, 0 at it, -1 below.
template <class T, class Window>
int height_against(const Scene<T, Window>& scene, const Vertex<T>& v, T y) {
  if (v.at.y != y || !v.made()) return (v.at.y > y) - (v.at.y < y);
  const Segment<2, T> horizontal{{T(0), y}, {T(1), y}};
  return side_of_crossing(horizontal, scene.line(v.edge), scene.line(v.border));
}

/// Whether a ring holds the place a little left of a point: an odd number of its edges pass farther left.
/// Exact. Domain: finite; the point may lie on the ring.
template <class T, class Window>
bool holds(const Scene<T, Window>& scene, std::span<const Vertex<T>> ring, glm::vec<2, T> point) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vertex<T>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool starts_above = height_against(scene, a, point.y) > 0;
    if (starts_above == (height_against(scene, b, point.y) > 0)) continue;
    const Segment<2, T> line = scene.line(a.after);
    const int right_of_it = -side(line, point);
    odd ^= (line.a.y < line.b.y ? right_of_it : -right_of_it) > 0;
  }
  return odd;
}

// --- The method --------------------------------------------------

/// What the vertices of pieces refer to.
template <class T, class Window>
Scene<T, Window> scene_of(const Rings<T>& rings, const Window& window) {
  return {{rings.points, rings.next, rings.touch}, window};
}

/// Cuts all rings at one border and keeps what lies inside, as rings of its own.
///
/// Steps: RingTested* CrossingsOrdered CrossingsJoined* BorderSplit, RingTested once for every ring.
/// Cost: a test per vertex; O(k log k) for k crossings.
template <class T, class Window,
          Observer<RingTested<T>, CrossingsOrdered<T>, CrossingsJoined<T>, BorderSplit<T>> O = Unobserved>
void split_at(int border, std::vector<Ring<T>>& rings, const Scene<T, Window>& scene, O&& observer = {}) {
  BorderCut cut(scene, border);
  // Split rings into chains inside
  for (const auto& ring : rings) {
    auto sides = cut.sides(ring);
    if constexpr (observed<O>) observer(RingTested<T>{border, ring, sides});
    if (all_inside(sides)) {
      cut.keep(ring);
    } else {
      cut.split(ring, sides);
    }
  }
  // Sort crossings along the border
  cut.order();
  if constexpr (observed<O>) observer(CrossingsOrdered<T>{border, cut.crossings()});
  // An exit leads to the next entry
  for (auto& pair : cut.pairs()) {
    cut.join(pair);
    if constexpr (observed<O>) observer(CrossingsJoined<T>{border, pair.leaves, pair.enters});
  }
  // Trace the rings that this makes
  rings = cut.traced();
  if constexpr (observed<O>) observer(BorderSplit<T>{border, rings});
}

/// Whether a ring runs along the window somewhere.
template <class T>
bool along_window(const Ring<T>& ring) {
  return std::any_of(ring.begin(), ring.end(), [](const Vertex<T>& v) { return v.after.of_window(); });
}

/// Which side of a ring the polygon has: 1 its inner side, -1 its outer one, 0 the ring has no area. Beyond
/// the window there is nothing; a ring that doesn't run along it has the input's vertices alone.
template <class T>
int turn_of(const Ring<T>& ring) {
  if (along_window(ring)) return 1;
  return area_sign(std::span<const Vertex<T>>(ring));
}

/// The piece that a ring goes round: where it passes a point twice it comes apart into the outline and holes.
/// touch: whether rings of the polygon do. Else only a vertex on the border of the window is passed twice.
template <class T>
Piece<T> piece_in(Ring<T> ring, bool touch) {
  const auto on_border = [](const Vertex<T>& v) { return !v.made() && v.after.of_window(); };
  if (!touch && std::none_of(ring.begin(), ring.end(), on_border)) return {std::move(ring), {}};
  Piece<T> piece{{}, simple_rings(ring)};
  if (piece.holes.empty()) return piece;
  const auto goes_round = [](const Ring<T>& simple) { return turn_of(simple) > 0; };
  auto outline = std::find_if(piece.holes.begin(), piece.holes.end(), goes_round);
  if (outline == piece.holes.end()) outline = piece.holes.begin();
  piece.outline = std::move(*outline);
  piece.holes.erase(outline);
  return piece;
}

/// Takes out pieces so small that their outline has fewer than three places left. Of rings that cross, what
/// runs along the window is no hole in it, but a piece.
template <class T>
void leave_out_vanished(std::vector<Piece<T>>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    leave_out_repeated(pieces[i].outline);
    if (!pieces[i].outline.empty()) continue;
    for (Ring<T>& ring : std::exchange(pieces[i].holes, {})) {
      if (along_window(ring)) pieces.push_back({std::move(ring), {}});
    }
  }
  std::erase_if(pieces, [](const Piece<T>& piece) { return piece.outline.empty(); });
}

/// The pieces that rings bound, each with the holes in it. Takes the rings.
template <class T, class Window>
std::vector<Piece<T>> grouped(std::vector<Ring<T>>& rings, const Scene<T, Window>& scene) {
  const bool touch = scene.polygon.touch;
  std::vector<Ring<T>> outer, inner;
  for (Ring<T>& ring : rings) {
    const int turn = turn_of(ring);
    if (turn != 0) (turn > 0 ? outer : inner).push_back(std::move(ring));
  }
  std::vector<Piece<T>> pieces;
  pieces.reserve(outer.size());
  for (Ring<T>& ring : outer) {
    // Holes ask for the whole rings
    pieces.push_back(piece_in(inner.empty() ? std::move(ring) : ring, touch));
  }
  for (const Ring<T>& ring : inner) {
    // What lies left of a hole is the piece that it is in
    const auto left_end = std::min_element(
        ring.begin(), ring.end(), [](const auto& a, const auto& b) { return comes_first(a.at, b.at); });
    const auto around = std::find_if(outer.begin(), outer.end(), [&](const Ring<T>& candidate) {
      return holds(scene, std::span<const Vertex<T>>(candidate), left_end->at);
    });
    if (around == outer.end()) {
      pieces.push_back({ring, {}});  // rings cross
      continue;
    }
    auto& holes = pieces[static_cast<std::size_t>(around - outer.begin())].holes;
    if (!touch) {
      holes.push_back(ring);
      continue;
    }
    const auto simple = simple_rings(ring);
    holes.insert(holes.end(), simple.begin(), simple.end());
  }
  leave_out_vanished(pieces);
  return pieces;
}

/// The part of a polygon, with holes or without, that lies in a convex window, as separate pieces.
/// After K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, SIGGRAPH 1977, 214-222,
/// whose crossings, entering and leaving, are joined here at one border of the window after the other, as
/// Sutherland and Hodgman take them.
///
/// rings: the outline and then the holes, each either way round. window: a Rectangle or a ConvexWindow.
///   order: the borders, each once.
///
/// Domain: finite coordinates of any size; rings that don't cross themselves or each other; holes that lie in
///   the outline and not in one another. They may touch themselves and each other, in points and along edges,
///   repeat vertices, and have vertices on borders and edges along them.
///   Rings that cross bring no error: the areas of all rings that come out, each with the sign of its
///   direction, then add up to what the given ones have in the window, counted as often as they go round it
///   (the outline counter-clockwise, holes clockwise, a ring of area 0 as it is given). The rest of what is
///   said here does not hold.
/// Steps: (RingTested* CrossingsOrdered CrossingsJoined* BorderSplit)* PieceTraced*, a BorderSplit for every
///   border until nothing is left. Rings come to the first border joined where they touch.
/// Accuracy: decisions and orders exact; vertices as clip_to_window. The pieces are the connected parts of
///   the polygon's inside in the window: two that meet in points alone are two pieces, as in OGC Simple
///   Feature Access 1.2.1, 6.1.11.1, and what touches the window in points or edges alone gives nothing.
///   Before vertices are rounded, no ring passes a point twice, and two of a piece have at most one in
///   common. A part so small that its vertices round to fewer than three places is left out.
/// Cost: to know whether rings touch, when Rings are made: for n vertices O(n) where one goes round a point
///   as convex polygons and stars do, or where boxes round runs of edges mostly lie apart; else, and where
///   they do touch, O(n log n), with O(n^2) bytes moved at worst (see touching_rings.hpp). Then one test per
///   vertex and border; O(k log k) for k crossings on one border; O(h n) for h holes that no border met.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out.
template <class T, class Window,
          Observer<RingTested<T>, CrossingsOrdered<T>, CrossingsJoined<T>, BorderSplit<T>, PieceTraced<T>> O =
              Unobserved>
std::vector<Piece<T>> separate_pieces(const Rings<T>& polygon, const Window& window,
                                      std::span<const int> order, O&& observer = {}) {
  expect_window(window);
  auto s(scene_of(polygon, window));
  auto rings = polygon.rings;
  // Split at each border in turn
  for (const int border : order) {
    if (rings.empty()) break;
    split_at(border, rings, s, observer);
  }
  // Holes that no border met go
  // to the piece they lie in
  auto pieces = grouped(rings, s);
  for (const auto& p : pieces) {
    if constexpr (observed<O>) observer(PieceTraced<T>{number_in<Piece<T>>(pieces, p), p});
  }
  return pieces;
}

/// The same, in the borders' own order: left, right, bottom, top.
template <class T, class Window = Rectangle<T>>
std::vector<Piece<T>> separate_pieces(const Rings<T>& polygon, const Window& window) {
  return separate_pieces(polygon, window, all_borders(window));
}

/// The same for an outline, or rings, as they are: points in a vector, an array or braces. With an order and
/// an observer or without.
template <PointRow<2> Points = PointsInBraces<2>, class Window = Rectangle<ScalarOf<Points>>, class... More>
auto separate_pieces(const Points& outline, const Window& window, More&&... order_and_observer) {
  return separate_pieces(Rings(outline), window, std::forward<More>(order_and_observer)...);
}
template <RowOfRings Given = RingsInBraces, class Window = Rectangle<ScalarOf<ItemOf<Given>>>, class... More>
auto separate_pieces(const Given& rings, const Window& window, More&&... order_and_observer) {
  return separate_pieces(Rings(rings), window, std::forward<More>(order_and_observer)...);
}

}  // namespace gradus::sutherland_hodgman
