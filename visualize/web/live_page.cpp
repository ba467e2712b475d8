#include "web/live_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "cairo/deflated.hpp"
#include "figure/colophon.hpp"
#include "figure/text/markup.hpp"
#include "json/json.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"
#include "web/player_parts.hpp"

namespace gradus {
namespace {

using Words = std::vector<std::pair<std::string, std::string>>;

std::string packed(std::string_view bytes) { return bytes.empty() ? "" : base64(deflated(bytes)); }

std::string language_options() {
  std::string out;
  for (const Language& language : languages())
    out += fmt::format("<option value=\"{}\">{}</option>", language.code(), escaped(language.name()));
  return out;
}

/// The templates that a script makes the page from, in this language.
std::string templates_in(const Language& language) {
  const std::string options = language_options(), player = "gradus-player-" + language.code();
  const Words of_player = page_words(language, "player."), of_strip = page_words(language, "live.");
  Parts parts{{"template", player}, {"topic_link", ""}};
  parts.insert(parts.end(), of_player.begin(), of_player.end());
  std::string out = filled(web_asset("player_template.html"), parts);
  Parts strip{{"language", language.code()}, {"languages", options}};
  strip.insert(strip.end(), of_strip.begin(), of_strip.end());
  strip.insert(strip.end(), of_player.begin(), of_player.end());  // of two texts of a name the strip's
  return out + filled(workbench_asset("workbench.html"), strip);
}

std::string data_of(const LiveContent& content) {
  std::vector<std::string> words, notations;
  for (const Language& language : languages()) {
    words.push_back(fmt::format("{}:{}", json_quoted(language.code()),
                                said_words(language, {"player.said.", "live.said."})));
  }
  for (const std::string& name : content.notations) notations.push_back(json_quoted(name));
  return fmt::format("{{\"themes\":{},\n\"words\":{{{}}},\n\"notations\":[{}],\n\"list\":{}}}", themes_json(),
                     fmt::join(words, ",\n"), fmt::join(notations, ","), content.topics);
}

std::string live_scripts() {
  std::string out = player_scripts();
  for (const std::string_view file : {"asker.js", "numbers.js", "handles.js", "form.js", "state.js",
                                      "files.js", "paint.js", "predict.js", "workbench.js", "live.js"}) {
    out.append(workbench_asset(file));
  }
  return out;
}

}  // namespace

std::string live_page(const LiveContent& content, std::string_view module) {
  const Language& first = languages().front();
  std::string templates;
  for (const Language& language : languages()) templates += templates_in(language);
  const std::string data = data_of(content), scripts = live_scripts();
  const std::string recorded = packed(content.recorded), own_module = packed(module);
  const std::string title = escaped(first.text("live.title")),
                    description = escaped(first.text("live.description"));
  const std::string no_script = escaped(first.text("player.no_script"));
  Parts parts{{"title", title},
              {"description", description},
              {"release", release_version},
              {"licence", figure_licence},
              {"no_script", no_script},
              {"connect", module.empty() ? "'self'" : "'none'"},
              {"templates", templates},
              {"data", data},
              {"scripts", scripts},
              {"host.js", workbench_asset("host.js")},
              {"worker.js", workbench_asset("worker.js")},
              {"player.css", web_asset("player.css")},
              {"live.css", workbench_asset("live.css")}};
  // Of the runs, too: what they show has letters that the page's own texts lack
  parts.emplace_back("runs", content.recorded);
  const std::string fonts = fonts_of(parts);
  parts.emplace_back("fonts", fonts);
  parts.emplace_back("recorded", recorded);
  parts.emplace_back("module", own_module);
  return filled(workbench_asset("live.html"), parts);
}

}  // namespace gradus
