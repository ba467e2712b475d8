#pragma once
// The camera of a view by parallel rays: from which side, and how much of the world it shows.

#include <span>

#include "scene/camera/view.hpp"
#include "scene/scene.hpp"

namespace gradus::pipeline {

/// Makes a camera see by parallel rays, as a view asks for.
///
/// camera: looks the right way. view: orthographic or oblique. plane: the depth of what is drawn where it
///   would be without slant. objects: with at least one face in all. aspect: width / height of the picture.
///
/// Without a height the objects fill the picture but for a margin of a twentieth on either side; without eye
/// and target they stand in its middle.
/// Accuracy: two opposite borders of the picture, less the margin, are touched when the middle is free.
/// Cost: the objects' corners. Errors: none.
SceneCamera with_rays(const Camera& camera, const View& view, double plane, std::span<const Object> objects,
                      double aspect);

}  // namespace gradus::pipeline
