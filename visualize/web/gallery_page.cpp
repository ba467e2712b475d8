#include "web/gallery_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "figure/colophon.hpp"
#include "figure/markup.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"

namespace gradus {
namespace {

/// "3 figures"
std::string counted(std::size_t count) { return fmt::format("{} figure{}", count, count == 1 ? "" : "s"); }

/// In the order of their first card.
std::vector<std::string_view> chapters_of(std::span<const Card> cards) {
  std::vector<std::string_view> chapters;
  for (const Card& card : cards) {
    if (std::ranges::find(chapters, card.chapter) == chapters.end()) chapters.push_back(card.chapter);
  }
  return chapters;
}

/// All that a search looks at. The page's script compares without regard to case, hyphens and underscores.
std::string search_text(const Card& card) {
  return fmt::format("{} {} {} {} {}", card.title, card.caption, card.slug, card.chapter,
                     fmt::join(card.words, " "));
}

/// A text (as HTML) in a box and the button that copies it; `what` tells a screen reader which one.
std::string copied_text(std::string_view html, std::string_view what) {
  return fmt::format(
      "<div class=\"copied\"><pre><code>{}</code></pre>"
      "<button type=\"button\" class=\"copy\" hidden>copy<span class=\"unseen\"> {}</span></button></div>\n",
      html, escaped(what));
}

/// A command whose flags stay whole where a line ends: "--from", not "--" and "from".
std::string command_html(std::string_view command) {
  std::string out;
  while (!command.empty()) {
    const std::string_view word = command.substr(0, std::min(command.find(' ', 1), command.size()));
    const bool flag = word.starts_with(" -");
    out += flag ? fmt::format(" <span class=\"flag\">{}</span>", escaped(word.substr(1))) : escaped(word);
    command.remove_prefix(word.size());
  }
  return out;
}

std::string link_html(std::string_view name, std::string_view path, std::string_view of) {
  return fmt::format("<li><a href=\"{}\">{}<span class=\"unseen\"> of {}</span></a></li>\n", link_to(path),
                     escaped(name), escaped(of));
}

std::string snippets_html(const Card& card) {
  if (card.snippets.empty()) return "";
  std::string texts;
  for (const auto& [name, text] : card.snippets) {
    texts += fmt::format("<h4>{}</h4>\n{}", escaped(name),
                         copied_text(escaped(text), fmt::format("the {} lines for {}", name, card.title)));
  }
  return fmt::format(
      "<details class=\"snippets\"><summary>lines for your slides<span class=\"unseen\">: "
      "{}</span></summary>\n"
      "{}</details>\n",
      escaped(card.title), texts);
}

std::string links_html(const Card& card) {
  std::string links;
  if (!card.topic_page.empty()) links += link_html("how it works", card.topic_page, card.title);
  for (const auto& [name, path] : card.downloads) links += link_html(name, path, card.title);
  if (!card.zip.empty()) links += link_html("steps (zip)", card.zip, card.title);
  return links;
}

std::string card_html(const Card& card) {
  const std::string& picture = card.opened.empty() ? card.thumbnail : card.opened;
  const std::string& opened = card.player.empty() ? picture : card.player;
  const std::string player =
      card.player.empty() ? ""
                          : fmt::format(
                                "<li><a class=\"player\" href=\"{}\">step through it<span class=\"unseen\">: "
                                "{}</span></a></li>\n",
                                link_to(card.player), escaped(card.title));
  return fmt::format(R"(<article class="card" id="{}" data-words="{}">
<a class="picture" href="{}" tabindex="-1" aria-hidden="true"><img src="{}" alt="" loading="lazy"></a>
<h3><a href="{}">{}</a></h3>
<p class="caption">{}</p>
<ul class="links">
{}{}</ul>
{}{}</article>
)",
                     escaped(card.slug), escaped(search_text(card)), link_to(opened), link_to(card.thumbnail),
                     link_to(opened), escaped(card.title), escaped(card.caption), player, links_html(card),
                     copied_text(command_html(card.command), "the command for " + card.title),
                     snippets_html(card));
}

std::string chapter_html(std::span<const Card> cards, std::string_view chapter) {
  std::string out = fmt::format("<section data-chapter=\"{}\">\n<h2>{}</h2>\n<div class=\"cards\">\n",
                                escaped(chapter), escaped(heading_of(chapter)));
  for (const Card& card : cards) {
    if (card.chapter == chapter) out += card_html(card);
  }
  return out + "</div>\n</section>\n";
}

}  // namespace

std::string gallery_page(std::span<const Card> cards, const GalleryOptions& options) {
  std::string sections, choices;
  for (const std::string_view chapter : chapters_of(cards)) {
    sections += chapter_html(cards, chapter);
    choices +=
        fmt::format("<option value=\"{}\">{}</option>\n", escaped(chapter), escaped(heading_of(chapter)));
  }
  const std::string zip =
      options.zip.empty()
          ? ""
          : fmt::format(" <a href=\"{}\" download>All of it in one file (zip)</a>", link_to(options.zip));
  const std::string errata =
      options.errata.empty()
          ? ""
          : fmt::format(" <a href=\"{}\">What lecture notes print wrong, beside what is right</a>",
                        link_to(options.errata));
  const std::string title = escaped(options.title), intro = escaped(options.intro);
  const std::string count = counted(cards.size());
  return filled(web_asset("gallery.html"), {{"title", title},
                                            {"intro", intro},
                                            {"zip", zip},
                                            {"errata", errata},
                                            {"count", count},
                                            {"choices", choices},
                                            {"sections", sections},
                                            {"release", release_version},
                                            {"licence", figure_licence},
                                            {"common.css", web_asset("common.css")},
                                            {"gallery.css", web_asset("gallery.css")},
                                            {"common.js", web_asset("common.js")},
                                            {"gallery.js", web_asset("gallery.js")}});
}

}  // namespace gradus
