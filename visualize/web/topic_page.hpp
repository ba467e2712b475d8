#pragma once
// The page of a topic (docs/topics/<chapter>/<name>.md) as HTML: one file, figures and sources in it.

#include <span>
#include <string>
#include <string_view>

#include "stories/topic.hpp"

namespace gradus {

/// docs/errata.md, or a file of docs/topics/ or docs/benchmarks/, as the build saw it, by its path from the
/// project's root: "docs/topics/scan_conversion/flood_fill.md". Empty when there is none.
std::string_view docs_text(std::string_view path);

struct Link {
  std::string name;
  std::string path;  ///< relative to the output folder, where index.html is
};

/// Where the topic's page goes, below the output folder: "topics/scan_conversion/flood_fill.html". Empty for
/// a topic without a page.
std::string topic_page_path(const TopicEntry& topic);

/// Loads what makes pages. Throws std::runtime_error where that is missing: to be asked before the first file
/// is written.
void load_page_maker();

/// The page. `figures` are the players of the topic. Pictures become part of the page; links lead to other
/// topics' pages and into the sources at its end; what is not there is named instead of linked.
std::string topic_page(const TopicEntry& topic, std::span<const Link> figures);

/// A single line of Markdown: code, emphasis and links without a paragraph around them. What looks like HTML
/// is text.
std::string html_of_line(std::string_view markdown);

}  // namespace gradus
