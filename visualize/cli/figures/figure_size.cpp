#include "cli/figures/figure_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <tuple>
#include <utility>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {

namespace {

constexpr double least_side = 160, most_side = 8192;

/// Pixels for a length: 96 per inch, as in CSS.
std::optional<double> unit_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 5> units{
      {{"", 1}, {"px", 1}, {"cm", 96 / 2.54}, {"mm", 96 / 25.4}, {"in", 96}}};
  const auto unit = std::ranges::find(units, name, &std::pair<std::string_view, double>::first);
  return unit == units.end() ? std::nullopt : std::optional(unit->second);
}

struct Length {
  double pixels;
  std::string text;
};
/// "1280", "12cm", "4.7in".
std::optional<Length> length_in(std::string_view text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of("0123456789."), text.size());
  const auto number = decimal(text.substr(0, end), 0.1, 100'000);
  const auto unit = unit_of(text.substr(end));
  if (!number || !unit) return std::nullopt;
  const std::string_view name = text.substr(end) == "px" ? "" : text.substr(end);
  return Length{*number * *unit, fmt::format("{}{}", *number, name)};
}

/// "4:3" as a slide of 720 lines (a tall one: 720 columns).
std::optional<std::pair<double, double>> ratio_in(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto across = whole_number(text.substr(0, colon)), down = whole_number(text.substr(colon + 1));
  if (!across || !down || *across < 1 || *down < 1 || *across > 100 || *down > 100) return std::nullopt;
  const double ratio = static_cast<double>(*across) / static_cast<double>(*down);
  return ratio >= 1 ? std::pair{720 * ratio, 720.0} : std::pair{720.0, 720 / ratio};
}

/// "1280x720", "12cm x 8cm": the x that has a length on either side.
std::optional<std::pair<Length, Length>> sides_in(std::string_view text) {
  for (std::size_t cross = text.find('x'); cross != std::string_view::npos;
       cross = text.find('x', cross + 1)) {
    const auto width = length_in(text.substr(0, cross)), height = length_in(text.substr(cross + 1));
    if (width && height) return std::pair{*width, *height};
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> decimal(std::string_view text, double least, double most) {
  text = trimmed(text);
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !(least <= value && value <= most))
    return {};
  return value;
}

std::string read_size(FigureSpec& spec, const std::string& text) {
  const std::string word = folded(trimmed(text));
  const auto ratio = ratio_in(word);
  const auto sides = sides_in(word);
  const std::pair size = ratio   ? *ratio
                         : sides ? std::pair{sides->first.pixels, sides->second.pixels}
                                 : std::pair{0.0, 0.0};
  const auto fits = [](double side) { return least_side <= side && side <= most_side; };
  if (!fits(size.first) || !fits(size.second)) {
    refuse_flag(
        "size",
        fmt::format(
            "a width and a height like 1280x720 or 12cmx8cm ({} to {} pixels, 96 per inch), or a ratio "
            "like 4:3",
            least_side, most_side),
        shown(text));
  }
  std::tie(spec.look.width, spec.look.height) = size;
  const std::string canonical = ratio ? word : fmt::format("{}x{}", sides->first.text, sides->second.text);
  return canonical == "1280x720" || canonical == "16:9" ? "" : canonical;
}

std::string read_scale(FigureSpec& spec, const std::string& text) {
  const auto value = decimal(text, 0.1, 8);
  if (!value) refuse_flag("scale", "a number from 0.1 to 8", shown(text));
  spec.scale = *value;
  return *value == 1 ? "" : fmt::format("{}", *value);
}

}  // namespace gradus::cli
