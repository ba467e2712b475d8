#pragma once
// A page to read: contents beside the text, light and dark; what topic pages and the page of errata share.

#include <string>
#include <string_view>
#include <vector>

namespace gradus {

/// The parts of such a page, as HTML.
struct Article {
  std::string title, summary;
  std::string trail;     ///< the way back: a link to all figures, and where among them this is
  std::string contents;  ///< items of a list
  std::string body;
  std::vector<std::string_view> styles, scripts;  ///< files of visualize/web/page/ besides the common ones
};

std::string page_of(const Article& article);

}  // namespace gradus
