#include "cli/terminal/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "cli/command_line/errors.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

namespace {

bool dumb() { return environment("TERM") == "dumb"; }

std::string styled(std::string_view text, bool color, std::string_view code) {
  return color ? "\x1b[" + std::string(code) + "m" + std::string(text) + "\x1b[0m" : std::string(text);
}

}  // namespace

Color read_color(std::string_view text) {
  static const std::array<std::string, 3> names{"auto", "always", "never"};
  return static_cast<Color>(choose_name("--color", text, names));
}

bool is_terminal(Stream stream) { return isatty(static_cast<int>(stream)) == 1; }

bool use_color(Color wanted, Stream stream) {
  if (wanted != Color::automatic) return wanted == Color::always;
  if (!environment("NO_COLOR").empty()) return false;
  for (const char* force : {"CLICOLOR_FORCE", "FORCE_COLOR"}) {
    if (const auto value = environment(force); !value.empty() && value != "0") return true;
  }
  return is_terminal(stream) && !dumb();
}

bool can_redraw(Stream stream) { return is_terminal(stream) && !dumb(); }

int columns(Stream stream) {
  winsize size{};
  const bool known = ioctl(static_cast<int>(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::size_t output_width(std::string_view wanted) {
  constexpr std::int64_t least = 20, most = 10'000;
  const auto fits = [](const auto& width) { return width && least <= *width && *width <= most; };
  if (!wanted.empty()) {
    const auto width = whole_number(wanted);
    if (!fits(width))
      throw UsageError(fmt::format("--width: expected a whole number from {} to {}, found {}", least, most,
                                   shown(wanted)));
    return static_cast<std::size_t>(*width);
  }
  if (const auto width = whole_number(environment("COLUMNS")); fits(width))
    return static_cast<std::size_t>(*width);
  return is_terminal(Stream::out) ? static_cast<std::size_t>(std::max(columns(Stream::out), 20)) : 0;
}

std::string bold(std::string_view text, bool color) { return styled(text, color, "1"); }
std::string alarming(std::string_view text, bool color) { return styled(text, color, "1;31"); }

}  // namespace gradus::cli
