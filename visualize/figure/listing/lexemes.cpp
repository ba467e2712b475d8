#include "figure/listing/lexemes.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace gradus::lexemes {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name(const Lexeme& token) {
  return is_letter(token.text.front()) && std::isdigit(static_cast<unsigned char>(token.text.front())) == 0;
}
bool is_one_of(const Lexeme& token, std::initializer_list<std::string_view> texts) {
  return std::ranges::find(texts, token.text) != texts.end();
}
bool is_keyword(const Lexeme& token) {
  return is_one_of(token, {"return", "else", "if", "for", "while", "do", "then", "in", "each", "break",
                           "continue", "repeat", "until", "case", "not", "and", "or", "throw", "function"});
}

// --- From and to text ----------------------------------------------------------------------------

Lexemes lexemes_of(std::string_view code) {
  constexpr std::array operators{"<<=", "->", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=",
                                 "|=",  "^=", "<<", "<=", ">=", "==", "!=", "&&", "||", "::"};
  Lexemes tokens;
  bool apart = false;
  for (std::size_t at = 0; at < code.size();) {
    if (code[at] == ' ') {
      apart = true;
      ++at;
      continue;
    }
    std::size_t length = 1;
    if (is_letter(code[at])) {
      while (at + length < code.size() &&
             (is_letter(code[at + length]) || (code[at + length] == '.' && std::isdigit(code[at]) != 0)))
        ++length;
    } else if (code[at] == '"') {
      length = std::min(code.find('"', at + 1), code.size() - 1) - at + 1;
    } else {
      for (const std::string_view sign : operators) {
        if (code.substr(at).starts_with(sign)) length = std::max(length, sign.size());
      }
    }
    tokens.push_back({std::string(code.substr(at, length)), apart});
    apart = false;
    at += length;
  }
  return tokens;
}

std::string text_of(const Lexemes& tokens) {
  std::string text;
  for (const Lexeme& token : tokens)
    text += (token.apart && !text.empty() && text.back() != '(' ? " " : "") + token.text;
  return text;
}

At closing(const Lexemes& tokens, At open) {
  int depth = 0;
  for (At i = open; i < std::ssize(tokens); ++i) {
    const Lexeme& token = tokens[i];
    if (is_one_of(token, {"(", "[", "{"})) ++depth;
    if (is_one_of(token, {")", "]", "}"}) && --depth == 0) return i;
  }
  return -1;
}

Lexemes between(const Lexemes& tokens, At first, At last) {
  return {tokens.begin() + first, tokens.begin() + std::max(first, last)};
}
void erase(Lexemes& tokens, At first, At last) {
  if (first < last && last < std::ssize(tokens)) tokens[last].apart |= tokens[first].apart;
  tokens.erase(tokens.begin() + first, tokens.begin() + last);
}
void insert(Lexemes& tokens, At at, std::initializer_list<std::string_view> texts) {
  Lexemes added;
  for (const std::string_view text : texts) added.push_back({std::string(text), true});
  tokens.insert(tokens.begin() + at, added.begin(), added.end());
}

}  // namespace gradus::lexemes
