#include "cli/lecture/lecture_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/files/files.hpp"
#include "cli/lecture/lecture_problem.hpp"
#include "request/faces_file.hpp"
#include "request/names.hpp"
#include "request/words.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {

namespace {

using Kind = JsonNode::Kind;

bool has_control(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace

bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 80 && text[0] != '-' && std::ranges::all_of(text, fits);
}

void LectureValues::note(Problem problem) {
  // A default that is wrong is wrong for every figure: once is enough
  if (known_problems_.insert(problem).second) lecture_.problems.push_back(std::move(problem));
}

void LectureValues::complain(const Place& place, const std::string& what) {
  note(problem_at(lecture_, place, ": " + what));
}

void LectureValues::complain(const Place& place, std::string_view expected, const JsonNode& found) {
  complain(place, fmt::format("expected {}, found {}", expected, described(found)));
}

bool LectureValues::is_object(const JsonNode& node, const Place& place, std::string_view expected) {
  if (node.kind == Kind::object) return true;
  complain(place, expected, node);
  return false;
}

std::optional<std::string> LectureValues::text_of(const JsonNode& node, const Place& place) {
  if (node.kind == Kind::text) return node.text;
  complain(place, "a text", node);
  return std::nullopt;
}

std::optional<std::string> LectureValues::line_of_text(const JsonNode& node, const Place& place) {
  const auto text = text_of(node, place);
  if (!text || (!trimmed(*text).empty() && !has_control(*text))) return text;
  complain(place, "a text on one line", node);
  return std::nullopt;
}

std::optional<std::string> LectureValues::number_or_text(const JsonNode& node, const Place& place,
                                                         std::string_view expected) {
  if (node.kind == Kind::text || node.kind == Kind::number) return node.text;
  complain(place, expected, node);
  return std::nullopt;
}

std::optional<std::string> LectureValues::joined(const JsonNode& node, const Place& place,
                                                 std::string_view separator, std::string_view expected) {
  if (node.kind != Kind::list || node.elements.empty()) return number_or_text(node, place, expected);
  Texts texts;
  for (const JsonNode& element : node.elements) {
    const auto text = number_or_text(element, {element.line, place.path}, expected);
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return fmt::format("{}", fmt::join(texts, separator));
}

std::optional<std::string> LectureValues::joined_points(const JsonNode& node, const Place& place,
                                                        const Parameter& parameter) {
  const std::string expected = "a list of points or a text like " + parameter.example;
  if (node.kind != Kind::list) return number_or_text(node, place, expected);
  Texts points;
  for (const JsonNode& element : node.elements) {
    const auto point = joined(element, {element.line, place.path}, ",", expected);
    if (!point) return std::nullopt;
    points.push_back(*point);
  }
  return fmt::format("{}", fmt::join(points, " "));
}

std::optional<std::string> LectureValues::joined_rings(const JsonNode& node, const Place& place,
                                                       const Parameter& parameter) {
  const auto begins_with_list = [](const JsonNode& list) {
    return list.kind == Kind::list && !list.elements.empty() && list.elements[0].kind == Kind::list;
  };
  if (!begins_with_list(node) || !begins_with_list(node.elements[0]))
    return joined_points(node, place, parameter);
  Texts rings;
  for (const JsonNode& element : node.elements) {
    const auto ring = joined_points(element, {element.line, place.path}, parameter);
    if (!ring) return std::nullopt;
    rings.push_back(*ring);
  }
  return fmt::format("{}", fmt::join(rings, "; "));
}

std::optional<std::string> LectureValues::flag_value(const LectureKey& key, const JsonNode& node,
                                                     const Place& place) {
  switch (key.kind) {
    case KeyKind::toggle:
      if (node.kind != Kind::boolean) complain(place, "true or false", node);
      return node.kind == Kind::boolean && node.truth ? std::optional<std::string>("") : std::nullopt;
    case KeyKind::number:
      return number_or_text(node, place, "a number");
    case KeyKind::list:
      return joined(node, place, ",", "a list of numbers and texts, or one text");
    case KeyKind::place:
      return joined(node, place, ",", "three numbers like [3, 2, 4], or one text");
    default:
      return text_of(node, place);
  }
}

/// Methods, themes and the like are fewer.
constexpr std::size_t most_listed = 30;

std::optional<std::size_t> LectureValues::whole_name(const std::string& word, const Texts& names,
                                                     const Place& place) {
  const auto found = std::ranges::find(names, word);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  // Of topics there are more than a line holds
  const std::string known = names.size() > most_listed
                                ? fmt::format("the {} that `gradus list` shows", names.size())
                                : fmt::format("{}", fmt::join(names, ", "));
  complain(place, fmt::format("expected one of {}, found {}{}", known, shown(word), suggestion(word, names)));
  return std::nullopt;
}

std::optional<std::string> LectureValues::safe_name(const JsonNode& node, const Place& place) {
  const auto text = text_of(node, place);
  if (text && lowered(*text) == pages_folder) {
    complain(place, "another name, for the pages of the topics have this one", node);
    return std::nullopt;
  }
  if (!text || is_name(*text)) return text;
  complain(place, "a name of at most 80 letters a-z, digits, _ and -, not beginning with -", node);
  return std::nullopt;
}

std::optional<std::string> LectureValues::file_name(const JsonNode& node, const Place& place) {
  if (node.kind == Kind::text && node.text != dash && !trimmed(node.text).empty()) return node.text;
  complain(place, "a file's name", node);
  return std::nullopt;
}

std::optional<std::string> LectureValues::input_value(const Parameter& parameter, const JsonNode& node,
                                                      const Place& place) {
  const bool is_file = parameter.type == ParameterType::picture || parameter.type == ParameterType::maze ||
                       parameter.type == ParameterType::model;
  const auto is_one_of = [&](std::initializer_list<ParameterType> types) {
    return std::ranges::find(types, parameter.type) != types.end();
  };
  std::optional<std::string> text;
  if (parameter.type == ParameterType::flag) {
    if (node.kind == Kind::boolean) return node.truth ? "yes" : "no";
    complain(place, "true or false", node);
    return std::nullopt;
  }
  if (parameter.type == ParameterType::maze && node.kind == Kind::list) {
    text = joined(node, place, "/", "a list of rows");
    if (text && !is_maze_rows(*text)) {
      complain(place, fmt::format("expected rows of '#', '.' and letters, found {}", shown(*text)));
      return std::nullopt;
    }
  } else if (is_one_of({ParameterType::cell, ParameterType::window})) {
    text = joined(node, place, ",", "whole numbers like " + parameter.example);
  } else if (is_one_of({ParameterType::numbers, ParameterType::bounds, ParameterType::order})) {
    text = joined(node, place, ",", "a list or a text like " + parameter.example);
  } else if (parameter.type == ParameterType::points) {
    text = joined_points(node, place, parameter);
  } else if (parameter.type == ParameterType::rings) {
    text = joined_rings(node, place, parameter);
  } else if (parameter.type == ParameterType::faces && node.kind == Kind::list) {
    text = faces_text(node, [&](int line, const std::string& what) { complain({line, place.path}, what); });
  } else {
    text = number_or_text(node, place, is_file ? "a file's name" : "a text or a number");
  }
  if (is_file && text && *text == dash) {
    complain(place, "a file's name", node);
    return std::nullopt;
  }
  return text;
}

bool LectureValues::has_symbol(const TopicEntry* topic, const std::string& symbol) {
  if (!topic) return false;
  const Texts symbols = topic_symbols(topic->name);
  return std::ranges::find(symbols, symbol) != symbols.end();
}

void LectureValues::require_symbol(const std::string& symbol, const Place& place, const Topics& topics) {
  const bool used =
      std::ranges::any_of(topics, [&symbol](const TopicEntry* topic) { return has_symbol(topic, symbol); });
  if (used || topics.empty()) return;
  complain(place, fmt::format("expected {}, found {}",
                              topics.size() == 1 ? expected_symbol((*topics.begin())->name)
                                                 : std::string("a symbol of one of the topics"),
                              shown(symbol)));
}

void LectureValues::require_symbols(const JsonNode& part, const std::string& path, const Topics& topics) {
  const JsonMember* notation = part.member("notation");
  const JsonMember* symbols = notation ? notation->value.member("symbols") : nullptr;
  if (!symbols) return;
  for (const JsonMember& symbol : symbols->value.members) {
    // Of topics by their names, and those that no topic has, the notation's reader tells
    const bool known = std::ranges::any_of(
        catalogue(), [&](const TopicEntry* topic) { return has_symbol(topic, symbol.key); });
    if (symbol.value.kind == JsonNode::Kind::object || !known) continue;
    const std::string way = fmt::format("{}{}notation.symbols.{}", path, path.empty() ? "" : ".", symbol.key);
    require_symbol(symbol.key, {symbol.line, way}, topics);
  }
}

}  // namespace gradus::cli
