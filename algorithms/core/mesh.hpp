#pragma once
// Surfaces made of flat faces with any number of corners, that know which line of which file they come from.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/faces.hpp"
#include "core/geometry.hpp"
#include "core/surface.hpp"

namespace gradus {

/// A corner of a face: numbers into the mesh's arrays, from 0; -1 where there is none.
struct Corner {
  int position = 0;
  int texture = -1;
  int normal = -1;

  friend constexpr bool operator==(const Corner&, const Corner&) = default;
};

/// A face: its corners stand in mesh.corners from `first` on, counter-clockwise seen from outside.
struct MeshFace {
  std::int64_t first = 0;
  int count = 0;     ///< corners, >= 3
  int material = 0;  ///< number into mesh.materials
  int file = -1;     ///< number into mesh.files; -1 when it comes from none
  int line = 0;      ///< line of that file, from 1; 0 when it is not known
};

/// Positions, faces and all they refer to. A face's id is its place in `faces`.
struct Mesh {
  std::vector<dvec3> positions;
  std::vector<dvec3> normals;   ///< of length 1, or zero where a file gives none worth the name
  std::vector<dvec2> textures;  ///< texture coordinates, v up
  std::vector<Corner> corners;
  std::vector<MeshFace> faces;
  std::vector<Material> materials{Material{}};  ///< number 0 is the default
  std::vector<std::string> files;               ///< what the faces were read from
};

/// The corners of a face, in order.
inline std::span<const Corner> corners_of(const Mesh& mesh, const MeshFace& face) {
  return {mesh.corners.data() + face.first, static_cast<std::size_t>(face.count)};
}

/// The position of one corner.
inline dvec3 position_of(const Mesh& mesh, const Corner& corner) {
  return mesh.positions[static_cast<std::size_t>(corner.position)];
}

/// Adds a face of these corners and returns its id. Domain: at least 3 corners (refused otherwise).
int add_face(Mesh& mesh, std::span<const Corner> corners, int material = 0, int file = -1, int line = 0);

/// A surface as algorithms give it: places of vertices, and faces that name them.
struct PolygonMesh {
  std::vector<dvec3> points;
  Faces faces;
};

/// The mesh of these faces. Domain: as expect_faces has it (refused otherwise).
Mesh mesh_of(std::span<const dvec3> positions, const Faces& faces);

/// The smallest box that holds every position some face uses; empty when there is no face.
Bounds bounds_of(const Mesh& mesh);
/// The smallest box that holds a face.
Bounds bounds_of(const Mesh& mesh, const MeshFace& face);

/// The power of two that magnifies a box so that squares and cubes of its lengths neither overflow nor
/// vanish; 1 for a box without extent. Magnified by it, a radius of at least 2^-1000 lies in [1, 2).
double unit_scale(const Bounds& bounds);

/// The normal of a face with the length of its doubled area, by Newell's method, which also knows what to do
/// with concave faces, collinear corners and faces that are not quite flat.
/// Source: Sutherland, Sproull, Schumacker, "A characterization of ten hidden-surface algorithms", 1974,
/// after M. E. Newell.
/// scale: magnifies the face first, as unit_scale does; a direction needs it where sizes may be extreme.
/// Domain: coordinates up to 1e150, and from 1e-150 on, once magnified.
/// Accuracy: m (m + 9) 2^-53 of the square of the longest side of the magnified face's box, m its corners
/// less 2.
dvec3 area_vector(const Mesh& mesh, const MeshFace& face, double scale = 1);

/// How many triangles the faces make: corners - 2 each.
std::int64_t triangle_count(const Mesh& mesh);

/// Whether the mesh encloses a body and shows its outside: every edge joins exactly two faces that run along
/// it in opposite directions, and the enclosed volume is positive. Only then are its back faces never seen.
/// Domain: coordinates up to 1e300, of any smallness.
/// Cost: sorts the edges.
bool closed_outward(const Mesh& mesh);

/// Gives a normal to every corner without one, or whose own is zero: at each position the mean of the
/// faces' normals, weighted by their areas. smoothing: a group for each face, by id; faces are averaged with
/// others of the same group, and those of group 0 stay flat. Empty: all faces are in one group. Where a
/// position has no area round it, its corners get the zero vector.
/// Errors: ContractViolation when `smoothing` is neither empty nor as long as the list of faces.
void add_missing_normals(Mesh& mesh, std::span<const int> smoothing = {});

}  // namespace gradus
