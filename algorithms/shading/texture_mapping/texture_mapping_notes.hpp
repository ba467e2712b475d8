#pragma once
// An exhibit: texture coordinates as lecture notes interpolate them, kept so that a figure can show how the
// texture bends. Never use it in perspective; texture_mapping.hpp has the right one.

#include "shading/texture_mapping/texture_mapping.hpp"

namespace gradus::texture_mapping {

/// 1, u and v as planes over the picture.
template <class T>
Planes<T> affine_planes(const Triangle& triangle, const Corners<T>& corners) {
  const auto at = [](const Corner<T>& c) { return glm::vec<3, T>(T(1), c.uv.x, c.uv.y); };
  return {triangle, {at(corners[0]), at(corners[1]), at(corners[2])}};
}

/// FAULTY: interpolates u and v themselves linearly in the picture (errata E000-12), as if the triangle had
/// one depth. A straight line on the texture has a bend where two triangles meet, and the texture swims.
///
/// triangle, corners, window, plot: as for perspective_correct.
///
/// Domain: as for perspective_correct.
/// Steps: Mapped* Finished.
/// Accuracy: right only where all corners have the same w; else off by up to the whole texture.
/// Cost: a pixel one division less.
/// Errors: as for perspective_correct.
template <class T, class Plot, Observer<Mapped<T>, Finished> O = Unobserved>
void affine(const Triangle& triangle, const Corners<T>& corners, const Window& window, Plot&& plot,
            O&& observer = {}) {
  expect_corners(corners);
  auto planes =  // of 1, u and v
      affine_planes(triangle, corners);
  std::int64_t pixels = 0;
  const auto map = [&](ivec2 pixel, auto& e) {
    // u and v: not linear in the picture
    const auto linear = planes.at(e);
    const Uv<T> uv{linear.y, linear.z};
    if constexpr (observed<O>) observer(Mapped<T>{pixel, e, linear, uv});
    auto area =  // of the pixel
        footprint_of(planes, T(1), uv);
    plot(pixel, uv, area);
    ++pixels;
  };
  cover(triangle, window, map);
  if constexpr (observed<O>) observer(Finished{pixels});
}

}  // namespace gradus::texture_mapping
