#pragma once
// Straight lines a pixel wide without stairs: each pixel gets as much of the line's colour as the line has of
// the pixel. Three answers to how much that is: two pixels share each column (Wu), a cone about the pixel is
// weighed within the line (Gupta and Sproull), or the line's area in the pixel is measured.
//
// All walk along the leading axis as bresenham_line does; the line goes from pixel centre to pixel centre,
// and pixel (x, y) is the square of side 1 about the point (x, y), y up.

#include <array>
#include <climits>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"

namespace gradus::antialiased_line {

using bresenham_line::Extent;
using bresenham_line::extent;
using bresenham_line::int128_t;
using bresenham_line::Moves;
using bresenham_line::moves;
using bresenham_line::place;
using bresenham_line::row_at;
using bresenham_line::Whole;

/// The least and the most of a line that a pixel can have.
inline constexpr int none = 0, full = 255;

/// The byte nearest to a share of 1, a half upwards: floor(255 share + 1/2). Lines of whole length have areas
/// like 1/6, whose 42.5 is a half exactly: what rounding has left less than 2^-36 below a half is one.
/// Domain: 0 <= share <= 1; what rounding leaves beyond is cut off.
constexpr int byte_of(double share) {
  if (share <= 0) return none;
  return share >= 1 ? full : static_cast<int>(255 * share + 0.5 + 0x1p-36);
}

// --- Steps -------------------------------------------------------

/// The walk is about to begin.
struct Started {
  ivec2 from, to;
  Whole dx, dy;  ///< lengths along the leading axis and aside, in pixels
  Moves moves;
};

/// Every pixel is plotted.
struct Finished {
  Whole columns;  ///< dx + 1
};

// --- Wu: two pixels per column -------------------------------------

/// Fixed-point numbers: so many of them make a pixel.
inline constexpr Whole one = Whole{1} << 62;

/// dy / dx in units of 1/one, rounded up: where the exact line passes through a pixel's centre the sum of
/// slopes does not stay below. 0 for a line of one pixel.
constexpr Whole slope_of(Extent size) {
  if (size.dx == 0) return 0;
  return static_cast<Whole>((int128_t{size.dy} * one + size.dx - 1) / size.dx);
}

/// The first eight bits of a fraction: how many 256ths it has.
constexpr int first_byte(Whole fraction) { return static_cast<int>(fraction >> 54); }

/// The slope was added once more: two columns are about to be plotted, one from each end of the line.
struct Paired {
  Whole k;              ///< number of the column, counted from either end
  Whole before, place;  ///< how far aside of its nearer pixel the line passed, and passes; in units of 1/one
  bool over;            ///< whether the sum reached a whole pixel, which was taken off
  ivec2 front, back;    ///< the nearer pixels of both columns
  int near, far;        ///< what they get and what their neighbours aside get
};

/// From a pixel of a column to the next one aside.
constexpr ivec2 side_of(const Moves& go) { return go.diagonal - go.straight; }
/// From a column to the next, one aside or not.
constexpr ivec2 move_of(const Moves& go, bool aside) { return aside ? go.diagonal : go.straight; }

/// Draws a line by two pixels per column, whose intensities are the fractions by which the line passes
/// between them. The fraction is kept in fixed point and one addition serves two columns, for from either end
/// the line looks the same.
/// X. Wu, An efficient antialiasing technique, Computer Graphics 25(4) (SIGGRAPH '91), 143-152.
///
/// from, to: the centres of the end pixels, any int32 coordinates. plot(ivec2, int) gets a pixel and its
///   intensity, 1 to 255 (0 only beside 255); the ends first, both with 255, then columns from both towards
///   the middle.
///
/// Domain: everything; from == to gives one pixel. Level, upright and diagonal lines have one pixel per
///   column.
/// Steps: Started Paired* Finished; Paired floor(dx / 2) times.
/// Accuracy: a column's intensities add up to 255, and their centre lies within 1/256 + 2^-31 pixel of the
///   line, along the axis that does not lead; up to 2^26 pixels the far one is floor(256 x fraction). The
///   same pixels whichever end comes first. The line is 1 thick along the column, so across it is
///   dx / length: a diagonal has 1/sqrt(2) of a level line's ink per unit of length.
/// Cost: an addition, a comparison and a shift for every two columns; one division per line; no memory.
/// Errors: none.
template <class Plot, Observer<Started, Paired, Finished> O = Unobserved>
constexpr void wu(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  Extent size = extent(from, to);
  const Moves go = moves(from, to);
  const ivec2 aside = side_of(go);
  Whole slope = slope_of(size);
  if constexpr (observed<O>) observer(Started{from, to, size.dx, size.dy, go});
  // Both ends lie on the line
  plot(from, full);
  if (from != to) plot(to, full);
  // Two pixels share a column
  int far = none;
  auto pair = [&](auto p, auto q) {
    plot(p, full - far);
    if (far > 0) plot(p + q, far);
  };
  ivec2 front = from, back = to;
  Whole place = 0;
  const Whole mid = size.dx / 2;
  for (Whole k = 1; k <= mid; ++k) {
    // Where the next is crossed
    const Whole sum = place + slope;
    const bool over = sum >= one;
    place = over ? sum - one : sum;
    auto move = move_of(go, over);
    front += move;
    back -= move;
    // The fraction is the far one's
    far = first_byte(place);
    if constexpr (observed<O>) observer(Paired{k, sum - slope, place, over, front, back, full - far, far});
    // A middle column is drawn once
    bool both = 2 * k != size.dx;
    if (both || go.tie) {
      pair(front, aside);
    }
    if (both || !go.tie) {
      pair(back, -aside);
    }
  }
  if constexpr (observed<O>) observer(Finished{size.dx + 1});
}

/// Two pixels of a column.
struct Pair {
  ivec2 pixel, aside;  ///< the nearer to its end of the line, and where from it the other one lies
  int far;             ///< the other one's intensity; the pixel's own is 255 - far
};

/// Column number k of a line as wu draws it, without the columns before: for windows, and to look things up.
///
/// Domain: any int32 coordinates, 0 <= k <= max(|dx|, |dy|).
/// Accuracy: the very pixels and intensities of wu.
/// Cost: O(1), two 128-bit divisions.
/// Errors: ContractViolation when k is not the number of a column.
constexpr Pair pair_at(ivec2 from, ivec2 to, Whole k) {
  const Extent size = extent(from, to);
  expects(0 <= k && k <= size.dx, "this line has columns 0 to {}, there is no column {}", size.dx, k);
  const Moves go = moves(from, to);
  const ivec2 aside = side_of(go);
  const bool from_front = 2 * k < size.dx || (2 * k == size.dx && go.tie);
  const Whole steps = from_front ? k : size.dx - k;
  const int128_t sum = int128_t{steps} * slope_of(size);
  const Whole row = static_cast<Whole>(sum / one);
  const int far = first_byte(static_cast<Whole>(sum % one));
  if (from_front) return {place(from, go, steps, row), aside, far};
  return {place(to, go, -steps, -row), -aside, far};
}

// --- Gupta and Sproull: a cone about each pixel ------------------

/// How far the ends must stay from the border of the int32 plane, in pixels.
inline constexpr int margin = 3;

/// Whether a line is so far from the border of the int32 plane that all pixels about it lie in the plane.
constexpr bool has_room(ivec2 from, ivec2 to) {
  for (const int x : {from.x, from.y, to.x, to.y}) {
    if (x < INT_MIN + margin || x > INT_MAX - margin) return false;
  }
  return true;
}

/// The length of a line of this extent, in pixels; 1 for a point. Accuracy: 2 ulp.
inline double length_of(Extent size) {
  if (size.dx == 0) return 1;
  const auto dx = static_cast<double>(size.dx), dy = static_cast<double>(size.dy);
  return sqrt(dx * dx + dy * dy);
}

/// The volume of the cone of radius 1 and volume 1 between the upright plane through its axis and the one at
/// distance t; negative on the other side. By integration of its sections:
/// (2 t s + asin t - t^3 ln((1 + s) / t)) / pi with s = sqrt(1 - t^2), up to 1/2 at t = 1.
/// Domain: every t. Accuracy: 1e-15.
inline double cone_beside(double t) {
  constexpr double pi = 3.14159265358979323846;
  const double u = t < 0 ? -t : t;
  if (u >= 1) return t < 0 ? -0.5 : 0.5;
  if (u == 0) return 0;
  const double s = sqrt((1 - u) * (1 + u));
  const double volume = (2 * u * s + asin(u) - u * u * u * log((1 + s) / u)) / pi;
  return t < 0 ? -volume : volume;
}

/// The part of a pixel's cone that a line of width 1 covers whose axis passes at this distance from the
/// pixel's centre: 0.78 at distance 0, exactly 1/2 at 1/2, 0 from 3/2 on. The cone has radius 1 and volume 1.
/// Domain: every distance. Accuracy: 2e-15 of the integral.
inline double cone_share(double distance) {
  return cone_beside(distance + 0.5) - cone_beside(distance - 0.5);
}

/// cone_share by a look-up: bytes at distances from 0 to 3/2 in steps of 1/256.
class ConeTable {
 public:
  ConeTable() {
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      bytes_[i] = static_cast<std::uint8_t>(byte_of(cone_share(static_cast<double>(i) / 256)));
  }
  /// The byte of the nearest distance that is there; 0 beyond 3/2.
  /// Domain: distance >= 0.
  /// Accuracy: within a byte's step, 1/255, of the cone's share: half of one by rounding, and less than half
  /// by
  ///   the steps of 1/256, for the share changes by 3/pi per unit of distance at most.
  int at(double distance) const {
    if (!(distance < 1.5)) return none;
    return bytes_[static_cast<std::size_t>(256 * distance + 0.5)];
  }
  /// The same on either side, where distances on one are negative.
  int beside(double distance) const { return at(std::abs(distance)); }

