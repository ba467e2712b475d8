#pragma once
// The walk through a BSP tree: which side of each plane the eye is on, and what is drawn next.

#include "stories/past.hpp"
#include "stories/visibility/bsp_tree/drawing.hpp"

namespace gradus::bsp_tree {

/// What a run is about.
struct Subject : Polygons {
  faces_subject::Reader reader;
};

inline Subject subject_of(const Arguments& arguments) {
  const faces_subject::Reader reader = faces_subject::reader_of(arguments);
  return {polygons_of(arguments), reader};
}

/// Of the paper: the picture as it is drawn, and the tree.
inline constexpr Extent picture_place{{0.6, 0.6}, {20.6, 23.4}}, walked_place{{22, 2.4}, {35, 22.8}};

class WalkStory : public Past<steps::Started, Visited, Drawn<double>, steps::Finished> {
 public:
  WalkStory(const Words& words, const Subject& subject, const DTree& tree, PartNames names)
      : words_(words),
        tree_(tree),
        names_(std::move(names)),
        picture_(subject.reader, picture_place, subject.points),
        drawing_(tree, walked_place) {}

  dvec2 at(dvec3 p) const { return picture_.at(p); }

  Event say(const steps::Started&) const {
    return {.text = "walk", .count = static_cast<std::int64_t>(polygon_count(tree_)), .level = Level::idea};
  }

  Event say(const Visited& v) const {
    constexpr std::array<std::string_view, 3> texts{"visited.behind", "visited.in_plane", "visited.in_front"};
    constexpr std::array<const char*, 3> branches{"behind", "in the plane", "in front"};
    const auto side = static_cast<std::size_t>(v.eye_side + 1);
    const std::string name = name_of(v.node);
    return {.text = texts[side],
            .facts = {{"node", static_cast<std::int64_t>(v.node)}, {"eye_side", v.eye_side}},
            .words = {{"name", name}},
            .row = {"", name,
                    v.eye_side > 0   ? "+"
                    : v.eye_side < 0 ? "−"
                                     : "0"},
            .key = name,
            .decides = Decision{words_.say("question.eye", {{"name", name}}),
                                {words_.say("side.2"), words_.say("side.0"), words_.say("side.1")},
                                side,
                                branches[side]}};
  }

  Event say(const Drawn<double>& d) const {
    const std::string& name = names_(d.polygon);
    const std::int64_t number = std::ssize(all<Drawn<double>>());
    return {.text = number == 1 ? "drawn.first" : "drawn",
            .facts = {{"number", number}},
            .words = {{"name", name}},
            .row = {number, name, ""},
            .key = name};
  }

  Event say(const steps::Finished&) const {
    const auto order = mapped(all<Drawn<double>>(), [&](const auto& d) { return names_(d.polygon); });
    return {.text = "walked", .words = {{"order", fmt::format("{}", fmt::join(order, ", "))}}};
  }

  View draw() const {
    View view;
    const Role drawn = now<steps::Finished>() ? Role::result : Role::input;
    std::vector<ShownFace> faces;
    std::vector<std::size_t> numbers(tree_.size());
    for (const auto& [node, polygon] : all<Drawn<double>>()) {
      faces.push_back({names_(polygon), polygon.corners, drawn});
      numbers[node] = faces.size();
    }
    if (now<Drawn<double>>()) faces.back().role = Role::current;
    std::vector<Ring> waiting;
    for (const Node<double>& node : tree_) {
      for (const DPolygon& polygon : node.polygons) waiting.push_back(polygon.corners);
    }
    picture_.add_painted(view, std::move(faces), waiting);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      const Role role = is_at(i) ? Role::current : numbers[i] > 0 ? drawn : Role::past;
      drawing_.add_node(view, i, role, name_of(i) + (tree_[i].polygons.size() > 1 ? "…" : ""));
      if (tree_[i].in_front != none) drawing_.add_branch(view, i, tree_[i].in_front, true, Role::past);
      if (tree_[i].behind != none) drawing_.add_branch(view, i, tree_[i].behind, false, Role::past);
      if (numbers[i] > 0) drawing_.add_number(view, i, numbers[i]);
    }
    return view;
  }

 private:
  const std::string& name_of(std::size_t node) const { return names_(tree_[node].polygons.front()); }
  bool is_at(std::size_t node) const {
    const auto* visited = now<Visited>();
    const auto* drawn = now<Drawn<double>>();
    return (visited && visited->node == node) || (drawn && drawn->node == node);
  }

  const Words& words_;
  const DTree& tree_;
  const PartNames names_;
  FacesPicture picture_;
  TreeDrawing drawing_;
};

}  // namespace gradus::bsp_tree
