// How long short commands take from their start to their end, beside a program that does nothing.

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"

namespace gradus::bench {
namespace {

/// The command that lies beside this program.
std::string gradus_command() {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "gradus").string();
}

/// Runs a program to its end; what it prints is dropped. Throws std::runtime_error where it fails.
void run_to_end(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int status = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (status == 0 && waitpid(child, &status, 0) != child) status = -1;
  if (status != 0) throw std::runtime_error(fmt::format("{} can't be run", words[0]));
}

std::vector<Case> cases() {
  const std::string gradus = gradus_command();
  std::vector<Case> all;
  const auto add = [&all](const char* name, Standing standing, const std::vector<std::string>& words) {
    all.push_back({.method = name, .standing = standing, .workload = {"from start to end"}, .run = [words] {
                     run_to_end(words);
                   }});
  };
  add("gradus --version", Standing::taught, {gradus, "--version"});
  add("gradus list", Standing::taught, {gradus, "list"});
  add("gradus run bresenham_line", Standing::taught, {gradus, "run", "bresenham_line"});
  add("gradus figure bresenham_line", Standing::taught, {gradus, "figure", "bresenham_line", "-o", "-"});
  add("true", Standing::peer, {"/bin/true"});
  return all;
}

}  // namespace

Subject start() { return {.topic = "start", .title = "Short commands", .item = "start", .cases = cases}; }

}  // namespace gradus::bench
