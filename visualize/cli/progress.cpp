#include "cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/files.hpp"
#include "cli/terminal.hpp"

namespace gradus::cli {
namespace {

void put(const std::string& text) {
  try {
    write_stream(Stream::err, text);
  } catch (const std::exception&) {
    // A closed stderr is no reason to stop the work
  }
}

}  // namespace

Progress::Progress(std::size_t items, bool quiet)
    : style_(quiet                     ? Style::none
             : can_redraw(Stream::err) ? Style::bar
                                       : Style::lines),
      lines_(items),
      done_(items) {
  const std::lock_guard lock(mutex_);
  draw();
}

Progress::~Progress() { erase(); }

void Progress::finished(std::size_t index, const std::string& line) {
  const std::lock_guard lock(mutex_);
  ++count_;
  done_[index] = true;
  lines_[index] = line;
  latest_ = line.empty() ? latest_ : line;
  if (style_ == Style::lines) {
    // Only what has nothing unfinished before it, so that the order does not depend on the threads
    for (; told_ < done_.size() && done_[told_]; ++told_) {
      if (!lines_[told_].empty()) put(lines_[told_] + "\n");
    }
  }
  draw();
}

void Progress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  erase();
  put(line + "\n");
  draw();
}

void Progress::draw() const {
  if (style_ != Style::bar || done_.size() < 2) return;
  constexpr std::size_t width = 24;
  const std::size_t full = width * count_ / done_.size();
  std::string line = fmt::format("[{}{}] {}/{} {}", std::string(full, '#'), std::string(width - full, '.'),
                                 count_, done_.size(), latest_);
  line.resize(std::min(line.size(), static_cast<std::size_t>(columns(Stream::err) - 1)));
  put("\r\x1b[K" + line);
}

void Progress::erase() const {
  if (style_ == Style::bar && done_.size() >= 2) put("\r\x1b[K");
}

}  // namespace gradus::cli
