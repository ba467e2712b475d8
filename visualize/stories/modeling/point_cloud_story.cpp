// The story of points without faces: the normal of each from its neighbours, depth images as points, and
// what is seen of points from near.

#include "modeling/point_cloud/point_cloud.hpp"

#include "modeling/point_cloud/point_cloud_notes.hpp"
#include "stories/checking.hpp"
#include "stories/modeling/point_cloud/depth_story.hpp"
#include "stories/modeling/point_cloud/normal_story.hpp"
#include "stories/modeling/point_cloud/zoom_story.hpp"
#include "stories/parameters.hpp"

namespace gradus::point_cloud {
namespace {

/// In smaller cells lines of text would lie on each other.
constexpr double least_cell_of_lines = 13.5;

template <Way way>
void tell_normal(Narrator& narrator) {
  Subject subject{.reader = faces_subject::reader_of(narrator.arguments())};
  prepare(subject, narrator.arguments());
  NormalStory story(narrator.words(), subject, way, whole_of<way>(subject));
  require_scale(story.panel(), narrator.arguments(), {"eye", "at"});
  narrator.paper(paper_width, paper_height);
  narrator.trace().grid.lines = least_cell_of_lines;
  narrator.subtitle("subtitle",
                    {{"points", subject.points.size()}, {"point", subject.point + 1}, {"k", subject.k}});
  narrator.columns({{"what", false}, {"value", false}});
  narrator.legend({{Role::current, "point"},
                   {Role::candidate, "near"},
                   {Role::accepted, "plane"},
                   {Role::result, "normal"},
                   {Role::rejected, "other"},
                   {Role::measure, "eye"},
                   {Role::boundary, "points"}});
  for (const std::size_t dots : {1u, 5u, 6u}) narrator.trace().legend[dots].sample = Sample::dot;
  const dvec3 at = *narrator.arguments().place("at");
  narrator.handles("eye", [&](dvec3 eye) { return story.at(eye + at); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const Surface n = normal_by<way>(subject.tree, subject.point, subject.k, subject.eye, watch);
  watch(steps::Finished{}, 0);
  narrator.result({{"x", n.way.x}, {"y", n.way.y}, {"z", n.way.z}, {"variation", n.variation()}});
}

void tell_depth(Narrator& narrator) {
  const DepthImage image = depth_image_of(narrator.arguments());
  const faces_subject::Reader reader(dvec3{3, 1.6, 1.6});
  DepthStory story(narrator.words(), image, reader);
  require_scale(story.panel(), narrator.arguments(), {"depths", "focal"});
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("subtitle.depth",
                    {{"columns", columns}, {"rows", image.depth.height()}, {"focal", image.camera.focal}});
  narrator.columns({{"pixel", false}, {"z"}, {"x"}, {"y"}, {"again", false}});
  narrator.legend({{Role::current, "pixel"},
                   {Role::measure, "ray"},
                   {Role::input, "depths"},
                   {Role::past, "seen"},
                   {Role::result, "cloud"},
                   {Role::boundary, "picture"},
                   {Role::rejected, "hole"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto points = back_project(image.depth, image.camera, watch);
  narrator.result({{"points", std::ssize(points)}});
}

void tell_zoom(Narrator& narrator) {
  Subject subject{.reader = faces_subject::reader_of(narrator.arguments())};
  prepare(subject, narrator.arguments());
  const auto zooms = static_cast<int>(narrator.arguments().integer("zooms"));
  const auto radius = static_cast<int>(narrator.arguments().integer("radius"));
  ZoomStory story(narrator.words(), subject, zooms, radius);
  narrator.paper(paper_width, paper_height);
  narrator.trace().grid.lines = least_cell_of_lines;
  narrator.subtitle("subtitle.zoom", {{"points", subject.points.size()}, {"dots", dots_of(radius)}});
  narrator.columns({{"zoom"}, {"surface"}, {"covered"}, {"bare"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (ZoomPicture& picture : story.pictures()) {
    std::optional<Report> done;
    const auto keep = [&]<class Step>(const Step& step, int line = __builtin_LINE(),
                                      const char* file = __builtin_FILE()) {
      if constexpr (std::same_as<Step, Finished>) done = {step, line, file};
    };
    const std::vector<dvec3> seen = picture.screen.seen(subject);
    picture.front = draw<double>(seen, ivec2(picture.screen.pixels), radius, keep);
    ZoomStory::count(picture);
    watch(done->step, done->line, done->file);
  }
  narrator.result({{"bare", story.pictures().back().bare}});
}

/// The points of the pixels, in their order.
const Checking& checking() {
  static const Checking known{.asked = {{.name = "points",
                                         .same = SameList::order,
                                         .type = "BackProjected",
                                         .fields = {"x", "y", "z"},
                                         .method = "back_project"}}};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Sizes modest{1e-3, 1e4};
  const Names of_normals{"depths", "focal", "radius", "zooms"},
      of_depths{"shape", "model", "count", "noise", "at", "k", "point", "eye", "radius", "zooms", "towards"};
  const std::vector<AtMost> few{{"count", 1000}};
  static const TopicEntry topic = completed<entry>(
      {.name = "point_cloud",
       .chapter = "modeling",
       .aliases = {"point set", "normal estimation", "depth image", "range image", "splats"},
       .summary =
           "points without faces: their normals from neighbours, from depth images, and seen from near",
       .methods = {{.name = "normal",
                    .standing = Standing::taught,
                    .tell = tell_normal<Way::right>,
                    .why_without = "",
                    .within = few,
                    .unread = of_normals},
                   {.name = "back_project", .tell = tell_depth, .unread = of_depths},
                   {.name = "draw",
                    .tell = tell_zoom,
                    .unread = {"depths", "focal"},
                    .opening = {{"shape", "ball"}, {"count", "2500"}, {"eye", "-4,5,-3"}}},
                   {.name = "uncentred",
                    .standing = Standing::faulty,
                    .tell = tell_normal<Way::uncentred>,
                    .why_without = "",
                    .within = few,
                    .unread = of_normals,
                    .opening = {{"shape", "ball"}, {"count", "400"}, {"eye", "-5,3,-4"}, {"at", "-10,5,-8"}}},
                   {.name = "unturned",
                    .standing = Standing::faulty,
                    .tell = tell_normal<Way::unturned>,
                    .why_without = "",
                    .within = few,
                    .unread = of_normals,
                    .opening = {{"shape", "ball"}, {"count", "400"}, {"eye", "-3,2,-3"}}}},
       .default_method = "normal",
       .parameters =
           {choice("shape", {"saddle", "ball", "roof", "plane", "cube", "spot", "fish", "icosphere"},
                   "saddle", "roof",
                   "the surface on which the points lie, or a model whose vertices they are"),
            {"model", ParameterType::model, "", "MODEL.obj",
             "a model of your own: its vertices are the points"},
            integer(1, 4000, "count", "140", "300",
                    "how many points a surface has; a cube or model has its own"),
            number("noise", "0", "0.05", "how far they lie off it at most, either way", {1e-4, 10}),
            numbers("at", "0,0,0", "100,0,0", "how far cloud and eye are moved from the origin", xyz, modest),
            integer(1, 64, "k", "14", "6", "how many neighbours a normal comes from, with the point itself"),
            integer(1, 4000, "point", "",
                    "7", "which point is told, counted from 1; else one near the middle of the picture"),
            numbers("eye", "-0.2,0.8,-1.6", "-2,2,-1", "from where the points were seen: normals turn there",
                    xyz, modest),
            points(1, 5, "depths", "11,11,11,11,11,11 11,9,8,8,9,11 11,8,7,7,8,11 11,9,8,8,9,0",
                   "8,8,8,8,8,8 8,8,4,4,8,8",
                   "rows of a depth image, of six depths each; 0: nothing was seen",
                   {"a", "b", "c", "d", "e", "f"}, {1e-2, 1e4}),
            number("focal", "4", "6", "how far in front of the eye the picture lies, in pixels", {1e-2, 1e4}),
            integer(0, 8, "radius", "1", "0", "of dots in pixels: each has twice as many and one either way"),
            integer(1, 4, "zooms", "3", "2", "pictures, each twice as near as the one before"),
            faces_subject::towards_parameter("-5,2.5,-4")},
       .examples = {"--k 5", "--method back_project", "--method draw --radius 0"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::point_cloud
