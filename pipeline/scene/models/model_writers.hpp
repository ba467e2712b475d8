#pragma once
// Meshes as the texts of model files, which the readers beside this one read back equal.

#include <string>
#include <string_view>

#include "core/mesh.hpp"

namespace gradus::pipeline {

// Of each mesh: its faces with the places of their corners, and where corners have normals, these. Materials
// and textures are not written. Numbers are the shortest that read as the same double.
//
// comment: one line, for people.
// Domain: finite coordinates up to 1e30, at least one face.
// Cost: linear, for STL that of cutting faces into triangles.
// Errors: ContractViolation outside the domain.

/// A Wavefront OBJ file. Read back, positions and corners are the mesh's own, in their order, and so are
/// normals but for a last place: readers give them the length 1 anew.
std::string obj_of(const Mesh& mesh, std::string_view comment);

/// A PLY file of text. A vertex has one normal there: corners of several normals make as many vertices of one
/// place, and normals are left out where a corner lacks its own. Read back, faces have the same corners.
std::string ply_of(const Mesh& mesh, std::string_view comment);

/// An STL file of text: triangles, larger faces cut into them, with flat normals. Read back, it has these.
std::string stl_of(const Mesh& mesh, std::string_view comment);

}  // namespace gradus::pipeline
