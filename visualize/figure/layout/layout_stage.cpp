// How much of the grid or the paper a drawing shows, at which size, and where.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::layout {
namespace {

constexpr double followed_cell = 30;
constexpr double axis_below = 28, axis_above = 22, axis_rim = 4;
constexpr double roomy_cell = 44;  ///< from here on the name of the columns stands below the last one
constexpr double easy_pixel = 6;   ///< of a picture on a paper with lines
constexpr double paper_rim = 2;    ///< of a line's width at the border of a paper
constexpr double inset_height = 104, inset_gap = 8;         ///< of an overview above the view
constexpr double inset_width = 190, inset_column_gap = 16;  ///< of one beside it

/// Where the name of the rows stands: above their numbers, over the last one of them, or left of all.
enum class RowName { above, among, aside };

Margins axis_margins(const Stage& stage, double cell, RowName name = RowName::above) {
  // The name of the columns stands behind the last number, which stands in the middle of its cell or at its
  // end
  const double least = cell < roomy_cell || stage.axes->on_lines ? 0 : roomy_cell;
  const double x_name = text_width(stage.axes->x_name, Face::italic, text_size) + 10 +
                        (std::min(stage.column_numbers, roomy_cell) - least) / 2;
  const double y_name = text_width(stage.axes->y_name + " ↑", Face::italic, text_size);
  const double numbers = std::max({stage.numbers, 14.0, name == RowName::among ? y_name : 0.0}) +
                         (name == RowName::aside ? y_name + name_gap : 0);
  const bool low = cell < roomy_cell;  // so that the upper number reaches out
  const double above = name == RowName::above          ? axis_above
                       : name == RowName::aside && low ? name_gap
                                                       : axis_rim;
  const double gap = stage.axes->on_lines ? std::max(8.0, 2 + stage.column_numbers / 2) : 8;
  return {numbers + 2 + gap, std::max(least > 0 ? 8.0 : 24.0, x_name), above, axis_below};
}

/// What one side needs for its texts: each reaches so far out, less its distance from the border in units of
/// the paper. Only those are kept that no other needs more room than at every size of a unit.
class SideTexts {
 public:
  void add(double reach, double units) {
    const auto needs_less = [&](const Text& t) { return t.reach <= reach && t.units >= units; };
    const auto needs_more = [&](const Text& t) { return t.reach >= reach && t.units <= units; };
    if (std::ranges::any_of(texts_, needs_more)) return;
    std::erase_if(texts_, needs_less);
    texts_.push_back({reach, units});
  }
  /// When a unit is this large.
  double margin(double cell) const {
    double margin = paper_rim;
    for (const Text& text : texts_) margin = std::max(margin, text.reach - text.units * cell);
    return margin;
  }

 private:
  struct Text {
    double reach, units;
  };
  std::vector<Text> texts_;
};

/// What texts need beyond the shown part of a paper.
class TextMargins {
 public:
  explicit TextMargins(const Stage& stage) {
    const dvec2 upper = stage.lower + stage.size;
    for (const Content::TextRoom& text : stage.content->texts) {
      const dvec2 from_lower = text.at - stage.lower, to_upper = upper - text.at;
      left_.add(text.left, from_lower.x);
      right_.add(text.right, to_upper.x);
      above_.add(text.up, stage.y_up ? to_upper.y : from_lower.y);
      below_.add(text.down, stage.y_up ? from_lower.y : to_upper.y);
    }
  }
  Margins operator()(double cell) const {
    return {left_.margin(cell), right_.margin(cell), above_.margin(cell), below_.margin(cell)};
  }

