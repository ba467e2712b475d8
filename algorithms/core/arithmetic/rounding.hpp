#pragma once
// What exact results stand on: the arithmetic of IEEE 754, where each operation rounds once, to nearest.
//
// A compiler may take that away in two ways. -ffast-math computes with other formulas than those that are
// written: it is refused. Contraction makes one fused multiply-add of a product and a sum that follows; GCC
// does so wherever the machine can (-march=native), unless told -ffp-contract=off. It only leaves a rounding
// out, so error bounds stand; but where a product must be the rounded one, it is written unfused(x * y).
// See docs/decisions/0014-products-are-rounded-where-it-matters.md.

#include <concepts>
#include <type_traits>

#include "core/language.hpp"

// __GCC_IEC_559 is 0 for each part of -ffast-math alone, too; Clang tells of -ffinite-math-only only
#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "Gradus needs the arithmetic of IEEE 754: compile without -ffast-math, -Ofast and their parts"
#elif __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error "Gradus needs results rounded to their own type: compile for SSE2 (-msse2 -mfpmath=sse), not for x87"
#endif

namespace gradus {

/// Whether the machine compiled for multiplies and adds in one instruction, rounding once.
#if defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__ARM_FEATURE_FMA)
inline constexpr bool has_fma = true;
#else
inline constexpr bool has_fma = false;
#endif

/// x, which the compiler doesn't look behind: a product is rounded before anything is added to it.
/// Cost: none but that of a multiplication and an addition in place of one fused instruction.
template <class T>
constexpr T unfused(T x) {
  if constexpr (std::floating_point<T>) {
#if __has_builtin(__builtin_assoc_barrier)
    return __builtin_assoc_barrier(x);  // GCC
#else
    // Clang fuses across statements only when told so (-ffp-contract=fast), and then everywhere
    if constexpr (has_fma) {
      if (!std::is_constant_evaluated()) {
#if defined(__x86_64__) || defined(__i386__)
        __asm__("" : "+x"(x));
#elif defined(__ARM_FEATURE_FMA)
        __asm__("" : "+w"(x));
#else
        __asm__("" : "+m"(x));
#endif
      }
    }
#endif
  }
  return x;
}

}  // namespace gradus
