#pragma once
// How a scene is to be seen; what is left open is found from its objects.

#include <optional>
#include <span>

#include "core/camera.hpp"
#include "core/geometry.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// The angles of view that may be asked for, in degrees.
inline constexpr double least_degrees = 0.001, most_degrees = 179.999;

/// What is told of a view, in world space.
struct View {
  std::optional<dvec3> eye, target, up;               ///< up: a direction, any length but 0
  double vertical_radians = Lens{}.vertical_radians;  ///< the angle of view, in (0, pi)
  Projection3d projection = Projection3d::perspective;
  std::optional<double> height;                  ///< of what parallel rays show, > 0
  double receding_radians = 0.7853981633974483;  ///< oblique: the angle at which depth is drawn, 45 degrees
  double foreshortening = 0.5;                   ///< oblique: how long a unit of depth is drawn, >= 0
};

/// From where, to where, and which direction is up in the picture.
struct Aim {
  dvec3 eye{0}, target{0, 0, -1}, up{0, 1, 0};
};

/// Completes a view.
///
/// objects: with at least one face in all. aspect: width / height of the picture.
///
/// Without eye: where `framed` puts it, so that all is seen: one object from its viewing_side, several from
/// front_right_above; obliquely straight from the front, so that it is seen in its true shape. Where `up` is
/// told, the front is what +z is where y is up; where z is up that is -y. Without target: the middle of all;
/// with neither, the direction in which all is seen. Without up: y, or -z where y is almost the direction of
/// the view. Errors: ContractViolation for an up of length 0 and for what `framed` refuses.
Aim aim_of(std::span<const Object> objects, const View& view, double aspect);
/// The same for one object.
inline Aim aim_of(const Object& object, const View& view, double aspect) {
  return aim_of(std::span(&object, 1), view, aspect);
}

/// Whether the target is another point than the eye.
bool leads_somewhere(const Aim& aim);
/// Whether up is another direction than that of the view. Domain: leads_somewhere(aim).
bool tells_upright(const Aim& aim);

/// The camera of an aim, with its near and far plane round the objects. Domain: both of the above.
SceneCamera camera_of(const Aim& aim, const View& view, std::span<const Object> objects, double aspect);
Camera camera_of(const Aim& aim, double vertical_radians, std::span<const Object> objects);
inline Camera camera_of(const Aim& aim, double vertical_radians, const Object& object) {
  return camera_of(aim, vertical_radians, std::span(&object, 1));
}

}  // namespace gradus::pipeline
