#pragma once
// Constructive solid geometry: a tree of Boolean operations over simple solids. Nothing is ever intersected:
// what is asked of the tree - is this point inside, where is this ray inside - is asked of its leaves, and
// the answers are combined node by node.

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/observe.hpp"
#include "modeling/csg_tree/solids.hpp"

namespace gradus::csg_tree {

using Index = std::size_t;

enum class Op : std::uint8_t { leaf, unite, intersect, subtract };

/// A solid, or an operation on two nodes before it.
template <class T>
struct Node {
  Op op = Op::leaf;
  Index a = 0, b = 0;  ///< of an operation: its operands
  Solid<T> solid{};    ///< of a leaf
};
/// Operands stand before what is made of them; the last node is the root.
template <class T>
using Tree = std::span<const Node<T>>;
template <class T>
using Nodes = std::vector<Node<T>>;

/// Of each node.
template <class T>
using EndsOfAll = std::vector<Ends<T>>;

template <class T>
Index add_leaf(Nodes<T>& tree, const Solid<T>& solid) {
  tree.push_back({Op::leaf, 0, 0, solid});
  return tree.size() - 1;
}
template <class T>
Index add_node(Nodes<T>& tree, Op op, Index a, Index b) {
  tree.push_back({op, a, b, tree[a].solid});
  return tree.size() - 1;
}

// --- Steps -------------------------------------------------------

/// A point was held against a leaf.
struct LeafTested {
  Index node;
  int side;  ///< of its surface: -1 inside, 0 on it, +1 outside
  bool in;   ///< on a surface: by the rule of solids.hpp
};
/// What its operands say of the point was combined.
struct Combined {
  Index node;
  Op op;
  bool a, b, in;
};

/// A leaf has its ends along the ray.
template <class T>
struct LeafHit {
  Index node;
  Ends<T> ends;
};
/// Its operands' ends were merged.
template <class T>
struct NodeMerged {
  Index node;
  Op op;
  Ends<T> a, b, ends;
};

/// A node's ends are still right.
struct Reused {
  Index node;
};
/// A node was computed again.
template <class T>
struct Renewed {
  Index node;
  Ends<T> before, now;
};
/// A node has its earlier ends again.
template <class T>
struct Restored {
  Index node;
  Ends<T> ends;
};

// --- Combining ---------------------------------------------------

template <class T>
bool is_leaf(const Node<T>& node) {
  return node.op == Op::leaf;
}

constexpr bool apply(Op op, bool a, bool b) {
  if (op == Op::unite) return a || b;
  return op == Op::intersect ? a && b : a && !b;
}

/// Of two lists the next end; at least one has one.
template <class T>
T next_end(const Ends<T>& a, Index i, const Ends<T>& b, Index j) {
  if (i == a.size()) return b[j];
  return j == b.size() ? a[i] : std::min(a[i], b[j]);
}
template <class T>
bool is_at(const Ends<T>& ends, Index i, T t) {
  return i < ends.size() && ends[i] == t;
}

/// Where a ray is in what an operation makes of two solids, from where it is in these.
/// Accuracy: exact: ends are compared and copied.
/// Cost: one pass, two comparisons per end.
template <class T>
Ends<T> merged(Op op, const Ends<T>& a, const Ends<T>& b) {
  Ends<T> out;
  Index n = a.size() + b.size();
  Index i = 0, j = 0;
  while (i + j < n) {
    T t = next_end(a, i, b, j);
    // At one t both may change
    if (is_at(a, i, t)) ++i;
    if (is_at(b, j, t)) ++j;
    // Past an odd number: inside
    bool in_a = i % 2 == 1;
    bool in_b = j % 2 == 1;
    bool in = apply(op, in_a, in_b);
    bool was = out.size() % 2 == 1;
    if (in != was) out.push_back(t);
  }
  return out;
}

/// Whether an operation has an operand among these.
template <class T>
bool reads(const Node<T>& node, const std::vector<bool>& these) {
  return !is_leaf(node) && (these[node.a] || these[node.b]);
}

template <class T>
void expect_tree(Tree<T> tree) {
  expects(!tree.empty(), "a tree has at least one node");
  for (Index i = 0; i < tree.size(); ++i) {
    const Node<T>& node = tree[i];
    if (is_leaf(node))
      expect_any(node.solid);
    else
      expects(node.a < i && node.b < i, "node {} has operands {} and {}, which don't stand before it", i,
              node.a, node.b);
  }
}

// --- The methods -------------------------------------------------

/// Whether a point is inside: every leaf says so for itself, every node combines two of these answers.
/// Source: A. A. G. Requicha, H. B. Voelcker, Constructive solid geometry, 1977; R. B. Tilove, Set membership
/// classification, 1980.
///
/// tree: operands before what is made of them. x: the point.
///
/// Domain: numbers up to an eighth of the largest, radii from 0 on, boxes not inside out, normals not 0.
/// Steps: for each node in their order LeafTested or Combined.
/// Accuracy: exact, for points on surfaces, too, by the rule of solids.hpp.
/// Cost: one test per leaf, a few ns, in doubt a microsecond; one operation per node.
/// Errors: ContractViolation outside the domain.
template <class T, Observer<LeafTested, Combined> O = Unobserved>
bool contains(Tree<T> tree, const Point<T>& x, O&& observer = {}) {
  expect_tree(tree);
  expects(is_moderate(x), "a point's numbers are not finite, or huge");
  const Index n = tree.size();
  std::vector<bool> in(n);
  for (Index i = 0; i < n; ++i) {
    const Node<T>& node = tree[i];
    if (is_leaf(node)) {
      auto& solid = node.solid;
      auto at = placed(solid, x);
      in[i] = at.in;
      if constexpr (observed<O>) observer(LeafTested{i, at.side, at.in});
      continue;
    }
    bool a = in[node.a];
    bool b = in[node.b];
    in[i] = apply(node.op, a, b);
    if constexpr (observed<O>) observer(Combined{i, node.op, a, b, in[i]});
  }
  return in.back();
}

/// Where a ray is inside: every leaf has its interval, every node merges those of two.
/// Source: S. D. Roth, Ray casting for modeling solids, 1982.
///
/// tree: as for contains. ray: from + t way, t from 0 to last. Returns the root's ends.
///
/// Domain: that of contains; way not 0, last above 0.
/// Steps: for each node in their order LeafHit or NodeMerged.
/// Accuracy: merging is exact. A leaf's ends lie on its surface: at a box's face within 3 u of the face's
///   distance from the ray's begin; beside a plane by at most 8 u of what normal · (x - on) adds up in size;
///   and of a round solid the squared distance from the centre is that of the radius within 16 u of the
///   squared
///   (|from - centre| + radius). Between ends it is as contains has it.
/// Cost: a division per half-space, six per box, two and a square root per round solid; one pass per node.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<LeafHit<T>, NodeMerged<T>> O = Unobserved>
Ends<T> along_ray(Tree<T> tree, const Ray<T>& ray, O&& observer = {}) {
  expect_tree(tree);
  expect_ray(ray);
  const Index n = tree.size();
  EndsOfAll<T> on(n);
  for (Index i = 0; i < n; ++i) {
    const Node<T>& node = tree[i];
    if (is_leaf(node)) {
      auto& solid = node.solid;
      on[i] = ends_in(solid, ray);
      if constexpr (observed<O>) observer(LeafHit<T>{i, on[i]});
      continue;
    }
    // Both operands are done
    auto& a = on[node.a];
    auto& b = on[node.b];
    on[i] = merged(node.op, a, b);
    if constexpr (observed<O>) observer(NodeMerged<T>{i, node.op, a, b, on[i]});
  }
  return on.back();
}

// --- Changing a leaf ---------------------------------------------

/// A tree with what each of its nodes has along a ray.
template <class T>
struct Evaluation {
  Nodes<T> tree;
  Ray<T> ray;
  EndsOfAll<T> on{};
};
/// What a change has replaced.
template <class T>
struct Undo {
  Index leaf;
  Solid<T> solid;
  std::vector<std::pair<Index, Ends<T>>> on{};
};

/// A node's ends from those of its operands.
template <class T>
Ends<T> found(const Evaluation<T>& e, Index i) {
  const auto& [op, a, b, solid] = e.tree[i];
  return op == Op::leaf ? ends_in(solid, e.ray) : merged(op, e.on[a], e.on[b]);
}
template <std::floating_point T>
Evaluation<T> evaluated(Nodes<T> tree, const Ray<T>& ray) {
  expect_tree<T>(tree);
  expect_ray(ray);
  Evaluation<T> e{std::move(tree), ray};
  for (Index i = 0; i < e.tree.size(); ++i) e.on.push_back(found(e, i));
  return e;
}

/// Puts another solid into a leaf. Computed again is the leaf, and a node if an operand has come out
/// otherwise: at most the way from the leaf to the root.
///
/// e: what is known so far. leaf: a leaf. solid: what it is from now on. Returns what restores the state
///   before.
///
/// Domain: that of along_ray.
/// Steps: for each node in their order Reused or Renewed.
/// Accuracy: the same ends, bit for bit, as if all were computed.
/// Cost: one pass per node on the way.
/// Errors: ContractViolation outside the domain, and where the node is no leaf.
template <std::floating_point T, Observer<Reused, Renewed<T>> O = Unobserved>
Undo<T> change(Evaluation<T>& e, Index leaf, const Solid<T>& solid, O&& observer = {}) {
  expects(leaf < e.tree.size() && is_leaf(e.tree[leaf]), "node {} is no leaf", leaf);
  expect_any(solid);
  const Index n = e.tree.size();
  auto& its = e.tree[leaf].solid;
  Undo<T> undo{leaf, its};
  its = solid;
  std::vector<bool> fresh(n);
  for (Index i = 0; i < n; ++i) {
    const Node<T>& node = e.tree[i];
    bool below = reads(node, fresh);
    if (i != leaf && !below) {
      if constexpr (observed<O>) observer(Reused{i});
      continue;
    }
    Ends<T> now = found(e, i);
    fresh[i] = now != e.on[i];
    if constexpr (observed<O>) observer(Renewed<T>{i, e.on[i], now});
    swap(now, e.on[i]);
    undo.on.emplace_back(i, now);
  }
  return undo;
}

/// Takes a change back, the last one first.
/// Steps: Restored for each node that was computed again.
/// Accuracy: the state before, bit for bit.
template <class T, Observer<Restored<T>> O = Unobserved>
void restore(Evaluation<T>& e, const Undo<T>& undo, O&& observer = {}) {
  auto& its = e.tree[undo.leaf];
  its.solid = undo.solid;
  for (auto& [i, ends] : undo.on) {
    e.on[i] = ends;
    if constexpr (observed<O>) observer(Restored<T>{i, ends});
  }
}

// --- Volume ------------------------------------------------------

/// The volume of the part in a box: n x n rays along x, each counting for its part of the cross-section.
/// Source: Roth 1982, section on mass properties; Y. T. Lee, A. A. G. Requicha, Algorithms for computing the
/// volume and other integral properties of solids, 1982.
/// Domain: that of along_ray; the box has a size in all axes; n >= 1.
/// Accuracy: for what rays in the middle of cells miss there is no bound; sums are those of the rays' ends.
template <std::floating_point T>
T volume(Tree<T> tree, const Box<T>& box, int n) {
  expect_solid(box);
  const Point<T> size = box.size(), way(1, 0, 0);
  T sum(0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const T y = (T(i) + T(0.5)) / T(n), z = (T(j) + T(0.5)) / T(n);
      const Point<T> from{box.lower.x, box.lower.y + y * size.y, box.lower.z + z * size.z};
      const Ends<T> ends = along_ray<T>(tree, {from, way, size.x});
      for (Index k = 0; k < ends.size(); k += 2) sum += ends[k + 1] - ends[k];
    }
  }
  return sum * (size.y / T(n)) * (size.z / T(n));
}

}  // namespace gradus::csg_tree
