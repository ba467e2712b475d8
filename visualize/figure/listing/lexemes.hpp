#pragma once
// A line of source as its lexemes, which are rewritten as a row and become text again: what pseudocode works
// on.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace gradus::lexemes {

struct Lexeme {
  std::string text;
  bool apart = false;  ///< a space stands before it

  bool is(std::string_view other) const { return text == other; }
};
using At = std::ptrdiff_t;  ///< a position among tokens
struct Lexemes : std::vector<Lexeme> {
  using std::vector<Lexeme>::vector;
  Lexeme& operator[](At i) { return *(begin() + i); }
  const Lexeme& operator[](At i) const { return *(begin() + i); }
};

bool is_letter(char c);
bool is_name(const Lexeme& token);
bool is_one_of(const Lexeme& token, std::initializer_list<std::string_view> texts);
bool is_keyword(const Lexeme& token);

Lexemes lexemes_of(std::string_view code);
std::string text_of(const Lexemes& tokens);

/// Position of the bracket that closes the one at `open`, or -1.
At closing(const Lexemes& tokens, At open);

/// The tokens between two positions, and without them.
Lexemes between(const Lexemes& tokens, At first, At last);
void erase(Lexemes& tokens, At first, At last);
/// Each with a space before it.
void insert(Lexemes& tokens, At at, std::initializer_list<std::string_view> texts);

}  // namespace gradus::lexemes
