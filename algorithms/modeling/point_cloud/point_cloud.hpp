#pragma once
// Points of space without faces: where the pixels of a depth image lie, how points are drawn, and the normal
// that each one lacks, from how its nearest neighbours lie round it.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arithmetic/finite.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/image.hpp"
#include "core/observe.hpp"
#include "core/raster.hpp"
#include "modeling/kd_tree/kd_tree.hpp"

namespace gradus::point_cloud {

using kd_tree::Index;
using kd_tree::none;

template <class T>
using Place = glm::vec<3, T>;
template <class T>
using Places = std::span<const Place<T>>;
template <class T>
using Near = kd_tree::Neighbours<T>;
template <class T>
using Tree = kd_tree::Tree<3, T>;

/// Points with what is known of each of them; a row that is empty is not known.
template <class T>
struct Cloud {
  std::vector<Place<T>> places{};
  std::vector<Rgba8> colours{};
  std::vector<Place<T>> normals{};
};

/// What each point has, and in how many bytes.
struct Attribute {
  std::string_view name;
  std::size_t bytes;

  friend bool operator==(const Attribute&, const Attribute&) = default;
};
template <class T>
std::vector<Attribute> attributes(const Cloud<T>& cloud) {
  std::vector<Attribute> all{{"position", sizeof(Place<T>)}};
  if (!cloud.colours.empty()) all.push_back({"colour", sizeof(Rgba8)});
  if (!cloud.normals.empty()) all.push_back({"normal", sizeof(Place<T>)});
  return all;
}

/// What neighbours look like: only a surface has one direction in which they spread least.
enum class Shape {
  surface,
  one_place,  ///< all of them are equal
  in_line,    ///< they spread in one direction only, but for roundings
  alike,      ///< in two directions they spread alike, and nowhere less
};

/// How a surface faces at a point.
template <class T>
struct Normal {
  Shape shape;
  Place<T> way;               ///< of length 1; 0 where there is none
  std::array<T, 3> variance;  ///< of the neighbours along three directions across each other, the least first

  /// The share of the least: 0 where all lie in one plane, up to 1/3.
  T variation() const {
    const T whole = variance[0] + variance[1] + variance[2];
    return whole > 0 ? variance[0] / whole : T(0);
  }
};

// --- Steps -------------------------------------------------------

/// The nearest neighbours of a point, itself among them, were found.
template <class T>
struct Gathered {
  Near<T> near;
};
/// Their mean, as seen from the point.
template <class T>
struct Centred {
  Place<T> mean;
};
/// How far they spread round it, and in which directions, the least first.
template <class T>
struct Fitted {
  std::array<T, 3> variance;
  std::array<Place<T>, 3> ways;
  Shape shape;
};
/// The normal, and whether it was turned round.
template <class T>
struct Turned {
  Place<T> normal;
  bool turned;
};

/// A pixel of a depth image was given its place in space.
template <class T>
struct BackProjected {
  ivec2 pixel;
  Place<T> place;
};
/// It has no depth.
struct Hole {
  ivec2 pixel;
};

/// A point was drawn round this pixel.
struct Drawn {
  Index point;
  ivec2 pixel;
};
struct Finished {
  std::size_t points;
};

// --- How neighbours lie ------------------------------------------

/// The neighbours as seen from a place.
template <class T>
std::vector<Place<T>> offsets(const Tree<T>& tree, const Near<T>& near, const Place<T>& from) {
  std::vector<Place<T>> all;
  all.reserve(near.size());
  for (const auto& n : near) all.push_back(tree.points[n.point] - from);
  return all;
}

template <class T>
Place<T> mean(const std::vector<Place<T>>& places) {
  Place<T> sum(T(0));
  for (const Place<T>& p : places) sum += p;
  return sum / static_cast<T>(places.size());
}

/// The covariance of places about a centre: the means of all products of two of their coordinates from there.
/// They are of no size in particular: times 4^exponent they are what they are.
template <class T>
struct Covariance {
  glm::mat<3, 3, T> matrix{T(0)};
  int exponent = 0;
  std::size_t count = 0;  ///< of places

