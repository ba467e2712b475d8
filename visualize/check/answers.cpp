#include "check/answers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "request/complaint.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

using Kind = JsonNode::Kind;

std::optional<double> real_of(std::string_view text) {
  const auto read = read_number(text);
  const Number* number = std::get_if<Number>(&read);
  return number ? std::optional(number->value) : std::nullopt;
}

/// Reads the JSON form.
class AnswersReader {
 public:
  AnswersReader(const TopicEntry& topic, OwnAnswers& to) : topic_(topic), to_(to) {}

  void read(const JsonNode& root) {
    want(root, Kind::object, "", "an object with answers");
    OwnAnswer single{.id = "answer", .line = root.line};  // as `gradus run --json` writes it
    for (const JsonMember& member : root.members) {
      if (member.key == "topic")
        to_.topic = text(member);
      else if (member.key == "method")
        to_.method = text(member);
      else if (member.key == "seed")
        to_.seed = static_cast<std::uint64_t>(whole(member, 0));
      else if (member.key == "conventions")
        read_conventions(member);
      else if (member.key == "answers")
        read_all(member);
      else if (is_of_one_answer(member.key))
        read_member(single, member);
      else if (!is_of_our_own(member.key))
        refuse_key(member, {"topic", "method", "seed", "conventions", "answers", "program"});
    }
    if (to_.answers.empty() && (!single.result.empty() || !single.steps.empty()))
      to_.answers.push_back(std::move(single));
    if (to_.answers.empty()) refuse_answer(to_, root.line, "", "answers, a list of at least one", "none");
  }

 private:
  static bool is_of_one_answer(std::string_view key) {
    constexpr std::string_view keys[] = {"case", "arguments", "input", "result", "steps"};
    return std::ranges::find(keys, key) != std::end(keys);
  }
  /// What our own files have besides.
  static bool is_of_our_own(std::string_view key) {
    constexpr std::string_view keys[] = {"schema", "program", "faulty", "input_hash", "recorded"};
    return std::ranges::find(keys, key) != std::end(keys);
  }
  void want(const JsonNode& node, Kind kind, std::string_view where, std::string_view expected) const {
    if (node.kind != kind) refuse_answer(to_, node.line, where, expected, described(node));
  }
  std::string text(const JsonMember& member) const {
    want(member.value, Kind::text, member.key, "a text");
    return member.value.text;
  }
  std::int64_t whole(const JsonMember& member, std::int64_t least) const {
    const auto value = member.value.kind == Kind::number ? whole_number(member.value.text) : std::nullopt;
    if (!value || *value < least)
      refuse_answer(to_, member.line, member.key, fmt::format("a whole number from {} on", least),
                    described(member.value));
    return *value;
  }
  [[noreturn]] void refuse_key(const JsonMember& member, const std::vector<std::string>& known) const {
    refuse_answer(to_, member.line, "", fmt::format("one of {}", fmt::join(known, ", ")),
                  shown(member.key) + suggestion(member.key, known));
  }
  std::size_t one_of(const JsonMember& member, const std::vector<std::string>& names) const {
    const auto found = std::ranges::find(names, text(member));
    if (found == names.end())
      refuse_answer(to_, member.line, member.key, fmt::format("{}", fmt::join(names, " or ")),
                    described(member.value));
    return static_cast<std::size_t>(found - names.begin());
  }

  void read_conventions(const JsonMember& conventions) {
    want(conventions.value, Kind::object, "conventions", "an object");
    Conventions& to = to_.conventions;
    for (const JsonMember& member : conventions.value.members) {
      if (member.key == "y")
        to.y_down = one_of(member, {"up", "down"}) == 1;
      else if (member.key == "height")
        to.height = whole(member, 1);
      else if (member.key == "bits")
        to.bits = text(member);
      else if (member.key == "vectors")
        to.rows = one_of(member, {"columns", "rows"}) == 1;
      else if (member.key == "ties")
        to.ties = one_of_ties(member);
      else if (member.key == "tolerance")
        to.tolerance = tolerance(member);
      else
        refuse_key(member, {"y", "height", "bits", "vectors", "ties", "tolerance"});
    }
  }
  std::string one_of_ties(const JsonMember& member) const {
    std::vector<std::string> names{"any", "ours"};
    if (topic_.checking) {
      for (const TieRule& rule : topic_.checking->tie_rules) names.push_back(rule.name);
    }
    return names[one_of(member, names)];
  }
  double tolerance(const JsonMember& member) const {
    const auto value = member.value.kind == Kind::number ? real_of(member.value.text) : std::nullopt;
    if (!value || !(*value >= 0 && *value <= 1))
      refuse_answer(to_, member.line, member.key, "a number from 0 to 1", described(member.value));
    return *value;
  }

