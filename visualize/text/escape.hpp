#pragma once
// Texts made safe for what they are pasted into.

#include <string>
#include <string_view>

namespace gradus {

/// For LaTeX's text mode under any engine: its special characters, and the signs that figures use (−, ·, ≤
/// …), become commands. Other letters stay as they are (UTF-8).
std::string latex_escaped(std::string_view text);

/// For Markdown (CommonMark, also inside a table's cell): every character with a meaning gets a backslash.
std::string markdown_escaped(std::string_view text);

}  // namespace gradus
