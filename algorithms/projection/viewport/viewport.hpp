#pragma once
// From a window on the camera plane to a picture's pixels, and back.
//
// A place in the picture is continuous: (0, 0) is the outer corner of pixel (0, 0), whose centre is
// (1/2, 1/2), and the pixel that a place belongs to is floor(place) (docs/conventions.md). A point whose
// place is outside is reported as such; nothing is moved to the border.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/arithmetic/finite.hpp"
#include "core/arithmetic/rounding.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::viewport {

// --- What a mapping is made of -----------------------------------

/// Where row 0 is, and so which way rows are counted.
enum class RowZero : std::uint8_t {
  top,     ///< as in every picture file: y is turned round
  bottom,  ///< as on paper: y keeps its direction
};

/// How a place between pixels becomes a pixel.
enum class Rounding : std::uint8_t {
  floor,      ///< the pixel that the place lies in
  half_up,    ///< the nearest integer, midway the greater: right where integers are pixel centres
  half_even,  ///< the nearest integer, midway the even one (round() in Python and NumPy)
};

/// Takes the window on the camera plane to the viewport in a picture.
template <class T>
struct Mapping {
  Rectangle<T> window;    ///< what is seen, on the camera plane
  Rectangle<T> viewport;  ///< where it comes to lie, in pixels
  ivec2 picture;          ///< width and height in pixels
  RowZero row_zero = RowZero::top;

  /// Whether the picture has this pixel.
  bool has(ivec2 pixel) const {
    return 0 <= pixel.x && pixel.x < picture.x && 0 <= pixel.y && pixel.y < picture.y;
  }
};

/// Pixels per side of the largest picture: 2^30.
inline constexpr int most_pixels = 1 << 30;

template <class T>
void expect_sizes(const Rectangle<T>& window, ivec2 picture) {
  expects(picture.x >= 1 && picture.y >= 1, "a picture has at least one pixel, not {} x {}", picture.x,
          picture.y);
  expects(picture.x <= most_pixels && picture.y <= most_pixels, "a picture has at most {} rows and columns",
          most_pixels);
  expects(window.lower.x < window.upper.x && window.lower.y < window.upper.y,
          "a window's lower corner lies below and left of its upper corner");
  expects(all_finite(window.size().x, window.size().y),
          "a window has a finite size: its corners are too far apart");
}

/// The window fills the whole picture: as taught. Where their shapes differ, x and y are scaled differently
/// and circles become ellipses.
///
/// window: on the camera plane. picture: width and height in pixels.
///
/// Domain: lower < upper, width and height from 1 to 2^30; the window's size doesn't overflow.
/// Cost: none.
/// Errors: ContractViolation for an empty window or picture, and for a window without a finite size.
template <class T = double>
Mapping<T> stretched(const Rectangle<T>& window, ivec2 picture, RowZero row_zero = RowZero::top) {
  expect_sizes(window, picture);
  return {window, {{T(0), T(0)}, {T(picture.x), T(picture.y)}}, picture, row_zero};
}

/// The window fills as much of the picture as it can without changing its shape, and stands in the middle;
/// two bars of the picture stay empty. A circle stays one.
///
/// Domain: as stretched, and height / width of the window is a normal number of T.
/// Accuracy: the viewport's corners are within 2 ulp of the picture's width or height.
/// Cost: four multiplications, two divisions.
/// Errors: as stretched.
template <class T = double>
Mapping<T> letterboxed(const Rectangle<T>& window, ivec2 picture, RowZero row_zero = RowZero::top) {
  expect_sizes(window, picture);
  const T width = T(picture.x), height = T(picture.y);
  const auto size = window.size();
  // The side on which the window has less room to spare sets the scale of both
  const bool wide = size.x / size.y > width / height;
  const T used_width = wide ? width : height * (size.x / size.y);
  const T used_height = wide ? width * (size.y / size.x) : height;
  const glm::vec<2, T> margin{(width - used_width) / T(2), (height - used_height) / T(2)};
  return {window, {margin, {width - margin.x, height - margin.y}}, picture, row_zero};
}

