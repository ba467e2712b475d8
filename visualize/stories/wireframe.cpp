#include "stories/wireframe.hpp"

#include <cmath>
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

}  // namespace

SightFrom parallel_sight(dvec3 towards_viewer) {
  return [towards_viewer](dvec3) { return Sight{towards_viewer, 1e300}; };
}

SightFrom central_sight(dvec3 eye) {
  return [eye](dvec3 point) { return Sight{eye - point, 1}; };
}

Wireframe::Wireframe(const Mesh& mesh) : mesh_(mesh), size_(bounds_of(mesh).radius()) {
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

std::vector<SightPiece> Wireframe::pieces(dvec3 a, dvec3 b, const SightFrom& sight) const {
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
