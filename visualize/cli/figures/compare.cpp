#include "cli/figures/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

bool is_a_file(const Parameter& parameter) {
  return parameter.type == ParameterType::picture || parameter.type == ParameterType::maze ||
         parameter.type == ParameterType::model;
}

/// What a run is about; all else says how it goes.
bool is_a_shape(const Parameter& parameter) {
  return parameter.type == ParameterType::cell || parameter.type == ParameterType::points ||
         parameter.type == ParameterType::rings || parameter.type == ParameterType::faces;
}

const Parameter* parameter_of(const TopicEntry& topic, std::string_view name) {
  const auto found = std::ranges::find(topic.parameters, name, &Parameter::name);
  return found == topic.parameters.end() ? nullptr : &*found;
}

std::vector<std::string> method_names(const TopicEntry& topic) {
  std::vector<std::string> names;
  for (const Method& method : topic.methods) names.push_back(method.name);
  return names;
}

/// What the flag says, apart: who is compared with, and the inputs that are changed.
struct Said {
  const TopicEntry* topic;
  GivenTexts inputs;
};

/// A name in full before one that is cut short, and a method of the topic before a topic.
void take_name(Said& said, const std::string& word) {
  const std::vector<std::string> methods = method_names(*said.topic);
  std::vector<std::string> topics;
  for (const TopicEntry* entry : catalogue()) topics.push_back(entry->name);
  const auto method = matching_names(word, methods), topic = matching_names(word, topics);
  const bool whole_topic = topic.size() == 1 && folded(word) == folded(topics[topic.front()]);
  const bool whole_method = method.size() == 1 && folded(word) == folded(methods[method.front()]);
  if (method.size() == 1 && (whole_method || !whole_topic)) {
    said.inputs["method"] = methods[method.front()];
    return;
  }
  if (topic.size() == 1) {
    said.topic = catalogue()[topic.front()];
    return;
  }
  std::vector<std::string> all = methods;
  all.insert(all.end(), topics.begin(), topics.end());
  throw UsageError(
      fmt::format("--compare: expected a method of {} ({}), a topic with the same inputs, or flags, "
                  "found {}{}",
                  said.topic->name, fmt::join(methods, ", "), shown(word), suggestion(word, all)));
}

Said read_said(const TopicEntry& topic, std::string_view text) {
  const auto words = shell_words(trimmed(text));
  if (!words || words->empty()) {
    refuse_flag("compare", "a method, a topic with the same inputs, or flags like '--method NAME'",
                shown(text));
  }
  Said said{&topic, {}};
  const bool named = !words->front().starts_with('-');
  if (named) take_name(said, words->front());
  std::vector<std::string> line{"figure", said.topic->name};
  line.insert(line.end(), words->begin() + (named ? 1 : 0), words->end());
  const Request request = read_request(line);
  if (!request.flags.empty() || !request.labels.empty() || !request.operands.empty()) {
    const std::string found = !request.flags.empty()    ? "--" + request.flags.begin()->first
                              : !request.labels.empty() ? "--label"
                                                        : request.operands.front();
    refuse_flag("compare", fmt::format("inputs of {}", said.topic->name), shown(found));
  }
  for (const auto& [name, value] : request.arguments) {
    const Parameter* parameter = parameter_of(*said.topic, name);
    if (parameter && is_a_file(*parameter)) {
      refuse_flag("compare", "inputs that are no files", shown("--" + hyphened(name)));
    }
    said.inputs[name] = value;
  }
  return said;
}

/// Whether an input of one topic can be handed to the other.
bool takes_over(const TopicEntry& other, const Parameter& parameter) {
  const Parameter* same = parameter_of(other, parameter.name);
  return same && same->type == parameter.type && same->parts.size() == parameter.parts.size();
}

/// Whether one of the inputs that are changed stands in the place of this one, or this one in its place.
bool gives_way(const Parameter& parameter, const TopicEntry& topic, const GivenTexts& changed) {
  return std::ranges::any_of(changed, [&](const auto& input) {
    const Parameter* other = parameter_of(topic, input.first);
    return other && (other->instead_of == parameter.name || parameter.instead_of == other->name);
  });
}

/// Whether the run's method takes notice of this input.
bool reads(const TopicEntry& topic, const Arguments& arguments, const Parameter& parameter) {
  const auto method = std::ranges::find(topic.methods, arguments.text("method"), &Method::name);
  return std::ranges::find(method->unread, parameter.name) == method->unread.end() &&
         std::ranges::find(method->without, parameter.name) == method->without.end();
}

std::string canonical_text(const TopicEntry& topic, const Said& said, const Arguments& arguments) {
  std::string text = said.topic == &topic ? "" : said.topic->name;
  for (const auto& [name, value] : said.inputs) {
    const std::string& read = arguments.text(name);
    const bool is_switch = name != "method" && parameter_of(*said.topic, name)->type == ParameterType::flag;
    // A method of the same topic is enough by its name
    const std::string part = name == "method" && said.topic == &topic && said.inputs.size() == 1 ? read
                             : is_switch ? "--" + hyphened(name)
                                         : flag_with(hyphened(name), read);
    text += (text.empty() ? "" : " ") + part;
  }
  return text;
}

}  // namespace

GivenTexts opened(const Request& request) {
  const TopicEntry& topic = *request.topic;
  const auto beside = request.flags.find("compare");
  if (beside == request.flags.end()) return gradus::opened(topic, request.arguments);
  try {
    const Said said = read_said(topic, beside->second);
    const bool by_method = said.topic == &topic && said.inputs.size() == 1 && said.inputs.contains("method");
    return gradus::opened(topic, request.arguments,
                          by_method ? &find_method(topic, said.inputs.at("method")) : nullptr);
  } catch (const UsageError&) {
    return request.arguments;  // what is wrong with it is said when it is read
  }
}

OtherSide other_side(const TopicEntry& topic, const Arguments& arguments, std::string_view text) {
  const Said said = read_said(topic, text);
  const bool same_topic = said.topic == &topic;
  GivenTexts given = said.inputs;
  std::vector<const Arguments::Entry*> files;
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (entry.name == "method") {
      if (same_topic) given.try_emplace("method", entry.text);
      continue;
    }
    const Parameter& parameter = *parameter_of(topic, entry.name);
    const bool is_default = entry.text == parameter.default_value;
    if (entry.text.empty() || gives_way(parameter, *said.topic, said.inputs)) continue;
    if (is_default && !reads(topic, arguments, parameter)) continue;
    if (!takes_over(*said.topic, parameter)) {
      if (is_default && !is_a_shape(parameter)) continue;
      refuse_flag("compare",
                  fmt::format("a topic that takes --{} as {} does", hyphened(entry.name), topic.name),
                  shown(said.topic->name));
    }
    if (is_a_file(parameter)) {
      files.push_back(&entry);
    } else if (!same_topic || !is_default) {
      given.try_emplace(entry.name, entry.text);
    }
  }
  OtherSide other{said.topic, read_inputs(*said.topic, given).arguments, ""};
  for (const Arguments::Entry* file : files) other.arguments.set(*file);
  if (!same_topic && std::ranges::none_of(topic.parameters, [&](const Parameter& parameter) {
        return takes_over(*said.topic, parameter);
      })) {
    refuse_flag("compare", fmt::format("a topic with inputs of {}", topic.name), shown(said.topic->name));
  }
  other.text = canonical_text(topic, said, other.arguments);
  return other;
}

}  // namespace gradus::cli
