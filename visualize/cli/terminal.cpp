#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "cli/names.hpp"

namespace gradus::cli {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

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

std::string bold(std::string_view text, bool color) { return styled(text, color, "1"); }
std::string alarming(std::string_view text, bool color) { return styled(text, color, "1;31"); }

}  // namespace gradus::cli
