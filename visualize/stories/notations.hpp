#pragma once
// The notations of well-known books.

#include <span>
#include <string_view>

#include "figure/text/notation.hpp"

namespace gradus {

/// All of them. Where a book says nothing of something, its notation leaves that as in the code;
/// docs/notation.md tells what each has.
std::span<const Notation> notations();

/// The notation of that name, or nullptr.
const Notation* find_notation(std::string_view name);

}  // namespace gradus
