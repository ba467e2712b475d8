#pragma once
// Small helpers of the pages: templates with places, text and links that stay what they are.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gradus {

/// (the name of a place, what stands there)
using Parts = std::vector<std::pair<std::string_view, std::string_view>>;

/// Puts parts into a template's {{places}}, once: a part that looks like a place stays as it is.
std::string filled(std::string_view page, const Parts& parts);

/// A relative path as a link that cannot be anything else: no scheme, no query, no way to the network.
std::string link_to(std::string_view path);

/// A chapter's name as a heading: "scan_conversion" -> "Scan conversion".
std::string heading_of(std::string_view chapter);

}  // namespace gradus
