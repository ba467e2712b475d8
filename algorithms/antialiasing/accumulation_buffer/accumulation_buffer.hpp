#pragma once
// The accumulation buffer: the whole picture is rendered again and again, each time from a slightly different
// place, moment or eye, and the sum of all passes is divided by their number. It antialiases, blurs what
// moves and what is out of focus, with one more buffer than a single picture needs.
//
// Pixel (c, r) covers [c, c + 1) x [r, r + 1), row 0 at the top.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"

namespace gradus::accumulation_buffer {

/// So many passes are allowed. Sums of as many values up to 2^1000, or 2^100 as floats, cannot overflow.
inline constexpr int most_passes = 1 << 20;

// --- The buffer --------------------------------------------------

/// The type that the values of a picture are divided by: of a vector its components', else its own.
template <class Value>
struct ScalarOf {
  using type = Value;
};
template <class Value>
  requires requires { typename Value::value_type; }
struct ScalarOf<Value> {
  using type = typename Value::value_type;
};
template <class Value>
using Scalar = typename ScalarOf<Value>::type;

/// The caller's sums, row by row, of a picture of this size. Value: float, double, gradus::Exact or a vector
/// of them: wider than what a picture is stored in, for a sum of n bytes has up to 255 n.
template <class Value>
struct Sums {
  using T = Scalar<Value>;
  std::span<Value> values;
  ivec2 size;  ///< columns and rows

  /// Errors: ContractViolation unless there is one value per pixel.
  constexpr Sums(std::span<Value> its_values, ivec2 its_size) : values(its_values), size(its_size) {
    expects(size.x >= 0 && size.y >= 0, "a picture of {} x {} pixels", size.x, size.y);
    expects(std::ssize(values) == std::int64_t{size.x} * size.y, "{} sums for {} x {} pixels", values.size(),
            size.x, size.y);
  }

  constexpr void clear() const { std::ranges::fill(values, Value(0)); }
  /// One value of a pass is added. Domain: a pixel of the picture, 0 <= x < columns, 0 <= y < rows.
  constexpr void operator()(ivec2 pixel, const Value& value) const { add(pixel, value); }
  constexpr void add(ivec2 p, const Value& value) const {
    // Wide enough for all passes
    Value& sum = at(p);
    sum = sum + value;
  }
  /// The sums become means.
  constexpr void divide(int passes) const {
    const auto n = T(passes);
    for (Value& sum : values) {
      sum = sum / n;
    }
  }

 private:
  constexpr Value& at(ivec2 p) const {
    return values[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size.x) +
                  static_cast<std::size_t>(p.x)];
  }
};

/// What draws the picture of a pass: render(place, plot) calls plot(pixel, value), at most once per pixel.
template <class Render, class Place, class Value>
concept Renders = std::invocable<Render&, const Place&, const Sums<Value>&>;

// --- Where the passes look ---------------------------------------

/// The middle of part k of n equal parts of [0, 1]: (2k + 1) / 2n, rounded once.
/// Domain: 0 <= k < n <= 2^20.
constexpr double middle(int k, int n) { return (2.0 * k + 1) / (2.0 * n); }

/// The place in every pixel that one of a x b passes looks at, in (0, 1) x (0, 1).
/// Domain: 0 <= i < a, 0 <= j < b. Accuracy: 1/2 ulp per coordinate; exact where a and b are powers of two.
constexpr dvec2 place_of(int i, int j, ivec2 grid) { return {middle(i, grid.x), middle(j, grid.y)}; }

/// How long light falls into the camera.
struct Shutter {
  double opens, closes;

  constexpr double length() const { return closes - opens; }
  /// The middle of part k of n. Accuracy: 6 * 2^-53 of the larger of |opens| and |closes|.
  constexpr double moment(int k, int n) const { return opens + middle(k, n) * length(); }
};

/// A square onto a disc: rings of squares become circles, and equal areas stay equal. The square is
/// [-1, 1] x [-1, 1], the disc has radius 1. P. Shirley, K. Chiu, A low distortion map between disk and
/// square, Journal of Graphics Tools 2(3), 1997, 45-52.
///
/// Domain: finite places. Accuracy: a coordinate within 4 * 2^-53 of the larger of |u| and |v|; places
/// mirrored in an axis are mirrored bit for bit.
inline dvec2 concentric(dvec2 square) {
  constexpr double eighth = 0.78539816339744830962;  // of a turn, in radians
  const double u = square.x, v = square.y;
  if (u == 0 && v == 0) return {0, 0};
  if (std::abs(u) > std::abs(v)) return u * dvec2{cos(eighth * (v / u)), sin(eighth * (v / u))};
  return v * dvec2{sin(eighth * (u / v)), cos(eighth * (u / v))};
}