  T trace() const { return matrix[0][0] + matrix[1][1] + matrix[2][2]; }
};
/// Among the smallest numbers a mean has few digits: the covariance is moved to where it would lie with more.
/// off: how far the places lie off their centre in the mean, in the covariance's units.
template <class T>
void take_back(Covariance<T>& found, const Place<T>& off) {
  const T rounding = std::scalbn(std::numeric_limits<T>::denorm_min(), -found.exponent);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(off[axis]) > rounding) return;
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) found.matrix[a][b] -= off[a] * off[b];
  }
}
template <class T>
Covariance<T> covariance(const std::vector<Place<T>>& places, const Place<T>& centre) {
  T largest(0);
  for (const Place<T>& p : places) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis] - centre[axis]));
  }
  Covariance<T> found{.count = places.size()};
  if (!(largest > 0)) return found;
  // Coordinates below 2, so that no square is lost
  found.exponent = std::ilogb(largest);
  Place<T> sum(T(0));
  for (const Place<T>& p : places) {
    Place<T> x = p - centre;
    for (int axis = 0; axis < 3; ++axis) x[axis] = std::scalbn(x[axis], -found.exponent);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) found.matrix[a][b] += x[a] * x[b];
    }
    sum += x;
  }
  found.matrix /= static_cast<T>(places.size());
  take_back(found, sum / static_cast<T>(places.size()));
  return found;
}

/// In parts of all variances: roundings move none of k neighbours by more.
template <std::floating_point T>
T doubt(std::size_t k) {
  return (T(2) * static_cast<T>(k) + T(64)) * (std::numeric_limits<T>::epsilon() / 2);
}

/// What variances of k neighbours, the least first, tell of their shape. A difference counts where roundings
/// alone can't make it.
template <class T>
Shape shape_of(const std::array<T, 3>& variance, std::size_t k) {
  const T whole = variance[0] + variance[1] + variance[2], least = T(2) * doubt<T>(k) * whole;
  if (!(whole > 0)) return Shape::one_place;
  if (!(variance[1] > least)) return Shape::in_line;
  return variance[1] - variance[0] > least ? Shape::surface : Shape::alike;
}

/// Turns two axes in their plane so that the matrix' entry of both becomes 0. ways: the axes so far.
template <class T>
void turn(glm::mat<3, 3, T>& matrix, glm::mat<3, 3, T>& ways, int p, int q) {
  const int r = 3 - p - q;
  const T theta = (matrix[q][q] - matrix[p][p]) / (T(2) * matrix[p][q]),
          slope = (theta < 0 ? T(-1) : T(1)) / (std::abs(theta) + std::sqrt(theta * theta + T(1))),
          c = T(1) / std::sqrt(slope * slope + T(1)), s = slope * c;
  const T moved = slope * matrix[p][q], pr = matrix[p][r], qr = matrix[q][r];
  matrix[p][p] -= moved;
  matrix[q][q] += moved;
  matrix[p][q] = matrix[q][p] = T(0);
  matrix[p][r] = matrix[r][p] = c * pr - s * qr;
  matrix[q][r] = matrix[r][q] = s * pr + c * qr;
  const Place<T> wp = ways[p], wq = ways[q];
  ways[p] = c * wp - s * wq;
  ways[q] = s * wp + c * wq;
}

