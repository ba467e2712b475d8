#include "live/protocol.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "json/json.hpp"
#include "request/complaint.hpp"
#include "request/names.hpp"
#include "request/notation_reader.hpp"
#include "request/openings.hpp"
#include "request/played_steps.hpp"
#include "request/takes.hpp"
#include "request/words.hpp"
#include "request/written_json.hpp"

namespace gradus::live {
namespace {

using Kind = JsonNode::Kind;

constexpr std::array<std::string_view, 10> member_names{
    "want", "topic", "arguments", "beside", "step", "steps", "labels", "language", "numbers", "notation"};

[[noreturn]] void refuse_member(const JsonMember& member, std::string_view expected) {
  refuse_usage(fmt::format("request: {}: expected {}, found {}", shown_name(member.key), expected,
                           described(member.value)));
}

const std::string& text_in(const JsonMember& member) {
  if (member.value.kind != Kind::text) refuse_member(member, "a text");
  return member.value.text;
}

/// The text of a member; nothing where there is none.
const std::string* text_of(const JsonNode& request, std::string_view name) {
  const JsonMember* const member = request.member(name);
  return member ? &text_in(*member) : nullptr;
}

void require_known_members(const JsonNode& request) {
  if (request.kind != Kind::object)
    refuse_usage(fmt::format("request: expected an object, found {}", described(request)));
  for (const JsonMember& member : request.members) {
    if (std::ranges::find(member_names, member.key) != member_names.end()) continue;
    refuse_usage(fmt::format("request: expected one of {}, found {}", fmt::join(member_names, ", "),
                             shown(member.key)));
  }
}

/// The flag of a parameter must have a value, as on a command line; flags that take none are said by "yes".
void require_value(const TopicEntry& topic, const JsonMember& argument) {
  const std::string& text = text_in(argument);
  const auto parameter = std::ranges::find(topic.parameters, argument.key, &Parameter::name);
  const bool is_method = argument.key == "method";
  if (!is_method && parameter == topic.parameters.end())
    refuse(argument.key, "{} has no such parameter", topic.name);
  if (!text.empty() || (!is_method && parameter->type == ParameterType::flag)) return;
  refuse_flag(hyphened(argument.key), is_method ? "a method's name" : expected_value(*parameter), "none");
}

GivenTexts arguments_in(const JsonNode& request, const TopicEntry& topic) {
  GivenTexts given;
  const JsonMember* const arguments = request.member("arguments");
  if (!arguments) return given;
  if (arguments->value.kind != Kind::object) refuse_member(*arguments, "an object");
  for (const JsonMember& argument : arguments->value.members) {
    require_value(topic, argument);
    given[argument.key] = argument.value.text;
  }
  return given;
}

std::vector<std::string> labels_in(const JsonNode& request) {
  std::vector<std::string> labels;
  const JsonMember* const list = request.member("labels");
  if (!list) return labels;
  if (list->value.kind != Kind::list) refuse_member(*list, "a list");
  for (const JsonNode& label : list->value.elements) {
    if (label.kind != Kind::text) refuse_member(*list, "a list of texts");
    labels.push_back(label.text);
  }
  return labels;
}

StepChoice steps_in(const JsonNode& request) {
  StepChoice choice;
  const std::string *const step = text_of(request, "step"), *const steps = text_of(request, "steps");
  if (step && steps) refuse_usage("--step: expected either this or --steps, found both");
  if (step) choose_step(choice, *step);
  if (steps) choose_steps(choice, *steps);
  return choice;
}

Wording wording_in(const JsonNode& request, const TopicEntry& topic) {
  Wording wording;
  if (const std::string* const text = text_of(request, "language")) read_language(wording, *text);
  if (const std::string* const text = text_of(request, "numbers")) read_numbers(wording, *text);
  if (const std::string* const text = text_of(request, "notation"))
    wording = wording.with(read_notation(*text));
  apply_labels(wording, topic.name, labels_in(request));
  return wording;
}

const TopicEntry& topic_in(const JsonNode& request) {
  const std::string* const name = text_of(request, "topic");
  if (!name) refuse_usage("request: expected a topic, found none");
  return find_topic(*name);
}

/// The texts of a run's inputs.
GivenTexts given_in(const JsonNode& request, const TopicEntry& topic) {
  const std::string* const beside = text_of(request, "beside");
  return opened(topic, arguments_in(request, topic),
                beside ? &find_method(topic, *beside, "--beside") : nullptr);
}

Inputs inputs_in(const JsonNode& request, const TopicEntry& topic, Files& files) {
  return read_inputs(topic, given_in(request, topic), files);
}

/// As much of a run as a page plays, from its start.
Trace first_steps(const TopicEntry& topic, const Arguments& arguments, const Wording& wording) {
  constexpr std::int64_t usual = 5 * most_played;  // events: of a long run no more need be recorded
  Trace trace = topic.run(arguments, {.most = usual, .wording = wording});
  if (!trace.whole() && trace.steps.back().number.step < most_played)
    trace = topic.run(arguments, {.wording = wording});
  std::erase_if(trace.steps, [](const TraceStep& step) { return step.number.step >= most_played; });
  return trace;
}

/// The part of a run that is asked for; where none is, all that is kept, or as much as is played.
Trace trace_in(const JsonNode& request, Files& files, bool played) {
  const TopicEntry& topic = topic_in(request);
  const Inputs inputs = inputs_in(request, topic, files);
  // What is wrong with the steps is said before what is wrong with the words, as by the command
  const StepChoice choice = steps_in(request);
  const Wording wording = wording_in(request, topic);
  if (played && !choice.names_steps()) return first_steps(topic, inputs.arguments, wording);
  return chosen_part(choice, Takes(topic, inputs.arguments, wording));
}

/// The same input by another method, without what that method lacks.
OtherSide other_in(const JsonNode& request, const TopicEntry& topic, Files& files) {
  GivenTexts given = given_in(request, topic);
  given["method"] = *text_of(request, "beside");
  const Method& method = find_method(topic, given["method"], "--beside");
  for (const std::string& name : method.without) given.erase(name);
  return {&topic, read_inputs(topic, given, files).arguments, method.name};
}

/// Two runs from their starts, as a page that plays them together holds them.
std::string both_in(const JsonNode& request, Files& files) {
  const TopicEntry& topic = topic_in(request);
  const Inputs inputs = inputs_in(request, topic, files);
  const OtherSide other = other_in(request, topic, files);
  const Wording wording = wording_in(request, topic);
  const Trace first = first_steps(topic, inputs.arguments, wording),
              second = first_steps(topic, other.arguments, wording);
  return fmt::format("{{\"trace\":{},\"beside\":{},\"alignment\":{}}}", trace_json(first), trace_json(second),
                     alignment_json(align(first, second)));
}

/// What is said of files that were read: a list of lines.
std::string remarks_in(const JsonNode& request, Files& files) {
  std::vector<std::string> quoted;
  for (const std::string& remark : inputs_in(request, topic_in(request), files).remarks)
    quoted.push_back(json_quoted(remark));
  return fmt::format("[{}]", fmt::join(quoted, ","));
}

}  // namespace

std::string answer(std::string_view request, Files& files) {
  const JsonNode read = read_json(request, "request");
  require_known_members(read);
  const std::string* const want = text_of(read, "want");
  const std::string wanted = want ? *want : "";
  if (wanted == "list") return list_json(catalogue());
  if (wanted == "run") return run_json(trace_in(read, files, false));
  if (wanted == "trace")
    return read.member("beside") ? both_in(read, files) : trace_json(trace_in(read, files, true));
  if (wanted == "remarks") return remarks_in(read, files);
  refuse_usage(fmt::format("request: want: expected run, trace, remarks or list, found {}", shown(wanted)));
}

}  // namespace gradus::live
