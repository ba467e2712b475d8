#pragma once
// Half-edges: made face by face, joined edge by edge, walked.

#include "stories/modeling/mesh_structures/walks.hpp"

namespace gradus::mesh_structures {

class HalfEdgeStory : public Past<steps::Started, FacePlaced, EdgeJoined, LoopClosed, Turned, Followed,
                                  Crossed, steps::Finished> {
 public:
  HalfEdgeStory(const Words& words, const Task& task, const MeshDrawing& drawing)
      : words_(words), task_(task), drawing_(drawing) {}

  /// Of a walk the last step but one has most to show; before that, what stops the building.
  double tells(const Turned& t) const {
    return t.round ? 1 : (t.face == none ? 2 : 3) + 0.01 * static_cast<double>(all<Turned>().size());
  }
  double tells(const Followed& f) const {
    return f.round ? 1 : 2 + static_cast<double>(all<Followed>().size() == 2);
  }
  double tells(const Crossed&) const { return 3; }
  double tells(const EdgeJoined& e) const {
    return e.fit > Fit::twins ? 4 : e.fit == Fit::twins ? 0.5 : 0.25;
  }
  double tells(const steps::Finished&) const { return missed().empty() ? 0 : 5; }
  double tells(const auto&) const { return 0; }

  Event say(const steps::Started&) const {
    return {.text = "started",
            .facts = {{"corners", std::ssize(task_.subject.faces.corners)}},
            .level = Level::idea};
  }
  Event say(const FacePlaced& p) const {
    return {.text = "placed",
            .facts = {{"count", static_cast<std::int64_t>(ring_of(task_.subject.faces, p.face).size())}},
            .words = {{"f", face_name(p.face)},
                      {"ring", names_of(ring_of(task_.subject.faces, p.face), vertex_name)}},
            .key = face_name(p.face),
            .phase = words_.say("phase.placing")};
  }
  Event say(const EdgeJoined& j) const {
    constexpr std::array<const char*, 4> branches{"boundary", "twins", "same way", "crowded"};
    constexpr std::array<std::string_view, 4> keys{"boundary", "twins", "same_way", "crowded"};
    const auto fit = static_cast<std::size_t>(j.fit);
    const Side& s = j.sides[0];
    const std::string name = task_.edge_name(j.edge), side = Task::side_name(s),
                      back = Task::side_name({s.to, s.from, none, none});
    const bool joined = j.fit <= Fit::twins;
    std::vector<Index> faces;
    for (const Side& each : j.sides) faces.push_back(each.face);
    std::vector<std::string> answers;
    for (const std::string_view key : keys) answers.push_back(words_.say("fit." + std::string(key)));
    return {.text = "joined." + std::string(keys[fit]),
            .facts = {{"faces", std::ssize(j.sides)}},
            .words = {{"e", name},
                      {"side", side},
                      {"back", back},
                      {"f", face_name(s.face)},
                      {"g", face_name(j.sides.back().face)},
                      {"all", names_of(faces, face_name)}},
            .row = {side, face_name(s.face), joined ? Said(back) : Said("–"), "", ""},
            .key = name,
            .phase = words_.say("phase.joining"),
            .decides = Decision{words_.say("question.fit", {{"e", name}}), answers, fit, branches[fit]}};
  }
  Event say(const LoopClosed& l) const {
    return {.text = "loop",
            .words = {{"h", task_.half_name(l.first)}, {"n", l.count}},
            .key = task_.half_name(l.first),
            .phase = words_.say("phase.joining")};
  }
  Event say(const Turned& t) const {
    const std::string next = task_.half_name(t.next);
    Event event{
        .text = t.face == none ? "turned.outside"
                : t.round      ? "turned.round"
                               : "turned",
        .facts = {{"face", face_name(t.face)}, {"inside", t.face != none}},
        .words = {{"h", task_.half_name(t.half)},
                  {"f", face_name(t.face)},
                  {"twin", task_.half_name(t.twin)},
                  {"next", next},
                  {"v", vertex_name(task_.number)}},
        .row = {task_.half_name(t.half), face_name(t.face), task_.half_name(t.twin), next, found().names()},
        .key = task_.half_name(t.half),
        .phase = words_.say("phase.walking")};
    if (t.face == none && t.round) event.text = "turned.outside_round";
    event.decides = yes_or_no(words_, "question.round", {{"next", next}}, t.round, "done", "go on");
    return event;
  }
  Event say(const Followed& f) const {
    const std::string next = task_.half_name(f.next);
    return {.text = f.round ? "followed.round" : "followed",
            .facts = {{"half_edges", std::ssize(all<Followed>())}},
            .words = {{"h", task_.half_name(f.half)}, {"next", next}},
            .row = {task_.half_name(f.half), face_name((*task_.mesh)[f.half].face),
                    task_.half_name((*task_.mesh)[f.half].twin), next, std::ssize(all<Followed>())},
            .key = task_.half_name(f.half),
            .phase = words_.say("phase.walking"),
            .decides = yes_or_no(words_, "question.round", {{"next", next}}, f.round, "done", "go on")};
  }
  Event say(const Crossed& c) const {
    return {.text = c.face == none ? "crossed.outside" : "crossed",
            .words = {{"h", task_.half_name(c.half)},
                      {"twin", task_.half_name(c.twin)},
                      {"f", face_name(c.face)}},
            .row = {task_.half_name(c.half), face_name((*task_.mesh)[c.half].face), task_.half_name(c.twin),
                    "", face_name(c.face)},
            .key = task_.half_name(c.half),
            .phase = words_.say("phase.walking")};
  }
  Event say(const steps::Finished&) const {
    if (!task_.mesh) return {.text = "finished.refused"};
    Event event = finished_event(task_, found());
    if (!missed().empty()) {
      event.text = "finished.missed";
      event.words.push_back({"missed", names_of(missed(), face_name)});
    }
    return event;
  }
  Found found() const {
    Found found;
    for (const Turned& t : all<Turned>()) found.add(t.face);
    for (const Crossed& c : all<Crossed>()) found.add(c.face);
    found.records =
        static_cast<Index>(2 * all<Turned>().size() + all<Followed>().size() + 2 * all<Crossed>().size());
    return found;
  }

  /// Faces at the vertex that a finished walk has not found.
  std::vector<Index> missed() const {
    std::vector<Index> left;
    if (!now<steps::Finished>() || !task_.mesh || task_.query != Query::vertex) return left;
    const auto all = found().faces;
    faces_at(*task_.mesh, task_.number, [&](Index f) {
      if (f != none && std::ranges::find(all, f) == all.end()) left.push_back(f);
    });
    return left;
  }

  View draw() const {
    Marks marks;
    const bool walking = !all<Turned>().empty() || !all<Followed>().empty() || !all<Crossed>().empty() ||
                         now<steps::Finished>();
    if (walking) mark_question(marks, task_);
    add_built(marks);
    if (walking && task_.mesh) add_walk(marks);
    return drawing_.draw(marks);
  }

 private:
  /// The arrows by now.
  void add_built(Marks& marks) const {
    const auto* placed = now<FacePlaced>();
    const auto* joined = now<EdgeJoined>();
    const bool whole = drawing_.shows_all_arrows();
    for (const FacePlaced& p : all<FacePlaced>()) {
      const bool at_hand = placed && &p == last<FacePlaced>();
      if (at_hand) marks.faces[p.face] = Role::current;
      for (Index k = 0; (whole || at_hand) && k < std::ssize(ring_of(task_.subject.faces, p.face)); ++k)
        marks.arrows.push_back({p.first + k, false, at_hand ? Role::current : Role::past});
    }
    for (const EdgeJoined& j : all<EdgeJoined>()) {
      if (whole && j.fit == Fit::boundary)
        marks.arrows.push_back({j.sides[0].corner, true, Role::past, "", true});
    }
    if (const auto* loop = now<LoopClosed>(); loop && task_.mesh)
      edges_round(*task_.mesh, loop->first, [&](Index h) { put(marks, task_.arrow(h, Role::current)); });
    if (!joined) return;
    const bool wrong = joined->fit > Fit::twins;
    for (std::size_t i = 0; i < joined->sides.size(); ++i) {
      const Side& s = joined->sides[i];
      if (wrong) marks.faces[s.face] = Role::rejected;
      marks.sides.push_back({s.corner, wrong ? Role::rejected : Role::current});
      put(marks, {s.corner, false, wrong ? Role::rejected : i == 0 ? Role::current : Role::candidate});
    }
    if (joined->fit == Fit::boundary) put(marks, {joined->sides[0].corner, true, Role::candidate});
  }
  void add_walk(Marks& marks) const {
    for (const Index f : found().faces)
      marks.faces[f] = now<steps::Finished>() ? Role::result : Role::accepted;
    for (const Index f : missed()) marks.faces[f] = Role::rejected;
    for (const Followed& f : all<Followed>())
      put(marks, task_.arrow(f.half, now<steps::Finished>() ? Role::result : Role::accepted));
    if (const auto* t = now<Turned>()) {
      if (t->face != none) marks.faces[t->face] = Role::current;
      put(marks, task_.arrow(t->next, Role::measure, "next"));
      put(marks, task_.arrow(t->twin, Role::candidate, "twin"));
      put(marks, task_.arrow(t->half, Role::current, "h"));
    }
    if (const auto* f = now<Followed>()) {
      put(marks, task_.arrow(f->next, Role::measure, "next"));
      put(marks, task_.arrow(f->half, Role::current, "h"));
    }
    if (const auto* c = now<Crossed>()) {
      put(marks, task_.arrow(c->twin, Role::candidate, "twin"));
      put(marks, task_.arrow(c->half, Role::current, "h"));
    }
  }
  /// In the place of the one that is drawn there already.
  static void put(Marks& marks, Arrow arrow) {
    std::erase_if(marks.arrows,
                  [&](const Arrow& a) { return a.corner == arrow.corner && a.outside == arrow.outside; });
    marks.arrows.push_back(std::move(arrow));
  }

  const Words& words_;
  const Task& task_;
  const MeshDrawing& drawing_;
};

}  // namespace gradus::mesh_structures
