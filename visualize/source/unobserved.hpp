#pragma once
// A header of the catalogue without what only an observer needs.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::source {

/// A part of a plain header: some file's text, and the steps that it declared to its observers.
struct Unwatched {
  std::string text;
  std::vector<std::string> steps;  ///< names of types, which may be of no more use
};

/// A source file without observers: no function takes one, hands one on or tells it a step, no template is
/// one over its type, and no comment speaks of steps. What became no template any more is inline.
/// Domain: files of algorithms/, in the project's format. Cost: O(length^2) characters at worst, a few ms.
Unwatched without_observers(std::string_view text);

/// The types among `names` that a text declares at the outermost level of a namespace.
std::vector<std::string> declared_in(std::string_view text, const std::vector<std::string>& names);

/// The text without the declaration of that type, and without the comment right above it.
std::string without_type(std::string_view text, std::string_view name);

/// Whether the text uses the name otherwise than within its declaration.
bool uses(std::string_view text, std::string_view name);

/// Whether an observer is left in the code of a text.
bool is_watched(std::string_view text);

}  // namespace gradus::source
