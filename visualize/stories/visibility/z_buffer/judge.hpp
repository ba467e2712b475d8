#pragma once
// Which face each pixel of a z-buffer's picture should show, by arithmetic that the z-buffer does not use.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "stories/visibility/z_buffer/subject.hpp"

namespace gradus::z_buffer {

/// What a picture shows at last: whose each pixel is.
using Owners = std::map<std::pair<int, int>, Id>;

/// The ray of sight through the centre of a pixel and a face's plane, in rationals, for faces as they stand
/// in space: no rounding of the code that is judged goes into it.
class Judge {
 public:
  Judge(const std::vector<dvec3>& ring, const Sight& sight) : sight_(sight) {
    // Newell's normal, and a corner of the ring
    for (int axis = 0; axis < 3; ++axis) {
      const int j = (axis + 1) % 3, k = (axis + 2) % 3;
      normal_[axis] = Exact{};
      for (const auto& [p, q] : sides_of(ring))
        normal_[axis] += Exact(p[j]) * Exact(q[k]) - Exact(p[k]) * Exact(q[j]);
    }
    const auto by_place = [](const dvec3& a, const dvec3& b) {
      return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    };
    const dvec3 corner = *std::ranges::min_element(ring, by_place);
    height_ = Exact{};
    for (int axis = 0; axis < 3; ++axis) height_ += normal_[axis] * Exact(corner[axis]);
  }

  /// How far along the ray; nothing where it never meets the plane.
  std::optional<Exact> distance(ivec2 pixel) const {
    const dvec2 at = dvec2(pixel) + 0.5;
    ExactVec3 from{Exact(at.x), Exact(at.y), Exact{}}, way{Exact{}, Exact{}, Exact(1)};
    if (sight_.eye) {
      const dvec3 eye = *sight_.eye;
      from = {Exact(eye.x), Exact(eye.y), Exact(eye.z)};
      way = {Exact(at.x) - from.x, Exact(at.y) - from.y, -from.z};
    }
    const auto along = [&](const ExactVec3& v) {
      return normal_.x * v.x + normal_.y * v.y + normal_.z * v.z;
    };
    const Exact rise = along(way);
    if (sign(rise) == 0) return std::nullopt;
    return (height_ - along(from)) / rise;
  }

 private:
  Sight sight_;
  ExactVec3 normal_;
  Exact height_;
};

/// What is right: of the faces that hold a pixel's centre the nearest, of equals the lowest.
inline Owners right_of(const Subject& subject) {
  const ExactScope scope;
  Owners shown;
  std::map<std::pair<int, int>, Exact> nearest;
  std::vector<Face> faces = subject.faces;
  std::ranges::sort(faces, {}, &Face::id);
  for (const Face& face : faces) {
    const Judge judge(subject.in_space[static_cast<std::size_t>(face.id.face)], subject.sight);
    const Outline outline(face, subject.picture());
    for (const ivec2 pixel : outline.pixels()) {
      const auto distance = judge.distance(pixel);
      if (!distance) continue;
      const std::pair at{pixel.x, pixel.y};
      const auto [there, is_new] = nearest.try_emplace(at, *distance);
      if (!is_new && !(*distance < there->second)) continue;
      there->second = *distance;
      shown[at] = face.id;
    }
  }
  return shown;
}

}  // namespace gradus::z_buffer
