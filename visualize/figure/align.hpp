#pragma once
// On which side of a text its place is.

#include <cstdint>

namespace gradus {

enum class Align : std::uint8_t { left, centre, right };

}  // namespace gradus