  void read_all(const JsonMember& answers) {
    want(answers.value, Kind::list, "answers", "a list");
    for (const JsonNode& node : answers.value.elements) {
      want(node, Kind::object, "answers", "objects with a case or arguments");
      OwnAnswer answer{.id = fmt::format("answer {}", to_.answers.size() + 1), .line = node.line};
      for (const JsonMember& member : node.members) read_member(answer, member);
      if (answer.result.empty() && answer.steps.empty())
        refuse_answer(to_, node.line, answer.id, "a result or steps", "neither");
      const bool twice = std::ranges::find(to_.answers, answer.id, &OwnAnswer::id) != to_.answers.end();
      if (twice) refuse_answer(to_, node.line, "", "one answer per case", "another to " + answer.id);
      to_.answers.push_back(std::move(answer));
    }
  }
  void read_member(OwnAnswer& answer, const JsonMember& member) {
    if (member.key == "case") {
      answer.id = text(member);
      answer.is_case = true;
    } else if (member.key == "arguments" || member.key == "input") {
      want(member.value, Kind::object, member.key, "an object");
      for (const JsonMember& argument : member.value.members)
        answer.arguments[folded(argument.key)] = argument_text(argument);
    } else if (member.key == "result") {
      want(member.value, Kind::object, "result", "an object");
      answer.result = member.value.members;
    } else if (member.key == "steps") {
      want(member.value, Kind::list, "steps", "a list");
      for (const JsonNode& step : member.value.elements) want(step, Kind::object, "steps", "objects");
      answer.steps = member.value.elements;
    } else if (member.key != "kind" && member.key != "command") {
      refuse_key(member, {"case", "arguments", "result", "steps"});
    }
  }

  /// A number, a text, a truth; lists of numbers "3,4", of points "0,0 6,0", of rings.
  std::string argument_text(const JsonMember& member) const {
    const JsonNode& node = member.value;
    if (node.kind == Kind::boolean) return node.truth ? "yes" : "";
    if (node.kind == Kind::text || node.kind == Kind::number) return node.text;
    if (node.kind != Kind::list)
      refuse_answer(to_, member.line, member.key, "a text, a number or a list", described(node));
    return list_text(member, node, 0);
  }
  std::string list_text(const JsonMember& member, const JsonNode& list, int depth) const {
    std::string all;
    const bool of_lists = !list.elements.empty() && list.elements.front().kind == Kind::list;
    const bool of_rings = of_lists && !list.elements.front().elements.empty() &&
                          list.elements.front().elements.front().kind == Kind::list;
    for (const JsonNode& element : list.elements) {
      const bool as_first = (element.kind == Kind::list) == of_lists;
      if (!as_first || depth > 2 || element.kind == Kind::object || element.kind == Kind::null)
        refuse_answer(to_, element.line, member.key, "numbers, points or lists of points",
                      described(element));
      if (!all.empty()) all += of_rings ? "; " : of_lists ? " " : ",";
      all += of_lists ? list_text(member, element, depth + 1) : element.text;
    }
    return all;
  }

  const TopicEntry& topic_;
  OwnAnswers& to_;
};

// --- Tables ------------------------------------------------------------------------------------------------

std::vector<std::string> cells_of(std::string_view line) {
  const bool blanks = line.find_first_of(",;\t") == std::string_view::npos;
  std::vector<std::string> cells{""};
  for (const char c : trimmed(line)) {
    const bool between = blanks ? c == ' ' : c == ',' || c == ';' || c == '\t';
    if (!between)
      cells.back() += c;
    else if (!blanks || !cells.back().empty())
      cells.emplace_back();
  }
  for (std::string& cell : cells) cell = std::string(trimmed(cell));
  return cells;
}

JsonNode cell_node(const std::string& cell, int line) {
  JsonNode node = real_of(cell) ? json_number(cell) : json_text(cell);
  if (cell == "true" || cell == "false") node = json_truth(cell == "true");
  node.line = line;
  return node;
}

