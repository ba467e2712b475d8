#pragma once
// The default camera and lights: placed from the bounds of what is to be seen.

#include <span>
#include <string>
#include <vector>

#include "core/camera.hpp"
#include "core/geometry.hpp"
#include "core/mesh.hpp"
#include "core/surface.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// From where a model is looked at: the direction from its middle to the eye, of any length but 0.
/// A closed body is seen from the front (+z), a little from the right and from above. An open one that shows
/// more of its faces' outsides to another side, as a room without one wall does, is seen straight from that
/// side.
dvec3 viewing_side(const Object& object);

/// A little from the right and from above of +z.
inline constexpr dvec3 front_right_above{0.45, 0.32, 1};

/// The nearest camera that looks along a direction and has all points in its picture, y up, with a margin of
/// a twentieth on either side.
///
/// points: of what is to be seen, at least one. aspect: width / height of the picture, > 0. side: from the
///   things to the eye, any length but 0; straight up or down turns the picture so that -z is up.
/// vertical_radians: the angle of view between lower and upper edge, in (0, pi).
///
/// Accuracy: two opposite borders of the picture, less the margin, are touched; between the other two the
///   points stand in the middle.
/// Cost: 50 times the points. Points that are all in one place are seen from a distance of 1. The eye keeps
/// at least 1e-12 of the points' distance from the origin away from them, so that it is told apart from them.
/// Errors: ContractViolation for no points and for parameters out of range.
Camera framed(std::span<const dvec3> points, double aspect, dvec3 side = front_right_above,
              double vertical_radians = Lens{}.vertical_radians);

/// The same for a box.
Camera framed(const Bounds& bounds, double aspect, dvec3 side = front_right_above,
              double vertical_radians = Lens{}.vertical_radians);

/// The same camera with the near and the far plane set so that the box lies between them, for a camera that
/// somebody else has placed. From inside the box near is a thousandth of far.
Camera with_depths(Camera camera, const Bounds& bounds);

/// The default lights: a strong one behind the viewer's left shoulder and a weak one from the
/// right. They are directional, so the size of the model makes no difference.
std::vector<Light> default_lights(const Camera& camera);

/// A scene of one mesh with the camera and the lights that are placed for it.
/// aspect: width / height of the picture. Errors: ContractViolation for a mesh without faces.
Scene scene_of(Mesh mesh, double aspect, std::string name = {});

}  // namespace gradus::pipeline
