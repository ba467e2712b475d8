#include "figure/listing/pseudocode.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "figure/listing/lexemes.hpp"
#include "figure/listing/plain_code.hpp"

namespace gradus {
namespace {

using namespace lexemes;

// --- Assignments ---------------------------------------------------------------------------------

/// First token of the place that ends before `end`: "window.lower", "done[i]".
At place_before(const Lexemes& tokens, At end) {
  At first = end;
  while (first > 0) {
    const Lexeme& token = tokens[first - 1];
    if (token.is("]")) {
      int depth = 0;
      do {
        --first;
        if (tokens[first].is("]")) ++depth;
        if (tokens[first].is("[")) --depth;
      } while (first > 0 && depth > 0);
      continue;
    }
    if (!(is_name(token) && !is_keyword(token)) && !token.is(".")) break;
    --first;
    if (tokens[first].apart) break;
  }
  return first;
}
/// One past the place that begins here.
At place_after(const Lexemes& tokens, At first) {
  At end = first;
  while (end < std::ssize(tokens)) {
    const Lexeme& token = tokens[end];
    if (end > first && token.apart) break;
    if (token.is("[") || (token.is("(") && end > first)) {
      const At close = closing(tokens, end);
      if (close < 0) break;
      end = close + 1;
    } else if (is_name(token) || token.is(".")) {
      ++end;
    } else {
      break;
    }
  }
  return end;
}
/// One past the expression that begins here.
At expression_after(const Lexemes& tokens, At first) {
  int depth = 0;
  for (At i = first; i < std::ssize(tokens); ++i) {
    const Lexeme& token = tokens[i];
    if (is_one_of(token, {"(", "[", "{"})) ++depth;
    if (is_one_of(token, {")", "]", "}"}) && --depth < 0) return i;
    if (depth == 0 && is_one_of(token, {";", ","})) return i;
  }
  return std::ssize(tokens);
}

bool is_sum(const Lexemes& tokens, At first, At last) {
  int depth = 0;
  for (At i = first; i < last; ++i) {
    const Lexeme& token = tokens[i];
    if (is_one_of(token, {"(", "["})) ++depth;
    if (is_one_of(token, {")", "]"})) --depth;
    if (depth == 0 && is_one_of(token, {"+", "-"})) return true;
  }
  return false;
}

/// p += x: p = p + x.
void spell_out_compound(Lexemes& tokens) {
  for (At i = 1; i < std::ssize(tokens); ++i) {
    const std::string sign = tokens[i].text;
    if (sign.size() != 2 || sign[1] != '=' || std::string_view("+-*/%&|^").find(sign[0]) == std::string::npos)
      continue;
    Lexemes place = between(tokens, place_before(tokens, i), i);
    if (place.empty()) continue;
    const At end = expression_after(tokens, i + 1);
    if (sign[0] != '+' && is_sum(tokens, i + 1, end)) {
      insert(tokens, end, {")"});
      tokens[end].apart = false;
      insert(tokens, i + 1, {"("});
      tokens[i + 2].apart = false;
    }
    tokens[i].text = "=";
    place.front().apart = true;
    place.push_back({sign.substr(0, 1), true});
    tokens.insert(tokens.begin() + i + 1, place.begin(), place.end());
  }
}

/// *next++ = x: *next = x; next = next + 1.
void count_after_assignment(Lexemes& tokens) {
  const At end = place_after(tokens, 0);
  if (end + 1 >= std::ssize(tokens) || !is_one_of(tokens[end], {"++", "--"}) || !tokens[end + 1].is("="))
    return;
  Lexemes counting = between(tokens, 0, end + 1);
  counting.front().apart = true;
  erase(tokens, end, end + 1);
  if (!tokens.back().is(";")) tokens.push_back({";"});
  tokens.insert(tokens.end(), counting.begin(), counting.end());
}

/// ++x: x = x + 1; inside something else in brackets.
void spell_out_counting(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    if (!is_one_of(tokens[i], {"++", "--"})) continue;
    const bool before = i + 1 < std::ssize(tokens) && is_name(tokens[i + 1]);
    const At first = before ? i : place_before(tokens, i);
    const At last = before ? place_after(tokens, i + 1) : i + 1;
    Lexemes place = before ? between(tokens, i + 1, last) : between(tokens, first, i);
    if (place.empty()) continue;
    const bool alone = (first == 0 || is_one_of(tokens[first - 1], {";", ",", ")", "then"})) &&
                       (last == std::ssize(tokens) || is_one_of(tokens[last], {";", ",", ")", "do"}));
    const std::string sign = tokens[i].text.substr(0, 1);
    const bool apart = tokens[first].apart;
    place.front().apart = false;
    Lexemes spelled = place;
    spelled.push_back({"=", true});
    place.front().apart = true;
    spelled.insert(spelled.end(), place.begin(), place.end());
    spelled.push_back({sign, true});
    spelled.push_back({"1", true});
    if (!alone) {
      spelled.insert(spelled.begin(), {"(", false});
      spelled.push_back({")", false});
    }
    spelled.front().apart = apart;
    tokens.erase(tokens.begin() + first, tokens.begin() + last);
    tokens.insert(tokens.begin() + first, spelled.begin(), spelled.end());
    i = first + std::ssize(spelled) - 1;
  }
}

// --- Statements ----------------------------------------------------------------------------------

std::vector<Lexemes> split(const Lexemes& tokens, std::string_view sign) {
  std::vector<Lexemes> parts(1);
  int depth = 0;
  for (const Lexeme& token : tokens) {
    if (is_one_of(token, {"(", "[", "{"})) ++depth;
    if (is_one_of(token, {")", "]", "}"})) --depth;
    if (depth == 0 && token.is(sign)) {
      parts.emplace_back();
    } else {
      parts.back().push_back(token);
    }
  }
  return parts;
}

std::optional<int> number_in(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "i < n" as the last value of a count: n - 1.
std::optional<std::string> last_value(const Lexemes& condition, const std::string& counter) {
  if (condition.size() < 3 || !condition[0].is(counter) || !is_one_of(condition[1], {"<", "<="}))
    return std::nullopt;
  const std::string bound = text_of(between(condition, 2, std::ssize(condition)));
  if (condition[1].is("<=")) return bound;
  if (const auto number = number_in(bound)) return std::to_string(*number - 1);
  return bound + " - 1";
}

/// What stands between "for" and "do".
std::string loop_text(const Lexemes& head) {
  if (const auto range = split(head, ":"); range.size() == 2)
    return "for each " + text_of(range[0]) + " in " + text_of(range[1]);
  const auto parts = split(head, ";");
  if (parts.size() != 3) return "for " + text_of(head);
  const Lexemes &start = parts[0], &condition = parts[1], &step = parts[2];
  if (start.size() > 2 && start[1].is("=")) {
    const std::string counter = start[0].text, from = text_of(between(start, 2, std::ssize(start)));
    const std::string first = "for " + counter + " = " + from;
    const bool counts_up = text_of(step) == "++" + counter || text_of(step) == counter + "++";
    if (const auto last = last_value(condition, counter); last && counts_up) return first + " to " + *last;
    if (const auto number = number_in(from); number && counts_up)
      return first + ", " + std::to_string(*number + 1) + ", … while " + text_of(condition);
    if (step.empty() && text_of(condition) == counter + "-- > 0") return first + " - 1 down to 0";
  }
  std::string text = start.empty() ? "" : text_of(start) + ", ";
  text += "while " + text_of(condition);
  return step.empty() ? text : text + ", then " + text_of(step);
}

/// if (…) {, while (…) {, for (…) {, do {, } else {: their words.
void write_control(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    const std::string word = tokens[i].text;
    if (word == "do") tokens[i].text = "repeat";
    if (word != "if" && word != "while" && word != "for" && word != "switch") continue;
    if (i + 1 < std::ssize(tokens) && tokens[i + 1].is("constexpr")) erase(tokens, i + 1, i + 2);
    if (i + 1 >= std::ssize(tokens) || !tokens[i + 1].is("(")) continue;
    const At end = closing(tokens, i + 1);
    if (end < 0) continue;
    const Lexemes head = between(tokens, i + 2, end);
    const bool repeats = i > 0 && tokens[i - 1].is("}") && word == "while";
    std::string text = word == "for"      ? loop_text(head) + " do"
                       : word == "while"  ? "while " + text_of(head) + " do"
                       : word == "switch" ? "case " + text_of(head) + " of"
                                          : "if " + text_of(head) + " then";
    if (repeats && head.size() > 1 && head[0].is("!")) {
      text = "until " + text_of(between(head, 1, std::ssize(head)));
    } else if (repeats) {
      text = "until not (" + text_of(head) + ")";
    }
    Lexemes written = lexemes_of(text);
    const std::ptrdiff_t size = std::ssize(written);
    written.front().apart = tokens[i].apart;
    tokens.erase(tokens.begin() + i, tokens.begin() + end + 1);
    tokens.insert(tokens.begin() + i, written.begin(), written.end());
    i += size - 1;
  }
}

/// c ? a : b: if c then a else b.
void write_choices(Lexemes& tokens) {
  for (At i = 0; i < std::ssize(tokens); ++i) {
    if (!tokens[i].is("?")) continue;
    At first = i;
    for (int depth = 0; first > 0; --first) {
      const Lexeme& token = tokens[first - 1];
      if (is_one_of(token, {")", "]"})) ++depth;
      if (is_one_of(token, {"(", "["}) && --depth < 0) break;
      if (depth == 0 && (is_one_of(token, {"=", ",", ";"}) || is_keyword(token))) break;
    }
    int depth = 0;
    for (At k = i; k < std::ssize(tokens); ++k) {
      Lexeme& token = tokens[k];
      if (is_one_of(token, {"(", "["})) ++depth;
      if (is_one_of(token, {")", "]"}) && --depth < 0) break;
      if (depth != 0 || !token.is(":")) continue;
      token.text = "else";
      break;
    }
    tokens[i].text = "then";
    const bool apart = tokens[first].apart;
    tokens[first].apart = true;
    insert(tokens, first, {"if"});
    tokens[first].apart = apart;
    ++i;
  }
}

void write_signs(Lexemes& tokens) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> signs{{{"=", "←"},
                                                                                 {"==", "="},
                                                                                 {"!=", "≠"},
                                                                                 {"<=", "≤"},
                                                                                 {">=", "≥"},
                                                                                 {"&&", "and"},
                                                                                 {"||", "or"},
                                                                                 {"*", "·"},
                                                                                 {"%", "mod"},
                                                                                 {"nullopt", "nothing"},
                                                                                 {"nullptr", "nothing"},
                                                                                 {"NULL", "nothing"},
                                                                                 {"auto", "any"},
                                                                                 {";", ","}}};
  for (At i = 0; i < std::ssize(tokens); ++i) {
    Lexeme& token = tokens[i];
    const auto sign =
        std::ranges::find(signs, token.text, &std::pair<std::string_view, std::string_view>::first);
    if (sign != signs.end()) token.text = sign->second;
    if (!token.is("!")) continue;
    token.text = "not";
    if (i + 1 < std::ssize(tokens)) tokens[i + 1].apart = true;
  }
}

