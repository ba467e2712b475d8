#include "cli/files/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "cli/command_line/errors.hpp"
#include "cli/files/leftovers.hpp"
#include "cli/files/own_files.hpp"
#include "cli/system/descriptor.hpp"
#include "cli/terminal/status_line.hpp"
#include "scene/files.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// False with errno set when not everything could be written.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

[[noreturn]] void cannot_write(const std::string& path) {
  const int reason = errno;
  throw WorkError(fmt::format("can't write {}: {}", shown(path), std::strerror(reason)));
}

// --- Incomplete files, to be removed when the program is stopped ---------------------------------

struct Incomplete {
  std::mutex mutex;
  std::set<std::string> paths;
};
/// Never destroyed: the thread that waits for signals may use it until the very end.
Incomplete& incomplete() {
  static auto* files = new Incomplete;
  return *files;
}

/// A new file that is known to be incomplete from its first moment: no signal comes between.
int open_incomplete(const std::string& path) {
  const std::lock_guard lock(incomplete().mutex);
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) incomplete().paths.insert(path);
  return descriptor;
}

void forget(const std::string& path) {
  const std::lock_guard lock(incomplete().mutex);
  incomplete().paths.erase(path);
}

[[noreturn]] void stop(int signal) {
  incomplete().mutex.lock();  // and never unlocked: nobody makes another file now
  for (const std::string& path : incomplete().paths) unlink(path.c_str());
  StatusLine::only().leave();
  _exit(128 + signal);
}

/// A signal that was ignored from the start (nohup, a background job) stays so.
bool heeded(int signal) {
  struct sigaction action{};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN;
}

void wait_for_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (heeded(signal)) sigaddset(&signals, signal);
  }
  // Blocked here and so in every thread started later: one thread alone receives them, and may do what no
  // signal handler may
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    while (sigwait(&signals, &signal) != 0) {
    }
    stop(signal);
  }).detach();
}

/// The file that a link leads to, so that the link itself is not replaced; it need not be there. Sets errno
/// and returns nothing for links that go round in a circle.
std::optional<std::string> behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as in the kernel
  std::filesystem::path at = path;
  for (int i = 0; i < most_links; ++i) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::read_symlink(at, error);
    if (error) return at.string();
    at = at.parent_path() / target;
  }
  errno = ELOOP;
  return std::nullopt;
}

/// The one name of the file that will be written: without links, dots and double slashes.
std::filesystem::path destination_of(const std::string& path) {
  std::error_code error;
  const auto target = std::filesystem::absolute(behind_links(path).value_or(path));
  const std::filesystem::path known = std::filesystem::weakly_canonical(target, error);
  return error ? target.lexically_normal() : known;
}

/// Throws WorkError, before work that would be lost, when the system will not let this file be written.
void check_writable(const std::string& path) {
  struct stat known{};
  const auto target = behind_links(path);
  if (!target) cannot_write(path);
  const bool in_place = stat(path.c_str(), &known) == 0 && !S_ISREG(known.st_mode);
  const std::string folder = std::filesystem::path(*target).parent_path().string();
  const std::string asked = in_place ? *target : folder.empty() ? std::string(".") : folder;
  if (faccessat(AT_FDCWD, asked.c_str(), W_OK, AT_EACCESS) != 0) cannot_write(path);
}

/// Opens a new file beside `path`.
int open_beside(const std::string& path, std::string& temporary) {
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  remove_leftovers(folder);
  while (true) {
    temporary = folder + temporary_name();
    const int descriptor = open_incomplete(temporary);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

void write_in_place(const std::string& path, std::string_view bytes) {
  Descriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0 || !write_all(file.number(), bytes) || !file.close()) cannot_write(path);
}

std::string read_standard_input(std::string_view what) {
  std::string bytes;
  char block[1 << 16];
  while (true) {
    const ssize_t count = read(STDIN_FILENO, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int reason = errno;
      throw UsageError(fmt::format("{}: expected a readable file, found standard input ({})", what,
                                   std::strerror(reason)));
    }
    if (count == 0) return bytes;
    if (bytes.size() + static_cast<std::size_t>(count) > pipeline::most_file_bytes) {
      throw UsageError(fmt::format("{}: expected at most 256 MiB, found more in standard input", what));
    }
    bytes.append(block, static_cast<std::size_t>(count));
  }
}

}  // namespace

std::string read_input(const std::string& path, std::string_view what) {
  if (path == dash) {
    const bool typed = isatty(STDIN_FILENO) == 1;
    if (typed) StatusLine::only().hide(true);
    std::string bytes = read_standard_input(what);
    if (typed) StatusLine::only().hide(false);
    return bytes;
  }
  pipeline::FileRead file = pipeline::read_regular_file(path);
  if (!file.problem.empty()) throw UsageError(fmt::format("{}: {}", what, file.problem));
  return std::move(file.bytes);
}

void write_stream(Stream stream, std::string_view bytes) {
  int reason = 0;
  const auto write = [&] { reason = write_all(static_cast<int>(stream), bytes) ? 0 : errno; };
  if (is_terminal(stream)) {
    StatusLine::only().aside(write, bytes.ends_with('\n'));
  } else {
    write();
  }
  if (reason == 0) return;
  if (reason == EPIPE) throw OutputClosed();
  throw WorkError(fmt::format("can't write to standard output: {}", std::strerror(reason)));
}

void note(std::string_view line) {
  try {
    // One call per line: lines of several threads do not mix
    write_stream(Stream::err, std::string(line) + "\n");
  } catch (const std::exception&) {
    // A closed stderr is no reason to stop the work
  }
}

