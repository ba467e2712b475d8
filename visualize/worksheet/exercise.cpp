#include "worksheet/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <set>

#include "figure/text/metrics.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::worksheet {
namespace {

constexpr std::string_view no_value = "–";

bool is_figure(char32_t c) { return U'0' <= c && c <= U'9'; }
/// What makes a word with the digits beside it: a name, a mask, a power.
bool is_letter_of_name(char32_t c) {
  return (U'a' <= c && c <= U'z') || (U'A' <= c && c <= U'Z') || c == U'_' || c == U'′' ||
         (0xc0 <= c && c <= 0x24f) || (0x370 <= c && c <= 0x3ff);
}

/// A number of a cell, as it is written.
struct CellNumber {
  std::size_t whole = 0, decimals = 0, below = 0;  ///< digits; below: of what it is divided by
  int denominator = 0;
  bool code = false;  ///< zeros in front: no number, but digits side by side
};

/// Digits from here on.
std::size_t count_figures(std::u32string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_figure(text[end])) ++end;
  return end - at;
}

/// The number that begins at a digit; `at` moves behind it.
CellNumber take_number(std::u32string_view text, std::size_t& at) {
  CellNumber number;
  number.whole = count_figures(text, at);
  number.code = number.whole > 1 && text[at] == U'0';
  at += number.whole;
  const auto goes_on = [&](std::u32string_view signs) {
    return at + 1 < text.size() && signs.find(text[at]) != signs.npos && is_figure(text[at + 1]);
  };
  if (goes_on(U".,")) {
    number.decimals = count_figures(text, at + 1);
    at += 1 + number.decimals;
  }
  if (goes_on(U"/")) {
    number.below = count_figures(text, at + 1);
    if (number.below <= 3) {
      number.denominator = std::atoi(utf8_of(text.substr(at + 1, number.below)).c_str());
    }
    at += 1 + number.below;
  }
  return number;
}

bool can_be_had(const CellNumber& number, Reckoning reckoning) {
  constexpr int largest_denominator = 25;
  if (number.code) return true;
  if (number.whole > 3 || number.below > 3) return false;
  if (reckoning == Reckoning::calculator) return number.decimals <= 3;
  return number.decimals <= 2 && number.denominator <= largest_denominator;
}

/// What a step decided, in words.
std::string decision_text(const Decision& decision) {
  if (decision.answers.empty()) return decision.question;
  return fmt::format("{} {}", decision.question, decision.answers[decision.answer]);
}

/// The decision that a row is told with, until one reads the row itself.
void take_decision(ExerciseRow& row, const Decision& decision) {
  row.decision = decision_text(decision);
  row.branch = decision.branch.empty() ? row.decision : decision.branch;
}

/// How often each kind of branch was taken; of a beginning the last row may go on otherwise.
std::map<std::string, int> branches_of(const Exercise& exercise, bool beginning) {
  std::map<std::string, int> branches;
  for (std::size_t r = 0; r + (beginning ? 1 : 0) < exercise.rows.size(); ++r) {
    if (!exercise.rows[r].branch.empty()) ++branches[exercise.rows[r].branch];
  }
  return branches;
}

// --- Rounded numbers -------------------------------------------------------------------------------------

/// A number as a text shows it, and half of its last place.
struct ShownNumber {
  double value, half;
};

/// The decimals of a text with points.
std::vector<ShownNumber> decimals_in(const std::string& text) {
  std::vector<ShownNumber> numbers;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] < '0' || text[at] > '9') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789.e", at), text.size());
    const std::string number = text.substr(at, end - at);
    const std::size_t point = number.find('.');
    if (point != std::string::npos) {
      double half = 0.5;
      for (std::size_t i = point + 1; i < number.size(); ++i) half /= 10;
      numbers.push_back({std::strtod(number.c_str(), nullptr), half});
    }
    at = end;
  }
  return numbers;
}

/// Sizes of the real numbers that a step reports.
std::vector<double> reported_by(const TraceStep& step) {
  std::vector<double> values;
  for (const Field& field : step.fields) {
    if (const double* value = std::get_if<double>(&field.value)) values.push_back(std::abs(*value));
    if (const std::string* text = std::get_if<std::string>(&field.value)) {
      for (const ShownNumber& number : decimals_in(*text)) values.push_back(number.value);
    }
  }
  return values;
}

