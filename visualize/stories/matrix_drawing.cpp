#include "stories/matrix_drawing.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"

namespace gradus {
namespace {

using fmt::arg;

constexpr double column_gap = 0.8;

/// Four rows stand closer.
double row_height(std::size_t rows) { return rows > 3 ? 1.6 : 2.1; }

/// The width of a digit; four columns stand closer.
double character(std::size_t columns) { return columns > 3 ? 0.74 : 0.92; }

double width_of(std::string_view noted, std::size_t columns) {
  const std::string text = without_notes(noted);
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
  return character(columns) *
         static_cast<double>(text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues)));
}

/// Four columns leave room for two decimals each.
std::string entry_text(double value, bool two_decimals) {
  if (!two_decimals || std::abs(value) >= 1000) return figure_real(value);
  return with_note(without_notes(figure_real(std::round(value * 100) / 100)), value);
}

/// The width of a column.
double column_width(const MatrixRows& rows, std::size_t column) {
  const std::size_t columns = rows.front().size();
  double width = character(columns);
  for (const auto& row : rows) {
    width = std::max(width, width_of(entry_text(row[column], columns > 3), columns));
  }
  return width;
}

std::string negated(std::string text) {
  return text.starts_with('-') ? text.substr(1) : text == "0" ? text : "-" + text;
}

Tuple negated(const Tuple& tuple) {
  Tuple result = tuple;
  for (Number& n : result) {
    n.value = 0 - n.value;
    n.text = negated(n.text);
    if (n.exact) n.exact->numerator = -n.exact->numerator;
  }
  return result;
}

}  // namespace

MatrixRows oriented(const Wording& words, MatrixRows rows) {
  if (!words.notation().rows) return rows;
  MatrixRows transposed(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) transposed[c].push_back(row[c]);
  }
  return transposed;
}

void add_matrix(View& view, std::string_view id, dvec2 right, const std::string& name, const MatrixRows& rows,
                Role role, bool aside) {
  const std::size_t columns = rows.front().size();
  const double height = row_height(rows.size()), half = 0.5 * height * static_cast<double>(rows.size());
  const auto bracket = [&](std::string_view side, double x, double inwards) {
    Path path{{{x + inwards, right.y + half},
               {x, right.y + half},
               {x, right.y - half},
               {x + inwards, right.y - half}}};
    path.aside = aside;
    view.add({fmt::format("{} bracket {}", id, side), role, std::move(path)});
  };
  bracket("right", right.x, -0.5);
  double x = right.x - 0.6;
  for (std::size_t c = columns; c-- > 0;) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::string text = entry_text(rows[r][c], columns > 3);
      const double y = right.y + half - height * (static_cast<double>(r) + 0.5);
      view.add({fmt::format("{} entry {} {}", id, r, c), role, Text{{x, y}, text, Align::right, aside}});
    }
    x -= column_width(rows, c) + (c > 0 ? column_gap : 0.6);
  }
  bracket("left", x, 0.5);
  if (name.empty()) return;
  view.add({fmt::format("{} name", id), role, Text{{x - 0.6, right.y}, name + " =", Align::right}});
}

dvec2 matrix_size(const MatrixRows& rows) {
  const std::size_t columns = rows.front().size();
  double width = 1.2 + column_gap * static_cast<double>(columns - 1);
  for (std::size_t c = 0; c < columns; ++c) width += column_width(rows, c);
  return {width, row_height(rows.size()) * static_cast<double>(rows.size())};
}

MatrixRows fitted(MatrixRows rows, double wide) {
  for (const double parts : {10.0, 1.0}) {
    if (matrix_size(rows).x <= wide) break;
    for (auto& row : rows) {
      for (double& x : row) x = std::round(x * parts) / parts;
    }
  }
  return rows;
}

std::string figure_text(const Number& number) {
  return number.text.starts_with('-') ? "−" + number.text.substr(1) : number.text;
}

