// From one argument as the user wrote it to its value and its canonical spelling.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "stories/colors.hpp"
#include "stories/factor_text.hpp"
#include "stories/point_text.hpp"
#include "stories/topic.hpp"

namespace gradus {

namespace {

/// What a text was read as, and how it is written.
struct Taken {
  ArgumentValue value;
  std::string text;
};

[[noreturn]] void refuse_value(const Parameter& parameter, const std::string& expected,
                               std::string_view found) {
  refuse(parameter.name, "expected {}, found {}", expected, shown(found));
}

/// What was read, if it could be.
template <class T>
T taken_or_refused(const Parameter& parameter, Read<T> read) {
  if (const Misread* misread = std::get_if<Misread>(&read)) refuse(parameter.name, misread->what);
  return std::get<T>(std::move(read));
}

/// Numbers that the topic can tell of: none too large, none too small.
void require_sizes(const Parameter& parameter, const ArgumentValue& value, std::string_view text) {
  if (!all_hold(parameter.sizes, value)) refuse_value(parameter, "numbers " + text_of(parameter.sizes), text);
}

// --- Colours

struct NamedColor {
  std::string_view name, hex;
};
/// The sixteen basic colours of CSS.
constexpr std::array<NamedColor, 16> basic_colors{{{"black", "#000000"},
                                                   {"silver", "#c0c0c0"},
                                                   {"gray", "#808080"},
                                                   {"white", "#ffffff"},
                                                   {"maroon", "#800000"},
                                                   {"red", "#ff0000"},
                                                   {"purple", "#800080"},
                                                   {"fuchsia", "#ff00ff"},
                                                   {"green", "#008000"},
                                                   {"lime", "#00ff00"},
                                                   {"olive", "#808000"},
                                                   {"yellow", "#ffff00"},
                                                   {"navy", "#000080"},
                                                   {"blue", "#0000ff"},
                                                   {"teal", "#008080"},
                                                   {"aqua", "#00ffff"}}};

char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int hex_digit(char c) {
  if ('0' <= c && c <= '9') return c - '0';
  return 'a' <= c && c <= 'f' ? c - 'a' + 10 : -1;
}

/// Of "#rrggbb".
Rgba8 color_of(std::string_view hex) {
  const auto part = [hex](std::size_t at) {
    return static_cast<std::uint8_t>(16 * hex_digit(hex[at]) + hex_digit(hex[at + 1]));
  };
  return {part(1), part(3), part(5), 255};
}

Taken read_color(const Parameter& parameter, std::string_view text) {
  const std::string word = lowered(trimmed(text));
  const auto named = std::ranges::find(basic_colors, word == "grey" ? "gray" : word, &NamedColor::name);
  const std::string hex = named == basic_colors.end() ? hex_color(word) : std::string(named->hex);
  if (hex.empty()) {
    const std::string names = fmt::format("{}", fmt::join(color_names(), ", "));
    refuse_value(parameter, "a colour #rrggbb or one of " + names, text);
  }
  return {color_of(hex), hex};
}

Taken read_paint(const Parameter& parameter, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word.size() == 1 && 'a' <= lower(word[0]) && lower(word[0]) <= 'z') return {{}, std::string(word)};
  return read_color(parameter, text);
}

// --- The other types

Taken read_cell(const Parameter& parameter, std::string_view text) {
  const auto pair = pair_in(text);
  const auto x = pair ? whole_number(pair->x) : std::nullopt, y = pair ? whole_number(pair->y) : std::nullopt;
  const auto in_range = [&parameter](const auto& v) {
    return v && parameter.least <= *v && *v <= parameter.most;
  };
  if (!in_range(x) || !in_range(y)) {
    refuse_value(parameter,
                 fmt::format("two whole numbers from {} to {} like 3,4", parameter.least, parameter.most),
                 text);
  }
  return {ivec2(*x, *y), fmt::format("{},{}", *x, *y)};
}

/// The four numbers between commas, if there are just four.
std::optional<std::array<std::int64_t, 4>> four_numbers(std::string_view text) {
  std::array<std::int64_t, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 3)) return std::nullopt;
    const auto number = whole_number(trimmed(text.substr(0, comma)));
    if (!number || *number < INT32_MIN || *number > INT32_MAX) return std::nullopt;
    numbers[i] = *number;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return numbers;
}

Taken read_window(const Parameter& parameter, std::string_view text) {
  const auto numbers = four_numbers(trimmed(text));
  if (!numbers) refuse_value(parameter, "four whole numbers xmin,ymin,xmax,ymax like 0,0,10,10", text);
  const auto [xmin, ymin, xmax, ymax] = *numbers;
  if (xmin > xmax) refuse_value(parameter, fmt::format("xmin <= xmax, not {} > {}", xmin, xmax), text);
  if (ymin > ymax) refuse_value(parameter, fmt::format("ymin <= ymax, not {} > {}", ymin, ymax), text);
  return {Window{{xmin, ymin}, {xmax, ymax}}, fmt::format("{},{},{},{}", xmin, ymin, xmax, ymax)};
}

