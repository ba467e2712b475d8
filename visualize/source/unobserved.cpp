#include "source/unobserved.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "source/code.hpp"

namespace gradus::source {
namespace {

void sort_once(std::vector<std::string>& words) {
  std::ranges::sort(words);
  const auto repeated = std::ranges::unique(words);
  words.erase(repeated.begin(), repeated.end());
}

/// The names that stand in some code.
void append_words(std::string_view bare, std::vector<std::string>& words) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  for (std::size_t at = bare.find_first_of(letters); at != nowhere; at = bare.find_first_of(letters, at)) {
    const std::size_t end = std::min(bare.find_first_not_of(letters, at), bare.size());
    words.emplace_back(bare.substr(at, end - at));
    at = end;
  }
}

/// Erases a whole line, or several, where nothing else stands on them; else the range alone.
void erase_lines(Code& code, Range range) {
  const std::size_t begin = line_begin(code.text(), range.begin), end = line_end(code.text(), range.end - 1);
  const std::string_view text = code.text();
  const bool alone = trimmed(text.substr(begin, range.begin - begin)).empty() &&
                     trimmed(text.substr(range.end, end - range.end)).empty();
  code.erase(alone ? Range{begin, end} : range);
}

/// Whether a statement may end before this place: else what is erased was all of a branch.
bool is_between_statements(const Code& code, std::size_t at) {
  const std::string_view before = trimmed(std::string_view(code.bare()).substr(0, at));
  return before.ends_with(';') || before.ends_with('{') || before.ends_with('}');
}

/// Erases `if constexpr (observed<O>) observer(...);`. Gives the words in the parentheses.
std::vector<std::string> erase_reports(Code& code) {
  std::vector<std::string> words;
  constexpr std::string_view report = "if constexpr (observed<O>) observer(";
  std::size_t at = code.bare().find(report);
  for (; at != nowhere; at = code.bare().find(report, at)) {
    const std::size_t end = code.bare().find(';', closing(code.bare(), at + report.size() - 1)) + 1;
    append_words(code.bare().substr(at + report.size(), end - at - report.size()), words);
    if (is_between_statements(code, at)) {
      erase_lines(code, {at, end});
    } else {
      code.replace({at, end}, ";");
    }
  }
  sort_once(words);
  return words;
}

/// Erases `Tally<O, Work> tally(observer);`, and gives the name of what is counted to the steps.
void erase_tallies(Code& code, std::vector<std::string>& steps) {
  constexpr std::string_view head = "Tally<O, ";
  for (std::size_t at = code.bare().find(head); at != nowhere; at = code.bare().find(head, at)) {
    const std::size_t begin = at + head.size(), end = code.bare().find('>', begin);
    steps.emplace_back(code.bare().substr(begin, end - begin));
    erase_lines(code, {at, code.bare().find(';', end) + 1});
  }
}

/// The brace that opens the innermost block around a place, or nowhere.
std::size_t block_begin(std::string_view bare, std::size_t at) {
  int depth = 0;
  while (at-- > 0) {
    if (bare[at] == '}') ++depth;
    if (bare[at] == '{' && --depth < 0) return at;
  }
  return nowhere;
}

/// Whether the innermost block around a place is a type's.
bool is_member(std::string_view bare, std::size_t at) {
  const std::size_t open = block_begin(bare, at);
  if (open == nowhere) return true;
  const std::string_view head = trimmed(bare.substr(line_begin(bare, open), open - line_begin(bare, open)));
  return head.starts_with("struct") || head.starts_with("class") || head.starts_with("namespace");
}

/// Whether a local variable is declared here, as the first of its line or behind others: "int a = 0, b = 0".
bool declares_variable(std::string_view bare, std::size_t at, std::string_view name) {
  const std::string_view line = bare.substr(line_begin(bare, at), at + name.size() - line_begin(bare, at));
  if (!bare.substr(at + name.size()).starts_with(" = ") || !line.starts_with("  ")) return false;
  const std::string_view first = trimmed(line.substr(0, line.find(" = ")));
  const std::size_t gap = first.rfind(' ');
  if (gap == nowhere || first.starts_with("class ") || is_member(bare, at)) return false;
  return first.find_first_of("(;=,{.[") == nowhere;
}

/// The end of the innermost block around a place.
std::size_t block_end(std::string_view bare, std::size_t at) {
  int depth = 0;
  for (; at < bare.size(); ++at) {
    if (bare[at] == '{') ++depth;
    if (bare[at] == '}' && --depth < 0) break;
  }
  return at;
}

/// Whether the rest of the block reads the variable: changing it alone is none.
bool is_read(std::string_view block, std::string_view name) {
  for (std::size_t at = find_word(block, name); at != nowhere; at = find_word(block, name, at + 1)) {
    const bool counted = at >= 2 && block.substr(at - 2, 2) == "++";
    const std::string_view before = trimmed(block.substr(0, at)), after = block.substr(at + name.size());
    const bool begins =
        before.ends_with(';') || before.ends_with('{') || before.ends_with('}') || before.ends_with(')');
    const bool changed = after.starts_with(" += ") || after.starts_with(" -= ") ||
                         after.starts_with(" |= ") || after.starts_with(" = ");
    if (!counted && !(begins && changed)) return true;
  }
  return false;
}

/// Lets compilers say nothing of variables that only reports read: how they are made may check something.
void mark_unused(Code& code, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    for (std::size_t at = find_word(code.bare(), word); at != nowhere;
         at = find_word(code.bare(), word, at + 1)) {
      const std::string_view bare = code.bare();
      if (!declares_variable(bare, at, word)) continue;
      const std::size_t after = at + word.size();
      if (is_read(bare.substr(after, block_end(bare, after) - after), word)) continue;
      const std::size_t begin = bare.find_first_not_of(' ', line_begin(bare, at));
      constexpr std::string_view attribute = "[[maybe_unused]] ";
      code.replace({begin, begin}, attribute);
      at += attribute.size();
    }
  }
}

