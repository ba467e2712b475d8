#include "text/escape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "figure/metrics.hpp"

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

}  // namespace

std::string latex_escaped(std::string_view text) { return replaced(text, latex); }

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