/// A lens seen as the disc of all eyes, which look along +z from depth 0.
struct Lens {
  double radius;
  double focus;  ///< the depth that is sharp, > 0

  /// The middle of cell (i, j) of n x n, put on the lens.
  dvec2 eye(int i, int j, int n) const {
    return radius * concentric({2 * middle(i, n) - 1, 2 * middle(j, n) - 1});
  }
};

/// Where an eye beside the lens's middle sees a point: the picture is sheared so that it stays put at the
/// depth of focus. P. Haeberli, K. Akeley, The accumulation buffer: hardware support for high-quality
/// rendering, SIGGRAPH 1990, 309-318.
///
/// point: z > 0 is its depth. eye: at depth 0. focus > 0. All in one unit; the picture is at depth 1.
///
/// Domain: as said; Scalar may be exact.
/// Accuracy: 5 * 2^-53 of |point / z| + |eye| (1/focus + 1/z); at z = focus the same bits from every eye.
/// Cost: 3 divisions.
/// Errors: none.
template <class Number>
constexpr glm::vec<2, Number> seen(const glm::vec<3, Number>& point, const glm::vec<2, Number>& eye,
                                   const Number& focus) {
  const Number shear = Number(1) / focus - Number(1) / point.z;
  return {point.x / point.z + eye.x * shear, point.y / point.z + eye.y * shear};
}

/// The circle of confusion: how wide the disc is, in the picture at depth 1, that a lens makes of a point.
/// It is aperture * |z - f| / (z f), with the aperture 2 r; 0 at z = f.
/// Domain: z > 0, f > 0. Accuracy: 4 * 2^-53 of 2 r (1/f + 1/z).
template <class Number>
constexpr Number circle_of_confusion(const Number& radius, const Number& focus, const Number& depth) {
  const Number shear = Number(1) / focus - Number(1) / depth;
  return Number(2) * radius * (shear < Number(0) ? Number(0) - shear : shear);
}

// --- Steps -------------------------------------------------------

/// The sums are 0.
struct Started {
  std::int64_t passes;  ///< how many there will be
};

/// The picture at one place of every pixel was added.
struct PassAdded {
  std::int64_t pass;  ///< from 0
  dvec2 place;        ///< in the pixel
};

/// The picture of one moment was added.
struct MomentAdded {
  std::int64_t pass;
  double moment;
};

/// The picture that one eye sees was added.
struct EyeAdded {
  std::int64_t pass;
  dvec2 eye;
};

/// The sums were divided.
struct Averaged {
  std::int64_t passes;
};

// --- The taught methods ------------------------------------------

/// Whether so many passes are allowed.
constexpr bool allowed(std::int64_t a, std::int64_t b) {
  return 1 <= a && a <= most_passes && 1 <= b && b <= most_passes && a * b <= most_passes;
}

/// Antialiases a picture: renders it a x b times, each time at another place of every pixel, and takes the
/// mean. P. Haeberli, K. Akeley, The accumulation buffer, SIGGRAPH 1990, 309-318.
///
/// grid: a columns and b rows of places in a pixel. render(dvec2 place, plot): draws the whole picture, each
///   pixel as its place says, and calls plot(ivec2 pixel, Value value). sums: the caller's; the means when it
///   returns.
///
/// Domain: 1 <= a b <= 2^20; values that are 0 or from 2^-1000 to 2^1000 in size, as floats from 2^-100 to
///   2^100. Pixels that a pass leaves out count as 0.
/// Steps: Started PassAdded{a b} Averaged; row by row, the places of a row from left to right.
/// Accuracy: exact with rationals; else at most (a b + 1) u times the mean of |values| off, u = 2^-53 or, as
///   floats, 2^-24: a b - 1 additions, each within u of its sum (C. Jeannerod, S. Rump, Improved error bounds
///   for inner products, SIAM J. Matrix Anal. Appl. 34(2), 2013, 338-344), and a division. What one pass
///   with a b samples per pixel gives, added in this order, bit for bit. Bytes as doubles: correctly rounded.
/// Cost: a b renderings, as many additions per pixel, a division per pixel; no memory but the sums.
/// Errors: ContractViolation for grids without places or with more than 2^20.
template <class Value, Renders<dvec2, Value> Render, Observer<Started, PassAdded, Averaged> O = Unobserved>
constexpr void accumulate(ivec2 grid, Render&& render, const Sums<Value>& sums, O&& observer = {}) {
  expects(allowed(grid.x, grid.y), "{} x {} passes are not from 1 to {}", grid.x, grid.y, most_passes);
  const int a = grid.x, b = grid.y;
  // Nothing is in the buffer yet
  sums.clear();
  if constexpr (observed<O>) observer(Started{a * b});
  for (int j = 0; j < b; ++j) {
    for (int i = 0; i < a; ++i) {
      // One place of every pixel
      auto p = place_of(i, j, grid);
      // The whole picture is added
      render(p, sums);
      if constexpr (observed<O>) observer(PassAdded{j * a + i, p});
    }
  }
  // The mean of all passes
  sums.divide(a * b);
  if constexpr (observed<O>) observer(Averaged{a * b});
}

