#pragma once
// The part of a polygon, with holes or without, that lies in a convex window, as separate pieces: where
// Sutherland and Hodgman let them hang together by bridges, the crossings of a border are put in order along
// it, and each one where the polygon leaves is joined with the next one where it enters.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

namespace gradus::sutherland_hodgman {

/// A closed chain of vertices; the area lies left of it.
template <class T>
using Ring = std::vector<Vertex<T>>;

/// A connected part of the result.
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

/// Two crossings were joined: from where a ring leaves the polygon goes along the border to where one enters.
template <class T>
struct CrossingsJoined {
  int border;
  Vertex<T> leaves, enters;
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

/// The sign of twice the area of a ring. Exact. Domain: finite. Cost: about 60 ns a vertex.
template <class T>
int area_sign(std::span<const glm::vec<2, T>> ring) {
  const std::size_t n = ring.size();
  if constexpr (std::floating_point<T>) {
    SumOfProducts<2> doubled;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 a(ring[i]), b(ring[i + 1 < n ? i + 1 : 0]);
      doubled.add(a.x, b.y);
      doubled.subtract(a.y, b.x);
    }
    return doubled.sign();
  } else {
    T doubled(0);
    for (std::size_t i = 0; i < n; ++i) {
      const auto &a = ring[i], &b = ring[i + 1 < n ? i + 1 : 0];
      doubled += a.x * b.y - a.y * b.x;
    }
    return sign_of(doubled);
  }
}

/// The chains of a ring that lie inside of a border, each from where it enters to where it leaves, and their
/// crossings. A vertex on the border is not inside: a chain ends there, and the next one may begin there.
/// Nothing when all lies inside; then the ring stays as it is.
template <class T, class Window, Observer<VertexTested<T>, EdgeCut<T>> O>
bool chains_inside(std::span<const Vertex<T>> ring, int border, const Scene<T, Window>& scene,
                   std::vector<Ring<T>>& chains, std::vector<BorderCrossing<T>>& crossings, O&& observer) {
  const std::size_t n = ring.size();
  std::vector<int> sides;
  for (const Vertex<T>& now : ring) {
    sides.push_back(side_of_border(scene, border, now));
    if constexpr (observed<O>) observer(VertexTested<T>{border, number_in(ring, now), now, sides.back()});
  }
  // Begin at a vertex that isn't inside
  const auto first = std::find_if(sides.begin(), sides.end(), [](int s) { return s <= 0; });
  if (first == sides.end()) return false;
  const std::size_t start = static_cast<std::size_t>(first - sides.begin());
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (start + k - 1) % n, j = (start + k) % n;
    const Vertex<T>&last = ring[i], &now = ring[j];
    // Enter, by a cut or at a vertex on the border
    if (sides[i] <= 0 && sides[j] > 0) {
      Vertex<T> vertex = last;
      if (sides[i] < 0) vertex = cut_edge(scene, border, last);
      chains.push_back({vertex});
      crossings.push_back({vertex, last.after, true, chains.size() - 1});
      if constexpr (observed<O>) observer(EdgeCut<T>{border, last, now, vertex, false});
    }
    // What is inside belongs to the chain
    if (sides[j] > 0) chains.back().push_back(now);
    // Leave, by a cut or at a vertex on the border
    if (sides[i] > 0 && sides[j] <= 0) {
      Vertex<T> vertex = now;
      if (sides[j] < 0) vertex = cut_edge(scene, border, last);
      vertex.after = EdgeName::window(border);
      chains.back().push_back(vertex);
      crossings.push_back({vertex, last.after, false, chains.size() - 1});
      if constexpr (observed<O>) observer(EdgeCut<T>{border, last, now, vertex, true});
    }
  }
  return true;
}

/// Puts crossings in order along a border. Two at one point are in the order that they have a little inside
/// of it: the edge that leans back comes first.
template <class T, class Window>
void order_crossings(std::vector<BorderCrossing<T>>& crossings, int border, const Scene<T, Window>& scene) {
  const Line<T> line = line_of(scene.window, border);
  const auto before = [&](const BorderCrossing<T>& a, const BorderCrossing<T>& b) {
    const int order = order_along(scene, border, a.vertex, b.vertex);
    if (order != 0) return order < 0;
    // Both edges as they point inside
    const Line<T> u = scene.line(a.edge), v = scene.line(b.edge);
    return heading(u, v) * heading(line, u) * heading(line, v) < 0;
  };
  std::sort(crossings.begin(), crossings.end(), before);
  // Of edges that run on one another take the one that keeps inside and outside in turns
  bool inside = false;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    for (std::size_t k = i; k < crossings.size() && !before(crossings[i], crossings[k]); ++k) {
      if (crossings[k].enters != inside) continue;
      std::swap(crossings[i], crossings[k]);
      break;
    }
    inside = !crossings[i].enters;
  }
}

