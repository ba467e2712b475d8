#include "web/article.hpp"

#include "figure/colophon.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"

namespace gradus {
namespace {

/// The texts of these files, one after the other.
std::string texts_of(std::string_view common, const std::vector<std::string_view>& more) {
  std::string text = std::string(web_asset(common)) + "\n";
  for (const std::string_view name : more) text.append(web_asset(name)) += "\n";
  return text;
}

}  // namespace

std::string page_of(const Article& article) {
  const std::string styles = texts_of("common.css", article.styles),
                    scripts = texts_of("common.js", article.scripts);
  Parts parts{{"title", article.title},       {"summary", article.summary}, {"trail", article.trail},
              {"contents", article.contents}, {"body", article.body},       {"release", release_version},
              {"licence", figure_licence},    {"styles", styles},           {"scripts", scripts}};
  const std::string fonts = fonts_of(parts);
  parts.emplace_back("fonts", fonts);
  return filled(web_asset("article.html"), parts);
}

}  // namespace gradus
