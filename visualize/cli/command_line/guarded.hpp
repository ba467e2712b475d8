#pragma once
// What goes wrong in a command, as one line on stderr and an exit code.

#include <functional>
#include <string>

namespace gradus::cli {

/// What `work` returns; 2 when the user's input is wrong, 1 when the work failed. `program` begins the line.
int guarded(const std::string& program, const std::function<int()>& work);

}  // namespace gradus::cli
