#include "engine/vertices_batch.hpp"

#include <array>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/vertices_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stages/5_clipping.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Whole = hn::Rebind<std::int32_t, D>;

struct Point {
  V x, y, z;
};
struct Clip {
  V x, y, z, w;
};

HWY_INLINE V set(double x) { return hn::Set(D(), x); }

// The stages' own order of operations, product by product: their bits
HWY_INLINE V dot(const dvec3& a, const Point& p) {
  return hn::Add(hn::Add(hn::Mul(set(a.x), p.x), hn::Mul(set(a.y), p.y)), hn::Mul(set(a.z), p.z));
}
HWY_INLINE V row(const glm::dmat4& m, int i, const Point& p) {
  const V sum = hn::Add(hn::Mul(p.x, set(m[0][i])), hn::Mul(p.y, set(m[1][i])));
  return hn::Add(hn::Add(sum, hn::Mul(p.z, set(m[2][i]))), set(m[3][i]));
}

HWY_INLINE Point to_view(const VertexPath& path, const glm::dmat4& placement, const Point& p) {
  const auto& [eye, right, up, forward] = path.camera.frame;
  const Point way{hn::Sub(row(placement, 0, p), set(eye.x)), hn::Sub(row(placement, 1, p), set(eye.y)),
                  hn::Sub(row(placement, 2, p), set(eye.z))};
  return {dot(right, way), dot(up, way), dot(forward, way)};
}

HWY_INLINE Clip by_rays(const SceneLens& lens, const Point& v) {
  const ParallelRays& rays = *lens.rays;
  const V t = hn::Sub(set(rays.plane), v.z);
  const V x = hn::Add(v.x, hn::Mul(t, set(rays.slant.a))), y = hn::Add(v.y, hn::Mul(t, set(rays.slant.b)));
  const double scale = 2 / rays.height;
  return {hn::Mul(set(scale / lens.aspect), x), hn::Mul(set(scale), y),
          hn::Div(hn::Sub(v.z, set(rays.near)), set(rays.far - rays.near)), set(1)};
}
HWY_INLINE Clip to_clip(const SceneLens& lens, const Point& v) {
  if (lens.rays) return by_rays(lens, v);
  const auto& [x, y, z, shift] = lens.perspective;
  return {hn::Mul(set(x), v.x), hn::Mul(set(y), v.y), hn::Add(hn::Mul(set(z), v.z), set(shift)), v.z};
}

// 1 << bit where the point lies beyond a plane
HWY_INLINE V beyond_bit(const sutherland_hodgman::Plane<double>& plane, const Clip& c, int bit) {
  const V along = plane.axis == 0 ? c.x : plane.axis == 1 ? c.y : c.z;
  const V distance = hn::Add(hn::Mul(set(plane.bound), c.w), hn::Mul(set(plane.sign), along));
  return hn::IfThenZeroElse(hn::Ge(distance, hn::Zero(D())), set(1 << bit));
}

// The nearest whole number, midway the smaller
HWY_INLINE V snapped(V pixel) {
  const V scaled = hn::Mul(pixel, set(triangle_coverage::subpixels)), below = hn::Floor(scaled);
  return hn::Add(below, hn::IfThenElseZero(hn::Gt(hn::Sub(scaled, below), set(0.5)), set(1)));
}

HWY_INLINE void place_some(const VertexPath& path, const glm::dmat4& placement,
                           const std::array<sutherland_hodgman::Plane<double>, 6>& planes,
                           const double* positions, std::int32_t* grid, double* depths) {
  const D d;
  const Whole whole;
  Point at;
  hn::LoadInterleaved3(d, positions, at.x, at.y, at.z);
  const Clip c = to_clip(path.lens, to_view(path, placement, at));
  V which = hn::Zero(d);
  for (int i = 0; i < 6; ++i) which = hn::Add(which, beyond_bit(planes[static_cast<std::size_t>(i)], c, i));
  const auto inside = hn::Eq(which, hn::Zero(d));
  const V half_width = set(path.size.width / 2.0), half_height = set(path.size.height / 2.0);
  const V x = hn::Mul(hn::Add(set(1), hn::Div(c.x, c.w)), half_width),
          y = hn::Mul(hn::Sub(set(1), hn::Div(c.y, c.w)), half_height);
  const V column = hn::IfThenElse(inside, snapped(x), set(beyond)),
          line = hn::IfThenElse(inside, snapped(y), which);
  hn::StoreInterleaved2(hn::DemoteTo(whole, column), hn::DemoteTo(whole, line), whole, grid);
  hn::StoreU(hn::Div(c.z, c.w), d, depths);
}

void place_all(const VertexPath& path, const glm::dmat4& placement, const dvec3* positions, std::size_t count,
               ivec2* grid, double* depths) {
  const std::size_t lanes = hn::Lanes(D());
  const auto planes = guard_volume(path.size);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    place_some(path, placement, planes, &positions[i].x, &grid[i].x, depths + i);
  if (i == count) return;
  // The last few, in full registers
  std::array<double, 3 * hn::MaxLanes(D())> from{};
  std::array<std::int32_t, 2 * hn::MaxLanes(D())> to{};
  std::array<double, hn::MaxLanes(D())> depth{};
  for (std::size_t k = 0; k < count - i; ++k)
    for (int axis = 0; axis < 3; ++axis)
      from[3 * k + static_cast<std::size_t>(axis)] = positions[i + k][axis];
  place_some(path, placement, planes, from.data(), to.data(), depth.data());
  for (std::size_t k = 0; k < count - i; ++k) {
    grid[i + k] = {to[2 * k], to[2 * k + 1]};
    depths[i + k] = depth[k];
  }
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(place_all);

void place_vertices(const VertexPath& path, const glm::dmat4& placement, std::span<const dvec3> positions,
                    std::span<ivec2> grid, std::span<double> depths) {
  expects(grid.size() == positions.size() && depths.size() == positions.size(),
          "{} places and {} depths for {} vertices", grid.size(), depths.size(), positions.size());
  HWY_DYNAMIC_DISPATCH(place_all)
  (path, placement, positions.data(), positions.size(), grid.data(), depths.data());
}

}  // namespace gradus::pipeline::engine
#endif
