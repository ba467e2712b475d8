#include "figure/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <numeric>
#include <optional>
#include <vector>

#include "figure/text/metrics.hpp"
#include "figure/trace.hpp"

namespace gradus {
namespace {

__extension__ typedef __int128 int128_t;

// Two characters of the private area, round all digits of what was rounded
constexpr char32_t note_begin = 0xf0a0, note_end = 0xf0a1;
constexpr std::string_view note_begin_bytes = "\uf0a0", note_end_bytes = "\uf0a1", minus_bytes = "−";
constexpr std::int64_t largest_denominator = 1000;

bool is_digit_of_number(char32_t c) { return U'0' <= c && c <= U'9'; }

// --- Rational numbers, as far as 128 bits go -------------------------------------------------------------

int128_t common_divisor(int128_t a, int128_t b) {
  a = a < 0 ? -a : a;
  b = b < 0 ? -b : b;
  while (b != 0) a = std::exchange(b, a % b);
  return a;
}

/// Lowest terms, denominator above 0.
struct Ratio {
  int128_t above = 0, below = 1;
  friend bool operator==(const Ratio&, const Ratio&) = default;
};
using MaybeRatio = std::optional<Ratio>;

MaybeRatio ratio_of(int128_t above, int128_t below) {
  if (below == 0) return std::nullopt;
  const int128_t common = common_divisor(above, below) * (below < 0 ? -1 : 1);
  return Ratio{above / common, below / common};
}

/// Nothing where a product or sum does not fit.
std::optional<int128_t> times(int128_t a, int128_t b) {
  int128_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
  return product;
}

MaybeRatio multiplied(const MaybeRatio& a, const MaybeRatio& b) {
  if (!a || !b) return std::nullopt;
  const auto above = times(a->above, b->above), below = times(a->below, b->below);
  return above && below ? ratio_of(*above, *below) : std::nullopt;
}
MaybeRatio inverted(const MaybeRatio& a) { return a ? ratio_of(a->below, a->above) : std::nullopt; }
MaybeRatio negated_ratio(const MaybeRatio& a) { return a ? ratio_of(-a->above, a->below) : std::nullopt; }
MaybeRatio added(const MaybeRatio& a, const MaybeRatio& b) {
  if (!a || !b) return std::nullopt;
  const auto left = times(a->above, b->below), right = times(b->above, a->below),
             below = times(a->below, b->below);
  int128_t above = 0;
  if (!left || !right || !below || __builtin_add_overflow(*left, *right, &above)) return std::nullopt;
  return ratio_of(above, *below);
}

/// The double nearest to a fraction of two numbers below 2^53 is their quotient. Domain: value > 0.
std::u32string fraction_text(double value) {
  for (std::int64_t below = 2; below <= largest_denominator && value < 1e6; ++below) {
    const double above = std::round(value * static_cast<double>(below));
    if (above / static_cast<double>(below) == value)
      return code_points(fmt::format("{:.0f}/{}", above, below));
  }
  return {};
}

// --- Texts taken apart -----------------------------------------------------------------------------------

enum class Kind : std::uint8_t { number, name, sign, open, close, comma, relation, equals, space, other };

/// Views into the text, or into what takes its place.
struct Piece {
  Kind kind;
  std::u32string_view text;
  bool rounded = false;
  std::u32string_view whole{};  ///< all digits of a rounded number
};

Kind kind_of(char32_t c) {
  if (c == U' ' || c == U'\u00a0') return Kind::space;
  if (c == U'=') return Kind::equals;
  if (std::u32string_view(U"<>≤≥≈≠").find(c) != std::u32string_view::npos) return Kind::relation;
  if (std::u32string_view(U"+−-·×/").find(c) != std::u32string_view::npos) return Kind::sign;
  if (c == U'(') return Kind::open;
  if (c == U')') return Kind::close;
  if (c == U',') return Kind::comma;
  const bool letter = (U'a' <= c && c <= U'z') || (U'A' <= c && c <= U'Z') || (0xc0 <= c && c <= 0x24f) ||
                      (0x370 <= c && c <= 0x3ff) || c == U'_' || c == U'′' || (0x2080 <= c && c <= 0x209c);
  return letter ? Kind::name : Kind::other;
}

/// Behind the digits of a number: 12, 1.5, 1.2e-05.
std::size_t end_of_number(std::u32string_view c, std::size_t at) {
  const auto digits = [c](std::size_t from) {
    while (from < c.size() && is_digit_of_number(c[from])) ++from;
    return from;
  };
  at = digits(at);
  if (at + 1 < c.size() && c[at] == U'.' && is_digit_of_number(c[at + 1])) at = digits(at + 1);
  if (at + 2 < c.size() && c[at] == U'e' && (c[at + 1] == U'-' || c[at + 1] == U'+') &&
      is_digit_of_number(c[at + 2]))
    at = digits(at + 2);
  return at;
}

std::vector<Piece> pieces_in(std::u32string_view c) {
  std::vector<Piece> pieces;
  pieces.reserve(c.size());
  for (std::size_t i = 0; i < c.size();) {
    if (c[i] == note_begin) {
      const std::size_t end = std::min(c.find(note_end, i), c.size() - 1);
      if (!pieces.empty()) {
        pieces.back().rounded = true;
        pieces.back().whole = c.substr(i + 1, end - i - 1);
      }
      i = end + 1;
      continue;
    }
    std::size_t end = i + 1;
    Kind kind = kind_of(c[i]);
    if (is_digit_of_number(c[i])) {
      kind = Kind::number;
      end = end_of_number(c, i);
    } else if (kind == Kind::name) {
      while (end < c.size() && (kind_of(c[end]) == Kind::name || is_digit_of_number(c[end]))) ++end;
    }
    pieces.push_back({kind, c.substr(i, end - i)});
    i = end;
  }
  return pieces;
}

MaybeRatio value_of(std::u32string_view number) {
  Ratio value;
  int decimals = 0, exponent = 0;
  bool point = false;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == U'.') {
      point = true;
    } else if (number[i] == U'e') {
      exponent = std::atoi(utf8_of(number.substr(i + 1)).c_str());
      break;
    } else {
      const auto ten = times(value.above, 10);
      if (!ten) return std::nullopt;
      value.above = *ten + static_cast<int>(number[i] - U'0');
      decimals += point;
    }
  }
  MaybeRatio result = value;
  for (int i = 0; i < std::abs(exponent - decimals) && result; ++i)
    result = multiplied(result, exponent > decimals ? ratio_of(10, 1) : ratio_of(1, 10));
  return result;
}

