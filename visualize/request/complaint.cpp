#include "request/complaint.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/shown.hpp"
#include "request/names.hpp"

namespace gradus {

void refuse_flag(std::string_view flag, const std::string& expected, std::string_view found) {
  refuse_usage(fmt::format("--{}: expected {}, found {}", flag, expected, found));
}

std::string complaint_of(std::string_view parameter, std::string_view what) {
  return fmt::format("--{}: {}", hyphened(parameter), what);
}

std::string complaint_of(const ArgumentError& error) { return complaint_of(error.parameter, error.what()); }

std::string complaint_of(const Refusal& refusal) {
  const bool of_argument = refusal.kind == Refusal::Kind::argument;
  return on_one_line(of_argument ? complaint_of(refusal.parameter, refusal.text) : refusal.text);
}

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return visible(text);
}

}  // namespace gradus