/// Whether this parameter of a template is the type of an observer, or of a pack with one.
bool is_type_of_observer(std::string_view parameter) {
  const std::string_view given = trimmed(parameter.substr(0, parameter.find('=')));
  return given.ends_with(" O") || given == "class... Observed";
}

/// The names of the types in Observer<A, B<T>>.
void append_steps(std::string_view parameter, std::vector<std::string>& steps) {
  const std::size_t at = parameter.find("Observer<");
  if (at == nowhere) return;
  const std::size_t open = parameter.find('<', at);
  for (const Range& part : split_at_commas(parameter, {open + 1, closing(parameter, open)})) {
    const std::string_view type = trimmed(parameter.substr(part.begin, part.end - part.begin));
    const std::string_view plain = type.substr(0, type.find('<'));
    steps.emplace_back(plain.substr(plain.rfind(':') == nowhere ? 0 : plain.rfind(':') + 1));
  }
}

/// Whether a function that is no template any more has to be told to be inline.
bool lacks_inline(std::string_view declaration) {
  return !declaration.starts_with("constexpr ") && !declaration.starts_with("inline ");
}

/// A head without the parameter that is an observer's type; the whole head where it was the only one.
void shorten_head(Code& code, std::size_t at, std::size_t open, std::size_t close,
                  std::vector<std::string>& steps) {
  const std::vector<Range> parameters = split_at_commas(code.bare(), {open + 1, close});
  const auto of_observer = std::ranges::find_if(parameters, [&](const Range& range) {
    return is_type_of_observer(std::string_view(code.bare()).substr(range.begin, range.end - range.begin));
  });
  if (of_observer == parameters.end()) return;
  append_steps(code.bare().substr(of_observer->begin, of_observer->end - of_observer->begin), steps);
  if (parameters.size() > 1) {
    const bool first = of_observer == parameters.begin();
    code.erase(first ? Range{of_observer->begin, of_observer->end + 1}
                     : Range{of_observer->begin - 1, of_observer->end});
    return;
  }
  const std::size_t declaration = code.bare().find_first_not_of(" \n", close + 1);
  const bool alone = lacks_inline(std::string_view(code.bare()).substr(declaration));
  code.replace({at, declaration}, alone ? "inline " : "");
}

