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
  const std::string& opened = card.player.empty() ? card.thumbnail : card.player;
  const std::string player =
      card.player.empty()
          ? ""
          : fmt::format("<a class=\"player\" href=\"{}\">step through it</a>\n", link_to(card.player));
  return fmt::format(R"(<article class="card" id="{}">
<a class="picture" href="{}"><img src="{}" alt="{}" loading="lazy"></a>
<h3>{}</h3>
<p class="caption">{}</p>
<p class="links">{}{}</p>
<div class="command"><code>{}</code><button type="button" class="copy">copy</button></div>
</article>
)",
                     escaped(card.slug), link_to(opened), link_to(card.thumbnail), escaped(card.title),
                     escaped(card.title), escaped(card.caption), player, downloads, escaped(card.command));
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

std::string gallery_page(std::span<const Card> cards, const std::string& title) {
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
  const std::string heading = title.empty() ? "Gradus" : escaped(title);
  const std::string page_title = title.empty() ? "Gradus: computer graphics, step by step" : heading;
  const std::string count = fmt::format("{} figure{}", cards.size(), cards.size() == 1 ? "" : "s");
  return filled(web_asset("gallery.html"), {{"release", release_version},
                                            {"licence", figure_licence},
                                            {"count", count},
                                            {"title", page_title},
                                            {"heading", heading},
                                            {"gallery.css", web_asset("gallery.css")},
                                            {"gallery.js", web_asset("gallery.js")},
                                            {"sections", sections}});
}

}  // namespace gradus
