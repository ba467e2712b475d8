// The story of mesh structures: the same questions asked of half-edges, winged edges and a list of faces, and
// whether the faces can be oriented.

#include "modeling/mesh_structures/mesh_structures_notes.hpp"
#include "stories/checking.hpp"
#include "stories/modeling/mesh_structures/half_edge_story.hpp"
#include "stories/modeling/mesh_structures/orientation_story.hpp"
#include "stories/modeling/mesh_structures/other_stories.hpp"

namespace gradus::mesh_structures {
namespace {

constexpr auto drop = [](Index) {};

void set_up(Narrator& narrator, const Task& task, const MeshDrawing& drawing) {
  narrator.paper(paper_width, paper_height);
  const Counts& c = task.counts;
  narrator.subtitle("subtitle", {{"V", c.vertices}, {"E", c.edges}, {"F", c.faces}, {"chi", c.euler()}});
  if (narrator.arguments().text("mesh") == "sample" && !names_a_model(narrator.arguments())) {
    require_scale(drawing.panel(), narrator.arguments(), {"vertices"});
    narrator.handles("vertices", [&drawing](dvec3 p) { return drawing.at(p); });
  }
}

/// Questions that only half-edges answer, and meshes without them.
void require_walks(const Arguments& arguments, const Task& task, bool boundary) {
  if (task.query == Query::boundary && !boundary)
    refuse("query", "vertex, face or edge expected: ask half_edge for a boundary");
  if (!task.mesh && !boundary)
    refuse(arguments, {"triangles", "model", "mesh"},
           "a mesh with half-edges expected: orientation says why there are no twins");
}

template <auto at_vertex>
void tell_half_edges(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  const MeshDrawing drawing(task.subject, task.edges);
  set_up(narrator, task, drawing);
  // Of the fault what differs
  if (narrator.method().standing != Standing::faulty) {
    narrator.list("half_edges");
    narrator.list_below(task.query == Query::vertex ? "faces_at"
                        : task.query == Query::edge ? "face_across"
                                                    : "edges_round");
  }
  narrator.columns({{"half", false}, {"face", false}, {"twin", false}, {"next", false}, {"found", false}});
  narrator.legend({{Role::current, "half"},
                   {Role::candidate, "twin"},
                   {Role::measure, "next"},
                   {Role::accepted, "found"},
                   {Role::rejected, narrator.method().standing == Standing::faulty ? "missed" : "refused"}});
  HalfEdgeStory story(narrator.words(), task, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto mesh = half_edges(task.subject.faces, task.subject.vertices, watch);
  if (mesh && task.query == Query::vertex) at_vertex(*mesh, task.number, drop, watch);
  if (mesh && task.query == Query::face) edges_round(*mesh, mesh->of_face[task.number], drop, watch);
  if (mesh && task.query == Query::edge) face_across(*mesh, task.side().corner, watch);
  if (mesh && task.query == Query::boundary && mesh->loops.size() > 0)
    edges_round(*mesh, mesh->loops[task.number], drop, watch);
  watch(steps::Finished{}, story.found().records > 0 ? narrator.last_line() : 0);
  narrator.result(
      {{"faces", story.found().names()}, {"records", static_cast<std::int64_t>(story.found().records)}});
}

void tell_winged(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  require_walks(narrator.arguments(), task, false);
  const MeshDrawing drawing(task.subject, task.edges);
  set_up(narrator, task, drawing);
  narrator.list(task.query == Query::vertex ? "winged_faces_at"
                : task.query == Query::edge ? "winged_face_across"
                                            : "winged_edges_round",
                "winged_edge.hpp");
  narrator.columns({{"edge", false}, {"left", false}, {"right", false}, {"next", false}, {"found", false}});
  narrator.legend({{Role::current, "edge"}, {Role::candidate, "next"}, {Role::accepted, "found"}});
  const WingedEdges mesh = winged_edges(*task.mesh);
  WingedStory story(narrator.words(), task, mesh, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  if (task.query == Query::vertex) winged_faces_at(mesh, task.number, drop, watch);
  if (task.query == Query::face) winged_edges_round(mesh, task.number, drop, watch);
  if (task.query == Query::edge) winged_face_across(mesh, task.number, task.side().face, watch);
  watch(steps::Finished{}, 0);
  narrator.result(
      {{"faces", story.found().names()}, {"records", static_cast<std::int64_t>(story.found().records)}});
}

void tell_search(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  if (task.query == Query::boundary) require_walks(narrator.arguments(), task, false);
  const MeshDrawing drawing(task.subject, task.edges);
  set_up(narrator, task, drawing);
  narrator.list(task.query == Query::edge ? "search_face_across" : "search_faces_at", "face_vertex.hpp");
  narrator.columns({{"face", false}, {"ring", false}, {"has", false}});
  narrator.legend({{Role::current, "face"}, {Role::accepted, "found"}});
  SearchStory story(narrator.words(), task, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Side s = task.side();
  if (task.query == Query::vertex) search_faces_at(task.subject.faces, task.number, drop, watch);
  if (task.query == Query::edge) search_face_across(task.subject.faces, s.from, s.to, s.face, watch);
  watch(steps::Finished{}, 0);
  narrator.result(
      {{"faces", story.found().names()}, {"records", static_cast<std::int64_t>(story.found().records)}});
}

template <auto spreads>
void tell_orientation(Narrator& narrator) {
  const Task task = task_of(narrator.arguments(), false);
  const MeshDrawing drawing(task.subject, task.edges);
  set_up(narrator, task, drawing);
  narrator.columns({{"edge", false}, {"from", false}, {"to", false}, {"demand", false}});
  narrator.legend({{Role::current, "demand"},
                   {Role::accepted, "kept"},
                   {Role::candidate, "turned"},
                   {Role::rejected, "conflict"}});
  SpreadStory story(narrator.words(), task, drawing);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  Ways ways(task.subject.faces);
  Turns turned(task.counts.faces, none);
  for (Index f = 0; f < turned.size() && !story.fails(); ++f) {
    if (turned[f] == none) spreads(ways, f, turned, watch);
  }
  watch(steps::Finished{}, 0);
  narrator.result(
      {{"orientable", !story.fails()}, {"euler", static_cast<std::int64_t>(task.counts.euler())}});
}

/// How many records each structure reads for a question.
std::array<Index, 3> records_of(const Task& whole, Query query) {
  Task task = whole;
  task.query = query;
  const Counts& c = task.counts;
  task.number = std::min(task.number, (query == Query::vertex ? c.vertices
                                       : query == Query::face ? c.faces
                                                              : c.edges) -
                                          1);
  const Faces& faces = task.subject.faces;
  const WingedEdges winged = winged_edges(*task.mesh);
  Index searched = 0, wings = 0, halves = 0;
  const auto search = [&](const Searched&) { ++searched; };
  const auto wing = [&](const auto&) { ++wings; };
  if (query == Query::vertex) {
    search_faces_at(faces, task.number, drop, search);
    winged_faces_at(winged, task.number, drop, wing);
    faces_at(*task.mesh, task.number, drop, [&](const Turned&) { halves += 2; });
  } else if (query == Query::face) {
    searched = 1;
    winged_edges_round(winged, task.number, drop, wing);
    edges_round(*task.mesh, task.mesh->of_face[task.number], drop, [&](const Followed&) { ++halves; });
  } else {
    const Side s = task.side();
    search_face_across(faces, s.from, s.to, s.face, search);
    winged_face_across(winged, task.number, s.face, wing);
    face_across(*task.mesh, s.corner, [&](const Crossed&) { halves += 2; });
  }
  return {searched, wings, halves};
}

void tell_costs(Narrator& narrator) {
  const Task task = task_of(narrator.arguments());
  require_walks(narrator.arguments(), task, false);
  const std::array all{records_of(task, Query::vertex), records_of(task, Query::face),
                       records_of(task, Query::edge)};
  Index most = 1;
  for (const auto& row : all) most = std::max(most, *std::ranges::max_element(row));
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"V", task.counts.vertices},
                                 {"E", task.counts.edges},
                                 {"F", task.counts.faces},
                                 {"chi", task.counts.euler()}});
  narrator.columns({{"question", false}, {"structure", false}, {"records"}});
  narrator.legend({{Role::rejected, "searched"}, {Role::accepted, "walked"}});
  CostsStory story(narrator.words(), task, most);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (std::size_t q = 0; q < 3; ++q) {
    for (std::size_t s = 0; s < 3; ++s) watch(Answered{q, s, all[q][s]}, 0);
  }
  watch(steps::Finished{}, 0);
  narrator.result({{"most", static_cast<std::int64_t>(most)}});
}

const Checking& checking() {
  static const Checking known{
      .asked = {{"faces", SameList::set, "Turned", {"face"}, "inside", "half_edge"},
                {"faces", SameList::set, "Searched", {"face"}, "found", "face_vertex"},
                {"half_edges", SameList::order, "Followed", {"key"}, "", "half_edge"}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  constexpr auto right = [](const HalfEdges& mesh, Index v, auto&& take, auto&& watch) {
    faces_at(mesh, v, take, watch);
  };
  constexpr auto wrong = [](const HalfEdges& mesh, Index v, auto&& take, auto&& watch) {
    first_fan_only(mesh, v, take, watch);
  };
  constexpr auto spreads = [](Ways& ways, Index f, Turns& turned, auto&& watch) {
    return spread(ways, f, turned, watch);
  };
  constexpr auto any = [](Ways& ways, Index f, Turns& turned, auto&& watch) {
    return any_number_of_faces(ways, f, turned, watch);
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "mesh_structures",
       .chapter = "modeling",
       .aliases = {"half-edge", "winged edge", "face-vertex mesh", "polygon mesh", "orientable",
                   "euler number", "moebius strip"},
       .summary = "who is beside whom in a mesh: half-edges, winged edges and lists of faces answer, and "
                  "orientation spreads",
       .methods = {{.name = "half_edge",
                    .standing = Standing::taught,
                    .tell = tell_half_edges<right>,
                    .function = "half_edges"},
                   {.name = "winged_edge",
                    .tell = tell_winged,
                    .function = "winged_faces_at",
                    .file = "winged_edge.hpp",
                    .opening = {{"query", "edge"}}},
                   {.name = "face_vertex",
                    .tell = tell_search,
                    .function = "search_faces_at",
                    .file = "face_vertex.hpp"},
                   {.name = "orientation",
                    .tell = tell_orientation<spreads>,
                    .function = "spread",
                    .file = "orientation.hpp",
                    .unread = {"query", "number"},
                    .opening = {{"triangles", "1,2,3 2,3,4 3,4,6 4,5,6"}}},
                   {.name = "costs",
                    .tell = tell_costs,
                    .function = "faces_at",
                    .unread = {"query"},
                    .opening = {{"mesh", "fine_sphere"}}},
                   {.name = "first_fan_only",
                    .standing = Standing::faulty,
                    .tell = tell_half_edges<wrong>,
                    .opening = {{"mesh", "bow_tie"}}},
                   {.name = "any_number_of_faces",
                    .standing = Standing::faulty,
                    .tell = tell_orientation<any>,
                    .unread = {"query", "number"}}},
       .default_method = "half_edge",
       .parameters = {choice("mesh",
                             {"sample", "cube", "refined_cube", "sphere", "fine_sphere", "moebius", "klein",
                              "open_box", "bow_tie", "book", "two_boxes"},
                             "sample", "cube", "what is asked about; sample: --vertices and --triangles"),
                      choice("query", {"vertex", "face", "edge", "boundary"}, "vertex", "face",
                             "whose neighbours are wanted"),
                      integer(1, 1000, "number", "3", "2",
                              "which one, from 1 on; where there are fewer, the last"),
                      points(3, 60, "vertices", "0,2,0 2,0,0 3,2,0 5,0,0 8,1,0 6,3,0", "0,0,0 4,0,0 0,4,0",
                             "of the sample, v1 first", xyz, {1e-3, 1e4}),
                      points(1, 60, "triangles", "1,2,3 2,4,3 3,4,6 4,5,6", "1,2,3",
                             "of the sample: the numbers of their vertices, counter-clockwise",
                             {"a", "b", "c"}, {1, 1000}),
                      {"model", ParameterType::model, "", "MODEL.obj",
                       "a mesh of up to 300 faces in the place of these"}},
       .examples = {"--query face --number 2", "--method orientation --mesh moebius",
                    "--method costs --mesh sphere"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::mesh_structures
