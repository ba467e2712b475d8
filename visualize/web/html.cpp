#include "web/html.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gradus {

std::string filled(std::string_view page, const Parts& parts) {
  std::string out;
  while (true) {
    const std::size_t open = page.find("{{");
    const std::size_t close = open == page.npos ? page.npos : page.find("}}", open);
    if (close == page.npos) return out.append(page);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    out.append(page.substr(0, open));
    const auto part = std::ranges::find(parts, name, &Parts::value_type::first);
    out.append(part == parts.end() ? page.substr(open, close + 2 - open) : part->second);
    page.remove_prefix(close + 2);
  }
}

std::string link_to(std::string_view path) {
  std::string out = "./";
  for (const char c : path) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

std::string heading_of(std::string_view chapter) {
  std::string out(chapter);
  std::ranges::replace(out, '_', ' ');
  if (!out.empty() && 'a' <= out[0] && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

}  // namespace gradus