/// Joins the crossings of a border, which are in order: the polygon lies ahead of where a ring leaves, up to
/// the next place where one enters. The chain that comes after each chain.
template <class T, Observer<CrossingsJoined<T>> O>
std::vector<std::size_t> join(std::span<const BorderCrossing<T>> crossings, std::size_t chains, int border,
                              O&& observer) {
  std::vector<std::size_t> successor(chains);
  std::vector<BorderCrossing<T>> open;  // more than one only where the polygon lies on itself
  for (const BorderCrossing<T>& now : crossings) {
    if (open.empty() || open.back().enters == now.enters) {
      open.push_back(now);
      continue;
    }
    const BorderCrossing<T> leaves = now.enters ? open.back() : now;
    const BorderCrossing<T> enters = now.enters ? now : open.back();
    open.pop_back();
    successor[leaves.chain] = enters.chain;
    if constexpr (observed<O>) observer(CrossingsJoined<T>{border, leaves.vertex, enters.vertex});
  }
  return successor;
}

/// The rings that chains make when each is followed by its successor.
template <class T, class Window>
std::vector<Ring<T>> traced(const std::vector<Ring<T>>& chains, const std::vector<std::size_t>& successor,
                            int border, const Scene<T, Window>& scene) {
  std::vector<Ring<T>> rings;
  std::vector<bool> used(chains.size());
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (used[first]) continue;
    Ring<T> ring;
    std::size_t chain = first;
    do {
      used[chain] = true;
      const Ring<T>& now = chains[chain];
      chain = successor[chain];
      ring.insert(ring.end(), now.begin(), now.end() - 1);
      // Where it leaves and enters at one point, that is one vertex
      if (order_along(scene, border, now.back(), chains[chain].front()) != 0) ring.push_back(now.back());
    } while (chain != first);
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  return rings;
}

/// Whether a vertex lies above a height: its exact place, not its rounded one. 1 above, 0 at it, -1 below.
template <class T, class Window>
int height_against(const Scene<T, Window>& scene, const Vertex<T>& v, T y) {
  if (v.at.y != y || !v.made()) return (v.at.y > y) - (v.at.y < y);
  const Line<T> horizontal{{T(0), y}, {T(1), y}};
  return side_of_crossing(horizontal, scene.line(v.edge), scene.line(v.border));
}

/// Whether a ring holds a point: an odd number of its edges pass left of it. Exact.
/// Domain: the point doesn't lie on the ring.
template <class T, class Window>
bool holds(const Scene<T, Window>& scene, std::span<const Vertex<T>> ring, glm::vec<2, T> point) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vertex<T>&a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool starts_above = height_against(scene, a, point.y) > 0;
    if (starts_above == (height_against(scene, b, point.y) > 0)) continue;
    const Line<T> line = scene.line(a.after);
    const int right_of_it = -side(line, point);
    odd ^= (line.p.y < line.q.y ? right_of_it : -right_of_it) > 0;
  }
  return odd;
}

// --- The method --------------------------------------------------

/// The rings of a polygon as it is given, one after the other: the first one its outline, the others holes.
template <class T>
struct Rings {
  std::vector<glm::vec<2, T>> points;
  std::vector<int> next;    ///< of each vertex, so that the area lies left
  std::vector<int> starts;  ///< the first vertex of every ring that has an area
  int outline_size = 0;     ///< vertices of the outline; those of holes come after them

  /// Outline counter-clockwise, holes clockwise, whichever way they come; rings without area are left out.
  explicit Rings(std::span<const std::vector<glm::vec<2, T>>> rings) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::span<const glm::vec<2, T>> ring(rings[r]);
      expect_finite(ring);
      const int turn = area_sign(ring);
      const int first = static_cast<int>(points.size()), n = static_cast<int>(ring.size());
      const bool reverse = turn == (r == 0 ? -1 : 1);
      points.insert(points.end(), ring.begin(), ring.end());
      for (int i = 0; i < n; ++i) next.push_back(first + (reverse ? i + n - 1 : i + 1) % n);
      if (turn != 0) starts.push_back(first);
      if (r == 0) outline_size = n;
    }
  }

  Ring<T> ring(std::size_t number) const {
    Ring<T> vertices;
    int i = starts[number];
    do {
      vertices.push_back({points[static_cast<std::size_t>(i)], i, {}, {}, EdgeName::polygon(i)});
      i = next[static_cast<std::size_t>(i)];
    } while (i != starts[number]);
    return vertices;
  }
};

