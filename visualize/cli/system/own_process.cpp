#include "cli/system/own_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <string_view>

#include "cli/command_line/errors.hpp"
#include "cli/system/descriptor.hpp"

namespace gradus::cli {
namespace {

void limit_to(int resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

/// What this process has of memory, in bytes.
rlim_t memory_now() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// What the copy does before its work.
void restrain(const ProcessLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // A library that finds its memory broken would say so on the terminal
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  limit_to(RLIMIT_CORE, 0);
  limit_to(RLIMIT_CPU, limits.seconds);
  limit_to(RLIMIT_AS, memory_now() + limits.bytes);
}

/// Never returns: destructors, and what stands in buffers, are the original's.
[[noreturn]] void work_and_end(const std::function<std::string()>& work, const ProcessLimits& limits,
                               int to) {
  int code = 1;
  try {
    restrain(limits);
    const std::string bytes = work();
    std::string_view rest = bytes;
    while (!rest.empty()) {
      const ssize_t count = write(to, rest.data(), rest.size());
      if (count < 0 && errno != EINTR) break;
      if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
    }
    code = rest.empty() ? 0 : 1;
  } catch (...) {
    // The code tells
  }
  _exit(code);
}

std::string all_of(int from) {
  std::string bytes;
  std::array<char, 1 << 16> block{};
  while (true) {
    const ssize_t count = read(from, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(count));
  }
}

int status_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void no_process() {
  const int reason = errno;
  throw WorkError(fmt::format("can't start another process: {}", std::strerror(reason)));
}

}  // namespace

ProcessResult in_own_process(const std::function<std::string()>& work, const ProcessLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) no_process();
  Descriptor from(ends[0]), to(ends[1]);
  const pid_t copy = fork();
  if (copy < 0) no_process();
  if (copy == 0) work_and_end(work, limits, to.number());
  to.close();
  ProcessResult result{ProcessResult::End::whole, all_of(from.number())};
  const int status = status_of(copy);
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    result.end = ProcessResult::End::too_much;
  } else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    result.end = ProcessResult::End::crashed;
  }
  return result;
}

}  // namespace gradus::cli
