// Somebody's answer in our conventions.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "check/judge.hpp"
#include "request/complaint.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

class Translator {
 public:
  Translator(const TopicEntry& topic, const Trace& ours, const Expected& expected, const OwnAnswers& answers,
             const Conventions& conventions)
      : expected_(expected), answers_(answers), translation_(topic, ours, conventions) {
    for (const TraceStep* step : expected.steps) {
      for (const Field& field : values_of(*step)) {
        if (!value_of(kinds_, field.name)) kinds_.push_back(field);
      }
    }
  }

  Translated translate(const OwnAnswer& answer) {
    Translated to;
    for (JsonMember member : answer.result) {
      if (member.value.kind == JsonNode::Kind::null) continue;
      if (!in_result(member.key) && member.key.ends_with('_')) member.key.pop_back();
      add_result(to, member);
    }
    translation_.turn(to.values);
    for (const JsonNode& step : answer.steps) add_step(to, step);
    return to;
  }

 private:
  Value read(const JsonNode& node, int line, const std::string& name, const Value& kind) const {
    const auto value = read_value(node, kind);
    if (!value) refuse_answer(answers_, line, name, kind_of(kind), described(node));
    return *value;
  }
  [[noreturn]] void refuse_name(const JsonMember& member, const std::vector<std::string>& known) const {
    refuse_answer(answers_, member.line, "",
                  known.empty() ? "no result: this topic has steps alone"
                                : fmt::format("one of {}", fmt::join(known, ", ")),
                  shown(member.key) + suggestion(member.key, known));
  }

  // --- The result

  bool in_result(const std::string& name) const {
    return value_of(expected_.values, name) ||
           std::ranges::find(expected_.lists, name, &ExpectedList::name) != expected_.lists.end();
  }

  std::vector<std::string> result_names() const {
    std::vector<std::string> names;
    for (const ExpectedList& list : expected_.lists) names.push_back(list.name);
    for (const Field& field : expected_.values) names.push_back(field.name);
    return names;
  }
  /// The list of that name; pixels are those of a list of cells that has another name, too.
  const ExpectedList* list_named(const std::string& name) const {
    const auto& lists = expected_.lists;
    auto found = std::ranges::find(lists, name, &ExpectedList::name);
    if (found == lists.end() && name == "pixels") found = std::ranges::find_if(lists, &ExpectedList::cells);
    return found == lists.end() ? nullptr : &*found;
  }
  void add_result(Translated& to, const JsonMember& member) const {
    const bool is_list = member.value.kind == JsonNode::Kind::list;
    const ExpectedList* list = list_named(member.key);
    // Our own files have an empty list of pixels where there are none
    const bool drawn = list && list->name == member.key;
    if (is_list && member.key == "pixels" && member.value.elements.empty() && !drawn) return;
    const Value* ours = value_of(expected_.values, member.key);
    if (list && (is_list || !ours)) return add_list(to, member, *list);
    if (!ours) refuse_name(member, result_names());
    to.values.push_back({member.key, read(member.value, member.line, member.key, *ours)});
  }
  void add_list(Translated& to, const JsonMember& member, const ExpectedList& list) const {
    if (member.value.kind != JsonNode::Kind::list)
      refuse_answer(answers_, member.line, member.key, "a list", described(member.value));
    Translated::List theirs{&list, {}};
    for (const JsonNode& node : member.value.elements)
      theirs.elements.push_back(element(node, member.key, list));
    to.lists.push_back(std::move(theirs));
  }
  Element element(const JsonNode& node, const std::string& name, const ExpectedList& list) const {
    const std::size_t size = list.fields.size();
    if (size > 1 && (node.kind != JsonNode::Kind::list || node.elements.size() != size)) {
      refuse_answer(answers_, node.line, name, fmt::format("lists of {}", fmt::join(list.fields, ", ")),
                    described(node));
    }
    Values values;
    for (std::size_t i = 0; i < size; ++i) {
      const JsonNode& part = size > 1 ? node.elements[i] : node;
      values.push_back({list.fields[i], read(part, node.line, name, kind_in(list, i))});
    }
    translation_.turn(values);
    Element element;
    for (Field& value : values) element.push_back(std::move(value.value));
    return element;
  }
  /// Ours may have no element.
  Value kind_in(const ExpectedList& list, std::size_t i) const {
    if (!list.elements.empty()) return list.elements.front().values[i];
    const Value* value = value_of(kinds_, list.fields[i]);
    return value ? *value : list.fields[i] == "pixel" ? Value(ivec2()) : Value(std::string());
  }

