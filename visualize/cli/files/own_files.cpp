#include "cli/files/own_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/files/files.hpp"
#include "core/shown.hpp"
#include "figure/colophon.hpp"

namespace gradus::cli {
namespace {

constexpr std::string_view figure_namespace = "xmlns=\"urn:gradus:figure\"";

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

std::string_view last_line(std::string_view text) {
  if (text.ends_with('\n')) text.remove_suffix(1);
  return text.substr(text.rfind('\n') + 1);
}

bool holds(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Before anything is drawn: only title and description come first.
bool is_own_svg(std::string_view text) {
  const std::size_t mark = text.find("<metadata><gradus ");
  if (mark == std::string_view::npos || !text.substr(mark).starts_with("<metadata><gradus xmlns="))
    return false;
  const std::string_view before = text.substr(0, mark);
  for (std::size_t at = before.find('<'); at < before.size(); at = before.find('<', at + 1)) {
    const std::string_view tag = before.substr(at + 1);
    const auto begins = [tag](std::string_view name) { return tag.starts_with(name); };
    if (!begins("?xml") && !begins("svg") && !begins("title") && !begins("/title") && !begins("desc") &&
        !begins("/desc")) {
      return false;
    }
  }
  return true;
}

bool is_own_page(std::string_view text) {
  const std::string_view head = text.substr(0, std::min(text.find("</head>"), text.size()));
  return text.starts_with("<!DOCTYPE html>") && holds(head, "<meta name=\"generator\" content=\"Gradus ");
}

/// Texts stand before the pixels.
bool is_own_png(std::string_view bytes) {
  return holds(bytes.substr(0, bytes.find("IDAT")), "iTXtgradus-command");
}

/// The comment ends the file.
bool is_own_zip(std::string_view bytes) {
  constexpr std::size_t longest_comment = 64;
  const std::string_view end = bytes.substr(bytes.size() - std::min(bytes.size(), longest_comment));
  return bytes.starts_with("PK") && holds(end, "Made by Gradus ");
}

/// What `gradus bench` writes.
bool is_own_report(std::string_view text) {
  return text.starts_with("{\n  \"context\": {") &&
         holds(text.substr(0, text.find("\"benchmarks\"")), "\n    \"gradus\": \"");
}

bool is_own_table(std::string_view text) {
  const std::string_view first = first_line(text), last = last_line(text);
  const bool csv = first.starts_with("number,type,line,") && first.ends_with(",sentence\r");
  const bool json =
      text.starts_with("{\n  \"topic\": \"") && holds(text.substr(0, 512), ",\n  \"method\": \"");
  const bool md = first.starts_with("| ") && last.starts_with("<!-- gradus figure ");
  const bool tex = (first == "% \\usepackage{booktabs}" || first.starts_with("\\begin{tabular}{")) &&
                   last.starts_with("% gradus figure ");
  const bool txt = holds(first, " · ") && last.starts_with("gradus figure ");
  const bool sheet = text.starts_with("\\documentclass[") && last.starts_with("% gradus worksheet ");
  const bool quiz = text.starts_with("<?xml ") && holds(text.substr(0, 4096), "\n<?gradus gradus worksheet ");
  const bool model = first.starts_with("# gradus figure ") || first.starts_with("solid gradus figure ") ||
                     (first == "ply" && holds(text.substr(0, 512), "\ncomment gradus figure "));
  return csv || json || md || tex || txt || sheet || quiz || model;
}

bool is_own_manual(std::string_view text) { return first_line(text) == manual_mark; }

}  // namespace

bool made_by_gradus(std::string_view bytes) {
  switch (format_by_content(bytes).value_or(Format::txt)) {
    case Format::svg:
      return is_own_svg(bytes);
    case Format::html:
      return is_own_page(bytes);
    case Format::png:
      return is_own_png(bytes);
    case Format::pdf:
      return holds(bytes, "gradus-command[");
    case Format::gif:
    case Format::webp:
    case Format::mp4:
      return holds(bytes, figure_namespace);
    default:
      return is_own_zip(bytes) || is_own_report(bytes) || is_own_table(bytes) || is_own_manual(bytes);
  }
}

bool is_replaceable(const std::string& path, std::string_view bytes) {
  struct stat known{};
  if (stat(path.c_str(), &known) != 0) return true;  // writing will say why, where it is not missing
  if (S_ISDIR(known.st_mode)) return false;
  if (!S_ISREG(known.st_mode) || known.st_size == 0) return true;
  try {
    const std::string there = read_input(path, "-o");
    return there == bytes || made_by_gradus(there);
  } catch (const UsageError&) {
    return false;  // nobody may look into it, or it is larger than anything made here
  }
}

std::string closing_line(std::string_view format, std::string_view command) {
  std::string line = visible(command);
  if (format == "tex") return fmt::format("% {}\n", line);
  if (format == "txt") return fmt::format("\n{}\n", line);
  // What would end the comment is written as it is where it would not
  for (std::size_t at = line.find("-->"); at != std::string::npos; at = line.find("-->", at)) {
    line.replace(at, 3, "--&gt;");
  }
  return fmt::format("\n<!-- {} -->\n", line);
}

std::string zip_comment() { return fmt::format("Made by Gradus {}", release_version); }

}  // namespace gradus::cli
