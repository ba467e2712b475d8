#pragma once
// Texts made safe for what they are pasted into.

#include <string>
#include <string_view>

namespace gradus {

/// For LaTeX's text mode under any engine: its special characters, and the signs that figures use (−, ·, ≤
/// …), become commands. Other letters stay as they are (UTF-8).
std::string latex_escaped(std::string_view text);

/// A table's cell for LaTeX: what is a formula (numbers, signs, names of one letter) in math mode, words as
/// latex_escaped() has them: "p > 0, east" becomes "$p > 0$, east".
std::string latex_cell(std::string_view text);

/// A file's name for LaTeX: a character that LaTeX would act on becomes the macro that expands to that very
/// character, wherever a name is expanded (of LaTeX's kernel from 2020 on).
std::string latex_path(std::string_view path);

/// For Markdown (CommonMark, also inside a table's cell): every character with a meaning gets a backslash.
std::string markdown_escaped(std::string_view text);

}  // namespace gradus