bool same_file(const std::string& a, const std::string& b) {
  struct stat first{}, second{};
  if (stat(a.c_str(), &first) != 0 || stat(b.c_str(), &second) != 0) {
    return destination_of(a) == destination_of(b);
  }
  return first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

void make_folder(const std::string& path, std::string_view what) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return;
  const bool in_the_way = std::filesystem::exists(path, ignored) || !error;
  if (in_the_way) throw UsageError(fmt::format("{}: expected a folder, found {}", what, shown(path)));
  throw UsageError(fmt::format("{}: expected a folder that can be made, found {} ({})", what, shown(path),
                               std::strerror(error.value())));
}

void check_replaced(const std::string& path, std::string_view what, std::string_view bytes) {
  if (is_replaceable(path, bytes)) return;
  if (access(path.c_str(), R_OK) != 0) {
    const int reason = errno;
    throw UsageError(
        fmt::format("{}: expected a file that can be read, to see whether gradus made it, found {} "
                    "({}; --force replaces it)",
                    what, shown(path), std::strerror(reason)));
  }
  throw UsageError(fmt::format(
      "{}: expected a new file or one that gradus made, found {} (--force replaces it)", what, shown(path)));
}

void check_output(const std::string& path, std::span<const std::string> inputs, Replace replace) {
  if (path == dash) return;
  std::error_code error;
  if (path.empty() || path.ends_with('/') || std::filesystem::is_directory(path, error)) {
    throw UsageError(fmt::format("-o: expected a file's name, found {}", shown(path)));
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    throw UsageError(fmt::format("-o: expected a folder that exists, found {}", shown(folder.string())));
  }
  for (const std::string& input : inputs) {
    if (input == dash || !same_file(path, input)) continue;
    throw UsageError(fmt::format("-o: expected another file than the input, found {}", shown(path)));
  }
  if (replace == Replace::own) check_replaced(path, "-o");
  check_writable(path);
}

NewFiles::~NewFiles() {
  for (const Pending& file : pending_) {
    unlink(file.temporary.c_str());
    forget(file.temporary);
  }
}

void NewFiles::add(const std::string& path, std::string_view bytes, Replace replace) {
  struct stat known{};
  const bool exists = stat(path.c_str(), &known) == 0;
  if (exists && !S_ISREG(known.st_mode)) return write_in_place(path, bytes);
  if (replace == Replace::own) check_replaced(path, "-o", bytes);
  const auto target = behind_links(path);
  if (!target) cannot_write(path);
  if (!destinations_.insert(destination_of(*target)).second) {
    throw UsageError(
        fmt::format("-o: expected different files, found {}, which leads to another's place", shown(path)));
  }
  std::string temporary;
  Descriptor file(open_beside(*target, temporary));
  if (file.number() < 0) cannot_write(path);
  pending_.push_back({temporary, *target});
  if (exists) static_cast<void>(fchmod(file.number(), known.st_mode & 07777));
  if (!write_all(file.number(), bytes) || !file.close()) cannot_write(path);
}

void NewFiles::commit() {
  // No signal to end the program comes between two of them
  const std::lock_guard lock(incomplete().mutex);
  // Names are given with nothing between: what kills the process there, as nothing can prevent, finds it
  // seldom
  std::vector<Old> olds;
  for (const Pending& file : pending_) olds.push_back(pending_.size() == 1 ? Old{} : keep_old(file.path));
  for (std::size_t done = 0; done < pending_.size(); ++done) {
    const Pending& file = pending_[done];
    if (rename(file.temporary.c_str(), file.path.c_str()) == 0) continue;
    const int reason = errno;
    const std::string remaining = take_back(olds, done);
    throw WorkError(fmt::format("can't write {}: {}{}", shown(file.path), std::strerror(reason), remaining));
  }
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    incomplete().paths.erase(pending_[i].temporary);
    drop(olds[i]);
  }
  pending_.clear();
}

NewFiles::Old NewFiles::keep_old(const std::string& path) {
  Old old;
  const std::string name = path.substr(0, path.find_last_of('/') + 1) + temporary_name();
  incomplete().paths.insert(name);
  if (link(path.c_str(), name.c_str()) == 0) {
    old.kept = name;
  } else {
    old.none = errno == ENOENT;
    incomplete().paths.erase(name);
  }
  return old;
}

void NewFiles::drop(const Old& old) {
  if (old.kept.empty()) return;
  unlink(old.kept.c_str());
  incomplete().paths.erase(old.kept);
}

std::string NewFiles::take_back(const std::vector<Old>& olds, std::size_t done) {
  for (std::size_t i = done; i < olds.size(); ++i) drop(olds[i]);  // these have no new file
  std::vector<std::string> remaining;
  for (std::size_t i = 0; i < done; ++i) {
    const auto& [kept, none] = olds[i];
    const std::string& path = pending_[i].path;
    if (!kept.empty() && rename(kept.c_str(), path.c_str()) == 0) {
      incomplete().paths.erase(kept);
    } else if (!none || unlink(path.c_str()) != 0) {
      remaining.push_back(shown(path));
    }
  }
  if (remaining.empty()) return done > 0 ? "; the others stay as they were" : "";
  constexpr std::size_t most = 3;
  const std::size_t more = remaining.size() - std::min(remaining.size(), most);
  remaining.resize(remaining.size() - more);
  return fmt::format("; new already: {}{}", fmt::join(remaining, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

void write_output(const std::string& path, std::string_view bytes, Replace replace) {
  if (path == dash) return write_stream(Stream::out, bytes);
  NewFiles files;
  files.add(path, bytes, replace);
  files.commit();
}

void prepare_process() {
  // A file opened later must not get the number of a closed standard stream. Standard output is opened for
  // reading: writing to it fails as it should
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    static_cast<void>(open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY));
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // writing says then that the file is too large
  wait_for_signals();
}

}  // namespace gradus::cli
