#include "request/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>

#include "core/refusal.hpp"
#include "stories/point_text.hpp"

namespace gradus {

std::string folded(std::string_view name) {
  std::string result(name);
  for (char& c : result) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '-') c = '_';
  }
  return result;
}

std::string hyphened(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '_', '-');
  return result;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Three rows of the usual table: the one being filled and the two above it
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    std::swap(above, row);
  }
  return above[b.size()];
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t longest = 64;  // nobody mistypes a name into a page of text
  if (word.empty() || word.size() > longest) return std::nullopt;
  const std::string wanted = folded(word);
  std::optional<std::string> nearest;
  std::size_t best = 1 + (wanted.size() + 1) / 3;
  for (const std::string& name : names) {
    // A beginning with a slip counts like the whole name with a slip
    const std::string whole = folded(name), start = whole.substr(0, wanted.size());
    const std::size_t distance = std::min(edit_distance(wanted, whole), edit_distance(wanted, start) + 1);
    if (distance >= best) continue;
    best = distance;
    nearest = name;
  }
  return nearest;
}

std::vector<std::size_t> matching_names(std::string_view word, std::span<const std::string> names) {
  const std::string wanted = folded(word);
  std::vector<std::size_t> beginnings;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = folded(names[i]);
    if (name == wanted) return {i};
    if (!wanted.empty() && name.starts_with(wanted)) beginnings.push_back(i);
  }
  // "fig" means figure although there is figures: one name that all the others go on from
  for (const std::size_t i : beginnings) {
    const bool starts_all = std::ranges::all_of(
        beginnings, [&](std::size_t other) { return folded(names[other]).starts_with(folded(names[i])); });
    if (starts_all) return {i};
  }
  return beginnings;
}

std::string suggestion(std::string_view word, std::span<const std::string> names) {
  const auto nearest = nearest_name(word, names);
  return nearest ? fmt::format(", did you mean '{}'?", *nearest) : "";
}

std::size_t choose_name(std::string_view what, std::string_view word, std::span<const std::string> names) {
  const std::vector<std::size_t> matches = matching_names(word, names);
  if (matches.size() == 1) return matches.front();
  std::vector<std::string> offered;
  for (const std::size_t i : matches) offered.push_back(names[i]);
  if (offered.empty()) offered.assign(names.begin(), names.end());
  refuse_usage(fmt::format("{}: expected one of {}, found {}{}", what, fmt::join(offered, ", "), shown(word),
                           matches.empty() ? suggestion(word, names) : ""));
}

std::size_t choose_value(std::string_view flag, std::string_view word, std::span<const std::string> names) {
  return choose_name(fmt::format("--{}", flag), trimmed(word), names);
}

bool matches_glob(std::string_view pattern, std::string_view name) {
  // Only outside brackets does a hyphen stand for itself: [a-c] stays a range
  std::string wanted;
  bool bracket = false;
  for (const char c : pattern) {
    if (c == '[') bracket = true;
    if (c == ']') bracket = false;
    wanted += bracket ? c : folded({&c, 1})[0];
  }
  return fnmatch(wanted.c_str(), folded(name).c_str(), 0) == 0;
}

std::string counted(std::int64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string shell_quoted(std::string_view value) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./,:=@%+-";
  if (!value.empty() && value.find_first_not_of(plain) == std::string_view::npos) return std::string(value);
  std::string quoted = "'";
  for (const char c : value) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string flag_with(std::string_view flag, std::string_view value) {
  return fmt::format("--{}{}{}", flag, value.starts_with("--") ? "=" : " ", shell_quoted(value));
}

std::optional<std::vector<std::string>> shell_words(std::string_view line) {
  std::vector<std::string> words;
  bool inside = false;  // a word has begun, be it empty
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == ' ' || c == '\t' || c == '\n') {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c == '\'') {
      const std::size_t end = line.find('\'', i + 1);
      if (end == std::string_view::npos) return std::nullopt;
      words.back() += line.substr(i + 1, end - i - 1);
      i = end;
    } else if (c == '\\') {
      if (++i == line.size()) return std::nullopt;
      words.back() += line[i];
    } else {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace gradus