/// Whether a number in a cell is near one that was reported, but is none of them.
bool is_rounded(const Row& cells, const std::vector<double>& reported, bool decimal_comma) {
  constexpr double noise = 1e-9;
  const auto rounded = [&](const ShownNumber& shown) {
    const auto within = [&](double most) {
      return std::ranges::any_of(reported, [&](double v) { return std::abs(v - shown.value) <= most; });
    };
    return within(shown.half) && !within(noise * std::max(1.0, shown.value));
  };
  return std::ranges::any_of(cells, [&](const std::string& cell) {
    return std::ranges::any_of(decimals_in(decimal_comma ? with_decimal_points(cell) : cell), rounded);
  });
}

}  // namespace

bool can_be_had(std::string_view cell, Reckoning reckoning) {
  if (cell.find("≈") != std::string_view::npos && reckoning == Reckoning::by_hand) return false;
  const std::u32string characters = code_points(cell);
  const std::u32string_view text = characters;
  for (std::size_t at = 0; at < text.size();) {
    if (is_letter_of_name(text[at])) {
      while (at < text.size() && (is_letter_of_name(text[at]) || is_figure(text[at]))) ++at;
    } else if (is_figure(text[at])) {
      const std::size_t begin = at;
      const CellNumber number = take_number(text, at);
      if (at < text.size() && is_letter_of_name(text[at])) {
        // 3c7f is a mask; 1e-05 is a number that nobody writes by hand
        const bool exponent = text[at] == U'e' && at + 1 < text.size() && (text[at + 1] == U'-');
        if (exponent) return false;
        while (at < text.size() && (is_letter_of_name(text[at]) || is_figure(text[at]))) ++at;
        continue;
      }
      // A code of one sign per place: 1010
      const auto binary = [](char32_t c) { return c == U'0' || c == U'1'; };
      const bool bits = number.whole >= 4 && std::ranges::all_of(text.substr(begin, at - begin), binary);
      if (!bits && !can_be_had(number, reckoning)) return false;
    } else {
      ++at;
    }
  }
  return true;
}

int ExerciseRow::blanks() const { return static_cast<int>(std::ranges::count(asked, true)); }

int Exercise::blanks() const {
  return std::accumulate(rows.begin(), rows.end(), 0,
                         [](int sum, const ExerciseRow& row) { return sum + row.blanks(); });
}

std::string Exercise::answers() const {
  std::string text;
  for (const ExerciseRow& row : rows) {
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      if (row.asked[c]) text += row.cells[c] + "\t";
    }
    text += "\n";
  }
  return text;
}

Exercise exercise_of(std::shared_ptr<const Trace> trace, std::size_t most, const Exercise* model) {
  Exercise exercise;
  const std::size_t columns = trace->columns.size();
  exercise.drawn_until = trace->steps.front().number;
  std::vector<std::size_t> reading;  // rows that a decision has read
  std::vector<std::vector<double>> reported;
  for (const TraceStep& step : trace->steps) {
    // What completes a row that was cut off completes none of the exercise
    if (!step.read.empty() && !exercise.rows.empty() && exercise.rows_of_run <= most) {
      exercise.rows.back().cells = step.read;
      if (step.decision) {
        take_decision(exercise.rows.back(), *step.decision);
        reading.push_back(exercise.rows.size() - 1);
      }
    }
    if (!step.row.empty() && ++exercise.rows_of_run <= most)
      exercise.rows.push_back({step.row, {}, step.number});
    if (exercise.rows_of_run > most) continue;
    reported.resize(exercise.rows.size());
    if (!reported.empty()) {
      for (const double value : reported_by(step)) reported.back().push_back(value);
    }
    exercise.drawn_until = step.number;
    const bool undecided = !exercise.rows.empty() && exercise.rows.back().decision.empty();
    if (step.decision && undecided) take_decision(exercise.rows.back(), *step.decision);
  }
  for (std::size_t r = 0; r < exercise.rows.size() && !reading.empty(); ++r) {
    if (std::ranges::find(reading, r) != reading.end()) continue;
    exercise.rows[r].decision.clear();
    exercise.rows[r].branch.clear();
  }
  for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
    ExerciseRow& row = exercise.rows[r];
    row.cells.resize(columns);
    row.rounded = is_rounded(row.cells, reported[r], trace->wording.decimal_comma());
    row.asked.assign(columns, false);
    if (r == 0) continue;
    for (std::size_t c = 0; c < columns; ++c)
      row.asked[c] = !row.cells[c].empty() && row.cells[c] != no_value;
    const bool named = !model || (r < model->rows.size() && model->rows[r].cells[0] == row.cells[0]);
    if (columns > 1 && named) row.asked[0] = false;
  }
  exercise.trace = std::move(trace);
  return exercise;
}