// --- Expressions -----------------------------------------------------------------------------------------

/// What stands on one side of a sign.
struct Side {
  MaybeRatio value{};    ///< where it is arithmetic of numbers
  bool rounded = false;  ///< a number in it is
};

/// Reads an expression: sums of products of numbers, names, tuples and what is in parentheses. What is no
/// arithmetic has no value, but is read all the same.
class Reader {
 public:
  Reader(const std::vector<Piece>& pieces, std::size_t begin, std::size_t end)
      : pieces_(pieces), at_(begin), end_(end) {}

  /// Nothing where there is none.
  std::optional<Side> expression() {
    std::optional<Side> left = term();
    while (left) {
      const std::size_t before = at_;
      const char32_t sign = take_sign(U"+−-");
      if (sign == 0) break;
      const std::optional<Side> right = term();
      if (!right) {
        at_ = before;
        break;
      }
      left->value = added(left->value, sign == U'+' ? right->value : negated_ratio(right->value));
      left->rounded |= right->rounded;
    }
    return left;
  }
  std::size_t at() const { return at_; }

 private:
  void skip_spaces() {
    while (at_ < end_ && pieces_[at_].kind == Kind::space) ++at_;
  }
  bool is(Kind kind) const { return at_ < end_ && pieces_[at_].kind == kind; }
  char32_t take_sign(std::u32string_view signs) {
    const std::size_t before = at_;
    skip_spaces();
    if (is(Kind::sign) && signs.find(pieces_[at_].text[0]) != signs.npos) return pieces_[at_++].text[0];
    at_ = before;
    return 0;
  }

  std::optional<Side> term() {
    std::optional<Side> left = factor();
    while (left) {
      const std::size_t before = at_;
      const char32_t sign = take_sign(U"·×/");
      // "3x" and "t d" are products, too
      const bool close = sign == 0 && at_ < end_ && (is(Kind::name) || is(Kind::open));
      if (sign == 0 && !close) break;
      const std::optional<Side> right = factor();
      if (!right) {
        at_ = before;
        break;
      }
      left->value = close ? std::nullopt
                          : multiplied(left->value, sign == U'/' ? inverted(right->value) : right->value);
      left->rounded |= right->rounded;
    }
    return left;
  }

