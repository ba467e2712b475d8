#pragma once
// What `gradus help` and the manual say alike of commands and topics.

#include <string>
#include <string_view>
#include <vector>

#include "cli/commands/commands.hpp"

namespace gradus::cli {

/// What a parameter takes: "a whole number, 1 to 100"; and the sizes of its numbers where they are limited.
std::string domain_of(const Parameter& parameter);

/// "default", "taught", "fast" or "faulty"; one, two or none.
std::vector<std::string> marks_of(const Method& method, const TopicEntry& topic);

/// The command's examples, about this topic, or about the first one.
std::vector<std::string> examples_of(const Command& command, const TopicEntry* topic);

/// The topic's examples, with run, and the last one with figure.
std::vector<std::string> examples_of(const TopicEntry& topic);

/// The symbols of a topic, and how one is renamed.
std::string symbols_text(const TopicEntry& topic);

/// The examples that `gradus --help` begins with.
std::vector<std::string> first_examples();

}  // namespace gradus::cli
