#pragma once
// A model on a turntable: the camera goes once round it.

#include <span>

#include "scene/camera/camera_path.hpp"
#include "scene/camera/view.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// A turn has so many frames at most: seven minutes at 25 a second.
inline constexpr int most_turntable_frames = 10'000;

/// The path of a camera that goes once round what it looks at, about the direction that is up,
/// counter-clockwise seen from above: frame i has gone i / frames of the way, so that the film can run in a
/// circle.
///
/// objects, view, aspect: as for aim_of. frames: 1 to most_turntable_frames.
///
/// With an eye that is told, it goes round the target, or the middle of all. Without, the eye stands where
/// the cylinder about all that turns is in the picture: all is seen in every frame, and none is larger than
/// another. Accuracy: each eye within 34 ulp of its distance from the target, and one of the target's size:
/// of the angle 8, the axis 14, the matrix 8, the sums 4. Cost: a pass over the corners, and a key per frame.
/// Errors: ContractViolation for frames out of range, and for what aim_of refuses.
CameraPath turntable(std::span<const Object> objects, const View& view, double aspect, int frames);

}  // namespace gradus::pipeline
