#include "stories/factor_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gradus {
namespace {

using Kind = FactorText::Kind;

constexpr std::array<std::pair<std::string_view, Kind>, 5> verbs{{{"translate", Kind::translate},
                                                                  {"scale", Kind::scale},
                                                                  {"rotate", Kind::rotate},
                                                                  {"shear", Kind::shear},
                                                                  {"reflect", Kind::reflect}}};
constexpr std::array<std::pair<std::string_view, Mirror>, 4> mirrors{
    {{"x", Mirror::x_axis}, {"y", Mirror::y_axis}, {"origin", Mirror::origin}, {"y=x", Mirror::diagonal}}};
constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// A factor of each kind, to be copied: in the plane, in space.
std::string_view example_of(Kind kind, bool space) {
  switch (kind) {
    case Kind::translate:
      return space ? "translate 2,1,0" : "translate 2,1";
    case Kind::scale:
      return space ? "scale 2,1,1 about 1,1,1" : "scale 2,3 about 1,1";
    case Kind::rotate:
      return space ? "rotate 30 about 0,1,1 through 1,1,0" : "rotate 30 about 1,1";
    case Kind::shear:
      return "shear 0.5,0 about 1,1";
    case Kind::reflect:
      return "reflect 0,1 3,2' or 'reflect y=x";
  }
  return "";
}

std::string_view verb_of(Kind kind) {
  return std::ranges::find(verbs, kind, &std::pair<std::string_view, Kind>::second)->first;
}

/// Cuts the text at a word of its own, white space around it: what is left of it stays, what is right of it
/// is returned; nothing where the word is missing.
std::optional<std::string_view> cut_at(std::string_view& text, std::string_view word) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (at == 0 || !blank(text[at - 1]) || (end < text.size() && !blank(text[end]))) continue;
    const std::string_view right = trimmed(text.substr(end));
    text = trimmed(text.substr(0, at));
    return right;
  }
  return std::nullopt;
}

/// Numbers, as many as there are names.
std::optional<Tuple> tuple_in(std::string_view text, std::span<const std::string> names) {
  Read<Tuple> read = read_tuple(text, names);
  if (!std::holds_alternative<Tuple>(read)) return std::nullopt;
  return std::get<Tuple>(std::move(read));
}

/// Whether products of twelve such factors stay numbers.
bool fits(const Tuple& tuple) {
  return std::ranges::all_of(tuple, [](const Number& n) {
    return n.value == 0 || (1e-15 <= std::abs(n.value) && std::abs(n.value) <= 1e15);
  });
}

const std::vector<std::string> one_number{"number"};

bool all_zero(const Tuple& tuple) {
  return std::ranges::all_of(tuple, [](const Number& n) { return n.value == 0; });
}

/// The direction of an axis: a letter or three numbers.
std::optional<Tuple> axis_in(std::string_view text, std::span<const std::string> names) {
  const auto letter = std::ranges::find(axes, text);
  if (letter == axes.end()) return tuple_in(text, names);
  Tuple unit(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool one = axes[i] == *letter;
    unit[i] = {one ? 1.0 : 0.0, Fraction{one, 1}, one ? "1" : "0"};
  }
  return unit;
}

/// What stands behind the verb; nothing where it can't be read.
std::optional<FactorText> factor_in(Kind kind, std::string_view rest, std::span<const std::string> names) {
  const bool space = names.size() == 3;
  FactorText factor{.kind = kind};
  const auto put = [](std::optional<Tuple> tuple, Tuple& into) {
    if (tuple) into = std::move(*tuple);
    return tuple.has_value();
  };
  if (kind == Kind::reflect) {
    const auto named = std::ranges::find(mirrors, rest, &std::pair<std::string_view, Mirror>::first);
    if (named != mirrors.end()) {
      factor.mirror = named->second;
      return factor;
    }
    Read<std::vector<Tuple>> line = read_tuples(rest, names);
    if (!std::holds_alternative<std::vector<Tuple>>(line)) return std::nullopt;
    factor.line = std::get<std::vector<Tuple>>(std::move(line));
    return factor.line.size() == 2 ? std::optional(factor) : std::nullopt;
  }
  if (kind == Kind::rotate && space) {
    const auto through = cut_at(rest, "through");
    const auto about = cut_at(rest, "about");
    if (!about || !put(axis_in(*about, names), factor.axis)) return std::nullopt;
    if (through && !put(tuple_in(*through, names), factor.pivot)) return std::nullopt;
    return put(tuple_in(rest, one_number), factor.amount) ? std::optional(factor) : std::nullopt;
  }
  const auto about = cut_at(rest, "about");
  if (about && (kind == Kind::translate || !put(tuple_in(*about, names), factor.pivot))) return std::nullopt;
  const bool one = kind == Kind::rotate || (kind == Kind::scale && rest.find(',') == std::string_view::npos);
  const bool read =
      put(tuple_in(rest, one ? std::span<const std::string>(one_number) : names), factor.amount);
  return read ? std::optional(factor) : std::nullopt;
}

