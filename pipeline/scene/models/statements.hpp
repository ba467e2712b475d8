#pragma once
// Text files of one statement per line (OBJ, MTL), read word by word; mistakes are told with file and line.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gradus::pipeline {

/// A text file, as messages speak of it.
struct TextFile {
  std::string name;
  /// Whether messages may show what stands in it. Not when others chose the file: a model may name any file
  /// of this machine as its library.
  bool quotable = true;

  // NOLINTNEXTLINE(google-explicit-constructor): most files are just a name
  TextFile(std::string called, bool may_be_quoted = true)
      : name(std::move(called)), quotable(may_be_quoted) {}
  TextFile(const char* called) : name(called) {}
};

/// One statement: its words, and where it stands.
///
/// Words are separated by blanks and tabs. A word that begins with # ends the statement, except in `rest`.
class Statement {
 public:
  Statement(std::string_view text, const TextFile& file, int line)
      : at_(text.data()), end_(text.data() + text.size()), file_(&file), line_(line) {}

  /// The next word; empty at the end.
  std::string_view word() {
    if (!more()) return {};
    const char* const begin = at_;
    while (at_ != end_ && !is_blank(*at_)) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }
  /// Whether another word follows.
  bool more() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_ != end_ && *at_ != '#';
  }
  /// All that is left, without the blanks round it: a name, which may hold blanks and #.
  std::string_view rest();

  /// The next word as a finite number of at most `largest` in size: the nearest double, which is a zero for
  /// what is too small. `what`: how mistakes call it.
  double number(std::string_view what);
  /// The same for a word already taken.
  double number(std::string_view what, std::string_view word);
  /// The next word as a whole number from least to most.
  std::int64_t whole(std::string_view what, std::int64_t least, std::int64_t most);
  /// Whether a word is how programs write what is no finite number: nan, -inf, 1.#IND.
  static bool is_no_number(std::string_view word);
  /// Nothing may follow.
  void end(std::string_view after);

  int line() const { return line_; }
  const TextFile& file() const { return *file_; }
  /// A word or a number of the file as messages show it; "something else" where it may not be quoted.
  std::string quoted(std::string_view word) const;
  std::string quoted(double number) const;
  /// Throws InputError: "file:line: text".
  [[noreturn]] void fail(std::string_view text) const;
  /// "file:line: text".
  std::string place(std::string_view text) const;

  static constexpr double largest = 1e30;
  static constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

 private:
  const char* at_;
  const char* end_;
  const TextFile* file_;
  int line_;
};

/// The statements of a text in order. Lines end in LF, CR LF or CR; one that ends in a backslash goes on in
/// the next, where the format has it so. Empty lines and those that begin with # are left out. A byte order
/// mark is skipped. Errors: InputError for text that is none: UTF-16, or with zero bytes.
class Statements {
 public:
  enum class Backslash { joins_lines, is_a_letter };

  /// text and file must outlive this.
  Statements(std::string_view text, const TextFile& file, Backslash backslash = Backslash::joins_lines);

  /// The next statement; nothing at the end. It is good until the next call.
  std::optional<Statement> next();

 private:
  std::string_view line();

  std::string_view text_;
  const TextFile& file_;
  Backslash backslash_;
  std::size_t at_ = 0;
  int line_ = 0;        ///< the last one read, from 1
  std::string joined_;  ///< a statement that goes over several lines
};

/// Unknown statements: each kind is reported once, with its first place and how often it stands there.
class UnknownStatements {
 public:
  void add(const Statement& s, std::string_view key);
  /// "m.obj:3: 't' is no known statement of an OBJ file and is left out (12 times)", a line each. kind: "an
  /// OBJ file".
  std::vector<std::string> notes(std::string_view kind) const;

 private:
  struct Known {
    std::string key, place;
    std::int64_t times;
  };
  std::vector<Known> known_;  ///< the first few kinds
  std::int64_t more_ = 0;     ///< statements of further kinds
};

}  // namespace gradus::pipeline
