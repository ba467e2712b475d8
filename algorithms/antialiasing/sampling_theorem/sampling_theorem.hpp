#pragma once
// What samples tell of a signal, and what they can't: frequencies a whole sampling rate apart have the same
// samples. From this follow the alias of a sine, the limit of half the rate, the curve that the samples give
// back, and the wheel of a film that turns backwards.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <span>

#include "core/arithmetic/elementary.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/observe.hpp"

namespace gradus::sampling_theorem {

// --- Steps ------------------------------------------------------------------------------------------------

/// A sample has been taken.
template <class T>
struct Sampled {
  std::int64_t k;
  T time, value;
};

/// The nearest multiple of the rate has been taken away from a frequency.
template <class T>
struct Folded {
  T f, fs;
  T alias;
  bool tie;  ///< f lay in the middle between two multiples
};

/// A sample's kernel has been added at one place.
struct KernelAdded {
  std::int64_t k;
  double sample, kernel;
  double sum;  ///< with all kernels up to this one
};

/// A wheel is on film once more. Turns are counted in revolutions from the first frame on.
template <class T>
struct FrameTaken {
  std::int64_t k;
  T turn;  ///< how far the wheel has turned
  T seen;  ///< how far the eye believes it to have turned
};

// --- Helpers ----------------------------------------------------------------------------------------------

/// f minus the multiple of fs that lies nearest to it: exact for all sizes. Of two multiples equally
/// near, either.
inline double nearest_rest(double f, double fs) { return std::remainder(f, fs); }
inline Exact nearest_rest(Exact f, Exact fs) { return f - fs * Exact(floor(f / fs + Exact(1, 2))); }

inline double size(double x) { return std::abs(x); }
inline Exact size(Exact x) { return abs(x); }

/// sin(pi x) and cos(pi x), the reduction exact: 0 at every whole x, or half of one.
inline SinCos sin_cos_half_turns(double x) { return sin_cos_degrees(180 * std::remainder(x, 2)); }

// --- Sampling ---------------------------------------------------------------------------------------------

/// Takes samples of a signal at equal distances, the first one at time 0.
///
/// signal(t): the signal's value at a time in seconds. fs: samples a second, above 0. samples: the caller's;
///   as many are taken as it holds.
///
/// Domain: any signal; no samples at all, too.
/// Steps: Sampled once per sample, in order.
/// Accuracy: sample k is taken at k / fs, rounded once; exact in Exact.
/// Cost: a call of `signal` a sample; no memory.
/// Errors: a rate of 0 or less, or NaN, is refused.
template <class T, class Signal, Observer<Sampled<T>> O = Unobserved>
constexpr void sample(const Signal& signal, const T& fs, std::span<T> samples, O&& observer = {}) {
  expects(fs > T(0), "a sampling rate above 0");
  std::int64_t k = 0;
  for (T& value : samples) {
    // Nobody looks in between
    const T t = T(k) / fs;
    value = signal(t);
    if constexpr (observed<O>) observer(Sampled<T>{k, t, value});
    ++k;
  }
}

/// The frequency that the samples of a sine of frequency f tell of: of all that have the same samples, the
/// one nearest to 0, f - fs round(f / fs). A negative one is a sine that runs backwards. Source: Shannon
/// 1949, Communication in the presence of noise, Proc. IRE 37(1), pp. 10-21; Nyquist 1928, Certain topics in
/// telegraph transmission theory, Trans. AIEE 47, pp. 617-644.
///
/// f: in Hz, of either sign. fs: samples a second, above 0.
///
/// Domain: everything finite. An odd multiple of fs/2 is as near to +fs/2 as to -fs/2: it gives +fs/2, whose
///   samples tell nothing of the sine's size (they are all 0 at phase 0).
/// Steps: Folded.
/// Accuracy: exact, in doubles of any size, too; the result lies in (-fs/2, fs/2].
/// Cost: one remainder; in doubles up to about 60 ns where f / fs is huge.
/// Errors: a rate of 0 or less, or NaN, is refused.
template <class T, Observer<Folded<T>> O = Unobserved>
constexpr T alias_of(const T& f, const T& fs, O&& observer = {}) {
  expects(fs > T(0), "a sampling rate above 0");
  // Whole rates leave no trace
  const T r = nearest_rest(f, fs);
  // Midway between two: the upper
  bool tie = size(r + r) == fs;
  const T alias = tie ? size(r) : r;
  if constexpr (observed<O>) observer(Folded<T>{f, fs, alias, tie});
  return alias;
}

/// Whether a signal without frequencies beyond f can be told from samples: the rate is above 2f, strictly.
/// Source: Shannon 1949, theorem 1, where the band ends before W; see errata E001-50.
///
/// f: the highest frequency in the signal, in Hz, of either sign. fs: samples a second.
///
/// Domain: everything finite. Accuracy: exact. Cost: a comparison. Errors: none.
template <class T>
constexpr bool is_enough(const T& f, const T& fs) {
  return fs > size(f) + size(f);
}

// --- Reconstruction ---------------------------------------------------------------------------------------

/// sin(pi x) / (pi x), the kernel of a signal that never ends.
/// Source: Whittaker 1915, Proc. Royal Soc. Edinburgh 35, pp. 181-194.
/// Domain: every finite x. Accuracy: 8 units of 2^-53.
inline double sinc(double x) {
  if (std::abs(x) < 0x1p-30) return 1;  // the next term of the series is below a rounding
  return sin_cos_half_turns(x).sin / (std::numbers::pi * x);
}

/// The kernel of a signal that repeats itself after so many samples: all its sincs in one sum. 1 at
/// multiples of `samples`, 0 at all other whole places.
/// Source: Dirichlet 1829, J. reine angew. Math. 4, pp. 157-169.
struct Dirichlet {
  std::int64_t samples;  ///< at least 1

