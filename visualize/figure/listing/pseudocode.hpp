#pragma once
// A listing in the textbook's form: p ← p + 2 · dy, while … do, if … then. Made from the source line by line,
// so that it can't say anything else.

#include <cstdint>
#include <vector>

#include "figure/trace.hpp"

namespace gradus {

/// How a listing is written: as the source has it, or as a textbook would.
enum class ListingForm : std::uint8_t { source, pseudo };

/// The lines under their numbers; lines without a meaning of their own (braces that close, names of types)
/// are left out, so that what was reported by one of them is told of the one above it.
std::vector<SourceLine> pseudocode(const std::vector<SourceLine>& listing);
/// The same of a trace's listing, and of what a fault strikes out of it.
void write_pseudocode(Trace& trace);

}  // namespace gradus
