// The story of subdivision surfaces: what one vertex of a control mesh gets round it and where it goes, with
// the weights of its neighbours, and the levels of the whole.

#include "modeling/subdivision_surface/subdivision_surface.hpp"

#include "stories/checking.hpp"
#include "stories/modeling/subdivision_surface/levels_story.hpp"
#include "stories/modeling/subdivision_surface/limit_story.hpp"
#include "stories/modeling/subdivision_surface/vertex_story.hpp"

namespace gradus::subdivision_surface {
namespace {

/// The vertices of the faces at a vertex: all that count for what the next level has there.
std::vector<std::int32_t> vertices_round(const Links& links, std::int32_t vertex) {
  std::vector<std::int32_t> all{vertex};
  for (const std::int32_t f : links.star(vertex).faces) {
    for (const std::int32_t v : links.ring(f)) {
      if (std::ranges::find(all, v) == all.end()) all.push_back(v);
    }
  }
  return all;
}

// --- The methods

template <Way way>
void tell_vertex(Narrator& narrator) {
  Subject subject = subject_of(narrator.arguments(), way == Way::loop);
  if (way == Way::always_four) subject.levels = 1;  // what it makes can't be subdivided
  const Links links(subject.mesh);
  const Weights weights(subject.mesh, vertices_round(links, subject.vertex),
                        [](const Control& units) { return level_of<way>(units).points; });
  Levels levels = levels_of<way>(subject);
  VertexStory story(narrator.words(), subject, links, way, std::move(levels.meshes), weights);
  narrator.paper(paper_width, paper_height);
  narrator.trace().grid.lines = least_cell_of_lines;
  narrator.subtitle("subtitle", {{"vertices", subject.mesh.points.size()},
                                 {"faces", subject.mesh.faces.size()},
                                 {"vertex", subject.vertex + 1}});
  add_credit(narrator);
  narrator.columns({{"point", false}, {"place", false}});
  narrator.legend({{Role::current, "vertex"},
                   {Role::accepted, "faces"},
                   {Role::measure, way == Way::loop ? "edges.loop" : "edges"},
                   {Role::boundary, "sharp"},
                   {Role::rejected, "missing"},
                   {Role::result, "limit"}});
  narrator.handles("move", [&](dvec3 way_gone) { return story.at(subject.place + way_gone); });
  const auto watch = narrator.watcher(story);
  const auto of_vertex = [&]<class Step>(const Step& step, int line = __builtin_LINE(),
                                         const char* file = __builtin_FILE()) {
    if (story.concerns(step)) watch(step, line, file);
  };
  watch(steps::Started{}, 0);
  level_of<way>(subject.mesh, 1, of_vertex);
  for (const auto& [done, line, file] : levels.reports) watch(done, line, file);
  const Control& last = story.level(subject.levels);
  narrator.result(last.points, last.faces);
  narrator.result(
      {{"vertices", std::ssize(last.points)}, {"faces", static_cast<std::int64_t>(last.faces.size())}});
}

void tell_levels(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), false);
  Levels levels = levels_of<Way::catmull_clark>(subject);
  LevelsStory story(narrator.words(), subject, std::move(levels.meshes));
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle.levels", {{"vertices", subject.mesh.points.size()}});
  add_credit(narrator);
  narrator.columns({{"level"}, {"vertices"}, {"faces"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (const auto& [done, line, file] : levels.reports) watch(done, line, file);
  const Control& last = story.last();
  narrator.result(last.points, last.faces);
  narrator.result(
      {{"vertices", std::ssize(last.points)}, {"faces", static_cast<std::int64_t>(last.faces.size())}});
}

void tell_limit(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), false);
  const Control next = catmull_clark(subject.mesh, 1);
  const Links links(next);
  if (links.fades(links.star(subject.vertex)))
    refuse("creases", "expected a sharpness of at most 1 or from 10 on at vertex {}", subject.vertex + 1);
  LimitStory story(narrator.words(), subject, {subject.mesh, next, catmull_clark(next, 3)}, links);
  narrator.paper(paper_width, paper_height);
  narrator.trace().grid.lines = least_cell_of_lines;
  narrator.subtitle("subtitle", {{"vertices", subject.mesh.points.size()},
                                 {"faces", subject.mesh.faces.size()},
                                 {"vertex", subject.vertex + 1}});
  add_credit(narrator);
  narrator.columns({{"point", false}, {"place", false}});
  narrator.legend({{Role::current, "vertex_point"},
                   {Role::measure, "edge_points"},
                   {Role::accepted, "face_points"},
                   {Role::boundary, "normal"},
                   {Role::result, "limit"}});
  narrator.handles("move", [&](dvec3 way_gone) { return story.at(subject.place + way_gone); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Limit<double> end = limit(subject.mesh, subject.vertex, watch);
  narrator.result({{"x", end.point.x}, {"y", end.point.y}, {"z", end.point.z}});
}

/// The points round the vertex, in any order.
const Checking& checking() {
  static const Checking known{
      .asked = {{"face_points", SameList::set, "FacePointFound", {"x", "y", "z"}},
                {"edge_points", SameList::set, "EdgePointFound", {"x", "y", "z"}},
                {"vertex_point", SameList::set, "VertexPointFound", {"x", "y", "z"}}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-6, 1e6};
  static const TopicEntry topic = completed<entry>(
      {.name = "subdivision_surface",
       .chapter = "modeling",
       .aliases = {"catmull-clark", "loop subdivision", "control mesh", "crease", "limit surface"},
       .summary =
           "a mesh gets points in its faces and edges and moves its vertices, level by level, until smooth",
       .methods = {{.name = "catmull_clark",
                    .standing = Standing::taught,
                    .tell = tell_vertex<Way::catmull_clark>,
                    .function = "catmull_clark_level"},
                   {.name = "loop", .tell = tell_vertex<Way::loop>, .function = "loop_level"},
                   {.name = "levels",
                    .tell = tell_levels,
                    .function = "catmull_clark_level",
                    .unread = {"vertex", "move"}},
                   {.name = "limit", .tell = tell_limit, .unread = {"levels"}},
                   {.name = "always_four",
                    .standing = Standing::faulty,
                    .tell = tell_vertex<Way::always_four>}},
       .parameters =
           {choice("shape", {"arch", "cube", "box", "pencil", "spot", "fish", "penguin"}, "arch", "cube",
                   "the control mesh"),
            {"model", ParameterType::model, "", "MODEL.obj", "a control mesh of your own"},
            integer(
                1, 1 << 20, "vertex", "", "8",
                "whose points are told, counted from 1; without it one of five edges, or of nearly as many"),
            numbers("move", "0,0,0", "0,0.5,0", "how far that vertex is moved from its place", xyz, modest),
            integer(1, 4, "levels", "4", "2", "how often the mesh is subdivided"),
            points(1, 64, "creases", "", "1,2,1.5 2,4,10",
                   "edges that stay sharp: two vertices, and for how many levels; from 10 on for ever",
                   {"a", "b", "sharpness"}, {1e-3, 1 << 20}),
            faces_subject::towards_parameter("-3,2.4,5")},
       .examples = {"--shape cube --levels 2", "--shape spot --vertex 8", "--method loop --shape cube"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::subdivision_surface
