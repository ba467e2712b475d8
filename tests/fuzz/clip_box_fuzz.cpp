// Segments in a box and in the view volume: both methods against rationals.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <optional>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"
#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_volume.hpp"
#include "clipping/liang_barsky/liang_barsky_box.hpp"
#include "support/clip_oracle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::Rational;
using gradus::test::require;

namespace {

template <class T>
void in_box(const Segment<3, T>& line, const AxisBox<3, T>& box, const BorderOrder<3>& order) {
  const auto part = cohen_sutherland_3d::correctly_rounded(line, box);
  const auto exact = test::exact_clip(line, box);
  require(part.has_value() == exact.has_value(), "kept exactly when there is a common point");
  require(cohen_sutherland_3d::correctly_rounded(line, box, order) == part,
          "the order of the faces does not matter");
  require(liang_barsky::box_correctly_rounded(line, box, order) == part, "both methods agree");
  const auto back = cohen_sutherland_3d::correctly_rounded(test::reversed(line), box);
  require(back.has_value() == part.has_value(), "the reverse is kept as well");
  if (!part) return;
  require(test::same_bits(test::reversed(*back), *part), "the reverse is the reverse");
  require(test::same_bits(cohen_sutherland_3d::correctly_rounded(*part, box), part),
          "clipping again changes nothing");
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    require(test::is_nearest(part->a[axis], exact->a[i]), "the first end is the nearest point");
    require(test::is_nearest(part->b[axis], exact->b[i]), "the last end is the nearest point");
  }
}

using Rationals = std::array<Rational, 4>;

/// The six depths that must not be negative.
std::array<Rational, 6> depths(const Rationals& p) {
  return {p[3] + p[0], p[3] - p[0], p[3] + p[1], p[3] - p[1], p[2], p[3] - p[2]};
}

void in_volume(const Segment<4, double>& line, const BorderOrder<3>& order) {
  using cohen_sutherland_3d::ViewVolume;
  std::optional<Segment<4, double>> part;
  Rationals a, d;
  for (std::size_t i = 0; i < 4; ++i) {
    a[i] = line.a[static_cast<int>(i)];
    d[i] = Rational(line.b[static_cast<int>(i)]) - a[i];
  }
  const bool zero = line.a == glm::dvec4(0) || line.b == glm::dvec4(0);
  try {
    part = cohen_sutherland_3d::correctly_rounded(line, ViewVolume{});
  } catch (const ContractViolation&) {
    // (0, 0, 0, 0) is no point; between opposite ends it lies
    Rational dot = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Rational b = a[i] + d[i];
      dot += a[i] * b, aa += a[i] * a[i], bb += b * b;
    }
    require(zero || (dot < 0 && dot * dot == aa * bb), "only what is no segment is refused");
    return;
  }
  require(!zero, "(0, 0, 0, 0) is refused");
  Rational enter = 0, leave = 1;
  Rationals b;
  for (std::size_t i = 0; i < 4; ++i) b[i] = a[i] + d[i];
  const auto from = depths(a), to = depths(b);
  bool misses = false;
  for (std::size_t i = 0; i < 6; ++i) {
    const Rational change = to[i] - from[i];
    if (change == 0) {
      misses = misses || from[i] < 0;
    } else if (change > 0) {
      enter = std::max<Rational>(enter, -from[i] / change);
    } else {
      leave = std::min<Rational>(leave, -from[i] / change);
    }
  }
  const bool hits = !misses && enter <= leave;
  require(part.has_value() == hits, "kept exactly when there is a common point of the volume");
  require(cohen_sutherland_3d::correctly_rounded(line, ViewVolume{}, order) == part,
          "the order of the planes does not matter");
  const auto back = cohen_sutherland_3d::correctly_rounded(test::reversed(line), ViewVolume{});
  require(back.has_value() == hits, "the reverse is kept as well");
  if (!hits) return;
  require(test::same_bits(test::reversed(*back), *part), "the reverse is the reverse");
  for (std::size_t i = 0; i < 4; ++i) {
    const int axis = static_cast<int>(i);
    require(test::is_nearest(part->a[axis], Rational(a[i] + enter * d[i])),
            "the first end is the nearest point");
    require(test::is_nearest(part->b[axis], Rational(a[i] + leave * d[i])),
            "the last end is the nearest point");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const int reach = input.coin() ? 1020 : 60;
  BorderOrder<3> order = usual_order<3>();
  for (std::size_t i = order.size(); i-- > 1;) {
    std::swap(order[i], order[static_cast<std::size_t>(input.below(static_cast<int>(i) + 1))]);
  }
  if (input.coin()) {
    const glm::dvec4 a = input.homogeneous_point(-reach - 54, reach);
    glm::dvec4 b = input.homogeneous_point(-reach - 54, reach);
    const int kind = input.below(8);
    if (kind == 0) b = -a;
    if (kind == 1) b.x = b.w;
    if (kind == 2) b.w = std::abs(b.w);
    in_volume({a, b}, order);
    return 0;
  }
  const glm::dvec3 p = input.space_point(-reach - 54, reach), q = input.space_point(-reach - 54, reach);
  const glm::dvec3 a = input.space_point(-reach - 54, reach), b = input.space_point(-reach - 54, reach);
  const AxisBox<3, double> box{glm::min(p, q), glm::max(p, q)};
  in_box(Segment<3, double>{a, b}, box, order);
  if (reach > 60) return 0;
  in_box(Segment<3, float>{glm::vec3(a), glm::vec3(b)},
         AxisBox<3, float>{glm::vec3(box.lower), glm::vec3(box.upper)}, order);
  return 0;
}
