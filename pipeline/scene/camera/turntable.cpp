#include "scene/camera/turntable.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "scene/camera/framing.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline {
namespace {

/// What objects sweep when they turn about an axis.
struct Cylinder {
  dvec3 foot, axis;  ///< a place on the axis, and its direction, of length 1
  double radius = 0;
  double lowest = std::numeric_limits<double>::infinity(),
         highest = -lowest;  ///< along the axis, from the foot

  void add(dvec3 point) {
    const double height = glm::dot(point - foot, axis);
    lowest = std::min(lowest, height), highest = std::max(highest, height);
    radius = std::max(radius, length_of(point - foot - height * axis));
  }
};

Cylinder swept_by(std::span<const Object> objects, dvec3 foot, dvec3 axis) {
  Cylinder cylinder{foot, axis};
  for (const Object& object : objects) {
    for (const Corner& corner : object.mesh->corners)
      cylinder.add(affine_3d::transform(object.placement, position_of(*object.mesh, corner)));
  }
  return cylinder;
}

/// The same place once more round the axis.
dvec3 turned(dvec3 place, dvec3 foot, dvec3 axis, double radians) {
  return foot + dvec3(affine_3d::rotation(axis, radians) * glm::dvec4(place - foot, 0));
}

/// Where an aim goes back to see a cylinder from: along its direction.
Aim before(const Cylinder& cylinder, const Aim& aim, double aspect, double radians) {
  constexpr int places = 64;  // on each rim; between them it is less than a six hundredth farther out
  const dvec3 towards_eye = aim.eye - aim.target;
  // Turned so that the axis is y, as framed() has it
  const dvec3 side = unit_vector(towards_eye - glm::dot(towards_eye, cylinder.axis) * cylinder.axis);
  const glm::dmat3 back(glm::cross(cylinder.axis, side), cylinder.axis, side);
  std::vector<dvec3> rims;
  for (int i = 0; i < places; ++i) {
    const double angle = 2 * std::numbers::pi * i / places;
    const auto [sin, cos] = sin_cos(angle);
    const dvec3 way{cylinder.radius * sin, 0, cylinder.radius * cos};
    for (const double height : {cylinder.lowest, cylinder.highest}) rims.push_back(way + dvec3{0, height, 0});
  }
  const dvec3 from = glm::transpose(back) * towards_eye;
  const Frame<double> frame = framed(std::span<const dvec3>(rims), aspect, from, radians).frame;
  // It looks at the axis
  const double ahead = -frame.eye.z / frame.forward.z;
  return {cylinder.foot + back * frame.eye, cylinder.foot + back * (frame.eye + ahead * frame.forward),
          cylinder.axis};
}

}  // namespace

CameraPath turntable(std::span<const Object> objects, const View& view, double aspect, int frames) {
  expects(1 <= frames && frames <= most_turntable_frames, "a turn has 1 to {} frames, not {}",
          most_turntable_frames, frames);
  Aim aim = aim_of(objects, view, aspect);
  const dvec3 axis = unit_vector(aim.up);
  // With an eye, an aim's target is the one that is told, or the middle of all
  View from_there = view;
  from_there.eye = aim.eye;
  const dvec3 foot = aim_of(objects, from_there, aspect).target;
  if (!view.eye && has_eye(view.projection))
    aim = before(swept_by(objects, foot, axis), aim, aspect, view.vertical_radians);
  CameraPath path{0, frames - 1};
  for (int i = 0; i < frames; ++i) {
    const double radians = 2 * std::numbers::pi * i / frames;
    path.eye.push_back({i, turned(aim.eye, foot, axis, radians)});
    path.target.push_back({i, turned(aim.target, foot, axis, radians)});
  }
  path.up = {{0, aim.up}};
  return path;
}

}  // namespace gradus::pipeline
