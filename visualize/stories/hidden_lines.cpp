#include "stories/hidden_lines.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "modeling/ear_clipping/ear_clipping.hpp"

namespace gradus {
namespace {

/// A corner on an edge, but for its rounding, counts as convex.
bool is_convex(const std::vector<dvec3>& ring, dvec3 normal) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const dvec3 a = ring[i], b = ring[(i + 1) % n], c = ring[(i + 2) % n];
    if (glm::dot(normal, glm::cross(b - a, c - b)) < -1e-12 * glm::dot(normal, normal)) return false;
  }
  return true;
}

/// Intervals that meet become one.
std::vector<std::pair<double, double>> joined(std::vector<std::pair<double, double>> spans) {
  constexpr double touching = 1e-6;
  std::ranges::sort(spans);
  std::vector<std::pair<double, double>> all;
  for (const auto& [from, to] : spans) {
    if (!all.empty() && from <= all.back().second + touching) {
      all.back().second = std::max(all.back().second, to);
    } else {
      all.emplace_back(from, to);
    }
  }
  return all;
}

}  // namespace

dvec3 area_vector(std::span<const dvec3> ring) {
  dvec3 area{0};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    area += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return area;
}

std::vector<std::vector<dvec3>> convex_parts(const std::vector<dvec3>& ring) {
  if (is_convex(ring, area_vector(ring))) return {ring};
  return triangles_of(ring);
}

std::vector<std::vector<dvec3>> triangles_of(const std::vector<dvec3>& ring) {
  std::vector<std::vector<dvec3>> parts;
  ear_clipping::triangulate(ring, [&](const ear_clipping::Triangle& triangle) {
    const auto corner = [&](std::size_t i) { return ring[static_cast<std::size_t>(triangle[i])]; };
    parts.push_back({corner(0), corner(1), corner(2)});
  });
  return parts;
}

HiddenLines::HiddenLines(std::span<const std::vector<dvec3>> faces, const Viewer& viewer, double size)
    : margin_(1e-9 * size) {
  for (const auto& face : faces) {
    for (const auto& part : convex_parts(face)) add_shadow(part, viewer);
  }
}

void HiddenLines::add_shadow(const std::vector<dvec3>& part, const Viewer& viewer) {
  const dvec3 area = area_vector(part);
  const double doubled = glm::length(area);
  if (!(doubled > margin_ * margin_)) return;
  dvec3 normal = area / doubled;
  const double facing = glm::dot(normal, towards(viewer, part[0]));
  // Seen edge-on it hides nothing
  if (std::abs(facing) <= 1e-9 * glm::length(towards(viewer, part[0]))) return;
  const double turn = facing > 0 ? 1 : -1;
  Shadow shadow{{turn * normal, part[0]}};
  for (std::size_t i = 0; i < part.size(); ++i) {
    const dvec3 a = part[i], b = part[(i + 1) % part.size()];
    const dvec3 aside = glm::cross(b - a, towards(viewer, a));
    const double length = glm::length(aside);
    if (!(length > 0)) continue;  // an edge of no length, or along the sight
    shadow.push_back({turn / length * aside, a});
  }
  shadows_.push_back(std::move(shadow));
}

std::vector<SightPiece> HiddenLines::pieces(dvec3 a, dvec3 b) const {
  constexpr double sliver = 1e-6;
  std::vector<std::pair<double, double>> spans;
  for (const Shadow& shadow : shadows_) {
    double from = 0, to = 1;
    for (const auto& [normal, at] : shadow) {
      const double at_a = glm::dot(normal, a - at) + margin_, at_b = glm::dot(normal, b - at) + margin_;
      if (at_a >= 0 && at_b >= 0) to = -1;
      if (at_a >= 0 && at_b < 0) from = std::max(from, at_a / (at_a - at_b));
      if (at_a < 0 && at_b >= 0) to = std::min(to, at_a / (at_a - at_b));
      if (to <= from) break;
    }
    if (to - from > sliver) spans.emplace_back(from, to);
  }
  std::vector<SightPiece> found;
  double reached = 0;
  for (const auto& [from, to] : joined(std::move(spans))) {
    if (from - reached > sliver) found.push_back({reached, from, false});
    found.push_back({found.empty() ? 0 : from, to, true});
    reached = to;
  }
  if (1 - reached > sliver) found.push_back({reached, 1, false});
  found.back().to = 1;
  return found;
}

}  // namespace gradus
