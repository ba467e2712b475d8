// `gradus`: reads the command line, does the command, turns what goes wrong into one line and an exit code.

#include <algorithm>

#include "cli/command_line/guarded.hpp"
#include "cli/commands/commands.hpp"
#include "cli/completion/complete.hpp"
#include "cli/files/files.hpp"
#include "cli/terminal/progress.hpp"

namespace gradus::cli {
namespace {

/// What shells ask at every press of the tab key: the words behind -- are not the user's command yet, and may
/// be anything.
bool asks_what_is_next(const std::vector<std::string>& words) {
  return words.size() > 2 && words[0] == "completion" && words[1] == "--next" && words[2] == "--";
}

int perform(const std::vector<std::string>& words) {
  if (asks_what_is_next(words)) return complete_next({words.begin() + 3, words.end()});
  const Request request = read_request(words);
  if (request.has("version")) return version();
  if (request.has("help") || !request.command) return help(request);
  const std::string& name = request.command->name;
  if (name == "list") return list(request);
  if (name == "help") return help(request);
  if (name == "bench" || name == "stress") return hand_over(request);
  if (name == "completion") return completion(request);
  if (name == "man") return manual(request);
  if (name == "inspect") return inspect(request);
  if (name == "open") return open_gallery(request);
  const Working working(name + (request.topic ? " " + request.topic->name : ""), request.quiet());
  if (name == "run") return run(request);
  if (name == "figure") return figure(request);
  if (name == "source") return source(request);
  if (name == "cases") return cases(request);
  if (name == "check") return check(request);
  if (name == "figures") return figures(request);
  if (name == "worksheet") return worksheet(request);
  if (name == "render") return render(request);
  if (name == "explain") return explain(request);
  if (name == "demo") return demo(request);
  return again(request);
}

}  // namespace
}  // namespace gradus::cli

int main(int argc, char** argv) {
  gradus::cli::prepare_process();
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  return gradus::cli::guarded("gradus", [&] { return gradus::cli::perform(words); });
}
