#pragma once
// Traces of real runs, for tests of what is made from them.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "stories/topic.hpp"
#include "support/sanitized.hpp"

namespace gradus::test {

inline const TopicEntry& topic(std::string_view name) {
  for (const TopicEntry* entry : catalogue()) {
    if (entry->name == name) return *entry;
  }
  throw std::invalid_argument("no topic of that name");
}

/// The topic's arguments: these, and the defaults of all others. Mazes are given as rows joined by "/".
inline Arguments complete(const TopicEntry& entry, const std::map<std::string, std::string>& given) {
  Arguments arguments;
  const auto method = given.find("method");
  arguments.set({"method", method == given.end() ? entry.default_method : method->second});
  for (const Parameter& parameter : entry.parameters) {
    const auto found = given.find(parameter.name);
    const std::string& text = found == given.end() ? parameter.default_value : found->second;
    Arguments::Entry argument{.name = parameter.name, .text = text};
    const bool is_file = parameter.type == ParameterType::maze || parameter.type == ParameterType::picture ||
                         parameter.type == ParameterType::model;
    if (!text.empty() && !is_file) argument = read_argument(parameter, text);
    argument.given = found != given.end();
    if (parameter.type == ParameterType::maze) {
      argument.content = argument.text;
      std::ranges::replace(argument.content, '/', '\n');
    }
    if (parameter.type == ParameterType::model && !argument.text.empty()) {
      argument.content = shipped_model(argument.text);
      argument.libraries.emplace("letter_f.mtl", shipped_model("letter_f.mtl"));
    }
    if (parameter.type == ParameterType::picture && !argument.text.empty()) {
      argument.image = std::make_shared<const Image>(read_png(argument.text));
    }
    arguments.set(std::move(argument));
  }
  return arguments;
}

inline Trace trace_of(std::string_view name, const std::map<std::string, std::string>& given = {},
                      Recording recording = {}) {
  const TopicEntry& entry = topic(name);
  return entry.run(complete(entry, given), recording);
}

/// A run that tells much: a topic's arguments, and which part of it is kept.
struct Run {
  std::map<std::string, std::string> given;
  std::int64_t first = 0, most = Recording::default_most;
};

/// The words of a line, blanks in '…' kept.
inline std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '\'')
      quoted = !quoted;
    else if (c == ' ' && !quoted)
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// All runs of a line: `@60` or `@1000+60` keeps so many steps, from that one on; then --flag value, or
/// --flag=value. Values with | between them stand for a run each, with each of another flag's.
inline std::vector<Run> runs_in(const std::string& line) {
  std::vector<Run> runs(1);
  const std::vector<std::string> words = words_of(line);
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string word = words[i];
    if (word.starts_with('@')) {
      const std::size_t plus = word.find('+');
      if (plus != std::string::npos) runs[0].first = std::stoll(word.substr(1));
      runs[0].most = std::stoll(word.substr(plus == std::string::npos ? 1 : plus + 1));
      continue;
    }
    const std::size_t equal = word.find('=');
    std::string name = word.substr(2, equal == std::string::npos ? equal : equal - 2);
    std::ranges::replace(name, '-', '_');
    const std::string values = equal == std::string::npos ? words.at(++i) : word.substr(equal + 1);
    std::vector<Run> all;
    for (const Run& run : runs) {
      std::istringstream each(values);
      for (std::string value; std::getline(each, value, '|');) all.emplace_back(run).given[name] = value;
    }
    runs = std::move(all);
  }
  return runs;
}

/// A topic's runs: one of every method, and those of the file T.runs beside its story, which say what such a
/// run leaves unsaid and strain a figure most.
inline std::vector<Run> runs_of(const TopicEntry& entry) {
  std::vector<Run> runs;
  for (const Method& method : entry.methods) runs.push_back({{{"method", method.name}}});
  std::ifstream file(
      fmt::format(GRADUS_SOURCE_DIR "/visualize/stories/{}/{}.runs", entry.chapter, entry.name));
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    for (Run& run : runs_in(line)) {
      if (const auto image = run.given.find("image"); image != run.given.end())
        image->second = GRADUS_SOURCE_DIR "/" + image->second;
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

/// A topic and one of its runs.
struct TellingRun {
  const TopicEntry* topic;
  Run run;
  Trace trace(const Wording& wording = {}) const {
    return trace_of(topic->name, run.given, {run.first, run.most, wording});
  }
};

/// All topics' runs; only: of this topic alone.
inline std::vector<TellingRun> telling_runs(std::string_view only = {}) {
  std::vector<TellingRun> runs;
  for (const TopicEntry* topic : catalogue()) {
    if (!only.empty() && topic->name != only) continue;
    for (Run& run : runs_of(*topic)) runs.push_back({topic, std::move(run)});
  }
  return runs;
}

/// Their traces; under a sanitizer of all topics one in three, since golden/trace_hash runs them all there.
inline std::vector<Trace> telling_traces(const Wording& wording = {}, std::string_view only = {}) {
  std::vector<Trace> traces;
  int next = 0;
  for (const TellingRun& run : telling_runs(only)) {
    if (sanitized && only.empty() && next++ % 3 != 0) continue;
    traces.push_back(run.trace(wording));
  }
  return traces;
}

}  // namespace gradus::test