void shorten_heads(Code& code, std::vector<std::string>& steps) {
  constexpr std::string_view head = "template <";
  for (std::size_t at = code.bare().find(head); at != nowhere; at = code.bare().find(head, at + 1)) {
    const std::size_t open = at + head.size() - 1, close = closing(code.bare(), open);
    // Of a declaration that has to do with an observer, not of one of that letter by chance
    const std::size_t end =
        code.bare().find_first_of("{;", closing(code.bare(), code.bare().find('(', close)));
    const std::string_view declaration = std::string_view(code.bare()).substr(close, end - close);
    if (declaration.find("observer") != nowhere) shorten_head(code, at, open, close, steps);
  }
}

/// Erases `template <class O> concept FillObserver = Observer<O, ...>;` and the comment above.
void erase_concepts(Code& code, std::vector<std::string>& steps) {
  constexpr std::string_view head = "template <class O>\nconcept ";
  for (std::size_t at = code.bare().find(head); at != nowhere; at = code.bare().find(head, at)) {
    const std::size_t end = code.bare().find(';', at) + 1;
    append_steps(code.bare().substr(at, end - at), steps);
    erase_lines(code, {comment_begin(code.text(), at), end});
  }
}

/// Erases a parameter or an argument, wherever it stands, with the comma before it or, of the first, after.
void erase_listed(Code& code, std::string_view listed) {
  for (std::size_t at = code.bare().find(listed); at != nowhere; at = code.bare().find(listed, at)) {
    const std::size_t end = at + listed.size();
    const std::size_t before = code.bare().find_last_not_of(" \n", at - 1);
    const std::size_t after = code.bare().find_first_not_of(" \n", end);
    if (code.bare()[before] == ',' && (code.bare()[after] == ',' || code.bare()[after] == ')')) {
      code.erase({before, end});
    } else if (code.bare()[before] == '(' && code.bare()[after] == ',') {
      code.erase({at, code.bare().find_first_not_of(" \n", after + 1)});
    } else if (code.bare()[before] == '(' && code.bare()[after] == ')') {
      code.erase({at, end});
    } else {
      at = end;
    }
  }
}

void rename(Code& code, std::string_view from, std::string_view to) {
  for (std::size_t at = find_word(code.bare(), from); at != nowhere; at = find_word(code.bare(), from, at)) {
    code.replace({at, at + from.size()}, to);
  }
}

/// What a sentence above a function may begin with.
constexpr std::array<std::string_view, 6> headings{"Domain", "Accuracy", "Cost",
                                                   "Errors", "Source",   "Memory"};

/// The place of the next heading in a comment, or its end.
std::size_t next_heading(std::string_view comment, std::size_t from) {
  std::size_t next = comment.size();
  for (const std::string_view heading : headings) {
    for (std::size_t at = find_word(comment, heading, from); at != nowhere;
         at = find_word(comment, heading, at + 1)) {
      const std::size_t end = at + heading.size();
      const bool heads = end < comment.size() && (comment[end] == ':' || comment[end] == ',');
      if (heads) next = std::min(next, at);
    }
  }
  return next;
}

/// A comment above a function without what it says of steps.
std::string without_steps(std::string comment) {
  for (const std::string_view shared : {"Steps, ", ", Steps"}) {
    if (const std::size_t at = comment.find(shared); at != nowhere) comment.erase(at, shared.size());
  }
  const std::size_t at = comment.find("Steps:");
  if (at == nowhere) return comment;
  const std::size_t next = next_heading(comment, at);
  const bool heads_line =
      trimmed(comment.substr(line_begin(comment, at), at - line_begin(comment, at))) == "///";
  const bool goes_on = !heads_line && comment.substr(at, next - at).find('\n') != nowhere;
  if (next < comment.size()) return comment.replace(at, next - at, goes_on ? "\n/// " : "");
  // The last of the comment: with the line's slashes
  const std::size_t begin = heads_line ? line_begin(comment, at) : comment.find_last_not_of(' ', at - 1) + 1;
  return comment.replace(begin, nowhere, heads_line ? "" : "\n");
}

