#pragma once
// A tree over points of the plane or of space that finds the nearest ones: each node parts a cell by a line
// through its middle point, and a search leaves out every cell that lies farther away than what it has found.
//
// Distances are compared as they are rounded, squared: of two equal ones the point with the smaller index is
// nearer. So a search has one right answer, the same as by brute force, and the same on every machine.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::kd_tree {

using Index = std::uint32_t;

/// In the place of a node: there is none.
inline constexpr Index none = std::numeric_limits<Index>::max();

template <int N, class T>
using Point = glm::vec<N, T>;
template <int N, class T>
using Points = std::span<const Point<N, T>>;

/// A point that was found; nearer ones are less.
template <class T>
struct Neighbour {
  T distance;  ///< squared
  Index point;

  friend bool operator==(const Neighbour&, const Neighbour&) = default;
  friend bool operator<(const Neighbour& a, const Neighbour& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.point < b.point);
  }
};
template <class T>
using Neighbours = std::vector<Neighbour<T>>;

/// A point with the axis that its line or plane lies across.
struct Node {
  Index point;
  int axis;

  friend bool operator==(const Node&, const Node&) = default;
};

/// A part of the plane or of space, and the nodes in it: the middle one parts it.
template <int N, class T>
struct Cell {
  Index first, last;  ///< the last one is no longer in it
  AxisBox<N, T> box;
  Index parent = none;  ///< the node beside whose line it lies

  bool empty() const { return first == last; }
  Index middle() const { return first + (last - first) / 2; }
};

/// The nodes of a cell stand together, those below its middle one before it, those above behind it.
template <int N, class T>
struct Tree {
  Points<N, T> points;  ///< which must outlive the tree
  std::vector<Node> nodes;
  AxisBox<N, T> box;  ///< of all points

  const Point<N, T>& at(Index node) const { return points[nodes[node].point]; }
  /// The point in the middle of a cell.
  Index middle(const Cell<N, T>& cell) const { return nodes[cell.middle()].point; }
  Cell<N, T> whole() const { return {0, static_cast<Index>(nodes.size()), box}; }
};

// --- Steps -------------------------------------------------------

/// A cell was parted: its middle node has a point and an axis.
template <int N, class T>
struct Parted {
  Cell<N, T> cell;
  Node middle;
};

struct Built {
  Index nodes;
};

/// A cell may hold a nearer point.
template <int N, class T>
struct Entered {
  Cell<N, T> cell;
  T distance;  ///< of its nearest place, squared
};

/// It can't, and is left out with all that lies in it.
template <int N, class T>
struct CutOff {
  Cell<N, T> cell;
  T distance;
};

/// The distance of a point was computed.
template <class T>
struct Measured {
  Neighbour<T> found;
  std::size_t rank;  ///< among the nearest so far, from 1 on; 0: it is none of them
};

struct Finished {
  std::int64_t distances;  ///< of points
  std::int64_t cells;      ///< whose distance was computed
};

/// Counts both.
struct Work {
  std::int64_t distances = 0, cells = 0;

  template <int N, class T>
  Entered<N, T> operator()(const Entered<N, T>& step) {
    ++cells;
    return step;
  }
  template <int N, class T>
  CutOff<N, T> operator()(const CutOff<N, T>& step) {
    ++cells;
    return step;
  }
  template <class T>
  Measured<T> operator()(const Measured<T>& step) {
    ++distances;
    return step;
  }
  Finished operator()(Finished) const { return {distances, cells}; }
};

// --- Distances ---------------------------------------------------

/// The largest coordinate: no distance overflows when it is squared.
template <std::floating_point T>
inline constexpr T most_coordinate = [] {
  T most(1);
  for (int i = 0; i < std::numeric_limits<T>::max_exponent / 2 - 3; ++i) most *= 2;
  return most;
}();

/// The distance of two points, squared; the sum is rounded as it stands here.
template <int N, class T>
constexpr T distance(const Point<N, T>& p, const Point<N, T>& q) {
  const auto square = [](const T& x) { return unfused(T(x * x)); };
  T sum = square(p[0] - q[0]);
  for (int axis = 1; axis < N; ++axis) sum += square(p[axis] - q[axis]);
  return sum;
}

/// That of the place in a box which is nearest to q: no point of the box has a smaller one, as rounded. On
/// each axis the place lies between q and the point, or at q. Rounding keeps order, x <= y => fl(x) <= fl(y),
/// so differences, their squares and sums of these, taken alike, keep it as well.
template <int N, class T>
constexpr T distance(const AxisBox<N, T>& box, const Point<N, T>& q) {
  Point<N, T> place(q);
  for (int axis = 0; axis < N; ++axis) place[axis] = std::clamp(q[axis], box.lower[axis], box.upper[axis]);
  return distance<N, T>(place, q);
}

/// The k nearest points so far, the nearest first.
template <class T>
class Nearest {
 public:
  explicit Nearest(std::size_t k) : k_(k) {}

