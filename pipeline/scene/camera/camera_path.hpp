#pragma once
// A camera that moves: where it is, what it looks at and how wide it sees, told at some frames.

#include "core/geometry.hpp"
#include "scene/camera/keyframes.hpp"
#include "scene/camera/view.hpp"

namespace gradus::pipeline {

/// The greatest number of a frame: 11 hours at 25 a second.
inline constexpr int most_frame = 999'999;

/// Frames are numbered from first to last, 0 <= first <= last <= most_frame. Each quantity has keys of its
/// own; one without keys stays what the view beside the path says.
struct CameraPath {
  int first = 0, last = 0;
  Interpolation interpolation = Interpolation::linear;
  Track<dvec3> eye{}, target{}, up{};
  Track<double> vertical_radians{};
};

/// How a path sees a scene at a frame.
///
/// beside: what the path has no keys for. frame: any finite number; between two frames as well, which motion
///   blur asks for, and before the first or behind the last one as there.
///
/// Domain: a path whose keys lie in its frames.
/// Accuracy: that of value_at, of each coordinate; the angle of view stays in [least_degrees, most_degrees]
///   where a smooth one would swing beyond.
/// Cost: that of value_at, four times.
View view_at(const CameraPath& path, View beside, double frame);

}  // namespace gradus::pipeline
