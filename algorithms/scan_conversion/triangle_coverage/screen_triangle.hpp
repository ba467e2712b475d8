#pragma once
// Triangles in the picture, and how deep they are at its places.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::triangle_coverage {

/// A value that is linear in the picture, such as the depth after division: given at the corners, it comes
/// out the same to the last bit however the corners are numbered, so that a triangle drawn twice has the same
/// depths.
class Linear {
 public:
  /// values: at the corners of the triangle, finite.
  constexpr Linear(const Triangle& triangle, const dvec3& values) {
    const auto before = [&](int i, int j) {
      const ivec2 p = triangle[static_cast<std::size_t>(i)], q = triangle[static_cast<std::size_t>(j)];
      return p.y < q.y || (p.y == q.y && p.x < q.x);
    };
    // From the topmost corner on, the leftmost of two, in one direction
    first_ = before(1, 0) ? (before(2, 1) ? 2 : 1) : (before(2, 0) ? 2 : 0);
    second_ = (first_ + 1) % 3;
    third_ = (first_ + 2) % 3;
    if (doubled_area(triangle) < 0) std::swap(second_, third_);
    value_ = values[first_];
    to_second_ = values[second_] - value_;
    to_third_ = values[third_] - value_;
  }

  /// The value at the centre with these weights from cover. Accuracy: 6 ulp of the largest corner value;
  /// exact where all three are equal.
  constexpr double at(const Weights& weights) const {
    const double sum = static_cast<double>(weights[0] + weights[1] + weights[2]);
    const double second = static_cast<double>(weights[static_cast<std::size_t>(second_)]) / sum;
    const double third = static_cast<double>(weights[static_cast<std::size_t>(third_)]) / sum;
    return value_ + (second * to_second_ + third * to_third_);
  }

 private:
  int first_ = 0, second_ = 1, third_ = 2;
  double value_ = 0, to_second_ = 0, to_third_ = 0;
};

/// The depth over the picture of a plane in which several triangles lie: that of a place is the same for all
/// of them, to the bit.
struct DepthPlane {
  dvec2 from{0};               ///< a place in the picture, in 1/256 pixel
  double depth = 0;            ///< there
  double right = 0, down = 0;  ///< what 1/256 pixel adds

  constexpr double at(ivec2 place) const {
    return depth + (right * (place.x - from.x) + down * (place.y - from.y));
  }
};

/// A triangle in the picture: where its corners are on the grid, and how deep. Depth after division is linear
/// in the picture; smaller is nearer.
struct ScreenTriangle {
  Triangle corners;
  dvec3 depth{0};
  std::optional<DepthPlane> plane{};  ///< that it shares with others, instead of the depths of its corners
};

/// The plane that a triangle shares, where it tells its depths: not where the triangle is so thin that
/// snapping, which moves it by up to 1/512 pixel, takes it farther in depth than it reaches itself.
/// corners: their depths.
constexpr std::optional<DepthPlane> told_by(const std::optional<DepthPlane>& plane, const dvec3& corners) {
  if (!plane) return {};
  const auto size = [](double x) { return x < 0 ? -x : x; };
  const auto [least, most] = std::minmax({corners.x, corners.y, corners.z});
  const bool is_thin = !((size(plane->right) + size(plane->down)) / 2 <= most - least + 0x1p-40);
  return is_thin ? std::nullopt : plane;
}

/// How deep a triangle is at a place of the picture.
class Depth {
 public:
  /// A shared plane keeps to the depths of the triangle's corners within this much, which is more than what
  /// rounding does to it.
  static constexpr double slack = 0x1p-40;

  explicit constexpr Depth(const ScreenTriangle& triangle)
      : own_(triangle.corners, triangle.depth), plane_(triangle.plane) {
    const auto [least, most] = std::minmax({triangle.depth.x, triangle.depth.y, triangle.depth.z});
    least_ = least - slack, most_ = most + slack;
  }

  /// weights: of the triangle there. Accuracy: as of Linear, or of the shared plane.
  constexpr double at(ivec2 place, const Weights& weights) const {
    return plane_ ? std::clamp(plane_->at(place), least_, most_) : own_.at(weights);
  }

 private:
  Linear own_;
  std::optional<DepthPlane> plane_;
  double least_ = 0, most_ = 0;
};

}  // namespace gradus::triangle_coverage
