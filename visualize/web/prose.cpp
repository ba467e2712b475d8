#include "web/prose.hpp"

#include <algorithm>
#include <vector>

#include "figure/text/markup.hpp"
#include "figure/text/typesetting.hpp"

namespace gradus {
namespace {

class Prose {
 public:
  explicit Prose(std::string_view text) : text_(text) {
    for (const Token& token : tokens_of(text)) {
      if (is_name(token)) names_.push_back(token);
    }
  }

  std::string set() {
    while (at_ < text_.size()) {
      if (next_ < names_.size() && names_[next_].begin == at_) {
        put_name(names_[next_++]);
      } else if (text_[at_] == '-') {
        html_ += dash();
        ++at_;
      } else if (text_[at_] == '^' && exponent_length() > 0) {
        put_exponent();
      } else {
        const std::size_t end = std::min(text_.find_first_of("-^", at_ + 1), next_name());
        html_ += escaped(text_.substr(at_, end - at_));
        at_ = std::min(end, text_.size());
      }
    }
    return std::move(html_);
  }

 private:
  static bool is_digit(char c) { return '0' <= c && c <= '9'; }
  static bool is_small(char c) { return 'a' <= c && c <= 'z'; }
  static bool is_letter(char c) { return is_small(c) || ('A' <= c && c <= 'Z'); }

  char before(std::size_t at) const { return at == 0 ? ' ' : text_[at - 1]; }
  char from(std::size_t at) const { return at < text_.size() ? text_[at] : ' '; }
  std::size_t next_name() const { return next_ < names_.size() ? names_[next_].begin : text_.size(); }

  /// A variable, but for words that look like one: the article and "do", units after a number, and letters of
  /// "1e308", "e.g.", "g++" and "y-coordinate".
  bool is_name(const Token& token) const {
    const std::string_view word = text_.substr(token.begin, token.end - token.begin);
    const char last = before(token.begin), next = from(token.end), second = from(token.end + 1);
    if (!is_variable(word) || word == "do" || last == '.' || last == '\'') return false;
    if (word == "a" && (token.begin == 0 || (next == ' ' && (is_letter(second) || is_digit(second)))))
      return false;
    const bool after_number = token.begin >= 2 && last == ' ' && is_digit(text_[token.begin - 2]);
    const bool unit = after_number && (word == "s" || word == "m");
    const bool power_of_ten = word.size() > 1 && word.starts_with('e') && is_digit(last);
    const bool of_a_word = (next == '.' && is_small(second)) || (next == '+' && second == '+') ||
                           (next == '-' && is_small(second) && is_small(from(token.end + 2)));
    return !unit && !power_of_ten && !of_a_word;
  }
  bool ends_name(std::size_t at) const { return std::ranges::find(names_, at, &Token::end) != names_.end(); }
  bool begins_name(std::size_t at) const {
    return std::ranges::find(names_, at, &Token::begin) != names_.end();
  }

  bool ends_value(std::size_t at) const {
    const char c = before(at);
    return is_digit(c) || c == ')' || c == ']' || c == '|' || static_cast<unsigned char>(c) >= 0x80 ||
           ends_name(at) || (is_letter(c) && !is_small(c) && !is_letter(before(at - 1)));
  }
  bool begins_value(std::size_t at) const {
    const char c = from(at);
    return is_digit(c) || c == '(' || c == '|' || static_cast<unsigned char>(c) >= 0x80 || begins_name(at) ||
           (is_letter(c) && !is_small(c) && !is_small(from(at + 1)));
  }

  /// A sign, the dash between two places, or a hyphen.
  std::string_view dash() const {
    const std::size_t after = at_ + 1;
    if (before(at_) == ')' && from(after) == '(' && names_a_place(at_)) return "–";
    if (before(at_) == ' ' && from(after) == ' ') return "−";        // as a dash the pages write a colon
    if (is_digit(before(at_)) && is_digit(from(after))) return "–";  // from 3 to 5
    // A compiler's option: "-O3"
    const bool option = !begins_name(after) && is_letter(from(after)) &&
                        (is_letter(from(after + 1)) || is_digit(from(after + 1)));
    const bool alone = at_ == 0 || std::string_view(" (=,[{|").find(before(at_)) != std::string_view::npos;
    const bool signs = begins_value(after) && !option && (alone || ends_value(at_) || is_power_of_ten());
    return signs ? "−" : "-";
  }
  /// "(3,4)" ends here.
  bool names_a_place(std::size_t end) const {
    const std::size_t open = text_.substr(0, end).rfind('(');
    return open != std::string_view::npos &&
           text_.substr(open, end - open).find(',') != std::string_view::npos;
  }
  bool is_power_of_ten() const { return at_ >= 2 && before(at_) == 'e' && is_digit(before(at_ - 1)); }

  std::size_t exponent_length() const {
    std::size_t end = at_ + 1;
    if (from(end) == '-') ++end;
    const std::size_t first = end;
    while (is_digit(from(end))) ++end;
    if (end == first && begins_name(end)) ++end;
    return end == first ? 0 : end - at_ - 1;
  }
  void put_exponent() {
    std::string exponent(text_.substr(at_ + 1, exponent_length()));
    at_ += 1 + exponent.size();
    while (next_ < names_.size() && names_[next_].begin < at_) ++next_;
    if (exponent.starts_with('-')) exponent.replace(0, 1, "−");
    html_ += "<sup>" + exponent + "</sup>";
  }
  void put_name(const Token& name) {
    const std::string_view word = text_.substr(name.begin, name.end - name.begin);
    const std::size_t letters = std::min(word.find_first_of("0123456789"), word.size());
    const std::size_t digits = std::min(word.find_first_not_of("0123456789", letters), word.size());
    html_ += "<i>" + escaped(word.substr(0, letters)) + "</i>";
    if (digits > letters) html_ += "<sub>" + std::string(word.substr(letters, digits - letters)) + "</sub>";
    html_ += escaped(word.substr(digits));
    at_ = name.end;
  }

  const std::string_view text_;
  std::vector<Token> names_;
  std::size_t at_ = 0, next_ = 0;
  std::string html_;
};

}  // namespace

std::string set_prose(std::string_view text) { return Prose(text).set(); }

}  // namespace gradus
