#pragma once
// A topic's examples as arguments.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "request/names.hpp"
#include "stories/topic.hpp"

namespace gradus::test {

/// "--from 0,0 --to=7,3 --exact", as examples are written.
inline std::vector<Argument> arguments_in(const TopicEntry& topic, std::string_view line) {
  std::vector<Argument> given;
  const std::vector<std::string> words = shell_words(line).value();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = std::min(words[i].find('='), words[i].size());
    const std::string name = folded(words[i].substr(2, equals - 2));
    const auto parameter = std::ranges::find(topic.parameters, name, &Parameter::name);
    if (parameter != topic.parameters.end() && parameter->type == ParameterType::flag) {
      given.push_back({name, "yes"});
    } else {
      given.push_back({name, equals < words[i].size() ? words[i].substr(equals + 1) : words.at(++i)});
    }
  }
  return given;
}

}  // namespace gradus::test
