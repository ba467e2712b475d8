#pragma once
// The normal at a vertex of a mesh, from those of the faces that meet there: an estimate of the normal that
// the surface had before it was cut into faces.

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <map>
#include <ranges>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"

namespace gradus::polygon_shading {

/// How much the normal of a face counts at one of its corners.
enum class Weighting {
  plain,  ///< as much as any other: the more faces a side is cut into, the more it counts
  area,   ///< by its area
  angle,  ///< by the angle it has at this corner: however it is cut, the angles add up to the same
};

/// A face's normal was added at one of its corners.
template <class T>
struct NormalAdded {
  std::size_t face, vertex;
  glm::vec<3, T> normal;  ///< of the face, of length 1
  T weight;
};

/// All that meet at a vertex were added.
template <class T>
struct VertexDone {
  std::size_t vertex;
  glm::vec<3, T> sum;
  glm::vec<3, T> normal;  ///< of length 1; zero where there was nothing to add, or it cancels
};

/// Numbers the faces: what is told of one comes with the number of its corner, from 0 on. Keeps the sums.
template <class T>
struct FacesTaken {
  std::size_t count = 0;
  std::map<std::size_t, glm::vec<3, T>> sums{};

  NormalAdded<T> operator()(NormalAdded<T> step) {
    const bool first = step.face == 0;
    count += first;
    step.face = count - 1;
    sums.try_emplace(step.vertex, T(0)).first->second += step.weight * step.normal;
    return step;
  }
  VertexDone<T> operator()(VertexDone<T> step) const {
    const auto sum = sums.find(step.vertex);
    step.sum = sum == sums.end() ? glm::vec<3, T>(T(0)) : sum->second;
    return step;
  }
};

/// Where nothing has been added yet.
template <class T>
inline constexpr glm::vec<3, T> nothing{T(0)};

/// The number of one of them.
template <class T>
std::size_t index_in(std::span<T> all, const T& one) {
  return static_cast<std::size_t>(&one - all.data());
}

/// The number of the vertex at the k-th corner of a face.
template <class Face>
std::size_t vertex(const Face& face, std::size_t k) {
  return static_cast<std::size_t>(face[k]);
}

/// 0, 1 … for the corners of a face.
template <class Face>
auto corners(const Face& face) {
  return std::views::iota(std::size_t{0}, static_cast<std::size_t>(std::ranges::size(face)));
}

/// The sum of cross products that is normal to a face and as long as twice its area (Newell).
template <class T, class Face>
glm::vec<3, T> doubled_area(std::span<const glm::vec<3, T>> places, const Face& face) {
  const auto at = [&](auto corner) { return places[static_cast<std::size_t>(corner)]; };
  const auto origin = at(*std::ranges::begin(face));
  glm::vec<3, T> sum{T(0)}, before{T(0)};
  for (const auto corner : face) {
    const auto way = at(corner) - origin;
    sum += glm::cross(before, way);
    before = way;
  }
  return sum;
}

/// The angle between two ways, in [0, pi].
template <class T>
T angle_between(glm::vec<3, T> a, glm::vec<3, T> b) {
  return gradus::atan2(length_of(glm::cross(a, b)), glm::dot(a, b));
}

/// How much a face counts at its k-th corner.
template <class T, class Face>
T weight(std::span<const glm::vec<3, T>> places, const Face& face, std::size_t k, Weighting how) {
  if (how == Weighting::plain) return T(1);
  if (how == Weighting::area) return length_of(doubled_area(places, face)) / T(2);
  const std::size_t n = std::ranges::size(face);
  const auto at = [&](std::size_t i) { return places[vertex(face, i % n)]; };
  return angle_between(at(k + 1) - at(k), at(k + n - 1) - at(k));
}

/// The normals at the vertices of a mesh: for each the sum of the normals of the faces that meet there, each
/// as its weight says, brought to length 1. Source: H. Gouraud, 1971 (plain); G. Thürmer, C. Wüthrich,
/// Computing vertex normals from polygonal facets, J. Graphics Tools 3 (1), 1998 (angle).
///
/// P: the places of the vertices. faces: a range of ranges of numbers of vertices, counter-clockwise seen
/// from
///   outside, at least 3 each, each range random access. N: the normals, the caller's, as long as P.
///
/// Domain: finite places, sizes whose squares neither overflow nor underflow. A face without area adds
/// nothing. Steps: NormalAdded for every corner of every face, then VertexDone for every vertex. Accuracy:
/// within 8 (k + 2) u of the exact sum's direction, k the faces that meet there, where the sum does
///   not cancel: beside the errors of the faces' own normals.
/// Cost: a normal per face and a weight per corner: an arc tangent with angles, a cross product per corner
///   with areas.
/// Errors: ContractViolation where the lengths of P and N differ.
template <class T, class Faces, Observer<NormalAdded<T>, VertexDone<T>> O = Unobserved>
void vertex_normals(std::span<const glm::vec<3, T>> P, const Faces& faces, Weighting how,
                    std::span<glm::vec<3, T>> N, O&& observer = {}) {
  expects(N.size() == P.size(), "{} normals were expected, not {}", P.size(), N.size());
  Tally<O, FacesTaken<T>> tally(observer);
  std::ranges::fill(N, nothing<T>);
  for (const auto& face : faces) {
    auto A = doubled_area(P, face);
    const auto n = unit_vector(A);
    for (auto k : corners(face)) {
      // Added at its k-th corner
      T w = weight(P, face, k, how);
      auto v = vertex(face, k);
      N[v] += w * n;
      if constexpr (observed<O>) observer(tally.count(NormalAdded<T>{k, v, n, w}));
    }
  }
  for (auto& normal : N) {
    normal = unit_vector(normal);
    if constexpr (observed<O>) observer(tally.count(VertexDone<T>{index_in(N, normal), {}, normal}));
  }
}

}  // namespace gradus::polygon_shading
