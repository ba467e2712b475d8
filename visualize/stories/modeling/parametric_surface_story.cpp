// The story of a parametric surface: a sphere's point with tangents and normal, its faces, and what those
// answer instead.

#include "modeling/parametric_surface/parametric_surface.hpp"

#include "modeling/parametric_surface/parametric_surface_notes.hpp"
#include "stories/modeling/parametric_surface/checking.hpp"
#include "stories/modeling/parametric_surface/lookup_story.hpp"
#include "stories/modeling/parametric_surface/patches_story.hpp"
#include "stories/modeling/parametric_surface/point_story.hpp"

namespace gradus::parametric_surface {
namespace {

template <bool by_tangents>
void tell_point(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  PointStory story(narrator.words(), subject);
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle", {{"r", subject.radius}});
  narrator.columns({{"vector", false}, {"x"}, {"y"}, {"z"}});
  narrator.legend({{Role::current, "point"},
                   {Role::candidate, "angles"},
                   {Role::result, "tangents"},
                   {Role::boundary, "seam"},
                   {Role::accepted, "poles"}});
  const Chart chart;
  narrator.handles("angles", [&](dvec2 angles) -> std::optional<dvec2> {
    if (!(0 <= angles.x && angles.x <= 360 && std::abs(angles.y) <= 90)) return {};
    return chart.at(angles.x, angles.y);
  });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Turn<double> s = angle(subject.s), t = angle(subject.t);
  const dvec3 found = [&] {
    if constexpr (by_tangents) return normal_by_tangents(subject.radius, s, t, watch).point;
    return point(subject.radius, s, t, watch).point;
  }();
  narrator.result({{"x", found.x}, {"y", found.y}, {"z", found.z}});
}

template <bool twice>
constexpr auto patches_of = [](const Subject& subject, const auto&... watch) {
  if constexpr (twice) return seam_twice(subject.radius, subject.n, subject.m, watch...);
  return patches(subject.radius, subject.n, subject.m, watch...);
};

template <bool twice>
void tell_patches(Narrator& narrator) {
  Subject subject = subject_of(narrator.arguments());
  subject.s = 60, subject.t = 0;  // seen from the usual place
  const Patches<double> mesh = patches_of<twice>(subject);
  PatchesStory story(narrator.words(), subject, mesh);
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle.patches", {{"r", subject.radius}, {"n", subject.n}, {"m", subject.m}});
  narrator.columns({{"part", false}, {"t"}, {"count"}, {"points"}, {"faces"}});
  narrator.legend({{Role::current, "part"},
                   {Role::past, "again"},
                   {Role::rejected, "open"},
                   {Role::boundary, "seam"},
                   {Role::accepted, "poles"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  patches_of<twice>(subject, watch);
  narrator.result(mesh.points, mesh.faces);
  narrator.result(
      {{"points", std::ssize(mesh.points)}, {"faces", static_cast<std::int64_t>(mesh.faces.size())}});
}

void tell_lookup(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Patches<double> mesh = patches(subject.radius, subject.n, subject.m);
  LookupStory story(narrator.words(), subject, mesh);
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle.patches", {{"r", subject.radius}, {"n", subject.n}, {"m", subject.m}});
  narrator.columns({{"vector", false}, {"x"}, {"y"}, {"z"}});
  narrator.legend({{Role::current, "cell"},
                   {Role::input, "place"},
                   {Role::boundary, "surface"},
                   {Role::measure, "faces"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const LookedUp<double> found = lookup(mesh, subject.s, subject.t, watch);
  narrator.result({{"x", found.point.x}, {"y", found.point.y}, {"z", found.point.z}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const std::vector<std::string> mesh_only{"n", "m"};
  static const TopicEntry topic = completed<entry>(
      {.name = "parametric_surface",
       .chapter = "modeling",
       .aliases = {"sphere", "spherical coordinates", "parametric patch", "poles and seam"},
       .summary = "a sphere by two angles: its points, tangents and normals, and the faces made of it",
       .methods =
           {{.name = "point", .standing = Standing::taught, .tell = tell_point<false>, .unread = mesh_only},
            {.name = "patches", .tell = tell_patches<false>, .unread = {"angles"}},
            {.name = "lookup", .tell = tell_lookup, .within = {{"n", 24}, {"m", 12}}},
            {.name = "normal_by_tangents",
             .standing = Standing::faulty,
             .tell = tell_point<true>,
             .unread = mesh_only},
            {.name = "seam_twice",
             .standing = Standing::faulty,
             .tell = tell_patches<true>,
             .unread = {"angles"}}},
       .parameters = {numbers("angles", "60,30", "200,-45",
                              "s round the axis and t up from the equator's plane, in degrees", {"s", "t"},
                              {1e-3, 360}),
                      number("radius", "2", "1", "of the sphere", {1e-6, 1e6}),
                      integer(3, 96, "n", "8", "24", "patches round the axis"),
                      integer(2, 48, "m", "4", "12", "patches from pole to pole")},
       .examples = {"--angles 0,90", "--method patches --n 12 --m 6", "--method lookup --angles 50,20"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::parametric_surface
