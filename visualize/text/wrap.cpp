#include "text/wrap.hpp"

#include <algorithm>
#include <vector>

#include "core/shown.hpp"

namespace gradus {
namespace {

/// A word and the blanks before it.
struct Word {
  std::size_t blanks = 0;
  std::string_view text;
  std::size_t columns = 0;
};

/// Columns of a text in a terminal: one per character, none for "\033[1m" and the like.
std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at).starts_with("\033[")) {
      at = std::min(text.find('m', at), text.size() - 1) + 1;
      continue;
    }
    at += std::max<std::size_t>(1, character_size(text.substr(at)));
    ++columns;
  }
  return columns;
}

std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t start = std::min(line.find_first_not_of(' ', at), line.size());
    const std::size_t end = std::min(line.find(' ', start), line.size());
    const std::string_view text = line.substr(start, end - start);
    words.push_back({start - at, text, columns_of(text)});
    at = end;
  }
  return words;
}

/// Where the lines that go on with this one begin.
std::size_t indentation_of(const std::vector<Word>& words, std::size_t width) {
  constexpr std::size_t least_room = 24;
  const std::size_t first = words.front().blanks;
  std::size_t column = 0, last = first + 2;
  for (const Word& word : words) {
    column += word.blanks;
    if (&word != &words.front() && word.blanks >= 2) last = column;
    column += word.columns;
  }
  return last + least_room <= width ? last : first + 4;
}

void add_wrapped(std::string& out, std::string_view line, std::size_t width) {
  const std::vector<Word> words = words_of(line);
  const std::size_t indentation = indentation_of(words, width);
  std::size_t column = 0;
  for (const Word& word : words) {
    if (column > indentation && column + word.blanks + word.columns > width) {
      out += "\n" + std::string(indentation, ' ');
      column = indentation;
    } else {
      out.append(word.blanks, ' ');
      column += word.blanks;
    }
    out += word.text;
    column += word.columns;
  }
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    if (width == 0 || line.starts_with("  gradus ") || columns_of(line) <= width) {
      out += line;
    } else {
      add_wrapped(out, line, width);
    }
    if (end < text.size()) out += '\n';
    at = end + 1;
  }
  return out;
}

}  // namespace gradus
