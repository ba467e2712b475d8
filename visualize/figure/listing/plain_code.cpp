#include "figure/listing/plain_code.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

namespace gradus::lexemes {
namespace {

/// "<…>" right behind a name: signs of comparison stand apart.
void drop_template_arguments(Lexemes& tokens) {
  for (At i = 1; i < std::ssize(tokens); ++i) {
    const auto& token = tokens[i];
    if (!token.is("<") || token.apart || !is_name(tokens[i - 1])) continue;
    int depth = 0;
    for (At end = i; end < std::ssize(tokens); ++end) {
      const auto& other = tokens[end];
      depth += other.is("<") ? 1 : other.is(">") ? -1 : 0;
      if (depth != 0) continue;
      erase(tokens, i, end + 1);
      --i;
      break;
    }
  }
}

void drop_qualifiers(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    if (!tokens[i].is("::")) continue;
    const bool qualified = i > 0 && is_name(tokens[i - 1]);
    erase(tokens, qualified ? i - 1 : i, i + 1);
    i -= qualified ? 2 : 1;
  }
}

// --- Functions in a line -------------------------------------------------------------------------

/// f = (x) { return x < 0; }: f(x) = x < 0, or "function f(x)" where its statements follow.
void name_function(Lexemes& tokens, At parameters, At body) {
  erase(tokens, parameters - 1, parameters);
  tokens[parameters - 1].apart = false;
  const At name = parameters - 2;
  if (closing(tokens, body - 1) >= 0) {
    insert(tokens, body - 1, {"="});
  } else {
    insert(tokens, name, {"function"});
  }
  erase(tokens, 0, name);
}

/// { return x; } on one line: x.
void drop_body(Lexemes& tokens, At body) {
  const At close = closing(tokens, body);
  if (close < 0) return;
  const At end = tokens[close - 1].is(";") ? close - 1 : close;
  erase(tokens, end, close + 1);
  const bool returns = tokens[body + 1].is("return");
  erase(tokens, body, returns ? body + 2 : body + 1);
}

/// [&](auto x) { return x < 0; }: (x) → x < 0, or what name_function says.
void drop_captures(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    if (!tokens[i].is("[") || !begins_expression(tokens, i)) continue;
    const At end = closing(tokens, i);
    if (end < 0 || end + 1 >= std::ssize(tokens) || !is_one_of(tokens[end + 1], {"(", "{"})) continue;
    erase(tokens, i, end + 1);
    if (tokens[i].is("{")) {
      insert(tokens, i, {"(", ")"});
      tokens[i + 1].apart = false;
    }
    const At parameters = closing(tokens, i);
    if (parameters < 0) continue;
    At body = parameters + 1;
    while (body < std::ssize(tokens) && !tokens[body].is("{")) ++body;
    if (body == std::ssize(tokens)) continue;
    erase(tokens, parameters + 1, body);
    body = parameters + 1;
    if (i > 1 && tokens[i - 1].is("=") && is_name(tokens[i - 2])) {
      name_function(tokens, i, body);
      body = 0;
    } else {
      insert(tokens, body, {"→"});
    }
    while (body < std::ssize(tokens) && !tokens[body].is("{")) ++body;
    if (body < std::ssize(tokens)) drop_body(tokens, body);
  }
}

// --- Declarations --------------------------------------------------------------------------------

/// vec, dvec2, Vec: what is written as its numbers.
bool is_vector(const Lexeme& type) {
  std::string_view name = type.text;
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0) name.remove_suffix(1);
  return name == "Vec" || name == "vec" || (name.size() == 4 && name.ends_with("vec"));
}
bool is_zero(const Lexeme& value) { return value.is("0") || value.is("0.0"); }

bool has_comma(const Lexemes& tokens, At open, At close) {
  int depth = 0;
  for (At i = open; i < close; ++i) {
    if (is_one_of(tokens[i], {"(", "[", "{"})) ++depth;
    if (is_one_of(tokens[i], {")", "]", "}"})) --depth;
    if (depth == 1 && tokens[i].is(",")) return true;
  }
  return false;
}

/// = value.
void assign(Lexemes& tokens, At at, std::initializer_list<std::string_view> value) {
  insert(tokens, at, {"="});
  insert(tokens, at + 1, value);
}

/// What a declared name is given by what stands behind it: in brackets, in braces, or nothing at all.
void write_declarator(Lexemes& tokens, At name, const Lexeme& type) {
  At next = name + 1;
  if (next + 1 < std::ssize(tokens) && tokens[next].is("[") && tokens[next + 1].is("]"))
    erase(tokens, next, next + 2);
  if (next >= std::ssize(tokens)) return;
  const At close = closing(tokens, next);
  const bool holds = close != next + 1;
  if (tokens[next].is("{") && holds) {
    assign(tokens, next, {});
    tokens[next + 1].apart = true;
  } else if (tokens[next].is("(") && close == next + 2 && is_zero(tokens[next + 1])) {
    // Zero is zero in every type
    tokens[next] = {"=", true};
    tokens[next + 1].apart = true;
    erase(tokens, close, close + 1);
  } else if (is_one_of(tokens[next], {"(", "{"})) {
    assign(tokens, next, {type.text});
    tokens[next + 2].apart = false;
  } else if (is_one_of(tokens[next], {";", ","})) {
    if (type.is("optional")) {
      assign(tokens, next, {"nothing"});
    } else {
      assign(tokens, next, {"empty", type.is("vector") ? "list" : type.text});
    }
  }
}

