#pragma once
// How somebody wants to see a model; what he leaves open is found from the model.

#include <optional>

#include "core/camera.hpp"
#include "core/geometry.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// What is told of a view, in world space.
struct View {
  std::optional<dvec3> eye, target, up;               ///< up: a direction, any length but 0
  double vertical_radians = Lens{}.vertical_radians;  ///< the angle of view, in (0, pi)
};

/// From where, to where, and which direction is up in the picture.
struct Aim {
  dvec3 eye{0}, target{0, 0, -1}, up{0, 1, 0};
};

/// Completes a view.
///
/// object: with at least one face. aspect: width / height of the picture.
///
/// Without eye: where `framed` puts it, so that all is seen. Of an object whose `up` is told, the front is
/// what +z is where y is up; where z is up that is -y. Without target: the middle of the object; with
/// neither, the direction in which all is seen. Without up: y, or -z where y is almost the direction of the
/// view. Errors: ContractViolation for an up of length 0 and for what `framed` refuses.
Aim aim_of(const Object& object, const View& view, double aspect);

/// Whether the target is another point than the eye.
bool leads_somewhere(const Aim& aim);
/// Whether up is another direction than that of the view. Domain: leads_somewhere(aim).
bool tells_upright(const Aim& aim);

/// The camera of an aim, with its near and far plane round the object. Domain: both of the above.
Camera camera_of(const Aim& aim, double vertical_radians, const Object& object);

}  // namespace gradus::pipeline
