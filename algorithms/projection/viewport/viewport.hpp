#pragma once
// From the square [-1, 1] x [-1, 1] with y up to a picture's pixels with row 0 at the top.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::viewport {

/// A point stands in the picture.
template <class T>
struct Mapped {
  glm::vec<2, T> ndc;
  glm::vec<2, T> pixel;
};

/// The continuous place in the picture: (-1, 1) is the upper left corner (0, 0) of the upper left pixel, (1,
/// -1) the lower right corner (width, height) of the last one. Pixel (c, r) covers [c, c + 1) x [r, r + 1).
///
/// width, height: of the picture in pixels. ndc: any point, also outside the picture.
///
/// Domain: width, height >= 1.
/// Steps: Mapped.
/// Accuracy: 3 roundings, at most 2 ulp of the width or the height for what lies in the picture.
/// Cost: two multiplications, two divisions by 2, two additions.
/// Errors: ContractViolation for an empty picture.
template <class T, Observer<Mapped<T>> O = Unobserved>
glm::vec<2, T> to_pixel(glm::vec<2, T> ndc, int width, int height, O&& observer = {}) {
  expects(width >= 1 && height >= 1, "a picture has at least one pixel, not {} x {}", width, height);
  const T half_width = T(width) / T(2);
  const T half_height = T(height) / T(2);
  const T x = (T(1) + ndc.x) * half_width;
  const T y = (T(1) - ndc.y) * half_height;
  const glm::vec<2, T> pixel{x, y};
  if constexpr (observed<O>) observer(Mapped<T>{ndc, pixel});
  return pixel;
}

}  // namespace gradus::viewport
