// The listing slot: the lines round the current one, and the head of its loop.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

/// What stands free in a row: before the number, between it and the code, behind the code.
struct Gaps {
  double before, between, behind;
};
constexpr Gaps usual_gaps{12, 14, 8}, tight_gaps{8, 8, 4};  ///< even: letters of half the size stay sharp
const Gaps& gaps_of(Spacing spacing) { return spacing == Spacing::tight ? tight_gaps : usual_gaps; }
constexpr double sign_gap = 8;     ///< from the sign of a changed line to its code
constexpr double gap_height = 14;  ///< of the row of dots that stands for lines left out
constexpr std::size_t continuation_indent = 4;

double column_width() { return text_width("0", Face::mono, text_size); }

// --- Long lines ----------------------------------------------------------------------------------

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

std::string_view without_trailing_comment(std::string_view line) {
  const std::size_t comment = line.find("//");
  if (comment == std::string_view::npos || comment <= indent_of(line)) return line;
  return line.substr(0, line.find_last_not_of(' ', comment - 1) + 1);
}

std::size_t characters_in(std::string_view text) { return count_of_code_points(text); }

/// Whether a line may go on below before this character.
bool may_break_before(std::string_view line, std::size_t at) {
  if (line[at - 1] == '(') return line[at] != ')';
  if (line[at - 1] != ' ') return false;
  if (line[at - 2] == ',' || line[at - 2] == ';' || line.substr(0, at).ends_with(" = ")) return true;
  const std::string_view rest = line.substr(at);
  constexpr std::array operators{"&& ", "|| ", "+ ", "- ",  "* ",  "/ ", "% ", "== ", "!= ", "<= ",
                                 ">= ", "< ",  "> ", "<< ", ">> ", "? ", ": ", "& ",  "| "};
  return std::ranges::any_of(operators, [rest](const char* sign) { return rest.starts_with(sign); });
}

/// Where to break a line so that its first row has at most `columns` characters: as late as can be, but
/// rather outside brackets. Nothing: nowhere.
std::size_t best_break(std::string_view line, std::size_t columns) {
  constexpr std::size_t worth_of_a_bracket = 9;
  std::size_t best = std::string_view::npos, least = std::string_view::npos, depth = 0;
  const std::size_t indent = indent_of(line);
  for (std::size_t at = 1; at < line.size(); ++at) {
    if (line[at - 1] == '(' || line[at - 1] == '[') ++depth;
    if ((line[at - 1] == ')' || line[at - 1] == ']') && depth > 0) --depth;
    if (at < indent + 4 || !may_break_before(line, at)) continue;
    const std::size_t length = characters_in(line.substr(0, line.find_last_not_of(' ', at - 1) + 1));
    if (length > columns) break;
    const std::size_t cost = columns - length + worth_of_a_bracket * depth;
    if (cost > least) continue;
    least = cost;
    best = at;
  }
  return best;
}

std::vector<std::string> comment_rows(const std::string& line, std::size_t columns) {
  const std::size_t indent = indent_of(line);
  const std::string lead = std::string(indent, ' ') + "// ";
  const std::string words = line.substr(std::min(line.size(), line.find("//") + 2));
  std::vector<std::string> rows;
  const double room =
      (static_cast<double>(columns) - static_cast<double>(lead.size()) + 0.01) * column_width();
  for (const std::string& row : wrapped(words, Face::mono, text_size, room)) rows.push_back(lead + row);
  return rows;
}

// --- Which lines ---------------------------------------------------------------------------------

/// Position in the listing of the nearest line at or above a source line, but for those that are struck out.
std::size_t place_in(const std::vector<SourceLine>& lines, int number) {
  auto after = std::ranges::upper_bound(lines, number, {}, &SourceLine::number);
  while (after != lines.begin() && std::prev(after)->change == Change::struck) --after;
  return after == lines.begin() ? 0 : static_cast<std::size_t>(after - lines.begin()) - 1;
}

bool begins_with_word(std::string_view code, std::string_view word) {
  if (!code.starts_with(word)) return false;
  return code.size() == word.size() || code[word.size()] == ' ' || code[word.size()] == '(';
}

