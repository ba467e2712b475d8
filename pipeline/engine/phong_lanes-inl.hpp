// Phong's model in single precision, sixteen places at once. Compiled once for every kind of machine, as
// shading_lanes-inl.hpp is.
#if defined(GRADUS_ENGINE_PHONG_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_ENGINE_PHONG_LANES_INL_HPP
#undef GRADUS_ENGINE_PHONG_LANES_INL_HPP
#else
#define GRADUS_ENGINE_PHONG_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <limits>

#include "engine/shading.hpp"
#include "engine/shading_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Cosines that are less from where something ends are in doubt
constexpr float unsure_choice = 0x1p-18f;
// Cones between whose cosines there is less have an edge that single precision cannot draw
constexpr float sharp_cone = 0x1p-6f;

// What leaves a surface: scattered light and the highlight. Doubtful where single precision might choose
// otherwise than double does, or loses too much
struct Light3 {
  Vec3 scattered, highlight;
  M doubtful;
};

// The way to a lamp and what of its light arrives
struct Arriving {
  Vec3 way;
  F share;
  M doubtful;
};

HWY_INLINE M never() { return hn::FirstN(D(), 0); }
HWY_INLINE M near_zero(F x, float limit) { return hn::Lt(hn::Abs(x), set(limit)); }

HWY_INLINE F window_of(const Lamp& lamp, F distance) {
  const F part = hn::Div(distance, set(lamp.range)), square = hn::Mul(part, part);
  const F left = hn::Sub(set(1), hn::Mul(square, square));
  return hn::IfThenElseZero(hn::Lt(distance, set(lamp.range)), hn::Mul(left, left));
}

// c: the cosine to the spot's axis
HWY_INLINE F cone_of(const Lamp& lamp, F c) {
  // The nearer to the inner cone the more; division by 0 where both cones are one is not asked for
  const F t = hn::IfThenElse(hn::Lt(c, set(lamp.inner)),
                             hn::Div(hn::Sub(c, set(lamp.outer)), set(lamp.inner - lamp.outer)), set(1));
  F edge = hn::Mul(hn::Mul(t, t), hn::Sub(set(3), hn::Mul(set(2), t)));
  if (lamp.concentration > 0) edge = hn::Mul(edge, power(positive(c), lamp.concentration, -1));
  return hn::IfThenElseZero(hn::Gt(c, set(lamp.outer)), edge);
}

HWY_INLINE Arriving arriving(const Lamp& lamp, const Vec3& place) {
  if (lamp.kind == Light::Kind::directional)
    return {set(lamp.place), set(lamp.constant > 1 ? 1 / lamp.constant : 1.0f), never()};
  const Vec3 to = minus(set(lamp.place), place);
  const F square = dot(to, to), over = over_length(square);
  // Beside the lamp the way to it is a difference of numbers that are nearly equal
  Arriving a{scaled(to, over), set(1), hn::Lt(square, set(lamp.beside))};
  if (lamp.weakens() || lamp.range < std::numeric_limits<float>::infinity()) {
    const F distance = hn::Mul(square, over);
    const F by = hn::Mul(distance, hn::Add(set(lamp.linear), hn::Mul(distance, set(lamp.quadratic))));
    a.share = hn::Div(set(1), hn::Max(hn::Add(set(lamp.constant), by), set(1)));
    if (lamp.range < std::numeric_limits<float>::infinity())
      a.share = hn::Mul(a.share, window_of(lamp, distance));
  }
  if (lamp.kind == Light::Kind::spot) {
    const F c = hn::Neg(dot(a.way, set(lamp.front)));
    a.share = hn::Mul(a.share, cone_of(lamp, c));
    if (lamp.inner - lamp.outer < sharp_cone) {
      const F middle = set((lamp.inner + lamp.outer) / 2), half = set((lamp.inner - lamp.outer) / 2);
      const M on_edge = hn::Lt(hn::Abs(hn::Sub(c, middle)), hn::Add(half, set(unsure_choice)));
      a.doubtful = hn::Or(a.doubtful, on_edge);
    }
  }
  if (lamp.kind == Light::Kind::area)
    a.share = hn::Mul(a.share, positive(hn::Neg(dot(a.way, set(lamp.front)))));
  return a;
}

// Phong's model, as illumination::phong has it
HWY_INLINE Light3 lit(const ShadingGroup& group, const Vec3& place, const Vec3& normal, const Vec3& viewer) {
  Light3 sum{{zero(), zero(), zero()}, {zero(), zero(), zero()}, never()};
  const F nv = dot(normal, viewer);
  for (const Lamp& lamp : group.lamps) {
    const auto [way, share, beside] = arriving(lamp, place);
    const F nl = dot(normal, way);
    sum.doubtful = hn::Or(sum.doubtful, beside);
    sum.scattered = add_scaled(sum.scattered, set(lamp.intensity), hn::Mul(share, positive(nl)));
    if (!group.shines()) continue;
    // R.V, with R = 2 (N.L) N - L
    const F rv = hn::Sub(hn::Mul(hn::Add(nl, nl), nv), dot(way, viewer));
    const M seen = hn::And(hn::Gt(nl, zero()), hn::Gt(rv, zero()));
    // The highlight ends at the horizon all at once, and steeply where R.V is small and so is its power
    sum.doubtful = hn::Or(sum.doubtful, near_zero(nl, unsure_choice));
    if (group.shininess < 1) sum.doubtful = hn::Or(sum.doubtful, near_zero(rv, 0x1p-10f));
    if (hn::AllFalse(D(), seen)) continue;
    const F mirrored = hn::IfThenElseZero(seen, power(rv, group.shininess, group.whole_power));
    sum.highlight = add_scaled(sum.highlight, set(lamp.intensity), hn::Mul(share, mirrored));
  }
  const Vec3 scattered = product(sum.scattered, set(group.diffuse)), even = set(group.even);
  return {{hn::Add(even.x, scattered.x), hn::Add(even.y, scattered.y), hn::Add(even.z, scattered.z)},
          product(sum.highlight, set(group.specular)),
          sum.doubtful};
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