  // --- Steps

  bool has_all(std::size_t place, const std::vector<JsonMember>& members) const {
    const Values ours = values_of(*expected_.steps[place]);
    return std::ranges::all_of(members, [&](const JsonMember& m) { return value_of(ours, m.key); });
  }
  std::vector<std::string> step_names() const {
    std::vector<std::string> names;
    for (const Field& field : kinds_) names.push_back(field.name);
    return names;
  }
  /// Which step is meant, where it says so: "number" always does, "step" and "k" where no value has that
  /// name.
  std::optional<std::int64_t> number_of(const JsonMember& member) const {
    const bool other = (member.key == "step" || member.key == "k") && !value_of(kinds_, member.key);
    if (member.key != "number" && !other) return std::nullopt;
    const auto number =
        member.value.kind == JsonNode::Kind::number ? whole_number(member.value.text) : std::nullopt;
    if (!number) refuse_answer(answers_, member.line, member.key, "a whole number", described(member.value));
    return number;
  }
  void add_step(Translated& to, const JsonNode& node) {
    // Our own files tell finer events, too
    if (const JsonMember* fine = node.member("fine"); fine && fine->value.text != "0") return;
    std::optional<std::int64_t> number;
    std::string type;
    std::vector<JsonMember> named;
    for (JsonMember member : node.members) {
      if (member.value.kind == JsonNode::Kind::null) continue;
      if (const auto found = number_of(member)) {
        number = found;
        continue;
      }
      if (!value_of(kinds_, member.key) && member.key.ends_with('_')) member.key.pop_back();
      if (member.key == "type" && !value_of(kinds_, "type")) {
        type = member.value.text;
      } else if (value_of(kinds_, member.key)) {
        named.push_back(std::move(member));
      } else if (member.key != "line" && member.key != "fine") {
        refuse_name(member, step_names());
      }
    }
    Translated::Step step{.values = {}, .stands_for = place_of(number, type, named)};
    const Values ours = step.stands_for ? values_of(*expected_.steps[*step.stands_for]) : Values();
    for (const JsonMember& member : named) {
      const Value* kind = value_of(ours, member.key);
      if (!kind) kind = value_of(kinds_, member.key);
      step.values.push_back({member.key, read(member.value, member.line, member.key, *kind)});
    }
    translation_.turn(step.values);
    to.steps.push_back(std::move(step));
  }
  /// The next of our steps that has all these values, or the one that is named.
  std::optional<std::size_t> place_of(const std::optional<std::int64_t>& number, const std::string& type,
                                      const std::vector<JsonMember>& named) {
    for (std::size_t place = number ? 0 : next_; place < expected_.steps.size(); ++place) {
      const TraceStep& ours = *expected_.steps[place];
      const bool meant =
          number ? ours.number.step == *number : (type.empty() || ours.type == type) && has_all(place, named);
      if (!meant) continue;
      next_ = place + 1;
      return place;
    }
    return std::nullopt;
  }

  const Expected& expected_;
  const OwnAnswers& answers_;
  const Translation translation_;
  Values kinds_;  ///< of the values that steps have
  std::size_t next_ = 0;
};

}  // namespace

Translated translated(const TopicEntry& topic, const Trace& ours, const Expected& expected,
                      const OwnAnswers& answers, const OwnAnswer& answer, const Conventions& conventions) {
  return Translator(topic, ours, expected, answers, conventions).translate(answer);
}

}  // namespace gradus::check
