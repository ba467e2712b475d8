#pragma once
// How far a long command is: a bar on a terminal, one plain line per finished item elsewhere, nothing with
// -q.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gradus::cli {

/// What is said of the items that are finished.
enum class Telling : std::uint8_t {
  each,        ///< where there is no bar, a line per item as soon as it and all before it are done
  as_a_whole,  ///< the same, but only once they are kept(): until then they may come to nothing
};

/// May be told of finished items from any thread and in any order; lines come out in the order of the items.
class Progress {
 public:
  Progress(std::size_t items, bool quiet, Telling telling = Telling::each);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Item `index` is done: `line` says what was made; empty says nothing, but counts.
  void finished(std::size_t index, const std::string& line);
  /// The items that are finished stay so.
  void kept();

 private:
  enum class Style { none, bar, lines };
  void draw() const;
  void tell();

  Style style_;
  Telling telling_;
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::vector<bool> done_;
  std::size_t count_ = 0, told_ = 0;
  std::string latest_;
};

/// Says on a terminal, from the first second on, that a command is at work, and for how long; a bar as long
/// as the share that is done, where somebody tells it. Nothing with -q, or while a bar of items is shown.
class Working {
 public:
  Working(std::string what, bool quiet);
  ~Working();
  Working(const Working&) = delete;
  Working& operator=(const Working&) = delete;

  /// So much of the work is done, from 0 to 1. From any thread.
  static void reached(double share);

 private:
  void tick();

  std::string what_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace gradus::cli
