#pragma once
// Objects whose models are control meshes: how often they are subdivided, and the mesh that makes.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/mesh.hpp"
#include "scene/camera/scene_camera.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// Levels that a scene may ask for.
inline constexpr int most_subdivisions = 6;
/// Edges of at most so many pixels show no corners.
inline constexpr double fine_edge = 4;
/// As many faces as an object is given.
inline constexpr std::int64_t most_subdivided_faces = std::int64_t{1} << 22;

/// The mesh after so many levels of Catmull and Clark's rules (modeling/subdivision_surface): faces keep
/// their materials, texture coordinates are shared out evenly within each face of the control mesh, normals
/// are the means of the faces round a place. Domain: at most two faces at an edge, in one sense; one fan of
/// faces at a place. Errors: ContractViolation outside the domain.
Mesh subdivided(const Mesh& control, int levels);

/// Why a mesh can't be subdivided, if it can't.
std::optional<std::string> why_not_subdivided(const Mesh& control);

/// The level of an object: 0 where it is no subdivided one.
inline int level_of(const Object& object) { return object.subdivision ? object.subdivision->level : 0; }

/// Gives every object with a control mesh the mesh of its level: the least at which none of its edges is
/// longer than fine_edge in any of the pictures, at most as many as it allows and its faces are many. Each
/// level halves the edges.
///
/// cameras: of the pictures that will be rendered of the scene. size: theirs.
/// Accuracy: edges are measured on the control mesh, one that reaches behind an eye as endless.
/// Errors: as subdivided.
void subdivide(Scene& scene, std::span<const SceneCamera> cameras, Size size);

}  // namespace gradus::pipeline
