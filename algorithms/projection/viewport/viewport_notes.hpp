#pragma once
// Exhibit: a report's rasterize, which moves what lies outside to the border, kept so that a figure can show
// what becomes of lines there. Never use it to draw; viewport.hpp reports what is outside.

#include <algorithm>

#include "projection/viewport/viewport.hpp"

namespace gradus::viewport {

/// Column and row are in the picture now, whether or not they were before.
struct Clamped {
  ivec2 nearest;  ///< the integers nearest to the place
  ivec2 pixel;    ///< the same, or on the border
};

/// The nearest integer by a named rounding, for any x; beyond +-2^30 it is +-2^30.
template <class T>
int rounded_anywhere(T x, Rounding rounding) {
  const T most = T(1 << 30);
  if (!(x < most)) return 1 << 30;
  return x < -most ? -(1 << 30) : rounded(x, rounding);
}

template <class T>
ivec2 integers(glm::vec<2, T> place, Rounding rounding) {
  return {rounded_anywhere(place.x, rounding), rounded_anywhere(place.y, rounding)};
}

/// FAULTY for every point outside, and for those in the last half pixel: rounds to the nearest integer and
/// moves column and row, each for itself, into the picture.
/// The report's rasterize (errata E000-09, E000-10).
///
/// map, point: as for rasterize. rule: half_even as the report's language has it.
///
/// Domain: right to half a pixel for points whose nearest integers are in the picture. With 640 x 480 pixels
///   for a plane of 2 x 1.5 the point (2, 1) comes out at (639, 0), where the line from the middle to it
///   never is: that leaves the picture in row 80.
/// Steps: Measured Placed Rounded Clamped.
/// Accuracy: none outside; inside half a pixel. The last column collects 3/2 pixels' points, column 0 half a
///   pixel's.
/// Cost: as rasterize.
/// Errors: none.
template <class T, Observer<Measured<T>, Placed<T>, Rounded<T>, Clamped> O = Unobserved>
ivec2 clamped(const Mapping<T>& map, glm::vec<2, T> point, Rounding rule, O&& observer = {}) {
  // How far across the window?
  auto part = fraction_of(map, point);
  if constexpr (observed<O>) observer(Measured<T>{point, part});
  // As far across the viewport
  auto place = place_at(map, part);
  if constexpr (observed<O>) observer(Placed<T>{part, place});
  // The nearest integers
  auto near = integers(place, rule);
  const bool there = map.has(near);
  if constexpr (observed<O>) observer(Rounded<T>{place, near, there});
  // Each for itself into the picture
  const ivec2 last = map.picture - 1;
  ivec2 pixel = min(near, last);
  pixel = max(pixel, ivec2(0));
  if constexpr (observed<O>) observer(Clamped{near, pixel});
  return pixel;
}

}  // namespace gradus::viewport
