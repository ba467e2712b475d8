#pragma once
// The walk through a BSP tree: which side of each plane the eye is on, and what is drawn next.

#include "stories/visibility/bsp_tree_drawing.hpp"

namespace gradus::bsp_tree {

/// What a run is about.
struct Task {
  faces_task::Reader reader;
  std::vector<faces_task::NamedPart> parts;
  std::vector<DPolygon> polygons{};
  std::vector<dvec3> points{};
};

inline Task task_of(const Arguments& arguments) {
  Task task{faces_task::reader_of(arguments), faces_task::parts_of(faces_task::faces_of(arguments))};
  for (std::size_t i = 0; i < task.parts.size(); ++i) {
    task.polygons.push_back({task.parts[i].ring, i});
    task.points.insert(task.points.end(), task.parts[i].ring.begin(), task.parts[i].ring.end());
  }
  return task;
}

/// Of the paper: the picture as it is drawn, and the tree.
inline constexpr Extent picture_place{{0.6, 0.6}, {20.6, 23.4}}, walked_place{{22, 2.4}, {35, 22.8}};

class WalkStory {
 public:
  WalkStory(const Words& words, const Task& task, const DTree& tree, PartNames names)
      : words_(words),
        tree_(tree),
        names_(std::move(names)),
        picture_(task.reader, picture_place, task.points),
        drawing_(tree, walked_place),
        numbers_(tree.size()) {}

  const FacesPicture& picture() const { return picture_; }

  void show(Board& board, const steps::Started&) { put(board, Role::input); }
  Event say(const steps::Started&) const {
    return {.text = "walk",
            .count = static_cast<std::int64_t>(polygon_count(tree_)),
            .begins = true,
            .level = Level::idea};
  }

  void show(Board& board, const Visited& v) {
    node_ = v.node;
    put(board, Role::input);
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

  void show(Board& board, const Drawn<double>& d) {
    node_ = d.node;
    drawn_.push_back(d.polygon);
    numbers_[d.node] = drawn_.size();
    put(board, Role::current);
  }
  Event say(const Drawn<double>& d) const {
    const std::string name = names_(d.polygon);
    return {.text = drawn_.size() == 1 ? "drawn.first" : "drawn",
            .facts = {{"number", std::ssize(drawn_)}},
            .words = {{"name", name}, {"number", drawn_.size()}},
            .row = {drawn_.size(), name, ""},
            .key = name};
  }

  void show(Board& board, const steps::Finished&) {
    node_ = none;
    ended_ = true;
    put(board, Role::result);
  }
  Event say(const steps::Finished&) const {
    std::vector<std::string> order;
    for (const DPolygon& polygon : drawn_) order.push_back(names_(polygon));
    return {.text = "walked", .words = {{"order", fmt::format("{}", fmt::join(order, ", "))}}};
  }

 private:
  std::string name_of(std::size_t node) const { return names_(tree_[node].polygons.front()); }

  void put(Board& board, Role last) const {
    View view;
    std::vector<ShownFace> faces;
    for (const DPolygon& polygon : drawn_)
      faces.push_back({names_(polygon), polygon.corners, ended_ ? Role::result : Role::input});
    if (!faces.empty()) faces.back().role = last;
    std::vector<std::vector<dvec3>> waiting;
    for (const Node<double>& node : tree_) {
      for (const DPolygon& polygon : node.polygons) waiting.push_back(polygon.corners);
    }
    picture_.add_painted(view, std::move(faces), waiting);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      const Role role = i == node_        ? Role::current
                        : numbers_[i] > 0 ? (ended_ ? Role::result : Role::input)
                                          : Role::past;
      drawing_.add_node(view, i, role, name_of(i) + (tree_[i].polygons.size() > 1 ? "…" : ""));
      if (tree_[i].in_front != none) drawing_.add_branch(view, i, tree_[i].in_front, true, Role::past);
      if (tree_[i].behind != none) drawing_.add_branch(view, i, tree_[i].behind, false, Role::past);
      if (numbers_[i] > 0) drawing_.add_number(view, i, numbers_[i]);
    }
    board.milestone(std::move(view));
  }

  const Words& words_;
  const DTree& tree_;
  const PartNames names_;
  FacesPicture picture_;
  TreeDrawing drawing_;
  std::vector<DPolygon> drawn_{};
  std::vector<std::size_t> numbers_;
  std::size_t node_ = none;
  bool ended_ = false;
};

}  // namespace gradus::bsp_tree
