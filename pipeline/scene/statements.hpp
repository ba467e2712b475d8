#pragma once
// Text files of one statement a line (OBJ, MTL), read word by word; every mistake is told with file and line.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace gradus::pipeline {

/// One statement: its words, and where it stands.
///
/// Words are separated by blanks and tabs. A word that begins with # ends the statement, except in `rest`.
class Statement {
 public:
  Statement(std::string_view text, const std::string& file, int line)
      : at_(text.data()), end_(text.data() + text.size()), file_(file), line_(line) {}

  /// The next word; empty at the end.
  std::string_view word();
  /// Whether another word follows.
  bool more();
  /// All that is left, without the blanks round it: a name, which may hold blanks and #.
  std::string_view rest();

  /// The next word as a finite number of at most `largest` in size. `what`: how mistakes call it.
  double number(std::string_view what);
  /// The same for a word already taken.
  double number(std::string_view what, std::string_view word);
  /// Nothing may follow.
  void end(std::string_view after);

  int line() const { return line_; }
  const std::string& file() const { return file_; }
  /// Throws InputError: "file:line: text".
  [[noreturn]] void fail(std::string_view text) const;
  /// "file:line: text".
  std::string place(std::string_view text) const;

  static constexpr double largest = 1e30;

 private:
  void skip_blanks();

  const char* at_;
  const char* end_;
  const std::string& file_;
  int line_;
};

/// The statements of a text in order. Lines end in LF, CR LF or CR; one that ends in a backslash goes on in
/// the next. Empty lines and those that begin with # are left out. A byte order mark is skipped. Errors:
/// InputError for text that is none: UTF-16, or with zero bytes.
class Statements {
 public:
  /// text and file must outlive this.
  Statements(std::string_view text, const std::string& file);

  /// The next statement; nothing at the end. It is good until the next call.
  std::optional<Statement> next();

 private:
  std::string_view line();

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 0;        ///< the last one read, from 1
  std::string joined_;  ///< a statement that goes over several lines
};

}  // namespace gradus::pipeline
