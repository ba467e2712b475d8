#pragma once
// Requests to the module of live pages, for every topic: what users try first, what others have stumbled
// over, and seeded inputs, most of them hard. docs/live.md says what a request is.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "live/files.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"
#include "stories/topic.hpp"
#include "stress/domain.hpp"
#include "support/example_arguments.hpp"
#include "support/odd_arguments.hpp"

namespace gradus::test {

/// Draws the requests of a topic; the same seed draws the same ones.
class LiveRequests {
 public:
  LiveRequests(const TopicEntry& topic, std::uint64_t seed)
      : topic_(topic), seed_(own_seed(topic, seed)), odd_(seed_) {}

  /// Each method as it is, the topic's examples, the traps of its promises, and so many seeded inputs.
  std::vector<std::string> drawn(std::size_t seeded) {
    add({});
    for (const Method& method : topic_.methods) add({{"method", method.name}});
    for (const std::string& example : topic_.examples) add(arguments_in(topic_, example));
    const std::vector<const stress::Property*> properties = drawable_properties();
    for (const stress::Property* property : properties) {
      for (const stress::Trap& trap : property->traps) add(arguments_of(*property, trap.input));
    }
    const std::size_t wanted = requests_.size() + seeded;
    for (std::size_t i = 0; requests_.size() < wanted; ++i) {
      const bool of_promise = i % 3 == 1 && !properties.empty();
      const std::vector<Argument> given = of_promise   ? hard(*properties[i / 3 % properties.size()], i)
                                          : i % 3 == 2 ? gentle()
                                                       : odd_.of(topic_);
      add(given);
    }
    return std::move(requests_);
  }

 private:
  /// The topics' inputs differ.
  static std::uint64_t own_seed(const TopicEntry& topic, std::uint64_t seed) {
    for (const char c : topic.name) seed = 31 * seed + static_cast<unsigned char>(c);
    return seed;
  }

  /// The topic's promises whose inputs are arguments of it.
  std::vector<const stress::Property*> drawable_properties() const {
    std::vector<const stress::Property*> properties;
    const auto domain = std::ranges::find(stress::domains(), topic_.name, &stress::Domain::topic);
    if (domain == stress::domains().end()) return properties;
    for (const stress::Property& property : domain->properties) {
      if (property.arguments) properties.push_back(&property);
    }
    return properties;
  }

  std::vector<Argument> arguments_of(const stress::Property& property, const stress::Input& input) const {
    std::vector<Argument> given;
    for (const auto& [flag, value] : property.arguments(input)) given.push_back({folded(flag), value});
    return given;
  }

  std::vector<Argument> hard(const stress::Property& property, std::size_t i) const {
    Random random(seed_ + i);
    return arguments_of(property, property.generate(property.kinds[i % property.kinds.size()], random));
  }

  /// One input at an odd value, the others as they are.
  std::vector<Argument> gentle() {
    std::vector<Argument> given = odd_.of(topic_);
    given.resize(std::min<std::size_t>(given.size(), 2));  // the method comes first
    return given;
  }

  bool is_long(const std::vector<Argument>& given) const {
    constexpr std::int64_t most_steps = 2000;
    std::map<std::string, std::string> texts;
    for (const Argument& argument : given) texts[argument.name] = argument.value;
    try {
      live::OpenedFiles none;
      return !topic_.run(read_inputs(topic_, texts, none).arguments, {0, most_steps, {}}).whole();
    } catch (const std::exception&) {
      return false;
    }
  }

  /// In turn a run and a trace, now and then in other words or in part.
  void add(const std::vector<Argument>& given) {
    // Long runs take seconds to write out: one is enough
    if (is_long(given) && long_runs_++ > 0) return;
    const std::size_t i = requests_.size();
    std::vector<JsonMember> arguments, members;
    const auto put = [](std::vector<JsonMember>& to, std::string_view name, JsonNode value) {
      to.push_back({std::string(name), 0, std::move(value)});
    };
    const auto now_and_then = [&](std::size_t every, std::string_view name,
                                  const std::vector<std::string>& texts) {
      if (i % every == every - 1) put(members, name, json_text(texts[i / every % texts.size()]));
    };
    for (const Argument& argument : given) put(arguments, argument.name, json_text(argument.value));
    put(members, "want", json_text(i % 2 == 0 ? "run" : "trace"));
    put(members, "topic", json_text(topic_.name));
    put(members, "arguments", json_object(std::move(arguments)));
    now_and_then(3, "language", {"de", "en"});
    now_and_then(5, "numbers", {"fractions", "decimals"});
    now_and_then(7, "notation", {"foley", "hearn", "shirley", "opengl", R"({"vectors": "rows"})"});
    now_and_then(11, "steps", {"auto", "0-2", "1", "0-3/2", "0-100000"});
    requests_.push_back(json_on_one_line(json_object(std::move(members))));
  }

  const TopicEntry& topic_;
  std::uint64_t seed_;
  OddArguments odd_;
  std::size_t long_runs_ = 0;
  std::vector<std::string> requests_;
};

}  // namespace gradus::test
