#pragma once
// The last line of a terminal, which says what is going on and is gone when that is done.

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace gradus::cli {

/// The one line of this process, on stderr where that is a terminal; elsewhere nothing is ever shown. From
/// any thread. Failures are ignored: a terminal that went away is no reason to stop the work.
class StatusLine {
 public:
  static StatusLine& only();

  /// Shows a text in place of the one before, cut to the terminal's width.
  void show(std::string_view text);
  void clear();

  /// Calls write(), which writes to a terminal, where the line was; it comes back when it is shown the next
  /// time. `ends_line`: whether the cursor is then at the start of a line; where it is not, nothing is shown
  /// until it is.
  void aside(const std::function<void()>& write, bool ends_line);

  /// While a person types, nothing is shown.
  void hide(bool hidden);

  /// For the end of the process, while other threads may still run: clears the line if it can.
  void leave();

 private:
  StatusLine() = default;
  bool is_shown() const { return !text_.empty() && at_line_start_ && !hidden_; }
  void draw() const;
  void erase() const;

  std::mutex mutex_;
  std::string text_;
  bool at_line_start_ = true;
  bool hidden_ = false;
};

}  // namespace gradus::cli