/// T s(1), t(2);: s = 1, t = 2.
void write_declarators(Lexemes& tokens, const Lexeme& type) {
  int depth = 0;
  write_declarator(tokens, 0, type);
  for (At i = 0; i + 1 < std::ssize(tokens); ++i) {
    if (is_one_of(tokens[i], {"(", "[", "{"})) ++depth;
    if (is_one_of(tokens[i], {")", "]", "}"})) --depth;
    if (depth != 0 || !tokens[i].is(",")) continue;
    while (i + 2 < std::ssize(tokens) && is_one_of(tokens[i + 1], {"&", "*"})) erase(tokens, i + 1, i + 2);
    if (is_name(tokens[i + 1])) write_declarator(tokens, i + 1, type);
  }
}

/// Types before the names that they declare. A value in brackets becomes an assignment.
void drop_types(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    if (is_one_of(tokens[i], {"const", "constexpr", "static", "mutable"})) {
      erase(tokens, i, i + 1);
      --i;
    }
  }
  std::optional<Lexeme> declared;
  for (At i = 0; i + 1 < std::ssize(tokens); ++i) {
    const Lexeme type = tokens[i];
    if (!is_name(type) || is_keyword(type)) continue;
    At name = i + 1;
    while (name < std::ssize(tokens) && is_one_of(tokens[name], {"&", "*", "&&"}) && !tokens[name].apart)
      ++name;
    if (name >= std::ssize(tokens) || !tokens[name].apart) continue;
    if (type.is("auto") && tokens[name].is("[")) {
      erase(tokens, i, name);
      continue;
    }
    // "in" is a word of the textbook's alone
    if (!is_name(tokens[name]) || (is_keyword(tokens[name]) && !tokens[name].is("in"))) continue;
    erase(tokens, i, name);
    if (i == 0) declared = type;
  }
  if (declared) write_declarators(tokens, *declared);
}

// --- Values --------------------------------------------------------------------------------------

/// No operator between two values: it needs no brackets.
bool is_unit(const Lexemes& tokens, At first, At last) {
  if (!is_letter(tokens[first].text.front())) return false;
  int depth = 0;
  for (At i = first; i < last; ++i) {
    if (is_one_of(tokens[i], {"(", "[", "{"})) ++depth;
    if (is_one_of(tokens[i], {")", "]", "}"})) --depth;
    if (depth == 0 && i > first && tokens[i].apart) return false;
  }
  return true;
}

/// T(0), std::move(x), static_cast<int>(x): the value alone.
void drop_conversions(Lexemes& tokens) {
  for (At i = 0; i + 1 < std::ssize(tokens); ++i) {
    const bool converts = is_one_of(tokens[i], {"T", "move", "forward", "static_cast", "double", "float",
                                                "int", "int64_t", "size_t", "ptrdiff_t", "Int", "Whole"});
    if (!converts || !is_one_of(tokens[i + 1], {"(", "{"})) continue;
    const At end = closing(tokens, i + 1);
    if (end < 0) continue;
    if (end == i + 2) {
      erase(tokens, i + 1, end + 1);
      tokens[i].text = "0";
      continue;
    }
    tokens[i + 1].text = "(";
    tokens[end].text = ")";
    const bool unit = is_unit(tokens, i + 2, end);
    if (unit) erase(tokens, end, end + 1);
    erase(tokens, i, unit ? i + 2 : i + 1);
  }
}

/// {x}: x. {x, y}: [x, y]. Segment{a, b}: Segment(a, b). ivec2{x, y}, too, is [x, y]. What ends on another
/// line stays.
void write_values(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    const bool brace = tokens[i].is("{") && !opens_block(tokens, i);
    const bool typed = i > 0 && !tokens[i].apart && is_name(tokens[i - 1]) && !is_keyword(tokens[i - 1]);
    const bool vector = typed && is_vector(tokens[i - 1]);
    if (!brace && !(vector && tokens[i].is("("))) continue;
    const At close = closing(tokens, i);
    if (close < 0) continue;
    const bool one = !has_comma(tokens, i, close);
    if (close == i + 1 && !typed) {
      erase(tokens, close, close + 1);
      tokens[i] = {"nothing", true};
    } else if (one && !typed) {
      erase(tokens, close, close + 1);
      erase(tokens, i, i + 1);
      --i;
    } else if (typed && (!vector || one)) {
      tokens[i].text = "(";
      tokens[close].text = ")";
    } else {
      tokens[i].text = "[";
      tokens[close].text = "]";
      if (vector) erase(tokens, i - 1, i);
    }
  }
}

void drop_pointers(Lexemes& tokens) {
  for (At i = 0; i + 1 < std::ssize(tokens); ++i) {
    Lexeme& token = tokens[i];
    if (token.is("->")) token.text = ".";
    const bool sign = token.is("*") || token.is("&");
    if (!sign || tokens[i + 1].apart || !begins_expression(tokens, i)) continue;
    erase(tokens, i, i + 1);
  }
}

}  // namespace

bool begins_expression(const Lexemes& tokens, At i) {
  if (i == 0) return true;
  const Lexeme& before = tokens[i - 1];
  return is_one_of(before, {"(", "[", "{",  ",",  ";", "=", "?",  ":",  "&&", "||", "+", "-",
                            "*", "/", "==", "!=", "<", ">", "<=", ">=", "!",  "->", "→"}) ||
         is_keyword(before);
}

bool opens_block(const Lexemes& tokens, At i) {
  return i > 0 && is_one_of(tokens[i - 1], {")", "do", "then", "else", "repeat", "of", "→"});
}

void drop_cpp(Lexemes& tokens) {
  drop_template_arguments(tokens);
  drop_qualifiers(tokens);
  drop_captures(tokens);
  drop_types(tokens);
  drop_conversions(tokens);
  write_values(tokens);
  drop_pointers(tokens);
}

}  // namespace gradus::lexemes
