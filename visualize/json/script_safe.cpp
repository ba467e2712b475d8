#include "json/script_safe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/shown.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {

std::string script_safe(const std::string& json) {
  std::string out;
  out.reserve(json.size() + json.size() / 64);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest = std::string_view(json).substr(i);
    if (rest[0] == '<' && rest.size() > 1 &&
        std::string_view("/!sS").find(rest[1]) != std::string_view::npos) {
      out += "\\u003c";
    } else if (rest.starts_with("-->")) {
      out += "--\\u003e";
      i += 2;
    } else if (static_cast<unsigned char>(rest[0]) >= 0x7f) {
      const std::string_view character = rest.substr(0, std::max<std::size_t>(character_size(rest), 1));
      const char32_t code = code_points(character)[0];
      out += is_control(code) ? fmt::format("\\u{:04x}", static_cast<std::uint32_t>(code))
                              : std::string(character);
      i += character.size() - 1;
    } else {
      out += rest[0];
    }
  }
  return out;
}

}  // namespace gradus
