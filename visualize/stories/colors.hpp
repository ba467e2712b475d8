#pragma once
// Colours as people write them.

#include <string>
#include <string_view>
#include <vector>

namespace gradus {

/// The sixteen basic colours of CSS, which parameters of type color take by name.
std::vector<std::string> color_names();

/// "#rgb" and "#rrggbb" as "#rrggbb", small letters taken alone; "" for anything else.
std::string hex_color(std::string_view text);

}  // namespace gradus