/// The part of all rings that lies inside of one border, as rings of its own.
///
/// Steps: (VertexTested* EdgeCut*)*, ring by ring, then CrossingsOrdered CrossingsJoined* BorderSplit. A ring
///   that touches the border at a vertex has a cut there, too.
/// Cost: a test a vertex; O(k log k) for k crossings.
template <class T, class Window,
          Observer<VertexTested<T>, EdgeCut<T>, CrossingsOrdered<T>, CrossingsJoined<T>, BorderSplit<T>> O =
              Unobserved>
std::vector<Ring<T>> split_at_border(std::span<const Ring<T>> rings, int border,
                                     const Scene<T, Window>& scene, O&& observer = {}) {
  std::vector<Ring<T>> kept, chains;
  std::vector<BorderCrossing<T>> crossings;
  // Cut each ring into the chains that lie inside
  for (const Ring<T>& ring : rings) {
    const std::span<const Vertex<T>> vertices(ring);
    const bool cut = chains_inside(vertices, border, scene, chains, crossings, observer);
    if (!cut) kept.push_back(ring);
  }
  // Put the crossings in order along the border
  order_crossings(crossings, border, scene);
  if constexpr (observed<O>) observer(CrossingsOrdered<T>{border, crossings});
  // Join where one leaves with where the next enters
  const std::span<const BorderCrossing<T>> ordered(crossings);
  const auto successor = join(ordered, chains.size(), border, observer);
  // Trace the rings that this makes
  for (Ring<T>& ring : traced(chains, successor, border, scene)) kept.push_back(std::move(ring));
  if constexpr (observed<O>) observer(BorderSplit<T>{border, kept});
  return kept;
}

/// Whether a ring is a hole that nothing was cut from.
template <class T>
bool whole_hole(const Rings<T>& polygon, const Ring<T>& ring) {
  const auto made = [](const Vertex<T>& v) { return v.made() || v.after.of_window(); };
  if (std::any_of(ring.begin(), ring.end(), made)) return false;
  return ring.front().input >= polygon.outline_size;
}

/// Outlines with their holes.
template <class T, class Window>
std::vector<Piece<T>> pieces_of(std::vector<Ring<T>>& rings, const Scene<T, Window>& scene,
                                const Rings<T>& polygon) {
  std::vector<Piece<T>> pieces;
  std::vector<Ring<T>> holes;
  for (Ring<T>& ring : rings) {
    if (whole_hole(polygon, ring)) {
      holes.push_back(std::move(ring));
    } else {
      pieces.push_back({std::move(ring), {}});
    }
  }
  for (Ring<T>& hole : holes) {
    const auto around = [&](const Piece<T>& piece) {
      return holds(scene, std::span<const Vertex<T>>(piece.outline), hole.front().at);
    };
    const auto piece = std::find_if(pieces.begin(), pieces.end(), around);
    if (piece != pieces.end()) piece->holes.push_back(std::move(hole));
  }
  for (Piece<T>& piece : pieces) {
    leave_out_repeated(piece.outline);
    for (Ring<T>& hole : piece.holes) leave_out_repeated(hole);
  }
  std::erase_if(pieces, [](const Piece<T>& piece) { return piece.outline.empty(); });
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
/// Domain: finite coordinates of any size; rings that don't cross themselves or each other. They may touch
///   themselves and each other, have vertices on borders and edges along them. (Where they do cross, the
///   area, counted as often as the rings go round it, still is the right one.)
/// Steps: that of split_at_border for every border, then PieceTraced*. Until nothing is left.
/// Accuracy: decisions and orders exact; vertices as clip_to_window. Pieces have an area, and share none;
///   what touches the window in points or edges alone gives nothing.
/// Cost: one test a vertex and border; O(k log k) for k crossings on one border.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out.
template <class T, class Window,
          Observer<VertexTested<T>, EdgeCut<T>, CrossingsOrdered<T>, CrossingsJoined<T>, BorderSplit<T>,
                   PieceTraced<T>>
              O = Unobserved>
std::vector<Piece<T>> separate_pieces(const Rings<T>& polygon, const Window& window,
                                      std::span<const int> order, O&& observer = {}) {
  expect_window(window);
  const Scene<T, Window> scene{{polygon.points, polygon.next}, window};
  std::vector<Ring<T>> rings;
  for (std::size_t i = 0; i < polygon.starts.size(); ++i) rings.push_back(polygon.ring(i));
  // Split at one border after the other
  for (const int border : order) {
    if (rings.empty()) break;
    const std::span<const Ring<T>> rest(rings);
    rings = split_at_border(rest, border, scene, observer);
  }
  // Holes that no border has met lie in one of the pieces
  std::vector<Piece<T>> pieces = pieces_of(rings, scene, polygon);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if constexpr (observed<O>) observer(PieceTraced<T>{i, pieces[i]});
  }
  return pieces;
}

}  // namespace gradus::sutherland_hodgman
