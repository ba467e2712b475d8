#pragma once
// The parts of laying out a figure that its files share. Sizes are for 720 lines and scale with the height.

#include <vector>

#include "figure/figure.hpp"
#include "figure/metrics.hpp"
#include "figure/sheet.hpp"

namespace gradus::layout {

inline constexpr double text_size = 20;      ///< 1/36 of the height: nothing is smaller
inline constexpr double sentence_size = 26;  ///< 1/28 and a little
inline constexpr double least_cell = 24;     ///< a cell is never smaller

/// Collects shapes of one slot; knows the scale.
class Pen {
 public:
  Pen(Sheet& sheet, Slot slot, double scale) : sheet_(sheet), slot_(slot), scale_(scale) {}

  void rect(std::string id, RectShape shape) { add(std::move(id), std::move(shape)); }
  void line(std::string id, LineShape shape) { add(std::move(id), std::move(shape)); }
  void strokes(std::string id, StrokesShape shape) { add(std::move(id), std::move(shape)); }
  void disc(std::string id, DiscShape shape) { add(std::move(id), std::move(shape)); }
  void text(std::string id, TextShape shape) { add(std::move(id), std::move(shape)); }
  void image(std::string id, ImageShape shape) { add(std::move(id), std::move(shape)); }
  double scale() const { return scale_; }

 private:
  template <class S>
  void add(std::string id, S shape) {
    sheet_.shapes.push_back({slot_, std::move(id), std::move(shape)});
  }

  Sheet& sheet_;
  Slot slot_;
  double scale_;
};

/// A cell's look, `box` being the cell; in the drawing and, small, in the legend. The outline comes apart,
/// since it is drawn over the grid lines.
void draw_cell_ground(Pen& pen, const std::string& id, Role role, const Box& box);
void draw_cell_outline(Pen& pen, const std::string& id, Role role, const Box& box);

/// The drawing slot.
void lay_out_drawing(Pen& pen, const Figure& figure, const Box& box);

/// The cells of the grid that a drawing of this size shows, following the figure's focus.
Window visible_cells(const Figure& figure, const Box& box, double scale);

}  // namespace gradus::layout
