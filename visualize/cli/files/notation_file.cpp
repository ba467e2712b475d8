#include "cli/files/notation_file.hpp"

#include <fmt/format.h>

#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/files/files.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

Notation notation_of_file(const std::string& word, const FindFile& find) {
  const FoundFile file = find(word, "--notation");
  const std::string bytes = read_input(file.path, "--notation");
  if (file.quotable) return notation_in_text(bytes, shown_name(word));
  std::vector<NotationMistake> mistakes;
  const Notation notation = notation_in(read_json(bytes, "--notation: " + shown_name(word)), mistakes);
  if (mistakes.empty()) return notation;
  refuse_flag("notation", "a notation", "another file");
}

}  // namespace

Notation read_notation(const std::string& text, const FindFile& find) {
  try {
    return is_notation_file(text) ? notation_of_file(std::string(trimmed(text)), find)
                                  : gradus::read_notation(text);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace gradus::cli
