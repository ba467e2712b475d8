#include "web/gallery_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "figure/colophon.hpp"
#include "figure/text/markup.hpp"
#include "web/assets.hpp"
#include "web/html.hpp"
#include "web/page_fonts.hpp"

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

/// The topics of a chapter's cards, in the order of their first card.
std::vector<CardGroup> groups_of(std::span<const Card> cards, std::string_view chapter) {
  std::vector<CardGroup> groups;
  for (const Card& card : cards) {
    if (card.chapter == chapter && std::ranges::find(groups, card.group.id, &CardGroup::id) == groups.end()) {
      groups.push_back(card.group);
    }
  }
  return groups;
}

const std::string& name_of(const Card& card) { return card.name.empty() ? card.title : card.name; }

/// All that a search looks at. The page's script compares without regard to case, hyphens and underscores.
std::string search_text(const Card& card) {
  return fmt::format("{} {} {} {} {} {} {}", card.title, card.group.title, card.caption, card.faulty,
                     card.slug, card.chapter, fmt::join(card.words, " "));
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
  for (const auto& [name, path] : card.downloads) links += link_html(name, path, card.title);
  if (!card.zip.empty()) links += link_html("steps (zip)", card.zip, card.title);
  return links;
}

/// What a click on the picture opens.
const std::string& opened_by(const Card& card) {
  if (!card.player.empty()) return card.player;
  return card.opened.empty() ? card.thumbnail : card.opened;
}

std::string player_link(const Card& card) {
  if (card.player.empty()) return "";
  return fmt::format(
      "<p><a class=\"player\" href=\"{}\">step through it<span class=\"unseen\">: {}</span></a></p>\n",
      link_to(card.player), escaped(card.title));
}

/// Files, command and lines to paste: for who has chosen the figure.
std::string take_html(const Card& card) {
  return fmt::format(R"(<details class="take"><summary>take it<span class="unseen">: {}</span></summary>
<ul class="links">
{}</ul>
{}{}</details>
)",
                     escaped(card.title), links_html(card),
                     copied_text(command_html(card.command), "the command for " + card.title),
                     snippets_html(card));
}

/// `leads`: the topic's first figure, which is drawn large.
std::string card_html(const Card& card, bool leads) {
  const std::string opened = link_to(opened_by(card));
  const std::string faulty =
      card.faulty.empty() ? "" : fmt::format("<p class=\"faulty\">faulty: {}</p>\n", escaped(card.faulty));
  return fmt::format(R"(<article class="card" id="{}" data-words="{}">
<a class="picture" href="{}" tabindex="-1" aria-hidden="true"><img src="{}" alt="" loading="lazy"></a>
<div class="text">
<h4><a href="{}">{}</a></h4>
{}<p class="caption">{}</p>
{}{}</div>
</article>
)",
                     escaped(card.slug), escaped(search_text(card)), opened, link_to(card.thumbnail), opened,
                     escaped(name_of(card)), faulty, escaped(card.caption), leads ? player_link(card) : "",
                     take_html(card));
}

/// A topic with its figures inside; the first of them is drawn large.
std::string group_html(std::span<const Card> cards, std::string_view chapter, const CardGroup& group) {
  const std::string page =
      group.page.empty() ? ""
                         : fmt::format("<a href=\"{}\">how it works<span class=\"unseen\">: {}</span></a>",
                                       link_to(group.page), escaped(group.title));
  std::string out =
      fmt::format("<section class=\"topic\">\n<header><h3>{}</h3>{}</header>\n<div class=\"cards\">\n",
                  escaped(group.title), page);
  bool leads = true;
  for (const Card& card : cards) {
    if (card.chapter != chapter || card.group.id != group.id) continue;
    out += card_html(card, leads);
    leads = false;
  }
  return out + "</div>\n</section>\n";
}

std::string chapter_html(std::span<const Card> cards, std::string_view chapter) {
  std::string out = fmt::format("<section data-chapter=\"{}\">\n<h2>{}</h2>\n", escaped(chapter),
                                escaped(heading_of(chapter)));
  for (const CardGroup& group : groups_of(cards, chapter)) out += group_html(cards, chapter, group);
  return out + "</section>\n";
}

/// The first figure as it would be projected.
std::string hero_html(std::span<const Card> cards) {
  const auto card = std::ranges::find_if(cards, [](const Card& c) { return !c.slide.empty(); });
  if (card == cards.end()) return "";
  const std::string opened = link_to(opened_by(*card));
  return fmt::format(
      "<a class=\"hero\" href=\"{}\"><img src=\"{}\" alt=\"\"><span class=\"unseen\">{}: one step as a "
      "slide</span></a>\n",
      opened, link_to(card->slide), escaped(card->title));
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
  const std::string count = counted(cards.size()), hero = hero_html(cards);
  Parts parts{{"title", title},
              {"intro", intro},
              {"hero", hero},
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
              {"gallery.js", web_asset("gallery.js")}};
  const std::string fonts = fonts_of(parts);
  parts.emplace_back("fonts", fonts);
  return filled(web_asset("gallery.html"), parts);
}

}  // namespace gradus
