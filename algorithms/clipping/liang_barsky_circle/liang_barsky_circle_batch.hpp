#pragma once
// Many segments against one circle: the results of exact_decision, several segments at a time.

#include <cstddef>
#include <cstdint>
#include <span>

#include "clipping/liang_barsky_circle/liang_barsky_circle.hpp"

namespace gradus::liang_barsky_circle {

/// What became of a batch.
struct BatchCount {
  std::size_t accepted = 0;    ///< something is left of them
  std::size_t one_by_one = 0;  ///< went through exact_decision: without a certificate, or the last few
};

/// Clips every segment to the circle: the bits of exact_decision, on every machine. As many segments as
/// fit into a register go together: sides, foot and discriminant with bounds of their errors, then points in
/// pairs of doubles. Where a bound leaves a decision or a point's last bit open, exact_decision has the word.
///
/// segments: any number. circle: as for exact_decision. clipped: as many as segments, or segments itself;
/// number i is what is left of segments[i], or segments[i] where nothing is. accepted: as many; 1 where
/// something is left, else 0.
///
/// Returns how many are accepted, and how many had no certificate.
///
/// Domain: that of exact_decision. Segments with a coordinate beyond 2^150 always go one by one; so do those
///   to be cut that are shorter than 2^-150, or at circles smaller than that.
/// Accuracy: that of exact_decision, bit for bit, on every machine: an interval that holds its point and the
///   true one rounds to one double, whether fused multiply-adds found it or products in parts.
/// Cost: see the topic's page; some 45 additions and products to decide; to cut 210, 2 divisions, a root.
/// Errors: ContractViolation for spans of different lengths, and as exact_decision; the outputs are without
///   meaning then.
BatchCount clip_batch(std::span<const Segment<2, double>> segments, const Circle<double>& circle,
                      std::span<Segment<2, double>> clipped, std::span<std::uint8_t> accepted);

}  // namespace gradus::liang_barsky_circle
