#include "cli/files/students.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "core/shown.hpp"
#include "figure/text/metrics.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

constexpr std::size_t longest_name = 100;
constexpr char32_t non_joiner = 0x200c, joiner = 0x200d;  // as Persian names and some emoji have them

/// The first field of a line.
std::string first_field(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with('"')) {
    return std::string(trimmed(line.substr(0, std::min(line.find_first_of(",;\t"), line.size()))));
  }
  std::string field;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (i + 1 == line.size() || line[i + 1] != '"') break;
      ++i;
    }
    field += line[i];
  }
  return std::string(trimmed(field));
}

bool is_heading(const std::string& field) {
  const std::string word = folded(field);
  return word == "name" || word == "names" || word == "student" || word == "students" || word == "namen";
}

void check_student(const std::string& name, std::size_t line, std::string_view what) {
  const std::u32string letters = code_points(name);
  const bool control = std::ranges::any_of(
      letters, [](char32_t c) { return is_control(c) && c != non_joiner && c != joiner; });
  const bool broken = letters.find(U'\ufffd') != std::u32string::npos;
  if (!control && !broken && letters.size() <= longest_name) return;
  throw UsageError(fmt::format("{}: expected names of up to {} letters in UTF-8, found {} in line {}", what,
                               longest_name, shown(name), line));
}

}  // namespace

std::vector<Student> students_in(std::string_view text, std::string_view what) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::vector<Student> names;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string name = first_field(line);
    if (name.empty() || (number == 1 && is_heading(name))) continue;
    check_student(name, number, what);
    names.push_back({name, number});
    if (names.size() > most_students) {
      throw UsageError(fmt::format("{}: expected at most {} students, found more", what, most_students));
    }
  }
  if (names.empty()) throw UsageError(fmt::format("{}: expected a name per line, found none", what));
  return names;
}

}  // namespace gradus::cli
