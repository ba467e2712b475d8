// `gradus`: reads the command line, does the command, turns what goes wrong into one line and an exit code.

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "core/contract.hpp"
#include "core/image.hpp"
#include "core/shown.hpp"

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
  return again(request);
}

/// One line, whatever the text holds.
int complain(std::string text, int code) {
  std::ranges::replace(text, '\n', ' ');
  note(alarming("gradus:", use_color(Color::automatic, Stream::err)) + " " + visible(text));
  return code;
}

int guarded(const std::vector<std::string>& words) {
  try {
    return perform(read_request(words));
  } catch (const UsageError& error) {
    return complain(error.what(), 2);
  } catch (const ArgumentError& error) {
    return complain(fmt::format("--{}: {}", hyphened(error.parameter), error.what()), 2);
  } catch (const InputError& error) {
    return complain(error.what(), 2);
  } catch (const OutputClosed&) {
    return 1;
  } catch (const std::bad_alloc&) {
    return complain("out of memory", 1);
  } catch (const std::exception& error) {
    return complain(error.what(), 1);
  }
}

}  // namespace
}  // namespace gradus::cli

int main(int argc, char** argv) {
  gradus::cli::prepare_process();
  return gradus::cli::guarded({argv + std::min(argc, 1), argv + argc});
}
