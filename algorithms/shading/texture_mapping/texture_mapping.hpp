#pragma once
// A picture on a surface: which place of the texture each pixel of a triangle shows, as the triangle lies in
// space, and how far the place goes from pixel to pixel. Which colour is there: texture_filters.hpp.
//
// Rows grow downwards, as in an image; texture coordinates (u, v) have v up.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/tally.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "shading/texture_mapping/texture_filters.hpp"

namespace gradus::texture_mapping {

using triangle_coverage::cover;
using triangle_coverage::Triangle;
using triangle_coverage::Weights;

/// A corner of a triangle in perspective.
template <class T>
struct Corner {
  T over_w;  ///< 1/w, > 0
  Uv<T> uv;
};
template <class T>
using Corners = std::array<Corner<T>, 3>;

// --- Steps -------------------------------------------------------

/// A pixel has its place on the texture.
template <class T>
struct Mapped {
  ivec2 pixel;
  Weights weights;
  glm::vec<3, T> linear;  ///< 1/w, u/w and v/w; of the affine exhibit 1, u and v
  Uv<T> uv;
};

/// The triangle is done.
struct Finished {
  std::int64_t pixels;
};

/// Counts the pixels.
struct Pixels {
  std::int64_t pixels = 0;

  template <class T>
  const Mapped<T>& operator()(const Mapped<T>& step) {
    ++pixels;
    return step;
  }
  Finished operator()(Finished) const { return {pixels}; }
};

// --- Triangles ---------------------------------------------------

/// Values that are linear in the picture: from those at the corners to those at pixels, and how they grow.
template <class T>
class Planes {
 public:
  using Values = glm::vec<3, T>;

  Planes(const Triangle& triangle, const std::array<glm::vec<3, T>, 3>& corners) : corners_(corners) {
    using triangle_coverage::doubled_area, triangle_coverage::subpixels;
    const std::int64_t area = doubled_area(triangle);
    if (area == 0) return;
    const auto edges = triangle_coverage::edges_of(triangle);
    const auto growth = [&](auto step) {
      const auto& [a, b, c] = edges;
      return mean({step(a), step(b), step(c)}, T(area < 0 ? -area : area));
    };
    along_x = growth([](const auto& edge) { return edge.step(); });
    along_y = growth([](const auto& edge) { return std::int64_t{edge.to.x - edge.from.x} * subpixels; });
  }

  /// At the centre with these weights.
  Values at(const Weights& e) const { return mean(e, T(e[0] + e[1] + e[2])); }
  /// Of 1/w, u/w and v/w: how far (u, v) = (u/w, v/w) / (1/w) goes from pixel to pixel, by the rule for
  /// quotients.
  Footprint<T> area(T over_w, Uv<T> uv) const {
    const auto along = [&](const Values& growth) {
      return (Uv<T>(growth.y, growth.z) - growth.x * uv) / over_w;
    };
    return {along(along_x), along(along_y)};
  }

  Values along_x{T(0)}, along_y{T(0)};  ///< what they grow by from a pixel to the next

 private:
  Values mean(const Weights& e, T sum) const {
    return (T(e[0]) * corners_[0] + T(e[1]) * corners_[1] + T(e[2]) * corners_[2]) / sum;
  }

  std::array<Values, 3> corners_;
};

/// What is linear in the picture: 1/w, u/w and v/w at the corners.
template <class T>
std::array<glm::vec<3, T>, 3> over_w(const Corners<T>& corners) {
  const auto at = [](const Corner<T>& c) {
    return glm::vec<3, T>(c.over_w, c.over_w * c.uv.x, c.over_w * c.uv.y);
  };
  return {at(corners[0]), at(corners[1]), at(corners[2])};
}

template <class T>
void expect_corners(const Corners<T>& corners) {
  for (const auto& corner : corners) {
    expects(corner.over_w > T(0), "1/w > 0 was expected at every corner");
    const auto near = [](const T& x) { return T(-farthest) <= x && x <= T(farthest); };
    expects(near(corner.uv.x) && near(corner.uv.y), "texture coordinates within {} were expected", farthest);
  }
}

/// Gives each pixel of a triangle its place on the texture, as the surface lies in space: 1/w, u/w and v/w
/// are linear in the picture, u and v themselves are not.
/// Source: P. Heckbert and H. Moreton, Interpolation for polygon texture mapping and shading, in: State of
/// the Art in Computer Graphics, Springer 1991, 101-111; J. F. Blinn, Hyperbolic interpolation, IEEE Computer
/// Graphics and Applications 12(4), 1992.
///
/// triangle: snapped corners, as triangle_coverage has them. corners: 1/w and (u, v) of each. window: the
///   pixels that are asked for. plot(ivec2, uv, footprint) is called for each pixel that the triangle covers.
///
/// Domain: as for triangle_coverage::cover; 1/w > 0; coordinates within 2^20 of 0.
/// Steps: Mapped* Finished, row by row from the top.
/// Accuracy: (u, v) within 16 u of the largest corner coordinate, u the rounding unit. The footprint within
///   64 u of the same, times what the weights grow by in a pixel, |step| (1/w) / sum, added up.
/// Cost: a pixel three additions to cover it, 9 multiplications and two divisions; 8 more for the footprint.
/// Errors: ContractViolation for corners outside the domain.
template <class T, class Plot, Observer<Mapped<T>, Finished> O = Unobserved>
void perspective_correct(const Triangle& triangle, const Corners<T>& corners, const Window& window,
                         Plot&& plot, O&& observer = {}) {
  expect_corners(corners);
  Tally<O, Pixels> tally(observer);
  // At the corners 1/w, u/w and v/w
  auto given = over_w(corners);
  Planes planes(triangle, given);
  auto map = [&](ivec2 p, auto& e) {
    // Linear in the picture
    const auto v = planes.at(e);
    const T q = v.x;
    // Divided: u and v
    Uv<T> uv{v.y / q, v.z / q};
    if constexpr (observed<O>) observer(tally.count(Mapped<T>{p, e, v, uv}));
    plot(p, uv, planes.area(q, uv));
  };
  cover(triangle, window, map);
  if constexpr (observed<O>) observer(tally.count(Finished{0}));
}

}  // namespace gradus::texture_mapping
