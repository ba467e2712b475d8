#include "web/player_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "figure/text/markup.hpp"
#include "json/json.hpp"
#include "theme/theme.hpp"
#include "web/assets.hpp"

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
  const auto tint = [&](int shade) { return hex_of(color_of(Paint::tint(role, shade), theme)); };
  return fmt::format(
      R"({{"role":{},"mark":{},"fill":{},"tints":[{},{},{}],"text":{},"on":{},"hatch":"{}","areaHatch":"{}","outline":{},"dashed":{},"cross":{}}})",
      json_quoted(name_of(role)), hex_of(look.mark), hex_of(look.fill), tint(1), tint(2), tint(3),
      hex_of(look.text), hex_of(color_of(Paint::on(role), theme)), name_of(channel.hatch),
      name_of(area_hatch(role)), channel.outline, channel.dashed, channel.cross);
}

}  // namespace

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
    if (theme.hatched) continue;  // for paper
    std::vector<std::string> tone_parts, role_parts;
    for (const auto& [name, tone] : tones) {
      tone_parts.push_back(fmt::format("\"{}\":{}", name, hex_of(theme[tone])));
    }
    for (const Role role : all_roles) role_parts.push_back(role_json(theme, role));
    std::vector<std::string> quantities;
    for (const Rgb color : theme.quantity) quantities.push_back(hex_of(color));
    out.push_back(
        fmt::format(R"({{"name":{},"tones":{{{}}},"quantities":[{}],"underlined":{},"roles":[{}]}})",
                    json_quoted(theme.name), fmt::join(tone_parts, ","), fmt::join(quantities, ","),
                    theme.quantities_underlined, fmt::join(role_parts, ",\n")));
  }
  return fmt::format("[{}]", fmt::join(out, ",\n"));
}

std::vector<std::pair<std::string, std::string>> page_words(const Language& language,
                                                            std::string_view section) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& [key, text] : language.texts(section))
    out.emplace_back("say " + key.substr(section.size()), escaped(text));
  return out;
}

std::string said_words(const Language& language, std::initializer_list<std::string_view> sections) {
  std::vector<std::string> out{fmt::format("\"step\":{}", json_quoted(language.text("figure.step"))),
                               fmt::format("\"faulty\":{}", json_quoted(language.text("figure.faulty")))};
  for (const std::string_view section : sections) {
    for (const auto& [key, text] : language.texts(section))
      out.push_back(fmt::format("{}:{}", json_quoted(key.substr(section.size())), json_quoted(text)));
  }
  return fmt::format("{{{}}}", fmt::join(out, ",\n"));
}

std::string player_scripts() {
  std::string out;
  for (const std::string_view file :
       {"words.js",  "run.js",      "typeset.js", "elements.js", "stage.js",    "labels.js",  "overview.js",
        "legend.js", "motion.js",   "still.js",   "drawing.js",  "scrub.js",    "address.js", "clipboard.js",
        "export.js", "together.js", "view.js",    "player.js",   "controls.js", "page.js"}) {
    out.append(web_asset(file));
  }
  return out;
}

}  // namespace gradus
