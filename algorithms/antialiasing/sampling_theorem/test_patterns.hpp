#pragma once
// Patterns that show what too few samples do to a picture, each as a function of the place: jagged edges,
// lost detail, fragments, moiré. Places are in pixels: pixel (c, r) covers [c, c+1) x [r, r+1), row 0 at the
// top. Values are from 0, black, to 1, white.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::sampling_theorem {

/// Half a cycle from 1, white, to 0, black, for each whole x.
inline double wave(double x) { return 0.5 + 0.5 * sin_cos_half_turns(x).cos; }
inline bool is_even(double whole) { return std::remainder(whole, 2) == 0; }

/// Rings that grow finer outwards: at the distance r from the centre there are r / distance cycles per pixel.
/// At r = distance/2 they pass half the rate of one sample per pixel; `distance` pixels from the centre,
/// along both axes, samples show centres that are not there. Source: Fresnel 1816 (the plate); for test
/// pictures, Drewery 1979, BBC Research 1979/23.
struct ZonePlate {
  dvec2 centre;
  double distance;  ///< above 0

  double operator()(dvec2 p) const { return rings(p); }
  double rings(dvec2 p) const {
    const dvec2 r = p - centre;
    auto r2 = r.x * r.x + r.y * r.y;
    return wave(r2 / distance);
  }
  /// Cycles per pixel at p, straight away from the centre.
  double frequency(dvec2 p) const {
    const dvec2 way = p - centre;
    return gradus::sqrt(way.x * way.x + way.y * way.y) / distance;
  }
};

/// Squares on a ground that reaches to the horizon, seen from one unit above it, looking straight ahead.
/// Above the horizon all is white.
struct Chequerboard {
  dvec2 vanishing;  ///< where lines straight ahead meet
  double focal;     ///< distance of the picture in pixels, above 0
  double side;      ///< of a square, in heights of the eye, above 0

  double operator()(dvec2 p) const { return squares(p); }
  double squares(dvec2 p) const {
    if (p.y <= vanishing.y) return 1;
    const dvec2 d = p - vanishing;
    // To the right and ahead
    const dvec2 at(d.x, focal);
    auto n = floor(at / d.y / side);
    return is_even(n.x + n.y) ? 1 : 0;
  }
  /// So many rows below the horizon the squares get lower than a pixel.
  double finest() const { return gradus::sqrt(focal / side); }
};

/// Black bars of `width` at every `period`, upright, white between them.
struct Bars {
  double period, width;
  double first = 0;  ///< where a bar begins

  double operator()(dvec2 p) const {
    const double x = (p.x - first) / period;
    return (x - std::floor(x)) * period < width ? 0 : 1;
  }
  /// White's part from x to x + 1: what a pixel should show.
  double mean(double x) const { return 1 - (black_up_to(x + 1) - black_up_to(x)); }

 private:
  double black_up_to(double x) const {
    const double bars = std::floor((x - first) / period);
    return bars * width + std::min(x - first - bars * period, width);
  }
};

/// A black line of `width` pixels, across it, through (0, offset); `slope` rows down a column.
struct ThinLine {
  double offset, slope, width;

  /// How many rows it is high.
  double height() const { return width * gradus::sqrt(1 + slope * slope); }
  double operator()(dvec2 p) const { return std::abs(p.y - offset - slope * p.x) * 2 < height() ? 0 : 1; }
};

/// Black below a straight edge through (0, offset), white above it; `slope` rows down a column.
struct HalfPlane {
  double offset, slope;

  double operator()(dvec2 p) const { return p.y > offset + slope * p.x ? 0 : 1; }
};

/// A wave of these many cycles per pixel along each axis.
struct Grating {
  dvec2 frequency;

  double operator()(dvec2 p) const { return wave(2 * phase(p)); }
  /// Its mean over a pixel.
  double mean(ivec2 pixel) const {
    const double middle = sin_cos_half_turns(2 * phase(dvec2(pixel) + 0.5)).cos;
    return 0.5 + 0.5 * middle * sinc(frequency.x) * sinc(frequency.y);
  }
  /// The wave that has the same samples in pixel centres, up to its phase.
  Grating alias() const { return {{alias_of(frequency.x, 1.0), alias_of(frequency.y, 1.0)}}; }

 private:
  double phase(dvec2 p) const { return frequency.x * p.x + frequency.y * p.y; }
};

/// A pixel of a pattern: the mean of n x n samples at the middles of its equal parts; n = 1 is the sample in
/// its centre.
///
/// pattern(dvec2): a value at a place. n: from 1 on.
///
/// Domain: any pixel. Steps: none. Accuracy: n n roundings. Cost: n n calls of the pattern.
/// Errors: n below 1 is refused.
template <class Pattern>
constexpr double pixel_of(const Pattern& pattern, ivec2 p, int n) {
  expects(n >= 1, "a sample per pixel or more");
  const double N = n;
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      // In the middle of a part
      auto part = dvec2(i, j) + 0.5;
      auto at = dvec2(p) + part / N;
      sum += pattern(at);
    }
  }
  return sum / (N * N);
}

/// A picture of a pattern, n x n samples per pixel.
///
/// pattern, n: as for pixel_of. size: columns and rows. plot(ivec2, double): once per pixel, row by row.
///
/// Domain: no pixels, too. Steps, accuracy, cost of a pixel and errors: as pixel_of.
template <class Pattern, class Plot>
constexpr void picture_of(const Pattern& pattern, ivec2 size, int n, Plot&& plot) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) plot(ivec2{x, y}, pixel_of(pattern, {x, y}, n));
  }
}

}  // namespace gradus::sampling_theorem
