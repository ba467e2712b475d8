#pragma once
// Bytes packed by zlib.

#include <string>
#include <string_view>

namespace gradus {

/// The bytes in zlib's format (RFC 1950), as small as it makes them.
/// Throws std::runtime_error when there is no memory for it.
std::string deflated(std::string_view bytes);

}  // namespace gradus
