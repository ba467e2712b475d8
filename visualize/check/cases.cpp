#include "check/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "check/changes.hpp"
#include "check/expected.hpp"
#include "core/random.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

/// So many draws are tried for a kind.
constexpr std::size_t most_draws = 400;
/// Where none of so many is a tie, the topic is taken to be without ties.
constexpr std::size_t draws_without_ties = 40;

/// "--from 0,0 --to 7,3" by the names of parameters; nothing where it takes files or other methods.
std::optional<GivenTexts> arguments_in(const TopicEntry& topic, const std::string& example) {
  const auto words = shell_words(example);
  if (!words) return std::nullopt;
  GivenTexts given;
  for (std::size_t i = 0; i < words->size(); ++i) {
    const std::string& word = (*words)[i];
    if (!word.starts_with("--")) return std::nullopt;
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string name = folded(word.substr(2, equals - 2));
    const auto parameter = std::ranges::find(topic.parameters, name, &Parameter::name);
    const bool is_switch = parameter != topic.parameters.end() && parameter->type == ParameterType::flag;
    if (!is_switch && equals == word.size() && i + 1 == words->size()) return std::nullopt;
    given[name] = is_switch ? "yes" : equals < word.size() ? word.substr(equals + 1) : (*words)[++i];
  }
  return given;
}

/// Whether whole numbers are of a size that a plain program can walk through: where ours jumps into a window
/// of a huge run, others would take hours.
bool can_be_walked(const Arguments& arguments) {
  constexpr std::int64_t farthest = 10'000;
  const auto near = [](std::int64_t n) { return -farthest <= n && n <= farthest; };
  return std::ranges::all_of(arguments.entries(), [&](const Arguments::Entry& entry) {
    if (const auto* cell = std::get_if<ivec2>(&entry.value)) return near(cell->x) && near(cell->y);
    const auto* whole = std::get_if<std::int64_t>(&entry.value);
    return !whole || near(*whole);
  });
}

}  // namespace

std::string_view name_of(CaseKind kind) {
  constexpr std::string_view names[] = {"easy", "typical", "nasty", "ties"};
  return names[static_cast<std::size_t>(kind)];
}

const Method& Cases::method() const {
  const auto named = fixed_.find("method");
  const std::string& name = named == fixed_.end() ? topic_.default_method : named->second;
  return *std::ranges::find(topic_.methods, name, &Method::name);
}

bool Cases::varies(const Parameter& parameter, const Method& method) const {
  const auto in = [&](const std::vector<std::string>& names) {
    return std::ranges::find(names, parameter.name) != names.end();
  };
  if (parameter.default_value.empty() || fixed_.contains(parameter.name)) return false;
  if (!can_be_changed(parameter.type)) return false;
  return !in(method.without) && !in(method.unread);
}

GivenTexts Cases::drawn(CaseKind kind, std::size_t draw) const {
  GivenTexts given = fixed_;
  if (kind == CaseKind::typical && draw == 0) return given;
  if (kind == CaseKind::typical && draw <= topic_.examples.size()) {
    auto example = arguments_in(topic_, topic_.examples[draw - 1]);
    const bool same_method =
        example && (!example->contains("method") || example->at("method") == method().name);
    if (!same_method) return given;
    given.merge(*example);
    return given;
  }
  const Random random = Random(seed_).split(static_cast<std::uint64_t>(kind)).split(draw);
  Changes changes(kind, random);
  // Easy and typical cases change a few things alone
  const double share = kind == CaseKind::easy || kind == CaseKind::typical ? 0.7 : 0.9;
  for (const Parameter& parameter : topic_.parameters) {
    if (varies(parameter, method()) && changes.picks(share)) given[parameter.name] = changes.of(parameter);
  }
  return given;
}

std::optional<Trace> Cases::run(const GivenTexts& given) const {
  try {
    const Arguments arguments = read_(given);
    if (!can_be_walked(arguments)) return std::nullopt;
    Trace trace = topic_.run(arguments, {.first = 0, .most = most_case_events, .wording = {}});
    return trace.whole() ? std::optional(std::move(trace)) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // the topic does not take these
  }
}

bool Cases::has_ties(const Trace& trace, const Arguments& arguments) const {
  const Checking* checking = topic_.checking;
  if (!checking) return false;
  if (checking->is_tie && std::ranges::any_of(trace.steps, checking->is_tie)) return true;
  if (!checking->as_near) return false;
  return std::ranges::any_of(trace.pixels, [&](ivec2 pixel) {
    constexpr ivec2 ways[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    return std::ranges::any_of(ways,
                               [&](ivec2 way) { return checking->as_near(arguments, pixel, pixel + way); });
  });
}

std::vector<Case> Cases::of_kind(CaseKind kind, std::size_t count) {
  Drawn& drawn_so_far = drawn_[static_cast<std::size_t>(kind)];
  auto& [cases, draws, known] = drawn_so_far;
  const Checking* checking = topic_.checking;
  if (kind == CaseKind::ties && (!checking || (!checking->is_tie && !checking->as_near))) return {};
  for (; draws < most_draws && cases.size() < count; ++draws) {
    if (kind == CaseKind::ties && cases.empty() && draws >= draws_without_ties) break;
    GivenTexts given = drawn(kind, draws);
    const bool as_usual = kind != CaseKind::typical && given == fixed_;
    if (as_usual) continue;
    const auto trace = run(given);
    if (!trace) continue;
    std::vector<std::string> canonical;
    for (const Argument& argument : trace->arguments) canonical.push_back(argument.value);
    if (known.contains(canonical)) continue;
    if (kind == CaseKind::ties && !has_ties(*trace, read_(given))) continue;
    known.insert(std::move(canonical));
    cases.push_back({fmt::format("{}-{}", name_of(kind), cases.size() + 1), kind, std::move(given)});
  }
  return {cases.begin(), cases.begin() + static_cast<std::ptrdiff_t>(std::min(count, cases.size()))};
}

std::optional<Case> Cases::find(std::string_view id) {
  const std::size_t hyphen = std::min(id.find('-'), id.size());
  const std::int64_t number = hyphen < id.size() ? whole_number(id.substr(hyphen + 1)).value_or(0) : 0;
  const auto kind =
      std::ranges::find_if(case_kinds, [&](CaseKind k) { return name_of(k) == id.substr(0, hyphen); });
  if (number < 1 || number > most_cases || kind == case_kinds.end()) return std::nullopt;
  const auto cases = of_kind(*kind, static_cast<std::size_t>(number));
  if (cases.size() < static_cast<std::size_t>(number)) return std::nullopt;
  return cases.back();
}

}  // namespace gradus::check
