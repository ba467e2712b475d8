#include "cairo/metadata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <map>
#include <span>

#include "cairo/cairo_library.hpp"
#include "cairo/colophon_markup.hpp"
#include "core/shown.hpp"
#include "figure/text/markup.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

// The same keys in every format; SVG and HTML hold them as attributes and elements, PDF in one Keywords text.
constexpr std::string_view command_key = "gradus-command", hash_key = "gradus-input-hash";

/// The character that an entity as escaped() writes it stands for; 0 for any other.
char32_t character_of(std::string_view entity) {
  static const std::map<std::string_view, char32_t> named{
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&#39;", '\''}};
  if (const auto found = named.find(entity); found != named.end()) return found->second;
  std::uint32_t code = 0;
  if (!entity.starts_with("&#x")) return 0;
  const char* end = entity.data() + entity.size() - 1;
  const auto [stopped, error] = std::from_chars(entity.data() + 3, end, code, 16);
  return error == std::errc() && stopped == end && is_control(code) ? code : 0;
}

std::string unescaped(std::string_view text) {
  constexpr std::size_t longest = 8;  // "&#x202e;"
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = text[i] == '&' ? text.substr(i, longest).find(';') + 1 : 0;
    if (const char32_t character = size == 0 ? 0 : character_of(text.substr(i, size))) {
      plain += utf8_of({&character, 1});
      i += size;
    } else {
      plain += text[i++];
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

std::string attributes_of(const Colophon& colophon) {
  return fmt::format("xmlns=\"urn:gradus:figure\" {}=\"{}\" {}=\"{}\" version=\"{}\" licence=\"{}\"",
                     command_key, escaped(colophon.command), hash_key, escaped(colophon.input_hash),
                     release_version, figure_licence);
}

/// The text of the first element of this name, with or without attributes.
std::string_view element(std::string_view text, std::string_view name) {
  const auto whole = between(text, fmt::format("<{}", name), fmt::format("</{}>", name)).value_or("");
  return whole.substr(std::min(whole.find('>'), whole.size() - 1) + 1);
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
  colophon.title = unescaped(element(text, "title"));
  colophon.description = unescaped(element(text, "desc"));
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

}  // namespace

std::string name_suffix(const Colophon& colophon) {
  std::uint32_t hash = 0x811c9dc5u;  // FNV-1a
  for (const char c : colophon.title + '\n' + colophon.description + '\n' + colophon.command) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193u;
  }
  return fmt::format("{:08x}", hash);
}

std::string markup_of(const Colophon& colophon) {
  return fmt::format("<gradus {}><title>{}</title><desc>{}</desc></gradus>", attributes_of(colophon),
                     escaped(colophon.title), escaped(colophon.description));
}

std::string svg_head(const Colophon& colophon, const std::string& suffix) {
  return fmt::format(
      "<title id=\"title-{0}\">{1}</title>\n<desc id=\"desc-{0}\">{2}</desc>\n"
      "<metadata><gradus {3}/></metadata>\n",
      suffix, escaped(colophon.title), escaped(colophon.description), attributes_of(colophon));
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
  cairo().pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, colophon.title.c_str());
  cairo().pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, colophon.description.c_str());
  cairo().pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_KEYWORDS, keywords.c_str());
  cairo().pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR,
                                   fmt::format("gradus {}", release_version).c_str());
  // Fixed: the same figure is the same bytes on every day
  cairo().pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
}

std::optional<Colophon> colophon_in(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return colophon_in_png(bytes);
  if (bytes.starts_with("%PDF")) return colophon_in_pdf(bytes);
  return colophon_in_markup(bytes);
}

}  // namespace gradus
