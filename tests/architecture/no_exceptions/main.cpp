// Tells a topic as JSON without exceptions, as a page does: `program TOPIC [NAME=VALUE]…`. What is refused
// comes to `told` and ends the program with code 3.

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/refusal.hpp"
#include "json/json.hpp"
#include "stories/topic.hpp"

namespace {

using namespace gradus;

void told(const Refusal& refusal) {
  constexpr const char* kinds[] = {"contract", "input", "argument", "usage"};
  std::printf("%s %s: %s\n", kinds[static_cast<std::size_t>(refusal.kind)], refusal.parameter.c_str(),
              refusal.text.c_str());
  std::exit(3);
}

Argument argument_in(std::string_view word) {
  const std::size_t equals = word.find('=');
  return {std::string(word.substr(0, equals)), std::string(word.substr(equals + 1))};
}

}  // namespace

int main(int count, char** words) {
  set_refusal_handler(told);
  const TopicEntry* const topic = count > 1 ? find_entry(words[1]) : nullptr;
  if (!topic) return 2;
  std::vector<Argument> given;
  for (int i = 2; i < count; ++i) given.push_back(argument_in(words[i]));
  const std::string json = run_json(topic->run(arguments_of(*topic, given), {}));
  std::fwrite(json.data(), 1, json.size(), stdout);
}
