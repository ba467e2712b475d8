#include "cli/terminal/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include "cli/files/files.hpp"
#include "cli/terminal/status_line.hpp"
#include "cli/terminal/terminal.hpp"

namespace gradus::cli {
namespace {

constexpr std::size_t bar_width = 24;

/// How many bars of items are shown.
std::atomic<int> bars = 0;
/// What Working::reached was told last.
std::atomic<double> share_done = 0;

/// A bar that is full where all is done.
std::string bar_of(double share) {
  const auto full = static_cast<std::size_t>(bar_width * std::clamp(share, 0.0, 1.0) + 1e-9);
  return std::string(full, '#') + std::string(bar_width - full, '.');
}

/// A block that moves to and fro.
std::string moving_block(std::size_t tick) {
  constexpr std::size_t block = 6, way = bar_width - block;
  const std::size_t at = tick % (2 * way), left = at < way ? at : 2 * way - at;
  return std::string(left, '.') + std::string(block, '#') + std::string(way - left, '.');
}

}  // namespace

Progress::Progress(std::size_t items, bool quiet, Telling telling)
    : style_(quiet                     ? Style::none
             : can_redraw(Stream::err) ? Style::bar
                                       : Style::lines),
      telling_(telling),
      lines_(items),
      done_(items) {
  if (style_ == Style::bar && items < 2) style_ = Style::none;
  if (style_ == Style::bar) ++bars;
  const std::lock_guard lock(mutex_);
  draw();
}

Progress::~Progress() {
  if (style_ != Style::bar) return;
  StatusLine::only().clear();
  --bars;
}

void Progress::finished(std::size_t index, const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (done_[index]) return;
  ++count_;
  done_[index] = true;
  lines_[index] = line;
  latest_ = line.empty() ? latest_ : line;
  if (telling_ == Telling::each) tell();
  draw();
}

void Progress::kept() {
  const std::lock_guard lock(mutex_);
  tell();
}

void Progress::tell() {
  if (style_ != Style::lines) return;
  // Only what has nothing unfinished before it, so that the order does not depend on the threads
  for (; told_ < done_.size() && done_[told_]; ++told_) {
    if (!lines_[told_].empty()) note(lines_[told_]);
  }
}

void Progress::draw() const {
  if (style_ != Style::bar) return;
  const double share = static_cast<double>(count_) / static_cast<double>(done_.size());
  StatusLine::only().show(fmt::format("[{}] {}/{} {}", bar_of(share), count_, done_.size(), latest_));
}

Working::Working(std::string what, bool quiet) : what_(std::move(what)) {
  if (!quiet && can_redraw(Stream::err)) thread_ = std::thread([this] { tick(); });
}

Working::~Working() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  thread_.join();
  StatusLine::only().clear();
}

void Working::reached(double share) { share_done = share; }

void Working::tick() {
  using namespace std::chrono_literals;
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  for (std::size_t i = 0; !changed_.wait_for(lock, i == 0 ? 1000ms : 200ms, [this] { return over_; }); ++i) {
    if (bars > 0) continue;
    const auto spent =
        std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - start);
    const double share = share_done;
    StatusLine::only().show(
        fmt::format("[{}] {}, {} s", share > 0 ? bar_of(share) : moving_block(i), what_, spent.count()));
  }
}

}  // namespace gradus::cli