 private:
  std::array<std::uint8_t, 385> bytes_{};
};

/// The one table there is.
inline const ConeTable& cone_table() {
  static const ConeTable table;
  return table;
}

/// A pixel's distance to the line's axis is measured and looked up; it is about to be plotted if any.
struct Measured {
  Whole k;  ///< number of the column
  int row;  ///< how far aside of the nearest pixel of the column
  ivec2 nearest, pixel;
  double beside;  ///< distance of the axis from the pixel's centre; positive: it passes aside
  int intensity;
};

/// Draws a line by the distance of pixel centres from its axis: each pixel gets the part of its cone that the
/// line covers, which a table holds. Neighbouring cones overlap, so brightness does not depend on the slope.
/// S. Gupta, R. F. Sproull, Filtering edges for gray-scale displays, Computer Graphics 15(3)
/// (SIGGRAPH '81), 1-5. They take three pixels per column; near a diagonal up to five have a share, at most
/// four of them one that a byte shows.
///
/// from, to, plot: as for wu, in the order of columns from `from` to `to`; intensities from 1 to 199.
///
/// Domain: coordinates at least 3 from the ends of int32; from == to gives the pixels of a level line's
///   column.
/// Steps: Started Measured* Finished; Measured five times per column, from the least row aside to the most.
/// Accuracy: each byte is within 1/255 of the cone's part within the line, thought without ends: the first
///   and the last column are drawn as if it went on, and no others are. The same whichever end comes first.
/// Cost: a multiplication and a look-up per pixel, five pixels per column; one square root per line.
/// Errors: ContractViolation for ends outside the domain.
template <class Plot, Observer<Started, Measured, Finished> O = Unobserved>
void gupta_sproull(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  expects(has_room(from, to), "the line comes nearer than {} pixels to the end of int32", margin);
  Extent size = extent(from, to);
  auto [dx, dy] = size;
  const Moves go = moves(from, to);
  const ivec2 aside = side_of(go);
  auto& cone = cone_table();
  Whole span = dx == 0 ? 1 : dx;
  auto unit = 1 / length_of(size);
  if constexpr (observed<O>) observer(Started{from, to, dx, dy, go});
  ivec2 nearest = from;
  // The axis above it, times dx
  Whole height = 0;
  for (Whole k = 0; k <= dx; ++k) {
    for (int i = -2; i <= 2; ++i) {
      // At right angles to the axis
      Whole h = height - i * span;
      double d = unit * double(h);
      int ink = cone.beside(d);
      auto p = nearest + i * aside;
      if constexpr (observed<O>) observer(Measured{k, i, nearest, p, d, ink});
      if (ink > none) plot(p, ink);
    }
    // To the next column's nearest
    nearest += go.straight;
    height += dy;
    // Midway the tie rule decides
    Whole past = 2 * height - dx;
    if (past >= (go.tie ? 1 : 0)) {
      nearest += aside;
      height -= dx;
    }
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

// --- The exact area ----------------------------------------------

/// A convex piece of a pixel, its corners about the pixel's centre: x along the line's leading axis, y aside.
/// Four cuts leave eight corners at most; rounding may split some.
struct Piece {
  std::array<dvec2, 16> corners{};
  std::size_t count = 0;

  constexpr void add(dvec2 corner) { corners[count++] = corner; }
};

/// The whole pixel.
constexpr Piece square() {
  Piece piece;
  for (const dvec2 corner : {dvec2{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) piece.add(corner);
  return piece;
}

/// The part of a piece where dot(normal, place) <= reach; nothing of it may be left.
/// Source: Sutherland and Hodgman 1974, one border.
constexpr Piece within(const Piece& piece, dvec2 normal, double reach) {
  Piece part;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const dvec2 a = piece.corners[i], b = piece.corners[i + 1 < piece.count ? i + 1 : 0];
    const double inside_a = reach - (normal.x * a.x + normal.y * a.y);
    const double inside_b = reach - (normal.x * b.x + normal.y * b.y);
    if (inside_a >= 0) part.add(a);
    if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0))
      part.add(a + inside_a / (inside_a - inside_b) * (b - a));
  }
  return part;
}

/// The area of a piece, by the shoelace formula.
constexpr double area_of(const Piece& piece) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < piece.count; ++i) {
    const dvec2 a = piece.corners[i] - piece.corners[0], b = piece.corners[i + 1] - piece.corners[0];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

/// How far aside of pixel (k, row) the axis of a line of this extent passes, times the line's length: exact.
/// Domain: a row near the axis.
constexpr Whole axis_beside(Extent size, Whole k, Whole row) {
  return static_cast<Whole>(int128_t{k} * size.dy - int128_t{row} * size.dx);
}
/// How far ahead of pixel (0, 0) pixel (k, row) lies in the direction of such a line, times its length.
constexpr double ahead(Extent size, Whole k, Whole row) {
  return static_cast<double>(int128_t{k} * size.dx + int128_t{row} * size.dy);
}

/// The direction of such a line; of a point level.
inline dvec2 direction_of(Extent size) {
  return size.dx == 0 ? dvec2{1, 0} : dvec2(size.dx, size.dy) / length_of(size);
}

/// How far the line reaches from the centre of a pixel, in all four directions.
struct Reach {
  double left, right, back, front;
};
constexpr Reach reach_of(Extent size, double length, Whole k, Whole row) {
  const double beside = static_cast<double>(axis_beside(size, k, row)) / length;
  return {0.5 + beside, 0.5 - beside, ahead(size, k, row) / length,
          ahead(size, size.dx - k, size.dy - row) / length};
}

/// The middle of the line that is drawn, from centre to centre; its pixels by column and row.
struct Axis {
  ivec2 from;
  Extent size;
  Moves go;
  double length;

  Axis(ivec2 a, ivec2 b) : from(a), size(extent(a, b)), go(moves(a, b)), length(length_of(size)) {}
  dvec2 direction() const { return direction_of(size); }
  /// Of the pixel nearest to it in a column.
  Whole row(Whole k) const { return row_at(size, go.tie, k); }
  Reach reach(Whole k, Whole j) const { return reach_of(size, length, k, j); }
  ivec2 pixel(Whole k, Whole j) const { return place(from, go, k, j); }
};

/// The line was cut out of a pixel's square; the pixel is about to be plotted.
struct Cut {
  Whole k;
  ivec2 pixel;
  Piece piece;  ///< what the line has of it
  double area;
};

/// Draws a line as what it is, a rectangle 1 wide from centre to centre: each pixel gets the area that the
/// rectangle has of it (a box filter), from cutting the pixel's square at the line's four sides.
/// E. Catmull, A hidden-surface algorithm with anti-aliasing, Computer Graphics 12(3) (SIGGRAPH '78), 6-11.
///
/// from, to: as for wu. plot(ivec2, double) gets a pixel and its area, more than 0 up to 1; byte_of rounds
/// it.
///
/// Domain: coordinates at least 3 from the ends of int32; from == to has no area, and plots nothing.
/// Steps: Started Cut* Finished; Cut once for every pixel that is plotted, column by column.
/// Accuracy: areas within 1e-14; their sum is the line's length within 1e-12 of it. Nothing is left out: two
///   pixels aside of the nearest, the line has ended.
/// Cost: four cuts of a polygon of up to eight corners per pixel, five pixels per column; no memory.
/// Errors: ContractViolation for ends outside the domain.
template <class Plot, Observer<Started, Cut, Finished> O = Unobserved>
void exact_area(ivec2 from, ivec2 to, Plot&& plot, O&& observer = {}) {
  expects(has_room(from, to), "the line comes nearer than {} pixels to the end of int32", margin);
  const Axis axis(from, to);
  const Whole dx = axis.size.dx;
  // Along the line, and across it
  const dvec2 d = axis.direction();
  const dvec2 n(-d.y, d.x);
  if constexpr (observed<O>) observer(Started{from, to, dx, axis.size.dy, axis.go});
  for (Whole k = 0; k <= dx; ++k) {
    const Whole mid = axis.row(k);
    for (int i = -2; i <= 2; ++i) {
      // How far the line reaches
      const Whole j = mid + i;
      auto r = axis.reach(k, j);
      // What of the pixel is inside
      Piece p = square();
      p = within(p, n, r.left);
      p = within(p, -n, r.right);
      p = within(p, -d, r.back);
      p = within(p, d, r.front);
      double area = area_of(p);
      if (area <= 0) continue;
      auto pixel = axis.pixel(k, j);
      if constexpr (observed<O>) observer(Cut{k, pixel, p, area});
      plot(pixel, area);
    }
  }
  if constexpr (observed<O>) observer(Finished{dx + 1});
}

}  // namespace gradus::antialiased_line