// --- Lines ---------------------------------------------------------------------------------------

/// Goes through a listing; knows which braces hold statements and which hold values.
class Rewriter {
 public:
  /// Nothing: the line has no meaning of its own.
  std::optional<std::string> rewritten(const std::string& line) {
    if (is_heading(line)) return line;
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t comment = std::min(line.find("//"), line.size());
    const std::string remark = line.substr(comment);
    if (comment <= indent) return line;
    const std::string_view statement = std::string_view(line).substr(indent, comment - indent);
    const std::string code = rewritten_code(statement);
    // A comment that stands inside a statement comes behind it
    remark_ += remark.empty() || remark_.empty() ? remark : remark.substr(2);
    if (!code.empty() && is_unfinished(statement)) return std::string(indent, ' ') + code;
    const std::string said = std::exchange(remark_, "");
    if (code.empty() && said.empty()) return std::nullopt;
    return std::string(indent, ' ') + code + (code.empty() || said.empty() ? "" : "  ") + said;
  }

 private:
  /// Its value or its list goes on below.
  static bool is_unfinished(std::string_view statement) {
    const std::size_t last = statement.find_last_not_of(' ');
    return last != std::string_view::npos &&
           std::string_view("=(,+-*/?:&|").find(statement[last]) != std::string_view::npos;
  }