bool are_alike(const Exercise& a, const Exercise& b, bool beginnings) {
  if (a.rows.size() != b.rows.size()) return false;
  if (!beginnings && a.whole() != b.whole()) return false;
  if (!beginnings && a.whole() && a.trace->last != b.trace->last) return false;
  const std::size_t columns = a.trace->columns.size();
  if (columns != b.trace->columns.size()) return false;
  for (std::size_t c = 0; c < columns; ++c) {
    const auto filled = [c](const Exercise& exercise) {
      return std::ranges::count_if(exercise.rows,
                                   [c](const ExerciseRow& row) { return !row.cells[c].empty(); });
    };
    if (std::abs(filled(a) - filled(b)) > 1) return false;
  }
  const auto branches = [beginnings](const Exercise& exercise) { return branches_of(exercise, beginnings); };
  return std::ranges::equal(branches(a), branches(b), [](const auto& one, const auto& other) {
    return one.first == other.first && std::abs(one.second - other.second) <= 1;
  });
}

// --- Points ------------------------------------------------------------------------------------------------

std::string text_of(Points points, const Wording& wording) {
  std::string text = fmt::format("{}", static_cast<double>(points.parts) / points.of_one);
  if (const std::size_t point = text.find('.'); point != std::string::npos && wording.decimal_comma()) {
    text[point] = ',';
  }
  return text;
}

namespace {

/// What is shared out: the rows with blanks of all exercises, then their drawings.
std::vector<int> weights_of(const std::vector<const Exercise*>& exercises, bool with_drawings) {
  std::vector<int> weights;
  for (const Exercise* exercise : exercises) {
    for (const ExerciseRow& row : exercise->rows) {
      if (const int blanks = row.blanks(); blanks > 0) weights.push_back(blanks);
    }
    if (with_drawings) weights.push_back(std::max(1, exercise->blanks() / 4));
  }
  return weights;
}

/// Whole parts that are as near to the weights as can be, at least one each. Domain: units >= the weights'
/// number, all weights > 0.
std::vector<int> shared_out(int units, const std::vector<int>& weights) {
  const int sum = std::accumulate(weights.begin(), weights.end(), 0);
  const int free = units - static_cast<int>(weights.size());
  std::vector<int> shares(weights.size(), 1);
  std::vector<std::pair<int, std::size_t>> rests;  // largest first, of equal ones the earlier
  int left = free;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const std::int64_t exact = std::int64_t{free} * weights[i];
    shares[i] += static_cast<int>(exact / sum);
    left -= static_cast<int>(exact / sum);
    rests.emplace_back(-static_cast<int>(exact % sum), i);
  }
  std::ranges::sort(rests);
  for (int i = 0; i < left; ++i) ++shares[rests[static_cast<std::size_t>(i)].second];
  return shares;
}

}  // namespace

int fewest_halves(const std::vector<const Exercise*>& exercises, bool with_drawings) {
  const int parts = static_cast<int>(weights_of(exercises, with_drawings).size());
  return (parts + 1) / 2;  // a quarter of a point each
}

std::vector<Worth> worths_of(const std::vector<const Exercise*>& exercises, int halves, bool with_drawings) {
  const std::vector<int> weights = weights_of(exercises, with_drawings);
  const int parts = static_cast<int>(weights.size());
  if (parts == 0 || halves < fewest_halves(exercises, with_drawings)) return {};
  // Whole points where there are many, quarters where there are few
  const int of_one = halves % 2 == 0 && halves / 2 >= 3 * parts ? 1 : halves >= parts ? 2 : 4;
  std::vector<int> shares = shared_out(halves * of_one / 2, weights);
  std::vector<Worth> worths;
  std::size_t next = 0;
  for (const Exercise* exercise : exercises) {
    Worth& worth = worths.emplace_back();
    for (const ExerciseRow& row : exercise->rows) {
      worth.rows.push_back({row.blanks() > 0 ? shares[next++] : 0, of_one});
    }
    worth.drawing = {with_drawings ? shares[next++] : 0, of_one};
  }
  return worths;
}

}  // namespace gradus::worksheet
