#include "cli/gallery/topic_pages.hpp"

#include <algorithm>

#include "web/topic_page.hpp"

namespace gradus::cli {

std::vector<TopicPage> topic_pages(std::span<const TopicFigure> figures) {
  std::vector<const TopicEntry*> topics;
  for (const TopicFigure& figure : figures) {
    if (std::ranges::find(topics, figure.topic) == topics.end()) topics.push_back(figure.topic);
  }
  std::vector<TopicPage> pages;
  for (const TopicEntry* topic : topics) {
    const std::string path = topic_page_path(*topic);
    if (path.empty()) continue;
    std::vector<Link> players;
    for (const TopicFigure& figure : figures) {
      if (figure.topic == topic) players.push_back({figure.name, figure.player});
    }
    pages.push_back({path, topic_page(*topic, players)});
  }
  return pages;
}

}  // namespace gradus::cli
