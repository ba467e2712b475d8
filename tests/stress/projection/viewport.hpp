#pragma once
// Places and pixels by rationals: what the promises and the benchmark of viewport judge by.

#include <optional>

#include "core/arithmetic/exact_scalar.hpp"
#include "projection/viewport/viewport.hpp"

namespace gradus::stress {

/// Where a point lies in the picture that the map's window fills.
inline ExactVec2 exact_place(const viewport::Mapping<double>& map, dvec2 point) {
  const auto share = [](double from, double to, double at) {
    return (Exact(at) - Exact(from)) / (Exact(to) - Exact(from));
  };
  const auto& [lower, upper] = map.window;
  const Exact up = share(lower.y, upper.y, point.y);
  const Exact down = map.row_zero == viewport::RowZero::top ? Exact(1) - up : up;
  return {share(lower.x, upper.x, point.x) * Exact(map.picture.x), down * Exact(map.picture.y)};
}

/// The greatest integer that is not greater, or the nearest one. Domain: |x| < 2^62.
inline std::int64_t exactly_rounded(const Exact& x, viewport::Rounding rounding) {
  if (rounding == viewport::Rounding::floor) return floor(x);
  const std::int64_t up = floor(x + Exact(1, 2));
  const bool tie = Exact(up) == x + Exact(1, 2);
  return tie && rounding == viewport::Rounding::half_even && up % 2 != 0 ? up - 1 : up;
}

/// The pixel of a place, where the picture has both.
inline std::optional<ivec2> exact_pixel(const ExactVec2& place, ivec2 picture, viewport::Rounding rounding) {
  ivec2 pixel;
  for (int k = 0; k < 2; ++k) {
    if (place[k] < Exact(0) || place[k] >= Exact(picture[k])) return std::nullopt;
    pixel[k] = static_cast<int>(exactly_rounded(place[k], rounding));
    if (pixel[k] >= picture[k]) return std::nullopt;
  }
  return pixel;
}

}  // namespace gradus::stress
