#include "cli/command_line/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "cli/command_line/errors.hpp"
#include "request/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

bool is_long_flag(std::string_view word) { return word.starts_with("--") && word.size() > 2; }
/// What --compare takes in quotes: flags of the other side, as one word.
bool is_flags_in_one(std::string_view flag, std::string_view word) {
  return flag == "compare" && word.find(' ') != word.npos;
}
bool is_short_flag(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '-' && !('0' <= word[1] && word[1] <= '9');
}

/// A flag that may be meant, of any command or topic.
struct Known {
  std::string name;  ///< as compared: "at", "svg_text"
  std::string word;  ///< as the parser knows it: "at", "svg-text"
  bool takes_value;
  std::string expected;  ///< what its value should be like
};

void add_flags(std::vector<Known>& known, std::span<const Flag> flags) {
  for (const Flag& flag : flags) known.push_back({flag.name, flag.name, !flag.value.empty(), flag.value});
}

std::vector<Known> known_flags(const Command* command, const TopicEntry* topic) {
  std::vector<Known> known;
  if (topic) {
    for (const Parameter& p : topic->parameters) {
      const std::string flag = command ? parameter_flag(*command, p) : hyphened(p.name);
      known.push_back({folded(flag), flag, p.type != ParameterType::flag, expected_value(p)});
    }
    known.push_back({"method", "method", true, "a method's name"});
  }
  if (command) add_flags(known, command->flags);
  add_flags(known, common_flags());
  return known;
}

/// What stands before and after "=".
struct FlagWord {
  std::string name;
  std::optional<std::string> value;
};
FlagWord split(std::string_view word) {
  word.remove_prefix(2);
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) return {std::string(word), std::nullopt};
  return {std::string(word.substr(0, equals)), std::string(word.substr(equals + 1))};
}

/// Positions in `known` of the flags that a name may mean.
std::vector<std::size_t> meant(const std::vector<Known>& known, std::string_view name) {
  std::vector<std::string> names;
  for (const Known& flag : known) names.push_back(flag.name);
  return matching_names(name, names);
}

bool letter_takes_value(const Command* command, char letter) {
  const auto find = [letter](std::span<const Flag> flags) {
    const auto flag = std::ranges::find(flags, letter, &Flag::letter);
    return flag != flags.end() && !flag->value.empty();
  };
  return find(common_flags()) || (command && find(command->flags));
}

/// Where the next operand stands, from `at` on. Flags not known yet (a topic's, before the topic) have a
/// value.
std::size_t next_operand(const std::vector<std::string>& words, std::size_t at, const Command* command) {
  const std::vector<Known> known = known_flags(command, nullptr);
  for (; at < words.size(); ++at) {
    const std::string& word = words[at];
    if (word == "--") return at + 1;
    if (is_long_flag(word)) {
      const auto [name, value] = split(word);
      const auto matches = meant(known, name);
      const bool takes_value = matches.empty() || known[matches.front()].takes_value;
      if (takes_value && !value && at + 1 < words.size() && !is_long_flag(words[at + 1])) ++at;
    } else if (is_short_flag(word)) {
      if (word.size() == 2 && letter_takes_value(command, word[1])) ++at;
    } else {
      return at;
    }
  }
  return words.size();
}

[[noreturn]] void unknown_flag(const std::vector<Known>& known, const std::string& name,
                               const Spelled& spelled) {
  std::vector<std::string> names;
  for (const Known& flag : known) names.push_back("--" + hyphened(flag.name));
  const std::string whose = spelled.topic ? fmt::format("{} {}: ", spelled.command->name, spelled.topic->name)
                            : spelled.command ? spelled.command->name + ": "
                                              : "";
  const std::string meant = suggestion("--" + name, names);
  throw UsageError(fmt::format("{}unknown flag {}{} one of {}", whose, shown("--" + name),
                               meant.empty() ? ": expected" : meant + " Expected", fmt::join(names, ", ")));
}

/// The one flag that is meant.
const Known& flag_meant(const std::vector<Known>& known, const FlagWord& word, const Spelled& spelled) {
  std::vector<std::size_t> matches = meant(known, word.name);
  if (matches.empty()) unknown_flag(known, word.name, spelled);
  const std::string& name = known[matches.front()].name;
  const bool one_name = std::ranges::all_of(matches, [&](std::size_t i) { return known[i].name == name; });
  if (!one_name) {
    std::vector<std::string> names;
    for (const std::size_t i : matches) names.push_back("--" + hyphened(known[i].name));
    throw UsageError(
        fmt::format("expected one of {}, found {}", fmt::join(names, ", "), shown("--" + word.name)));
  }
  return known[matches.front()];
}

/// The names of one command line are written out here, word by word.
class LongNames {
 public:
  LongNames(const std::vector<std::string>& words, Spelled& spelled)
      : words_(words), spelled_(spelled), known_(known_flags(spelled.command, spelled.topic)) {}

  void write(std::size_t command_at, std::size_t topic_at) {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (i == command_at || i == topic_at) continue;
      if (plain_ || !is_long_flag(words_[i])) {
        if (words_[i] == "--") plain_ = true;
        spelled_.words.push_back(words_[i]);
        take_short_value(i);
      } else {
        write_flag(i);
      }
    }
  }

 private:
  void write_flag(std::size_t& i) {
    FlagWord word = split(words_[i]);
    const Known& flag = flag_meant(known_, word, spelled_);
    const bool has_next = i + 1 < words_.size() && words_[i + 1] != "--" &&
                          (!is_long_flag(words_[i + 1]) || is_flags_in_one(flag.name, words_[i + 1]));
    const std::string value = word.value ? *word.value : has_next ? words_[i + 1] : "";
    if (!flag.takes_value) {
      if (word.value) {
        throw UsageError(
            fmt::format("--{}: expected no value, found {}", hyphened(flag.name), shown(*word.value)));
      }
      spelled_.words.push_back("--" + flag.word);
      return;
    }
    if (!word.value && has_next) ++i;
    if (value.empty()) {
      throw UsageError(fmt::format("--{}: expected {}, found none", hyphened(flag.name), flag.expected));
    }
    spelled_.words.push_back("--" + flag.word + "=" + value);
  }

  /// The word after -o belongs to it, even if it begins with "-".
  void take_short_value(std::size_t& i) {
    const std::string& word = words_[i];
    if (plain_ || !is_short_flag(word) || word.size() != 2 || !letter_takes_value(spelled_.command, word[1]))
      return;
    if (i + 1 == words_.size()) throw UsageError(fmt::format("{}: expected a value, found none", word));
    spelled_.words.push_back(words_[++i]);
  }

  const std::vector<std::string>& words_;
  Spelled& spelled_;
  std::vector<Known> known_;
  bool plain_ = false;  ///< behind "--"
};

}  // namespace

Spelled spelled_out(const std::vector<std::string>& words) {
  Spelled spelled;
  const std::size_t command_at = next_operand(words, 0, nullptr);
  std::size_t topic_at = words.size();
  if (command_at < words.size()) {
    std::vector<std::string> names;
    for (const Command& command : commands()) names.push_back(command.name);
    spelled.command = &commands()[choose_name("COMMAND", words[command_at], names)];
  }
  if (spelled.command && spelled.command->about_topic) {
    topic_at = next_operand(words, command_at + 1, spelled.command);
    if (topic_at < words.size()) spelled.topic = &find_topic(words[topic_at]);
  }
  LongNames(words, spelled).write(command_at, topic_at);
  return spelled;
}

}  // namespace gradus::cli