// --- Steps -------------------------------------------------------

/// It is known how far across the window the point lies.
template <class T>
struct Measured {
  glm::vec<2, T> point;     ///< on the camera plane
  glm::vec<2, T> fraction;  ///< 0 .. 1 from column 0 and from row 0 on, for what lies in the window
};

/// The point has its place in the picture.
template <class T>
struct Placed {
  glm::vec<2, T> fraction;
  glm::vec<2, T> place;  ///< in pixels, continuous
};

/// The place is not in the viewport: nothing is drawn.
template <class T>
struct Outside {
  glm::vec<2, T> place;
};

/// The place has its pixel.
template <class T>
struct Rounded {
  glm::vec<2, T> place;
  ivec2 pixel;  ///< column, row
  bool there;   ///< the picture has it; by floor it always does
};

/// A point stands in the picture (to_pixel).
template <class T>
struct Mapped {
  glm::vec<2, T> ndc;
  glm::vec<2, T> pixel;
};

// --- Plane to picture --------------------------------------------

/// How far across the window a point lies: (0, 0) at the corner of column 0 and row 0, (1, 1) at the opposite
/// corner, exactly there.
template <class T>
glm::vec<2, T> fraction_of(const Mapping<T>& map, glm::vec<2, T> point) {
  const Rectangle<T>& window = map.window;
  const auto size = window.size();
  const T x = (point.x - window.lower.x) / size.x;
  if (map.row_zero == RowZero::bottom) return {x, (point.y - window.lower.y) / size.y};
  return {x, (window.upper.y - point.y) / size.y};
}

/// The place that lies so far across the viewport: its corners exactly at 0 and 1.
template <class T>
glm::vec<2, T> place_at(const Rectangle<T>& viewport, glm::vec<2, T> fraction) {
  const auto along = [](T a, T b, T t) { return (T(1) - t) * a + t * b; };
  return {along(viewport.lower.x, viewport.upper.x, fraction.x),
          along(viewport.lower.y, viewport.upper.y, fraction.y)};
}

/// The same in the viewport of a mapping.
template <class T>
glm::vec<2, T> place_at(const Mapping<T>& map, glm::vec<2, T> fraction) {
  return place_at(map.viewport, fraction);
}

/// Whether a place lies in the viewport, its lower sides included, its upper ones not: so that viewports side
/// by side share no place. False for what is not a number.
template <class T>
bool holds(const Rectangle<T>& viewport, glm::vec<2, T> place) {
  return viewport.lower.x <= place.x && place.x < viewport.upper.x && viewport.lower.y <= place.y &&
         place.y < viewport.upper.y;
}

/// The largest integer up to x. Domain: |x| < 2^31 - 1.
template <class T>
int floor_of(T x) {
  using std::floor;
  return static_cast<int>(floor(x));
}

/// A coordinate as an integer, by each of the named roundings; exact: the fraction is compared, never added
/// to. Domain: |x| < 2^31 - 1.
template <class T>
int by_floor(T x) {
  // The pixel that it lies in
  return floor_of(x);
}
template <class T>
int by_half_up(T x) {
  const T half = T(1) / T(2);
  const int below = floor_of(x);
  const T fraction = x - T(below);
  // Midway: the larger one
  const bool up = fraction >= half;
  return below + up;
}
template <class T>
int by_half_even(T x) {
  const T half = T(1) / T(2);
  const int below = floor_of(x);
  const T fraction = x - T(below);
  // Midway: the even one
  bool up = fraction > half;
  if (fraction == half) {
    up = below % 2 != 0;
  }
  return below + up;
}

template <class T>
int rounded(T x, Rounding rounding) {
  switch (rounding) {
    case Rounding::floor:
      return by_floor(x);
    case Rounding::half_up:
      return by_half_up(x);
    default:
      return by_half_even(x);
  }
}

template <class T>
ivec2 rounded(glm::vec<2, T> place, Rounding rounding) {
  return {rounded(place.x, rounding), rounded(place.y, rounding)};
}

