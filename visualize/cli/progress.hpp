#pragma once
// How far a long command is: a bar on a terminal, one plain line per finished item elsewhere, nothing with
// -q.

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace gradus::cli {

/// May be told of finished items from any thread and in any order; lines come out in the order of the items.
class Progress {
 public:
  Progress(std::size_t items, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Item `index` is done: `line` says what was made; empty says nothing, but counts.
  void finished(std::size_t index, const std::string& line);
  /// A line that is not about one item, above the bar.
  void say(const std::string& line);

 private:
  enum class Style { none, bar, lines };
  void draw() const;
  void erase() const;

  Style style_;
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::vector<bool> done_;
  std::size_t count_ = 0, told_ = 0;
  std::string latest_;
};

}  // namespace gradus::cli
