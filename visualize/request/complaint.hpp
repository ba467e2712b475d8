#pragma once
// What is wrong with a request, in the words of its answer.

#include <string>
#include <string_view>

#include "core/refusal.hpp"

namespace gradus {

/// "--size: expected a ratio like 4:3, found 4". `found` is shown as it is. Throws UsageError.
[[noreturn]] void refuse_flag(std::string_view flag, const std::string& expected, std::string_view found);

/// "--from: expected …": the parameter's flag, and what is wrong with its argument.
std::string complaint_of(std::string_view parameter, std::string_view what);
/// The same of an argument that can't be taken.
std::string complaint_of(const ArgumentError& error);
/// What a refusal of any kind says, on one line.
std::string complaint_of(const Refusal& refusal);

/// A text on one line, with all visible that would move a cursor.
std::string on_one_line(std::string text);

}  // namespace gradus