/// The head of the loop that a line stands in; the line itself where it is one, and where it stands in none.
std::size_t loop_of(const std::vector<SourceLine>& lines, std::size_t line) {
  const auto code = [&lines](std::size_t i) {
    return std::string_view(lines[i].text).substr(indent_of(lines[i].text));
  };
  const auto is_head = [&](std::size_t i) {
    return std::ranges::any_of(std::array{"for", "while", "do", "repeat"},
                               [&](const char* word) { return begins_with_word(code(i), word); });
  };
  if (is_head(line)) return line;
  // A brace that closes a loop belongs to it
  std::size_t indent = indent_of(lines[line].text) + (code(line).starts_with('}') ? 1u : 0u);
  for (std::size_t i = line; i-- > 0 && !is_heading(lines[i].text);) {
    if (indent_of(lines[i].text) >= indent || code(i).empty() || code(i).starts_with("//")) continue;
    if (lines[i].change == Change::struck) continue;
    indent = indent_of(lines[i].text);
    if (is_head(i)) return i;
  }
  return line;
}

/// The lines from `first` to before `last`, and above them, apart, the head of a loop.
struct Excerpt {
  std::size_t first = 0, last = 0;
  std::optional<std::size_t> head{};

  bool shows(std::size_t line) const { return (first <= line && line < last) || head == line; }
};

