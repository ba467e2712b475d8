#pragma once
// How often objects with control meshes are subdivided: as the picture needs it.

#include <cstdint>
#include <span>

#include "scene/camera/scene_camera.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// Edges of some so many pixels show no corners.
inline constexpr double fine_edge = 4;
/// As many faces as an object is given.
inline constexpr std::int64_t most_subdivided_faces = std::int64_t{1} << 22;

/// The level of an object: 0 where it is no subdivided one.
inline int level_of(const Object& object) { return object.subdivision ? object.subdivision->level : 0; }

/// Gives every object with a control mesh the mesh of its level: the least at which none of its edges is
/// longer than fine_edge in any of the pictures, at most as many as it allows, and as make no more than
/// most_subdivided_faces. Each level is taken to halve the edges; round vertices of many edges
/// they shrink more slowly.
///
/// cameras: of the pictures that will be rendered of the scene. size: theirs.
/// Accuracy: edges are measured on the control mesh, one that reaches behind an eye as endless.
/// Errors: as subdivided.
void subdivide(Scene& scene, std::span<const SceneCamera> cameras, Size size);

}  // namespace gradus::pipeline
