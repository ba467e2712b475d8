#include "worksheet/similar_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <span>
#include <utility>

#include "stories/face_text.hpp"
#include "stories/outline.hpp"

namespace gradus::worksheet {
namespace {

constexpr bool is_digit(char c) { return '0' <= c && c <= '9'; }
constexpr bool is_word(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_' || is_digit(c);
}

// --- Numbers in a text ---------------------------------------------------------------------------------

/// A number where it stands in the canonical text of an argument.
struct WrittenNumber {
  std::size_t begin, end;
  double value;
  int decimals;
  int axis = -1;      ///< 0, 1, 2: it is an x, y or z of a place; -1: it is none
  int face = -1;      ///< of which face it is; -1: of none
  bool turn = false;  ///< degrees
};

/// Behind the number that begins here; here, when none does.
std::size_t end_of_written(const std::string& text, std::size_t at) {
  std::size_t end = at + (text[at] == '-' ? 1 : 0);
  if (end >= text.size() || !is_digit(text[end])) return at;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
  return end;
}

/// The numbers of a text: not the digits of names ("B1: 0,0,0"), nor what a fraction is divided by.
std::vector<WrittenNumber> numbers_written_in(const std::string& text) {
  std::vector<WrittenNumber> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = end_of_written(text, at);
    if (end == at) {
      const bool name = is_word(text[at]);
      ++at;
      while (name && at < text.size() && is_word(text[at])) ++at;
      continue;
    }
    const std::string digits = text.substr(at, end - at);
    const std::size_t dot = digits.find('.');
    const bool of_a_name = end < text.size() && (text[end] == ':' || is_word(text[end]));
    const bool divides = at > 0 && text[at - 1] == '/';
    if (!of_a_name && !divides) {
      const int decimals = dot == std::string::npos ? 0 : static_cast<int>(digits.size() - dot - 1);
      const std::string before = text.substr(0, at);
      numbers.push_back({.begin = at,
                         .end = end,
                         .value = std::strtod(digits.c_str(), nullptr),
                         .decimals = decimals,
                         .turn = before.ends_with("rotate ")});
    }
    at = end;
  }
  return numbers;
}

/// Which coordinate the i-th number of an argument is.
int axis_of(const Parameter& parameter, std::size_t i) {
  switch (parameter.type) {
    case ParameterType::cell:
    case ParameterType::window:
      return static_cast<int>(i % 2);
    case ParameterType::faces:
      return static_cast<int>(i % 3);
    case ParameterType::numbers:
    case ParameterType::bounds:
    case ParameterType::points:
    case ParameterType::rings: {
      if (parameter.parts.empty()) return -1;
      // "x", "x0", "xmin"; not "yaw"
      const std::string& name = parameter.parts[i % parameter.parts.size()];
      const std::string rest = name.substr(1);
      const bool coordinate = rest.empty() || is_digit(rest.front()) || rest == "min" || rest == "max";
      return coordinate && 'x' <= name.front() && name.front() <= 'z' ? name.front() - 'x' : -1;
    }
    default:
      return -1;
  }
}

std::string written(double value) {
  std::string text = fmt::format("{:.4f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

/// The text with other numbers.
std::string rewritten(const std::string& text, std::span<const WrittenNumber> numbers) {
  std::string out;
  std::size_t at = 0;
  for (const WrittenNumber& number : numbers) {
    out += text.substr(at, number.begin - at) + written(number.value);
    at = number.end;
  }
  return out + text.substr(at);
}

// --- Moves -----------------------------------------------------------------------------------------------

/// The numbers of one argument while they are changed.
struct Draft {
  const Parameter* parameter;
  std::string text;
  std::vector<WrittenNumber> numbers;
};
using Drafts = std::vector<Draft>;

bool chance(Random& random, std::int64_t one_in) { return random.uniform_int(1, one_in) == 1; }

/// Quarter turns stay such; of angles like 30 and 45 degrees, whose sines are roots, another one comes.
void nudge_turn(WrittenNumber& number, Random& random) {
  constexpr double quarter = 90, parts[] = {30, 45, 60};
  const bool simple = std::fmod(number.value, 30) == 0 || std::fmod(number.value, 45) == 0;
  if (simple && std::fmod(number.value, quarter) != 0)
    number.value = parts[random.uniform_int(0, 2)] + quarter * static_cast<double>(random.uniform_int(-2, 1));
  else
    number.value = quarter * static_cast<double>(random.uniform_int(-1, 2));
}

void nudge(WrittenNumber& number, Random& random) {
  if (number.turn) return nudge_turn(number, random);
  const std::int64_t reach =
      std::clamp<std::int64_t>(std::llround(std::min(std::abs(number.value), 1000.0) / 4), 3, 50);
  if (number.decimals == 0) {
    number.value += static_cast<double>(random.uniform_int(-reach, reach));
  } else if (chance(random, 2)) {
    number.value = std::round(2 * number.value) / 2 + static_cast<double>(random.uniform_int(-2, 2)) / 2;
  } else {
    const double grain = number.decimals == 1 ? 0.1 : 0.01;
    number.value = std::round(number.value / grain + static_cast<double>(random.uniform_int(-3, 3))) * grain;
  }
}

/// Faces are moved as they are, or stretched from their first corner: so flat ones stay flat.
class FaceNudges {
 public:
  FaceNudges(Random& random, std::int64_t one_in) : random_(random), one_in_(one_in) {}
  void operator()(WrittenNumber& number) {
    const auto [found, first] = changes_.try_emplace({number.face, number.axis});
    Change& change = found->second;
    if (first) change.from = number.value;
    if (first && chance(random_, one_in_)) {
      WrittenNumber moved = number;
      nudge(moved, random_);
      change.way = moved.value - number.value;
      constexpr double factors[] = {2, 0.5, -1};
      if (chance(random_, 3)) change.factor = factors[random_.uniform_int(0, 2)];
    }
    number.value = change.from + change.way + change.factor * (number.value - change.from);
  }

 private:
  struct Change {
    double from = 0, way = 0, factor = 1;
  };
  Random& random_;
  const std::int64_t one_in_;
  std::map<std::pair<int, int>, Change> changes_;  ///< by face and axis
};

/// Some numbers of one argument, or of all.
void nudge_some(Drafts& drafts, Random& random) {
  const bool all = chance(random, 3);
  const std::int64_t only = random.uniform_int(0, std::ssize(drafts) - 1);
  const std::int64_t one_in = random.uniform_int(1, 3);
  for (std::int64_t i = 0; i < std::ssize(drafts); ++i) {
    if (!all && i != only) continue;
    FaceNudges nudge_face(random, one_in);
    for (WrittenNumber& number : drafts[static_cast<std::size_t>(i)].numbers) {
      if (number.face >= 0)
        nudge_face(number);
      else if (chance(random, one_in))
        nudge(number, random);
    }
  }
}

/// All places, those of one argument, or of some, go through a change of their coordinates.
template <class Change>
void change_places(Drafts& drafts, Random& random, Change change) {
  const std::int64_t which = random.uniform_int(0, 2), only = random.uniform_int(0, std::ssize(drafts) - 1);
  for (std::int64_t i = 0; i < std::ssize(drafts); ++i) {
    if (which == 1 ? i != only : which == 2 && chance(random, 2)) continue;
    for (WrittenNumber& number : drafts[static_cast<std::size_t>(i)].numbers) {
      if (number.axis >= 0) change(number);
    }
  }
}

void mirror(Drafts& drafts, Random& random) {
  const std::int64_t axis = random.uniform_int(0, 2);
  change_places(drafts, random, [axis](WrittenNumber& number) {
    if (number.axis == axis) number.value = -number.value;
  });
}

/// All together, by whole numbers or so that one place gets whole coordinates.
void move(Drafts& drafts, Random& random) {
  double by[3];
  for (double& each : by) each = static_cast<double>(random.uniform_int(-4, 4));
  if (chance(random, 2)) {
    const std::int64_t chosen = random.uniform_int(0, std::ssize(drafts) - 1);
    bool known[3] = {};
    for (const WrittenNumber& number : drafts[static_cast<std::size_t>(chosen)].numbers) {
      if (number.axis < 0 || std::exchange(known[number.axis], true)) continue;
      by[number.axis] = std::round(by[number.axis] / 2) + std::round(number.value) - number.value;
    }
  }
  change_places(drafts, random, [&by](WrittenNumber& number) { number.value += by[number.axis]; });
}

/// x becomes y, and y x.
void turn_round(Drafts& drafts, Random& random) {
  const bool together = !chance(random, 4);
  const std::int64_t only = random.uniform_int(0, std::ssize(drafts) - 1);
  for (std::int64_t i = 0; i < std::ssize(drafts); ++i) {
    if (!together && i != only) continue;
    std::vector<WrittenNumber>& numbers = drafts[static_cast<std::size_t>(i)].numbers;
    for (std::size_t k = 0; k + 1 < numbers.size(); ++k) {
      if (numbers[k].axis == 0 && numbers[k + 1].axis == 1) std::swap(numbers[k].value, numbers[k + 1].value);
    }
  }
}

void scale(Drafts& drafts, Random& random) {
  constexpr double factors[] = {2, 0.5, 1.5, 3};
  const double factor = factors[random.uniform_int(0, 3)];
  change_places(drafts, random, [factor](WrittenNumber& number) {
    const double value = number.value * factor;
    number.value = number.decimals == 0 ? std::round(value) : value;
  });
}

/// Numbers that are easier: whole ones, and no turns.
void simplify(Drafts& drafts, Random& random) {
  for (Draft& draft : drafts) {
    if (chance(random, 2)) continue;
    for (WrittenNumber& number : draft.numbers) {
      number.value = number.turn ? 0 : std::round(number.value);
    }
  }
}

/// After mirroring, the lower borders of a window are the upper ones.
void set_right(Draft& draft) {
  const ParameterType type = draft.parameter->type;
  if (type != ParameterType::bounds && type != ParameterType::window) return;
  const std::size_t half = draft.numbers.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    WrittenNumber &lower = draft.numbers[i], &upper = draft.numbers[half + i];
    if (lower.value > upper.value) std::swap(lower.value, upper.value);
  }
}

/// A maze with a few walls less or more; its rim stays.
std::string with_other_walls(std::string rows, Random& random) {
  const std::size_t width = std::min(rows.find('/'), rows.size()) + 1;
  std::vector<std::size_t> inner;
  for (std::size_t i = width; i + width < rows.size(); ++i) {
    const bool rim = i % width == 0 || i % width + 2 >= width;
    if (!rim && (rows[i] == '#' || rows[i] == '.')) inner.push_back(i);
  }
  if (inner.empty()) return rows;
  for (std::int64_t left = random.uniform_int(1, 6); left > 0; --left) {
    char& cell = rows[inner[static_cast<std::size_t>(random.uniform_int(0, std::ssize(inner) - 1))]];
    cell = cell == '#' ? '.' : '#';
  }
  return rows;
}

/// Whether a reader could be given another value of it.
bool is_changeable(const Parameter& parameter, const Arguments::Entry& entry) {
  switch (parameter.type) {
    case ParameterType::maze:
      return is_maze_rows(entry.text);
    case ParameterType::faces:  // a file's name where they are too many to be written down
      return entry.text.find(',') != std::string::npos;
    case ParameterType::cell:
    case ParameterType::window:
    case ParameterType::integer:
    case ParameterType::number:
    case ParameterType::numbers:
    case ParameterType::bounds:
    case ParameterType::points:
    case ParameterType::rings:
    case ParameterType::factors:
      return !entry.text.empty();
    default:
      return false;
  }
}

/// Whether an argument has a face that is not flat.
bool has_bent_face(const Arguments::Entry& entry) {
  const auto* faces = std::get_if<std::vector<FaceText>>(&entry.value);
  return faces && std::ranges::any_of(*faces, [](const FaceText& face) {
           std::vector<dvec3> corners;
           for (const Tuple& p : face.points) corners.emplace_back(p[0].value, p[1].value, p[2].value);
           return !is_flat(corners);
         });
}

Arguments::Entry entry_of(const Parameter& parameter, const std::string& text) {
  if (parameter.type != ParameterType::maze) return read_argument(parameter, text);
  std::string rows = text + "\n";
  std::ranges::replace(rows, '/', '\n');
  return {.name = parameter.name, .text = text, .content = rows};
}

}  // namespace

const Method& method_of(const TopicEntry& topic, const Arguments& arguments) {
  return *std::ranges::find(topic.methods, arguments.text("method"), &Method::name);
}

std::vector<const Parameter*> read_parameters(const TopicEntry& topic, const Arguments& arguments) {
  const Method& method = method_of(topic, arguments);
  const auto names = [](const std::vector<std::string>& list, const std::string& name) {
    return std::ranges::find(list, name) != list.end();
  };
  std::vector<const Parameter*> read;
  for (const Parameter& parameter : topic.parameters) {
    if (names(method.without, parameter.name) || names(method.unread, parameter.name)) continue;
    if (!arguments.has(parameter.name) || arguments.text(parameter.name).empty()) continue;
    read.push_back(&parameter);
  }
  return read;
}

SimilarInputs::SimilarInputs(const std::vector<const Parameter*>& parameters, const Arguments& model,
                             Random random)
    : random_(random) {
  for (const Parameter* parameter : parameters) {
    if (is_changeable(*parameter, model.entry(parameter->name))) changed_.push_back(parameter);
  }
}

std::size_t SimilarInputs::choice(std::size_t most) {
  return static_cast<std::size_t>(random_.uniform_int(0, static_cast<std::int64_t>(most)));
}

std::optional<Arguments> SimilarInputs::next(const Arguments& near) {
  Drafts drafts;
  for (const Parameter* parameter : changed_) {
    Draft draft{parameter, near.text(parameter->name), {}};
    if (draft.parameter->type != ParameterType::maze) draft.numbers = numbers_written_in(draft.text);
    const bool in_degrees = draft.parameter->type != ParameterType::factors &&
                            draft.parameter->help.find("degrees") != std::string::npos;
    // Of an argument with decimals any number may have some
    int decimals = 0;
    for (const WrittenNumber& number : draft.numbers) decimals = std::max(decimals, number.decimals);
    for (std::size_t i = 0; i < draft.numbers.size(); ++i) {
      draft.numbers[i].axis = axis_of(*draft.parameter, i);
      if (draft.parameter->type == ParameterType::faces) {
        const auto begin = draft.text.begin();
        draft.numbers[i].face = static_cast<int>(
            std::count(begin, begin + static_cast<std::ptrdiff_t>(draft.numbers[i].begin), ';'));
      }
      draft.numbers[i].decimals = decimals;
      draft.numbers[i].turn |= in_degrees;
    }
    drafts.push_back(std::move(draft));
  }
  for (std::int64_t moves = random_.uniform_int(1, 3); moves > 0; --moves) {
    constexpr void (*all[])(Drafts&, Random&) = {nudge_some, nudge_some, nudge_some, mirror,
                                                 move,       turn_round, scale,      simplify};
    all[random_.uniform_int(0, std::ssize(all) - 1)](drafts, random_);
  }
  Arguments drawn = near;
  try {
    for (Draft& draft : drafts) {
      set_right(draft);
      const std::string text = draft.parameter->type == ParameterType::maze
                                   ? with_other_walls(draft.text, random_)
                                   : rewritten(draft.text, draft.numbers);
      if (text == draft.text) continue;
      Arguments::Entry entry = entry_of(*draft.parameter, text);
      // Where numbers were rounded
      if (has_bent_face(entry) && !has_bent_face(near.entry(entry.name))) return std::nullopt;
      entry.given = true;
      drawn.set(std::move(entry));
    }
  } catch (const std::exception&) {
    return std::nullopt;  // a value beyond its parameter's range
  }
  return drawn;
}

}  // namespace gradus::worksheet