class Excerpts {
 public:
  Excerpts(const Trace& trace, std::size_t columns, int rows)
      : lines_(shown_listing(trace)), room_(static_cast<std::size_t>(std::max(rows, 1))) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      heights_.push_back(source_rows(lines_[i].text, columns).size());
      loops_.push_back(loop_of(lines_, i));
    }
    for (const int number : trace.lines) reporting_.push_back(place_in(lines_, number));
    const auto is_changed = [](const SourceLine& line) { return line.change != Change::none; };
    changed_ = std::ranges::any_of(lines_, is_changed);
    if (!changed_) stillest_ = stillest();
  }

  /// The lines to show, ascending.
  std::vector<std::size_t> with(std::optional<std::size_t> current) const {
    if (changed_) return round_changes(current);
    const Excerpt shown = current && !holds(stillest_, *current) ? round(*current) : stillest_;
    std::vector<std::size_t> lines;
    if (shown.head) lines.push_back(*shown.head);
    for (std::size_t i = shown.first; i < shown.last; ++i) lines.push_back(i);
    return lines;
  }
  /// Whether some step shows a line that takes more than a row.
  bool break_a_line() const {
    const auto breaks = [this](std::optional<std::size_t> current) {
      return std::ranges::any_of(with(current), [this](std::size_t line) { return heights_[line] > 1; });
    };
    return breaks(std::nullopt) || std::ranges::any_of(reporting_, breaks);
  }

 private:
  /// Where a fault changes the listing: the current line and the head of its loop, as many of the changed
  /// ones as fit, the nearest first, and what stands next to these.
  std::vector<std::size_t> round_changes(std::optional<std::size_t> current) const {
    std::set<std::size_t> shown;
    const auto add = [&](std::size_t line) {
      std::set<std::size_t> more = shown;
      more.insert(line);
      if (height_of(more) <= 2 * room_) shown = std::move(more);
    };
    if (current) shown.insert(*current);
    if (current) add(loops_[*current]);
    for (const std::size_t line : changed_lines(current.value_or(0))) add(line);
    const std::set<std::size_t> core = shown;
    std::size_t before = 0;
    for (std::size_t apart = 1; shown.size() > before; ++apart) {
      before = shown.size();
      for (const std::size_t line : core) {
        if (line >= apart && shown.contains(line - apart + 1)) add(line - apart);
        if (line + apart < lines_.size() && shown.contains(line + apart - 1)) add(line + apart);
      }
    }
    return {shown.begin(), shown.end()};
  }
  /// Run by run, the nearest to a line first, remarks that are struck out last.
  std::vector<std::size_t> changed_lines(std::size_t from) const {
    struct Run {
      std::size_t first, last;
      std::size_t apart(std::size_t line) const {
        return line < first ? first - line : line < last ? 0 : line - last + 1;
      }
    };
    std::vector<Run> runs;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].change == Change::none) continue;
      if (runs.empty() || runs.back().last != i) runs.push_back({i, i});
      runs.back().last = i + 1;
    }
    std::ranges::stable_sort(runs, {}, [from](const Run& run) { return run.apart(from); });
    std::vector<std::size_t> lines;
    for (const Run& run : runs)
      for (std::size_t i = run.first; i < run.last; ++i) lines.push_back(i);
    std::ranges::stable_partition(lines, [this](std::size_t i) {
      return lines_[i].change == Change::added ||
             !lines_[i].text.substr(indent_of(lines_[i].text)).starts_with("//");
    });
    return lines;
  }
  /// In halves of a row: a gap is as high as one.
  std::size_t height_of(const std::set<std::size_t>& lines) const {
    std::size_t height = 0;
    std::optional<std::size_t> before;
    for (const std::size_t line : lines) {
      height += 2 * heights_[line] + (before && line != *before + 1 ? 1u : 0u);
      before = line;
    }
    return height;
  }

  /// The one that shows most of the lines that report steps and their loops, so that the listing keeps still
  /// as long as it shows the current line.
  Excerpt stillest() const {
    std::optional<Excerpt> best;
    std::size_t most = 0;
    for (std::size_t first = 0; first < lines_.size(); ++first) {
      const Excerpt excerpt = from(first, std::nullopt);
      const std::size_t held = held_in(excerpt);
      if (!best || held > most) best = excerpt, most = held;
      if (excerpt.last == lines_.size()) break;
    }
    for (std::size_t head = 0; head < lines_.size(); ++head) {
      if (!is_loop(head)) continue;
      for (std::size_t first = head + 2; first < lines_.size(); ++first) {
        const Excerpt excerpt = from(first, head);
        const std::size_t held = held_in(excerpt);
        if (held > most) best = excerpt, most = held;
        if (excerpt.last == lines_.size()) break;
      }
    }
    return best.value_or(Excerpt{});
  }

  bool is_loop(std::size_t line) const {
    return std::ranges::any_of(reporting_, [&](std::size_t l) { return l != line && loops_[l] == line; });
  }
  /// As many lines as fit from this one on, below the head.
  Excerpt from(std::size_t first, std::optional<std::size_t> head) const {
    std::size_t room = room_;
    if (head) room -= std::min(room, heights_[*head] + 1);
    Excerpt excerpt{first, first, head};
    while (excerpt.last < lines_.size() && heights_[excerpt.last] <= room) room -= heights_[excerpt.last++];
    return excerpt;
  }
  bool holds(const Excerpt& excerpt, std::size_t line) const {
    return excerpt.shows(line) && excerpt.shows(loops_[line]);
  }
  /// What a loop does counts twice; a brace alone tells nothing.
  std::size_t held_in(const Excerpt& excerpt) const {
    std::size_t held = 0;
    for (const std::size_t line : reporting_) {
      if (holds(excerpt, line)) held += loops_[line] != line && !is_brace(line) ? 2u : 1u;
    }
    return held;
  }
  bool is_brace(std::size_t line) const {
    return lines_[line].text.find_first_not_of(" })") == std::string::npos;
  }
  /// With the line about in the middle, its loop's head above where that is too far.
  Excerpt round(std::size_t line) const {
    const std::size_t head = loops_[line];
    const auto centred = [&](std::optional<std::size_t> above) {
      // The lines before share a half of what the others leave
      const std::size_t taken = heights_[line] + (above ? heights_[*above] + 1 : 0);
      std::size_t before = (room_ - std::min(room_, taken)) / 2, first = line;
      while (first > (above ? *above + 1 : 0) && heights_[first - 1] <= before) before -= heights_[--first];
      return from(first, above);
    };
    Excerpt excerpt = centred(std::nullopt);
    if (!excerpt.shows(head)) excerpt = centred(head);
    if (excerpt.head && excerpt.first == *excerpt.head + 1) excerpt = from(head, std::nullopt);
    // At the end there may be room for more before
    while (excerpt.last == lines_.size() && excerpt.first > 0) {
      const Excerpt earlier = from(excerpt.first - 1, excerpt.head);
      if (earlier.last < lines_.size() || (excerpt.head && earlier.first <= *excerpt.head + 1)) break;
      excerpt = earlier;
    }
    return excerpt.shows(line) ? excerpt : Excerpt{line, line + 1, {}};
  }

  std::vector<SourceLine> lines_;
  std::size_t room_;
  std::vector<std::size_t> heights_;    ///< rows of each line
  std::vector<std::size_t> loops_;      ///< the head of each line's loop
  std::vector<std::size_t> reporting_;  ///< lines that report steps
  bool changed_ = false;                ///< by a fault
  Excerpt stillest_;
};

/// Where the numbers before the lines end.
double numbers_indent(const Trace& trace, const Look& look, const Gaps& gaps) {
  if (look.line_numbers == LineNumbers::none || trace.listing.empty()) return gaps.before;
  const std::size_t highest = look.line_numbers == LineNumbers::listing
                                  ? trace.listing.size()
                                  : static_cast<std::size_t>(trace.listing.back().number);
  return gaps.before + static_cast<double>(fmt::formatted_size("{}", highest)) * column_width();
}

