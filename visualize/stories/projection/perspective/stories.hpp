#pragma once
// What the stories of perspective share; each tells its methods in a file of its own.

#include "projection/perspective/perspective.hpp"
#include "stories/projection/solids.hpp"
#include "stories/telling.hpp"

namespace gradus::perspective {

using solids::place_text;
using solids::real;
using solids::short_real;
using solids::vector_of;

// projection_story.cpp
void tell_projection(Narrator& narrator);
// vanishing_story.cpp
void tell_vanishing_points(Narrator& narrator);
void tell_parallel_by_plane(Narrator& narrator);
// bent_story.cpp
void tell_transformation(Narrator& narrator);
void tell_keep_z(Narrator& narrator);
// division_story.cpp
void tell_divide_tested(Narrator& narrator);
void tell_divide_untested(Narrator& narrator);
void tell_zoom_minus_z(Narrator& narrator);
// frustum_story.cpp
void tell_frustum(Narrator& narrator);
// depth_story.cpp
void tell_depth_precision(Narrator& narrator);

using solids::paper_height;

inline double distance_of(const Arguments& arguments) {
  const double d = *arguments.number("distance");
  if (!(d > 0)) refuse("distance", "expected a distance above 0, not {}", d);
  return d;
}

/// The solid's own x, y and z in view space.
inline std::array<dvec3, 3> axes_of(const Arguments& arguments) {
  const std::vector<double> turn = arguments.numbers("turn");
  return solids::turned_axes(turn[0], turn[1]);
}

inline void say_turn(Narrator& narrator, std::string_view subtitle) {
  const std::vector<double> turn = narrator.arguments().numbers("turn");
  narrator.subtitle(subtitle, {{"yaw", real(turn[0])}, {"pitch", real(turn[1])}});
}

/// Where the ray from a point of a rectangle leaves it.
inline dvec2 last_inside(const Extent& box, dvec2 a, dvec2 way) {
  return a + std::max(0.0, span_in(box, a, way, 0, 1e300).second) * way;
}

/// Two drawings beside each other: space from above, and what becomes of it.
inline const Extent space_place{{3.4, 2.6}, {17, 21.4}};
inline void add_captions(View& view, const Words& words, std::string image) {
  view.add({"z caption space", Role::guide, Text{{10, 23.2}, words.say("from_above")}});
  view.add({"z caption image", Role::guide, Text{{28.5, 23.2}, std::move(image)}});
}

/// What says whether a point of this depth has an image.
inline Decision before_eye(const Words& words, double z) {
  return yes_or_no(words, "question.before_eye", {{"z", z}}, z > 0, "before", "behind");
}

}  // namespace gradus::perspective
