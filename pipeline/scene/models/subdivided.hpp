#pragma once
// The mesh that subdividing a control mesh makes.

#include <optional>
#include <string>

#include "core/mesh.hpp"

namespace gradus::pipeline {

/// Levels that a scene may ask for.
inline constexpr int most_subdivisions = 6;

/// The mesh after so many levels of Catmull and Clark's rules (modeling/subdivision_surface): faces keep
/// their materials and their places in files, texture coordinates are shared out evenly within each face of
/// the control mesh, normals are the means of the faces round a place. Domain: at most two faces at an edge,
/// in one sense; one fan of faces at a place. Errors: ContractViolation outside the domain.
Mesh subdivided(const Mesh& control, int levels);

/// Why a mesh can't be subdivided, if it can't.
std::optional<std::string> why_not_subdivided(const Mesh& control);

}  // namespace gradus::pipeline
