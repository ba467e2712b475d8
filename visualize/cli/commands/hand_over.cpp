// `gradus bench` and `gradus stress`: done by programs of their own beside this one, which have rivals and
// oracles linked that the command does without.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"

namespace gradus::cli {

int hand_over(const Request& request) {
  const std::string& command = request.command->name;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / ("gradus-" + command);
  if (!std::filesystem::exists(program)) {
    throw WorkError(
        fmt::format("{0}: expected the program gradus-{0} beside this one, found none; in a clone of Gradus "
                    "`./bootstrap {0}` builds and runs it",
                    command));
  }
  std::vector<std::string> words{program.string()};
  for (const auto& [flag, value] : request.flags) {
    words.push_back(value.empty() ? "--" + flag : fmt::format("--{}={}", flag, value));
  }
  words.insert(words.end(), request.operands.begin(), request.operands.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  throw WorkError(fmt::format("{}: {} can't be run", command, program.string()));
}

}  // namespace gradus::cli