  /// Whether a point at this distance may be one of them. One as far as the last of them may: its index
  /// could be smaller.
  bool reaches(const T& distance) const { return found_.size() < k_ || !(found_.back().distance < distance); }
  /// The rank that the point gets, or 0.
  std::size_t take(const T& distance, Index point) {
    const Neighbour<T> next{distance, point};
    if (found_.size() == k_ && !(next < found_.back())) return 0;
    if (found_.size() == k_) found_.pop_back();
    const auto at = found_.insert(std::ranges::upper_bound(found_, next, std::less<>{}), next);
    return static_cast<std::size_t>(at - found_.begin()) + 1;
  }
  const Neighbours<T>& found() const { return found_; }

 private:
  std::size_t k_;
  Neighbours<T> found_{};
};

// --- What the methods ask for ------------------------------------

template <int N, class T>
void expect_point(const Point<N, T>& p) {
  for (int axis = 0; axis < N; ++axis) {
    expects(all_finite(p[axis]), "a coordinate is not finite");
    if constexpr (std::floating_point<T>)
      expects(-most_coordinate<T> <= p[axis] && p[axis] <= most_coordinate<T>, "a coordinate is above {}",
              most_coordinate<T>);
  }
}

template <int N, class T>
void expect_points(Points<N, T> points) {
  expects(points.size() < none, "at most {} points expected, not {}", none - 1, points.size());
  for (const Point<N, T>& p : points) expect_point<N, T>(p);
}

template <int N, class T>
void expect_query(const Point<N, T>& q, std::size_t k) {
  expects(k >= 1, "expected to look for at least one point");
  expect_point<N, T>(q);
}

// --- Cells -------------------------------------------------------

template <int N, class T>
using Cells = std::vector<Cell<N, T>>;

/// A cell of no points holds nothing to do.
template <int N, class T>
void push(Cells<N, T>& waiting, const Cell<N, T>& cell) {
  if (!cell.empty()) waiting.push_back(cell);
}
template <int N, class T>
Cell<N, T> pop(Cells<N, T>& waiting) {
  const Cell<N, T> last = waiting.back();
  waiting.pop_back();
  return last;
}
template <int N, class T>
Cells<N, T> whole(const Tree<N, T>& tree) {
  Cells<N, T> waiting;
  push(waiting, tree.whole());
  return waiting;
}

/// What lies below a cell's middle, and what above it; its line belongs to both.
template <int N, class T>
Cell<N, T> below(const Tree<N, T>& tree, Cell<N, T> cell) {
  const Index m = cell.middle();
  const int axis = tree.nodes[m].axis;
  cell.box.upper[axis] = tree.at(m)[axis];
  return {cell.first, m, cell.box, m};
}
template <int N, class T>
Cell<N, T> above(const Tree<N, T>& tree, Cell<N, T> cell) {
  const Index m = cell.middle();
  const int axis = tree.nodes[m].axis;
  cell.box.lower[axis] = tree.at(m)[axis];
  return {m + 1, cell.last, cell.box, m};
}

/// Both, as q lies to the line; on it the one above is near.
template <int N, class T>
struct Halves {
  Cell<N, T> near, far;
};
template <int N, class T>
Halves<N, T> halves(const Tree<N, T>& tree, const Cell<N, T>& cell, const Point<N, T>& q) {
  const Index m = cell.middle();
  const int axis = tree.nodes[m].axis;
  const auto low = below(tree, cell), high = above(tree, cell);
  if (q[axis] < tree.at(m)[axis]) return {low, high};
  return {high, low};
}

// --- Building ----------------------------------------------------

/// The box of some points.
template <int N, class T>
AxisBox<N, T> box_around(Points<N, T> points) {
  if (points.empty()) return {Point<N, T>(T(0)), Point<N, T>(T(0))};
  AxisBox<N, T> box{points[0], points[0]};
  for (const Point<N, T>& p : points) {
    for (int axis = 0; axis < N; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], p[axis]);
      box.upper[axis] = std::max(box.upper[axis], p[axis]);
    }
  }
  return box;
}

/// A node for each point, in their order.
template <int N, class T>
Tree<N, T> unparted(Points<N, T> points) {
  Tree<N, T> tree{points, {}, box_around<N, T>(points)};
  tree.nodes.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) tree.nodes.push_back({static_cast<Index>(i), 0});
  return tree;
}

/// The axis along which a box is longest, of equal ones the first.
template <int N, class T>
int longest_side(const AxisBox<N, T>& box) {
  int longest = 0;
  for (int axis = 1; axis < N; ++axis) {
    if (box.upper[longest] - box.lower[longest] < box.upper[axis] - box.lower[axis]) longest = axis;
  }
  return longest;
}

/// Puts the point in the middle place that stands there once all are sorted along the axis, of equal ones by
/// index, with the less before and the greater behind it.
template <int N, class T>
Node part(Tree<N, T>& tree, const Cell<N, T>& cell, int axis) {
  const auto at = [&](Index node) { return tree.nodes.begin() + static_cast<std::ptrdiff_t>(node); };
  const auto less = [&](const Node& a, const Node& b) {
    const T &x = tree.points[a.point][axis], &y = tree.points[b.point][axis];
    return x < y || (x == y && a.point < b.point);
  };
  std::nth_element(at(cell.first), at(cell.middle()), at(cell.last), less);
  tree.nodes[cell.middle()].axis = axis;
  return tree.nodes[cell.middle()];
}

