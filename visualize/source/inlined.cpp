#include "source/inlined.hpp"

#include <algorithm>
#include <array>

#include "source/code.hpp"

namespace gradus::source {
namespace {

/// What a line begins with that is no function and no constant of its own, or is inline already.
constexpr std::array<std::string_view, 15> others{
    " ",      "}",          "#",      "//",      "template ",      "struct ",  "class ",        "enum ",
    "union ", "namespace ", "using ", "inline ", "__extension__ ", "typedef ", "static_assert("};

bool is_definition(std::string_view line) {
  return !trimmed(line).empty() &&
         std::ranges::none_of(others, [line](std::string_view other) { return line.starts_with(other); });
}

/// Whether what begins at this place of a file's outermost level is a function.
bool is_function(std::string_view bare, std::size_t at) {
  const std::size_t decides = bare.find_first_of("({;=", at);
  return decides != nowhere && bare[decides] == '(';
}

/// Past the attributes that a declaration begins with.
std::size_t after_attributes(std::string_view bare, std::size_t at) {
  while (bare.substr(at).starts_with("[[")) at = bare.find_first_not_of(" \n", bare.find("]]", at) + 2);
  return at;
}

/// Whether the line before ends a head that makes a template of what follows: that is inline anyway.
bool follows_head(std::string_view bare, std::size_t at) {
  const std::string_view before = trimmed(bare.substr(0, at));
  if (!before.ends_with('>')) return before.ends_with("requires");
  const std::size_t head = before.rfind("\ntemplate <");
  return head != nowhere && closing(before, before.find('<', head)) == before.size() - 1;
}

/// What erase_if sees of a function: its head, and the character that ends that, ; or {.
struct Head {
  std::string_view text;
  char end;
};

/// The text without the functions of the outermost level, with the comments above them, that `unwanted` says.
template <class Unwanted>
std::string without_functions(std::string_view text, Unwanted unwanted) {
  Code code{std::string(text)};
  std::size_t at = 0;
  while (at < code.text().size()) {
    const std::size_t next = line_end(code.text(), at);
    const std::string_view line = std::string_view(code.bare()).substr(at, next - at);
    const bool begins = is_definition(line) || line.starts_with("inline ");
    if (begins && is_function(code.bare(), at)) {
      const std::size_t parameters = code.bare().find('(', at);
      const std::size_t ends = code.bare().find_first_of("{;", closing(code.bare(), parameters));
      if (unwanted(Head{std::string_view(code.bare()).substr(at, ends - at), code.bare()[ends]})) {
        const std::size_t last = code.bare()[ends] == ';' ? ends : closing(code.bare(), ends);
        const std::size_t begin = comment_begin(code.text(), at);
        std::size_t end = line_end(code.text(), last);
        if (begin > 1 && code.text()[begin - 2] == '\n' && code.text()[end] == '\n') ++end;
        code.erase({begin, end});
        at = begin;
        continue;
      }
    }
    at = next;
  }
  return code.text();
}

}  // namespace

std::string inlined(std::string_view text, std::string_view own_namespace) {
  Code code{std::string(text)};
  constexpr std::string_view unnamed = "\nnamespace {\n", unnamed_end = "\n}  // namespace\n";
  const std::string name(own_namespace);
  if (const std::size_t at = code.text().find(unnamed); at != nowhere) {
    code.replace({at, at + unnamed.size()}, "\nnamespace " + name + " {\n");
    const std::size_t end = code.text().find(unnamed_end, at);
    code.replace({end, end + unnamed_end.size()},
                 "\n}  // namespace " + name + "\nusing namespace " + name + ";\n");
  }
  for (std::size_t at = 0; at < code.text().size(); at = line_end(code.text(), at)) {
    const std::string_view line = std::string_view(code.bare()).substr(at, line_end(code.text(), at) - at);
    if (!is_definition(line) || follows_head(code.bare(), at)) continue;
    if (!is_function(code.bare(), at) && !line.starts_with("constexpr ") && !line.starts_with("const "))
      continue;
    if (is_function(code.bare(), at) && line.starts_with("constexpr ")) continue;
    const std::size_t begin = after_attributes(code.bare(), at);
    code.replace({begin, begin}, "inline ");
  }
  return code.text();
}

std::string without_bare_declarations(std::string_view text) {
  return without_functions(text, [](const Head& head) { return head.end == ';'; });
}

std::string without_functions_of(std::string_view text, std::string_view type) {
  return without_functions(text, [type](const Head& head) { return find_word(head.text, type) != nowhere; });
}

}  // namespace gradus::source
