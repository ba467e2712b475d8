#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "stories/colors.hpp"
#include "stories/factor_text.hpp"
#include "stories/point_text.hpp"
#include "stories/topic.hpp"

namespace gradus {

void refuse(std::string_view parameter, const std::string& what) {
  refuse({Refusal::Kind::argument, what, std::string(parameter)});
}

namespace {

[[noreturn]] void refuse(const Parameter& parameter, const std::string& expected, std::string_view found) {
  gradus::refuse(parameter.name, fmt::format("expected {}, found {}", expected, shown(found)));
}

/// Numbers that the topic can tell of: none too large, none too small.
template <class Tuples>
void require_sizes(const Parameter& parameter, const Tuples& tuples, std::string_view text) {
  const auto fits = [&](const Tuple& tuple) {
    return std::ranges::all_of(tuple, [&](const Number& n) { return parameter.sizes.hold(n.value); });
  };
  if (!std::ranges::all_of(tuples, fits)) refuse(parameter, "numbers " + text_of(parameter.sizes), text);
}

// --- Colours
// -----------------------------------------------------------------------------------------------------

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

std::string lowered(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

int hex_digit(char c) {
  if ('0' <= c && c <= '9') return c - '0';
  return 'a' <= c && c <= 'f' ? c - 'a' + 10 : -1;
}

/// "#rgb" and "#rrggbb" become "#rrggbb"; "" when it is neither.
std::string hex_color(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7)) return "";
  std::string hex = "#";
  for (const char c : text.substr(1)) {
    if (hex_digit(c) < 0) return "";
    hex.append(text.size() == 4 ? 2 : 1, c);
  }
  return hex;
}

std::string canonical_color(const Parameter& parameter, std::string_view text) {
  const std::string word = lowered(trimmed(text));
  const auto named = std::ranges::find(basic_colors, word == "grey" ? "gray" : word, &NamedColor::name);
  if (named != basic_colors.end()) return std::string(named->hex);
  const std::string hex = hex_color(word);
  if (hex.empty()) {
    refuse(parameter, fmt::format("a colour #rrggbb or one of {}", fmt::join(color_names(), ", ")), text);
  }
  return hex;
}

std::string canonical_paint(const Parameter& parameter, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word.size() == 1 && 'a' <= lower(word[0]) && lower(word[0]) <= 'z') return std::string(word);
  return canonical_color(parameter, text);
}

// --- The other types
// ---------------------------------------------------------------------------------------------

