#include "web/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "figure/markup.hpp"
#include "json/json.hpp"
#include "theme/theme.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"

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

/// The page's own words as parts of its template: {{say next}} is the text "player.next".
std::vector<std::pair<std::string, std::string>> page_words(const Language& language) {
  constexpr std::string_view section = "player.";
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& [key, text] : language.texts()) {
    if (key.starts_with(section)) out.emplace_back("say " + key.substr(section.size()), escaped(text));
  }
  return out;
}

/// The templates that the page's script fills in: the section [player.said], and what figures say too.
std::string said_words(const Language& language) {
  constexpr std::string_view section = "player.said.";
  std::vector<std::string> out{fmt::format("\"step\":{}", json_quoted(language.text("figure.step"))),
                               fmt::format("\"faulty\":{}", json_quoted(language.text("figure.faulty")))};
  for (const auto& [key, text] : language.texts()) {
    if (!key.starts_with(section)) continue;
    out.push_back(fmt::format("{}:{}", json_quoted(key.substr(section.size())), json_quoted(text)));
  }
  return fmt::format("{{{}}}", fmt::join(out, ",\n"));
}

std::string topic_link_to(std::string_view topic_page, const Language& language) {
  if (topic_page.empty()) return {};
  return fmt::format("<a class=\"topic\" href=\"{}\">{}</a>", link_to(topic_page),
                     escaped(language.text("player.about")));
}

/// [["0","0"],["1","2"]]: the steps that stand side by side, and with which they part.
std::string beside_json(const PlayedBeside& beside, const std::set<Slot>& slots) {
  const Alignment& alignment = beside.alignment;
  const auto number = [](StepNumber step) { return json_quoted(text_of(step)); };
  std::vector<std::string> pairs;
  for (const StepPair& pair : alignment.pairs)
    pairs.push_back(fmt::format("[{},{}]", number(pair.a), number(pair.b)));
  const std::string parting = alignment.parting ? number(alignment.pairs[*alignment.parting].a) : "null";
  return fmt::format("{{\"trace\":{},\n\"command\":{},\n\"pairs\":[{}],\n\"parting\":{}}}",
                     trace_json(beside.trace, slots), json_quoted(beside.command), fmt::join(pairs, ","),
                     parting);
}

}  // namespace

std::string player_page(const Trace& trace, const Colophon& colophon, const PlayerOptions& options) {
  const Language& language = trace.wording.language();
  const std::string data =
      fmt::format("{{\"themes\":{},\n\"theme\":{},\n\"words\":{},\n\"command\":{},\n\"trace\":{}{}}}",
                  themes_json(), json_quoted(options.theme), said_words(language),
                  json_quoted(colophon.command), trace_json(trace, options.slots),
                  options.beside ? ",\n\"beside\":" + beside_json(*options.beside, options.slots) : "");
  const bool describes = options.slots.contains(Slot::title) && options.slots.contains(Slot::sentence);
  const std::string title = escaped(colophon.title);
  const std::string description = describes ? escaped(colophon.description) : title;
  const std::string command = escaped(colophon.command), input_hash = escaped(colophon.input_hash);
  const std::string topic_link = topic_link_to(options.topic_page, language);
  Parts parts{{"title", title},
              {"description", description},
              {"command", command},
              {"input_hash", input_hash},
              {"release", release_version},
              {"licence", figure_licence},
              {"language", language.code()},
              {"topic_link", topic_link},
              {"data", data}};
  for (const std::string_view file :
       {"player.css", "words.js", "run.js", "typeset.js", "elements.js", "stage.js", "labels.js",
        "overview.js", "legend.js", "motion.js", "drawing.js", "scrub.js", "address.js", "clipboard.js",
        "together.js", "view.js", "player.js", "page.js"}) {
    parts.emplace_back(file, web_asset(file));
  }
  const std::vector<std::pair<std::string, std::string>> words = page_words(language);
  parts.insert(parts.end(), words.begin(), words.end());
  const std::string fonts = fonts_of(parts);
  parts.emplace_back("fonts", fonts);
  return filled(web_asset("player.html"), parts);
}

}  // namespace gradus
