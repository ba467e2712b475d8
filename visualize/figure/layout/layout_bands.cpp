// The bands above and below the drawing: title, sentence, footer, and what they leave in the middle.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

constexpr double narrow = 1000;  ///< units: below it the bands save room

/// As many lines as the longest sentence needs; a shorter one may break less well.
int lines_for_sentences(const Trace& trace, double room) {
  const int most = room < 800 ? 4 : 3;
  const auto lines = sentence_lines(trace.longest_sentence, sentence_size, 0.95 * room, most);
  return std::max(1, static_cast<int>(lines.size()));
}

/// Where a sentence may be broken.
enum class Break { outside_formulas, before_relations, before_terms };

bool is_relation(std::string_view word) {
  constexpr std::array<std::string_view, 9> relations{"=", "≈", "<", ">", "≤", "≥", "≠", "∈", ":"};
  return std::ranges::find(relations, word) != relations.end();
}
bool is_operator(std::string_view word) {
  constexpr std::array<std::string_view, 9> operators{"+", "−", "-", "·", "×", "÷", "/", "→", "mod"};
  return std::ranges::find(operators, word) != operators.end();
}
bool begins_term(std::string_view word) { return word == "+" || word == "−"; }

/// A word, and whether a no-break space is before it.
struct Word {
  std::string_view text;
  bool held = false;
};

std::vector<Word> words_of(std::string_view sentence) {
  constexpr std::string_view no_break = "\u00a0";
  std::vector<Word> words;
  bool held = false;
  while (!sentence.empty()) {
    const std::size_t space = sentence.find(' '), other = sentence.find(no_break);
    const std::size_t end = std::min({space, other, sentence.size()});
    words.push_back({sentence.substr(0, end), held});
    held = other < space;
    sentence.remove_prefix(std::min(end + (held ? no_break.size() : 1), sentence.size()));
  }
  return words;
}

/// Whether a point is not told to its end with this word, as with "(x,".
bool opens_point(std::string_view word) {
  return word.size() == 3 && word.starts_with('(') && (word.ends_with(',') || word.ends_with(';'));
}

/// The sentence's words, those of a formula held together: all of it, or up to its next relation or term.
std::vector<std::string> parts_of(std::string_view sentence, Break where) {
  std::vector<std::string> parts;
  std::string_view before;
  for (const Word& word : words_of(sentence)) {
    const bool may_begin = (where != Break::outside_formulas && is_relation(word.text)) ||
                           (where == Break::before_terms && begins_term(word.text));
    const bool in_formula =
        is_relation(before) || is_relation(word.text) || is_operator(before) || is_operator(word.text);
    if (!parts.empty() && (in_formula ? !may_begin : word.held || opens_point(before)))
      parts.back().append(word.held ? "\u00a0" : " ").append(word.text);
    else
      parts.emplace_back(word.text);
    before = word.text;
  }
  return parts;
}

/// As many parts a line as have room; `breaks`: after a semicolon, too.
std::vector<std::string> filled(const std::vector<std::string>& parts, double size, double room,
                                bool breaks) {
  std::vector<std::string> lines;
  for (const std::string& part : parts) {
    const bool begins = lines.empty() || (breaks && lines.back().ends_with(';'));
    if (begins || text_width(lines.back() + " " + part, Face::sans, size) > room)
      lines.push_back(part);
    else
      lines.back() += " " + part;
  }
  return lines;
}

/// The part behind a semicolon stands on its own where that takes no more lines.
std::vector<std::string> lines_of_parts(const std::vector<std::string>& parts, double size, double room) {
  std::vector<std::string> plain = filled(parts, size, room, false), lines = filled(parts, size, room, true);
  return lines.size() <= plain.size() ? lines : plain;
}

bool all_fit(const std::vector<std::string>& lines, double size, double room) {
  return std::ranges::all_of(
      lines, [&](const std::string& line) { return text_width(line, Face::sans, size) <= room; });
}

}  // namespace

