#pragma once
// Orientation spread from face to face: each edge demands of the face beyond it to run the other way.

#include "modeling/mesh_structures/orientation.hpp"
#include "stories/modeling/mesh_structures/walks.hpp"

namespace gradus::mesh_structures {

class SpreadStory : public Past<steps::Started, Seeded, Demanded, steps::Finished> {
 public:
  SpreadStory(const Words& words, const Task& task, const MeshDrawing& drawing)
      : words_(words), task_(task), drawing_(drawing) {}

  /// Where demands meet; else where a face is turned, or is reached late.
  double tells(const Demanded& d) const {
    if (d.outcome > Outcome::agrees) return 1e6;
    if (d.outcome == Outcome::reached && d.turned) return 3;
    return static_cast<double>(all<Demanded>().size()) / 1000 + (d.outcome == Outcome::reached ? 2 : 1);
  }
  double tells(const Seeded& s) const { return left_out_at(s.face) == none ? 0 : 4; }
  double tells(const auto&) const { return 0; }

  Event say(const steps::Started&) const { return {.text = "spread.started", .level = Level::idea}; }
  Event say(const Seeded& s) const {
    const Index edge = left_out_at(s.face);
    return {.text = edge == none ? "seeded" : "seeded.left_out",
            .words = {{"f", face_name(s.face)}, {"e", edge == none ? "" : task_.edge_name(edge)}},
            .row = {"", "", face_name(s.face), words_.say("sense.kept")},
            .key = face_name(s.face)};
  }
  Event say(const Demanded& d) const {
    constexpr std::array<std::string_view, 4> keys{"reached", "agrees", "conflicts", "crowded"};
    const auto outcome = static_cast<std::size_t>(d.outcome);
    std::vector<Index> faces;
    for (const Side& s : task_.edges[d.edge]) faces.push_back(s.face);
    const std::vector<std::string> answers =
        mapped(std::vector<std::string_view>(keys.begin(), keys.end()),
               [&](std::string_view key) { return words_.say("outcome." + std::string(key)); });
    const bool same = is_turned(d.from) != d.turned;
    const std::string sense = words_.say(d.turned ? "sense.turned" : "sense.kept");
    const std::string way = d.turned ? "turned" : "kept";
    const TextKey text = d.outcome == Outcome::reached     ? "demanded.reached." + way
                         : d.outcome == Outcome::conflicts ? "demanded.conflicts." + way
                                                           : "demanded." + std::string(keys[outcome]);
    return {
        .text = text,
        .facts = {{"turned", d.turned}},
        .words = {{"e", task_.edge_name(d.edge)},
                  {"f", face_name(d.from)},
                  {"g", face_name(d.to)},
                  {"count", faces.size()},
                  {"all", names_of(faces, face_name)},
                  {"way", words_.say(same ? "way.same" : "way.opposite")}},
        .row = {task_.edge_name(d.edge), face_name(d.from), face_name(d.to), sense},
        .key = task_.edge_name(d.edge),
        .decides = Decision{words_.say("question.demand", {{"f", face_name(d.from)}, {"g", face_name(d.to)}}),
                            answers, outcome, std::string(keys[outcome])}};
  }
  Event say(const steps::Finished&) const {
    const Counts& c = task_.counts;
    std::int64_t turned = 0;
    for (const Demanded& d : all<Demanded>()) turned += d.outcome == Outcome::reached && d.turned;
    return {.text = fails() ? "spread.failed" : "spread.passed",
            .facts = {{"turned", turned}},
            .words = {{"chi", c.euler()}, {"loops", c.loops == none ? Said("–") : Said(c.loops)}}};
  }

  View draw() const {
    Marks marks;
    for (const Seeded& s : all<Seeded>()) paint(marks, s.face, false);
    for (const Demanded& d : all<Demanded>()) {
      if (d.outcome == Outcome::reached) paint(marks, d.to, d.turned);
    }
    const auto* d = all<Demanded>().empty() ? nullptr : last<Demanded>();
    if (const auto* s = now<Seeded>()) {
      marks.faces[s->face] = Role::current;
      if (const Index edge = left_out_at(s->face); edge != none) {
        marks.faces[s->face] = Role::rejected;
        marks.sides.push_back({task_.edges[edge][0].corner, Role::current});
      }
    }
    if (!d || !(now<Demanded>() || fails())) return drawing_.draw(marks);
    const bool wrong = fails();
    for (const Side& s : task_.edges[d->edge]) {
      marks.sides.push_back({s.corner, Role::current});
      if (wrong) marks.faces[s.face] = Role::rejected;
    }
    if (!wrong) marks.faces[d->to] = Role::current;
    return drawing_.draw(marks);
  }
  bool fails() const { return last<Demanded>() && last<Demanded>()->outcome > Outcome::agrees; }

 private:
  /// An edge of a face that begins at which others have agreed, so that it should have been reached; or none.
  Index left_out_at(Index face) const {
    for (const Demanded& d : all<Demanded>()) {
      if (d.from == face || d.to == face) continue;
      for (const Side& s : task_.edges[d.edge]) {
        if (s.face == face) return d.edge;
      }
    }
    return none;
  }
  bool is_turned(Index face) const {
    for (const Demanded& d : all<Demanded>()) {
      if (d.to == face && d.outcome == Outcome::reached) return d.turned;
    }
    return false;
  }
  void paint(Marks& marks, Index face, bool turned) const {
    marks.faces[face] = now<steps::Finished>() && !fails() ? Role::result
                        : turned                           ? Role::candidate
                                                           : Role::accepted;
    marks.senses[face] = turned;
  }

  const Words& words_;
  const Task& task_;
  const MeshDrawing& drawing_;
};

}  // namespace gradus::mesh_structures
