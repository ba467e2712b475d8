// Running a topic from code, without a command line.

#include <algorithm>

#include "stories/topic.hpp"

namespace gradus {

const TopicEntry* entry_in_namespace(std::string_view space);  // made by the build, as catalogue() is

namespace {

std::string method_of(const TopicEntry& topic, std::span<const Argument> given) {
  const auto found = std::ranges::find(given, "method", &Argument::name);
  if (found == given.end()) return topic.default_method;
  if (std::ranges::find(topic.methods, found->value, &Method::name) == topic.methods.end()) {
    refuse("method", "{} has no method {}", topic.name, found->value);
  }
  return found->value;
}

void require_known(const TopicEntry& topic, std::span<const Argument> given) {
  for (const Argument& argument : given) {
    if (argument.name != "method" &&
        std::ranges::find(topic.parameters, argument.name, &Parameter::name) == topic.parameters.end()) {
      refuse(argument.name, "{} has no such parameter", topic.name);
    }
  }
}

}  // namespace

const TopicEntry* find_entry(std::string_view name) {
  // Most topics are called what their namespace is: of these no other entry is made for the search
  if (const TopicEntry* found = entry_in_namespace(name); found && found->name == name) return found;
  const auto topics = catalogue();
  const auto found = std::ranges::find(topics, name, &TopicEntry::name);
  return found == topics.end() ? nullptr : *found;
}

const Parameter* model_of(const TopicEntry& topic) {
  const auto found = std::ranges::find(topic.parameters, ParameterType::model, &Parameter::type);
  return found == topic.parameters.end() ? nullptr : &*found;
}

Arguments arguments_of(const TopicEntry& topic, std::span<const Argument> given) {
  require_known(topic, given);
  Arguments arguments;
  arguments.set({"method", method_of(topic, given)});
  for (const Parameter& parameter : topic.parameters) {
    const auto found = std::ranges::find(given, parameter.name, &Argument::name);
    const bool is_given = found != given.end();
    const std::string& text = is_given ? found->value : parameter.default_value;
    Arguments::Entry entry{.name = parameter.name, .text = ""};
    if (is_given || !text.empty()) entry = read_argument(parameter, text);
    entry.given = is_given;
    if (parameter.type == ParameterType::maze) {
      entry.content = entry.text;
      std::ranges::replace(entry.content, '/', '\n');
    }
    arguments.set(std::move(entry));
  }
  return arguments;
}

Trace trace_of(const TopicEntry& topic, std::initializer_list<Argument> given, Recording recording) {
  return topic.run(arguments_of(topic, {given.begin(), given.size()}), recording);
}

}  // namespace gradus
