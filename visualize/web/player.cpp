#include "web/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "figure/text/markup.hpp"
#include "json/json.hpp"
#include "theme/theme.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"
#include "web/player_parts.hpp"

namespace gradus {
namespace {

std::string topic_link_to(std::string_view topic_page, const Language& language) {
  if (topic_page.empty()) return {};
  return fmt::format("<a class=\"topic\" href=\"{}\">{}</a>", link_to(topic_page),
                     escaped(language.text("player.about")));
}

std::string beside_json(const PlayedBeside& beside, const std::set<Slot>& slots) {
  return fmt::format("{{\"trace\":{},\n\"command\":{},\n\"alignment\":{}}}", trace_json(beside.trace, slots),
                     json_quoted(beside.command), alignment_json(beside.alignment));
}

}  // namespace

std::string player_page(const Trace& trace, const Colophon& colophon, const PlayerOptions& options) {
  const Language& language = trace.wording.language();
  const std::string data =
      fmt::format("{{\"themes\":{},\n\"theme\":{},\n\"words\":{},\n\"command\":{},\n\"trace\":{}{}}}",
                  themes_json(), json_quoted(options.theme), said_words(language, {"player.said."}),
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
              {"template", "gradus-player"},
              {"data", data}};
  const std::vector<std::pair<std::string, std::string>> words = page_words(language, "player.");
  parts.insert(parts.end(), words.begin(), words.end());
  const std::string player_template = filled(web_asset("player_template.html"), parts);
  const std::string scripts = player_scripts();
  parts.insert(parts.end(), {{"player_template.html", player_template},
                             {"scripts", scripts},
                             {"player.css", web_asset("player.css")}});
  const std::string fonts = fonts_of(parts);
  parts.emplace_back("fonts", fonts);
  return filled(web_asset("player.html"), parts);
}

}  // namespace gradus