/// By Jacobi's rotations: the largest mixed product is turned away until all are less than a rounding of the
/// whole. Each takes away a third of what is left, or more, so that they come to an end.
/// Source: C. G. J. Jacobi, 1846; G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., section 8.5.
template <class T>
Fitted<T> axes(const Covariance<T>& covariance) {
  glm::mat<3, 3, T> matrix = covariance.matrix, ways(T(1));
  const T negligible = std::numeric_limits<T>::epsilon() / 2 * covariance.trace();
  constexpr std::array<std::pair<int, int>, 3> pairs{{{0, 1}, {1, 2}, {0, 2}}};
  const auto size = [&](const std::pair<int, int>& pair) {
    return std::abs(matrix[pair.first][pair.second]);
  };
  while (true) {
    const auto [p, q] = *std::ranges::max_element(pairs, {}, size);
    if (!(size({p, q}) > negligible)) break;
    turn(matrix, ways, p, q);
  }
  std::array<std::pair<T, int>, 3> order;
  // A variance below 0 is 0 but for roundings
  for (int i = 0; i < 3; ++i) order[static_cast<std::size_t>(i)] = {std::max(matrix[i][i], T(0)), i};
  std::ranges::sort(order);
  Fitted<T> found;
  for (std::size_t i = 0; i < 3; ++i) {
    found.variance[i] = order[i].first;
    found.ways[i] = ways[order[i].second];
  }
  found.shape = shape_of(found.variance, covariance.count);
  for (T& variance : found.variance) variance = std::scalbn(variance, 2 * covariance.exponent);
  return found;
}

// --- Normals -----------------------------------------------------

/// Whether there is one direction in which neighbours spread least: the others span a surface.
template <class T>
bool flat(const Fitted<T>& found) {
  return found.shape == Shape::surface;
}
/// What is left of neighbours that look like no surface.
template <class T>
Normal<T> no_normal(const Fitted<T>& found) {
  return {found.shape, Place<T>(T(0)), found.variance};
}

template <class T>
void expect_eye(const Place<T>& eye) {
  kd_tree::expect_point<3, T>(eye);
}

/// How the surface faces on which a point lies: the direction in which its nearest neighbours spread least,
/// turned towards an eye that sees it.
/// Source: H. Hoppe, T. DeRose, T. Duchamp, J. McDonald, W. Stuetzle, Surface reconstruction from unorganized
/// points, SIGGRAPH 1992, section 3; M. Pauly, M. Gross, L. Kobbelt, Efficient simplification of
/// point-sampled surfaces, IEEE Visualization 2002, section 2 (the variation).
///
/// tree: of the cloud's points. i: which of them. k: how many neighbours, the point itself among them; all
///   where there are no more. eye: from where the point was seen; infinitely far away it is no place.
///
/// Domain: coordinates, the eye's too, as for kd_tree::build; k >= 1.
///   No normal, of length 0 and with the shape's name, for neighbours in one place, in a line, or whose two
///   lesser variances differ by no more than roundings could make; among them all of fewer than three places.
/// Steps: Gathered Centred Fitted Turned?; no Turned without a normal.
/// Accuracy: n has a variance whose exact residual |C n - l n| is within (2 k + 64) u of the trace of the
///   exact covariance C, and l is its least eigenvalue but for as much. The angle's sine is within as much
///   over the gap to the next variance. Exact for neighbours in a plane across an axis. Of equally near
///   neighbours those of smaller indices count. Neither the cloud's size nor where it lies matters, as far as
///   coordinates and the squares of distances are not rounded away. u = 2^-53 in double.
/// Cost: a search in the tree, 9 k products, some 6 rotations.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<Gathered<T>, Centred<T>, Fitted<T>, Turned<T>> O = Unobserved>
Normal<T> normal(const Tree<T>& tree, Index i, std::size_t k, const Place<T>& eye, O&& observer = {}) {
  expects(i < tree.points.size(), "there is no point {} in a cloud of {}", i, tree.points.size());
  expect_eye(eye);
  auto p = tree.points[i];
  auto near = nearest(tree, p, k);
  if constexpr (observed<O>) observer(Gathered<T>{near});
  auto D = offsets(tree, near, p);
  auto m = mean(D);
  if constexpr (observed<O>) observer(Centred<T>{m});
  auto a = axes(covariance(D, m));
  if constexpr (observed<O>) observer(a);
  if (!flat(a)) return no_normal(a);
  auto n = a.ways[0];
  bool away = dot(n, eye - p) < 0;
  n = away ? -n : n;
  if constexpr (observed<O>) observer(Turned<T>{n, away});
  return {a.shape, n, a.variance};
}

