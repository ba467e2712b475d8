#include "web/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "theme/theme.hpp"
#include "figure/markup.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/json.hpp"

namespace gradus {
namespace {

std::string hex_of(Rgb color) { return fmt::format("\"#{:06x}\"", color.hex); }

std::string_view name_of(Hatch hatch) {
  constexpr std::array<std::string_view, 4> names{"none", "rising", "falling", "cross"};
  return names[static_cast<std::size_t>(hatch)];
}

std::string role_json(const Theme& theme, Role role) {
  const RoleLook& look = theme[role];
  const Channel channel = channel_of(role);
  return fmt::format(
      R"({{"role":{},"mark":{},"fill":{},"text":{},"on":{},"hatch":"{}","outline":{},"dashed":{},"cross":{}}})",
      json_quoted(name_of(role)), hex_of(look.mark), hex_of(look.fill), hex_of(look.text),
      hex_of(color_of(Paint::on(role), theme)), name_of(channel.hatch), channel.outline, channel.dashed,
      channel.cross);
}

/// The same looks as Cairo's figures, for the page's script.
std::string themes_json() {
  constexpr std::array<std::pair<std::string_view, Tone>, 9> tones{{{"paper", Tone::paper},
                                                                    {"panel", Tone::panel},
                                                                    {"header", Tone::header},
                                                                    {"weak", Tone::weak},
                                                                    {"strong", Tone::strong},
                                                                    {"rule", Tone::rule},
                                                                    {"ink", Tone::ink},
                                                                    {"muted", Tone::muted},
                                                                    {"accent", Tone::accent}}};
  std::vector<std::string> out;
  for (const Theme& theme : themes()) {
    std::vector<std::string> tone_parts, role_parts;
    for (const auto& [name, tone] : tones) {
      tone_parts.push_back(fmt::format("\"{}\":{}", name, hex_of(theme[tone])));
    }
    for (const Role role : all_roles) role_parts.push_back(role_json(theme, role));
    out.push_back(fmt::format(R"({{"name":{},"tones":{{{}}},"roles":[{}]}})", json_quoted(theme.name),
                              fmt::join(tone_parts, ","), fmt::join(role_parts, ",\n")));
  }
  return fmt::format("[{}]", fmt::join(out, ",\n"));
}

}  // namespace

std::string player_page(const Trace& trace, const Colophon& colophon) {
  const std::string data = fmt::format("{{\"themes\":{},\n\"command\":{},\n\"trace\":{}}}", themes_json(),
                                       json_quoted(colophon.command), trace_json(trace));
  const std::string title = escaped(colophon.title), description = escaped(colophon.description);
  const std::string command = escaped(colophon.command), input_hash = escaped(colophon.input_hash);
  return filled(web_asset("player.html"), {{"title", title},
                                           {"description", description},
                                           {"command", command},
                                           {"input_hash", input_hash},
                                           {"release", release_version},
                                           {"licence", figure_licence},
                                           {"player.css", web_asset("player.css")},
                                           {"run.js", web_asset("run.js")},
                                           {"drawing.js", web_asset("drawing.js")},
                                           {"player.js", web_asset("player.js")},
                                           {"data", data}});
}

}  // namespace gradus