  double operator()(double x) const {
    const auto n = static_cast<double>(samples);
    x = std::remainder(x, n);
    if (std::abs(x) < 0x1p-30) return 1;  // the next term of the series is below a rounding
    const SinCos slow = sin_cos_half_turns(x / n);
    // Of an even number half the band's last frequency is on either side
    const double shape = samples % 2 == 0 ? slow.cos : 1;
    return sin_cos_half_turns(x).sin * shape / (n * slow.sin);
  }
};

/// The signal's value between its samples: a kernel stands on each of them, as high as the sample, and all
/// are added. With `Dirichlet` the samples are one period; with `sinc` they are all there is, and the signal
/// is taken to be 0 at all others. Source: Whittaker 1915; Shannon 1949, theorem 1.
///
/// samples: one at least. x: the place, in distances of samples from the first one. kernel(x): 1 at 0, 0 at
///   other whole places.
///
/// Domain: every finite x; beyond a few periods it is the place itself that is rounded.
/// Steps: KernelAdded once per sample, in order.
/// Accuracy: with Dirichlet and x in [0, n] every periodic signal of frequencies below half the rate comes
///   back within n 2^-48 times its largest possible size; one beyond comes back as its alias.
/// Cost: a kernel per sample.
/// Errors: no samples are refused.
template <class Kernel, Observer<KernelAdded> O = Unobserved>
double reconstruct(std::span<const double> samples, double x, const Kernel& kernel, O&& observer = {}) {
  expects(!samples.empty(), "one sample or more");
  double sum = 0;
  std::int64_t k = 0;
  for (double value : samples) {
    // 0 at all other samples
    auto w = kernel(x - double(k));
    sum += value * w;
    if constexpr (observed<O>) observer(KernelAdded{k, value, w, sum});
    ++k;
  }
  return sum;
}

// --- Time -------------------------------------------------------------------------------------------------

/// The alias of n f. In doubles the product is kept in two parts, so that no rounding decides on which side
/// of the middle it lies.
inline Exact alias_of(std::int64_t n, Exact f, Exact fs) { return alias_of(Exact(n) * f, fs); }
inline double alias_of(std::int64_t n, double f, double fs) {
  const Rounded product = two_product(static_cast<double>(n), std::remainder(f, fs));
  const Rounded sum = two_sum(std::remainder(product.value, fs), std::remainder(product.error, fs));
  // Two rests of at most fs/2 each: their sum may lie one rate too far
  const double half = 0.5 * fs;
  const bool above = sum.value > half || (sum.value == half && sum.error > 0);
  const bool below = sum.value < -half || (sum.value == -half && sum.error <= 0);
  const double rate = above ? fs : below ? -fs : 0;
  return (sum.value - rate) + sum.error;
}

/// How fast a wheel seems to turn on film, in revolutions a second; a negative speed is backwards. The spokes
/// look alike, so the picture repeats `spokes` times per revolution, and the eye takes each for the nearest
/// one of the frame before: f - (F/n) round(f n / F). Source: the sampling theorem in time, Shannon 1949; see
/// errata E001-51 for the rule of half the frame rate.
///
/// f: revolutions a second, of either sign. fps: frames a second, above 0. n: how many spokes look alike,
///   from 1 on; 1 for a wheel with a mark.
///
/// Domain: everything finite; of doubles, fps from 2^-900 to 2^900 and n up to 2^53. Where the spokes move
///   half their distance per frame, both ways are equally near: forwards is told.
/// Steps: none.
/// Accuracy: exact in Exact; in doubles the direction is always right and the speed within 2 units of 2^-53
///   of fps / n.
/// Cost: three remainders and a division.
/// Errors: a rate of 0 or less, or fewer spokes than 1, are refused.
template <class T>
constexpr T apparent_speed(const T& f, const T& fps, std::int64_t n) {
  expects(fps > T(0), "a frame rate above 0");
  expects(n >= 1, "a spoke or more");
  // n times per turn it looks alike
  return alias_of(n, f, fps) / T(n);
}

/// A wheel on film: how far it has turned in each frame, and how far it seems to have.
///
/// f, fps, n: as for apparent_speed. seen: the caller's; a number per frame, in revolutions.
///
/// Domain: as apparent_speed. Where `turn` and `seen` differ it is by whole spokes, so both are the same
/// picture. Steps: FrameTaken once per frame, in order. Accuracy: exact in Exact; in doubles as
/// apparent_speed, and two roundings. Cost: one speed, a division and two products per frame. Errors: as
/// apparent_speed.
template <class T, Observer<FrameTaken<T>> O = Unobserved>
constexpr void film_wheel(const T& f, const T& fps, std::int64_t n, std::span<T> seen, O&& observer = {}) {
  // Spokes look like the nearest
  T v = apparent_speed(f, fps, n);
  std::int64_t k = 0;
  for (T& turn : seen) {
    // Frames have places, not ways
    const T t = T(k) / fps;
    turn = v * t;
    if constexpr (observed<O>) observer(FrameTaken<T>{k, f * t, turn});
    ++k;
  }
}

}  // namespace gradus::sampling_theorem
