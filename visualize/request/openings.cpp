#include "request/openings.hpp"

#include <algorithm>

#include "request/written_json.hpp"

namespace gradus {

std::string_view exhibit_text(std::string_view path);  // embedded by the build

namespace {

bool is_text(const JsonNode& exhibit, std::string_view member, std::string_view text) {
  const JsonMember* const found = exhibit.member(member);
  return found && found->value.text == text;
}

/// The input that the method, or its exhibit, opens with; empty: the defaults do.
GivenTexts opening_of(const TopicEntry& topic, const Method& method) {
  GivenTexts inputs(method.opening.begin(), method.opening.end());
  if (!inputs.empty()) return inputs;
  if (method.standing != Standing::faulty) return inputs;
  const JsonNode all = read_json(exhibit_text("errata.json"), "examples/errata.json");
  const auto exhibit = std::ranges::find_if(all.elements, [&](const JsonNode& one) {
    return one.member("opens") && is_text(one, "topic", topic.name) && is_text(one, "wrong", method.name);
  });
  if (exhibit == all.elements.end()) return inputs;
  for (const JsonMember& input : exhibit->member("input")->value.members)
    inputs[input.key] = input.value.text;
  return inputs;
}

}  // namespace

GivenTexts opened(const TopicEntry& topic, GivenTexts given, const Method* beside) {
  const auto named = given.find("method");
  const Method* const own = named == given.end() ? nullptr : &find_method(topic, named->second);
  if (given.size() > given.count("method")) return given;
  for (const Method* const method : {own, beside}) {
    if (method) given.merge(opening_of(topic, *method));
  }
  return given;
}

}  // namespace gradus
