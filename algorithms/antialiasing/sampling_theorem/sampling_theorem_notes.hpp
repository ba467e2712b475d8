#pragma once
// Exhibits: two rules of lecture notes for sampling, kept so that a figure can show where they go wrong.
// Never use them to decide anything; sampling_theorem.hpp has the right ones.

#include <cstdint>

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

namespace gradus::sampling_theorem {

// --- Steps ------------------------------------------------------------------------------------------------

/// A rate has been taken to be enough, or too low.
template <class T>
struct RateJudged {
  T f, fs;
  bool enough;
};

/// A wheel has been said to look forwards or backwards.
template <class T>
struct DirectionTold {
  T f, fps;
  bool backward;
};

// --- Exhibits ---------------------------------------------------------------------------------------------

/// FAULTY: twice the highest frequency is taken to be enough (errata E001-50). A sine of 5 Hz, sampled 10
/// times a second from one of its zeros on, is 0 in every sample, and what comes back is nothing at all; at
/// any other phase its size comes out wrong.
///
/// f, fs: as for is_enough.
///
/// Domain: as is_enough. Steps: RateJudged. Accuracy: wrong at fs = 2|f| alone. Cost: a comparison. Errors:
/// none.
template <class T, Observer<RateJudged<T>> O = Unobserved>
constexpr bool at_least_twice(const T& f, const T& fs, O&& observer = {}) {
  // Equality is let through
  const T twice = size(f) + size(f);
  const bool enough = fs >= twice;
  if constexpr (observed<O>) observer(RateJudged<T>{f, fs, enough});
  return enough;
}

/// FAULTY: a wheel faster than half the frame rate is said to turn backwards (errata E001-51). At 24 frames
/// 30 revolutions look like 6 forwards, and eight spokes go backwards at 2 already.
///
/// f, fps: as for apparent_speed; spokes are not asked for.
///
/// Domain: as apparent_speed. Steps: DirectionTold.
/// Accuracy: right for one spoke up to a revolution per frame, else by chance.
/// Cost: a comparison. Errors: none.
template <class T, Observer<DirectionTold<T>> O = Unobserved>
constexpr bool half_frame_rate(const T& f, const T& fps, O&& observer = {}) {
  // No spokes, and no faster wheels
  const T twice = size(f) + size(f);
  const bool backward = twice > fps;
  if constexpr (observed<O>) observer(DirectionTold<T>{f, fps, backward});
  return backward;
}

}  // namespace gradus::sampling_theorem