/// Those of all points.
/// Domain, Accuracy, Errors: as normal. Cost: a tree, and normal for each point.
template <std::floating_point T>
std::vector<Normal<T>> normals(Places<T> points, std::size_t k, const Place<T>& eye) {
  const auto tree = kd_tree::build<3, T>(points);
  std::vector<Normal<T>> all;
  all.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) all.push_back(normal(tree, i, k, eye));
  return all;
}

// --- Depth images ------------------------------------------------

/// A camera in the origin that looks along z, x to the right and y up; rows of its pixels count downwards.
template <class T>
struct Pinhole {
  T focal;                ///< how far in front of the eye the picture lies, in pixels
  glm::vec<2, T> centre;  ///< where z goes through it: column and row of pixels, whose middles lie at + 1/2
};

/// What depths and focal lengths may be: coordinates and their products stay numbers of full precision.
template <std::floating_point T>
inline constexpr T largest_depth = std::same_as<T, float> ? T(0x1p40) : T(0x1p400);
/// So far from 0 pixels and a picture's centre may lie.
inline constexpr int most_pixels = 1 << 15;

template <std::floating_point T>
void expect_depth(const T& z) {
  expects(T(1) / largest_depth<T> <= z && z <= largest_depth<T>,
          "expected a depth or focal length from {} to {}, not {}", T(1) / largest_depth<T>, largest_depth<T>,
          z);
}
template <std::floating_point T>
void expect_camera(const Pinhole<T>& camera) {
  expect_depth(camera.focal);
  for (const T& x : {camera.centre.x, camera.centre.y})
    expects(std::abs(x) <= T(most_pixels), "a centre up to {} pixels expected, not {}", most_pixels, x);
}

/// The points that the pixels of a depth image have seen, in their rows from the top: a structured cloud,
/// whose neighbours are known without a search.
/// Source: R. Hartley, A. Zisserman, Multiple View Geometry, 2nd ed., 2004, section 6.1, of the pinhole.
///
/// depth: along z, not along the ray; 0 where nothing was seen.
///
/// Domain: up to 2^15 columns and rows, a centre up to 2^15 pixels from the first one; depths that are not 0,
///   and the focal length, from 2^-400 to 2^400 in double, 2^-40 to 2^40 in float.
/// Steps: (BackProjected | Hole) for each pixel, Finished.
/// Accuracy: z is exact. project gives each point's own pixel again, exactly: i + 1/2 comes back moved by the
///   roundings of a few operations, where half a pixel would be needed to leave it.
/// Cost: two products and two quotients for each pixel.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<BackProjected<T>, Hole, Finished> O = Unobserved>
std::vector<Place<T>> back_project(const Raster<T>& depth, const Pinhole<T>& camera, O&& observer = {}) {
  expect_camera(camera);
  int w = depth.width();
  int h = depth.height();
  expects(w <= most_pixels && h <= most_pixels, "at most {} columns and rows expected", most_pixels);
  auto [f, c] = camera;
  T half(0.5);
  std::vector<Place<T>> cloud;
  for (int j = 0; j < h; ++j) {
    for (int i = 0; i < w; ++i) {
      auto z = depth[{i, j}];
      if (z == 0) {
        if constexpr (observed<O>) observer(Hole{{i, j}});
        continue;
      }
      expect_depth(z);
      // From its pixel's middle
      T u = T(i) + half - c.x;
      T v = c.y - (T(j) + half);
      T x = u * z / f;
      T y = v * z / f;
      cloud.push_back({x, y, z});
      if constexpr (observed<O>) observer(BackProjected<T>{{i, j}, {x, y, z}});
    }
  }
  if constexpr (observed<O>) observer(Finished{cloud.size()});
  return cloud;
}

