#pragma once
// Many segments against one box: the results of correctly_rounded, several segments at a time.

#include <cstddef>
#include <cstdint>
#include <span>

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

namespace gradus::cohen_sutherland_3d {

/// Clips every line to the box: the bits of correctly_rounded, on every machine. As many lines as fit
/// into a register go together through codes, at most one cut per end, and a certificate; lines without it go
/// through correctly_rounded one by one.
///
/// lines: any number. box: as for correctly_rounded. clipped: as many as lines, or lines itself; number i is
/// what is left of lines[i], or lines[i] where nothing is. accepted: as many; 1 where something is left, else
/// 0.
///
/// Returns how many are accepted.
///
/// Domain: that of correctly_rounded. Lines with a coordinate beyond 2^300 always go one by one.
/// Accuracy: that of correctly_rounded, bit for bit, on every machine: what is certified is the nearest
///   number, whether fused multiply-adds found it or products in parts.
/// Cost: see the topic's page; some 120 additions and products per line, two divisions.
/// Errors: ContractViolation for spans of different lengths, and as correctly_rounded; the outputs are
/// without
///   meaning then.
std::size_t clip_batch(std::span<const Segment<3, double>> lines, const AxisBox<3, double>& box,
                       std::span<Segment<3, double>> clipped, std::span<std::uint8_t> accepted);

}  // namespace gradus::cohen_sutherland_3d
