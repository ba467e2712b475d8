#include "web/player.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "theme/theme.hpp"
#include "web/assets.hpp"
#include "web/json.hpp"

namespace gradus {
namespace {

using Parts = std::vector<std::pair<std::string_view, std::string_view>>;

/// Puts parts into a template's {{places}}, once: a part that looks like a place stays as it is.
std::string filled(std::string_view page, const Parts& parts) {
  std::string out;
  while (true) {
    const std::size_t open = page.find("{{");
    const std::size_t close = open == page.npos ? page.npos : page.find("}}", open);
    if (close == page.npos) return out.append(page);
    const std::string_view name = page.substr(open + 2, close - open - 2);
    out.append(page.substr(0, open));
    const auto part = std::ranges::find(parts, name, &Parts::value_type::first);
    out.append(part == parts.end() ? page.substr(open, close + 2 - open) : part->second);
    page.remove_prefix(close + 2);
  }
}

/// Text for HTML, in an element or in a quoted attribute.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// A relative path as a link that cannot be anything else: no scheme, no query, no way to the network.
std::string link_to(std::string_view path) {
  std::string out = "./";
  for (const char c : path) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
                       std::string_view("-._~/").find(c) != std::string_view::npos;
    if (plain) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

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

/// "scan_conversion" -> "Scan conversion"
std::string heading_of(std::string_view chapter) {
  std::string out(chapter);
  std::ranges::replace(out, '_', ' ');
  if (!out.empty() && 'a' <= out[0] && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

std::string card_html(const Card& card) {
  std::string downloads;
  for (const auto& [name, path] : card.downloads) {
    downloads += fmt::format("<a href=\"{}\">{}</a>\n", link_to(path), escaped(name));
  }
  return fmt::format(R"(<article class="card" id="{}">
<a class="picture" href="{}"><img src="{}" alt="{}" loading="lazy"></a>
<h3>{}</h3>
<p class="caption">{}</p>
<p class="links"><a class="player" href="{}">step through it</a>
{}</p>
<div class="command"><code>{}</code><button type="button" class="copy">copy</button></div>
</article>
)",
                     escaped(card.slug), link_to(card.player), link_to(card.thumbnail), escaped(card.title),
                     escaped(card.title), escaped(card.caption), link_to(card.player), downloads,
                     escaped(card.command));
}

}  // namespace

std::string player_page(const Trace& trace, const Colophon& colophon, const PlayerOptions& options) {
  const Language& language = trace.wording.language();
  const std::string data =
      fmt::format("{{\"themes\":{},\n\"theme\":{},\n\"words\":{},\n\"command\":{},\n\"trace\":{}}}",
                  themes_json(), json_quoted(options.theme), said_words(language),
                  json_quoted(colophon.command), trace_json(trace, options.slots));
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
  for (const std::string_view file : {"player.css", "words.js", "run.js", "drawing.js", "scrub.js",
                                      "address.js", "clipboard.js", "player.js"}) {
    parts.emplace_back(file, web_asset(file));
  }
  const std::vector<std::pair<std::string, std::string>> words = page_words(language);
  parts.insert(parts.end(), words.begin(), words.end());
  return filled(web_asset("player.html"), parts);
}

std::string gallery_page(std::span<const Card> cards) {
  // Chapters in the order of their first card
  std::vector<std::string_view> chapters;
  for (const Card& card : cards) {
    if (std::ranges::find(chapters, card.chapter) == chapters.end()) chapters.push_back(card.chapter);
  }
  std::string sections;
  for (const std::string_view chapter : chapters) {
    sections += fmt::format("<section>\n<h2>{}</h2>\n<div class=\"cards\">\n", escaped(heading_of(chapter)));
    for (const Card& card : cards) {
      if (card.chapter == chapter) sections += card_html(card);
    }
    sections += "</div>\n</section>\n";
  }
  const std::string count = fmt::format("{} figure{}", cards.size(), cards.size() == 1 ? "" : "s");
  return filled(web_asset("gallery.html"), {{"release", release_version},
                                            {"licence", figure_licence},
                                            {"count", count},
                                            {"gallery.css", web_asset("gallery.css")},
                                            {"gallery.js", web_asset("gallery.js")},
                                            {"sections", sections}});
}

}  // namespace gradus
