#pragma once
// The colours that have names.

#include <string>
#include <vector>

namespace gradus {

/// The sixteen basic colours of CSS, which parameters of type color take by name.
std::vector<std::string> color_names();

}  // namespace gradus