std::string canonical_cell(const Parameter& parameter, std::string_view text) {
  const auto pair = pair_in(text);
  const auto x = pair ? whole_number(pair->x) : std::nullopt, y = pair ? whole_number(pair->y) : std::nullopt;
  const auto in_range = [&parameter](const auto& v) {
    return v && parameter.least <= *v && *v <= parameter.most;
  };
  if (!in_range(x) || !in_range(y)) {
    refuse(parameter,
           fmt::format("two whole numbers from {} to {} like 3,4", parameter.least, parameter.most), text);
  }
  return fmt::format("{},{}", *x, *y);
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

std::string canonical_window(const Parameter& parameter, std::string_view text) {
  const auto numbers = four_numbers(trimmed(text));
  if (!numbers) refuse(parameter, "four whole numbers xmin,ymin,xmax,ymax like 0,0,10,10", text);
  const auto [xmin, ymin, xmax, ymax] = *numbers;
  if (xmin > xmax) refuse(parameter, fmt::format("xmin <= xmax, not {} > {}", xmin, xmax), text);
  if (ymin > ymax) refuse(parameter, fmt::format("ymin <= ymax, not {} > {}", ymin, ymax), text);
  return fmt::format("{},{},{},{}", xmin, ymin, xmax, ymax);
}

std::string canonical_integer(const Parameter& parameter, std::string_view text) {
  const auto value = whole_number(text);
  if (!value || *value < parameter.least || *value > parameter.most) {
    refuse(parameter, fmt::format("a whole number from {} to {}", parameter.least, parameter.most), text);
  }
  return fmt::format("{}", *value);
}

std::string canonical_choice(const Parameter& parameter, std::string_view text) {
  const auto folded = [](std::string_view name) {
    std::string word = lowered(trimmed(name));
    std::ranges::replace(word, '-', '_');
    return word;
  };
  const auto chosen = std::ranges::find(parameter.choices, folded(text), folded);
  if (chosen == parameter.choices.end()) {
    refuse(parameter, fmt::format("one of {}", fmt::join(parameter.choices, ", ")), text);
  }
  return *chosen;
}

std::string canonical_flag(const Parameter& parameter, std::string_view text) {
  const std::string word = lowered(trimmed(text));
  if (word == "yes") return "yes";
  if (word.empty() || word == "no") return "";
  refuse(parameter, "yes or no", text);
}

/// A file goes by its name without folders, so that a figure's command is the same wherever it was made.
std::string base_name(std::string_view path) { return std::string(path.substr(path.find_last_of('/') + 1)); }

std::string canonical_picture(const Parameter& parameter, std::string_view text) {
  const std::string name = base_name(text);
  if (name.empty()) refuse(parameter, "a PNG file", text);
  return name;
}

std::string canonical_maze(const Parameter& parameter, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (is_maze_rows(word)) {
    std::string rows(word);
    std::ranges::replace(rows, '\n', '/');
    return rows;
  }
  const std::string name = base_name(text);
  if (trimmed(name).empty()) refuse(parameter, "a text file or rows like '#.#/...'", text);
  return is_maze_rows(trimmed(name)) ? "@" + name : name;  // else the name alone would be taken for rows
}

/// The canonical spelling of a number in the parameter's range.
std::optional<std::string> number_in_range(const Parameter& parameter, std::string_view text) {
  const Read<Number> read = read_number(text);
  const Number* number = std::get_if<Number>(&read);
  const auto least = static_cast<double>(parameter.least), most = static_cast<double>(parameter.most);
  if (!number || number->value < least || number->value > most) return std::nullopt;
  return number->text;
}

std::string canonical_number(const Parameter& parameter, std::string_view text) {
  const auto number = number_in_range(parameter, text);
  if (!number)
    refuse(parameter, fmt::format("a number from {} to {}", parameter.least, parameter.most), text);
  const Tuple alone{std::get<Number>(read_number(*number))};
  require_sizes(parameter, std::span(&alone, 1), text);
  return *number;
}

std::string canonical_numbers(const Parameter& parameter, std::string_view text) {
  const Read<Tuple> read = read_tuple(text, parameter.parts);
  if (const Misread* misread = std::get_if<Misread>(&read)) gradus::refuse(parameter.name, misread->what);
  const Tuple& numbers = std::get<Tuple>(read);
  require_sizes(parameter, std::span(&numbers, 1), text);
  return text_of(numbers);
}

std::string canonical_bounds(const Parameter& parameter, std::string_view text) {
  const Read<Tuple> read = read_tuple(text, parameter.parts);
  if (const Misread* misread = std::get_if<Misread>(&read)) gradus::refuse(parameter.name, misread->what);
  const Tuple& bounds = std::get<Tuple>(read);
  const std::size_t half = bounds.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Number &lower = bounds[i], &upper = bounds[half + i];
    if (lower.value <= upper.value) continue;
    const auto order = fmt::format("{} <= {}, not {} > {}", parameter.parts[i], parameter.parts[half + i],
                                   lower.text, upper.text);
    refuse(parameter, order, text);
  }
  require_sizes(parameter, std::span(&bounds, 1), text);
  return text_of(bounds);
}

