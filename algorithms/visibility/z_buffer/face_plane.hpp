#pragma once
// Faces in the picture, and how deep they are: the depth depends on a face's plane and on the pixel alone.

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/two_doubles.hpp"
#include "core/geometry.hpp"

namespace gradus::z_buffer {

/// Who a face is. Of faces at equal depth the one of the lowest (object, face) is seen.
struct Id {
  int object = 0, face = 0;
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

/// A plane convex polygon on the screen: x to the right and y down in pixels, z away from the viewer, who
/// looks along +z with parallel rays. Pixel (i, j) has its centre at (i + 0.5, j + 0.5).
struct Face {
  std::span<const dvec3> corners;  ///< at least three, in order, in either direction
  Id id;
  /// The corners of a face in the same plane that give it. Faces that share them are as deep as one another
  /// where rounding has moved corners beside the plane, as that of a projection does. None: the face's own.
  std::span<const dvec3> plane{};
};

/// The depth of a face over the screen: z = corner.z + right (x - corner.x) + down (y - corner.y).
struct Plane {
  std::span<const dvec3> ring;    ///< the corners that give it, which outlive it
  dvec3 corner;                   ///< the first of them by x, then y, then z
  double right, down;             ///< by how much z grows a pixel
  Rounded right_pair, down_pair;  ///< the same to some 100 bits
  double doubt;                   ///< by how much these may be off
  double nearest, farthest;       ///< of the corners' depths

  /// The depth at the centre of a pixel. Faces in one plane have the same, whichever corner comes first and
  /// whichever way round they run.
  /// Accuracy: the nearest double. A face narrower than 1/512 pixel, which snapping may let cover a centre
  ///   far outside it, keeps to the range of its corners' depths.
  /// Cost: some 30 ns; where 100 bits leave open which double is the nearest, some 10 us.
  double at(ivec2 pixel) const;
};

namespace detail {

/// Adds the components of Newell's normal, each times a factor: the sum of p x q over the edges from p to q,
/// multiplied out, so that no difference is rounded.
template <int Factors, class... Factor>
void add_normal(SumOfProducts<Factors>& sum, std::span<const dvec3> ring, int axis, Factor... factor) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 &p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
    sum.add(p[j], q[k], factor...);
    sum.subtract(p[k], q[j], factor...);
  }
}

/// The nearest double to the depth of a ring's plane at a place.
/// Domain: not seen edge on.
inline double exact_depth(std::span<const dvec3> ring, const dvec3& corner, dvec2 place) {
  SumOfProducts<3> numerator;
  for (int axis = 0; axis < 3; ++axis) add_normal(numerator, ring, axis, corner[axis]);
  for (int axis = 0; axis < 2; ++axis) add_normal(numerator, ring, axis, -place[axis]);
  SumOfProducts<2> denominator;
  add_normal(denominator, ring, 2);
  return rounded_quotient(numerator, denominator) + 0.0;  // a zero is +0
}

/// A component of Newell's normal, to some 100 bits of the products that it is the sum of.
struct NormalPart {
  Rounded sum{0, 0};
  double size = 0;  ///< of the products
};
inline NormalPart normal_part(std::span<const dvec3> ring, const dvec3& corner, int axis) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  NormalPart part;
  const auto from_corner = [&](const dvec3& p, int i) { return two_difference(p[i], corner[i]); };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec3 &p = ring[i], &q = ring[i + 1 < ring.size() ? i + 1 : 0];
    const Rounded a = product_of_pairs(from_corner(p, j), from_corner(q, k)),
                  b = product_of_pairs(from_corner(p, k), from_corner(q, j));
    part.sum = sum_of_pairs(part.sum, sum_of_pairs(a, negated(b)));
    part.size += std::abs(a.value) + std::abs(b.value);
  }
  return part;
}

/// What pairs may lose, as a share: of sums of up to 2^10 products, with room to spare.
inline constexpr double lost = 0x1p-88;

}  // namespace detail

inline double Plane::at(ivec2 pixel) const {
  const dvec2 place = dvec2(pixel) + 0.5;
  const Rounded x = two_difference(place.x, corner.x), y = two_difference(place.y, corner.y);
  const Rounded along = product_of_pairs(right_pair, x), below = product_of_pairs(down_pair, y);
  const Rounded z = sum_of_pairs({corner.z, 0}, sum_of_pairs(along, below));
  const double far = std::abs(x.value) + std::abs(y.value);
  const double off = 2 * doubt * far +
                     detail::lost * (std::abs(corner.z) + std::abs(along.value) + std::abs(below.value)) +
                     0x1p-900;
  // Whatever the error is, it rounds to the same double?
  const bool sure = z.value + (z.error - off) == z.value && z.value + (z.error + off) == z.value;
  const double depth = sure ? z.value + 0.0 : detail::exact_depth(ring, corner, place);
  const bool is_thin = (std::abs(right) + std::abs(down)) / 512 > farthest - nearest;
  return is_thin ? std::clamp(depth, nearest, farthest) : depth;
}

/// The plane of a face by Newell's normal; nothing for a face that is seen edge on.
/// Accuracy: exact, but for the rounding of `right` and `down`; whether it is edge on is decided exactly.
inline std::optional<Plane> plane_of(const Face& face) {
  const auto& c = face.plane.empty() ? face.corners : face.plane;
  SumOfProducts<2> height;
  detail::add_normal(height, c, 2);
  if (height.sign() == 0) return {};
  const auto by_place = [](const dvec3& a, const dvec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  const dvec3 corner = *std::ranges::min_element(c, by_place);
  const auto by_depth = [](const dvec3& a, const dvec3& b) { return a.z < b.z; };
  const auto [near, far] = std::ranges::minmax_element(c, by_depth);
  const auto x = detail::normal_part(c, corner, 0), y = detail::normal_part(c, corner, 1),
             z = detail::normal_part(c, corner, 2);
  const Rounded right = negated(quotient_of_pairs(x.sum, z.sum)),
                down = negated(quotient_of_pairs(y.sum, z.sum));
  // Of a normal that has lost its digits nothing is sure: no number, which no comparison is true of
  const double of_z = detail::lost * z.size + 0x1p-900, slopes = std::abs(right.value) + std::abs(down.value);
  const bool known = 2 * of_z < std::abs(z.sum.value);
  const double doubt =
      (detail::lost * (x.size + y.size) + slopes * of_z) / std::abs(z.sum.value) + detail::lost * slopes;
  return Plane{
      c,       corner, right.value + 0.0, down.value + 0.0, right, down, known ? 2 * doubt : std::nan(""),
      near->z, far->z};
}

}  // namespace gradus::z_buffer
