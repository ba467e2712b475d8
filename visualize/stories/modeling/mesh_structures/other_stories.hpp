#pragma once
// The same questions asked of winged edges and of a list of faces, and what each answer costs.

#include "stories/modeling/mesh_structures/walks.hpp"

namespace gradus::mesh_structures {

class WingedStory : public Past<steps::Started, WingTurned, WingFollowed, WingCrossed, steps::Finished> {
 public:
  WingedStory(const Words& words, const Task& task, const WingedEdges& mesh, const MeshDrawing& drawing)
      : words_(words), task_(task), mesh_(mesh), drawing_(drawing) {}

  double tells(const WingTurned& t) const {
    return t.round ? 1 : 2 + static_cast<double>(all<WingTurned>().size());
  }
  double tells(const WingFollowed& f) const { return f.round ? 1 : 2; }
  double tells(const auto&) const { return 0; }

  Event say(const steps::Started&) const { return {.text = "winged.started", .level = Level::idea}; }
  Event say(const WingTurned& t) const {
    return walked(t.edge, t.next, t.round, t.face == none ? "winged.turned.outside" : "winged.turned",
                  face_name(t.face));
  }
  Event say(const WingFollowed& f) const {
    return walked(f.edge, f.next, f.round, "winged.followed", face_name(task_.number));
  }
  Event say(const WingCrossed& c) const {
    const WingedEdge& w = mesh_[c.edge];
    return {.text = w.right == none ? "winged.crossed.border" : "winged.crossed",
            .words = {{"e", directed(c.edge)},
                      {"f", face_name(w.left)},
                      {"g", face_name(w.right)},
                      {"a", task_.edge_name(w.left_before)},
                      {"b", task_.edge_name(w.left_next)},
                      {"c", task_.edge_name(w.right_before)},
                      {"d", task_.edge_name(w.right_next)}},
            .row = row(c.edge, task_.edge_name(w.left_next)),
            .key = task_.edge_name(c.edge)};
  }
  Event say(const steps::Finished&) const { return finished_event(task_, found()); }
  Found found() const {
    Found found;
    for (const WingTurned& t : all<WingTurned>()) found.add(t.face);
    for (const WingCrossed& c : all<WingCrossed>()) found.add(c.face);
    found.records =
        static_cast<Index>(all<WingTurned>().size() + all<WingFollowed>().size() + all<WingCrossed>().size());
    return found;
  }

  View draw() const {
    Marks marks;
    mark_question(marks, task_);
    const Role answer = now<steps::Finished>() ? Role::result : Role::accepted;
    for (const Index f : found().faces) marks.faces[f] = answer;
    for (const WingFollowed& f : all<WingFollowed>()) add_edge(marks, f.edge, answer);
    if (const auto* t = now<WingTurned>()) {
      if (t->face != none) marks.faces[t->face] = Role::current;
      add_walk(marks, t->edge, t->next);
    }
    if (const auto* f = now<WingFollowed>()) add_walk(marks, f->edge, f->next);
    if (const auto* c = now<WingCrossed>()) {
      const WingedEdge& w = mesh_[c->edge];
      add_way(marks, c->edge);
      marks.faces[w.left] = Role::current;
      for (const auto& [wing, key] :
           {std::pair(w.left_before, "wing.left_before"), std::pair(w.left_next, "wing.left_next"),
            std::pair(w.right_before, "wing.right_before"), std::pair(w.right_next, "wing.right_next")}) {
        add_edge(marks, wing, Role::candidate);
        marks.side_names.push_back({task_.edges[wing][0].corner, words_.say(key)});
      }
    }
    return drawing_.draw(marks);
  }