  std::optional<Side> factor() {
    skip_spaces();
    if (at_ >= end_) return std::nullopt;
    const Piece& piece = pieces_[at_];
    if (piece.kind == Kind::sign && (piece.text == U"−" || piece.text == U"-")) {
      ++at_;
      std::optional<Side> side = factor();
      if (side) side->value = negated_ratio(side->value);
      return side;
    }
    std::optional<Side> side;
    if (piece.kind == Kind::number) {
      ++at_;
      side = Side{value_of(piece.text), piece.rounded};
    } else if (piece.kind == Kind::name) {
      ++at_;
      side = Side{std::nullopt, piece.rounded};
    } else if (piece.kind == Kind::open) {
      side = in_parentheses();
    }
    // Powers and what else hangs on: no value is claimed
    while (side && at_ < end_ && pieces_[at_].kind == Kind::other && is_raised_sign(pieces_[at_].text[0])) {
      side->value.reset();
      ++at_;
    }
    return side;
  }
  static bool is_raised_sign(char32_t c) {
    return c == U'²' || c == U'³' || c == U'¹' || (0x2070 <= c && c <= 0x207f) || c == U'°';
  }

  std::optional<Side> in_parentheses() {
    const std::size_t before = at_++;
    std::optional<Side> side = expression();
    while (side) {
      skip_spaces();
      if (is(Kind::close)) {
        ++at_;
        return side;
      }
      if (!is(Kind::comma)) break;
      ++at_;
      const std::optional<Side> next = expression();
      if (!next) break;
      side = Side{std::nullopt, side->rounded || next->rounded};
    }
    at_ = before;
    return std::nullopt;
  }

  const std::vector<Piece>& pieces_;
  std::size_t at_, end_;
};

/// The longest expression that ends before a sign.
Side before_sign(const std::vector<Piece>& pieces, std::size_t sign) {
  std::size_t from = sign;
  while (from > 0 && pieces[from - 1].kind != Kind::equals && pieces[from - 1].kind != Kind::relation) --from;
  for (; from < sign; ++from) {
    if (pieces[from].kind == Kind::space) continue;
    // A name in the middle of words is no beginning
    Reader reader(pieces, from, sign);
    const std::optional<Side> side = reader.expression();
    std::size_t rest = reader.at();
    while (rest < sign && pieces[rest].kind == Kind::space) ++rest;
    if (side && rest == sign) return *side;
  }
  return {};
}

Side behind_sign(const std::vector<Piece>& pieces, std::size_t sign) {
  return Reader(pieces, sign + 1, pieces.size()).expression().value_or(Side{});
}

// --- Texts put together ----------------------------------------------------------------------------------

/// What takes the place of pieces, at the same address for as long as they are used.
using Written = std::deque<std::u32string>;

void show_fractions(std::vector<Piece>& pieces, Written& all_written) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    if (!piece.rounded) continue;
    const std::u32string_view written =
        all_written.emplace_back(fraction_text(std::strtod(utf8_of(piece.whole).c_str(), nullptr)));
    if (written.empty()) continue;
    const auto is_product = [&](std::size_t at) {
      return at < pieces.size() &&
             (pieces[at].text == U"·" || pieces[at].text == U"/" || pieces[at].text == U"²");
    };
    std::size_t before = i, behind = i + 1;
    while (before > 0 && pieces[before - 1].kind == Kind::space) --before;
    while (behind < pieces.size() && pieces[behind].kind == Kind::space) ++behind;
    const bool in_product = (before > 0 && is_product(before - 1)) || is_product(behind);
    const auto slash = written.find(U'/');
    // Pieces of their own, so that they are arithmetic
    std::vector<Piece> fraction{{Kind::number, written.substr(0, slash)},
                                {Kind::sign, U"/"},
                                {Kind::number, written.substr(slash + 1)}};
    if (in_product) {
      fraction.insert(fraction.begin(), {Kind::open, U"("});
      fraction.push_back({Kind::close, U")"});
    }
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
    pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i), fraction.begin(), fraction.end());
    i += fraction.size() - 1;
  }
}

void show_roundings(std::vector<Piece>& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kind != Kind::equals) continue;
    const Side left = before_sign(pieces, i), right = behind_sign(pieces, i);
    const bool differ = left.value && right.value && *left.value != *right.value;
    if (left.rounded || right.rounded || differ) pieces[i].text = U"≈";
  }
}

