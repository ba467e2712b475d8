#pragma once
// The paper of the tour: one panel with the stage's own drawing, the stage's numbers beside it, and above
// both the stages with the one that is told. Rows go down, as in pictures. Cells are fine: a pixel of the
// picture is a block of them, so that a solid is drawn in them, too.

#include <algorithm>
#include <cmath>

#include "stages/points.hpp"
#include "stories/paper.hpp"

namespace gradus::textbook_chain {

class ChainPaper {
 public:
  /// In units: about the height of a letter on a slide.
  static constexpr double panel_left = 0.7, panel_width = 22, panel_height = 15.4, card_left = 23.4,
                          card_width = 17, strip_height = 1.9, caption_height = 1.8;

  explicit ChainPaper(pipeline::Size picture)
      : picture_(picture.width, picture.height),
        block_(std::max(1, static_cast<int>(finest / pixels_across(picture)))),
        unit_(pixels_across(picture) * block_ / panel_width),
        top_(static_cast<int>(std::ceil((strip_height + caption_height) * unit_))) {}

  double unit() const { return unit_; }
  /// How large a cell is asked for by the lines of a card, in units of a slide: smaller, they would lie on
  /// each other.
  double least_cell() const { return 16.5 / unit_; }
  /// With room for numbers that are longer than they usually are: the paper is cut to what is drawn.
  Window cells() const {
    constexpr double spare = 8;
    const dvec2 size = dvec2{card_left + card_width + spare, panel_height + spare} * unit_;
    return {{0, 0}, ivec2(glm::ceil(size)) + ivec2{0, top_}};
  }

  Extent panel() const {
    const dvec2 corner = dvec2{panel_left * unit_, top_} - 0.5;
    return {corner, corner + dvec2{panel_width, panel_height} * unit_};
  }
  /// Where the numbers stand, from the height of the panel's caption on.
  Extent card() const {
    const Extent drawing = panel();
    const dvec2 corner{card_left * unit_ - 0.5, drawing.lower.y - caption_height * unit_};
    return {corner, {corner.x + card_width * unit_, drawing.upper.y}};
  }

  /// How many cells a pixel of the picture has in each direction.
  int block() const { return block_; }
  /// The first of a pixel's cells, in the picture in the middle of the panel.
  ivec2 cell(ivec2 pixel) const {
    const dvec2 room = dvec2{panel_width, panel_height} * unit_ - dvec2(picture_ * block_);
    return ivec2(dvec2{panel_left * unit_, top_} + room * 0.5 + 1e-6) + pixel * block_;
  }
  /// A place in the picture, with pixel centres at integers.
  dvec2 in_picture(dvec2 place) const { return dvec2(cell({0, 0})) - 0.5 + (place + 0.5) * double(block_); }
  Extent picture() const { return {in_picture(dvec2{-0.5}), in_picture(dvec2(picture_) - 0.5)}; }

 private:
  /// Cells across a panel: more would be too fine for eight panels on a slide.
  static constexpr double finest = 100;

  /// Across a panel that holds the picture.
  static double pixels_across(pipeline::Size picture) {
    return std::max<double>(picture.width, picture.height * panel_width / panel_height);
  }

  ivec2 picture_;
  int block_;
  double unit_;
  int top_;
};

}  // namespace gradus::textbook_chain
