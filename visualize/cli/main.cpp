// `gradus`: reads the command line, does the command, turns what goes wrong into one line and an exit code.

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/guarded.hpp"

namespace gradus::cli {
namespace {

int perform(const Request& request) {
  if (request.has("version")) return version();
  if (request.has("help") || !request.command) return help(request);
  const std::string& name = request.command->name;
  if (name == "list") return list(request);
  if (name == "help") return help(request);
  if (name == "run") return run(request);
  if (name == "figure") return figure(request);
  if (name == "figures") return figures(request);
  if (name == "render") return render(request);
  if (name == "bench" || name == "stress") return hand_over(request);
  return again(request);
}

}  // namespace
}  // namespace gradus::cli

int main(int argc, char** argv) {
  gradus::cli::prepare_process();
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  return gradus::cli::guarded("gradus",
                              [&] { return gradus::cli::perform(gradus::cli::read_request(words)); });
}
