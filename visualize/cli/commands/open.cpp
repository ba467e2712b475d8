// `gradus open`: the gallery in the browser.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/terminal/terminal.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

Texts parts_of(const std::string& text, char separator) {
  Texts parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    if (end > at) parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// The program of this name where the shell would find it; empty when it is nowhere.
std::string found_program(const std::string& name) {
  const auto runs = [](const std::string& path) {
    return access(path.c_str(), X_OK) == 0 && !fs::is_directory(path);
  };
  if (name.find('/') != std::string::npos) return runs(name) ? name : "";
  for (const std::string& folder : parts_of(environment("PATH"), ':')) {
    if (std::string path = folder + "/" + name; runs(path)) return path;
  }
  return "";
}

/// The page as an address: all but letters, digits and a few signs as %xx.
std::string address_of(const fs::path& page) {
  std::string address = "file://";
  for (const char c : fs::absolute(page).lexically_normal().string()) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
                       std::string_view("/-_.~").find(c) != std::string_view::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
}

/// "firefox --new-tab %s": the words of a command, with the address in the place of %s, or at the end.
Texts command_for(const std::string& browser, const std::string& address) {
  Texts words = parts_of(browser, ' ');
  bool told = false;
  for (std::string& word : words) {
    const std::size_t place = word.find("%s");
    if (place == std::string::npos) continue;
    word.replace(place, 2, address);
    told = true;
  }
  if (!told) words.push_back(address);
  return words;
}

/// The browser gets signals as they were before prepare_process.
void hand_back_signals() {
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
}

fs::path page_of(const Request& request) {
  const std::string name = request.operands.empty() ? "out" : request.operands[0];
  std::error_code error;
  if (fs::is_regular_file(name, error)) return name;
  const fs::path page = fs::path(name) / "index.html";
  if (fs::is_regular_file(page, error)) return page;
  if (fs::exists(name, error)) {
    throw UsageError(
        fmt::format("open: expected a folder with figures (`gradus figures -o {}` draws them), found {}",
                    shell_quoted(name), shown(name)));
  }
  throw UsageError(
      fmt::format("open: expected a folder that exists (`gradus figures -o {}` makes it), found {}",
                  shell_quoted(name), shown(name)));
}

}  // namespace

int open_gallery(const Request& request) {
  const fs::path page = page_of(request);
  const std::string address = address_of(page);
  // BROWSER: programs in the order of preference, with : between them
  Texts browsers = parts_of(environment("BROWSER"), ':');
  browsers.emplace_back("xdg-open");
  for (const std::string& browser : browsers) {
    Texts words = command_for(browser, address);
    const std::string program = found_program(words[0]);
    if (program.empty()) continue;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    hand_back_signals();
    execv(program.c_str(), arguments.data());
  }
  throw WorkError(
      fmt::format("open: expected a browser in BROWSER, or xdg-open, found none; the page is {}", address));
}

}  // namespace gradus::cli
