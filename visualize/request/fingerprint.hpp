#pragma once
// What tells contents apart.

#include <string>
#include <string_view>

namespace gradus {

/// A short fingerprint of contents: FNV-1a, 64 bits, "fnv1a:0123456789abcdef". Finds what has changed; it
/// does not defend against forgery.
std::string fingerprint(std::string_view bytes);

}  // namespace gradus
