#pragma once
// Many segments against one window: the results of correctly_rounded, several segments at a time.

#include <cstddef>
#include <cstdint>
#include <span>

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

namespace gradus::cohen_sutherland_2d {

/// Clips every line to the window: the bits of correctly_rounded (and of liang_barsky's), on every
/// machine. As many lines as fit into a register go together through codes, at most one cut per end, and a
/// certificate; lines without it go through correctly_rounded one by one.
///
/// lines: any number. window: as for correctly_rounded. clipped: as many as lines, or lines itself; number i
/// is what is left of lines[i], or lines[i] where nothing is. accepted: as many; 1 where something is left,
/// else 0.
///
/// Returns how many are accepted.
///
/// Domain: that of correctly_rounded. Lines with a coordinate beyond 2^300 always go one by one.
/// Accuracy: that of correctly_rounded, bit for bit, on every machine: what is certified is the nearest
///   number, whether fused multiply-adds found it or products in parts.
/// Cost: see the topic's page; some 60 additions and products per line, one division per end.
/// Errors: ContractViolation for spans of different lengths, and as correctly_rounded; the outputs are
/// without
///   meaning then.
std::size_t clip_batch(std::span<const Segment<2, double>> lines, const Rectangle<double>& window,
                       std::span<Segment<2, double>> clipped, std::span<std::uint8_t> accepted);

}  // namespace gradus::cohen_sutherland_2d