/// Where the code begins: behind the numbers and, where a fault changes lines, the signs - and +.
double code_indent(const Trace& trace, const Look& look, const Gaps& gaps) {
  const auto changed = [](const SourceLine& line) { return line.change != Change::none; };
  const bool signs = !trace.struck.empty() || std::ranges::any_of(trace.listing, changed);
  const bool numbers = look.line_numbers != LineNumbers::none && !trace.listing.empty();
  const double after = numbers ? gaps.between : 2;
  return numbers_indent(trace, look, gaps) + (signs ? after - 4 + column_width() + sign_gap : after);
}

// --- The slot ------------------------------------------------------------------------------------

class ListingLayout {
 public:
  ListingLayout(Pen& pen, const Figure& figure, const Look& look, const Box& box, Spacing spacing)
      : pen_(pen),
        figure_(figure),
        numbers_(look.line_numbers),
        s_(pen.scale()),
        box_(box),
        columns_(layout::listing_columns(*figure.trace, look, box.width / s_, spacing)),
        number_right_(box.x + numbers_indent(*figure.trace, look, gaps_of(spacing)) * s_),
        text_left_(box.x + code_indent(*figure.trace, look, gaps_of(spacing)) * s_) {}

  void draw(int rows) {
    pen_.rect(
        "panel",
        {box_, Paint::of(Tone::panel), Paint::of(Tone::rule), 1.5 * s_, 6 * s_, false, Hatch::none, {}});
    y_ = box_.y + panel_padding * s_;
    const auto strong = std::ranges::find(figure_.listing, Emphasis::strong, &Figure::ListingLine::emphasis);
    std::optional<std::size_t> current;
    if (strong != figure_.listing.end()) current = static_cast<std::size_t>(strong - figure_.listing.begin());
    std::optional<std::size_t> before;
    for (const std::size_t line : Excerpts(*figure_.trace, columns_, rows).with(current)) {
      if (before && line != *before + 1) draw_gap();
      draw_line(line);
      before = line;
    }
  }

 private:
  void draw_line(std::size_t index) {
    const Figure::ListingLine& entry = figure_.listing[index];
    const SourceLine& line = entry.line;
    const std::vector<std::string> rows = source_rows(line.text, columns_);
    const double height = static_cast<double>(rows.size()) * line_height * s_;
    const bool strong = entry.emphasis == Emphasis::strong;
    Paint ground = Paint::of(Tone::panel);
    if (entry.emphasis != Emphasis::none) {
      ground = Paint::of(strong ? Tone::strong : Tone::weak);
      pen_.rect(fmt::format("ground {}", line.number),
                {{box_.x, y_, box_.width, height}, ground, {}, 0, 0, false, Hatch::none, {}});
    }
    if (strong) {
      pen_.rect("current line",
                {{box_.x, y_, 6 * s_, height}, Paint::of(Tone::accent), {}, 0, 0, false, Hatch::none, {}});
    }
    const Paint quiet = Paint::of(Tone::muted), ink = Paint::of(Tone::ink);
    if (numbers_ != LineNumbers::none && is_counted(line)) {
      const int shown = numbers_ == LineNumbers::source ? line.number : place_of(index);
      write(fmt::format("number {}", line.number), fmt::format("{}", shown), number_right_,
            {Face::mono, Align::right, strong ? ink : quiet, ground});
    }
    if (line.change != Change::none) {
      write(fmt::format("change {}", line.number), line.change == Change::struck ? "−" : "+",
            text_left_ - sign_gap * s_, {Face::mono_bold, Align::right, ink, ground});
    }
    const Face face = strong || is_heading(line.text) ? Face::mono_bold : Face::mono;
    for (std::size_t i = 0; i < rows.size(); ++i, y_ += line_height * s_) {
      write(i == 0 ? fmt::format("line {}", line.number) : fmt::format("line {} row {}", line.number, i + 1),
            rows[i], text_left_, {face, Align::left, line.change == Change::struck ? quiet : ink, ground});
      if (line.change == Change::struck) strike(fmt::format("strike {} row {}", line.number, i + 1), rows[i]);
    }
  }

  static bool is_counted(const SourceLine& line) {
    return line.change != Change::struck && !is_heading(line.text);
  }
  /// Its number in the listing, in which neither struck lines nor headings are counted.
  int place_of(std::size_t index) const {
    return 1 + static_cast<int>(std::count_if(figure_.listing.begin(),
                                              figure_.listing.begin() + static_cast<std::ptrdiff_t>(index),
                                              [](const auto& l) { return is_counted(l.line); }));
  }

