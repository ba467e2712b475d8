#pragma once
// What the two streams are connected to: decides on colour and progress bars.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gradus::cli {

enum class Color { automatic, always, never };

/// "auto", "always", "never", or a unique beginning. Throws UsageError.
Color read_color(std::string_view text);

/// Empty: there is none.
std::string environment(const char* name);

enum class Stream { out = 1, err = 2 };
bool is_terminal(Stream stream);

/// The flag beats the environment: NO_COLOR, then CLICOLOR_FORCE or FORCE_COLOR, then TERM=dumb, then whether
/// the stream is a terminal.
bool use_color(Color wanted, Stream stream);

/// Whether a bar that redraws itself can be shown.
bool can_redraw(Stream stream);
/// Columns of the terminal; 80 where that is unknown.
int columns(Stream stream);
/// How long the lines of standard output may be: what was asked for ("72"; empty: nothing was), else what the
/// environment's COLUMNS says, else the terminal's width. 0: as long as they are, in a pipe or a file. Throws
/// UsageError for a width that is none.
std::size_t output_width(std::string_view wanted);

/// Text in bold, where colour is on.
std::string bold(std::string_view text, bool color);
/// Text in red and bold, where colour is on.
std::string alarming(std::string_view text, bool color);

}  // namespace gradus::cli
