#pragma once
// How a command ends when it can't do what was asked. Each becomes one line on stderr.

#include <exception>
#include <stdexcept>

#include "core/refusal.hpp"
#include "request/complaint.hpp"

namespace gradus::cli {

/// The user's input is wrong: names the argument, says what was expected and what was found. Exit code 2.
using gradus::UsageError;

/// The input is right and the work failed: a full disk, a folder without permission. Exit code 1.
class WorkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The reader of our output has closed it (`gradus list | head -1`): nothing to report. Exit code 1.
class OutputClosed : public std::exception {};

}  // namespace gradus::cli