  std::string rewritten_code(std::string_view code) {
    Lexemes tokens = lexemes_of(code);
    if (tokens.front().is("using")) return "";
    drop_cpp(tokens);
    write_control(tokens);
    spell_out_compound(tokens);
    count_after_assignment(tokens);
    spell_out_counting(tokens);
    write_choices(tokens);
    drop_braces(tokens);
    while (!tokens.empty() && tokens.back().is(";")) tokens.pop_back();
    if (tokens.size() > 2 && tokens[0].is("return") && tokens[1].is("(") &&
        closing(tokens, 1) + 1 == std::ssize(tokens)) {
      tokens.pop_back();
      erase(tokens, 1, 2);
      tokens[1].apart = true;
    }
    write_signs(tokens);
    return text_of(tokens);
  }

  /// Of statements; a value's that end on another line become brackets.
  void drop_braces(Lexemes& tokens) {
    for (At i = 0; i < std::ssize(tokens); ++i) {
      if (tokens[i].is("{") && !opens_block(tokens, i)) {
        const bool typed = i > 0 && !tokens[i].apart && is_name(tokens[i - 1]);
        tokens[i].text = typed ? "(" : "[";
        closers_.push_back(typed ? ")" : "]");
      } else if (tokens[i].is("{")) {
        closers_.push_back("");
        tokens.erase(tokens.begin() + i--);
      } else if (tokens[i].is("}")) {
        const std::string_view closer = closers_.empty() ? "" : closers_.back();
        if (!closers_.empty()) closers_.pop_back();
        tokens[i].text = closer;
        if (closer.empty()) {
          erase(tokens, i, i + 1);
          --i;
        }
      }
    }
  }

  std::vector<std::string_view> closers_;  ///< for the braces that are open: nothing for statements
  std::string remark_;                     ///< of a statement that goes on
};

}  // namespace

std::vector<SourceLine> pseudocode(const std::vector<SourceLine>& listing) {
  std::vector<SourceLine> lines;
  Rewriter rewriter;
  for (const SourceLine& line : listing) {
    if (auto text = rewriter.rewritten(line.text))
      lines.push_back({line.number, std::move(*text), line.change});
  }
  return lines;
}

void write_pseudocode(Trace& trace) {
  // What is struck out is read among the lines that it stood among
  std::vector<SourceLine> taught = shown_listing(trace);
  std::erase_if(taught, [](const SourceLine& line) { return line.change == Change::added; });
  trace.struck = pseudocode(taught);
  std::erase_if(trace.struck, [](const SourceLine& line) { return line.change != Change::struck; });
  trace.listing = pseudocode(trace.listing);
}

}  // namespace gradus
