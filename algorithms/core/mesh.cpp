#include "core/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/contract.hpp"

namespace gradus {

int add_face(Mesh& mesh, std::span<const Corner> corners, int material, int file, int line) {
  expects(corners.size() >= 3, "a face has at least 3 corners, not {}", corners.size());
  mesh.faces.push_back({static_cast<std::int64_t>(mesh.corners.size()), static_cast<int>(corners.size()),
                        material, file, line});
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  return static_cast<int>(mesh.faces.size()) - 1;
}

Mesh mesh_of(std::span<const dvec3> positions, const Faces& faces) {
  expect_faces(faces, positions.size());
  Mesh mesh;
  mesh.positions.assign(positions.begin(), positions.end());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<Corner> corners;
    for (const std::int32_t vertex : faces[f]) corners.push_back({vertex});
    add_face(mesh, corners);
  }
  return mesh;
}

Bounds bounds_of(const Mesh& mesh) {
  Bounds bounds;
  for (const Corner& corner : mesh.corners) bounds.add(position_of(mesh, corner));
  return bounds;
}

Bounds bounds_of(const Mesh& mesh, const MeshFace& face) {
  Bounds bounds;
  for (const Corner& corner : corners_of(mesh, face)) bounds.add(position_of(mesh, corner));
  return bounds;
}

double unit_scale(const Bounds& bounds) {
  const double size = bounds.empty() ? 0 : bounds.radius();
  return size > 0 ? std::scalbn(1.0, -std::clamp(std::ilogb(size), -1000, 1000)) : 1;
}

dvec3 area_vector(const Mesh& mesh, const MeshFace& face, double scale) {
  const std::span<const Corner> corners = corners_of(mesh, face);
  const dvec3 origin = position_of(mesh, corners[0]);
  dvec3 sum{0};
  // Triangles from the first corner; those outside a concave face count negative
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const dvec3 b = (position_of(mesh, corners[i - 1]) - origin) * scale;
    const dvec3 c = (position_of(mesh, corners[i]) - origin) * scale;
    sum += glm::cross(b, c);
  }
  return sum;
}

std::int64_t triangle_count(const Mesh& mesh) {
  return static_cast<std::int64_t>(mesh.corners.size()) - 2 * static_cast<std::int64_t>(mesh.faces.size());
}

bool closed_outward(const Mesh& mesh) {
  if (mesh.faces.empty()) return false;
  std::vector<std::pair<int, int>> edges;
  edges.reserve(mesh.corners.size());
  for (const MeshFace& face : mesh.faces) {
    const std::span<const Corner> corners = corners_of(mesh, face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      edges.emplace_back(corners[i].position, corners[(i + 1) % corners.size()].position);
    }
  }
  std::ranges::sort(edges);
  if (std::ranges::adjacent_find(edges) != edges.end()) return false;  // two faces run the same way
  for (const auto& [from, to] : edges) {
    if (!std::ranges::binary_search(edges, std::pair{to, from})) return false;
  }
  // Six times the volume, magnified, as the sum of the pyramids from the centre to the faces
  const Bounds bounds = bounds_of(mesh);
  const dvec3 centre = bounds.centre();
  const double scale = unit_scale(bounds);
  const auto at = [&](const Corner& corner) { return (position_of(mesh, corner) - centre) * scale; };
  double volume = 0;
  for (const MeshFace& face : mesh.faces) {
    const std::span<const Corner> corners = corners_of(mesh, face);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      volume += glm::dot(at(corners[0]), glm::cross(at(corners[i - 1]), at(corners[i])));
    }
  }
  return volume > 0;
}

namespace {

/// The faces' normals summed up for each position, or for each (position, smoothing group).
class VertexNormals {
 public:
  VertexNormals(const Mesh& mesh, std::span<const int> smoothing) : mesh_(mesh), smoothing_(smoothing) {
    if (smoothing_.empty()) whole_.assign(mesh.positions.size(), dvec3{0});
    scale_ = unit_scale(bounds_of(mesh));  // one for all
    for (std::size_t id = 0; id < mesh.faces.size(); ++id) {
      const dvec3 normal = face_normal(mesh.faces[id]);
      for (const Corner& corner : corners_of(mesh, mesh.faces[id])) *sum(corner.position, id) += normal;
    }
  }

  dvec3 at(int position, std::size_t face) {
    if (!smoothing_.empty() && smoothing_[face] == 0) return unit_vector(face_normal(mesh_.faces[face]));
    return unit_vector(*sum(position, face));
  }

 private:
  dvec3 face_normal(const MeshFace& face) const { return area_vector(mesh_, face, scale_); }

  dvec3* sum(int position, std::size_t face) {
    if (smoothing_.empty()) return &whole_[static_cast<std::size_t>(position)];
    const auto key =
        static_cast<std::uint64_t>(position) << 32 | static_cast<std::uint32_t>(smoothing_[face]);
    return &grouped_.try_emplace(key, 0.0).first->second;
  }

  const Mesh& mesh_;
  std::span<const int> smoothing_;
  double scale_ = 1;
  std::vector<dvec3> whole_;
  std::unordered_map<std::uint64_t, dvec3> grouped_;
};

}  // namespace

void add_missing_normals(Mesh& mesh, std::span<const int> smoothing) {
  expects(smoothing.empty() || smoothing.size() == mesh.faces.size(),
          "a smoothing group for each of {} faces was expected, not {}", mesh.faces.size(), smoothing.size());
  const auto missing = [&mesh](const Corner& corner) {
    return corner.normal < 0 || mesh.normals[static_cast<std::size_t>(corner.normal)] == dvec3{0};
  };
  if (std::ranges::none_of(mesh.corners, missing)) return;

  VertexNormals normals(mesh, smoothing);
  std::vector<int> shared(smoothing.empty() ? mesh.positions.size() : 0, -1);  // one normal per position
  for (std::size_t id = 0; id < mesh.faces.size(); ++id) {
    const MeshFace& face = mesh.faces[id];
    for (std::int64_t i = face.first; i < face.first + face.count; ++i) {
      Corner& corner = mesh.corners[static_cast<std::size_t>(i)];
      if (!missing(corner)) continue;
      int own = -1;
      int& number = shared.empty() ? own : shared[static_cast<std::size_t>(corner.position)];
      if (number < 0) {
        number = static_cast<int>(mesh.normals.size());
        mesh.normals.push_back(normals.at(corner.position, id));
      }
      corner.normal = number;
    }
  }
}

}  // namespace gradus
