#include "source/code.hpp"

#include <algorithm>
#include <cctype>

namespace gradus::source {
namespace {

bool belongs_to_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The end of what begins here and is no code: a comment or a literal; the same place when there is none.
std::size_t end_of_aside(std::string_view text, std::size_t at) {
  if (text.substr(at).starts_with("//")) return std::min(text.find('\n', at), text.size());
  if (text.substr(at).starts_with("/*")) return std::min(text.find("*/", at) + 2, text.size());
  const bool separates_digits = text[at] == '\'' && at > 0 && belongs_to_word(text[at - 1]);
  if ((text[at] != '"' && text[at] != '\'') || separates_digits) return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at]) end += text[end] == '\\' ? 2u : 1u;
  return std::min(end + 1, text.size());
}

std::string without_asides(std::string text) {
  // Nothing else begins one: most of a text is passed over
  for (std::size_t at = text.find_first_of("/\"'"); at < text.size(); at = text.find_first_of("/\"'", at)) {
    const std::size_t end = end_of_aside(text, at);
    for (std::size_t i = at; i < end; ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
    at = std::max(end, at + 1);
  }
  return text;
}

}  // namespace

Code::Code(std::string text) : text_(std::move(text)), bare_(without_asides(text_)) {}

void Code::replace(Range range, std::string_view with) {
  text_.replace(range.begin, range.end - range.begin, with);
  bare_.replace(range.begin, range.end - range.begin, without_asides(std::string(with)));
}

std::size_t closing(std::string_view bare, std::size_t open) {
  const bool angles = bare[open] == '<';
  const std::string_view opens = angles ? "<(" : "([{", closes = angles ? ">)" : ")]}";
  int depth = 0;
  for (std::size_t at = open; at < bare.size(); ++at) {
    if (opens.find(bare[at]) != nowhere) ++depth;
    if (closes.find(bare[at]) != nowhere && --depth == 0) return at;
  }
  return nowhere;
}

std::vector<Range> split_at_commas(std::string_view bare, Range range) {
  std::vector<Range> parts{{range.begin, range.begin}};
  int depth = 0;
  for (std::size_t at = range.begin; at < range.end; ++at) {
    if (std::string_view("<([{").find(bare[at]) != nowhere) ++depth;
    if (std::string_view(">)]}").find(bare[at]) != nowhere) --depth;
    if (depth == 0 && bare[at] == ',') {
      parts.back().end = at;
      parts.push_back({at + 1, at + 1});
    }
  }
  parts.back().end = range.end;
  return parts;
}

bool is_word_at(std::string_view text, std::size_t at, std::string_view word) {
  const std::size_t end = at + word.size();
  return text.substr(at).starts_with(word) && (at == 0 || !belongs_to_word(text[at - 1])) &&
         (end == text.size() || !belongs_to_word(text[end]));
}

std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
  std::size_t at = text.find(word, from);
  while (at != nowhere && !is_word_at(text, at, word)) at = text.find(word, at + 1);
  return at;
}

std::size_t line_begin(std::string_view text, std::size_t at) {
  const std::size_t end_before = at == 0 ? nowhere : text.rfind('\n', at - 1);
  return end_before == nowhere ? 0 : end_before + 1;
}

std::size_t line_end(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == nowhere ? text.size() : end + 1;
}

std::vector<std::string_view> lines_in(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = line_end(text, at);
    lines.push_back(text.substr(at, next - at - (text[next - 1] == '\n')));
    at = next;
  }
  return lines;
}

std::size_t comment_begin(std::string_view text, std::size_t at) {
  while (at > 0) {
    const std::size_t above = line_begin(text, at - 1);
    if (!trimmed(text.substr(above, at - above)).starts_with("//")) break;
    at = above;
  }
  return at;
}

}  // namespace gradus::source