 private:
  std::vector<Said> row(Index e, const std::string& next) const {
    const WingedEdge& w = mesh_[e];
    return {directed(e), face_name(w.left), face_name(w.right), next,
            task_.query == Query::face ? "" : found().names()};
  }
  Event walked(Index e, Index next, bool round, std::string_view text, const std::string& face) const {
    const std::string name = directed(e), its = task_.edge_name(next);
    const bool leaves = mesh_[e].from == task_.number;
    Event event{.text = text,
                .words = {{"e", name},
                          {"next", its},
                          {"f", face},
                          {"v", vertex_name(task_.number)},
                          {"end", words_.say(leaves ? "winged.begins" : "winged.ends")}},
                .row = row(e, its),
                .key = name};
    event.decides = yes_or_no(words_, "question.round", {{"next", its}}, round, "done", "go on");
    return event;
  }
  /// "v4→v3": left and right are said of an edge with a direction.
  std::string directed(Index e) const {
    const auto [a, b] = task_.edges[e][0].ends();
    const Index from = mesh_[e].from;
    return vertex_name(from) + "→" + vertex_name(from == a ? b : a);
  }
  /// An arrow where a face runs along the edge as it does.
  void add_way(Marks& marks, Index e) const {
    for (const Side& s : task_.edges[e]) {
      if (s.from == mesh_[e].from) return marks.ways.push_back(s.corner);
    }
  }
  void add_edge(Marks& marks, Index e, Role role) const {
    for (const Side& s : task_.edges[e]) marks.sides.push_back({s.corner, role});
  }
  void add_walk(Marks& marks, Index e, Index next) const {
    add_edge(marks, next, Role::candidate);
    add_edge(marks, e, Role::current);
    add_way(marks, e);
  }

  const Words& words_;
  const Task& task_;
  const WingedEdges& mesh_;
  const MeshDrawing& drawing_;
};

// --- A list of faces

class SearchStory : public Past<steps::Started, Searched, steps::Finished> {
 public:
  SearchStory(const Words& words, const Task& task, const MeshDrawing& drawing)
      : words_(words), task_(task), drawing_(drawing) {}

  double tells(const Searched& s) const { return s.found ? 2 : 3; }
  double tells(const auto&) const { return 0; }

  Event say(const steps::Started&) const { return {.text = "search.started", .level = Level::idea}; }
  Event say(const Searched& s) const {
    const std::string ring = names_of(ring_of(task_.subject.faces, s.face), vertex_name);
    const std::string what =
        task_.query == Query::vertex ? vertex_name(task_.number) : task_.edge_name(task_.number);
    return {.text = s.found ? "searched.found" : "searched",
            .facts = {{"face", face_name(s.face)}, {"found", s.found}},
            .words = {{"f", face_name(s.face)}, {"ring", ring}, {"what", what}},
            .row = {face_name(s.face), ring, words_.shared("words", s.found ? "yes" : "no")},
            .key = face_name(s.face),
            .decides = yes_or_no(words_, "question.search", {{"f", face_name(s.face)}, {"what", what}},
                                 s.found, "taken", "left out")};
  }
  Event say(const steps::Finished&) const { return finished_event(task_, found()); }
  Found found() const {
    Found found;
    for (const Searched& s : all<Searched>()) {
      if (s.found) found.add(s.face);
      ++found.records;
    }
    if (task_.query == Query::face) found.records = 1;
    return found;
  }

  View draw() const {
    Marks marks;
    for (const Searched& s : all<Searched>())
      if (s.found) marks.faces[s.face] = now<steps::Finished>() ? Role::result : Role::accepted;
    if (const auto* s = now<Searched>()) {
      marks.faces[s->face] = Role::current;
      const auto f = static_cast<std::size_t>(s->face);
      for (Index c = task_.subject.faces.first[f]; c < task_.subject.faces.first[f + 1]; ++c)
        marks.sides.push_back({c, Role::current});
    }
    mark_question(marks, task_);
    return drawing_.draw(marks);
  }

