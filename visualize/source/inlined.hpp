#pragma once
// What stands in a .cpp file, to be put into a header.

#include <string>
#include <string_view>

namespace gradus::source {

/// The text with its functions and constants inline, and what it keeps to itself (its unnamed namespace) in a
/// namespace of that name. Domain: a .cpp file of algorithms/, in the project's format, without its
/// directives.
std::string inlined(std::string_view text, std::string_view own_namespace);

/// The text without functions that are declared and never defined in it, and the comments above those.
std::string without_bare_declarations(std::string_view text);

/// The text without functions whose head, from the start of a line to its body, names this type.
std::string without_functions_of(std::string_view text, std::string_view type);

}  // namespace gradus::source