/// The pixel that holds a place of the picture; one beside it for places that are far away from it.
template <class T>
ivec2 pixel_of(const Place<T>& p) {
  constexpr T far = T(1 << 30);
  return {std::floor(std::clamp(p.x, -far, far)), std::floor(std::clamp(p.y, -far, far))};
}

/// The pixel in which a point is seen.
/// Domain: the camera, and the point's depth, as for back_project; a point that no picture of 2^30 columns
///   and rows shows gets one of its last ones.
template <std::floating_point T>
ivec2 project(const Pinhole<T>& camera, const Place<T>& p) {
  expect_camera(camera);
  expect_depth(p.z);
  const T column = camera.centre.x + camera.focal * p.x / p.z,
          row = camera.centre.y - camera.focal * p.y / p.z;
  expects(all_finite(column, row), "a point expected that lies near enough to be seen");
  return pixel_of(Place<T>{column, row, p.z});
}

// --- Drawing -----------------------------------------------------

/// So many columns and rows a picture may have, and a dot.
inline constexpr int most_side = 1 << 20;

inline void expect_picture(ivec2 size, int radius) {
  expects(size.x <= most_side && size.y <= most_side && 0 <= radius && radius <= most_side,
          "at most {} columns, rows and a radius of as much expected", most_side);
}
/// A picture in which no point is seen.
inline Raster<Index> blank(ivec2 size) { return {size.x, size.y, none}; }

/// The pixels of a dot that a picture has, row by row.
struct DotPixels {
  Window window;
  struct Walk {
    const Window& window;
    ivec2 at;

    ivec2 operator*() const { return at; }
    Walk& operator++() {
      at = at.x < window.upper.x ? ivec2{at.x + 1, at.y} : ivec2{window.lower.x, at.y + 1};
      return *this;
    }
    bool operator!=(const Walk& other) const { return at != other.at; }
  };
  Walk begin() const { return {window, window.empty() ? end().at : window.lower}; }
  Walk end() const { return {window, {window.lower.x, window.upper.y + 1}}; }
};
inline DotPixels dot_at(ivec2 pixel, int radius, const Raster<Index>& picture) {
  return {intersection({pixel - radius, pixel + radius}, picture.window())};
}
/// Of the point that is seen so far, if there is one, and another the one that lies nearer.
template <class T>
Index nearer(Places<T> points, Index seen, Index other) {
  return seen == none || points[other].z < points[seen].z ? other : seen;
}

/// Draws points, and no face between them: which point is seen in each pixel, or `none`.
/// Source: M. Levoy, T. Whitted, The use of points as a display primitive, UNC 85-022, 1985.
///
/// points: x and y in pixels, (0, 0) the first one's corner, z their depth. r: a dot has 2 r + 1 pixels
///   either way.
///
/// Domain: finite coordinates; up to 2^20 columns, rows, and an r of as much.
/// Steps: Drawn for each point, Finished.
/// Accuracy: exact: coordinates are rounded down and compared. Of equally near points the first one is seen.
/// Cost: (2 r + 1)^2 comparisons for each point.
/// Errors: ContractViolation outside the domain.
template <std::floating_point T, Observer<Drawn, Finished> O = Unobserved>
Raster<Index> draw(Places<T> points, ivec2 size, int r, O&& observer = {}) {
  expect_picture(size, r);
  auto front = blank(size);
  auto n = points.size();
  for (Index i = 0; i < n; ++i) {
    auto& p = points[i];
    expects(all_finite(p.x, p.y, p.z), "point {} is not finite", i);
    auto c = pixel_of(p);
    auto dot = dot_at(c, r, front);
    for (ivec2 q : dot) {
      // The nearest is seen
      auto& s = front[q];
      s = nearer(points, s, i);
    }
    if constexpr (observed<O>) observer(Drawn{i, c});
  }
  if constexpr (observed<O>) observer(Finished{points.size()});
  return front;
}

}  // namespace gradus::point_cloud
