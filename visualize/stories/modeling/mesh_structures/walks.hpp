#pragma once
// What the stories of mesh structures have in common: the question, and what is found so far.

#include "modeling/mesh_structures/face_vertex.hpp"
#include "modeling/mesh_structures/winged_edge.hpp"
#include "stories/modeling/mesh_structures/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::mesh_structures {

enum class Query { vertex, face, edge, boundary };

/// A mesh and what is asked about it.
struct Task {
  Subject subject;
  Edges edges{subject.faces};
  Counts counts = counts_of(subject.faces, subject.vertices);
  std::optional<HalfEdges> mesh = half_edges(subject.faces, subject.vertices);
  Query query;
  Index number = 0;  ///< from 0 on

  Side side() const { return edges[number][0]; }
  std::string edge_name(Index e) const {
    const auto [a, b] = edges[e][0].ends();
    return vertex_name(a) + " " + vertex_name(b);
  }
  std::string half_name(Index h) const {
    return vertex_name((*mesh)[h].from) + "→" + vertex_name(mesh->to(h));
  }
  static std::string side_name(const Side& s) { return vertex_name(s.from) + "→" + vertex_name(s.to); }
  /// An arrow for a half-edge: those outside lie along their twin.
  Arrow arrow(Index h, Role role, std::string name = {}) const {
    const bool outside = (*mesh)[h].face == none;
    return {outside ? (*mesh)[h].twin : h, outside, role, std::move(name)};
  }
};

/// The places of what is asked about; of a boundary, none.
inline Ring places_asked(const Task& task) {
  const Subject& subject = task.subject;
  if (task.query == Query::face) return subject.ring(task.number);
  Ring places;
  for (std::size_t c = 0; task.query == Query::vertex && c < subject.at.size(); ++c) {
    if (subject.faces.corners[c] == task.number) places.push_back(subject.at[c]);
  }
  if (task.query == Query::edge) {
    for (const Side& s : task.edges[task.number])
      places.push_back(subject.at[static_cast<std::size_t>(s.corner)]);
  }
  return places;
}

/// Seen from the side on which that lies.
inline void turn_to_question(Task& task) {
  Bounds all, asked;
  for (const dvec3 p : task.subject.at) all.add(p);
  for (const dvec3 p : places_asked(task)) asked.add(p);
  if (asked.empty()) return;
  const dvec3 way = asked.centre() - all.centre();
  for (int axis = 0; axis < 3; ++axis) {
    double& towards = task.subject.towards[axis];
    if (std::abs(way[axis]) > 1e-6 * all.radius()) towards = std::copysign(towards, way[axis]);
  }
}

/// asks: whether it is about one vertex, face or edge.
inline Task task_of(const Arguments& arguments, bool asks = true) {
  const std::string& text = arguments.text("query");
  Task task{.subject = subject_of(arguments),
            .query = text == "vertex" ? Query::vertex
                     : text == "face" ? Query::face
                     : text == "edge" ? Query::edge
                                      : Query::boundary};
  const Counts& c = task.counts;
  const Index last = task.query == Query::vertex ? c.vertices
                     : task.query == Query::face ? c.faces
                     : task.query == Query::edge ? c.edges
                                                 : std::max(c.loops, 1);
  task.number = std::min(static_cast<Index>(arguments.integer("number")), last) - 1;
  if (asks && task.subject.closed) turn_to_question(task);
  return task;
}

/// Faces and edges that were found, and how the answer is said.
struct Found {
  std::vector<Index> faces{};
  Index records = 0;  ///< touched on the way

  void add(Index face) {
    if (face != none && !std::ranges::count(faces, face)) faces.push_back(face);
  }
  std::string names() const {
    std::vector<Index> sorted = faces;
    std::ranges::sort(sorted);
    return names_of(sorted, face_name);
  }
};

/// What is asked about is drawn strong.
inline void mark_question(Marks& marks, const Task& task) {
  if (task.query == Query::vertex) marks.vertices[task.number] = Role::current;
  if (task.query == Query::face) marks.faces[task.number] = Role::current;
  if (task.query == Query::edge) marks.sides.push_back({task.side().corner, Role::current});
}

/// Sentences end alike for all structures.
inline Event finished_event(const Task& task, const Found& found) {
  constexpr std::array<std::string_view, 4> texts{"finished.vertex", "finished.face", "finished.edge",
                                                  "finished.boundary"};
  Event event{.text = texts[static_cast<std::size_t>(task.query)],
              .facts = {{"records", static_cast<std::int64_t>(found.records)}},
              .words = {{"faces", found.names()},
                        {"v", vertex_name(task.number)},
                        {"f", face_name(task.number)},
                        {"corners", task.subject.faces.corners.size()}},
              .ends = true};
  if (task.query == Query::edge) event.words.push_back({"e", task.edge_name(task.number)});
  if (task.query == Query::vertex && found.faces.empty()) event.text = "finished.isolated";
  if (task.query == Query::edge && task.edges[task.number].size() == 1) event.text = "finished.border";
  if (task.query == Query::boundary && task.counts.loops == 0) event.text = "finished.closed";
  return event;
}

}  // namespace gradus::mesh_structures
