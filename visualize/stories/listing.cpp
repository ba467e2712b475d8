// A method's listing: its real source without the plumbing.

#include <algorithm>
#include <cctype>
#include <optional>

#include "stories/listing.hpp"
#include "stories/topic.hpp"

namespace gradus {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::string_view without_indent(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  return line;
}

bool is_comment(std::string_view line) { return without_indent(line).starts_with("//"); }

/// The code of a line: without a trailing comment.
std::string_view code_of(std::string_view line) { return line.substr(0, line.find("//")); }

/// Adds up what opens and closes in a line.
int balance(std::string_view line, char open, char close) {
  const std::string_view code = code_of(line);
  return static_cast<int>(std::ranges::count(code, open) - std::ranges::count(code, close));
}

/// Whether the line starts the declaration of a function of that name: "name(" with a type before it.
bool declares(std::string_view line, std::string_view name) {
  if (is_comment(line)) return false;
  const std::size_t at = line.find(std::string(name) + "(");
  if (at == std::string_view::npos || at == 0) return false;
  const std::string_view before = line.substr(0, at);
  return before.back() == ' ' && before.find_first_of("=(;.") == std::string_view::npos &&
         without_indent(before).find("return ") != 0;
}

/// Whether a statement is none of the method's: it reports a step or counts for reports, refuses an input, or
/// sets memory aside.
bool is_plumbing(std::string_view code) {
  const std::string_view called = code.substr(0, code.find('('));
  return code.starts_with("if constexpr (observed<") || code.starts_with("Tally<O, ") ||
         called == "expects" || called.starts_with("expect_") || called.ends_with(".reserve");
}

/// First and one past the last line of the function's body, or nothing where the line declares without
/// defining.
std::optional<std::pair<std::size_t, std::size_t>> body_from(const std::vector<std::string_view>& lines,
                                                             std::size_t start) {
  std::size_t i = start;
  while (i < lines.size() && code_of(lines[i]).find_first_of("{;") == std::string_view::npos) ++i;
  // The last brace of the line opens the body; those before belong to default arguments
  while (i < lines.size() && without_indent(code_of(lines[i])).find_last_of('{') != std::string_view::npos &&
         balance(lines[i], '{', '}') <= 0) {
    ++i;
  }
  if (i == lines.size() || balance(lines[i], '{', '}') <= 0) return std::nullopt;
  int depth = 1;
  for (std::size_t end = i + 1; end < lines.size(); ++end) {
    depth += balance(lines[end], '{', '}');
    if (depth <= 0) return std::pair{i + 1, end};
  }
  return std::nullopt;
}

/// First and one past the last line of the body of the function of that name.
std::optional<std::pair<std::size_t, std::size_t>> body_in(const std::vector<std::string_view>& lines,
                                                           std::string_view function) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!declares(lines[i], function)) continue;
    if (const auto body = body_from(lines, i)) return body;
  }
  return std::nullopt;
}

// --- Its heading among others --------------------------------------------------------------------------

/// What stands between the brackets of a declaration, parameter by parameter.
std::vector<std::string> parameters_in(std::string_view declaration) {
  std::vector<std::string> parameters(1);
  int depth = 0;
  for (const char c : declaration.substr(declaration.find('(') + 1)) {
    if (c == ')' && depth == 0) break;
    if (c == '(' || c == '<' || c == '{') ++depth;
    if (c == ')' || c == '>' || c == '}') --depth;
    if (c == ',' && depth == 0)
      parameters.emplace_back();
    else
      parameters.back() += c;
  }
  return parameters;
}

/// The name that a parameter declares, without its type and its default.
std::string name_of(std::string_view parameter) {
  parameter = parameter.substr(0, parameter.find('='));
  const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  while (!parameter.empty() && !is_of_name(parameter.back())) parameter.remove_suffix(1);
  const auto begin = std::find_if_not(parameter.rbegin(), parameter.rend(), is_of_name);
  return {begin.base(), parameter.end()};
}

/// What a heading has room for beside two drawings, with what ends it.
constexpr std::size_t widest_heading = 34;
constexpr std::string_view and_more = ", …):";

/// "divide(point, view):", without observers; "scanline(faces, window, …):" where not all parameters fit.
std::string heading_text(std::string_view function, std::string_view declaration) {
  std::string heading(function), cut;
  const char* before = "(";
  for (const std::string& parameter : parameters_in(declaration.substr(declaration.find(function)))) {
    const std::string name = name_of(parameter);
    if (name.empty() || name == "observer") continue;
    if (heading.size() + 5 <= widest_heading) cut = heading;
    heading += before + name;
    before = ", ";
  }
  heading += *before == '(' ? "():" : "):";
  return heading.size() <= widest_heading || cut == function ? heading : cut + std::string(and_more);
}

// --- Which line a step marks ---------------------------------------------------------------------------

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Nothing but braces, or a comment.
bool says_nothing(std::string_view line) {
  return is_comment(line) || line.find_first_not_of(" {}();,") == std::string_view::npos;
}
bool starts_branch(std::string_view line) {
  const std::string_view code = without_indent(line);
  return code.starts_with("if ") || code.starts_with("else ") || code.starts_with("} else");
}
/// A branch whose statement stands behind its question: whether it was taken is not seen.
bool is_short_branch(std::string_view line) {
  const std::string_view code = code_of(line);
  return starts_branch(line) && code.find_last_not_of(' ') != std::string_view::npos &&
         code[code.find_last_not_of(' ')] == ';';
}