  struct Letters {
    Face face;
    Align align;
    Paint paint, ground;
  };
  void write(std::string id, std::string text, double x, const Letters& letters) {
    pen_.text(std::move(id), {{x, y_ + 22 * s_},
                              std::move(text),
                              letters.face,
                              text_size * s_,
                              letters.align,
                              letters.paint,
                              false,
                              letters.ground});
  }

  /// A line through the middle of a row's small letters.
  void strike(std::string id, const std::string& row) {
    const double y = y_ + 16 * s_, width = column_width() * s_;
    const double left = text_left_ + static_cast<double>(indent_of(row)) * width;
    const double right = text_left_ + static_cast<double>(characters_in(row)) * width;
    pen_.line(std::move(id), {{{left - 3 * s_, y}, {right + 3 * s_, y}}, Paint::of(Tone::ink), 1.8 * s_});
  }

  /// Dots where lines are left out.
  void draw_gap() {
    StrokesShape dots{{}, Paint::of(Tone::muted), 3.4 * s_, true};
    for (int i = 0; i < 3; ++i) {
      const dvec2 at{text_left_ + (5 + 9 * i) * s_, y_ + gap_height / 2 * s_};
      dots.segments.push_back({at, at});
    }
    pen_.strokes(gaps_++ == 0 ? "lines left out" : fmt::format("lines left out {}", gaps_), std::move(dots));
    y_ += gap_height * s_;
  }

  Pen& pen_;
  const Figure& figure_;
  LineNumbers numbers_;
  double s_;
  const Box& box_;
  std::size_t columns_;
  double number_right_, text_left_, y_ = 0;
  int gaps_ = 0;  ///< that were drawn
};

}  // namespace

std::size_t listing_columns(const Trace& trace, const Look& look, double width, Spacing spacing) {
  const double room = width - listing_width(trace, look, 0, spacing);
  return static_cast<std::size_t>(std::max(1.0, std::floor(room / column_width() + 1e-6)));
}

double listing_width(const Trace& trace, const Look& look, std::size_t columns, Spacing spacing) {
  const Gaps& gaps = gaps_of(spacing);
  return code_indent(trace, look, gaps) + static_cast<double>(columns) * column_width() + gaps.behind;
}

std::size_t longest_line(const Trace& trace) {
  std::size_t most = 1;
  for (const auto* lines : {&trace.listing, &trace.struck}) {
    for (const SourceLine& line : *lines)
      most = std::max(most, characters_in(without_trailing_comment(line.text)));
  }
  return most;
}

std::vector<std::string> source_rows(const std::string& line, std::size_t columns) {
  if (characters_in(line) <= columns) return {line};
  const std::size_t indent = indent_of(line);
  if (std::string_view(line).substr(indent).starts_with("//")) return comment_rows(line, columns);
  std::vector<std::string> rows;
  std::string rest(without_trailing_comment(line));
  while (characters_in(rest) > columns) {
    const std::size_t at = best_break(rest, columns);
    if (at == std::string::npos) break;
    rows.push_back(rest.substr(0, rest.find_last_not_of(' ', at - 1) + 1));
    rest = std::string(indent + continuation_indent, ' ') + rest.substr(at);
  }
  rows.push_back(elided(rest, Face::mono, text_size, (static_cast<double>(columns) + 0.01) * column_width()));
  return rows;
}

ListingRows::Count ListingRows::at(std::size_t columns) {
  const auto [place, is_new] = counts_.try_emplace(columns);
  Count& count = place->second;
  if (!is_new) return count;
  std::vector<int> rows;
  for (const SourceLine& line : lines_) {
    rows.push_back(static_cast<int>(source_rows(line.text, columns).size()));
    count.all += rows.back();
  }
  for (const int number : trace_->lines) {
    const std::size_t line = place_in(lines_, number), head = loop_of(lines_, line);
    count.of_a_loop = std::max(count.of_a_loop, rows[line] + (head == line ? 0 : rows[head] + 1));
  }
  return count;
}

bool ListingRows::break_a_shown_line(std::size_t columns, int rows) {
  const auto [place, is_new] = broken_.try_emplace({columns, rows});
  if (is_new)
    place->second = columns < longest_line(*trace_) && Excerpts(*trace_, columns, rows).break_a_line();
  return place->second;
}

void lay_out_listing(Pen& pen, const Figure& figure, const Look& look, const Box& box, int rows,
                     Spacing spacing) {
  ListingLayout(pen, figure, look, box, spacing).draw(rows);
}

}  // namespace gradus::layout
