#pragma once
// The colophon inside a file, as text.

#include <optional>
#include <string>
#include <string_view>

#include "figure/colophon.hpp"

namespace gradus {

/// The colophon as an XML element, for other files that hold a text: `colophon_in` finds it there.
std::string markup_of(const Colophon& colophon);

/// What a file of sheets, a player page or a film, says of itself; nothing when it says
/// nothing.
std::optional<Colophon> colophon_in(std::string_view file_bytes);

}  // namespace gradus
