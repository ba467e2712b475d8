#pragma once
// Formulas that a page's sentences write in plain letters, "p = 3 - 2 r", set as formulas are.

#include <string>
#include <string_view>

namespace gradus {

/// The text as HTML: variables in italics with their numbers below, minus signs, exponents above, and the
/// dash of a segment from (0,0) to (5,2). Words, hyphens and units stay what they are.
std::string set_prose(std::string_view text);

}  // namespace gradus
