// Masks as bits. Compiled once for every kind of machine, as shading_lanes-inl.hpp is.
#if defined(GRADUS_ENGINE_MASK_BITS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRADUS_ENGINE_MASK_BITS_INL_HPP
#undef GRADUS_ENGINE_MASK_BITS_INL_HPP
#else
#define GRADUS_ENGINE_MASK_BITS_INL_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One bit per lane, that of the first the lowest. Domain: up to 16 lanes.
template <class Tag>
HWY_INLINE std::uint32_t bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(tag, mask, bytes.data());
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The mask that these bits are of.
template <class Tag>
HWY_INLINE hn::Mask<Tag> mask_of(Tag tag, std::uint32_t bits) {
  const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(bits),
                                          static_cast<std::uint8_t>(bits >> 8)};
  return hn::LoadMaskBits(tag, bytes.data());
}

/// Calls visit(x) for each bit x, from the lowest.
template <class Visit>
HWY_INLINE void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

// Stores the lanes that are own, and leaves others as they are: Highway's BlendedStore by whole registers,
// since a store of some lanes is microcode on processors of AMD. to: aligned
template <class V, class D, class T>
HWY_INLINE void store_own(V v, hn::Mask<D> own, D d, T* to) {
  hn::Store(hn::IfThenElse(own, v, hn::Load(d, to)), d, to);
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
