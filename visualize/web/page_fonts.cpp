#include "web/page_fonts.hpp"

#include <algorithm>
#include <iterator>

#include "cairo/web_font.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {

std::string fonts_of(const Parts& parts) {
  constexpr char32_t last_of_ascii = U'~';
  std::u32string characters;
  for (char32_t c = U' '; c <= last_of_ascii; ++c) characters += c;
  for (const auto& [name, text] : parts) {
    std::ranges::copy_if(code_points(text), std::back_inserter(characters),
                         [](char32_t c) { return c > last_of_ascii; });
  }
  return font_rules(characters);
}

}  // namespace gradus
