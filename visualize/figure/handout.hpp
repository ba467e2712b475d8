#pragma once
// Pages for print: several steps on one sheet of paper, each with its caption beneath it.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "figure/figure.hpp"
#include "figure/sheet.hpp"

namespace gradus {

/// A sheet of paper, upright; CSS pixels, 96 per inch.
struct Paper {
  std::string_view name;
  double width, height;
};
/// a4 and letter.
std::span<const Paper> papers();
/// The paper of that name, or nullptr.
const Paper* find_paper(std::string_view name);

/// How many figures stand side by side and below one another: "2x3" is two columns of three.
struct PageGrid {
  int columns = 2, rows = 3;
  static constexpr int most_columns = 4, most_rows = 6;
  std::size_t figures() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

struct Handout {
  Paper paper = papers().front();
  PageGrid grid;
  Look look;           ///< its slots, view, y_up and title; the size is the page's
  std::string source;  ///< where the figures come from, for the page's foot: the command or the input
  /// What stands in a figure's place.
  std::function<Sheet(const Figure&, const Look&)> draw = lay_out;
};

/// Pages that so many figures fill; at least 1.
std::size_t handout_page_count(const Handout& handout, std::size_t figures);

/// Page `page`, counted from 0, of `figures` figures in all, row by row. figure(i) is asked for when its turn
/// comes and must live until the next is asked for. Nothing is smaller than 7 pt. In a box that is too small
/// for all slots the listing is left out, then the table; title and footer stand once per page, the sentence
/// beneath its figure. Throws ContractViolation for a grid of none or more than 4 x 6 figures, and as
/// lay_out does.
Sheet handout_page(const Handout& handout, std::size_t page, std::size_t figures,
                   const std::function<Figure(std::size_t)>& figure);

}  // namespace gradus