std::string canonical_points(const Parameter& parameter, std::string_view text) {
  const Read<std::vector<Tuple>> read = read_tuples(text, parameter.parts);
  if (const Misread* misread = std::get_if<Misread>(&read)) gradus::refuse(parameter.name, misread->what);
  const auto& points = std::get<std::vector<Tuple>>(read);
  const auto count = static_cast<std::int64_t>(points.size());
  if (count < parameter.least)
    gradus::refuse(parameter.name,
                   fmt::format("expected at least {} points, found {}", parameter.least, count));
  if (count > parameter.most)
    gradus::refuse(parameter.name,
                   fmt::format("expected at most {} points, found {}", parameter.most, count));
  require_sizes(parameter, points, text);
  return text_of(points);
}

std::string canonical_rings(const Parameter& parameter, std::string_view text) {
  const Read<std::vector<std::vector<Tuple>>> read = read_rings(text, parameter.parts);
  if (const Misread* misread = std::get_if<Misread>(&read)) gradus::refuse(parameter.name, misread->what);
  const auto& rings = std::get<std::vector<std::vector<Tuple>>>(read);
  std::int64_t all = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto count = static_cast<std::int64_t>(rings[i].size());
    all += count;
    require_sizes(parameter, rings[i], text);
    if (count >= parameter.least) continue;
    gradus::refuse(parameter.name,
                   fmt::format("ring {}: expected at least {} points, with ; between rings alone, "
                               "found {}",
                               i + 1, parameter.least, count));
  }
  if (all > parameter.most)
    gradus::refuse(parameter.name,
                   fmt::format("expected at most {} points in all, found {}", parameter.most, all));
  return text_of(rings);
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

std::string canonical_order(const Parameter& parameter, std::string_view text) {
  const std::vector<std::string> words = words_in(text);
  std::vector<std::string> numbers;
  for (std::size_t i = 1; i <= words.size(); ++i) numbers.push_back(fmt::format("{}", i));
  if (parameter.numbered && std::ranges::is_permutation(words, numbers))
    return fmt::format("{}", fmt::join(words, ","));
  if (!std::ranges::is_permutation(words, parameter.choices)) {
    refuse(parameter,
           fmt::format("{}{}, each once in any order", fmt::join(parameter.choices, ","),
                       parameter.numbered ? " or the numbers 1, 2, … to the last" : ""),
           text);
  }
  return fmt::format("{}", fmt::join(words, ","));
}

std::string canonical_factors(const Parameter& parameter, std::string_view text) {
  const Read<std::vector<FactorText>> read = read_factors(text, parameter.parts);
  if (const Misread* misread = std::get_if<Misread>(&read)) gradus::refuse(parameter.name, misread->what);
  return text_of(std::get<std::vector<FactorText>>(read));
}

std::string canonical_model(const Parameter& parameter, std::string_view text) {
  const std::string name = base_name(text);
  if (name.empty()) refuse(parameter, "an OBJ file", text);
  return name;
}

}  // namespace

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

void Arguments::set(Entry entry) {
  const auto known = std::ranges::find(entries_, entry.name, &Entry::name);
  if (known != entries_.end()) {
    *known = std::move(entry);
  } else {
    entries_.push_back(std::move(entry));
  }
}

bool Arguments::has(std::string_view name) const {
  return std::ranges::find(entries_, name, &Entry::name) != entries_.end();
}

const Arguments::Entry& Arguments::entry(std::string_view name) const {
  const auto known = std::ranges::find(entries_, name, &Entry::name);
  if (known == entries_.end()) refuse(std::string(name), "expected a value, found none");
  return *known;
}

ivec2 Arguments::cell(std::string_view name) const {
  const std::string& value = text(name);
  const auto pair = pair_in(value);
  const auto x = pair ? whole_number(pair->x) : std::nullopt, y = pair ? whole_number(pair->y) : std::nullopt;
  const auto fits = [](const auto& v) { return v && INT32_MIN <= *v && *v <= INT32_MAX; };
  expects(fits(x) && fits(y), "{} is a cell in its canonical spelling, not '{}'", name, value);
  return {static_cast<int>(*x), static_cast<int>(*y)};
}

