#pragma once
// Holes that are joined to the outline by bridges.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modeling/ear_clipping/join_holes.hpp"
#include "stories/modeling/ear_clipping/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::ear_clipping {

class BridgeStory : public Past<steps::Started, EdgeMet, InTheWay, HoleJoined, AllJoined> {
 public:
  /// ring: what comes out.
  BridgeStory(const Words& words, const Subject& subject, const Drawing& drawing, std::vector<int> ring)
      : words_(words), subject_(subject), drawing_(drawing), ring_(std::move(ring)) {}

  Event say(const steps::Started&) const {
    return {.text = "holes.started",
            .words = {{"corners", subject_.rings[0].size()}},
            .count = std::ssize(subject_.rings) - 1,
            .level = Level::idea};
  }
  Event say(const EdgeMet& e) const {
    return {.text = "edge_met",
            .facts = facts(e.hole, e.corner, e.end),
            .words = {{"corner", corner_name(e.corner)},
                      {"hole", e.hole},
                      {"from", corner_name(e.from)},
                      {"to", corner_name(e.to)},
                      {"end", corner_name(e.end)}},
            .row = {e.hole, corner_name(e.corner), bridge_name(e.corner, e.end)},
            .key = corner_name(e.corner),
            .phase = phase(e.hole)};
  }
  Event say(const InTheWay& w) const {
    return {
        .text = "in_the_way",
        .facts = facts(w.hole, w.corner, w.end),
        .words = {{"end", corner_name(w.end)},
                  {"before", bridge_name(w.corner, w.instead_of)},
                  {"bridge", bridge_name(w.corner, w.end)}},
        .row = {w.hole, corner_name(w.corner), bridge_name(w.corner, w.end)},
        .key = corner_name(w.corner),
        .phase = phase(w.hole),
        .decides = yes_or_no(words_, "question.way",
                             {{"end", corner_name(w.end)}, {"bridge", bridge_name(w.corner, w.instead_of)}},
                             true, "in the way")};
  }
  Event say(const HoleJoined& j) const {
    const bool bridge = j.by == Joint::bridge;
    return {.text = bridge ? "hole_joined" : "hole_joined.touch",
            .facts = facts(j.hole, j.corner, j.end),
            .words = {{"hole", j.hole},
                      {"bridge", bridge_name(j.corner, j.end)},
                      {"place", subject_.at(j.by == Joint::by_edge ? j.end : j.corner)},
                      {"corners", j.corners}},
            .row = {j.hole, corner_name(j.corner), bridge ? bridge_name(j.corner, j.end) : words_.say("none"),
                    j.corners},
            .key = corner_name(j.corner),
            .phase = phase(j.hole)};
  }
  Event say(const AllJoined& a) const {
    return {.text = "all_joined",
            .facts = {{"corners", std::int64_t{a.corners}}},
            .words = {{"ring", order()}, {"triangles", a.corners - 2}},
            .phase = words_.say("phase.ears"),
            .level = Level::idea};
  }

  /// A corner in the way tells most, then a bridge.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    return std::same_as<Step, InTheWay> ? 3 : std::same_as<Step, EdgeMet> ? 2 : 0;
  }

  View draw() const {
    View view;
    drawing_.add_input(view);
    for (std::size_t i = 0; i < subject_.rings.size(); ++i) {
      const bool in_ring = i == 0 || is_joined(static_cast<int>(i));
      drawing_.add_ring(view, fmt::format("c ring {}", i), in_ring ? Role::input : Role::past,
                        subject_.rings[i]);
    }
    for (const HoleJoined& j : all<HoleJoined>()) {
      const bool current = now<HoleJoined>() && &j == last<HoleJoined>();
      if (j.by == Joint::bridge)
        view.add({fmt::format("f bridge {}", j.hole), current ? Role::current : Role::result,
                  Stroke{drawing_.at(j.corner), drawing_.at(j.end)}});
    }
    if (const EdgeMet* e = since<EdgeMet, HoleJoined>()) add_search(view, *e);
    const EdgeMet* met = now<EdgeMet>();
    const InTheWay* way = now<InTheWay>();
    const HoleJoined* joined = now<HoleJoined>();
    drawing_.add_names(view, [&](int i) {
      const auto is_of = [i](const auto* step) { return step && (i == step->corner || i == step->end); };
      if (is_of(met) || is_of(way) || is_of(joined)) return Role::current;
      return way && i == way->instead_of ? Role::rejected : Role::input;
    });
    return view;
  }

 private:
  static std::string bridge_name(int corner, int end) { return corner_name(corner) + " " + corner_name(end); }
  static std::vector<Field> facts(int hole, int corner, int end) {
    return {{"hole", std::int64_t{hole}}, {"corner", corner_name(corner)}, {"end", corner_name(end)}};
  }
  std::string phase(int hole) const { return words_.say("phase.hole", {{"hole", hole}}); }
  std::string order() const {
    std::string names;
    for (const int corner : ring_) names += (names.empty() ? "" : " ") + corner_name(corner);
    return names;
  }
  bool is_joined(int hole) const {
    return std::ranges::any_of(all<HoleJoined>(), [&](const HoleJoined& j) { return j.hole == hole; });
  }

  /// The ray, the edge that it meets, the triangle between, and the bridge so far.
  void add_search(View& view, const EdgeMet& e) const {
    const dvec2 m = subject_.at(e.corner), a = subject_.at(e.from), b = subject_.at(e.to);
    const dvec2 met{a.x + (m.y - a.y) / (b.y - a.y) * (b.x - a.x), m.y};
    const dvec2 hit = drawing_.panel().at(met);
    const InTheWay* way = now<InTheWay>();
    gradus::add_ring(view, "d search", Role::candidate, {drawing_.at(e.corner), hit, drawing_.at(e.end)}, 0);
    view.add({"e edge", Role::current, Stroke{drawing_.at(e.from), drawing_.at(e.to)}});
    view.add({"e ray", Role::measure, Stroke{drawing_.at(e.corner), hit, true}});
    if (way)
      view.add({"f before", Role::rejected,
                Stroke{drawing_.at(e.corner), drawing_.at(way->instead_of), false, true}});
    const int end = way ? way->end : e.end;
    view.add({"g bridge", Role::current, Stroke{drawing_.at(e.corner), drawing_.at(end), false, true}});
  }

  const Words& words_;
  const Subject& subject_;
  const Drawing& drawing_;
  const std::vector<int> ring_;
};

}  // namespace gradus::ear_clipping
