// `gradus list`: what there is.

#include <fmt/format.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "json/json.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {
namespace {

bool mentions(std::string_view text, std::string_view word) {
  return folded(text).find(folded(word)) != std::string::npos;
}

bool is_about(const TopicEntry& topic, std::string_view word) {
  return mentions(topic.name, word) || mentions(topic.title, word) ||
         std::ranges::any_of(topic.aliases,
                             [word](const std::string& alias) { return mentions(alias, word); });
}

std::vector<const TopicEntry*> topics_about(std::string_view word) {
  std::vector<const TopicEntry*> topics;
  for (const TopicEntry* topic : catalogue()) {
    if (is_about(*topic, word)) topics.push_back(topic);
  }
  return topics;
}

std::string table(std::span<const TopicEntry* const> topics, bool color) {
  std::size_t width = 0;
  for (const TopicEntry* topic : topics) width = std::max(width, topic->name.size());
  std::string text, chapter;
  for (const TopicEntry* topic : topics) {
    if (topic->chapter != chapter) text += (text.empty() ? "" : "\n") + bold(topic->chapter, color) + "\n";
    chapter = topic->chapter;
    const std::string gap(width - topic->name.size() + 2, ' ');
    text += fmt::format("  {}{}{}: {}\n", topic->name, gap, topic->title, topic->summary);
  }
  return text;
}

/// What is no topic, for who looks for it here.
constexpr std::string_view note_on_models =
    "\nModels and scenes are drawn by another command: gradus render --help\n";

}  // namespace

int list(const Request& request) {
  const std::string word = request.operands.empty() ? "" : request.operands[0];
  const std::vector<const TopicEntry*> topics = topics_about(word);
  if (topics.empty() && !word.empty()) {
    throw UsageError(
        fmt::format("list: expected a word in the name, alias or title of a topic, found {}", shown(word)));
  }
  const bool color = use_color(request.color(), Stream::out);
  const std::string ending(word.empty() ? note_on_models : "");
  write_stream(Stream::out, request.has("json") ? list_json(topics)
                                                : wrapped(table(topics, color) + ending, request.width()));
  return 0;
}

}  // namespace gradus::cli
