// `gradus source`: the algorithm of a topic, to read or for one's own program.

#include <fmt/format.h>

#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "request/inputs.hpp"
#include "source/plain_header.hpp"

namespace gradus::cli {

int source(const Request& request) {
  const TopicEntry& topic = find_topic(request.operands.front());
  const source::Files& files = source::built_in_files();
  const std::string path = fmt::format("{}/{}", topic.chapter, topic.name);
  const std::string_view watched = source::watched_header(files, path);
  if (watched.empty()) {
    throw UsageError(fmt::format(
        "source: expected a topic with a header of its own, but {} chains those of others", topic.name));
  }
  const std::string text = request.has("plain") ? source::plain_header(files, path) : std::string(watched);
  const auto output = request.flags.find("output");
  const std::string target = output == request.flags.end() ? std::string(dash) : output->second;
  const Replace replace = replaces(request.has("force"));
  if (target != dash) check_output(target, {}, Replace::anything);
  write_output(target, text, replace);
  return 0;
}

}  // namespace gradus::cli
