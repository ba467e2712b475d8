#include "cli/files/leftovers.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>

#include "cli/files/files.hpp"
#include "request/fingerprint.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".gradus.", suffix = ".tmp";
constexpr std::chrono::hours longest_work{7 * 24};

std::string text_in(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Processes that have this in common see each other under the same numbers: the machine, its running since
/// it was started, the container. Empty where the system doesn't tell.
std::string host_name() {
  std::error_code error;
  const std::string numbers = fs::read_symlink("/proc/self/ns/pid", error).string();
  const std::string boot = text_in("/proc/sys/kernel/random/boot_id");
  utsname names{};
  if (numbers.empty() || boot.empty() || uname(&names) != 0) return "";
  return fingerprint(fmt::format("{} {} {}", names.nodename, boot, numbers))
      .substr(std::string_view("fnv1a:").size());
}

/// When a process began, in ticks since the system did: the 22nd word of its stat; empty when it is not told.
/// The second word is the program's name in parentheses, of any characters.
std::string start_of(pid_t process) {
  const std::string stat = text_in(fmt::format("/proc/{}/stat", process));
  const std::size_t name_end = stat.rfind(')');
  if (name_end == std::string::npos) return "";
  std::istringstream words(stat.substr(name_end + 1));
  std::string word;
  for (int i = 3; i <= 22; ++i) words >> word;
  return words ? word : "";
}

struct Writer {
  std::string host, start;
  pid_t process;
};

const Writer& myself() {
  static const Writer writer{host_name(), start_of(getpid()), getpid()};
  return writer;
}

/// Who writes the file of this name; nothing for a name that is not made by temporary_name().
std::optional<Writer> writer_of(std::string_view name) {
  name.remove_prefix(prefix.size());
  const std::size_t first = name.find('-'), second = name.find('-', first + 1),
                    third = name.find('-', second + 1);
  if (first == name.npos || second == name.npos || third == name.npos) return std::nullopt;
  Writer writer{std::string(name.substr(0, first)), std::string(name.substr(second + 1, third - second - 1)),
                0};
  const auto [end, error] = std::from_chars(name.data() + first + 1, name.data() + second, writer.process);
  if (error != std::errc() || end != name.data() + second || writer.process <= 0) return std::nullopt;
  return writer;
}

/// Whether it is certain that a process of this host has ended. Its number may be another's by now.
bool has_ended(const Writer& writer) {
  if (kill(writer.process, 0) != 0) return errno == ESRCH;
  const std::string start = start_of(writer.process);
  return !start.empty() && !writer.start.empty() && start != writer.start;
}

bool is_old(const struct stat& file) {
  const auto age = std::chrono::system_clock::now() - std::chrono::system_clock::from_time_t(file.st_mtime);
  return age > longest_work;
}

bool is_leftover(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return false;
  struct stat state{};
  if (lstat(file.c_str(), &state) != 0 || !S_ISREG(state.st_mode)) return false;
  const auto writer = writer_of(name);
  const bool known = writer && !writer->host.empty() && writer->host == myself().host;
  return known ? has_ended(*writer) : is_old(state);
}

/// Whether nobody has asked before.
bool is_new(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> known;
  const std::lock_guard lock(mutex);
  return known.insert(folder).second;
}

}  // namespace

std::string temporary_name() {
  static std::atomic<unsigned> counter = 0;
  return fmt::format("{}{}-{}-{}-{}{}", prefix, myself().host, myself().process, myself().start, counter++,
                     suffix);
}

void remove_leftovers(const fs::path& folder) {
  if (!is_new(folder)) return;
  std::error_code error;
  fs::directory_iterator entries(folder.empty() ? fs::path(".") : folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    if (is_leftover(entries->path())) unlink(entries->path().c_str());
  }
}

}  // namespace gradus::cli
