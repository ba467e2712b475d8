// The numbers and names beside a grid's cells.

#include <algorithm>

#include "figure/layout/layout.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::layout {
namespace {

/// Distance between labelled integers: 1, 2, 5, 10 … cells, so that the labels keep apart.
std::int64_t tick_step(double cell, double needed) {
  std::int64_t step = 1;
  for (int i = 0; static_cast<double>(step) * cell < needed; ++i) step = i % 3 == 1 ? step / 2 * 5 : step * 2;
  return step;
}

/// The first multiple of `step` that is not below `lower`.
std::int64_t first_tick(std::int64_t lower, std::int64_t step) {
  const std::int64_t rest = ((lower % step) + step) % step;
  return rest == 0 ? lower : lower + step - rest;
}

class AxesLayout {
 public:
  AxesLayout(Pen& pen, const Grid& grid, const Scene& scene, Obstacles& taken)
      : pen_(pen), grid_(grid), s_(pen.scale()), at_(scene), frame_(scene.frame), free_(taken) {}

  void tick(std::string id, dvec2 baseline, std::string text, Align align) {
    TextShape shape{baseline, std::move(text), Face::sans, text_size * s_, align, Paint::of(Tone::muted)};
    free_.texts.push_back(shape.box());
    free_.ticks.push_back(grown(shape.box(), 8 * s_));
    pen_.text(std::move(id), std::move(shape));
  }

  void name_axis(std::string id, dvec2 baseline, const std::string& name) {
    TextShape shape{baseline, name, Face::italic, text_size * s_, Align::left, Paint::of(Tone::muted)};
    free_.texts.push_back(shape.box());
    pen_.text(std::move(id), std::move(shape));
  }

  void draw() {
    const Box& b = frame_.box;
    const Window& view = frame_.view;
    const double size = text_size * s_, below = b.bottom() + 23 * s_;
    const double widest = std::max(text_width(figure_number(view.lower.x), Face::sans, size),
                                   text_width(figure_number(view.upper.x), Face::sans, size));
    const std::int64_t across = tick_step(frame_.cell, widest + 10 * s_);
    // The axis' name stands behind the last label, inside the slot
    const double name_width = text_width(grid_.x_name, Face::italic, size);
    const double most_right = at_.right - name_width - 8 * s_;
    double last_right = b.x;
    const int on_lines = grid_.on_lines;  // then one more than there are cells
    const double off = on_lines / 2.0;
    for (std::int64_t x = first_tick(view.lower.x, across); x <= view.upper.x + on_lines; x += across) {
      const std::string text = figure_number(x);
      const double half = text_width(text, Face::sans, size) / 2;
      const double at = frame_.column(static_cast<double>(x) - off);
      if (at + half > most_right) break;
      tick("x " + text, {at, below}, text, Align::centre);
      last_right = free_.texts.back().right();
    }
    const std::vector<Box> columns(free_.texts);  // whose first number is near the corner
    const double row_name_bottom = name_rows();
    // On lines one of the columns' numbers stands below the corner
    const double gap = std::max(8 * s_, on_lines * (2 * s_ + widest / 2));
    const std::int64_t up = tick_step(frame_.cell, 24 * s_);
    for (std::int64_t y = first_tick(at_.own_cells(grid_).lower.y, up); y <= view.upper.y + on_lines;
         y += up) {
      const std::string text = figure_number(y);
      const double baseline = frame_.row(static_cast<double>(y) - off) + 7 * s_;
      const TextShape shape{{b.x - gap, baseline}, text, Face::sans, size, Align::right,
                            Paint::of(Tone::muted)};
      const bool in_the_corner =
          std::ranges::any_of(columns, [&](const Box& other) { return overlap(shape.box(), other); });
      if (baseline - 0.8 * size > row_name_bottom && !in_the_corner)
        tick("y " + text, {b.x - gap, baseline}, text, Align::right);
    }
    const double x_name = std::min(b.right() + 6 * s_, at_.right - name_width);
    name_axis("x axis", {std::max(x_name, last_right + 8 * s_), below}, grid_.x_name);
  }

  /// The arrow behind the name of the rows says where they grow; columns always grow to the right. Returns
  /// how far down the name reaches.
  double name_rows() {
    const Box& b = frame_.box;
    const double size = text_size * s_;
    const std::string name = grid_.y_name + (frame_.y_up ? " ↑" : " ↓");
    constexpr double low_cell = 24;  // units: whose number reaches up to the name
    const bool above = b.y - at_.settled.y >= size || at_.follows;
    if (!above &&
        (grid_.on_lines || frame_.cell < high_cell * s_)) {  // left of all numbers, beside the upper one
      const double shelf =
          frame_.y_up ? 0 : (at_.own_cells(grid_).lower.y - frame_.view.lower.y) * frame_.cell;
      name_axis("y axis", {at_.left, b.y + shelf + (grid_.on_lines ? 0 : frame_.cell / 2) + 7 * s_}, name);
      return at_.settled.y - size;
    }
    if (above && (grid_.on_lines || frame_.cell < low_cell * s_)) {  // right of the first number, not over it
      name_axis("y axis", {b.x, b.y - 6 * s_}, name);
      return at_.settled.y - size;
    }
    if (!above) {  // among the numbers
      const double left = b.x - 8 * s_ - text_width(name, Face::italic, size);
      name_axis("y axis", {left, b.y + 13 * s_}, name);
    } else {
      // A long name may stand over the grid's corner, but not in the margin
      const double y_name = text_width(grid_.y_name, Face::italic, size);
      name_axis("y axis", {std::max(b.x - 8 * s_ - y_name, at_.left), b.y - 5 * s_}, name);
    }
    return free_.texts.back().bottom();
  }

 private:
  Pen& pen_;
  const Grid& grid_;
  double s_;
  const Scene& at_;
  const Frame& frame_;
  Obstacles& free_;
};

}  // namespace

void lay_out_axes(Pen& pen, const Grid& grid, const Scene& scene, Obstacles& taken) {
  AxesLayout(pen, grid, scene, taken).draw();
}

}  // namespace gradus::layout
