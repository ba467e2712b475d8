#pragma once
// What is the same in every presentation (visualize/office/parts/), put into the program by the build.

#include <string_view>

namespace gradus {

/// The text of a file of visualize/office/parts/ by its name: "theme.xml". Empty when there is none.
std::string_view office_part(std::string_view name);

}  // namespace gradus
