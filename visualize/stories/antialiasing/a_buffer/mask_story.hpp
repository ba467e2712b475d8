#pragma once
// The story of a triangle's mask, edge by edge.

#include <bit>
#include <optional>
#include <utility>

#include "antialiasing/a_buffer/a_buffer.hpp"
#include "stories/antialiasing/a_buffer/drawing.hpp"

namespace gradus::a_buffer {

/// The half-planes of one triangle.
class MaskStory {
 public:
  MaskStory(const Words& words, Piece piece) : words_(words), piece_(std::move(piece)) {}

  Mask mask() const { return left_; }
  StepNumber telling() const { return {telling_, 0}; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const { return {.text = "mask.started"}; }
  void show(Board& board, const HalfPlane& h) {
    edge_ = h.edge;
    inside_ = h.inside;
    left_ = h.left;
    ++number_;
    if (telling_ == 0 && h.inside != full) telling_ = number_;
    put(board);
  }
  Event say(const HalfPlane& h) const {
    return {.text = "mask.edge",
            .facts = {{"inside", hex_of(h.inside)}, {"left", hex_of(h.left)}},
            .words = {{"bits", std::popcount(h.left)}},
            .count = std::popcount(h.inside),
            .row = {number_, hex_of(h.inside), hex_of(h.left), std::popcount(h.left)},
            .key = figure_number(number_)};
  }
  void show(Board& board, const steps::Finished&) {
    edge_.reset();
    inside_ = left_;
    put(board);
  }
  Event say(const steps::Finished&) const {
    return {.text = "mask.finished",
            .facts = {{"mask", hex_of(left_)}},
            .words = {{"hex", hex_of(left_)}, {"area", area_of(left_)}},
            .count = std::popcount(left_)};
  }

 private:
  void put(Board& board) const {
    View view;
    LargePixel::add_grid(view);
    LargePixel::add_polygon(view, piece_, Role::input, true);
    if (edge_) {
      const auto at = [](ivec2 p) { return dvec2(p) / double{subpixels}; };
      const Extent unit{{0, 0}, {1, 1}};
      const dvec2 from = at(edge_->from), way = at(edge_->to) - from;
      const auto [first, last] = span_in(unit, from, way, -1e6, 1e6);
      if (first < last)
        view.add({"c edge", Role::current,
                  Stroke{LargePixel::at(from + first * way), LargePixel::at(from + last * way)}});
    }
    LargePixel::add_samples(view, full, Role::guide, true);
    LargePixel::add_samples(view, inside_ & ~left_, Role::candidate, true);
    LargePixel::add_samples(view, left_, Role::accepted, false);
    add_mask(view, "l edge", 21.5, inside_, Role::candidate, "edge_mask");
    add_mask(view, "m left", 12, left_, Role::accepted, "left_mask");
    board.milestone(std::move(view));
  }

  void add_mask(View& view, const std::string& id, double top, Mask mask, Role role,
                std::string_view title) const {
    const Pattern pattern{{21.5, top}, 1.4};
    view.add({id + " title", Role::guide,
              Text{{pattern.corner.x + pattern.width() / 2, top + 1.2}, words_.say(title)}});
    pattern.add_bits(view, id, mask, role);
    pattern.add_frame(view, id, role);
  }

  const Words& words_;
  Piece piece_;
  std::optional<Edge> edge_;
  Mask inside_ = full, left_ = full;
  int number_ = 0, telling_ = 0;
};

}  // namespace gradus::a_buffer