/// Blurs what moves: renders the picture at the middle of each of n parts of the time that the shutter is
/// open, and takes the mean. Source: as accumulate.
///
/// n: passes. shutter: when it opens and closes. render(double moment, plot): draws the picture of a moment.
///   sums: as for accumulate.
///
/// Domain: 1 <= n <= 2^20; finite times, opens <= closes.
/// Steps: Started MomentAdded{n} Averaged, in the order of time.
/// Accuracy: of the sums as accumulate. What moves with speed v is drawn at n places v length / n apart: each
///   stands for its part, and together they are as long as v times the time that the shutter is open.
/// Cost: n renderings, as many additions per pixel, a division per pixel; no memory but the sums.
/// Errors: ContractViolation for other numbers of passes and for shutters that close before they open.
template <class Value, Renders<double, Value> Render, Observer<Started, MomentAdded, Averaged> O = Unobserved>
constexpr void motion_blur(int n, const Shutter& shutter, Render&& render, const Sums<Value>& sums,
                           O&& observer = {}) {
  expects(allowed(n, 1), "{} passes are not from 1 to {}", n, most_passes);
  expects(shutter.opens <= shutter.closes, "the shutter opens at {} and closes at {}", shutter.opens,
          shutter.closes);
  // Nothing is in the buffer yet
  sums.clear();
  if constexpr (observed<O>) observer(Started{n});
  for (int k = 0; k < n; ++k) {
    // The middle of a part
    auto t = shutter.moment(k, n);
    // The picture of that moment
    render(t, sums);
    if constexpr (observed<O>) observer(MomentAdded{k, t});
  }
  // The mean of all moments
  sums.divide(n);
  if constexpr (observed<O>) observer(Averaged{n});
}

/// Blurs what is out of focus: renders the picture from n x n eyes on the lens, sheared so that the depth of
/// focus stays put, and takes the mean. Source: as accumulate.
///
/// n: eyes of a side of the grid that is put on the lens. render(dvec2 eye, plot): draws what the eye sees,
///   each point where seen(point, eye, lens.focus) says. sums: as for accumulate.
///
/// Domain: 1 <= n <= 2^10; radius >= 0, focus > 0, both finite.
/// Steps: Started EyeAdded{n n} Averaged; row by row.
/// Accuracy: of the sums as accumulate; of the places as seen. A point at depth z becomes n x n points within
///   a disc as wide as circle_of_confusion, and one at the depth of focus stays one.
/// Cost: n n renderings, as many additions per pixel, a division per pixel; no memory but the sums.
/// Errors: ContractViolation for other numbers of eyes, radii and depths.
template <class Value, Renders<dvec2, Value> Render, Observer<Started, EyeAdded, Averaged> O = Unobserved>
constexpr void depth_of_field(int n, const Lens& lens, Render&& render, const Sums<Value>& sums,
                              O&& observer = {}) {
  expects(allowed(n, n), "{} x {} eyes are not from 1 to {}", n, n, most_passes);
  expects(lens.radius >= 0 && lens.focus > 0, "a lens of radius {}, sharp at {}", lens.radius, lens.focus);
  // Nothing is in the buffer yet
  sums.clear();
  if constexpr (observed<O>) observer(Started{n * n});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      // An eye on the lens
      auto eye = lens.eye(i, j, n);
      // The picture that it sees
      render(eye, sums);
      if constexpr (observed<O>) observer(EyeAdded{j * n + i, eye});
    }
  }
  // The mean of all eyes
  sums.divide(n * n);
  if constexpr (observed<O>) observer(Averaged{n * n});
}

}  // namespace gradus::accumulation_buffer
