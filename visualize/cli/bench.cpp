// `gradus bench`: hands over to gradus-bench, which has the rivals linked and lies beside this program.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "cli/commands.hpp"
#include "cli/errors.hpp"

namespace gradus::cli {

int bench(const Request& request) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "gradus-bench";
  if (!std::filesystem::exists(program)) {
    throw WorkError("bench: gradus-bench is not beside this program; build it with `./bootstrap bench`");
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
  throw WorkError(fmt::format("bench: {} can't be run", program.string()));
}

}  // namespace gradus::cli