Taken read_integer(const Parameter& parameter, std::string_view text) {
  const auto value = whole_number(text);
  if (!value || *value < parameter.least || *value > parameter.most) {
    refuse_value(parameter, fmt::format("a whole number from {} to {}", parameter.least, parameter.most),
                 text);
  }
  return {*value, fmt::format("{}", *value)};
}

Taken read_choice(const Parameter& parameter, std::string_view text) {
  const auto folded = [](std::string_view name) {
    std::string word = lowered(trimmed(name));
    std::ranges::replace(word, '-', '_');
    return word;
  };
  const auto chosen = std::ranges::find(parameter.choices, folded(text), folded);
  if (chosen == parameter.choices.end()) {
    refuse_value(parameter, fmt::format("one of {}", fmt::join(parameter.choices, ", ")), text);
  }
  return {{}, *chosen};
}

Taken read_flag(const Parameter& parameter, std::string_view text) {
  const std::string word = lowered(trimmed(text));
  if (word == "yes") return {true, word};
  if (word.empty() || word == "no") return {false, ""};
  refuse_value(parameter, "yes or no", text);
}

/// A file goes by its name without folders, so that a figure's command is the same wherever it was made.
std::string base_name(std::string_view path) { return std::string(path.substr(path.find_last_of('/') + 1)); }

Taken read_picture(const Parameter& parameter, std::string_view text) {
  const std::string name = base_name(text);
  if (name.empty()) refuse_value(parameter, "a PNG or JPEG file", text);
  return {{}, name};
}

Taken read_model(const Parameter& parameter, std::string_view text) {
  const std::string name = base_name(text);
  if (name.empty()) refuse_value(parameter, "an OBJ file", text);
  return {{}, name};
}

Taken read_maze(const Parameter& parameter, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (is_maze_rows(word)) {
    std::string rows(word);
    std::ranges::replace(rows, '\n', '/');
    return {{}, rows};
  }
  const std::string name = base_name(text);
  if (trimmed(name).empty()) refuse_value(parameter, "a text file or rows like '#.#/...'", text);
  return {{}, is_maze_rows(trimmed(name)) ? "@" + name : name};  // else the name would be taken for rows
}

Taken read_one_number(const Parameter& parameter, std::string_view text) {
  const Read<Number> read = read_number(text);
  const Number* number = std::get_if<Number>(&read);
  const auto least = static_cast<double>(parameter.least), most = static_cast<double>(parameter.most);
  if (!number || number->value < least || number->value > most)
    refuse_value(parameter, fmt::format("a number from {} to {}", parameter.least, parameter.most), text);
  require_sizes(parameter, *number, text);
  return {*number, number->text};
}

Taken read_numbers(const Parameter& parameter, std::string_view text) {
  const Tuple numbers = taken_or_refused(parameter, read_tuple(text, parameter.parts));
  require_sizes(parameter, numbers, text);
  return {numbers, text_of(numbers)};
}

Taken read_bounds(const Parameter& parameter, std::string_view text) {
  const Tuple bounds = taken_or_refused(parameter, read_tuple(text, parameter.parts));
  const std::size_t half = bounds.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Number &lower = bounds[i], &upper = bounds[half + i];
    if (lower.value <= upper.value) continue;
    const auto order = fmt::format("{} <= {}, not {} > {}", parameter.parts[i], parameter.parts[half + i],
                                   lower.text, upper.text);
    refuse_value(parameter, order, text);
  }
  require_sizes(parameter, bounds, text);
  return {bounds, text_of(bounds)};
}

Taken read_points(const Parameter& parameter, std::string_view text) {
  const auto points = taken_or_refused(parameter, read_tuples(text, parameter.parts));
  const std::int64_t count = std::ssize(points);
  if (count < parameter.least)
    refuse(parameter.name, "expected at least {} points, found {}", parameter.least, count);
  if (count > parameter.most)
    refuse(parameter.name, "expected at most {} points, found {}", parameter.most, count);
  require_sizes(parameter, points, text);
  return {points, text_of(points)};
}

Taken read_all_rings(const Parameter& parameter, std::string_view text) {
  const auto rings = taken_or_refused(parameter, read_rings(text, parameter.parts));
  std::int64_t all = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::int64_t count = std::ssize(rings[i]);
    all += count;
    require_sizes(parameter, rings[i], text);
    if (count >= parameter.least) continue;
    refuse(parameter.name, "ring {}: expected at least {} points, with ; between rings alone, found {}",
           i + 1, parameter.least, count);
  }
  if (all > parameter.most)
    refuse(parameter.name, "expected at most {} points in all, found {}", parameter.most, all);
  return {rings, text_of(rings)};
}

