// `gradus cases`: inputs on which somebody's own program can be tried.

#include "check/cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "check/answers.hpp"
#include "check/expected.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/commands/commands.hpp"
#include "cli/files/files.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"
#include "stories/checking.hpp"
#include "stories/point_text.hpp"
#include "text/table.hpp"
#include "text/wrap.hpp"

namespace gradus::cli {
namespace {

using check::Case;

JsonNode whole_node(std::int64_t number) { return json_number(fmt::format("{}", number)); }

/// Lists of whatever a function makes of their elements.
template <class List, class ToNode>
JsonNode list_node(const List& list, const ToNode& to_node) {
  std::vector<JsonNode> nodes;
  for (const auto& element : list) nodes.push_back(to_node(element));
  return json_list(std::move(nodes));
}

JsonNode number_node(const Number& number) { return json_number(fmt::format("{}", number.value)); }
JsonNode tuple_node(const Tuple& tuple) { return list_node(tuple, number_node); }
JsonNode tuples_node(const std::vector<Tuple>& tuples) { return list_node(tuples, tuple_node); }

/// Numbers as numbers, points as lists of them; what is more than that as its text.
JsonNode argument_node(const Arguments::Entry& entry) {
  const auto& value = entry.value;
  if (const auto* truth = std::get_if<bool>(&value)) return json_truth(*truth);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return whole_node(*whole);
  if (const auto* number = std::get_if<Number>(&value)) return number_node(*number);
  if (const auto* tuple = std::get_if<Tuple>(&value)) return tuple_node(*tuple);
  if (const auto* tuples = std::get_if<std::vector<Tuple>>(&value)) return tuples_node(*tuples);
  if (const auto* rings = std::get_if<std::vector<std::vector<Tuple>>>(&value))
    return list_node(*rings, tuples_node);
  if (const auto* cell = std::get_if<ivec2>(&value))
    return json_list({whole_node(cell->x), whole_node(cell->y)});
  if (const auto* window = std::get_if<Window>(&value)) {
    return json_list({whole_node(window->lower.x), whole_node(window->lower.y), whole_node(window->upper.x),
                      whole_node(window->upper.y)});
  }
  return json_text(entry.text);
}

/// A case, what it says in full, and the run that answers it.
struct ToldCase {
  Case told;
  Arguments arguments;
  Trace trace;
};

JsonNode case_node(const TopicEntry& topic, const ToldCase& one) {
  std::vector<JsonMember> arguments;
  for (const Argument& named : one.trace.arguments) {
    if (named.name == "method") continue;
    const Arguments::Entry& entry = one.arguments.entry(named.name);
    if (!entry.text.empty()) arguments.push_back({named.name, 0, argument_node(entry)});
  }
  std::vector<JsonMember> members{{"case", 0, json_text(one.told.id)},
                                  {"arguments", 0, json_object(std::move(arguments))}};
  const Grid& grid = one.trace.grid;
  if (grid.axes) {
    const Window& cells = grid.cells;
    members.push_back({"cells", 0,
                       json_list({whole_node(cells.lower.x), whole_node(cells.lower.y),
                                  whole_node(cells.upper.x), whole_node(cells.upper.y)})});
  }
  members.push_back({"command", 0, json_text(command_of("run", topic, one.arguments))});
  return json_object(std::move(members));
}

/// What is asked for: names, and of what kind the values are.
JsonNode result_node(const TopicEntry& topic, const Trace& trace) {
  const check::Expected expected = check::expected_of(topic, trace);
  std::vector<JsonMember> members;
  for (const check::ExpectedList& list : expected.lists) {
    const std::string of = list.cells()              ? "[x, y]"
                           : list.fields.size() == 1 ? list.fields.front()
                                                     : fmt::format("[{}]", fmt::join(list.fields, ", "));
    members.push_back({list.name, 0, json_text("a list of " + of)});
  }
  for (const Field& field : expected.values) {
    const std::string kind(check::kind_of(field.value));
    // A list and how long it is may have one name
    const auto list = std::ranges::find(members, field.name, &JsonMember::key);
    if (list == members.end())
      members.push_back({field.name, 0, json_text(kind)});
    else
      list->value.text += ", or " + kind;
  }
  return json_object(std::move(members));
}

JsonNode steps_node(const Trace& trace) {
  std::vector<JsonMember> members;
  for (const TraceStep& step : trace.steps) {
    const bool known = std::ranges::find(members, step.type, &JsonMember::key) != members.end();
    if (step.number.fine != 0 || known) continue;
    std::vector<std::string> names;
    for (const Field& field : check::values_of(step)) names.push_back(field.name);
    members.push_back({step.type, 0, json_texts(names)});
  }
  return json_object(std::move(members));
}

/// In which conventions answers are read that declare none.
JsonNode conventions_node(const TopicEntry& topic, const Trace& trace) {
  std::vector<JsonMember> members;
  if (trace.grid.axes) members.push_back({"y", 0, json_text(trace.grid.y_up ? "up" : "down")});
  const Checking* checking = topic.checking;
  if (checking && !checking->matrix.empty()) members.push_back({"vectors", 0, json_text("columns")});
  if (checking && !checking->bits.empty()) members.push_back({"bits", 0, json_text(checking->bits)});
  members.push_back({"ties", 0, json_text("any")});
  members.push_back({"tolerance", 0, json_number(fmt::format("{}", check::Conventions{}.tolerance))});
  return json_object(std::move(members));
}

JsonNode tie_rules_node(const TopicEntry& topic) {
  std::vector<std::string> names{"any", "ours"};
  if (topic.checking) {
    for (const TieRule& rule : topic.checking->tie_rules) names.push_back(rule.name);
  }
  return json_texts(names);
}

std::string as_json(const TopicEntry& topic, const std::vector<ToldCase>& cases, std::uint64_t seed) {
  const Trace& first = cases.front().trace;
  return write_json(json_object(
      {{"schema", 0, whole_node(check::check_schema)},
       {"topic", 0, json_text(topic.name)},
       {"method", 0, json_text(first.method)},
       {"seed", 0, json_number(fmt::format("{}", seed))},
       {"conventions", 0, conventions_node(topic, first)},
       {"tie_rules", 0, tie_rules_node(topic)},
       {"result", 0, result_node(topic, first)},
       {"steps", 0, steps_node(first)},
       {"cases", 0, list_node(cases, [&](const ToldCase& one) { return case_node(topic, one); })}}));
}

std::string as_table(const TopicEntry& topic, const std::vector<ToldCase>& cases) {
  std::vector<std::vector<std::string>> rows{{"case", "command"}};
  for (const ToldCase& one : cases) rows.push_back({one.told.id, command_of("run", topic, one.arguments)});
  return table_of(rows, {false, false});
}

std::int64_t whole_flag(const Request& request, const std::string& name, std::int64_t usual,
                        std::int64_t least, std::int64_t most) {
  const auto given = request.flags.find(name);
  if (given == request.flags.end()) return usual;
  const auto value = whole_number(given->second);
  if (!value || *value < least || *value > most)
    refuse_flag(name, fmt::format("a whole number from {} to {}", least, most), shown(given->second));
  return *value;
}

}  // namespace

int cases(const Request& request) {
  const TopicEntry& topic = *request.topic;
  const auto seed = static_cast<std::uint64_t>(whole_flag(request, "random-seed", 1, 0, INT64_MAX));
  const std::int64_t count = whole_flag(request, "count", 4, 1, check::most_cases);
  const auto read = [&](const GivenTexts& given) { return read_inputs(topic, given).arguments; };
  read(request.arguments);  // what is fixed has to be right by itself
  check::Cases all(topic, request.arguments, seed, read);
  std::vector<ToldCase> told;
  for (const check::CaseKind kind : check::case_kinds) {
    const auto found = all.of_kind(kind, static_cast<std::size_t>(count));
    if (std::ssize(found) < count && !request.quiet())
      note(fmt::format("{}: {} of {}", check::name_of(kind),
                       found.size() == 0 ? "none" : fmt::format("{}", found.size()), count));
    for (const Case& one : found) {
      Arguments arguments = read(one.arguments);
      Trace trace = topic.run(arguments, {.first = 0, .most = check::most_case_events, .wording = {}});
      told.push_back({one, std::move(arguments), std::move(trace)});
    }
  }
  if (told.empty()) {
    throw UsageError(fmt::format("cases: expected inputs whose run has at most {} events, found none",
                                 check::most_case_events));
  }
  write_stream(Stream::out, request.has("json") ? as_json(topic, told, seed)
                                                : wrapped(as_table(topic, told), request.width()));
  return 0;
}

}  // namespace gradus::cli
