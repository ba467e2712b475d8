#include "figure/alignment.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "core/contract.hpp"

namespace gradus {
namespace {

/// How far ahead the next steps that belong together are looked for.
constexpr std::size_t look_ahead = 32;

std::vector<const TraceStep*> whole_steps_of(const Trace& trace) {
  std::vector<const TraceStep*> steps;
  for (const TraceStep& step : trace.steps) {
    if (step.number.fine == 0) steps.push_back(&step);
  }
  return steps;
}

/// What each step is about, as a number: the same of both runs for the same thing.
class Subjects {
 public:
  std::vector<int> of(const std::vector<const TraceStep*>& steps) {
    std::vector<int> subjects;
    for (const TraceStep* step : steps) {
      const std::string& text = step->key.empty() ? step->type : step->key;
      subjects.push_back(known_.emplace(text, static_cast<int>(known_.size())).first->second);
    }
    return subjects;
  }

 private:
  std::unordered_map<std::string, int> known_;
};

struct Meeting {
  std::size_t a, b;
};

/// The nearest places from here on whose steps are about the same; nothing within sight: nothing.
std::optional<Meeting> next_meeting(const std::vector<int>& a, const std::vector<int>& b, Meeting from) {
  for (std::size_t apart = 0; apart <= look_ahead; ++apart) {
    for (std::size_t ahead = 0; ahead <= apart; ++ahead) {
      const std::size_t i = from.a + ahead, j = from.b + apart - ahead;
      if (i < a.size() && j < b.size() && a[i] == b[j]) return Meeting{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace

bool tells_otherwise(const TraceStep& a, const TraceStep& b) {
  if (a.key != b.key) return true;
  bool comparable = a.type == b.type;
  // What one kind of step asks and another does not is no other answer
  if (comparable && a.decision && b.decision && a.decision->branch != b.decision->branch) return true;
  for (const Field& field : a.fields) {
    const auto other = std::ranges::find(b.fields, field.name, &Field::name);
    if (other == b.fields.end()) continue;
    if (other->value != field.value) return true;
    comparable = true;
  }
  return !comparable;
}

Alignment align(const Trace& a, const Trace& b) {
  const auto steps_a = whole_steps_of(a), steps_b = whole_steps_of(b);
  expects(!steps_a.empty() && !steps_b.empty(), "two runs with steps expected, found {} and {}",
          steps_a.size(), steps_b.size());
  Subjects subjects;
  const std::vector<int> about_a = subjects.of(steps_a), about_b = subjects.of(steps_b);
  Alignment alignment;
  const auto add = [&](std::size_t i, std::size_t j) {
    const TraceStep &of_a = *steps_a[std::min(i, steps_a.size() - 1)],
                    &of_b = *steps_b[std::min(j, steps_b.size() - 1)];
    const bool behind_the_input = of_a.number.step > 0 && of_b.number.step > 0;
    if (!alignment.parting && behind_the_input && tells_otherwise(of_a, of_b))
      alignment.parting = alignment.pairs.size();
    alignment.pairs.push_back({of_a.number, of_b.number});
  };
  Meeting at{0, 0};
  while (at.a < steps_a.size() || at.b < steps_b.size()) {
    const Meeting to = next_meeting(about_a, about_b, at).value_or(Meeting{steps_a.size(), steps_b.size()});
    // What lies between two meetings stands side by side as it comes
    for (; at.a < to.a || at.b < to.b; at = {std::min(at.a + 1, to.a), std::min(at.b + 1, to.b)}) {
      const auto shown = [](std::size_t place, std::size_t end) { return place < end ? place : end - 1; };
      add(shown(at.a, std::max<std::size_t>(to.a, 1)), shown(at.b, std::max<std::size_t>(to.b, 1)));
    }
    if (to.a < steps_a.size() && to.b < steps_b.size()) {
      add(to.a, to.b);
      at = {to.a + 1, to.b + 1};
    }
  }
  return alignment;
}

StepPair pair_with(const Alignment& alignment, StepNumber a) {
  const auto found = std::ranges::lower_bound(alignment.pairs, a, {}, &StepPair::a);
  expects(found != alignment.pairs.end(), "a step of the first run expected, found {}", text_of(a));
  return a == alignment.pairs.back().a ? alignment.pairs.back() : *found;
}

}  // namespace gradus
