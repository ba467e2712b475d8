#pragma once
// Names as people type them: hyphen = underscore, upper = lower case, a unique beginning is enough, and an
// unknown name gets the nearest one.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gradus {

/// Standard output or standard input, where a file's name is expected.
inline constexpr std::string_view dash = "-";

/// Lower case with underscores: the form in which names are compared.
std::string folded(std::string_view name);
/// The form in which flags are shown: "x_axis" -> "x-axis".
std::string hyphened(std::string_view name);

/// Insertions, deletions, replacements and swaps of neighbours that turn one name into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name nearest to this word, if any is near enough to be meant.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names);

/// What a word names in a list: an exact name before a beginning, of several names one that all others begin
/// with; several only when it is ambiguous.
std::vector<std::size_t> matching_names(std::string_view word, std::span<const std::string> names);

/// Position of the one name that is meant. Throws UsageError: "<what>: expected one of …, found 'x' (did you
/// mean …?)".
std::size_t choose_name(std::string_view what, std::string_view word, std::span<const std::string> names);

/// The same for the value of a flag, "theme".
std::size_t choose_value(std::string_view flag, std::string_view word, std::span<const std::string> names);

/// For callers that word their own error: ", did you mean 'x'?", or nothing.
std::string suggestion(std::string_view word, std::span<const std::string> names);

/// Whether a name matches a shell pattern like "circle*"; hyphen = underscore in both.
bool matches_glob(std::string_view pattern, std::string_view name);

/// "3 faces", "1 face".
std::string counted(std::int64_t count, std::string_view what);

/// A value as a POSIX shell would need it: quoted only where it must be.
std::string shell_quoted(std::string_view value);
/// "--theme dark", and "--title=--odd" where the value would be taken for a flag.
std::string flag_with(std::string_view flag, std::string_view value);
/// The words of a command line as shell_quoted wrote them. Nothing when a quote is left open.
std::optional<std::vector<std::string>> shell_words(std::string_view line);

}  // namespace gradus