/// A tree over points: each cell is parted across its longest side by its middle point.
/// Source: J. L. Bentley, Multidimensional binary search trees used for associative searching, 1975;
/// J. H. Friedman, J. L. Bentley, R. A. Finkel, An algorithm for finding best matches in logarithmic expected
/// time, 1977.
///
/// points: of the plane or of space; the tree refers to them. A cell is the box of all points, cut by the
///   lines above it. Of n points the middle is the one with n/2 before it, rounded down, sorted along the
///   axis and, where they have the same coordinate, by index.
///
/// Domain: any number of points below 2^32 - 1, also none and equal ones; finite, coordinates up to 2^509 in
///   double, 2^61 in float.
/// Steps: Parted for each point, a cell before its parts, Built.
/// Accuracy: exact: coordinates are only compared, but for which of two sides is the longer. The tree is one
///   for its points. No point lies deeper than 1 + log2 n.
/// Cost: n log n comparisons in the mean; 8 bytes for each point.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Parted<N, T>, Built> O = Unobserved>
Tree<N, T> build(Points<N, T> points, O&& observer = {}) {
  expect_points<N, T>(points);
  auto tree = unparted(points);
  auto rest = whole(tree);
  while (!rest.empty()) {
    auto cell = pop(rest);
    int a = longest_side(cell.box);
    // The middle along that axis
    auto node = part(tree, cell, a);
    if constexpr (observed<O>) observer(Parted<N, T>{cell, node});
    push(rest, above(tree, cell));
    push(rest, below(tree, cell));
  }
  if constexpr (observed<O>) observer(Built{static_cast<Index>(tree.nodes.size())});
  return tree;
}

// --- Searching ---------------------------------------------------

/// The k points nearest to a place, the nearest first.
/// Source: J. H. Friedman, J. L. Bentley, R. A. Finkel, 1977.
///
/// tree: of build. q: any place. k: how many; all where there are no more.
///
/// Domain: q as the points of build; k >= 1.
/// Steps: (Entered Measured | CutOff)*, Finished.
/// Accuracy: the same as brute_force finds: the order is that of distances as they are rounded, and no cell
///   is cut off that holds one as near. So each of them is within 11 u of as near, squared, as the one of its
///   rank is exactly, or within 3 of the smallest subnormal numbers; u = 2^-53 in double.
/// Cost: some log n distances for few, evenly spread points near q; all n at worst, as on a circle round q.
///   Each that is kept moves up to k others.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Entered<N, T>, CutOff<N, T>, Measured<T>, Finished> O = Unobserved>
Neighbours<T> nearest(const Tree<N, T>& tree, const Point<N, T>& q, std::size_t k, O&& observer = {}) {
  expect_query<N, T>(q, k);
  Tally<O, Work> tally(observer);
  const auto& P = tree.points;
  Nearest<T> best(k);
  auto rest = whole(tree);
  while (!rest.empty()) {
    auto cell = pop(rest);
    T d = distance(cell.box, q);
    // Nothing nearer in it: cut off
    if (!best.reaches(d)) {
      if constexpr (observed<O>) observer(tally.count(CutOff<N, T>{cell, d}));
      continue;
    }
    if constexpr (observed<O>) observer(tally.count(Entered<N, T>{cell, d}));
    auto i = tree.middle(cell);
    T own = distance<N, T>(P[i], q);
    auto rank = best.take(own, i);
    if constexpr (observed<O>) observer(tally.count(Measured<T>{{own, i}, rank}));
    // The query's side comes first
    auto h = halves(tree, cell, q);
    push(rest, h.far);
    push(rest, h.near);
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
  return best.found();
}

/// The same from the distances of all points.
///
/// points, q, k: as for build and nearest.
///
/// Domain: as build and nearest.
/// Steps: Measured for each point, Finished.
/// Accuracy: as nearest.
/// Cost: n distances. Each that is kept moves up to k others.
/// Errors: ContractViolation outside the domain.
template <int N, class T, Observer<Measured<T>, Finished> O = Unobserved>
Neighbours<T> brute_force(Points<N, T> points, const Point<N, T>& q, std::size_t k, O&& observer = {}) {
  expect_points<N, T>(points);
  expect_query<N, T>(q, k);
  Tally<O, Work> tally(observer);
  Nearest<T> best(k);
  auto n = points.size();
  for (Index i = 0; i < n; ++i) {
    auto& p = points[i];
    T d = distance<N, T>(p, q);
    auto rank = best.take(d, i);
    if constexpr (observed<O>) observer(tally.count(Measured<T>{{d, i}, rank}));
  }
  if constexpr (observed<O>) observer(tally.count(Finished{0, 0}));
  return best.found();
}

}  // namespace gradus::kd_tree
