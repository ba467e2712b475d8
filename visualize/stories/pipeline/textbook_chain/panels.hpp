#pragma once
// The paper of the tour: two panels beside each other, before and after a stage, and below them the stage's
// own numbers. Rows go down, as in pictures, and a unit of the paper is a pixel of the picture.

#include <algorithm>
#include <cmath>

#include "stages/points.hpp"
#include "stories/paper.hpp"

namespace gradus::textbook_chain {

/// The panel of what a stage is given, or of what it makes of it.
enum class Side { before, after };

class ChainPaper {
 public:
  /// In units: a thirty-sixth of the paper's width, about the height of a letter on a slide.
  static constexpr double panel_width = 17, panel_height = 14, after_left = 19, caption_height = 1.9,
                          card_gap = 0.8, card_height = 9;

  explicit ChainPaper(pipeline::Size picture)
      : picture_(picture.width, picture.height),
        unit_(std::max(picture.width / panel_width, picture.height / panel_height)),
        top_(static_cast<int>(std::ceil(caption_height * unit_))),
        after_(static_cast<int>(std::ceil(after_left * unit_))) {}

  double unit() const { return unit_; }
  /// How large a cell is asked for by the lines of a card, in units of a slide: smaller, they would lie on
  /// each other.
  double least_cell() const { return 16.5 / unit_; }
  /// With room for numbers that are longer than they usually are: the paper is cut to what is drawn.
  Window cells() const {
    constexpr double spare = 12;
    const double height = panel_height + card_gap + card_height + spare, width = panel_width + spare;
    return {{0, 0},
            {after_ + static_cast<int>(std::ceil(width * unit_)),
             top_ + static_cast<int>(std::ceil(height * unit_))}};
  }

  Extent panel(Side side) const {
    const dvec2 corner(left(side) - 0.5, top_ - 0.5);
    return {corner, corner + dvec2{panel_width, panel_height} * unit_};
  }
  /// A panel and what lies below it.
  Extent column(Side side) const {
    Extent place = panel(side);
    place.upper.y += (card_gap + card_height) * unit_;
    return place;
  }
  /// Where the numbers stand.
  Extent card() const {
    const Extent before = panel(Side::before);
    const dvec2 corner{before.lower.x, before.upper.y + card_gap * unit_};
    return {corner, {panel(Side::after).upper.x, corner.y + card_height * unit_}};
  }

  /// The cell of a pixel, in a picture in the middle of a panel.
  ivec2 cell(Side side, ivec2 pixel) const {
    const dvec2 room = dvec2{panel_width, panel_height} * unit_ - dvec2(picture_);
    return ivec2(left(side), top_) + ivec2(room * 0.5) + pixel;
  }
  /// A place in the picture, with pixel centres at integers.
  dvec2 in_picture(Side side, dvec2 place) const { return dvec2(cell(side, {0, 0})) + place; }
  Extent picture(Side side) const {
    return {in_picture(side, dvec2{-0.5}), in_picture(side, dvec2(picture_) - 0.5)};
  }

 private:
  int left(Side side) const { return side == Side::before ? 0 : after_; }

  ivec2 picture_;
  double unit_;
  int top_, after_;
};

}  // namespace gradus::textbook_chain
