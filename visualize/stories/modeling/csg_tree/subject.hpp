#pragma once
// What a run is about: a solid in a few leaves, what they and the operations are called, and a ray in the
// plane z = 0, in which all is drawn.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "modeling/csg_tree/csg_tree.hpp"
#include "stories/telling.hpp"

namespace gradus::csg_tree {

using DNodes = Nodes<double>;
using DRay = Ray<double>;
using DEnds = Ends<double>;

struct Subject {
  DNodes tree{};
  std::vector<std::string> kinds{};  ///< of each leaf in turn, as texts have them: "plate"
  dvec2 from{}, to{};

  /// t counts units of length.
  DRay ray() const {
    const auto [way, length] = directed(dvec3(to - from, 0));
    return {dvec3(from, 0), way, length};
  }
  Index root() const { return tree.size() - 1; }
  std::vector<Index> leaves() const {
    std::vector<Index> all;
    for (Index i = 0; i < tree.size(); ++i) {
      if (is_leaf(tree[i])) all.push_back(i);
    }
    return all;
  }
};

/// A, B, C, …: leaves; P, Q, R, …: what operations make.
inline std::string name_of(const DNodes& tree, Index node) {
  Index number = 0;
  for (Index i = 0; i < node; ++i) number += is_leaf(tree[i]) == is_leaf(tree[node]);
  return letter(number + (is_leaf(tree[node]) ? 0 : 'P' - 'A'));
}
/// "A ∪ B", or with the operands exchanged.
inline std::string term_of(const DNodes& tree, Index i, bool exchanged = false) {
  constexpr std::array<const char*, 4> signs{"", "∪", "∩", "−"};
  const auto& [op, a, b, solid] = tree[i];
  return fmt::format("{}\u00a0{}\u00a0{}", name_of(tree, exchanged ? b : a),
                     signs[static_cast<std::size_t>(op)], name_of(tree, exchanged ? a : b));
}
/// "[2, 12] ∪ [16, 18]", "∅".
inline std::string text_of(const DEnds& ends) {
  std::string text;
  for (Index k = 0; k + 1 < ends.size(); k += 2)
    text += fmt::format("{}[{},\u00a0{}]", k > 0 ? "\u00a0∪ " : "", figure_real(ends[k]),
                        figure_real(ends[k + 1]));
  return text.empty() ? "∅" : text;
}
/// What a node is: "plate", or "A ∪ B".
inline std::string what_of(const Words& words, const Subject& subject, Index node) {
  if (!is_leaf(subject.tree[node])) return term_of(subject.tree, node);
  const std::vector<Index> leaves = subject.leaves();
  const auto number = static_cast<std::size_t>(std::ranges::find(leaves, node) - leaves.begin());
  return words.say("leaf." + subject.kinds[number]);
}
/// "A", "P = A ∪ B".
inline std::string row_name(const DNodes& tree, Index i) {
  if (is_leaf(tree[i])) return name_of(tree, i);
  return fmt::format("{}\u00a0= {}", name_of(tree, i), term_of(tree, i));
}
inline double length_in(const DEnds& ends) {
  double length = 0;
  for (Index k = 0; k + 1 < ends.size(); k += 2) length += ends[k + 1] - ends[k];
  return length;
}

// --- Shapes

namespace shapes {

inline void add(Subject& s, const char* kind, const Solid<double>& solid) {
  s.kinds.push_back(kind);
  add_leaf(s.tree, solid);
}
/// A plate with a ball as its head, drilled, and cut off at a slant.
inline void lever(Subject& s) {
  add(s, "plate", Box<double>{{2, 2, -1}, {13, 6, 1}});
  add(s, "head", Ball<double>{{14, 4, 0}, 4});
  add_node(s.tree, Op::unite, 0, 1);
  add(s, "hole", Cylinder<double>{{14, 4, 0}, 2, 2});
  add_node(s.tree, Op::subtract, 2, 3);
  add(s, "half_space", HalfSpace<double>{{-2, -1, 0}, {4, 4, 0}});
  add_node(s.tree, Op::intersect, 4, 5);
}
inline void lens(Subject& s) {
  add(s, "ball", Ball<double>{{7.5, 4, 0}, 5});
  add(s, "ball", Ball<double>{{13.5, 4, 0}, 5});
  add_node(s.tree, Op::intersect, 0, 1);
}
/// A cube and a ball in common, drilled along all axes.
inline void dice(Subject& s) {
  add(s, "cube", Box<double>{{6, 2, -4}, {14, 10, 4}});
  add(s, "ball", Ball<double>{{10, 6, 0}, 5.2});
  add_node(s.tree, Op::intersect, 0, 1);
  for (int axis = 0; axis < 3; ++axis) {
    add(s, "drill", Cylinder<double>{{10, 6, 0}, 1.5, axis});
    add_node(s.tree, Op::subtract, s.tree.size() - 2, s.tree.size() - 1);
  }
}
/// Two boxes that share a face.
inline void flush(Subject& s) {
  add(s, "box", Box<double>{{3, 1, -4}, {10, 7, 4}});
  add(s, "box", Box<double>{{10, 0, -4}, {17, 6, 4}});
  add_node(s.tree, Op::unite, 0, 1);
}

}  // namespace shapes

inline const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names{"lever", "lens", "dice", "flush"};
  return names;
}
inline const std::vector<std::string>& root_names() {
  static const std::vector<std::string> names{"given", "union", "intersection", "difference"};
  return names;
}

inline Subject subject_of(const Arguments& arguments) {
  Subject s;
  constexpr std::array makers{shapes::lever, shapes::lens, shapes::dice, shapes::flush};
  const auto position = [](const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  makers[position(shape_names(), arguments.text("shape"))](s);
  const auto root = position(root_names(), arguments.text("root"));
  if (root > 0) s.tree.back().op = static_cast<Op>(root);
  const std::vector<dvec2> ends = arguments.points("ray");
  s.from = ends[0];
  s.to = ends[1];
  if (s.from == s.to) refuse("ray", "expected two different points");
  return s;
}

}  // namespace gradus::csg_tree
