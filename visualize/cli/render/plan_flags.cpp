#include "cli/render/plan_flags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// "120,88,200x100": column and row of the upper left pixel, and how many.
std::optional<Window> window_in(std::string_view text, pipeline::Size size) {
  const std::string word = folded(trimmed(text));
  const std::size_t first = std::min(word.find(','), word.size()), second = word.find(',', first + 1),
                    cross = word.find('x', first);
  if (second == std::string::npos || cross == std::string::npos || cross < second) return std::nullopt;
  const auto column = whole_number(word.substr(0, first)),
             row = whole_number(word.substr(first + 1, second - first - 1)),
             width = whole_number(word.substr(second + 1, cross - second - 1)),
             height = whole_number(word.substr(cross + 1));
  const auto fits = [](const auto& from, const auto& count, int all) {
    return from && count && *from >= 0 && *count >= 1 && *from < all && *count <= all - *from;
  };
  if (!fits(column, width, size.width) || !fits(row, height, size.height)) return std::nullopt;
  const ivec2 lower{static_cast<int>(*column), static_cast<int>(*row)};
  return Window{lower, lower + ivec2{static_cast<int>(*width), static_cast<int>(*height)} - 1};
}

pipeline::Rules rules_without(const std::string& list) {
  pipeline::Rules rules = pipeline::Rules::all();
  std::string_view rest = list;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string word = folded(trimmed(rest.substr(0, comma)));
    more = comma != std::string_view::npos;
    if (more) rest = rest.substr(comma + 1);
    const auto found = std::ranges::find(pipeline::rule_names, word);
    if (word == "all") {
      rules = pipeline::Rules::none();
    } else if (found != pipeline::rule_names.end()) {
      rules = rules.without(static_cast<pipeline::Rule>(found - pipeline::rule_names.begin()));
    } else {
      refuse_flag("without", fmt::format("all, or some of {}", fmt::join(pipeline::rule_names, ", ")),
                  shown(list));
    }
  }
  return rules;
}

}  // namespace

ivec2 pixel_flag(const std::string& flag, const std::string& text, pipeline::Size size) {
  const std::optional<Pair> pair = pair_in(text);
  const auto column = pair ? whole_number(pair->x) : std::nullopt,
             row = pair ? whole_number(pair->y) : std::nullopt;
  const auto fits = [](const auto& at, int count) { return at && 0 <= *at && *at < count; };
  if (!fits(column, size.width) || !fits(row, size.height)) {
    refuse_flag(
        flag, fmt::format("column and row like 120,88 within the picture of {}x{}", size.width, size.height),
        shown(text));
  }
  return {static_cast<int>(*column), static_cast<int>(*row)};
}

PlanWish plan_wish(const Flags& flags, pipeline::Size size) {
  PlanWish wish;
  if (const std::string* text = given(flags, "part")) {
    wish.part = window_in(*text, size);
    if (!wish.part) {
      refuse_flag("part",
                  fmt::format("column, row and size like 120,88,200x100 within the picture of {}x{}",
                              size.width, size.height),
                  shown(*text));
    }
    const auto& [lower, upper] = *wish.part;
    wish.said = fmt::format(" --part {},{},{}x{}", lower.x, lower.y, wish.part->width(), wish.part->height());
  }
  if (const std::string* text = given(flags, "without")) wish.rules = rules_without(*text);
  return wish;
}

}  // namespace gradus::cli
