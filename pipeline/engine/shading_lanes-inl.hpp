// Numbers, textures and colours in single precision, sixteen pixels at once: what shading_batch.cpp computes
// with. Compiled once for every kind of machine, as certified_lanes-inl.hpp in core is.
#if defined(GRADUS_ENGINE_SHADING_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_ENGINE_SHADING_LANES_INL_HPP
#undef GRADUS_ENGINE_SHADING_LANES_INL_HPP
#else
#define GRADUS_ENGINE_SHADING_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/shading.hpp"
#include "engine/visibility_batch.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, block_cells>;
using DI = hn::RebindToSigned<D>;
using F = hn::Vec<D>;
using I = hn::Vec<DI>;
using M = hn::Mask<D>;
using MI = hn::Mask<DI>;

HWY_INLINE F set(float x) { return hn::Set(D(), x); }
HWY_INLINE I whole(std::int32_t x) { return hn::Set(DI(), x); }
HWY_INLINE F zero() { return hn::Zero(D()); }
HWY_INLINE F positive(F x) { return hn::Max(x, zero()); }

struct Vec3 {
  F x, y, z;
};
HWY_INLINE Vec3 set(const glm::vec3& v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE F dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 scaled(const Vec3& v, F by) { return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)}; }
HWY_INLINE Vec3 product(const Vec3& a, const Vec3& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Vec3 minus(const Vec3& a, const Vec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 add_scaled(const Vec3& a, const Vec3& b, F by) {
  return {hn::Add(a.x, hn::Mul(b.x, by)), hn::Add(a.y, hn::Mul(b.y, by)), hn::Add(a.z, hn::Mul(b.z, by))};
}
// 1 / length, 0 for the zero vector
HWY_INLINE F over_length(F square) {
  return hn::IfThenElseZero(hn::Gt(square, zero()), hn::Div(set(1), hn::Sqrt(square)));
}
HWY_INLINE Vec3 unit(const Vec3& v) { return scaled(v, over_length(dot(v, v))); }

// --- Powers --------------------------------------------------------------------------------------

// c0 + c1 x + c2 x^2 + ...
template <std::size_t n>
HWY_INLINE F polynomial(F x, const float (&c)[n]) {
  F sum = set(c[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;) sum = hn::Add(hn::Mul(sum, x), set(c[i]));
  return sum;
}

// Within 2^-22, for normal x > 0. With x = 2^n m, 2 artanh((m - 1) / (m + 1)) / ln 2 + n
HWY_INLINE F log2_of(F x) {
  const DI di;
  // m from sqrt(1/2) to sqrt(2)
  const I bits = hn::BitCast(di, x), shifted = hn::Sub(bits, whole(0x3f3504f3));
  const I n = hn::ShiftRight<23>(shifted);
  const F m = hn::BitCast(D(), hn::Sub(bits, hn::ShiftLeft<23>(n)));
  const F z = hn::Div(hn::Sub(m, set(1)), hn::Add(m, set(1)));
  constexpr float series[] = {2.88539008f, 0.961796694f, 0.577078016f, 0.412198583f, 0.320598898f};
  return hn::Add(hn::ConvertTo(D(), n), hn::Mul(z, polynomial(hn::Mul(z, z), series)));
}

// Within 2^-22 of 2^x, for x from -126 to 126; less gives less than 2^-125
HWY_INLINE F exp2_of(F x) {
  const F within = hn::Max(hn::Min(x, set(126)), set(-126)), n = hn::Round(within), part = hn::Sub(within, n);
  constexpr float series[] = {
      1, 0.693147181f, 0.240226507f, 0.0555041087f, 0.00961812911f, 0.00133335581f, 0.000154035304f};
  const I shift = hn::ShiftLeft<23>(hn::ConvertTo(DI(), n));
  return hn::BitCast(D(), hn::Add(hn::BitCast(DI(), polynomial(part, series)), shift));
}

// x > 0 to a power
HWY_INLINE F power(F x, float by, int whole_power) {
  if (whole_power < 0) return exp2_of(hn::Mul(log2_of(hn::Max(x, set(0x1p-100f))), set(by)));
  F result = set(1);
  for (auto bit = static_cast<int>(std::bit_width(static_cast<unsigned>(whole_power))); bit-- > 0;) {
    result = hn::Mul(result, result);
    if (whole_power >> bit & 1) result = hn::Mul(result, x);
  }
  return result;
}

// --- Textures ------------------------------------------------------------------------------------

// Texture coordinates: those of a place nearby, with few digits, and how far it is from there
struct Uv {
  F u, v;
  F base_u, base_v;
};

// Of each lane where the four texels of a level about (u, v) begin among all numbers of a texture: lower
// left, lower right, upper left, upper right; and how far (u, v) is on the way to the right and up
struct FourTexels {
  alignas(64) std::int32_t begin[4][block_cells];
  F right, up;
};

// Two cells of an axis beside one another, from 0 to count - 1, and how far the place is from one to the next
struct AxisCells {
  I first, second;
  F part;
};

// Beyond a texture it comes again
HWY_INLINE I wrapped(F cell, I count, bool power_of_two) {
  const DI di;
  if (power_of_two) return hn::And(hn::ConvertTo(di, cell), hn::Sub(count, whole(1)));
  const F size = hn::ConvertTo(D(), count);
  const I rough = hn::ConvertTo(di, hn::Sub(cell, hn::Mul(size, hn::Floor(hn::Div(cell, size)))));
  // The quotient may have been rounded to the next whole number
  const I low = hn::IfThenElse(hn::Lt(rough, hn::Zero(di)), hn::Add(rough, count), rough);
  const I in = hn::IfThenElse(hn::Lt(low, count), low, hn::Sub(low, count));
  // Lanes beyond the triangle may be anywhere
  return hn::Min(hn::Max(in, hn::Zero(di)), hn::Sub(count, whole(1)));
}

HWY_INLINE AxisCells cells_about(F base, F way, I count, bool power_of_two) {
  const F size = hn::ConvertTo(D(), count), there = hn::Sub(hn::Mul(base, size), set(0.5f)),
          cell_there = hn::Floor(there);
  // From here on digits count: texels on from that cell
  const F on = hn::Add(hn::Sub(there, cell_there), hn::Mul(way, size)), cells_on = hn::Floor(on);
  const I first = wrapped(hn::Add(cell_there, cells_on), count, power_of_two),
          next = hn::Add(first, whole(1));
  return {first, hn::IfThenZeroElse(hn::Eq(next, count), next), hn::Sub(on, cells_on)};
}

// What a level has, of all lanes one or of each its own
HWY_INLINE I of_level(const std::array<std::int32_t, 16>& numbers, I level) {
  const std::int32_t first = hn::GetLane(level);
  if (hn::AllTrue(DI(), hn::Eq(level, whole(first)))) return whole(numbers[static_cast<std::size_t>(first)]);
  return hn::GatherIndex(DI(), numbers.data(), level);
}

// Not inline: lanes are to be loaded from memory, one by one, not taken out of registers
HWY_NOINLINE inline void find_texels(const TextureLevels& texture, I level, const Uv& at, FourTexels& four) {
  const DI di;
  const I columns = of_level(texture.columns, level), rows = of_level(texture.rows, level),
          last = hn::Add(of_level(texture.begin, level), hn::Mul(hn::Sub(rows, whole(1)), columns));
  const AxisCells x = cells_about(at.base_u, at.u, columns, texture.powers_of_two),
                  y = cells_about(at.base_v, at.v, rows, texture.powers_of_two);
  const auto put = [&](int which, I up, I column) {
    const I texel = hn::Add(hn::Sub(last, hn::Mul(up, columns)), column);
    hn::Store(hn::Mul(texel, whole(3)), di, four.begin[which]);
  };
  put(0, y.first, x.first);
  put(1, y.first, x.second);
  put(2, y.second, x.first);
  put(3, y.second, x.second);
  four.right = x.part;
  four.up = y.part;
}

// Registers of four numbers and more hold texels whole, and a number more: of four lanes, or eight, the
// first, the fifth and so on at once. Others hold one number of a texel
constexpr bool whole_texels = hn::MaxLanes(D()) >= 4;

template <std::size_t lanes>
HWY_INLINE auto loaded_texels(const float* texels, const std::int32_t* begin) {
  const hn::CappedTag<float, lanes> d;
  if constexpr (lanes <= 4)
    return hn::LoadU(d, texels + *begin);
  else
    // Found by its arguments, as those below: targets of one lane do without
    return Combine(d, loaded_texels<lanes / 2>(texels, begin + lanes / 2),
                   loaded_texels<lanes / 2>(texels, begin));
}

// A number of each of those lanes beside its texel
template <int lane, class Numbers>
HWY_INLINE Numbers beside_texels(Numbers numbers) {
  if constexpr (whole_texels)
    return Broadcast<lane>(numbers);
  else
    return numbers;
}

HWY_INLINE F mixed(F a, F b, F part) { return hn::Add(a, hn::Mul(hn::Sub(b, a), part)); }

// The four texels of lanes, the first of them `lane`, from one of their numbers on
template <int lane>
HWY_INLINE F mixed_of(const float* texels, const FourTexels& four, int from) {
  const auto texel = [&](int which) {
    return loaded_texels<hn::MaxLanes(D())>(texels + from, four.begin[which] + lane);
  };
  const F right = beside_texels<lane>(four.right), up = beside_texels<lane>(four.up);
  return mixed(mixed(texel(0), texel(1), right), mixed(texel(2), texel(3), right), up);
}

// Colours of lanes: find(lane, from) as mixed_of
template <class Find>
HWY_INLINE Vec3 of_each_lane(const Find& find) {
  const D d;
  const std::integral_constant<int, 0> first;
  if constexpr (whole_texels) {
    const auto of = [&](auto lane) { return find(lane, 0); };
    const auto a = of(first), b = of(std::integral_constant<int, 1>()),
               c = of(std::integral_constant<int, 2>()), e = of(std::integral_constant<int, 3>());
    const auto xy_even = InterleaveLower(d, a, c), xy_odd = InterleaveLower(d, b, e),
               z_even = InterleaveUpper(d, a, c), z_odd = InterleaveUpper(d, b, e);
    return {InterleaveLower(d, xy_even, xy_odd), InterleaveUpper(d, xy_even, xy_odd),
            InterleaveLower(d, z_even, z_odd)};
  } else {
    return {find(first, 0), find(first, 1), find(first, 2)};
  }
}

// The mean of the four texels of the first level that lie about (u, v)
HWY_INLINE Vec3 bilinear(const TextureLevels& texture, const Uv& at) {
  FourTexels four;
  find_texels(texture, hn::Zero(DI()), at, four);
  return of_each_lane([&](auto lane, int from) { return mixed_of<lane()>(texture.texels, four, from); });
}

// side: the square of the footprint's longer side, in texels
HWY_INLINE Vec3 mip_mapped(const TextureLevels& texture, F square, const Uv& at) {
  const DI di;
  // Far too long ones, and what is no number, have the last level
  const F most = set(static_cast<float>(texture.levels - 1));
  const M short_enough = hn::Lt(square, set(0x1p40f));
  const F height = hn::IfThenElse(short_enough, hn::Mul(set(0.5f), log2_of(hn::Max(square, set(1)))), most);
  const F level = hn::Min(height, most), lower = hn::Floor(level), part = hn::Sub(level, lower);
  if (hn::AllTrue(D(), hn::Eq(level, zero()))) return bilinear(texture, at);
  const I k = hn::ConvertTo(di, lower), next = hn::Min(hn::Add(k, whole(1)), whole(texture.levels - 1));
  FourTexels finer, coarser;
  find_texels(texture, k, at, finer);
  find_texels(texture, next, at, coarser);
  return of_each_lane([&](auto lane, int from) {
    return mixed(mixed_of<lane()>(texture.texels, finer, from),
                 mixed_of<lane()>(texture.texels, coarser, from), beside_texels<lane()>(part));
  });
}

// --- Colours -------------------------------------------------------------------------------------

// 255 * 1.055 * 2^(5 n / 12) for x from 2^n on, by the lowest four bits of x's exponent: n from -9 to -1
alignas(64) constexpr float octaves[block_cells] = {
    0,           0,           0,           0,           0,           0,           19.9954028f, 26.6906605f,
    35.6277574f, 47.5573505f, 63.4814467f, 84.7375651f, 113.111079f, 150.985176f, 201.541031f, 0};

// Entries of a table of 16 by the lowest four bits of each lane
HWY_INLINE F looked_up(const float* table, I place) {
  const D d;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const auto at = [&](std::size_t from, std::size_t count) {
    const I low = hn::And(place, whole(static_cast<std::int32_t>(count) - 1));
    return hn::TableLookupLanes(hn::Load(d, table + from), hn::IndicesFromVec(d, low));
  };
  if constexpr (lanes == block_cells) {
    return at(0, block_cells);
  } else if constexpr (2 * lanes == block_cells) {
    // The highest bit says in which half, as the sign
    static_assert(block_cells == 16);
    const F which = hn::BitCast(d, hn::ShiftLeft<28>(place));
    return hn::IfNegativeThenElse(which, at(lanes, lanes), at(0, lanes));
  } else {
    return hn::GatherIndex(d, table, hn::And(place, whole(block_cells - 1)));
  }
}

// The nearest of 0 to 255 by sRGB's curve, or its neighbour, in the lowest byte: 255 (1.055 x^(5/12) - 0.055)
// within 1/400. With x = 2^n m, 2^(5 n / 12) m^(5/12). The highest byte is 0x4b.
HWY_INLINE I byte_of(F light) {
  const F x = hn::Min(positive(light), set(0x1.fffffep-1f));
  const I bits = hn::BitCast(DI(), x);
  const F m = hn::BitCast(D(), hn::OrAnd(whole(0x3f800000), bits, whole(0x7fffff)));
  constexpr float power[] = {0.411229337f, 0.828860187f, -0.31828726f, 0.0890376911f, -0.0108295471f};
  const F octave = looked_up(octaves, hn::ShiftRight<23>(bits));
  const F curve = hn::Sub(hn::Mul(polynomial(m, power), octave), set(0.055f * 255));
  const F value = hn::IfThenElse(hn::Lt(x, set(0.0031308f)), hn::Mul(x, set(12.92f * 255)), curve);
  // Of a sum with 2^23 the lowest digits are the nearest whole number
  return hn::BitCast(DI(), hn::Add(value, set(0x1p23f)));
}

HWY_INLINE I packed_of(const Vec3& light) {
  // What is more than a byte is shifted out, or under the opaque highest byte
  const I red = byte_of(light.x), green = hn::ShiftLeft<8>(byte_of(light.y)),
          blue = hn::ShiftLeft<16>(byte_of(light.z));
  return hn::Or(hn::Or(red, green), hn::Or(blue, whole(static_cast<std::int32_t>(0xff000000U))));
}

// packed_of for three times the same
HWY_INLINE I grey_of(F light) {
  const I byte = byte_of(light), twice = hn::Or(byte, hn::ShiftLeft<8>(byte));
  return hn::Or(hn::Or(twice, hn::ShiftLeft<16>(byte)), whole(static_cast<std::int32_t>(0xff000000U)));
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
