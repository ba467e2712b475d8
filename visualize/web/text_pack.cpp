#include "web/text_pack.hpp"

#include <algorithm>
#include <utility>

#include "cairo/deflated.hpp"
#include "core/contract.hpp"

namespace gradus {
namespace {

constexpr char number_mark = '\1', colour_mark = '\2', shared_mark = '\3';
constexpr std::size_t most_digits = 15;  // so that a double holds every difference

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_hex(char c) { return is_digit(c) || ('a' <= c && c <= 'f'); }

/// A number or a colour in a line.
struct Token {
  char mark = number_mark;
  int decimals = 0;
  std::int64_t digits = 0;
};

/// A line in its two parts.
struct Line {
  std::string form;
  std::vector<Token> tokens;
};

/// Reads a line from left to right.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : text_(text) {}

  Line read() {
    while (at_ < text_.size()) {
      if (!read_colour() && !read_number()) line_.form += text_[at_++];
    }
    return std::move(line_);
  }

 private:
  bool read_colour() {
    const std::string_view word = text_.substr(at_, 7);
    if (word.size() < 7 || word[0] != '#' || !std::ranges::all_of(word.substr(1), is_hex)) return false;
    add({colour_mark, 0, std::stoll(std::string(word.substr(1)), nullptr, 16)}, 7);
    return true;
  }

  bool read_number() {
    std::size_t end = at_;
    const bool minus = text_[end] == '-';
    end += minus;
    Token token;
    std::size_t count = 0;
    const auto take = [&] {
      token.digits = 10 * token.digits + (text_[end++] - '0');
      ++count;
    };
    const auto digit_at = [&](std::size_t place) { return place < text_.size() && is_digit(text_[place]); };
    if (!digit_at(end)) return false;
    // "007" is three numbers
    const bool zero = text_[end] == '0';
    take();
    while (!zero && digit_at(end) && count < most_digits) take();
    if (end < text_.size() && text_[end] == '.' && digit_at(end + 1) && count < most_digits) {
      ++end;
      for (; digit_at(end) && count < most_digits; ++token.decimals) take();
    }
    // The sign of "-0" belongs to the form
    if (minus && token.digits == 0) return false;
    if (minus) token.digits = -token.digits;
    add(token, end - at_);
    return true;
  }

  void add(const Token& token, std::size_t length) {
    line_.form += token.mark;
    line_.tokens.push_back(token);
    at_ += length;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Line line_;
};

void add_whole(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes += static_cast<char>((value & 127) | 128);
  bytes += static_cast<char>(value);
}

/// With the sign in the lowest bit: 0, -1, 1, -2 …
std::uint64_t folded(std::int64_t value) {
  return value < 0 ? 2 * static_cast<std::uint64_t>(-(value + 1)) + 1 : 2 * static_cast<std::uint64_t>(value);
}

/// What a block holds before zlib packs it.
class Block {
 public:
  void begin_text(std::size_t lines) { add_whole(forms_, lines); }

  void add(int form, const std::vector<Token>& tokens) {
    add_whole(forms_, static_cast<std::uint64_t>(form));
    int place = 0;
    for (const Token& token : tokens) {
      if (token.mark == number_mark) places_ += static_cast<char>(token.decimals);
      std::int64_t& last = last_[{form, place++, token.decimals}];
      add_whole(digits_, folded(token.digits - last));
      last = token.digits;
    }
  }

  std::string packed() const {
    std::string bytes;
    add_whole(bytes, forms_.size());
    bytes += forms_;
    add_whole(bytes, places_.size());
    return deflated(bytes + places_ + digits_);
  }

 private:
  std::string forms_, places_, digits_;
  std::map<std::array<int, 3>, std::int64_t> last_;  ///< by form, place in it and decimals
};

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    expects(end != text.npos, "a text's last line ends, too, not {}", text);
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}

}  // namespace

int TextPack::form_of(const std::string& form) {
  const auto [known, is_new] = form_numbers_.try_emplace(form, static_cast<int>(forms_.size()));
  if (is_new) forms_.push_back(form);
  return known->second;
}

int TextPack::shared_of(const std::string& text) {
  const auto [known, is_new] = shared_numbers_.try_emplace(text, static_cast<int>(shared_.size()));
  if (is_new) shared_.push_back(text);
  return known->second;
}

std::string TextPack::block(std::span<const PartedText> texts) {
  Block block;
  for (const PartedText& text : texts) {
    std::vector<Line> lines;
    for (const TextPart& part : text) {
      if (part.shared) {
        lines.push_back({{shared_mark, number_mark}, {{number_mark, 0, shared_of(part.text)}}});
        continue;
      }
      for (const std::string_view line : lines_of(part.text)) lines.push_back(LineReader(line).read());
    }
    block.begin_text(lines.size());
    for (const Line& line : lines) block.add(form_of(line.form), line.tokens);
  }
  return block.packed();
}

std::vector<std::string> TextPack::shared_blocks() {
  std::vector<std::string> blocks;
  for (std::size_t first = 0; first < shared_.size(); first += shared_in_block) {
    std::vector<PartedText> texts;
    for (std::size_t i = first; i < std::min(first + shared_in_block, shared_.size()); ++i)
      texts.push_back({{shared_[i]}});
    blocks.push_back(block(texts));
  }
  return blocks;
}

}  // namespace gradus
