#pragma once
// The stack or the queue of a fill, as a row of boxes above the maze.

#include <deque>
#include <string>
#include <vector>

#include "stories/telling.hpp"

namespace gradus::flood_fill {

/// Each entry is a box with a short text, wide enough that no two texts touch. What leaves next is at the
/// left end of a queue, at the right end of a stack, and has its name below. Where there are more entries
/// than boxes, those farthest from it are left out.
class Shelf {
 public:
  static constexpr int rows = 2;  ///< of the grid that it takes: the entries, and the name

  Shelf() = default;  ///< is not drawn
  /// left: the cell of the first entry. columns: how many there is room for. characters: of the longest
  /// entry.
  Shelf(ivec2 left, int columns, std::size_t characters, bool queue, std::string next)
      : left_(left),
        width_(characters <= 2 ? 1 : 0.5 * static_cast<double>(characters)),
        columns_(columns),
        boxes_(static_cast<std::size_t>(columns / width_)),
        queue_(queue),
        next_(std::move(next)) {}

  void push(Board& board, std::string entry) {
    if (boxes_.empty()) return;
    entries_.push_back(std::move(entry));
    draw(board);
  }
  void take(Board& board) {
    if (boxes_.empty()) return;
    queue_ ? entries_.pop_front() : entries_.pop_back();
    draw(board);
  }

 private:
  /// Changes in the drawing what has changed.
  void draw(Board& board) {
    const std::vector<std::string> now = texts();
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] == boxes_[i]) continue;
      const std::string box = fmt::format("shelf {:02}", i), text = box + " text";
      if (now[i].empty()) {
        board.remove(box);
        board.remove(text);
        continue;
      }
      const dvec2 from = dvec2(left_) + dvec2{static_cast<double>(i) * width_ - 0.4, -0.46},
                  to = from + dvec2{width_ - 0.2, 0.92};
      if (boxes_[i].empty())
        board.keep(box, Role::candidate, Path{{from, {to.x, from.y}, to, {from.x, to.y}}, true});
      board.keep(text, Role::candidate, Text{0.5 * (from + to), now[i]});
    }
    name_next(board);
    boxes_ = now;
  }
  /// Of each box; empty where there is no entry.
  std::vector<std::string> texts() const {
    std::vector<std::string> out(entries_.begin(), entries_.end());
    if (out.size() > boxes_.size()) {
      const auto surplus = static_cast<std::ptrdiff_t>(out.size() - boxes_.size());
      queue_ ? out.erase(out.end() - surplus, out.end()) : out.erase(out.begin(), out.begin() + surplus);
      (queue_ ? out.back() : out.front()) = "…";
    }
    out.resize(boxes_.size());
    return out;
  }
  /// Towards the middle of the row, where there is most room.
  void name_next(Board& board) const {
    if (entries_.empty()) return board.remove("next out");
    const std::size_t place = queue_ ? 0 : std::min(entries_.size(), boxes_.size()) - 1;
    const double from = static_cast<double>(place) * width_ - 0.4, to = from + width_ - 0.2;
    const bool to_the_left = from + to > columns_ - 1;
    board.keep("next out", Role::candidate,
               Text{dvec2(left_) + dvec2{to_the_left ? to : from, 1}, next_,
                    to_the_left ? Align::right : Align::left});
  }

  ivec2 left_{};
  double width_ = 1;  ///< of a box, in cells
  int columns_ = 0;
  std::vector<std::string> boxes_;  ///< their texts, as they are drawn
  bool queue_ = false;
  std::string next_;
  std::deque<std::string> entries_;
};

}  // namespace gradus::flood_fill