double unit_of(const Look& look) {
  const double slide = std::min(look.width, look.height) / 720;
  return look.layout == Layout::slide ? slide : std::max(0.7 * slide, look.least_text / text_size);
}

Heading heading_of(const Trace& trace, const Look& look, double width, double height) {
  const std::string& title = look.title.empty() ? trace.title : look.title;
  const bool tight = width < narrow || height < 720;
  const auto sans = [](const std::string& text) { return text_width(text, Face::sans, text_size); };
  Heading heading;
  heading.title = lines_of(title, Face::bold, title_size, width, 2);
  const double method_width = sans(trace.method_title);
  const double title_width = text_width(heading.title.back(), Face::bold, title_size);
  if (title_width + 40 + method_width > width)
    heading.method_line = sans(trace.subtitle) + 40 + method_width <= width ? 1 : 2;
  heading.input = elided(trace.subtitle, Face::sans, text_size, width);
  heading.method = elided(trace.method_title, Face::sans, text_size, width);
  if (!trace.faulty.empty()) {
    heading.fault = lines_of(trace.wording.say("figure.faulty", fmt::arg("what", trace.faulty)), Face::bold,
                             text_size, width, 3);
  }
  heading.first_baseline = tight ? 40 : 45;
  heading.height = heading.first_baseline + 40 * (static_cast<double>(heading.title.size()) - 1) +
                   28 * std::max(1, heading.method_line) + 26 * static_cast<double>(heading.fault.size()) +
                   12;
  return heading;
}

Page page_of(const Trace& trace, const Look& look) {
  const auto has = [&look](Slot slot) { return look.slots.contains(slot); };
  const double unit = unit_of(look);
  Page page{look.width / unit, look.height / unit, 0, {}, {}};
  page.margin = std::clamp(page.width / 40, 22.0, 32.0);
  const double width = page.width - 2 * page.margin;
  double top = page.margin / 2, bottom = page.height - page.margin / 2;
  if (has(Slot::title)) {
    page.at.heading = heading_of(trace, look, width, page.height);
    top = page.at.heading.height;
    page.at.title = {page.margin, 0, width, top};
  }
  if (has(Slot::footer)) {
    page.at.footer_lines = footer_lines(trace, width);
    const double height = (width < narrow ? 42 : 46) + (page.at.footer_lines - 1) * footer_line;
    bottom = page.height - height;
    page.at.footer = {page.margin, bottom, width, height};
  }
  if (has(Slot::sentence)) {
    page.at.sentence_lines = lines_for_sentences(trace, width - 40);
    const double lines = page.at.sentence_lines * sentence_line;
    const double height = (page.at.sentence_lines == 1 ? 24 : 14) + lines;
    page.at.sentence = {page.margin, bottom - 4 - height, width, height};
    bottom -= height + 8;
  }
  page.middle = {page.margin, top, width, bottom - top - 4};
  return page;
}

std::vector<std::string> lines_of(const std::string& text, Face face, double size, double room, int most) {
  std::vector<std::string> lines = wrapped(text, face, size, room);
  const auto count = static_cast<std::size_t>(most);
  for (std::size_t i = count; i < lines.size(); ++i) lines[count - 1] += " " + lines[i];
  if (lines.size() > count) lines.resize(count);
  for (std::string& line : lines) line = elided(line, face, size, room);
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::vector<std::string> sentence_lines(const std::string& sentence, double size, double room, int most) {
  if (text_width(sentence, Face::sans, size) <= room) return {sentence};
  for (const Break where : {Break::outside_formulas, Break::before_relations, Break::before_terms}) {
    std::vector<std::string> lines = lines_of_parts(parts_of(sentence, where), size, room);
    if (std::ssize(lines) <= most && all_fit(lines, size, room)) return lines;
  }
  return lines_of(sentence, Face::sans, size, room, most);
}

}  // namespace gradus::layout