/// The words between commas.
std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    words.push_back(lowered(trimmed(text.substr(at, end - at))));
    at = end + 1;
  }
  return words;
}

/// The words as an order of these names, each once; nothing where they are none.
std::optional<std::vector<std::size_t>> order_of(const std::vector<std::string>& words,
                                                 const std::vector<std::string>& names) {
  if (!std::ranges::is_permutation(words, names)) return std::nullopt;
  std::vector<std::size_t> places;
  for (const std::string& word : words)
    places.push_back(static_cast<std::size_t>(std::ranges::find(names, word) - names.begin()));
  return places;
}

Taken read_order(const Parameter& parameter, std::string_view text) {
  const std::vector<std::string> words = words_in(text);
  const std::string written = fmt::format("{}", fmt::join(words, ","));
  std::vector<std::string> numbers;
  for (std::size_t i = 1; i <= words.size(); ++i) numbers.push_back(fmt::format("{}", i));
  if (parameter.numbered) {
    if (auto places = order_of(words, numbers)) return {Order{std::move(*places), true}, written};
  }
  auto places = order_of(words, parameter.choices);
  if (!places) {
    refuse_value(parameter,
                 fmt::format("{}{}, each once in any order", fmt::join(parameter.choices, ","),
                             parameter.numbered ? " or the numbers 1, 2, … to the last" : ""),
                 text);
  }
  return {Order{std::move(*places)}, written};
}

Taken read_all_faces(const Parameter& parameter, std::string_view text) {
  const auto faces = taken_or_refused(parameter, read_faces(text));
  std::int64_t corners = 0;
  for (const FaceText& face : faces) {
    corners += std::ssize(face.points);
    require_sizes(parameter, face.points, text_of(face.points));
  }
  if (corners > parameter.most)
    refuse(parameter.name, "expected at most {} corners in all, found {}", parameter.most, corners);
  return {faces, text_of(faces)};
}

Taken read_all_factors(const Parameter& parameter, std::string_view text) {
  const auto factors = taken_or_refused(parameter, read_factors(text, parameter.parts));
  return {factors, text_of(factors)};
}

Taken read(const Parameter& parameter, std::string_view text) {
  switch (parameter.type) {
    case ParameterType::cell:
      return read_cell(parameter, text);
    case ParameterType::window:
      return read_window(parameter, text);
    case ParameterType::integer:
      return read_integer(parameter, text);
    case ParameterType::choice:
      return read_choice(parameter, text);
    case ParameterType::color:
      return read_color(parameter, text);
    case ParameterType::paint:
      return read_paint(parameter, text);
    case ParameterType::picture:
      return read_picture(parameter, text);
    case ParameterType::maze:
      return read_maze(parameter, text);
    case ParameterType::number:
      return read_one_number(parameter, text);
    case ParameterType::numbers:
      return read_numbers(parameter, text);
    case ParameterType::bounds:
      return read_bounds(parameter, text);
    case ParameterType::points:
      return read_points(parameter, text);
    case ParameterType::rings:
      return read_all_rings(parameter, text);
    case ParameterType::order:
      return read_order(parameter, text);
    case ParameterType::factors:
      return read_all_factors(parameter, text);
    case ParameterType::faces:
      return read_all_faces(parameter, text);
    case ParameterType::model:
      return read_model(parameter, text);
    case ParameterType::flag:
      return read_flag(parameter, text);
  }
  refuse(parameter.name, "expected a known type of value, found none");
}

}  // namespace

std::string hex_color(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7)) return "";
  std::string hex = "#";
  for (const char c : text.substr(1)) {
    if (hex_digit(c) < 0) return "";
    hex.append(text.size() == 4 ? 2 : 1, c);
  }
  return hex;
}

std::vector<std::string> color_names() {
  std::vector<std::string> names;
  for (const NamedColor& color : basic_colors) names.emplace_back(color.name);
  return names;
}

bool is_maze_rows(std::string_view text) {
  const auto in_maze = [](char c) { return c == '#' || c == '.' || ('a' <= lower(c) && lower(c) <= 'z'); };
  const std::size_t width = text.find_first_of("/\n");
  bool even = true, free = false;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("/\n", start), text.size());
    const std::string_view row = text.substr(start, end - start);
    if (row.empty() || !std::ranges::all_of(row, in_maze)) return false;
    even = even && row.size() == std::min(width, text.size());
    free = free || row.find('.') != std::string_view::npos;
    start = end + 1;
  }
  return text.find('#') != std::string_view::npos || (even && free && !text.ends_with(".txt"));
}

Arguments::Entry read_argument(const Parameter& parameter, std::string_view text) {
  auto [value, canonical] = read(parameter, text);
  return {.name = parameter.name, .text = std::move(canonical), .value = std::move(value)};
}

std::string canonical(const Parameter& parameter, std::string_view text) {
  return read_argument(parameter, text).text;
}

}  // namespace gradus