/// Of the block that ends with this line, the one that begins it.
std::size_t head_of(std::span<const SourceLine> lines, std::size_t end) {
  const std::size_t indent = indent_of(lines[end].text);
  std::size_t head = end;
  do --head;
  while (head > 0 && (indent_of(lines[head].text) > indent || is_comment(lines[head].text)));
  return head;
}
/// The first question of a chain of branches, of which this is one.
std::size_t first_of_chain(std::span<const SourceLine> lines, std::size_t branch) {
  while (branch > 0 && without_indent(lines[branch].text).starts_with('}')) branch = head_of(lines, branch);
  return branch;
}

constexpr std::string_view struck_out = "//- ", put_in = "  //+";

bool is_struck(std::string_view line) { return without_indent(line).starts_with(struck_out); }

/// A line of a function with a fault: as it was taught, where it is struck out, and else as it runs.
SourceLine changed_line(std::string_view line, int number) {
  const std::size_t indent = indent_of(line);
  if (is_struck(line)) {
    std::string text(line.substr(0, indent));
    return {number, text.append(line.substr(indent + struck_out.size())), Change::struck};
  }
  if (!line.ends_with(put_in)) return {number, std::string(line)};
  return {number, std::string(line.substr(0, line.size() - put_in.size())), Change::added};
}

/// A call without the observer that it hands on, or what counts for it.
std::string without_observer(std::string_view line) {
  std::string text(line);
  for (const std::string_view handed_on : {", observer)", ", tally)"}) {
    if (const std::size_t at = text.find(handed_on); at != std::string::npos)
      text.replace(at, handed_on.size(), ")");
  }
  return text;
}

/// The function's lines without its plumbing: those that run, or those that are struck out.
std::vector<SourceLine> lines_in(std::string_view source, std::string_view function, bool struck) {
  const std::vector<std::string_view> lines = lines_of(source);
  const auto body = body_in(lines, function);
  if (!body) return {};
  std::vector<SourceLine> listing;
  std::size_t indent = std::string_view::npos;
  for (std::size_t k = body->first; k < body->second; ++k) {
    indent = std::min(indent, lines[k].find_first_not_of(' '));
  }
  int open = 0;  // of a plumbing statement that goes on
  for (std::size_t k = body->first; k < body->second; ++k) {
    if (is_struck(lines[k]) != struck) continue;
    SourceLine line = changed_line(lines[k], static_cast<int>(k) + 1);
    const std::string_view code = without_indent(line.text);
    if (open > 0 || is_plumbing(code)) {
      open += balance(line.text, '(', ')');
      continue;
    }
    if (code.empty()) continue;
    line.text = without_observer(std::string_view(line.text).substr(indent));
    listing.push_back(std::move(line));
  }
  return listing;
}

}  // namespace

std::vector<SourceLine> listing_of(std::string_view source, std::string_view function) {
  return lines_in(source, function, false);
}

std::vector<SourceLine> struck_of(std::string_view source, std::string_view function) {
  return lines_in(source, function, true);
}

std::optional<SourceLine> heading_of(std::string_view source, std::string_view function) {
  const std::vector<std::string_view> lines = lines_of(source);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto body = declares(lines[i], function) ? body_from(lines, i) : std::nullopt;
    if (!body) continue;
    std::string declaration;
    for (std::size_t k = i; k < body->first; ++k) declaration += code_of(lines[k]);
    return SourceLine{static_cast<int>(i) + 1, heading_text(function, declaration)};
  }
  return std::nullopt;
}

std::pair<int, int> body_of(std::string_view source, std::string_view function) {
  const auto body = body_in(lines_of(source), function);
  if (!body) return {0, 0};
  return {static_cast<int>(body->first) + 1, static_cast<int>(body->second) + 1};
}

int line_that_ran(std::span<const SourceLine> lines, int line) {
  const auto after = std::ranges::upper_bound(lines, line, {}, &SourceLine::number);
  auto at = static_cast<std::size_t>(after - lines.begin());
  while (at-- > 0) {
    const std::string& text = lines[at].text;
    const bool closes = without_indent(text).starts_with('}') && says_nothing(text);
    if (closes && at > 0) {
      const std::size_t head = first_of_chain(lines, head_of(lines, at));
      if (starts_branch(lines[head].text)) return lines[head].number;
      // The last line of a loop, unless that is a branch without a block
      if (is_short_branch(lines[at - 1].text)) return lines[head].number;
    }
    if (says_nothing(text)) continue;
    // The only statement of a branch without braces
    const bool inner = at > 0 && indent_of(text) > indent_of(lines[at - 1].text);
    if (inner && starts_branch(lines[at - 1].text) && !code_of(text).ends_with("{") &&
        !code_of(lines[at - 1].text).ends_with("{"))
      return lines[at - 1].number;
    return lines[at].number;
  }
  return 0;
}

int line_with(std::span<const SourceLine> lines, std::string_view text) {
  const auto has = [text](const SourceLine& line) { return line.text.find(text) != std::string::npos; };
  const auto found = std::ranges::find_if(lines, has);
  return found == lines.end() ? 0 : found->number;
}

}  // namespace gradus