std::string figure_text(const Tuple& point) {
  std::vector<std::string> parts;
  for (const Number& n : point) parts.push_back(figure_text(n));
  return fmt::format("({})", fmt::join(parts, ",\u00a0"));
}

std::string factor_words(const Wording& words, const FactorText& factor) {
  using Verb = FactorText::Kind;
  const std::string by =
      factor.amount.size() == 1 ? figure_text(factor.amount[0]) : figure_text(factor.amount);
  std::string text;
  constexpr std::string_view keys[] = {"transformation.translate", "transformation.scale",
                                       "transformation.rotate", "transformation.shear"};
  if (factor.kind != Verb::reflect)
    text = words.say(keys[static_cast<std::size_t>(factor.kind)], arg("by", by));
  if (factor.kind == Verb::reflect && factor.mirror != Mirror::line) {
    constexpr std::string_view names[] = {"x", "y", "origin", "diagonal"};
    text =
        words.say(fmt::format("transformation.reflect.{}", names[static_cast<std::size_t>(factor.mirror)]));
  }
  if (factor.kind == Verb::reflect && factor.mirror == Mirror::line) {
    text = words.say("transformation.reflect.line", arg("a", figure_text(factor.line[0])),
                     arg("b", figure_text(factor.line[1])));
  }
  if (!factor.axis.empty()) {
    const std::string axis = text_of(factor.axis);
    const std::string name = axis == "1,0,0"   ? words.symbol("x")
                             : axis == "0,1,0" ? words.symbol("y")
                             : axis == "0,0,1" ? words.symbol("z")
                                               : figure_text(factor.axis);
    text = words.say("transformation.round", arg("factor", text), arg("axis", name));
    if (!factor.pivot.empty())
      return words.say("transformation.through", arg("factor", text),
                       arg("pivot", figure_text(factor.pivot)));
  }
  if (factor.pivot.empty()) return text;
  return words.say("transformation.about", arg("factor", text), arg("pivot", figure_text(factor.pivot)));
}

std::string factors_words(const Wording& words, const std::vector<FactorText>& factors) {
  std::vector<std::string> all;
  for (const FactorText& factor : factors) all.push_back(factor_words(words, factor));
  return fmt::format("{}", fmt::join(all, "; "));
}

std::string factor_name(const Wording& words, std::size_t factor) {
  return fmt::format("{}{}", words.symbol("M"), factor + 1);
}

std::string product_name(const Wording& words, std::size_t factors) {
  if (factors == 0) return words.symbol("M");
  std::vector<std::string> names;
  for (std::size_t k = factors; k-- > 0;) names.push_back(factor_name(words, k));
  return chained(words, std::move(names));
}

std::string chained(const Wording& words, std::vector<std::string> names) {
  if (words.notation().rows) std::ranges::reverse(names);
  if (names.size() <= 4) return fmt::format("{}", fmt::join(names, "·"));
  return fmt::format("{}·{}·…·{}", names[0], names[1], names.back());
}

std::string sum_text(const std::vector<double>& factors, const std::vector<double>& values) {
  std::string sum;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    sum += i == 0 ? figure_real(factors[i]) : " + " + figure_factor(factors[i]);
    if (i < values.size()) sum += "·" + figure_factor(values[i]);
  }
  return sum;
}

std::vector<FactorText> split_at_pivots(const std::vector<FactorText>& factors) {
  std::vector<FactorText> split;
  for (const FactorText& factor : factors) {
    if (factor.pivot.empty()) {
      split.push_back(factor);
      continue;
    }
    FactorText middle = factor;
    middle.pivot.clear();
    split.push_back({.kind = FactorText::Kind::translate, .amount = negated(factor.pivot)});
    split.push_back(middle);
    split.push_back({.kind = FactorText::Kind::translate, .amount = factor.pivot});
  }
  return split;
}

}  // namespace gradus
