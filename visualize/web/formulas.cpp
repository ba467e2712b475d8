#include "web/formulas.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "figure/text/markup.hpp"
#include "web/topic_page.hpp"

namespace gradus {
namespace {

/// Two lines a formula: TeX, then MathML.
std::map<std::string_view, std::string_view> read_formulas(std::string_view text) {
  std::map<std::string_view, std::string_view> found;
  const auto next_line = [&text] {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
  };
  while (!text.empty()) {
    const std::string_view tex = next_line();
    found.emplace(tex, next_line());
  }
  return found;
}

}  // namespace

std::string_view mathml_of(std::string_view tex) {
  static const auto formulas = read_formulas(docs_text("docs/topics/formulas.txt"));
  const auto found = formulas.find(tex);
  if (found == formulas.end()) {
    throw std::logic_error(fmt::format("docs/topics/formulas.txt has no formula {}", tex));
  }
  return found->second;
}

std::string formula_in_line(std::string_view tex) {
  return fmt::format("<math alttext=\"{}\">{}</math>", escaped(tex), mathml_of(tex));
}

std::string formula_on_line(std::string_view tex) {
  return fmt::format(
      "<p class=\"formula\" tabindex=\"0\"><math display=\"block\" alttext=\"{}\">{}</math></p>\n",
      escaped(tex), mathml_of(tex));
}

}  // namespace gradus