 private:
  const Words& words_;
  const Task& task_;
  const MeshDrawing& drawing_;
};

// --- What each answer costs

/// An answer, and how many records were read for it.
struct Answered {
  std::size_t question, structure;
  Index records;
};

class CostsStory : public Past<steps::Started, Answered, steps::Finished> {
 public:
  static constexpr std::array<std::string_view, 3> questions{"vertex", "face", "edge"},
      structures{"face_vertex", "winged_edge", "half_edge"};

  CostsStory(const Words& words, const Task& task, Index most) : words_(words), task_(task), most_(most) {}

  double tells(const Answered& a) const { return a.question == 2 && a.structure == 0 ? 1 : 0; }
  double tells(const steps::Finished&) const { return 2; }
  double tells(const auto&) const { return 0; }

  Event say(const steps::Started&) const {
    return {
        .text = "costs", .words = {{"corners", task_.subject.faces.corners.size()}}, .level = Level::idea};
  }
  Event say(const Answered& a) const {
    const std::string question = asked(a.question), structure = name(a.structure);
    return {.text = "answered",
            .facts = {{"records", static_cast<std::int64_t>(a.records)}},
            .words = {{"question", question}, {"structure", structure}, {"read", read(a)}},
            .row = {question, structure, a.records},
            .key = std::string(structures[a.structure])};
  }
  Event say(const steps::Finished&) const {
    Index searched = 0, walked = 0;
    for (const Answered& a : all<Answered>())
      (a.structure == 0 ? searched : walked) = std::max(a.structure == 0 ? searched : walked, a.records);
    return {.text = "costs.finished",
            .words = {{"searched", searched}, {"all", task_.counts.faces}, {"walked", walked}}};
  }

  View draw() const {
    View view;
    for (std::size_t q = 0; q < 3; ++q) {
      const double top = paper_height - 2 - 8.6 * static_cast<double>(q);
      view.add({fmt::format("a question {}", q), Role::guide, Text{{1, top}, asked(q), Align::left}});
      for (std::size_t s = 0; s < 3; ++s) add_bar(view, q, s, top - 2.1 - 2.1 * static_cast<double>(s));
    }
    return view;
  }

 private:
  std::string asked(std::size_t q) const {
    const Index last = q == 0 ? task_.counts.vertices : q == 1 ? task_.counts.faces : task_.counts.edges;
    const Index i = std::min(task_.number, last - 1);
    return words_.say("asked." + std::string(questions[q]), {{"name", q == 0   ? vertex_name(i)
                                                                      : q == 1 ? face_name(i)
                                                                               : task_.edge_name(i)}});
  }
  /// "4 of 80 faces": what each structure reads is another thing.
  std::string read(const Answered& a) const {
    constexpr std::array texts{"read.face_vertex", "read.winged_edge", "read.half_edge"};
    const std::array<Index, 3> all{task_.counts.faces, task_.counts.edges, task_.mesh->size()};
    return words_.say(texts[a.structure], {{"n", a.records}, {"all", all[a.structure]}});
  }
  std::string name(std::size_t s) const { return words_.say("method." + std::string(structures[s])); }
  void add_bar(View& view, std::size_t q, std::size_t s, double y) const {
    constexpr double left = 12, longest = 12.5;
    const std::string id = fmt::format("b {} {}", q, s);
    view.add({id + " name", Role::guide, Text{{left - 0.6, y}, name(s), Align::right}});
    const auto& answers = all<Answered>();
    const auto found =
        std::ranges::find_if(answers, [&](const Answered& a) { return a.question == q && a.structure == s; });
    if (found == answers.end()) return;
    const bool current = now<Answered>() && &*found == &answers.back();
    const Role role = current ? Role::current : s == 0 ? Role::rejected : Role::accepted;
    const double right = left + longest * found->records / most_;
    add_ring(view, id, role, Extent{{left, y - 0.75}, {right, y + 0.75}}.corners(), 2);
    view.add({id + " value", role, Text{{right + 0.5, y}, read(*found), Align::left}});
  }

  const Words& words_;
  const Task& task_;
  const Index most_;
};

}  // namespace gradus::mesh_structures