std::optional<Window> Arguments::window(std::string_view name) const {
  if (!has(name) || text(name).empty()) return std::nullopt;
  const auto numbers = four_numbers(text(name));
  expects(numbers.has_value(), "{} is a window in its canonical spelling, not '{}'", name, text(name));
  const auto at = [&numbers](std::size_t i) { return static_cast<int>((*numbers)[i]); };
  return Window{{at(0), at(1)}, {at(2), at(3)}};
}

std::int64_t Arguments::integer(std::string_view name) const {
  const auto value = whole_number(text(name));
  expects(value.has_value(), "{} is a whole number, not '{}'", name, text(name));
  return *value;
}

std::optional<double> Arguments::number(std::string_view name) const {
  if (!has(name) || text(name).empty()) return std::nullopt;
  const Read<Number> read = read_number(text(name));
  expects(std::holds_alternative<Number>(read), "{} is a number, not '{}'", name, text(name));
  return std::get<Number>(read).value;
}

std::vector<double> Arguments::numbers(std::string_view name) const {
  std::vector<double> values;
  if (!has(name) || text(name).empty()) return values;
  for (const std::string& word : words_in(text(name))) {
    const Read<Number> read = read_number(word);
    expects(std::holds_alternative<Number>(read), "{} has numbers, not '{}'", name, word);
    values.push_back(std::get<Number>(read).value);
  }
  return values;
}

std::optional<dvec3> Arguments::place(std::string_view name) const {
  const std::vector<double> at = numbers(name);
  if (at.empty()) return std::nullopt;
  expects(at.size() == 3, "{} is a place in its canonical spelling, not '{}'", name, text(name));
  return dvec3{at[0], at[1], at[2]};
}

namespace {

/// The numbers of tuples, points or rings in their canonical spelling, one after the other.
std::vector<double> every_number_in(std::string_view text) {
  constexpr std::string_view separators = ",; ";
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = text.find_first_not_of(separators, at)) < text.size();) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    numbers.push_back(std::get<Number>(read_number(text.substr(at, end - at))).value);
    at = end;
  }
  return numbers;
}

std::vector<Tuple> tuples_of(const Arguments& arguments, std::string_view name,
                             const std::vector<std::string>& parts) {
  if (!arguments.has(name) || arguments.text(name).empty()) return {};
  Read<std::vector<Tuple>> read = read_tuples(arguments.text(name), parts);
  expects(std::holds_alternative<std::vector<Tuple>>(read),
          "{} has points in their canonical spelling, not '{}'", name, arguments.text(name));
  return std::get<std::vector<Tuple>>(std::move(read));
}

}  // namespace

std::vector<dvec2> Arguments::points(std::string_view name) const {
  std::vector<dvec2> points;
  for (const Tuple& p : tuples_of(*this, name, {"x", "y"})) points.emplace_back(p[0].value, p[1].value);
  return points;
}

std::vector<dvec3> Arguments::places(std::string_view name) const {
  std::vector<dvec3> points;
  for (const Tuple& p : tuples_of(*this, name, {"x", "y", "z"})) {
    points.emplace_back(p[0].value, p[1].value, p[2].value);
  }
  return points;
}

std::vector<std::vector<dvec2>> Arguments::rings(std::string_view name) const {
  std::vector<std::vector<dvec2>> rings;
  if (!has(name) || text(name).empty()) return rings;
  const std::vector<std::string> parts{"x", "y"};
  const Read<std::vector<std::vector<Tuple>>> read = read_rings(text(name), parts);
  expects(!std::holds_alternative<Misread>(read), "{} has rings in their canonical spelling, not '{}'", name,
          text(name));
  for (const auto& ring : std::get<std::vector<std::vector<Tuple>>>(read)) {
    rings.emplace_back();
    for (const Tuple& p : ring) rings.back().emplace_back(p[0].value, p[1].value);
  }
  return rings;
}

