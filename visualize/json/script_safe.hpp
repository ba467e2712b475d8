#pragma once
// JSON that may stand in a page.

#include <string>

namespace gradus {

/// Makes JSON safe inside a <script> element too: no "</", "<!" or "<script" is left, no line separator of
/// JavaScript, and no character that turns the direction of text. All of these can only stand inside string
/// literals, where an escape means the same.
std::string script_safe(const std::string& json);

}  // namespace gradus
