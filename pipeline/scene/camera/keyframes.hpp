#pragma once
// Values that are told at some frames of a film, and what they are at all others.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace gradus::pipeline {

/// How a value goes from one key to the next: straight at a steady pace, or on a curve without a jerk.
enum class Interpolation { linear, smooth };
inline constexpr std::array<std::string_view, 2> interpolation_names{"linear", "smooth"};

/// A value and the frame that has it.
template <class Value>
struct Keyframe {
  int frame = 0;
  Value value{};
};

/// Keys of one quantity, each at a later frame than the one before. Value: double, dvec3.
template <class Value>
using Track = std::vector<Keyframe<Value>>;

/// How much a value changes per frame on the straight way from key k to the next.
template <class Value>
Value steady_pace(const Track<Value>& track, std::size_t k) {
  return (track[k + 1].value - track[k].value) / static_cast<double>(track[k + 1].frame - track[k].frame);
}

/// How much a value changes per frame on the smooth way through key k, the same before and behind it.
template <class Value>
Value smooth_pace(const Track<Value>& track, std::size_t k) {
  if (k == 0) return steady_pace(track, 0);
  if (k + 1 == track.size()) return steady_pace(track, k - 1);
  const Keyframe<Value>&left = track[k - 1], &here = track[k], &right = track[k + 1];
  if (left.value == here.value || here.value == right.value) return Value(0);
  // The parabola through the three keys: each side weighs as much as the other is long
  const double before = here.frame - left.frame, behind = right.frame - here.frame;
  return (behind * steady_pace(track, k - 1) + before * steady_pace(track, k)) / (before + behind);
}

/// The value at a frame, or between two.
///
/// Before the first key and behind the last one it stays what it is there, as in glTF 2.0 (3.11).
/// linear: on the straight line from key to key.
/// smooth: on the Catmull-Rom curve whose knots are the frames of the keys (P. Barry, R. Goldman, "A
/// recursive
///   evaluation algorithm for a class of Catmull-Rom splines", SIGGRAPH 1988, of degree 3): the cubic with
///   the values of two keys, and at each of them with the slope of the parabola through it and its
///   neighbours. So the slope has no jump at any key, however far apart keys are. Ends: the curve is
///   continued straight beyond the first and the last key, by a key as far away as the neighbour is. What two
///   neighbouring keys have in common is held between them, with slope 0 at both.
///
/// Domain: at least one key, finite values; any finite frame.
/// Accuracy: exact at keys and where a value is held; else 8 ulp of the largest of both keys around and of
///   their slopes times their distance. A smooth value may swing beyond those of its keys.
/// Cost: a binary search, some 30 products per coordinate.
template <class Value>
Value value_at(const Track<Value>& track, double frame, Interpolation how) {
  const auto next =
      std::ranges::upper_bound(track, frame, {}, [](const auto& key) -> double { return key.frame; });
  if (next == track.begin()) return next->value;
  const auto k = static_cast<std::size_t>(next - track.begin()) - 1;
  const auto& [from, start] = track[k];
  if (next == track.end() || frame == from || start == next->value) return start;
  const double passed = frame - from, share = passed / (next->frame - from);
  if (how == Interpolation::linear) return start + share * (next->value - start);
  // Hermite's cubic in the shape of Horner
  const Value steady = steady_pace(track, k), leaving = smooth_pace(track, k),
              arriving = smooth_pace(track, k + 1);
  const Value bend = 3.0 * steady - 2.0 * leaving - arriving, twist = leaving + arriving - 2.0 * steady;
  return start + passed * (leaving + share * (bend + share * twist));
}

}  // namespace gradus::pipeline
