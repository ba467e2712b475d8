#pragma once
// What shapes come down to, for every format alike.

#include <optional>
#include <utility>
#include <vector>

#include "figure/sheet.hpp"
#include "figure/text/metrics.hpp"
#include "theme/theme.hpp"

namespace gradus {

/// The shape as a theme shows it: one that hatches has its own hatchings, and frames round what is current.
RectShape shown_in(const Theme& theme, RectShape rect, double unit);
AreaShape shown_in(const Theme& theme, AreaShape area);

/// The hatching as diagonals cut to the box by hand: no clip path, so vector files stay small.
std::vector<Segment<2, double>> hatch_lines(const RectShape& rect, double unit);
/// The same, cut to the inside of the rings.
std::vector<Segment<2, double>> hatch_lines(const AreaShape& area, double unit);
double hatch_width(double unit);

/// The tip and the two barbs of a line's arrow; nothing for a line without one.
struct ArrowHead {
  dvec2 tip, left, right;
};
std::optional<ArrowHead> arrow_head(const LineShape& line, double unit);

/// The rim of a text with a halo: half of it lies inside the letters.
double halo_width(const TextShape& text);

/// The line below a quantity in a theme that tells quantities apart so.
struct Underline {
  Segment<2, double> segment;
  double width;
  bool dashed;
};
std::optional<Underline> underline(const TextPiece& piece, const TextShape& text, const Theme& theme);

/// Strokes and gaps of a dashed line of this width.
std::pair<double, double> dashes(double width);

/// The cells in a theme's colours: those with a role in that role's mark.
Image pixels_of(const ImageShape& shape, const Theme& theme);

}  // namespace gradus
