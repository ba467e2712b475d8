#include "text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

struct Replacement {
  char32_t character;
  std::string_view by;
};

constexpr Replacement latex[] = {
    {U'\\', "\\textbackslash{}"},
    {U'{', "\\{"},
    {U'}', "\\}"},
    {U'$', "\\$"},
    {U'&', "\\&"},
    {U'#', "\\#"},
    {U'%', "\\%"},
    {U'_', "\\_"},
    {U'^', "\\textasciicircum{}"},
    {U'~', "\\textasciitilde{}"},
    {U'<', "$<$"},
    {U'>', "$>$"},
    {U'|', "$|$"},
    {U'"', "\\textquotedbl{}"},
    {U'−', "$-$"},
    {U'·', "$\\cdot$"},
    {U'×', "$\\times$"},
    {U'≤', "$\\le$"},
    {U'≥', "$\\ge$"},
    {U'≠', "$\\ne$"},
    {U'²', "$^2$"},
    {U'½', "$\\frac12$"},
    {U'…', "\\dots{}"},
    {U'√', "$\\surd$"},
    {U'→', "$\\to$"},
    {U'\u00a0', "~"},
};

template <std::size_t n>
std::string replaced(std::string_view text, const Replacement (&table)[n]) {
  std::string out;
  for (const char32_t character : code_points(text)) {
    const auto* found = std::ranges::find(table, character, &Replacement::character);
    if (found != std::end(table)) {
      out += found->by;
    } else {
      // Control characters mean nothing good in any of them
      out += utf8_of(std::u32string(1, character < U' ' || character == 0x7f ? U'\ufffd' : character));
    }
  }
  return out;
}

/// The same signs where they stand in math mode already.
constexpr Replacement latex_math[] = {
    {U'−', "-"},        {U'·', "\\cdot "},  {U'×', "\\times "},  {U'≤', "\\le "},
    {U'≥', "\\ge "},    {U'≠', "\\ne "},    {U'≈', "\\approx "}, {U'²', "^2"},
    {U'³', "^3"},       {U'½', "\\frac12"}, {U'√', "\\surd "},   {U'→', "\\to "},
    {U'∞', "\\infty "}, {U'Δ', "\\Delta "}, {U'°', "^\\circ "},  {U'\u00a0', "\\ "},
};

constexpr bool is_latin(char32_t c) { return (U'a' <= c && c <= U'z') || (U'A' <= c && c <= U'Z'); }
constexpr bool is_digit(char32_t c) { return U'0' <= c && c <= U'9'; }
bool is_sign(char32_t c) {
  return std::u32string_view(U"+/=<>()[]|.,;' ").find(c) != std::u32string_view::npos ||
         std::ranges::find(latex_math, c, &Replacement::character) != std::end(latex_math);
}

/// Whether the letter here is a variable, not part of a word; points have capitals and stay upright.
bool is_variable(std::u32string_view text, std::size_t at) {
  const auto in_word = [text](std::size_t i) {
    return i < text.size() && (is_latin(text[i]) || text[i] > 0xbf) && !is_sign(text[i]);
  };
  return U'a' <= text[at] && text[at] <= U'z' && !in_word(at + 1) && (at == 0 || !in_word(at - 1));
}

/// What stands between formulas as well as in them.
bool is_pause(char32_t c) { return std::u32string_view(U" .,;'\u00a0").find(c) != std::u32string_view::npos; }

/// Behind the formula that begins here; here, when none does.
std::size_t end_of_formula(std::u32string_view text, std::size_t at) {
  if (is_pause(text[at])) return at;
  std::size_t end = at;
  for (std::size_t i = at; i < text.size(); ++i) {
    if (!is_digit(text[i]) && !is_sign(text[i]) && !is_variable(text, i)) break;
    if (!is_pause(text[i])) end = i + 1;
  }
  return end;
}

std::string formula(std::u32string_view text) {
  std::string out = "$";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool decimal =
        text[i] == U',' && i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
    out += decimal ? "{,}" : replaced(utf8_of(text.substr(i, 1)), latex_math);
  }
  while (out.ends_with(' ')) out.pop_back();
  return out + "$";
}

}  // namespace

std::string latex_escaped(std::string_view text) { return replaced(text, latex); }

std::string latex_cell(std::string_view text) {
  const std::u32string characters = code_points(text);
  const std::u32string_view all = characters;
  std::string out;
  for (std::size_t at = 0; at < all.size();) {
    if (const std::size_t end = end_of_formula(all, at); end > at) {
      out += formula(all.substr(at, end - at));
      at = end;
    } else {
      out += latex_escaped(utf8_of(all.substr(at, 1)));
      ++at;
    }
  }
  return out;
}

std::string latex_path(std::string_view path) {
  constexpr std::pair<char, std::string_view> names[] = {
      {'\\', "backslash"}, {'{', "left_brace"}, {'}', "right_brace"}, {'$', "dollar"}, {'&', "ampersand"},
      {'#', "hash"},       {'%', "percent"},    {'^', "circumflex"},  {'~', "tilde"}};
  std::string out;
  bool macro = false;  // a blank ends a macro's name and is lost: those that follow it are spelled out
  for (const char c : path) {
    const auto* const named = std::ranges::find(names, c, &std::pair<char, std::string_view>::first);
    if (named != std::end(names))
      out += fmt::format("\\csname c_{}_str\\endcsname ", named->second);
    else if (macro && c == ' ')
      out += "\\space ";
    else
      out += c;
    macro = named != std::end(names) || (macro && c == ' ');
  }
  return out;
}

std::string markdown_escaped(std::string_view text) {
  constexpr std::string_view special = "\\`*_{}[]()#+-.!|<>~&";
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

}  // namespace gradus