 private:
  SideTexts left_, right_, above_, below_;
};

double cell_between(const Stage& stage, const Margins& m, double width, double height) {
  return std::min({(width - m.left - m.right) / stage.size.x, (height - m.above - m.below) / stage.size.y,
                   stage.largest_cell});
}

/// The largest cell, with the room that is asked beside it.
struct Sized {
  double cell = 0;
  Margins margins{};
};

/// Whether the name of the rows may stand there; over the last number where that has its room.
bool may_stand(const Stage& stage, RowName name, double cell) {
  if (name == RowName::above) return true;
  return !stage.part && (name == RowName::aside || (cell >= high_cell && !stage.axes->on_lines));
}

Sized largest_of_grid(const Stage& stage, double width, double height) {
  Sized best;
  for (const RowName name : {RowName::above, RowName::among, RowName::aside}) {
    for (const double from : {roomy_cell, 0.0}) {
      const Margins margins = axis_margins(stage, from, name);
      const double cell = cell_between(stage, margins, width, height);
      if (cell < from || cell <= best.cell * 1.001) continue;
      if (may_stand(stage, name, cell)) best = {cell, margins};
    }
  }
  return best;
}

/// The smaller the unit, the more room is asked beside it.
Sized largest_of_paper(const Stage& stage, double width, double height) {
  const TextMargins margins(stage);
  double low = 0, high = cell_between(stage, {}, width, height);
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    const bool fits = middle <= cell_between(stage, margins(middle), width, height);
    (fits ? low : high) = middle;
  }
  return {low, margins(low)};
}

Sized largest_in(const Stage& stage, double width, double height) {
  if (stage.axes) return largest_of_grid(stage, width, height);
  if (stage.content) return largest_of_paper(stage, width, height);
  return {cell_between(stage, {}, width, height), {}};
}

/// Cells shown along one axis, following `focus` by jumps of half a view: the first one.
std::int64_t followed(std::int64_t lower, std::int64_t upper, std::int64_t count, std::int64_t focus) {
  if (upper - lower + 1 <= count) return lower;
  const std::int64_t half = std::max<std::int64_t>(count / 2, 1);
  const std::int64_t page = (focus - lower) / half;
  const std::int64_t first = lower + page * half - half / 2;
  return std::clamp(first, lower, upper - count + 1);
}

/// The cells of a view that follows the step.
Window followed_view(const Window& all, const Fit& shown, ivec2 focus) {
  const std::int64_t x = followed(all.lower.x, all.upper.x, shown.columns, focus.x);
  const std::int64_t y = followed(all.lower.y, all.upper.y, shown.rows, focus.y);
  return {{static_cast<int>(x), static_cast<int>(y)},
          {static_cast<int>(x + shown.columns - 1), static_cast<int>(y + shown.rows - 1)}};
}

/// Beside a narrow grid there must be room for labels; a wider one has room of its own.
Box with_room_for_labels(const Box& settled, const Box& slot, double s) {
  constexpr double enough = 420;
  const double missing = std::max(0.0, enough * s - settled.width);
  const double x = std::max(slot.x, settled.x - missing / 2);
  return {x, settled.y, std::min(slot.right(), settled.right() + missing / 2) - x, settled.height};
}

/// Cuts the stage to what is drawn on the paper, and a hair more: no rounding may cut off what ends there.
void cut_to(Stage& stage, const Content& content) {
  constexpr double hair = 1e-6;
  stage.content = &content;
  stage.lower = content.all.lower - hair;
  stage.size = glm::max(content.all.size(), dvec2{1}) + 2 * hair;
  const auto whole = [](dvec2 p, double up) {
    return ivec2{static_cast<int>(std::floor(p.x + up)), static_cast<int>(std::floor(p.y + up))};
  };
  stage.cells = intersection(stage.cells, {whole(stage.lower, 0.5), whole(stage.lower + stage.size, 0.5)});
}

/// As if all its digits were the widest: views with as many digits get the same room beside them.
double number_width(int n) {
  static const char widest = std::ranges::max(std::string_view("0123456789"), {}, [](char digit) {
    return text_width(std::string(1, digit), Face::sans, text_size);
  });
  std::string text = figure_number(n);
  std::ranges::replace_if(text, [](char c) { return c >= '0' && c <= '9'; }, widest);
  return text_width(text, Face::sans, text_size);
}

void show_cells(Stage& stage) {
  stage.lower = dvec2(stage.cells.lower) - 0.5;
  stage.size = {static_cast<double>(stage.cells.width()), static_cast<double>(stage.cells.height())};
}

}  // namespace

