#pragma once
// How large a figure is: what --size and --scale take.

#include <optional>
#include <string>
#include <string_view>

#include "cli/figures/figure_spec.hpp"

namespace gradus::cli {

/// A decimal number without an exponent, in a range.
std::optional<double> decimal(std::string_view text, double least, double most);

/// Each takes its flag's value and returns what the canonical command says of it, nothing for the default.
std::string read_size(FigureSpec& spec, const std::string& text);
std::string read_scale(FigureSpec& spec, const std::string& text);

}  // namespace gradus::cli
