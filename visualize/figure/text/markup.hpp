#pragma once
// Texts inside SVG and HTML.

#include <string>
#include <string_view>

namespace gradus {

/// A text for XML or HTML, in an element or in a quoted attribute: markup escaped; what XML can't hold
/// (control characters but tab and line ends, broken UTF-8) as U+FFFD.
std::string escaped(std::string_view text);

/// Bytes as a data: address has them.
std::string base64(std::string_view bytes);

}  // namespace gradus