Stage stage_of(const Trace& trace, const Look& look) {
  const Grid& grid = trace.grid;
  Stage stage{grid.cells, grid.own(), look.view.has_value(), look.y_up.value_or(grid.y_up)};
  if (look.view) stage.cells = intersection(*look.view, grid.cells);
  if (look.view && stage.cells.empty()) {
    const Window &all = grid.cells, &view = *look.view;
    contract_violated(fmt::format("expected cells of the grid {},{} to {},{}, found {},{} to {},{}",
                                  all.lower.x, all.lower.y, all.upper.x, all.upper.y, view.lower.x,
                                  view.lower.y, view.upper.x, view.upper.y));
  }
  show_cells(stage);
  const Content& content = trace.content;
  if (!grid.axes && !look.view && !content.all.empty()) cut_to(stage, content);
  stage.core = content.core.empty() ? stage.size : glm::min(content.core.size(), stage.size);
  if (grid.axes) {
    stage.axes = &grid;
    stage.numbers = std::max(number_width(stage.cells.lower.y), number_width(stage.cells.upper.y));
    stage.column_numbers = std::max(number_width(stage.cells.lower.x), number_width(stage.cells.upper.x));
  }
  const bool slide = look.layout == Layout::slide;
  if (slide && !look.view) stage.part = grid.part;
  // The pixels of a picture may be as small as they are asked for
  const bool pixels = look.view && grid.picture;
  // The units of a paper are no cells; two pictures and all texts leave little of a square slide
  const double least_whole = grid.axes ? 6 : grid.lines > 0 ? std::min(1.5, grid.lines) : 3;
  stage.least_cell = pixels ? 0.2 : grid.whole ? least_whole : slide ? least_cell : 16;
  // In print it is the real size of a cell that counts: 3 mm
  const double printed = look.least_text > 0 && grid.axes ? 11 / unit_of(look) : 0;
  // Pixels too fine to be looked at one by one are no reason to give up text
  stage.easy_cell = std::max({stage.least_cell, printed, grid.lines > 1 ? easy_pixel : 0});
  stage.lines = grid.lines;
  stage.largest_cell = slide ? 96 : 120;
  return stage;
}

Stage bare(Stage stage, Content& content) {
  constexpr double wide_enough = 60;  // units
  expects(stage.content, "only a paper has something aside");
  content = *stage.content;
  content.all = content.bare;
  content.core.lower = glm::max(content.core.lower, content.bare.lower);
  content.core.upper = glm::min(content.core.upper, content.bare.upper);
  std::erase_if(content.texts, [](const Content::TextRoom& text) { return text.aside; });
  cut_to(stage, content);
  stage.core = glm::min(content.core.size(), stage.size);
  stage.bare = true;
  stage.lines = 0;
  // A paper of fine cells is not refused for their size
  stage.least_cell = std::min(stage.least_cell, wide_enough / std::max(stage.size.x, 1.0));
  return stage;
}

namespace {

/// The stage's part with an overview above or beside it, or, where cells would be small, alone.
std::optional<Fit> fit_of_part(Stage stage, double width, double height) {
  const Window& part = *stage.part;
  stage.size = {static_cast<double>(part.width()), static_cast<double>(part.height())};
  Fit best;
  const auto add = [&](double across, double up, bool follows, bool beside) {
    const auto [cell, margins] = largest_in(stage, width - across, height - up);
    if (cell > best.cell) best = {cell, part.width(), part.height(), follows, beside, margins, true};
  };
  add(0, inset_height + inset_gap, true, false);
  add(inset_width + inset_column_gap, 0, true, true);
  if (best.cell < followed_cell) add(0, 0, false, false);
  return best.cell < stage.easy_cell ? std::nullopt : std::optional(best);
}

/// A picture is looked at itself: its overview is as wide as the view beside it.
bool shows_picture(const Stage& stage) { return stage.axes && stage.axes->picture; }
double inset_width_of(const Stage& stage, double width) {
  return shows_picture(stage) ? std::max(inset_width, (width - inset_column_gap) / 2) : inset_width;
}

}  // namespace

