#include "cli/errors.hpp"

#include <fmt/format.h>

namespace gradus::cli {

void refuse_flag(std::string_view flag, const std::string& expected, std::string_view found) {
  throw UsageError(fmt::format("--{}: expected {}, found {}", flag, expected, found));
}

}  // namespace gradus::cli
