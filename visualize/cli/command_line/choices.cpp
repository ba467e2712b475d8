#include "cli/command_line/choices.hpp"

#include "figure/layout/layout.hpp"
#include "figure/text/wording.hpp"
#include "theme/theme.hpp"

namespace gradus::cli {

std::vector<std::string> choices_of(std::string_view flag) {
  std::vector<std::string> names;
  if (flag == "theme") {
    for (const Theme& theme : themes()) names.push_back(theme.name);
  }
  if (flag == "language") {
    for (const Language& language : languages()) names.push_back(language.code());
  }
  if (flag == "layout") return {"slide", "handout"};
  if (flag == "listing") return {"source", "pseudo"};
  if (flag == "line_numbers") return {"listing", "source", "none"};
  if (flag == "y") return {"up", "down"};
  if (flag == "numbers") return {"decimals", "fractions"};
  if (flag == "svg_text") return {"outlines", "text"};
  if (flag == "paper") return {"a4", "letter"};
  return names;
}

}  // namespace gradus::cli
