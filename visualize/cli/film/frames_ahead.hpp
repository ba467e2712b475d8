#pragma once
// The frames of a film, asked for one after the other and drawn several at a time.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "cli/system/threads.hpp"

namespace gradus::cli {

/// Draws frames in blocks, as many at once as there are threads, and keeps but one block: a film may be
/// longer than memory.
template <class Frame>
class FramesAhead {
 public:
  /// draw(i): frame i, from any thread.
  FramesAhead(std::size_t count, std::size_t threads, std::function<Frame(std::size_t)> draw)
      : count_(count), threads_(threads), draw_(std::move(draw)) {}

  /// Frame i < count. Asked for in order, each is drawn once; what draw() throws passes through.
  const Frame& at(std::size_t i) {
    if (i < first_ || first_ + block_.size() <= i) draw_from(i);
    return block_[i - first_];
  }

 private:
  void draw_from(std::size_t first) {
    // Longer than there are threads: none waits long for the slowest of the block
    first_ = first;
    block_.assign(std::min(count_ - first, 4 * threads_), Frame());
    in_parallel(block_.size(), threads_, [&](std::size_t k) { block_[k] = draw_(first + k); });
  }

  std::size_t count_, threads_;
  std::function<Frame(std::size_t)> draw_;
  std::size_t first_ = 0;
  std::vector<Frame> block_{};
};

}  // namespace gradus::cli