/// One factor, or what is wrong with it.
Read<FactorText> read_factor(std::string_view text, std::span<const std::string> names) {
  const bool space = names.size() == 3;
  const std::string word = lowered(text);
  const std::size_t end = std::min(word.find_first_of(" \t\r\n"), word.size());
  const auto verb = std::ranges::find(verbs, std::string_view(word).substr(0, end),
                                      &std::pair<std::string_view, Kind>::first);
  const auto known = [space](Kind kind) { return !space || (kind != Kind::shear && kind != Kind::reflect); };
  if (verb == verbs.end() || !known(verb->second)) {
    const std::string_view list =
        space ? "translate, scale or rotate" : "translate, scale, rotate, shear or reflect";
    return Misread{fmt::format("expected {}, found {}", list, shown(text))};
  }
  auto factor = factor_in(verb->second, trimmed(std::string_view(word).substr(end)), names);
  if (!factor) {
    return Misread{
        fmt::format("expected something like '{}', found {}", example_of(verb->second, space), shown(text))};
  }
  const bool fit = fits(factor->amount) && fits(factor->pivot) && fits(factor->axis) &&
                   std::ranges::all_of(factor->line, fits);
  if (!fit)
    return Misread{fmt::format("expected numbers 0 or from 1e-15 to 1e15 in size, found {}", shown(text))};
  if (factor->kind == Kind::rotate && space && all_zero(factor->axis))
    return Misread{fmt::format("expected an axis, not the zero vector, found {}", shown(text))};
  if (factor->line.size() == 2 && text_of(factor->line[0]) == text_of(factor->line[1]))
    return Misread{fmt::format("expected two different points of the mirror, found {}", shown(text))};
  return *factor;
}

}  // namespace

Read<std::vector<FactorText>> read_factors(std::string_view text, std::span<const std::string> names) {
  std::vector<FactorText> factors;
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    Read<FactorText> factor = read_factor(trimmed(rest.substr(0, end)), names);
    if (const Misread* misread = std::get_if<Misread>(&factor))
      return Misread{fmt::format("factor {}: {}", factors.size() + 1, misread->what)};
    factors.push_back(std::get<FactorText>(std::move(factor)));
    rest = trimmed(rest.substr(std::min(end + 1, rest.size())));
  }
  if (factors.empty() || factors.size() > most_factors) {
    return Misread{fmt::format("expected 1 to {} factors like '{}', found {}", most_factors,
                               example_of(Kind::rotate, names.size() == 3), factors.size())};
  }
  return factors;
}

std::string text_of(const FactorText& factor) {
  std::string text(verb_of(factor.kind));
  if (factor.kind == Kind::reflect) {
    const auto named =
        std::ranges::find(mirrors, factor.mirror, &std::pair<std::string_view, Mirror>::second);
    return text + " " + (named != mirrors.end() ? std::string(named->first) : text_of(factor.line));
  }
  text += " " + text_of(factor.amount);
  if (!factor.axis.empty()) {
    const std::string axis = text_of(factor.axis);
    text += " about " + (axis == "1,0,0"   ? "x"
                         : axis == "0,1,0" ? "y"
                         : axis == "0,0,1" ? std::string("z")
                                           : axis);
  }
  if (!factor.pivot.empty()) text += (factor.axis.empty() ? " about " : " through ") + text_of(factor.pivot);
  return text;
}

std::string text_of(const std::vector<FactorText>& factors) {
  std::vector<std::string> texts;
  for (const FactorText& factor : factors) texts.push_back(text_of(factor));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace gradus
