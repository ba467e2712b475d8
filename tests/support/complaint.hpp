#pragma once
// What the command complains of.

#include <functional>
#include <string>

#include "cli/command_line/errors.hpp"

namespace gradus::test {

inline std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const UsageError& error) {
    return error.what();
  } catch (const cli::WorkError& error) {
    return std::string("work: ") + error.what();
  }
  return "(no complaint)";
}

}  // namespace gradus::test
