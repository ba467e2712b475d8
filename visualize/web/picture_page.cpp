#include "web/picture_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "figure/text/markup.hpp"
#include "json/json.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"
#include "web/text_pack.hpp"

namespace gradus {
namespace {

template <class Written>
std::string json_list(const std::vector<std::string>& texts, Written written) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ",\n") + written(text);
  return fmt::format("[{}]", list);
}

std::string data_of(const PicturePage& page) {
  const auto block = [](const std::string& bytes) { return fmt::format("\"{}\"", base64(bytes)); };
  const auto form = [](const std::string& text) { return json_quoted(text); };
  return fmt::format(
      "{{\"width\":{},\"height\":{},\"command\":{},\n\"forms\":{},\n\"sharedInBlock\":{},\n\"shared\":{},\n"
      "\"rows\":{}}}",
      page.width, page.height, json_quoted(page.colophon.command), json_list(page.forms, form),
      TextPack::shared_in_block, json_list(page.shared, block), json_list(page.rows, block));
}

}  // namespace

std::string picture_page(const PicturePage& page) {
  const std::string title = escaped(page.colophon.title), description = escaped(page.colophon.description);
  const std::string command = escaped(page.colophon.command), hash = escaped(page.colophon.input_hash);
  const std::string data = data_of(page), png = base64(page.png);
  const std::string width = fmt::format("{}", page.width), height = fmt::format("{}", page.height);
  Parts parts{{"title", title},
              {"description", description},
              {"command", command},
              {"input_hash", hash},
              {"width", width},
              {"height", height},
              {"release", release_version},
              {"licence", figure_licence},
              {"common.css", web_asset("common.css")},
              {"picture.css", web_asset("picture.css")},
              {"common.js", web_asset("common.js")},
              {"unpack.js", web_asset("unpack.js")},
              {"picture.js", web_asset("picture.js")}};
  // What the stories say may hold letters of names
  Parts letters = parts;
  std::string names;
  for (const std::string& form : page.forms) names += form;
  letters.emplace_back("forms", names);
  const std::string fonts = fonts_of(letters);
  parts.insert(parts.end(), {{"fonts", fonts}, {"data", data}, {"png", png}});
  return filled(web_asset("picture.html"), parts);
}

}  // namespace gradus
