// The topic of perspective: a solid's picture and its vanishing points, the transformation that keeps depth
// and the one that bends it, what may be divided and what becomes of the rest, and how finely depth is
// stored.

#include "stories/parameters.hpp"
#include "stories/projection/perspective/stories.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::perspective {
const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  // Parameters that only some methods read, and that only their traces name
  static const std::vector<std::string> of_division{"points", "scales", "centre", "zoom", "fields"};
  static const std::vector<std::string> late{"points", "scales", "centre", "zoom", "fields", "direction"};
  static const std::vector<std::string> divided{"fields", "direction"};
  static const std::vector<std::string> of_frustum{"points", "scales", "centre", "zoom", "direction"};
  const auto method = [](std::string name, Standing standing, void (*tell)(Narrator&), std::string function,
                         std::vector<std::string> unread) {
    const bool exact = standing == Standing::taught;
    return Method{.name = std::move(name),
                  .standing = standing,
                  .tell = tell,
                  .function = std::move(function),
                  .unread = std::move(unread),
                  .exact = exact};
  };
  static const TopicEntry topic = completed<entry>(
      {.name = "perspective",
       .chapter = "projection",
       .aliases = {"perspective projection", "vanishing point", "depth buffer precision", "pinhole camera"},
       .summary = "what is farther looks smaller: projection, vanishing points, and what becomes of depth",
       .methods = {method("projection", Standing::taught, tell_projection, "project", late),
                   method("vanishing_points", Standing::plain, tell_vanishing_points, "vanishing_point",
                          of_division),
                   method("frustum", Standing::plain, tell_frustum, "frustum_corners", of_frustum),
                   method("transformation", Standing::plain, tell_transformation, "transform", late),
                   method("divide_tested", Standing::plain, tell_divide_tested, "transform", divided),
                   method("depth_precision", Standing::plain, tell_depth_precision, "separable_step", late),
                   method("keep_z", Standing::faulty, tell_keep_z, "keep_z", late),
                   method("divide_untested", Standing::faulty, tell_divide_untested, "divide_untested",
                          divided),
                   method("zoom_minus_z", Standing::faulty, tell_zoom_minus_z, "zoom_minus_z", divided),
                   method("parallel_by_plane", Standing::faulty, tell_parallel_by_plane, "parallel_by_plane",
                          of_division)},
       .parameters =
           {number("distance", "3", "1",
                   "the picture plane's distance d from the eye; methods frustum, transformation and keep_z: "
                   "the near plane",
                   {1e-3, 1e6}),
            choice("solid", {"house", "box"}, "house", "box",
                   "method projection: what is projected, 2 wide, 2 high, 3 deep"),
            numbers("at", "1.2,-1,7", "0,0,8", "where the solid's middle stands: x right, y up, z forward",
                    xyz, solids::modest_sizes),
            numbers("turn", "35,0", "35,25",
                    "degrees by which the solid is turned: round the upright, then round x", {"yaw", "pitch"},
                    solids::modest_sizes),
            numbers("from", "0,0,3", "0,0,1", "methods transformation and keep_z: where the line starts", xyz,
                    solids::modest_sizes),
            numbers("to", "6,0,9", "2,0,3", "where it ends", xyz, solids::modest_sizes),
            number("wall", "6.6", "2.2", "the depth of a wall that the line crosses", solids::modest_sizes),
            number("far", "12", "4", "the far plane's depth", solids::modest_sizes),
            numbers("fields", "90,60", "60,45",
                    "method frustum: the angles of view across and up, in degrees", {"across", "up"},
                    {1, 160}),
            integer(1, 15, "samples", "3", "7", "points between the line's ends"),
            numbers("range", "1,1000000", "0.1,1000",
                    "methods depth_precision, divide_tested and divide_untested: the depths of the near and "
                    "the far plane",
                    {"near", "far"}, {1e-9, 1e12}),
            points(1, 6, "points", "2,1,-2 2,1,2 2,1,-6", "1,0,2 1,0,-2",
                   "methods divide_tested, divide_untested and zoom_minus_z: x right, y up, z "
                   "forward, and the lines from one to the next",
                   xyz, {1e-9, 1e6}),
            numbers("scales", "1,1", "1,1.732",
                    "of these methods: by what x and y are multiplied, the cotangents of half the angles of "
                    "view; zoom_minus_z takes the first for both",
                    {"across", "up"}, {1e-3, 1e6}),
            numbers("centre", "0,0", "400,300", "of these methods: x and y straight ahead of the eye", xy,
                    solids::modest_sizes),
            number("zoom", "4", "0", "of these methods: how far before z = 0 the eye stands",
                   solids::modest_sizes),
            numbers("direction", "0,0,0", "1,0,1",
                    "methods vanishing_points and parallel_by_plane: one direction more, along the box's "
                    "axes; 0,0,0: none",
                    xyz, solids::modest_sizes),
            exact_parameter()},
       .examples = {"--solid box --turn 0,0", "--method vanishing_points --turn 35,25",
                    "--method keep_z --distance 1 --from 0,0,1 --to 2,0,3 --wall 2.2 --far 4"}});
  return topic;
}

}  // namespace gradus::perspective