std::optional<Fit> fit(const Stage& stage, double width, double height) {
  if (stage.part) {
    if (const auto part = fit_of_part(stage, width, height)) return part;
  }
  if (const Sized sized = largest_in(stage, width, height); sized.cell >= stage.least_cell)
    return Fit{sized.cell, stage.cells.width(), stage.cells.height(), false, false, sized.margins};
  if (stage.fixed || stage.content) return std::nullopt;
  const Margins margins = stage.axes ? axis_margins(stage, followed_cell) : Margins{};
  const double across = width - margins.left - margins.right, up = height - margins.above - margins.below;
  const auto count = [](double room, std::int64_t all) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(room / followed_cell), 0, all);
  };
  const Fit above{followed_cell,
                  count(across, stage.own.width()),
                  count(up - inset_height - inset_gap, stage.own.height()),
                  true,
                  false,
                  margins};
  const Fit beside{followed_cell,
                   count(across - inset_width_of(stage, width) - inset_column_gap, stage.own.width()),
                   count(up, stage.own.height()),
                   true,
                   true,
                   margins};
  const auto cells = [](const Fit& f) { return static_cast<double>(f.columns * f.rows); };
  const double worth = shows_picture(stage) ? 0.3 : 1.25;
  const Fit& better = cells(beside) > worth * cells(above) ? beside : above;
  return cells(better) > 0 ? std::optional(better) : std::nullopt;
}

Fit capacity(const Stage& stage, double width, double height) {
  const Margins margins = stage.axes ? axis_margins(stage, stage.least_cell) : Margins{};
  const auto count = [&stage](double room) {
    return static_cast<std::int64_t>(std::max(0.0, std::floor(room / stage.least_cell + 1e-9)));
  };
  return {stage.least_cell, count(width - margins.left - margins.right),
          count(height - margins.below - margins.above)};
}

Scene scene_of(const Figure& figure, const Look& look, const Stage& stage, const Box& slot, double s) {
  const std::optional<Fit> shown = fit(stage, slot.width / s, slot.height / s);
  Scene scene;
  scene.bare = stage.bare;
  scene.numbered = stage.axes != nullptr;
  if (!shown) return scene;
  const Margins& margins = shown->margins;
  scene.follows = shown->follows;
  scene.beside = shown->beside;
  Box box = slot;
  if (scene.beside) {
    const double inset = inset_width_of(stage, slot.width / s) * s;
    box.width -= inset + inset_column_gap * s;
    scene.inset = {slot.right() - inset, slot.y + margins.above * s, inset,
                   slot.height - (margins.above + margins.below) * s};
  } else if (scene.follows) {
    scene.inset = {box.x, box.y + 4 * s, box.width, inset_height * s};
    box = {box.x, box.y + (inset_height + inset_gap) * s, box.width,
           box.height - (inset_height + inset_gap) * s};
  }
  // What is shown with its axes, in the middle of what is left
  const double cell = shown->cell * s;
  const dvec2 size = shown->follows || shown->part
                         ? dvec2{static_cast<double>(shown->columns), static_cast<double>(shown->rows)} * cell
                         : stage.size * cell;
  const double width = size.x + (margins.left + margins.right) * s;
  const double height = size.y + (margins.above + margins.below) * s;
  scene.settled = {box.x + (box.width - width) / 2, box.y + (box.height - height) / 2, width, height};
  scene.left = scene.settled.x;
  scene.right = scene.settled.right();
  const Window view = shown->part     ? *stage.part
                      : scene.follows ? followed_view(stage.own, *shown, figure.focus)
                                      : stage.cells;
  scene.frame = {view,
                 scene.follows || shown->part ? dvec2(view.lower) - 0.5 : stage.lower,
                 {scene.settled.x + margins.left * s, scene.settled.y + margins.above * s, size.x, size.y},
                 cell,
                 stage.y_up};
  scene.labels = look.crop ? with_room_for_labels(scene.settled, box, s) : box;
  if (look.crop) scene.settled = scene.labels;
  if (scene.follows) scene.settled = around(scene.settled, scene.inset);
  return scene;
}

}  // namespace gradus::layout
