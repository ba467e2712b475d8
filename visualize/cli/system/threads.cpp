#include "cli/system/threads.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>

#include "cli/command_line/errors.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
std::size_t usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const bool known = sched_getaffinity(0, sizeof set, &set) == 0;
  const std::size_t allowed = known ? static_cast<std::size_t>(CPU_COUNT(&set)) : 1;
  const char* granted = std::getenv("SLURM_CPUS_PER_TASK");
  const auto count = granted ? whole_number(granted) : std::nullopt;
  return count && *count > 0 ? std::min(allowed, static_cast<std::size_t>(*count)) : allowed;
}

std::size_t read_jobs(const Request& request) {
  const auto text = request.flags.find("jobs");
  if (text == request.flags.end()) return usable_cores();
  const auto count = whole_number(text->second);
  if (!count || *count < 1 || *count > 1024) {
    throw UsageError(
        fmt::format("--jobs: expected a whole number from 1 to 1024, found {}", shown(text->second)));
  }
  return static_cast<std::size_t>(*count);
}

}  // namespace gradus::cli
