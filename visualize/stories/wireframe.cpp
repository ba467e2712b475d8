#include "stories/wireframe.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <map>
#include <set>

namespace gradus {
namespace {

/// Whether a point in the plane of a flat polygon lies inside it, by the parity of crossings, seen along the
/// axis in which its normal is largest.
bool inside(const Mesh& mesh, const MeshFace& face, dvec3 normal, dvec3 p) {
  const dvec3 size = glm::abs(normal);
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  bool in = false;
  const auto corners = corners_of(mesh, face);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 a = position_of(mesh, corners[i]), b = position_of(mesh, corners[(i + 1) % corners.size()]);
    if ((a[v] <= p[v]) == (b[v] <= p[v])) continue;
    const double at = a[u] + (p[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]);
    if (p[u] < at) in = !in;
  }
  return in;
}

/// Whether the mesh is a body that lies behind the plane of each of its faces.
bool is_convex(const Mesh& mesh, double size) {
  if (!closed_outward(mesh)) return false;
  for (const MeshFace& face : mesh.faces) {
    const dvec3 normal = area_vector(mesh, face);
    const double length = glm::length(normal), most = 1e-9 * size * length;
    const dvec3 at = position_of(mesh, corners_of(mesh, face)[0]);
    const auto beyond = [&](dvec3 p) { return glm::dot(normal, p - at) > most; };
    if (!(length > 0) || std::ranges::any_of(mesh.positions, beyond)) return false;
  }
  return true;
}

/// A viewer as a homogeneous point: an eye, or with w = 0 the direction of parallel sight.
glm::dvec4 viewer_of(dvec3 point, const Sight& sight) {
  const bool parallel = sight.far >= 1e300;
  return parallel ? glm::dvec4(sight.direction, 0) : glm::dvec4(point + sight.far * sight.direction, 1);
}

/// A plane: what has a negative product with its normal lies on the shadow's side of it.
struct ShadowPlane {
  dvec3 normal, at;
};

/// What a convex body hides lies behind all faces that look to the viewer, and within the planes through him
/// and the edges between those faces and the others.
std::vector<ShadowPlane> shadow_of(const Mesh& mesh, const glm::dvec4& viewer) {
  std::vector<ShadowPlane> planes;
  std::map<std::pair<int, int>, int> lit;  // of an edge, how many of its two faces look to the viewer
  for (const MeshFace& face : mesh.faces) {
    const dvec3 normal = glm::normalize(area_vector(mesh, face));
    const auto corners = corners_of(mesh, face);
    const dvec3 at = position_of(mesh, corners[0]);
    if (!(glm::dot(normal, dvec3(viewer) - viewer.w * at) > 0)) continue;
    planes.push_back({normal, at});
    for (std::size_t i = 0; i < corners.size(); ++i) {
      ++lit[std::minmax(corners[i].position, corners[(i + 1) % corners.size()].position)];
    }
  }
  dvec3 middle{0};
  for (const dvec3 p : mesh.positions) middle += p / static_cast<double>(mesh.positions.size());
  for (const auto& [ends, count] : lit) {
    if (count == 2) continue;
    const dvec3 a = mesh.positions[static_cast<std::size_t>(ends.first)];
    const dvec3 b = mesh.positions[static_cast<std::size_t>(ends.second)];
    const dvec3 normal = glm::normalize(glm::cross(b - a, dvec3(viewer) - viewer.w * a));
    planes.push_back({glm::dot(normal, middle - a) > 0 ? -normal : normal, a});
  }
  return planes;
}

}  // namespace

SightFrom parallel_sight(dvec3 towards_viewer) {
  return [towards_viewer](dvec3) { return Sight{towards_viewer, 1e300}; };
}

SightFrom central_sight(dvec3 eye) {
  return [eye](dvec3 point) { return Sight{eye - point, 1}; };
}

Wireframe::Wireframe(const Mesh& mesh)
    : mesh_(mesh), size_(bounds_of(mesh).radius()), convex_(is_convex(mesh, size_)) {
  std::set<std::pair<int, int>> known;
  for (const MeshFace& face : mesh.faces) {
    const auto corners = corners_of(mesh, face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (!known.insert(std::minmax(a.position, b.position)).second) continue;
      edges_.emplace_back(position_of(mesh, a), position_of(mesh, b));
    }
  }
}

bool Wireframe::hides(dvec3 point, const Sight& sight) const {
  const double least = 1e-6 * size_ / glm::length(sight.direction);
  for (const MeshFace& face : mesh_.faces) {
    const dvec3 normal = area_vector(mesh_, face);
    const double along = glm::dot(normal, sight.direction);
    if (along == 0) continue;
    const double t = glm::dot(normal, position_of(mesh_, corners_of(mesh_, face)[0]) - point) / along;
    if (t <= least || t >= sight.far) continue;
    if (inside(mesh_, face, normal, point + t * sight.direction)) return true;
  }
  return false;
}

std::vector<SightPiece> Wireframe::pieces_of_convex(dvec3 a, dvec3 b, const SightFrom& sight) const {
  const std::vector<ShadowPlane> shadow = shadow_of(mesh_, viewer_of(a, sight(a)));
  if (shadow.empty()) return {{0, 1, true}};  // seen from inside, nothing is seen
  double from = 0, to = 1;
  for (const ShadowPlane& plane : shadow) {
    const double margin = 1e-9 * size_;
    const double at_a = glm::dot(plane.normal, a - plane.at) + margin;
    const double at_b = glm::dot(plane.normal, b - plane.at) + margin;
    if (at_a >= 0 && at_b >= 0) return {{0, 1, false}};
    if (at_a >= 0) from = std::max(from, at_a / (at_a - at_b));
    if (at_b >= 0) to = std::min(to, at_a / (at_a - at_b));
  }
  // No sliver where an edge begins or ends at the border of the shadow
  constexpr double sliver = 1e-6;
  if (from < sliver) from = 0;
  if (to > 1 - sliver) to = 1;
  if (to - from < sliver) return {{0, 1, false}};
  std::vector<SightPiece> found;
  if (from > 0) found.push_back({0, from, false});
  found.push_back({from, to, true});
  if (to < 1) found.push_back({to, 1, false});
  return found;
}

std::vector<SightPiece> Wireframe::pieces(dvec3 a, dvec3 b, const SightFrom& sight) const {
  if (convex_) return pieces_of_convex(a, b, sight);
  constexpr int samples = 64;
  const auto hidden_at = [&](double t) {
    const dvec3 p = a + t * (b - a);
    return hides(p, sight(p));
  };
  std::vector<SightPiece> found{{0, 1, hidden_at(0.5 / samples)}};
  for (int i = 1; i < samples; ++i) {
    double before = (i - 0.5) / samples, after = (i + 0.5) / samples;
    const bool hidden = hidden_at(after);
    if (hidden == found.back().hidden) continue;
    for (int round = 0; round < 20; ++round) {
      const double middle = (before + after) / 2;
      (hidden_at(middle) == hidden ? after : before) = middle;
    }
    found.back().to = after;
    found.push_back({after, 1, hidden});
  }
  return found;
}

}  // namespace gradus
