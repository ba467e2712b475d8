#include "cairo/metadata.hpp"

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <map>
#include <span>

#include "cairo/cairo_output.hpp"

namespace gradus {
namespace {

// The same keys in every format; SVG and HTML hold them as attributes and elements, PDF in one Keywords text.
constexpr std::string_view command_key = "gradus-command", hash_key = "gradus-input-hash";

/// A text for XML: markup escaped, control characters (not allowed there) as U+FFFD.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? std::string("\xef\xbf\xbd") : std::string(1, c);
    }
  }
  return safe;
}

std::string unescaped(std::string_view text) {
  static const std::map<std::string_view, char> entities{
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = text[i] == '&' ? text.find(';', i) : std::string_view::npos;
    const auto found =
        end == std::string_view::npos ? entities.end() : entities.find(text.substr(i, end - i + 1));
    if (found == entities.end()) {
      plain += text[i++];
    } else {
      plain += found->second;
      i = end + 1;
    }
  }
  return plain;
}

/// What stands between two marks, from `at` on.
std::optional<std::string_view> between(std::string_view text, std::string_view open,
                                        std::string_view close) {
  const std::size_t start = text.find(open);
  if (start == std::string_view::npos) return std::nullopt;
  const std::size_t first = start + open.size(), end = text.find(close, first);
  if (end == std::string_view::npos) return std::nullopt;
  return text.substr(first, end - first);
}

/// SVG: an attribute key="value"; HTML: <meta name="key" content="value">.
std::optional<Colophon> colophon_in_markup(std::string_view text) {
  const auto attribute = [text](std::string_view key) {
    const auto in_svg = between(text, fmt::format(" {}=\"", key), "\"");
    return in_svg ? in_svg : between(text, fmt::format("name=\"{}\" content=\"", key), "\"");
  };
  const auto command = attribute(command_key);
  if (!command) return std::nullopt;
  Colophon colophon;
  colophon.command = unescaped(*command);
  colophon.input_hash = unescaped(attribute(hash_key).value_or(""));
  colophon.title = unescaped(between(text, "<title>", "</title>").value_or(""));
  colophon.description = unescaped(between(text, "<desc>", "</desc>").value_or(""));
  return colophon;
}

std::optional<Colophon> colophon_in_png(std::string_view bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  Colophon colophon;
  for (const PngText& entry : png_texts({data, bytes.size()}, "figure")) {
    if (entry.key == command_key) colophon.command = entry.text;
    if (entry.key == hash_key) colophon.input_hash = entry.text;
    if (entry.key == "Title") colophon.title = entry.text;
    if (entry.key == "Description") colophon.description = entry.text;
  }
  if (colophon.command.empty()) return std::nullopt;
  return colophon;
}

/// Percent-encoding, so that the PDF text stays plain ASCII whatever the command holds.
std::string percent_encoded(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) || c == ' ' || c == '-' || c == '_' || c == '.' || c == ',' ||
                       c == '#' || c == '/' || c == '\'' || c == '=';
    safe += plain && byte < 0x80 ? std::string(1, c) : fmt::format("%{:02x}", byte);
  }
  return safe;
}

std::string percent_decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, byte, 16).ec == std::errc()) {
      plain += static_cast<char>(static_cast<unsigned char>(byte));
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

std::optional<Colophon> colophon_in_pdf(std::string_view bytes) {
  const auto keyword = [bytes](std::string_view key) { return between(bytes, fmt::format("{}[", key), "]"); };
  const auto command = keyword(command_key);
  if (!command) return std::nullopt;
  Colophon colophon;
  colophon.command = percent_decoded(*command);
  colophon.input_hash = percent_decoded(keyword(hash_key).value_or(""));
  return colophon;
}

/// Numbers the ids stem17, stem23 … from 1 on, where they are set ("stem17") and used (#stem17).
std::string renumbered(const std::string& svg, std::string_view stem) {
  std::map<std::string, std::size_t> numbers;
  std::string text;
  text.reserve(svg.size());
  std::size_t done = 0;
  for (std::size_t at = svg.find(stem); at != std::string::npos; at = svg.find(stem, done)) {
    std::size_t end = at + stem.size();
    text.append(svg, done, end - done);
    done = end;
    if (at == 0 || (svg[at - 1] != '"' && svg[at - 1] != '#')) continue;
    while (end < svg.size() && std::isdigit(static_cast<unsigned char>(svg[end]))) ++end;
    if (end == done) continue;
    const auto [entry, added] = numbers.emplace(svg.substr(done, end - done), numbers.size() + 1);
    text += std::to_string(entry->second);
    done = end;
  }
  return text.append(svg, done);
}

}  // namespace

std::string renumbered(const std::string& svg) { return renumbered(renumbered(svg, "surface"), "image"); }

std::string with_colophon(const std::string& svg, const Colophon& colophon) {
  const std::size_t root = svg.find("<svg");
  const std::size_t after = svg.find('>', root) + 1;
  const std::string head = fmt::format(
      "\n<title>{}</title>\n<desc>{}</desc>\n<metadata><gradus xmlns=\"urn:gradus:figure\" {}=\"{}\" "
      "{}=\"{}\" "
      "version=\"{}\" licence=\"{}\"/></metadata>",
      escaped(colophon.title), escaped(colophon.description), command_key, escaped(colophon.command),
      hash_key, escaped(colophon.input_hash), release_version, figure_licence);
  std::string text = svg;
  return text.insert(after, head);
}

std::vector<PngText> png_texts_of(const Colophon& colophon) {
  std::vector<PngText> texts{{"Title", colophon.title},
                             {"Description", colophon.description},
                             {"Software", fmt::format("gradus {}", release_version)},
                             {"Copyright", std::string(figure_licence)},
                             {std::string(command_key), colophon.command}};
  if (!colophon.input_hash.empty()) texts.push_back({std::string(hash_key), colophon.input_hash});
  return texts;
}

void set_pdf_metadata(cairo_surface_t* surface, const Colophon& colophon) {
  const std::string keywords =
      fmt::format("{}[{}] {}[{}] licence[{}]", command_key, percent_encoded(colophon.command), hash_key,
                  percent_encoded(colophon.input_hash), figure_licence);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, colophon.title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, colophon.description.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_KEYWORDS, keywords.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR,
                                 fmt::format("gradus {}", release_version).c_str());
  // Fixed: the same figure is the same bytes on every day
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
}

std::optional<Colophon> colophon_in(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return colophon_in_png(bytes);
  if (bytes.starts_with("%PDF")) return colophon_in_pdf(bytes);
  return colophon_in_markup(bytes);
}

}  // namespace gradus
