#pragma once
// Telling what Gradus made from what others made, so that nobody's work is replaced without a word.

#include <string>
#include <string_view>

namespace gradus::cli {

/// Whether these are the bytes of a file that Gradus made: a figure, a page, a film or a rendered picture by
/// the metadata it carries, a zip by its comment, a table or report by its last line or its form. A file that
/// holds one of ours among other things (slides with a figure in them) is somebody's own.
bool made_by_gradus(std::string_view bytes);

/// Whether a new file may take the place of what is there: nothing, an empty file, what Gradus made, exactly
/// these bytes. A device or a pipe is written to, not replaced. A link stands for what it leads to.
bool is_replaceable(const std::string& path, std::string_view bytes = {});

/// The last line of a table in Markdown, LaTeX or plain text: how it was made, as a comment where there are
/// comments. `format`: "md", "tex", "txt".
std::string closing_line(std::string_view format, std::string_view command);

/// The first line of every page of the manual.
constexpr std::string_view manual_mark = ".\\\" Made by gradus man";

/// The comment of every zip.
std::string zip_comment();

}  // namespace gradus::cli
