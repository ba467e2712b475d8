#pragma once
// The page's own source files (visualize/web/page/), put into the program by the build.

#include <string_view>

namespace gradus {

/// The text of a file of visualize/web/page/ by its name: "player.js". Empty when there is none.
std::string_view web_asset(std::string_view name);

/// The same of visualize/web/workbench/.
std::string_view workbench_asset(std::string_view name);

}  // namespace gradus
