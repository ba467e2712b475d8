#pragma once
// The stack or the queue of a fill, as a row of cells above the maze.

#include <deque>
#include <string>
#include <vector>

#include "stories/telling.hpp"

namespace gradus::flood_fill {

/// Each entry is a cell with a short text, behind the name of the whole where that has room. What leaves next
/// is at the left end of a queue, at the right end of a stack, and has its name below. Where there are more
/// entries than cells, those farthest from it are left out.
class Shelf {
 public:
  static constexpr int rows = 2;  ///< of the grid that it takes: the entries, and names

  Shelf() = default;  ///< is not drawn
  /// left: the cell of the first entry. columns: how many there is room for.
  Shelf(ivec2 left, int columns, bool queue, std::string title, std::string next)
      : left_(left), queue_(queue), title_(std::move(title)), next_(std::move(next)) {
    constexpr int of_title = 3, least = 6;
    if (columns < of_title + least) title_.clear();
    if (!title_.empty()) left_.x += of_title;
    cells_.resize(static_cast<std::size_t>(columns - (left_.x - left.x)));
  }
  /// What stands there before anything waits.
  void begin(Board& board) const {
    if (!title_.empty())
      board.keep("shelf title", Role::candidate, Text{dvec2(left_) - dvec2{0.7, 0}, title_, Align::right});
  }

  void push(Board& board, std::string entry) {
    if (!drawn()) return;
    entries_.push_back(std::move(entry));
    draw(board);
  }
  void take(Board& board) {
    if (!drawn()) return;
    queue_ ? entries_.pop_front() : entries_.pop_back();
    draw(board);
  }

 private:
  /// Changes in the drawing what has changed.
  void draw(Board& board) {
    const std::vector<std::string> now = texts();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const ivec2 cell = left_ + ivec2{static_cast<int>(i), 0};
      if (now[i] == cells_[i]) continue;
      now[i].empty() ? board.bare(cell) : board.put(cell, Role::candidate, now[i]);
    }
    name_next(board);
    cells_ = now;
  }
  bool drawn() const { return !cells_.empty(); }
  /// Of each cell; empty where there is no entry.
  std::vector<std::string> texts() const {
    std::vector<std::string> out(entries_.begin(), entries_.end());
    if (out.size() > cells_.size()) {
      const auto surplus = static_cast<std::ptrdiff_t>(out.size() - cells_.size());
      queue_ ? out.erase(out.end() - surplus, out.end()) : out.erase(out.begin(), out.begin() + surplus);
      (queue_ ? out.back() : out.front()) = "…";
    }
    out.resize(cells_.size());
    return out;
  }
  void name_next(Board& board) const {
    if (entries_.empty()) return board.remove("next out");
    const std::size_t place = queue_ ? 0 : std::min(entries_.size(), cells_.size()) - 1;
    board.keep("next out", Role::candidate, Text{dvec2(left_) + dvec2{place, 1}, next_});
  }

  ivec2 left_{};
  std::vector<std::string> cells_;  ///< as they are drawn
  bool queue_ = false;
  std::string title_, next_;
  std::deque<std::string> entries_;
};

}  // namespace gradus::flood_fill
