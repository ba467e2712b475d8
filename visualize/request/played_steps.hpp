#pragma once
// How much of a run a page with the player holds.

#include <cstdint>

namespace gradus {

/// A page plays so many steps, if no others are asked for: some 2 kB each, which a browser reads in one go.
inline constexpr std::int64_t most_played = 4000;

}  // namespace gradus
