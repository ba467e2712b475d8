#pragma once
// The walk through a BSP tree: which side of each plane the eye is on, and what is drawn next.

#include "stories/past.hpp"
#include "stories/visibility/bsp_tree/plan.hpp"

namespace gradus::bsp_tree {

/// What a run is about.
struct Subject : Polygons {
  faces_subject::Reader reader;
  dvec3 towards;  ///< the reader, as it was given: of any length
};

inline Subject subject_of(const Arguments& arguments) {
  const faces_subject::Reader reader = faces_subject::reader_of(arguments);
  return {polygons_of(arguments), reader, *arguments.place("towards")};
}

/// The plan of polygons that have one.
inline std::optional<Plan> plan_of(const Subject& subject, const DTree& tree, const Extent& place) {
  const auto along = direction_of_walls(subject.polygons);
  if (!along) return std::nullopt;
  return Plan(*along, place, tree, subject.points, subject.towards);
}

/// Of the paper: the picture as it is drawn, and the tree.
inline constexpr Extent picture_place{{0.6, 0.6}, {20.6, 23.4}}, walked_place{{22, 2.4}, {35, 22.8}};

class WalkStory : public Past<steps::Started, Visited, Drawn<double>, steps::Finished> {
 public:
  WalkStory(const Words& words, const Subject& subject, const DTree& tree, PartNames names)
      : words_(words),
        subject_(subject),
        tree_(tree),
        names_(std::move(names)),
        picture_(subject.reader, picture_place, subject.points),
        plan_(plan_of(subject, tree, picture_place)),
        drawing_(tree, walked_place) {}

  dvec2 at(dvec3 p) const { return picture_.at(p); }
  const std::optional<Plan>& plan() const { return plan_; }
  /// A node where something is beyond and something on the eye's side, when some are drawn already.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Visited>) {
      const Node<double>& node = tree_[step.node];
      const auto children = (node.in_front != none ? 1 : 0) + (node.behind != none ? 1 : 0);
      return children == 0 ? 0 : children + static_cast<double>(all<Drawn<double>>().size());
    }
    return 0;
  }

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
    const auto& drawn = all<Drawn<double>>();
    if (plan_)
      add_plan(view);
    else
      add_picture(view);
    std::vector<std::size_t> numbers(tree_.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) numbers[drawn[i].node] = i + 1;
    const std::vector<Role> roles = roles_of_nodes();
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      const auto& [plane, polygons, in_front, behind] = tree_[i];
      drawing_.add_node(view, i, roles[i], name_of(i) + (polygons.size() > 1 ? "…" : ""));
      if (in_front != none) drawing_.add_branch(view, i, in_front, true, branch_role(roles[in_front]));
      if (behind != none) drawing_.add_branch(view, i, behind, false, branch_role(roles[behind]));
      if (numbers[i] > 0) drawing_.add_number(view, i, numbers[i]);
    }
    return view;
  }

 private:
  const std::string& name_of(std::size_t node) const { return names_(tree_[node].polygons.front()); }
  Role drawn_role() const { return now<steps::Finished>() ? Role::result : Role::input; }
  static Role branch_role(Role node) {
    return node == Role::accepted || node == Role::candidate ? node : Role::past;
  }

  /// What is drawn, what is to come, and of what is below a node just visited what comes first and what last.
  std::vector<Role> roles_of_nodes() const {
    std::vector<Role> roles(tree_.size(), Role::past);
    for (const auto& [node, polygon] : all<Drawn<double>>()) roles[node] = drawn_role();
    const auto* visited = now<Visited>();
    if (const auto* drawn = now<Drawn<double>>()) roles[drawn->node] = Role::current;
    if (!visited) return roles;
    const std::function<void(std::size_t, Role)> give = [&](std::size_t node, Role role) {
      if (node == none) return;
      roles[node] = role;
      give(tree_[node].in_front, role);
      give(tree_[node].behind, role);
    };
    give(far_side(tree_[visited->node], visited->eye_side), Role::accepted);
    give(near_side(tree_[visited->node], visited->eye_side), Role::candidate);
    roles[visited->node] = Role::current;
    return roles;
  }

  void add_plan(View& view) const {
    if (const auto* visited = now<Visited>(); visited) {
      const bool front_is_far = visited->eye_side <= 0;
      plan_->add_region(view, visited->node, front_is_far, Role::accepted);
      plan_->add_region(view, visited->node, !front_is_far, Role::candidate);
    }
    plan_->add_border(view);
    plan_->add_eye(view, subject_.towards, words_.say("eye"));
    const auto& drawn = all<Drawn<double>>();
    const std::vector<Role> roles = roles_of_nodes();
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      plan_->add_line(view, i, Role::past);
      for (const DPolygon& polygon : tree_[i].polygons) {
        const auto turn =
            std::ranges::find_if(drawn, [&](const auto& d) { return same(d.polygon, polygon); });
        const bool is_drawn = turn != drawn.end();
        const Role role = is_drawn && roles[i] != Role::current ? drawn_role() : roles[i];
        const std::string number = is_drawn ? fmt::format("{}.\u00a0", turn - drawn.begin() + 1) : "";
        plan_->add_wall(view, polygon, role, number + names_(polygon));
      }
    }
  }
  void add_picture(View& view) const {
    std::vector<ShownFace> faces;
    for (const auto& [node, polygon] : all<Drawn<double>>())
      faces.push_back({names_(polygon), polygon.corners, drawn_role()});
    if (now<Drawn<double>>()) faces.back().role = Role::current;
    std::vector<Ring> waiting;
    for (const Node<double>& node : tree_) {
      for (const DPolygon& polygon : node.polygons) waiting.push_back(polygon.corners);
    }
    picture_.add_painted(view, std::move(faces), waiting);
  }

  const Words& words_;
  const Subject& subject_;
  const DTree& tree_;
  const PartNames names_;
  FacesPicture picture_;
  const std::optional<Plan> plan_;
  TreeDrawing drawing_;
};

}  // namespace gradus::bsp_tree
