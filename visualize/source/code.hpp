#pragma once
// C++ source text as the project writes it, to be found one's way in and changed.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "stories/point_text.hpp"  // IWYU pragma: export (trimmed)

namespace gradus::source {

/// From the first character to before the last.
struct Range {
  std::size_t begin, end;
};

/// A text beside the same text with comments and literals blanked: what is found in the second is code.
/// Domain: no raw strings, no line that a backslash continues.
class Code {
 public:
  explicit Code(std::string text);

  const std::string& text() const { return text_; }
  /// As long as the text.
  const std::string& bare() const { return bare_; }

  void replace(Range range, std::string_view with);
  void erase(Range range) { replace(range, ""); }

 private:
  std::string text_, bare_;
};

inline constexpr std::size_t nowhere = std::string_view::npos;

/// Where the bracket at `open` is closed: one of ( [ { <. Of the last, only brackets of the same kind and
/// parentheses count, as in the head of a template. nowhere when it isn't.
std::size_t closing(std::string_view bare, std::size_t open);

/// The parts between commas that stand in no brackets, as ranges of the text.
std::vector<Range> split_at_commas(std::string_view bare, Range range);

/// Whether the name stands at this place as a word of its own.
bool is_word_at(std::string_view text, std::size_t at, std::string_view word);

/// The next place of a word from `from` on, or nowhere.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t from = 0);

/// The first character of the line, and the one past its end.
std::size_t line_begin(std::string_view text, std::size_t at);
std::size_t line_end(std::string_view text, std::size_t at);

/// The lines of a text, without their ends.
std::vector<std::string_view> lines_in(std::string_view text);

/// From the first line of the comments right above a place, which is the first of a line, or that place.
std::size_t comment_begin(std::string_view text, std::size_t at);

}  // namespace gradus::source
