#pragma once
// In whose words a run is told, as flags say it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/text/metrics.hpp"
#include "figure/text/wording.hpp"

namespace gradus {

/// Of a title, a caption or a name of one's own: figures set them in lines, and try widths for each.
inline constexpr std::size_t longest_text = 1000;
/// Code points of a text in UTF-8.
std::size_t letters_in(std::string_view text);
/// For messages about a longer one: "a text of up to 1000 letters", "one of 20000".
std::string expected_length();
std::string found_length(std::string_view text);

/// A text that figures will show: not empty, on one line, not too long, of letters that the fonts have.
/// Throws UsageError naming the flag.
std::string drawable(std::string_view flag, std::string_view text, Face face);

// --- Each takes what a flag says, and gives its canonical text: nothing for the default. They throw
// UsageError.

std::string read_language(Wording& wording, std::string_view text);
std::string read_numbers(Wording& wording, const std::string& text);

/// What is expected where a symbol of the topic is: "one of the symbols p, q", "no symbol, for painter has
/// none".
std::string expected_symbol(std::string_view topic);

/// Each "p=d": a symbol, and what the reader calls it. topic: whose symbols they are; "": of any. Throws
/// UsageError.
void apply_labels(Wording& wording, std::string_view topic, std::span<const std::string> given);

}  // namespace gradus
