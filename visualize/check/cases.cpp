#include "check/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "check/expected.hpp"
#include "core/random.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

/// So many draws are tried for a kind.
constexpr std::size_t most_draws = 400;
/// Where none of so many is a tie, the topic is taken to have none.
constexpr std::size_t draws_without_ties = 40;

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// The text with every number of it changed: the i-th, as it was, becomes what change(i, number) says. Names
/// of faces and colours stay.
template <class Change>
std::string with_numbers(std::string_view text, bool named, const Change& change) {
  std::string all;
  bool in_name = named && text.find(':') != std::string_view::npos;
  for (std::size_t at = 0, i = 0; at < text.size();) {
    const char c = text[at];
    if (in_name) {
      in_name = c != ':';
      all += c;
      ++at;
      continue;
    }
    if (named && c == ';') in_name = true;
    const bool sign =
        (c == '-' || c == '+') && at + 1 < text.size() && (is_digit(text[at + 1]) || text[at + 1] == '.');
    const bool begins = is_digit(c) || sign || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
    if (!begins) {
      all += c;
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() &&
           (is_digit(text[end]) || text[end] == '.' || text[end] == '/' || text[end] == 'e'))
      ++end;
    const auto read = read_number(text.substr(at, end - at));
    const Number* number = std::get_if<Number>(&read);
    all += number ? change(i++, number->value) : std::string(text.substr(at, end - at));
    at = end;
  }
  return all;
}

bool has_numbers(ParameterType type) {
  using enum ParameterType;
  switch (type) {
    case cell:
    case window:
    case integer:
    case number:
    case numbers:
    case bounds:
    case points:
    case rings:
    case factors:
    case faces:
      return true;
    default:
      return false;
  }
}

bool is_whole(ParameterType type) {
  return type == ParameterType::cell || type == ParameterType::window || type == ParameterType::integer;
}

/// Numbers of a text, changed as a kind of case asks for.
class Changes {
 public:
  Changes(CaseKind kind, Random random)
      : kind_(kind), random_(random), way_(static_cast<int>(random_.uniform_int(0, 7))) {
    constant_ = random_.uniform_int(-3, 6);
  }

  std::string of(const Parameter& p, const std::string& text) {
    if (p.type == ParameterType::maze) return maze(text);
    last_ = 0;
    std::string changed =
        with_numbers(text, p.type == ParameterType::faces, [&](std::size_t i, double usual) {
          double value = number(i, usual, is_whole(p.type));
          if (p.type == ParameterType::number || p.type == ParameterType::integer)
            value = std::clamp(value, static_cast<double>(p.least), static_cast<double>(p.most));
          last_ = value;
          return fmt::format("{}", value + 0.0);
        });
    if (p.type == ParameterType::window || p.type == ParameterType::bounds) changed = in_order(changed);
    return changed;
  }
  bool picks(double share) { return random_.unit() < share; }

 private:
  double number(std::size_t i, double usual, bool whole) {
    const auto small = [&](int least, int most) {
      return static_cast<double>(random_.uniform_int(least, most));
    };
    switch (kind_) {
      case CaseKind::easy:
        return small(0, 8);
      case CaseKind::typical: {
        const double moved = usual + small(-5, 5) * (whole ? 1 : std::max(0.1, std::abs(usual) / 10));
        return whole ? std::round(moved) : std::round(moved * 10) / 10;
      }
      case CaseKind::ties:
        return way_ % 2 == 0 ? usual + small(-2, 2) : way_ % 3 == 0 ? 2 * small(-4, 4) : small(-6, 6);
      case CaseKind::nasty:
        break;
    }
    return nasty(i, usual, whole);
  }
  double nasty(std::size_t i, double usual, bool whole) {
    const auto small = [&](int least, int most) {
      return static_cast<double>(random_.uniform_int(least, most));
    };
    switch (way_) {
      case 0:  // all in one place
        return static_cast<double>(constant_);
      case 1:  // the other side of the origin
        return -usual;
      case 2:  // along an axis, or a diagonal
        return i < 2 ? small(-9, 9) : picks(0.6) ? last_ : small(-9, 9);
      case 3:  // large
        return usual * small(10, 40) + small(-9, 9);
      case 4:  // nearly the same
        return whole ? static_cast<double>(constant_) + small(0, 1) : usual + small(-1, 1) * 1e-9;
      case 5:  // steep, backwards
        return small(-60, 60);
      case 6:  // thirds and sevenths, or ones
        return whole ? small(-1, 1) : small(-20, 20) / (picks(0.5) ? 3 : 7);
      default:
        return picks(0.5) ? 0 : usual;
    }
  }

  /// Lower bounds before upper ones.
  static std::string in_order(const std::string& text) {
    std::vector<std::string> numbers{""};
    for (const char c : text) {
      if (c == ',')
        numbers.emplace_back();
      else
        numbers.back() += c;
    }
    const auto value = [](const std::string& number) {
      const auto read = read_number(number);
      const Number* found = std::get_if<Number>(&read);
      return found ? found->value : 0;
    };
    const std::size_t half = numbers.size() / 2;
    std::string all;
    for (std::size_t i = 0; i < half; ++i) {
      if (value(numbers[i]) > value(numbers[half + i])) std::swap(numbers[i], numbers[half + i]);
    }
    for (const std::string& number : numbers) all += (all.empty() ? "" : ",") + number;
    return all;
  }

  /// Some walls more, some fewer, the border as it is.
  std::string maze(std::string rows) {
    const std::size_t width = rows.find('/');
    if (width == std::string::npos) return rows;
    const double share = kind_ == CaseKind::easy ? 0.05 : kind_ == CaseKind::nasty ? 0.5 : 0.15;
    for (std::size_t i = width + 1; i + width + 1 < rows.size(); ++i) {
      const std::size_t column = i % (width + 1);
      if (rows[i] == '/' || column == 0 || column + 1 == width || !picks(share)) continue;
      rows[i] = rows[i] == '#' ? '.' : '#';
    }
    return rows;
  }

  const CaseKind kind_;
  Random random_;
  const int way_;
  std::int64_t constant_ = 0;
  double last_ = 0;
};

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
  if (!has_numbers(parameter.type) && parameter.type != ParameterType::maze) return false;
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
    if (varies(parameter, method()) && changes.picks(share))
      given[parameter.name] = changes.of(parameter, parameter.default_value);
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
  if (std::ranges::any_of(trace.steps, [&](const TraceStep& step) { return has_tie(topic_, step); }))
    return true;
  const Checking* checking = topic_.checking;
  if (!checking || !checking->as_near) return false;
  return std::ranges::any_of(trace.pixels, [&](ivec2 pixel) {
    constexpr ivec2 ways[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    return std::ranges::any_of(ways,
                               [&](ivec2 way) { return checking->as_near(arguments, pixel, pixel + way); });
  });
}

std::vector<Case> Cases::of_kind(CaseKind kind, std::size_t count) {
  Drawn& drawn_so_far = drawn_[static_cast<std::size_t>(kind)];
  auto& [cases, draws, known] = drawn_so_far;
  for (; draws < most_draws && cases.size() < count; ++draws) {
    if (kind == CaseKind::ties && cases.empty() && draws >= draws_without_ties) break;
    GivenTexts given = drawn(kind, draws);
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
