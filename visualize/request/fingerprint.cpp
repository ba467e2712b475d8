#include "request/fingerprint.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace gradus {

std::string fingerprint(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return fmt::format("fnv1a:{:016x}", hash);
}

}  // namespace gradus
