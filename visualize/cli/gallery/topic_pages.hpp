#pragma once
// The topic pages beside a gallery: what docs/topics/ says, one click from the figures.

#include <span>
#include <string>
#include <vector>

#include "stories/topic.hpp"

namespace gradus::cli {

/// A player that a topic's page leads to.
struct TopicFigure {
  const TopicEntry* topic = nullptr;
  std::string name;    ///< of the link
  std::string player;  ///< relative to the output folder
};

struct TopicPage {
  std::string path;  ///< below the output folder
  std::string html;
};

/// One page for each topic that has a page and a figure here, in the order of the first figures.
std::vector<TopicPage> topic_pages(std::span<const TopicFigure> figures);

}  // namespace gradus::cli
