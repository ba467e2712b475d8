#pragma once
// How a tree grows: which line parts a cell, and why just there.

#include "stories/modeling/kd_tree/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::kd_tree {

class BuildStory : public Past<steps::Started, Parted<2, double>, Built> {
 public:
  BuildStory(const Words& words, const Subject& subject, const PlaneDrawing& plane, const TreeDrawing& tree)
      : words_(words), subject_(subject), plane_(plane), tree_(tree) {}

  Event say(const steps::Started&) const {
    return {.text = "build.started", .count = std::ssize(subject_.points)};
  }
  Event say(const Parted<2, double>& p) const {
    const dvec2 size = p.cell.box.size();
    const Index before = p.cell.middle() - p.cell.first, behind = p.cell.last - p.cell.middle() - 1;
    const std::string name = name_of(p.middle.point), axis = words_.axis(p.middle.axis);
    Event event{.text = before + behind == 0 ? "parted.leaf" : "parted",
                .facts = {{"point", name},
                          {"axis", std::string(1, "xy"[p.middle.axis])},
                          {"before", std::int64_t{before}},
                          {"behind", std::int64_t{behind}}},
                .words = {{"axis", axis}, {"width", size.x}, {"height", size.y}},
                .row = {name, before + behind + 1, size.x, size.y, axis},
                .key = name};
    if (before + behind > 0)
      event.decides = Decision{words_.say("question.axis", {{"width", size.x}, {"height", size.y}}),
                               {words_.axis(0), words_.axis(1)},
                               static_cast<std::size_t>(p.middle.axis),
                               std::string(1, "xy"[p.middle.axis])};
    return event;
  }
  Event say(const Built& b) const {
    return {.text = "built",
            .facts = {{"nodes", std::int64_t{b.nodes}}},
            .words = {{"levels", std::bit_width(b.nodes)},
                      {"bytes", b.nodes * sizeof(Node)},
                      {"points", b.nodes * sizeof(dvec2)}},
            .ends = true};
  }

  /// The second line: it shows that the axis is chosen anew.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Parted<2, double>>)
      return all<Parted<2, double>>().size() == 2 ? 1 : 0;
    return 0;
  }

  View draw() const {
    View view;
    Roles roles(subject_.points.size(), now<Built>() ? Role::result : Role::input);
    Roles nodes(roles.size(), Role::guide);
    for (const auto& p : all<Parted<2, double>>()) {
      plane_.add_line(view, p.cell, Role::boundary);
      nodes[p.cell.middle()] = roles[p.middle.point] = now<Built>() ? Role::result : Role::past;
    }
    plane_.add_border(view);
    if (const auto* p = now<Parted<2, double>>()) {
      const Index m = p->cell.middle();
      for (Index node = p->cell.first; node < p->cell.last; ++node)
        nodes[node] = roles[subject_.tree.nodes[node].point] = node < m    ? Role::accepted
                                                               : node == m ? Role::current
                                                                           : Role::candidate;
      if (m > p->cell.first)
        plane_.add_cell(view, "b below", below(subject_.tree, p->cell), Role::accepted, false);
      if (m + 1 < p->cell.last)
        plane_.add_cell(view, "b above", above(subject_.tree, p->cell), Role::candidate, false);
      plane_.add_line(view, p->cell, Role::current);
      tree_.add_order(view, p->cell, words_.say("order", {{"axis", words_.axis(p->middle.axis)}}));
    }
    plane_.add_points(view, roles);
    tree_.add(view, nodes, true);
    return view;
  }

 private:
  const Words& words_;
  const Subject& subject_;
  const PlaneDrawing& plane_;
  const TreeDrawing& tree_;
};

inline void tell_build(Narrator& narrator, const Subject& subject) {
  const PlaneDrawing plane(subject, beside_tree, false);
  const TreeDrawing tree(subject);
  require_scale(plane.panel(), narrator.arguments(), {"points"});
  narrator.paper(paper_width, paper_height);
  narrator.trace().subtitle = narrator.words().count("subtitle.build", std::ssize(subject.points));
  narrator.handles("points", shown_in(plane.panel()));
  narrator.columns({{"middle", false}, {"count"}, {"width"}, {"height"}, {"axis", false}});
  narrator.legend({{Role::input, "points"},
                   {Role::boundary, "lines"},
                   {Role::current, "parting"},
                   {Role::accepted, "before"},
                   {Role::candidate, "behind"},
                   {Role::past, "parted"},
                   {Role::result, "tree"}});
  BuildStory story(narrator.words(), subject, plane, tree);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const PlaneTree made = build<2, double>(subject.points, watch);
  narrator.result({{"bytes", static_cast<std::int64_t>(made.nodes.size() * sizeof(Node))}});
}

}  // namespace gradus::kd_tree