/// The pixel of a point on the camera plane, or nothing where the point is outside: the window-to-viewport
/// transformation (Foley, van Dam, Feiner, Hughes, Computer graphics: principles and practice, 1990, section
/// 5.4), then a rounding by name.
///
/// T: float, double or Exact. map: from stretched or letterboxed. point: any.
/// rule: floor gives the pixel that the place lies in. The two others name the nearest corner of pixels:
///   up to half a pixel away, column and row 0 get half a pixel's points and the last half pixel none, for
///   there is no pixel `width`.
///
/// Domain: everything; what is not finite is outside.
/// Steps: Measured Placed (Rounded | Outside).
/// Accuracy: in a stretched picture the place is within 5/2 ulp of the exact one, counted in ulp of width or
///   height; corners of the window are exact. So a point may get a neighbouring pixel only when it lies
///   that near to their common side. Exact: exact.
/// Cost: two divisions, four multiplications.
/// Errors: none.
template <class T, Observer<Measured<T>, Placed<T>, Outside<T>, Rounded<T>> O = Unobserved>
std::optional<ivec2> rasterize(const Mapping<T>& map, glm::vec<2, T> point, Rounding rule = Rounding::floor,
                               O&& observer = {}) {
  // How far across the window?
  auto t = fraction_of(map, point);
  if constexpr (observed<O>) observer(Measured<T>{point, t});
  // As far across the viewport
  auto place = place_at(map, t);
  if constexpr (observed<O>) observer(Placed<T>{t, place});
  // Outside: say so, move nothing
  if (!holds(map.viewport, place)) {
    if constexpr (observed<O>) observer(Outside<T>{place});
    return std::nullopt;
  }
  // The pixel, unless there is none
  auto pixel = rounded(place, rule);
  const bool there = map.has(pixel);
  if constexpr (observed<O>) observer(Rounded<T>{place, pixel, there});
  if (!there) return std::nullopt;
  return pixel;
}

/// The continuous place in the picture of what stands in [-1, 1] x [-1, 1], row 0 at the top: (-1, 1) is the
/// upper left corner (0, 0) of the upper left pixel, (1, -1) the lower right corner (width, height) of the
/// last one. Pixel (c, r) covers [c, c + 1) x [r, r + 1). The place of rasterize for that window, unrounded:
/// what comes after clipping, where nothing is outside.
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

// --- Picture to plane --------------------------------------------

/// The point of the camera plane that has this place: the inverse of what rasterize does before it rounds.
///
/// T: float, double or Exact. place: continuous, in pixels, also outside the picture.
///
/// Domain: finite; the viewport is at least a pixel wide and high, which letterboxes may not be.
/// Accuracy: for places in the viewport, there and back is within 4 ulp of the window's largest coordinate,
///   times picture / viewport where a letterbox leaves bars. Exact: exact.
/// Cost: two divisions, four multiplications.
/// Errors: none.
template <class T>
glm::vec<2, T> to_plane(const Mapping<T>& map, glm::vec<2, T> place) {
  const auto size = map.viewport.size();
  const T x = (place.x - map.viewport.lower.x) / size.x;
  const T y = (place.y - map.viewport.lower.y) / size.y;
  const bool up = map.row_zero == RowZero::bottom;
  return place_at(map.window, glm::vec<2, T>{x, up ? y : T(1) - y});
}

/// The point of the camera plane at the centre of a pixel, where a picture is sampled.
///
/// pixel: any, also outside the picture.
///
/// Domain: |column|, |row| < 2^22 for float.
/// Accuracy: as to_plane. In a stretched picture the point's own pixel, by floor, is this one where a pixel
///   measures at least 9 ulp of the window's largest coordinate on either axis. Of narrower ones some may
///   hold no point at all: 1,920 columns from 1e9 to 1e9 + 1e-4 share 840 doubles.
/// Cost: as to_plane.
/// Errors: none.
template <class T>
glm::vec<2, T> pixel_centre(const Mapping<T>& map, ivec2 pixel) {
  const T half = T(1) / T(2);
  return to_plane(map, glm::vec<2, T>{T(pixel.x) + half, T(pixel.y) + half});
}

}  // namespace gradus::viewport