/// Columns x and y as pixels, all columns as steps.
class Table {
 public:
  Table(OwnAnswers& to, std::string_view text) : to_(to) {
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      add(text.substr(at, end - at), ++number);
      at = end + 1;
    }
    if (pixels_.elements.empty() && answer_.steps.empty())
      refuse_answer(to_, std::max(number, 1), "", "a line x,y for each pixel", "none");
    if (has_pixels()) answer_.result.push_back({"pixels", 1, std::move(pixels_)});
    to_.answers.push_back(std::move(answer_));
  }

 private:
  std::size_t column(std::string_view name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }
  bool has_pixels() const { return std::max(column("x"), column("y")) < names_.size(); }

  void add(std::string_view line, int number) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    const std::vector<std::string> cells = cells_of(line);
    if (names_.empty()) {
      named_ = !real_of(cells.front());
      names_ = named_ ? cells : std::vector<std::string>{"x", "y"};
      if (named_) return;
    }
    if (cells.size() != names_.size())
      refuse_answer(to_, number, "", fmt::format("{} values: {}", names_.size(), fmt::join(names_, ",")),
                    fmt::format("{}", cells.size()));
    if (named_) add_step(cells, number);
    if (has_pixels()) add_pixel(cells[column("x")], cells[column("y")], number);
  }
  void add_step(const std::vector<std::string>& cells, int number) {
    JsonNode step = json_object({});
    step.line = number;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!cells[i].empty()) step.members.push_back({names_[i], number, cell_node(cells[i], number)});
    }
    answer_.steps.push_back(std::move(step));
  }
  void add_pixel(const std::string& x, const std::string& y, int number) {
    for (const std::string& cell : {x, y}) {
      if (!real_of(cell)) refuse_answer(to_, number, "", "two numbers x,y", shown(cell));
    }
    JsonNode pixel = json_list({cell_node(x, number), cell_node(y, number)});
    pixel.line = number;
    pixels_.elements.push_back(std::move(pixel));
  }

  OwnAnswers& to_;
  OwnAnswer answer_{.id = "answer"};
  std::vector<std::string> names_;
  bool named_ = false;
  JsonNode pixels_ = json_list({});
};

}  // namespace

void refuse_answer(const OwnAnswers& answers, int line, std::string_view where, std::string_view expected,
                   std::string_view found) {
  refuse_input(fmt::format("{}:{}: {}{}expected {}, found {}", answers.file, line, where,
                           where.empty() ? "" : ": ", expected, found));
}

OwnAnswers read_answers(const TopicEntry& topic, std::string_view text, const std::string& file) {
  OwnAnswers answers{.file = file};
  if (pipeline::begins_as_json(text)) {
    AnswersReader(topic, answers).read(read_json(text, file));
    if (!answers.topic.empty() && folded(answers.topic) != topic.name)
      refuse_answer(answers, 1, "topic", topic.name, shown(answers.topic));
  } else {
    Table(answers, text);
  }
  return answers;
}

std::string_view kind_of(const Value& ours) {
  constexpr std::string_view names[] = {"a number", "a number", "true or false", "a text",
                                        "two whole numbers"};
  return names[ours.index()];
}

std::optional<Value> read_value(const JsonNode& node, const Value& ours) {
  const auto whole = [](const JsonNode& n) -> std::optional<std::int64_t> {
    return n.kind == Kind::number ? whole_number(n.text) : std::nullopt;
  };
  if (std::holds_alternative<ivec2>(ours)) {
    if (node.kind != Kind::list || node.elements.size() != 2) return std::nullopt;
    std::int64_t place[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const JsonNode& element = node.elements[i];
      const auto value = element.kind == Kind::number ? real_of(element.text) : std::nullopt;
      if (!value || !(std::abs(*value) <= 2147483647.0)) return std::nullopt;
      place[i] = static_cast<std::int64_t>(*value);
      if (static_cast<double>(place[i]) != *value) return std::nullopt;
    }
    return ivec2(static_cast<int>(place[0]), static_cast<int>(place[1]));
  }
  if (std::holds_alternative<bool>(ours)) {
    if (node.kind == Kind::boolean) return node.truth;
    const auto digit = whole(node);
    return digit && (*digit == 0 || *digit == 1) ? std::optional<Value>(*digit == 1) : std::nullopt;
  }
  if (std::holds_alternative<std::string>(ours))
    return node.kind == Kind::text || node.kind == Kind::number ? std::optional<Value>(node.text)
                                                                : std::nullopt;
  if (std::holds_alternative<std::int64_t>(ours)) {
    if (const auto value = whole(node)) return *value;
    const bool digits = node.kind == Kind::text && !node.text.empty() && node.text.size() <= 32 &&
                        node.text.find_first_not_of("01") == std::string::npos;
    if (digits) return static_cast<std::int64_t>(std::stoll(node.text, nullptr, 2));
  }
  const auto value = node.kind == Kind::number ? real_of(node.text) : std::nullopt;
  if (!value) return std::nullopt;
  const auto rounded = static_cast<std::int64_t>(std::clamp(*value, -9e18, 9e18));
  const bool is_whole = std::holds_alternative<std::int64_t>(ours) && static_cast<double>(rounded) == *value;
  return is_whole ? Value(rounded) : Value(*value);
}

}  // namespace gradus::check
