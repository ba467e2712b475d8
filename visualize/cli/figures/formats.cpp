#include "cli/figures/formats.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "request/names.hpp"

namespace gradus::cli {
namespace {

/// In the order of Format.
constexpr std::array<FormatFacts, 16> all_formats{{
    {"svg", FormatKind::picture, false, "SVG"},
    {"png", FormatKind::picture, true, "PNG"},
    {"pdf", FormatKind::document, false, "PDF, a page per step"},
    {"html", FormatKind::player, false, "player"},
    {"csv", FormatKind::text, false, "table (CSV)"},
    {"md", FormatKind::text, false, "table (Markdown)"},
    {"tex", FormatKind::text, false, "table (LaTeX)"},
    {"json", FormatKind::text, false, "data (JSON)"},
    {"txt", FormatKind::text, false, "text"},
    {"gif", FormatKind::film, true, "film (GIF)"},
    {"mp4", FormatKind::film, true, "film (MP4)"},
    {"webp", FormatKind::film, true, "film (WebP)"},
    {"pptx", FormatKind::document, false, "PowerPoint, a slide per step"},
    {"obj", FormatKind::model, false, "model (OBJ)"},
    {"ply", FormatKind::model, false, "model (PLY)"},
    {"stl", FormatKind::model, false, "model (STL)"},
}};

}  // namespace

const FormatFacts& facts_of(Format format) { return all_formats[static_cast<std::size_t>(format)]; }

std::span<const std::string> format_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const FormatFacts& facts : all_formats) all.emplace_back(facts.name);
    return all;
  }();
  return names;
}

std::optional<Format> format_by_ending(std::string_view path) {
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string_view::npos || path[dot] == '/') return std::nullopt;
  const auto found = std::ranges::find(format_names(), folded(path.substr(dot + 1)));
  if (found == format_names().end()) return std::nullopt;
  return static_cast<Format>(found - format_names().begin());
}

std::optional<Format> format_by_content(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return Format::png;
  if (bytes.starts_with("%PDF")) return Format::pdf;
  if (bytes.starts_with("GIF8")) return Format::gif;
  if (bytes.starts_with("RIFF") && bytes.size() > 8 && bytes.substr(8).starts_with("WEBP"))
    return Format::webp;
  if (bytes.size() > 8 && bytes.substr(4).starts_with("ftyp")) return Format::mp4;
  if (bytes.starts_with("PK") && bytes.find("ppt/presentation.xml") != std::string_view::npos)
    return Format::pptx;
  const std::string start = folded(bytes.substr(0, 512));
  if (start.find("<!doctype html") != std::string::npos || start.find("<html") != std::string::npos) {
    return Format::html;
  }
  if (start.find("<svg") != std::string::npos) return Format::svg;
  return std::nullopt;
}

}  // namespace gradus::cli