std::optional<std::vector<std::size_t>> Arguments::numbered_order(std::string_view name) const {
  std::vector<std::size_t> order;
  for (const std::string& word : words_in(text(name))) {
    const auto number = whole_number(word);
    if (!number) return std::nullopt;
    expects(*number >= 1, "{} counts from 1, not '{}'", name, word);
    order.push_back(static_cast<std::size_t>(*number - 1));
  }
  return order;
}

std::vector<std::size_t> Arguments::order(const Parameter& parameter) const {
  std::vector<std::size_t> order;
  for (const std::string& word : words_in(text(parameter.name))) {
    const auto found = std::ranges::find(parameter.choices, word);
    expects(found != parameter.choices.end(), "{} has no '{}'", parameter.name, word);
    order.push_back(static_cast<std::size_t>(found - parameter.choices.begin()));
  }
  return order;
}

Rgba8 Arguments::color(std::string_view name) const {
  const std::string& value = text(name);
  expects(value.size() == 7 && hex_color(value) == value, "{} is a colour #rrggbb, not '{}'", name, value);
  const auto part = [&value](std::size_t at) {
    return static_cast<std::uint8_t>(16 * hex_digit(value[at]) + hex_digit(value[at + 1]));
  };
  return {part(1), part(3), part(5), 255};
}

std::string text_of(const Sizes& sizes) {
  const auto written = [](double x) {
    std::string text = fmt::format("{:g}", x);  // "1e+06" becomes "1e6"
    const std::size_t power = text.find('e');
    if (power == std::string::npos) return text;
    const bool small = text[power + 1] == '-';
    const std::size_t digits = text.find_first_not_of("+-0", power + 1);
    return text.substr(0, power + 1) + (small ? "-" : "") + text.substr(digits);
  };
  if (!sizes.limited()) return "of any size";
  if (sizes.least == 0) return fmt::format("up to {} in size", written(sizes.most));
  return fmt::format("0 or from {} to {} in size", written(sizes.least), written(sizes.most));
}

void refuse(const Arguments& arguments, std::initializer_list<std::string_view> parameters,
            const std::string& what_was_expected) {
  const auto* const given = std::ranges::find_if(
      parameters, [&](std::string_view name) { return arguments.has(name) && arguments.entry(name).given; });
  refuse(std::string(given == parameters.end() ? *parameters.begin() : *given), what_was_expected);
}

void require_sizes(const Arguments& arguments, std::string_view parameter, const Sizes& sizes) {
  for (const double x : every_number_in(arguments.text(parameter))) {
    if (sizes.hold(x)) continue;
    refuse(std::string(parameter),
           fmt::format("method {} needs numbers {}, found {}", arguments.text("method"), text_of(sizes),
                       shown(arguments.text(parameter))));
  }
}

std::string canonical(const Parameter& parameter, std::string_view text) {
  switch (parameter.type) {
    case ParameterType::cell:
      return canonical_cell(parameter, text);
    case ParameterType::window:
      return canonical_window(parameter, text);
    case ParameterType::integer:
      return canonical_integer(parameter, text);
    case ParameterType::choice:
      return canonical_choice(parameter, text);
    case ParameterType::color:
      return canonical_color(parameter, text);
    case ParameterType::paint:
      return canonical_paint(parameter, text);
    case ParameterType::picture:
      return canonical_picture(parameter, text);
    case ParameterType::maze:
      return canonical_maze(parameter, text);
    case ParameterType::number:
      return canonical_number(parameter, text);
    case ParameterType::numbers:
      return canonical_numbers(parameter, text);
    case ParameterType::bounds:
      return canonical_bounds(parameter, text);
    case ParameterType::points:
      return canonical_points(parameter, text);
    case ParameterType::rings:
      return canonical_rings(parameter, text);
    case ParameterType::order:
      return canonical_order(parameter, text);
    case ParameterType::factors:
      return canonical_factors(parameter, text);
    case ParameterType::model:
      return canonical_model(parameter, text);
    case ParameterType::flag:
      return canonical_flag(parameter, text);
  }
  gradus::refuse(parameter.name, "expected a known type of value, found none");
}

}  // namespace gradus