/// Commas in numbers; and semicolons between those of a point, which no-break spaces follow.
void show_commas(std::vector<Piece>& pieces, Written& all_written) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kind == Kind::number && pieces[i].text.find(U'.') != pieces[i].text.npos) {
      std::u32string& written = all_written.emplace_back(pieces[i].text);
      std::ranges::replace(written, U'.', U',');
      pieces[i].text = written;
    }
    if (pieces[i].kind == Kind::comma && i + 1 < pieces.size() && pieces[i + 1].text == U"\u00a0")
      pieces[i].text = U";";
  }
}

bool has_note(std::string_view text) { return text.find(note_begin_bytes) != text.npos; }

}  // namespace

std::string with_note(std::string text, double value) {
  constexpr double noise = 1e-12;  // of the last bits: that is not what a figure tells of
  std::string plain = text;
  if (plain.starts_with(minus_bytes)) plain.replace(0, minus_bytes.size(), "-");
  const double printed = std::strtod(plain.c_str(), nullptr);
  if (!std::isfinite(value) || std::abs(printed - value) <= noise * std::abs(value)) return text;
  return text.append(note_begin_bytes).append(fmt::format("{}", std::abs(value))).append(note_end_bytes);
}

std::string without_notes(std::string_view text) {
  std::string plain;
  while (true) {
    const std::size_t begin = text.find(note_begin_bytes);
    const std::size_t end = begin == text.npos ? text.npos : text.find(note_end_bytes, begin);
    if (end == text.npos) return plain.append(text);
    plain.append(text.substr(0, begin));
    text.remove_prefix(end + note_end_bytes.size());
  }
}

std::string settled(std::string_view text, NumberStyle style) {
  const bool noted = has_note(text);
  if (!noted && text.find('=') == text.npos && !style.decimal_comma) return std::string(text);
  const std::u32string characters = code_points(text);
  Written written;
  std::vector<Piece> pieces = pieces_in(characters);
  if (style.numbers == Numbers::fractions) show_fractions(pieces, written);
  show_roundings(pieces);
  if (style.decimal_comma) show_commas(pieces, written);
  std::u32string out;
  out.reserve(characters.size());
  for (const Piece& piece : pieces) out += piece.text;
  return utf8_of(out);
}

std::string with_decimal_points(std::string_view text) {
  std::string out(text);
  for (std::size_t i = 1; i + 1 < out.size(); ++i) {
    const auto digit = [&](std::size_t at) { return '0' <= out[at] && out[at] <= '9'; };
    if (out[i] == ',' && digit(i - 1) && digit(i + 1)) out[i] = '.';
    if (out.compare(i, 3, ";\u00a0") == 0) out[i] = ',';
  }
  return out;
}

namespace {

NumberStyle style_of(const Wording& wording) { return {wording.numbers(), wording.decimal_comma()}; }

void settle(std::string& text, NumberStyle style) { text = settled(text, style); }

void settle(Mark& mark, NumberStyle style) {
  if (Text* text = std::get_if<Text>(&mark.shape)) settle(text->text, style);
  if (Label* label = std::get_if<Label>(&mark.shape)) settle(label->text, style);
}

}  // namespace

void settle_numbers(Delta& delta, const Wording& wording) {
  const NumberStyle style = style_of(wording);
  for (Mark& mark : delta.set) settle(mark, style);
  for (CellChange& change : delta.cells) {
    if (change.look) settle(change.look->text, style);
  }
}

void settle_numbers(TraceStep& step, const Wording& wording) {
  const NumberStyle style = style_of(wording);
  for (std::string* text : {&step.sentence, &step.note, &step.phase}) settle(*text, style);
  for (Row* row : {&step.read, &step.row}) {
    for (std::string& cell : *row) settle(cell, style);
  }
  if (!step.decision) return;
  settle(step.decision->question, style);
  for (std::string& answer : step.decision->answers) settle(answer, style);
}

void settle_numbers(Trace& trace) {
  const NumberStyle style = style_of(trace.wording);
  for (std::string* text : {&trace.title, &trace.subtitle, &trace.method_title, &trace.faulty, &trace.goal})
    settle(*text, style);
  for (LegendEntry& entry : trace.legend) settle(entry.text, style);
  for (Mark& mark : trace.backdrop) settle(mark, style);
}

}  // namespace gradus
