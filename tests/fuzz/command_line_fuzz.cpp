// Command lines, read as far as possible without running anything: a request and how its figure looks, or one
// clear line.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/figures/figure_spec.hpp"
#include "core/image.hpp"
#include "request/names.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

std::string no_file(const std::string&, const std::string& flag) {
  throw UsageError(flag + ": expected a file, found none");
}

/// Everything short of running the topic; and the command that the figure would carry says the same again.
void read_figure(const cli::Request& request) {
  for (const auto& [name, value] : request.arguments) {
    if (value.find('-') == 0 && value.size() == 1) return;  // standard input is nobody's here
  }
  const Inputs inputs = cli::read_inputs(*request.topic, request.arguments, no_file);
  const cli::FigureSpec spec = cli::read_spec(request, inputs.arguments);
  const std::string command = cli::command_of(spec);
  const auto words = shell_words(command);
  require(words && words->size() >= 3, "a command can be taken apart");
  cli::Request again;
  try {
    again = cli::read_request({words->begin() + 1, words->end()});
  } catch (const UsageError&) {
    require(false, "the command that a figure carries can be read");
  }
  require(again.topic == request.topic, "the command names the same topic");
  const Inputs same = cli::read_inputs(*again.topic, again.arguments, no_file);
  require(cli::command_of(cli::read_spec(again, same.arguments)) == command, "the command is its own");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // One word per line
  std::vector<std::string> words;
  std::string_view text(reinterpret_cast<const char*>(data), size);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    words.emplace_back(text.substr(0, end));
    // The system hands over words without zero bytes
    std::erase(words.back(), '\0');
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  std::string line = "gradus";
  for (const std::string& word : words) line += " " + shell_quoted(word);
  const auto apart = shell_words(line);
  require(apart && apart->size() == words.size() + 1 &&
              std::equal(words.begin(), words.end(), apart->begin() + 1),
          "words survive a shell");
  try {
    const cli::Request request = cli::read_request(words);
    if (request.topic && request.command && request.command->name == "figure") read_figure(request);
  } catch (const UsageError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  } catch (const ArgumentError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  } catch (const InputError& error) {
    require(test::harmless(error.what()), "an error is safe to show");
  }
  return 0;
}
