#pragma once
// Words and numbers that stories share.

#include <concepts>
#include <numeric>
#include <string>

#include "core/geometry.hpp"
#include "figure/text/number_text.hpp"
#include "stories/topic.hpp"

namespace gradus {

/// The same as a later term of a sum or a factor: "(−4)" when negative.
template <std::integral Whole>
std::string figure_factor(Whole value) {
  return value < 0 ? "(" + figure_number(value) + ")" : figure_number(value);
}

/// A point as figures show it: "(4, −2)", with a no-break space.
inline std::string figure_point(ivec2 p) {
  return fmt::format("({},\u00a0{})", figure_number(p.x), figure_number(p.y));
}

/// A fraction of non-negative numbers in lowest terms: "2/7", "0", "3".
inline std::string figure_fraction(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t common = std::gcd(numerator, denominator);
  if (common == denominator) return fmt::format("{}", numerator / denominator);
  return fmt::format("{}/{}", numerator / common, denominator / common);
}

/// A, B … Z, A1, B1 …
inline std::string letter(std::size_t n) {
  const char letter = static_cast<char>('A' + n % 26);
  return n < 26 ? std::string(1, letter) : fmt::format("{}{}", letter, n / 26);
}

/// The key of a pixel in a trace: "4,-2".
inline std::string pixel_key(ivec2 p) { return fmt::format("{},{}", p.x, p.y); }

/// The compass name of a move to a neighbouring pixel, y up.
inline std::string_view compass(ivec2 move) {
  constexpr std::string_view names[3][3] = {{"SW", "S", "SE"}, {"W", "", "E"}, {"NW", "N", "NE"}};
  return names[move.y + 1][move.x + 1];
}
/// What the reader calls that move.
inline std::string move_name(const Wording& wording, ivec2 move) { return wording.symbol(compass(move)); }

/// What a trace says of itself before its first step: topic, title, goal, method, what is wrong with it where
/// it is faulty, and its arguments. The texts are the topic's "title", "goal" or, where a
/// method has another, "goal.<name>", "method.<name>" and "note.<name>".
inline void introduce(Trace& trace, const std::string& topic, const Arguments& arguments, bool faulty) {
  trace.topic = topic;
  trace.method = arguments.text("method");
  trace.title = trace.wording.say(topic + ".title");
  const std::string its = topic + '.' + "goal." + trace.method;
  trace.goal = trace.wording.say(trace.wording.has(its) ? its : topic + ".goal");
  trace.method_title = trace.wording.say(topic + ".method." + trace.method);
  if (faulty) trace.faulty = trace.wording.say(topic + ".note." + trace.method);
  for (const Arguments::Entry& entry : arguments.entries()) {
    if (!entry.hash.empty()) trace.input_hash = entry.hash;
    if (!entry.text.empty()) trace.arguments.push_back({entry.name, entry.text});
  }
}

}  // namespace gradus
