#include "cli/film/ffmpeg.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "cli/command_line/errors.hpp"

extern char** environ;

namespace gradus::cli {
namespace {

constexpr int output_number = 3, palette_number = 4;  ///< in the child, as Ffmpeg::output and ::palette say

[[noreturn]] void cannot(std::string_view what) {
  const int reason = errno;
  throw WorkError(fmt::format("film: can't {}: {}", what, std::strerror(reason)));
}

/// A copy out of the way of the numbers that files get in the child, and not inherited by other programs.
Descriptor apart(int number) {
  constexpr int least = 16;
  Descriptor copy(fcntl(number, F_DUPFD_CLOEXEC, least));
  // Where fewer files may be open than that, it calls the number invalid
  if (copy.number() < 0 && errno == EINVAL) errno = EMFILE;
  if (copy.number() < 0) cannot("open a file");
  return copy;
}

std::string contents(const Descriptor& file) {
  std::string bytes;
  char block[1 << 16];
  while (true) {
    const ssize_t count = pread(file.number(), block, sizeof block, static_cast<off_t>(bytes.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot("read what ffmpeg has written");
    if (count == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(count));
  }
}

struct SpawnSettings {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  SpawnSettings() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
};

}  // namespace

Descriptor nameless_file(std::string_view contents) {
  std::FILE* file = std::tmpfile();
  if (!file) cannot("make a temporary file");
  const bool written =
      std::fwrite(contents.data(), 1, contents.size(), file) == contents.size() && std::fflush(file) == 0;
  Descriptor copy = apart(fileno(file));
  std::fclose(file);
  if (!written) cannot("write a temporary file");
  return copy;
}

Ffmpeg::Ffmpeg(std::vector<std::string> words, const Descriptor& palette_file)
    : output_(nameless_file()), complaints_(nameless_file()) {
  int ends[2];
  // An end that leaked into a child would keep the pipe open for ever
  if (pipe2(ends, O_CLOEXEC) != 0) cannot("make a pipe");
  const Descriptor read_end(ends[0]), write_end(ends[1]);
  frames_ = apart(write_end.number());
  start(std::move(words), apart(read_end.number()), palette_file);
}

Ffmpeg::~Ffmpeg() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  wait();
}

bool Ffmpeg::take(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(frames_.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EPIPE) return false;
    if (count < 0) cannot("hand frames to ffmpeg");
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

std::string Ffmpeg::finish() {
  frames_.close();
  const int status = wait();
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return contents(output_);
  throw WorkError(fmt::format("film: ffmpeg failed: {}", reason(status)));
}

void Ffmpeg::start(std::vector<std::string> words, const Descriptor& frames, const Descriptor& palette_file) {
  words.insert(words.begin(), {"ffmpeg", "-v", "error", "-y"});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  SpawnSettings settings;
  const auto give = [&settings](const Descriptor& file, int number) {
    if (file.number() >= 0) posix_spawn_file_actions_adddup2(&settings.files, file.number(), number);
  };
  give(frames, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&settings.files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  give(complaints_, STDERR_FILENO);
  give(output_, output_number);
  give(palette_file, palette_number);
  // Signals are blocked here, so that one thread alone receives them, and SIGPIPE is ignored: not so there
  sigset_t none, usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  posix_spawnattr_setsigmask(&settings.attributes, &none);
  posix_spawnattr_setsigdefault(&settings.attributes, &usual);
  posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, "ffmpeg", &settings.files, &settings.attributes, arguments.data(), environ);
  if (error == 0) process_ = process;
  if (error == ENOENT) {
    throw WorkError("film: expected the program ffmpeg on the PATH (Debian: apt install ffmpeg), found none");
  }
  if (error != 0) throw WorkError(fmt::format("film: can't start ffmpeg: {}", std::strerror(error)));
}

int Ffmpeg::wait() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  return status;
}

std::string Ffmpeg::reason(int status) const {
  const std::string text = contents(complaints_);
  const std::string line = text.substr(0, text.find('\n'));
  if (!line.empty()) return line;
  return WIFSIGNALED(status) ? fmt::format("stopped by signal {}", WTERMSIG(status))
                             : fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace gradus::cli
