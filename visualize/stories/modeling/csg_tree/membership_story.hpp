#pragma once
// A point held against each leaf, and the answers that go up the tree.

#include "stories/modeling/csg_tree/drawing.hpp"

namespace gradus::csg_tree {

/// The tree itself, its root above: leaves in a line, an operation above the middle of its operands.
class TreeDrawing {
 public:
  TreeDrawing(const DNodes& tree, const Extent& place) : tree_(tree), at_(tree.size()) {
    std::vector<Index> height(tree.size());
    const auto leaves = static_cast<double>(tree.size() / 2 + 1);
    double next = 0;
    for (Index i = 0; i < tree.size(); ++i) {
      const auto& [op, a, b, solid] = tree[i];
      if (is_leaf(tree[i])) {
        at_[i].x = place.lower.x + place.size().x * (next++ + 0.5) / leaves;
      } else {
        height[i] = std::max(height[a], height[b]) + 1;
        at_[i].x = 0.5 * (at_[a].x + at_[b].x);
      }
    }
    const double step = std::min(4.2, (place.size().y - 2 * radius) / static_cast<double>(height.back()));
    for (Index i = 0; i < tree.size(); ++i)
      at_[i].y = place.lower.y + radius + step * static_cast<double>(height[i]);
  }

  /// Its name stands in the node; what an operation is before it, what a leaf is below.
  void add_node(View& view, Index i, Role role, bool filled, const std::string& what) const {
    constexpr int corners = 32;
    Ring2 circle;
    for (int k = 0; k < corners; ++k) {
      const double turn = 2 * 3.14159265358979 * k / corners;
      circle.push_back(at_[i] + radius * dvec2{gradus::cos(turn), gradus::sin(turn)});
    }
    const std::string id = fmt::format("t node {:02}", i);
    if (filled) view.add({id, role, Area{{circle}}});
    view.add({id + " outline", role, Path{circle, true}});
    view.add({id + " name", role, Text{at_[i], name_of(tree_, i)}});
    if (is_leaf(tree_[i]))
      view.add({id + " what", Role::guide, Text{at_[i] - dvec2{0, radius + 0.9}, what}});
    else
      view.add({id + " what", role, Text{at_[i] - dvec2{radius + 0.5, 0}, what, Align::right}});
  }
  void add_branches(View& view, Index i, const std::vector<Role>& roles) const {
    if (is_leaf(tree_[i])) return;
    for (const Index operand : {tree_[i].a, tree_[i].b}) {
      const dvec2 way = glm::normalize(at_[i] - at_[operand]);
      view.add({fmt::format("s branch {:02}", operand), roles[operand],
                Stroke{at_[operand] + radius * way, at_[i] - radius * way, true}});
    }
  }

  static constexpr double radius = 1.4;

 private:
  const DNodes& tree_;
  std::vector<dvec2> at_;
};

class MembershipStory : public Past<steps::Started, LeafTested, Combined, steps::Finished> {
 public:
  template <class Along>
  MembershipStory(const Words& words, const Subject& subject, dvec2 point, const Along& along)
      : words_(words),
        subject_(subject),
        point_(point),
        section_(subject, with(extent_of(subject), point), {{1, 15.2}, {35, 26.6}}, along) {}

  dvec2 at(dvec2 p) const { return section_.at(p); }
  const Section& section() const { return section_; }

  Event say(const steps::Started&) const {
    return {.text = "membership.started",
            .words = {{"point", point_}, {"leaves", subject_.leaves().size()}},
            .level = Level::idea};
  }
  Event say(const LeafTested& l) const {
    Event event = event_of(l.node, l.in);
    event.text = l.side == 0 ? "leaf_tested.on" : l.in ? "leaf_tested.in" : "leaf_tested.out";
    event.facts.push_back({"side", std::int64_t{l.side}});
    return event;
  }
  Event say(const Combined& c) const {
    Event event = event_of(c.node, c.in);
    const auto& [op, a, b, solid] = subject_.tree[c.node];
    event.text = op == Op::unite       ? "combined.unite"
                 : op == Op::intersect ? "combined.intersect"
                                       : "combined.subtract";
    event.words.insert(event.words.end(), {{"a", name_of(subject_.tree, a)},
                                           {"b", name_of(subject_.tree, b)},
                                           {"in_a", in_or_out(c.a)},
                                           {"in_b", in_or_out(c.b)}});
    return event;
  }
  Event say(const steps::Finished&) const {
    return {.text = answers().back() ? "membership.finished.in" : "membership.finished.out",
            .words = {{"point", point_}, {"name", name_of(subject_.tree, subject_.root())}}};
  }
  /// The root's answer.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Combined>) return static_cast<double>(step.node);
    return 0;
  }

  View draw() const {
    View view;
    const std::vector<bool> known = answers();
    const bool done = now<steps::Finished>();
    const Index shown = known.empty() || done ? subject_.root() : known.size() - 1;
    section_.add_region(view, "a region", done || known.empty() ? Role::result : Role::current, shown);
    section_.add_leaves(view);
    view.add_named("g point", Role::measure, at(point_), words_.symbol("x"));
    std::vector<Role> roles;
    for (Index i = 0; i < subject_.tree.size(); ++i)
      roles.push_back(i >= known.size() ? Role::guide : known[i] ? Role::accepted : Role::rejected);
    for (Index i = 0; i < subject_.tree.size(); ++i) {
      const bool at_hand = !known.empty() && !done && i + 1 == known.size();
      drawing_.add_branches(view, i, roles);
      drawing_.add_node(view, i, at_hand ? Role::current : roles[i], i < known.size() && known[i],
                        what_of(words_, subject_, i));
    }
    return view;
  }

 private:
  std::string in_or_out(bool in) const { return words_.say(in ? "in" : "out"); }
  /// Of the nodes so far.
  std::vector<bool> answers() const {
    std::vector<bool> all_of(all<LeafTested>().size() + all<Combined>().size());
    for (const LeafTested& l : all<LeafTested>()) all_of[l.node] = l.in;
    for (const Combined& c : all<Combined>()) all_of[c.node] = c.in;
    return all_of;
  }
  Event event_of(Index node, bool in) const {
    const std::string name = name_of(subject_.tree, node);
    const std::string what = what_of(words_, subject_, node);
    return {.facts = {{"in", in}},
            .words = {{"name", name}, {"what", what}, {"point", point_}, {"answer", in_or_out(in)}},
            .row = {name, what, in_or_out(in)},
            .key = name,
            .decides = yes_or_no(words_, "question.inside", {{"name", name}, {"point", point_}}, in, "inside",
                                 "outside")};
  }

  const Words& words_;
  const Subject& subject_;
  const dvec2 point_;
  Section section_;
  TreeDrawing drawing_{subject_.tree, {{1, 1.8}, {34, 14.4}}};
};

}  // namespace gradus::csg_tree
