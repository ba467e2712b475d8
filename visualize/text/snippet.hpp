#pragma once
// The lines that put figures into a lecture: for Beamer, reveal.js and Markdown.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gradus {

enum class SnippetKind : std::uint8_t { beamer, reveal, markdown };
inline constexpr std::string_view snippet_names[] = {"beamer", "reveal", "markdown"};

/// A step as it lies in a file.
struct SnippetStep {
  std::string path;  ///< relative to the lecture
  int page = 0;      ///< in a PDF: from 1; else 0
  std::string alt;   ///< what it shows, for who can't see it
};

struct SnippetFigure {
  std::string ending;  ///< the files' format: "pdf", "svg", "png", "html", "gif", "webp", "mp4"
  std::string title;   ///< of the slide
  bool titled = true;  ///< the figures show their own title, so that the slide needs none
  std::vector<SnippetStep> steps;
};

/// The formats that this kind of lecture can show.
std::vector<std::string_view> snippet_formats(SnippetKind kind);

/// The lines to paste: one slide that shows the steps one after the other (Markdown: one below the other).
/// Domain: a format of snippet_formats(kind), at least one step.
std::string snippet_of(SnippetKind kind, const SnippetFigure& figure);

}  // namespace gradus
