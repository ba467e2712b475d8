#pragma once
// Numbers in the bytes of binary files.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gradus::pipeline {

/// The whole number without a sign in `size` bytes, the least significant one first.
/// Domain: at + size <= bytes.size(), size up to 8.
inline std::uint64_t whole_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = size; i > 0; --i) number = number << 8 | static_cast<unsigned char>(bytes[at + i - 1]);
  return number;
}

/// The float in 4 bytes, as IEEE 754 has it. Domain: as above.
inline float float_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(whole_at(bytes, at, 4)));
}

}  // namespace gradus::pipeline