/// The comments of a text without what they say of steps and observers.
std::string without_words_of_steps(std::string_view text) {
  std::string result, comment;
  bool in_section = false;
  const auto finish = [&] {
    result += without_steps(std::move(comment));
    comment.clear();
  };
  for (const std::string_view line : lines_in(text)) {
    if (trimmed(line).starts_with("///")) {
      comment += std::string(line) + "\n";
      in_section = false;
      continue;
    }
    finish();
    if (line.starts_with("// --- Steps")) {
      in_section = true;
    } else if (!(in_section && (line.empty() || line.starts_with("// ")))) {
      in_section = false;
    }
    if (line.starts_with("// ---") && !line.starts_with("// --- Steps")) in_section = false;
    if (!in_section) result += std::string(line) + "\n";
  }
  finish();
  return result;
}

/// "With an order and an observer or without." says more than is left; it may go on on the next line.
std::string without_words_of_observers(std::string text) {
  for (const std::string_view words : {" and an observer", " and\n/// an observer"}) {
    for (std::size_t at = text.find(words); at != nowhere; at = text.find(words, at)) {
      text.replace(at, words.size(), words.find('\n') == nowhere ? "" : "\n///");
    }
  }
  return text;
}

/// From the comment above a type's declaration to after it, if the text declares it.
std::optional<Range> declaration_of(const Code& code, std::string_view name) {
  for (const std::string_view kind : {"struct ", "class "}) {
    const std::string declared = std::string(kind) + std::string(name) + " {";
    const std::size_t at = code.bare().find(declared);
    if (at == nowhere || line_begin(code.bare(), at) != at) continue;
    const std::size_t end = closing(code.bare(), at + declared.size() - 1) + 2;  // with the semicolon
    std::size_t begin = at;
    const std::size_t above = at == 0 ? 0 : line_begin(code.bare(), at - 1);
    if (code.bare().compare(above, 10, "template <") == 0) begin = above;
    return Range{comment_begin(code.text(), begin), line_end(code.text(), end)};
  }
  return std::nullopt;
}

}  // namespace

Unwatched without_observers(std::string_view text) {
  Code code(without_words_of_observers(without_words_of_steps(text)));
  Unwatched result;
  const std::vector<std::string> reported = erase_reports(code);
  erase_tallies(code, result.steps);
  erase_concepts(code, result.steps);
  shorten_heads(code, result.steps);
  for (const std::string_view listed :
       {"O&& observer = {}", "O&& observer", "O& observer", "Observed&&... observer",
        "std::forward<Observed>(observer)...", "observer", "nobody", "tally"}) {
    erase_listed(code, listed);
  }
  rename(code, "order_and_observer", "order");
  // Who asks a function for a report that is there only with an observer
  constexpr std::string_view asked = "<observed<O>>";
  for (std::size_t at = code.bare().find(asked); at != nowhere; at = code.bare().find(asked, at))
    code.erase({at, at + asked.size()});
  constexpr std::string_view nobody = "Unobserved nobody;";
  for (std::size_t at = code.bare().find(nobody); at != nowhere; at = code.bare().find(nobody, at)) {
    erase_lines(code, {at, at + nobody.size()});
  }
  mark_unused(code, reported);
  result.text = code.text();
  sort_once(result.steps);
  return result;
}

std::vector<std::string> declared_in(std::string_view text, const std::vector<std::string>& names) {
  const Code code{std::string(text)};
  std::vector<std::string> declared;
  std::ranges::copy_if(names, std::back_inserter(declared),
                       [&](const std::string& name) { return declaration_of(code, name).has_value(); });
  return declared;
}

std::string without_type(std::string_view text, std::string_view name) {
  Code code{std::string(text)};
  if (const auto range = declaration_of(code, name)) {
    // With the empty line that follows, where one stands before it, too
    const bool apart = range->begin > 1 && code.text()[range->begin - 2] == '\n' &&
                       range->end < code.text().size() && code.text()[range->end] == '\n';
    code.erase({range->begin, range->end + (apart ? 1 : 0)});
  }
  return code.text();
}

bool uses(std::string_view text, std::string_view name) {
  const Code rest(without_type(text, name));
  return find_word(rest.bare(), name) != nowhere;
}

bool is_watched(std::string_view text) {
  const Code code{std::string(text)};
  for (const char* word : {"observer", "Observer", "observed", "Observed", "Unobserved"}) {
    if (find_word(code.bare(), word) != nowhere) return true;
  }
  return false;
}

}  // namespace gradus::source
