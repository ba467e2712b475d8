#include "cli/terminal/status_line.hpp"

#include <unistd.h>

#include <algorithm>

#include "cli/terminal/terminal.hpp"
#include "core/shown.hpp"

namespace gradus::cli {
namespace {

void put(std::string_view text) { static_cast<void>(!write(STDERR_FILENO, text.data(), text.size())); }

/// The beginning of a text that takes at most so many columns.
std::string_view cut(std::string_view text, int columns) {
  std::size_t end = 0;
  for (int i = 0; i < columns && end < text.size(); ++i) {
    end += std::max<std::size_t>(character_size(text.substr(end)), 1);
  }
  return text.substr(0, end);
}

}  // namespace

StatusLine& StatusLine::only() {
  static auto* line = new StatusLine;  // never destroyed: threads may use it until the very end
  return *line;
}

void StatusLine::show(std::string_view text) {
  static const bool possible = can_redraw(Stream::err);
  if (!possible) return;
  const std::lock_guard lock(mutex_);
  text_ = text;
  draw();
}

void StatusLine::clear() {
  const std::lock_guard lock(mutex_);
  erase();
  text_.clear();
}

void StatusLine::aside(const std::function<void()>& write, bool ends_line) {
  const std::lock_guard lock(mutex_);
  erase();
  text_.clear();
  at_line_start_ = ends_line;
  write();
}

void StatusLine::hide(bool hidden) {
  const std::lock_guard lock(mutex_);
  erase();
  hidden_ = hidden;
}

void StatusLine::leave() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) erase();
}

void StatusLine::draw() const {
  if (!is_shown()) return;
  put("\r\x1b[K" + std::string(cut(text_, columns(Stream::err) - 1)));
}

void StatusLine::erase() const {
  if (is_shown()) put("\r\x1b[K");
}

}  // namespace gradus::cli
