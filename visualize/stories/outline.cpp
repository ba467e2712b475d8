#include "stories/outline.hpp"

#include <algorithm>

#include "core/arithmetic/exact.hpp"
#include "stories/hidden_lines.hpp"
#include "stories/paper.hpp"

namespace gradus {
namespace {

struct Edge {
  dvec2 a, b;
};

/// Whether a point of the line through an edge belongs to the edge.
bool is_between(const Edge& edge, dvec2 p) {
  return glm::all(glm::lessThanEqual(glm::min(edge.a, edge.b), p)) &&
         glm::all(glm::lessThanEqual(p, glm::max(edge.a, edge.b)));
}
bool touches(const Edge& edge, dvec2 p) { return orient2d(edge.a, edge.b, p) == 0 && is_between(edge, p); }
bool meet(const Edge& e, const Edge& f) {
  if (touches(e, f.a) || touches(e, f.b) || touches(f, e.a) || touches(f, e.b)) return true;
  return orient2d(e.a, e.b, f.a) != orient2d(e.a, e.b, f.b) &&
         orient2d(f.a, f.b, e.a) != orient2d(f.a, f.b, e.b);
}

}  // namespace

bool is_simple(std::span<const dvec2> corners) {
  const std::size_t size = corners.size();
  if (size < 3) return false;
  const auto edge = [&](std::size_t i) { return Edge{corners[i % size], corners[(i + 1) % size]}; };
  for (std::size_t i = 0; i < size; ++i) {
    if (edge(i).a == edge(i).b || touches(edge(i), edge(i + 1).b) || touches(edge(i + 1), edge(i).a))
      return false;
    for (std::size_t k = i + 2; k < size; ++k) {
      const bool neighbours = i == 0 && k + 1 == size;
      if (!neighbours && meet(edge(i), edge(k))) return false;
    }
  }
  return true;
}

bool is_flat(std::span<const dvec3> corners) {
  const dvec3 normal = unit_vector(area_vector(corners));
  double size = 0;
  for (const dvec3 p : corners) size = std::max(size, length_between(p, corners[0]));
  // What six decimals may do to two corners and to the plane, but of small faces no more than is seen
  const double thick = std::max(1e-9 * size, std::min(4e-6, 1e-3 * size));
  return std::ranges::all_of(corners,
                             [&](dvec3 p) { return std::abs(glm::dot(normal, p - corners[0])) <= thick; });
}

}  // namespace gradus
