#pragma once
// Names of students from a file.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::cli {

/// As many at most.
inline constexpr std::size_t most_students = 500;

/// A name, and in which line it stands.
struct Student {
  std::string name;
  std::size_t line = 0;
};

/// The names in a text, one per line; of a line with , or ; or a tab what stands before that, so that a table
/// (CSV) whose first column has the names will do. Names may stand in "…", with "" for a quote. Empty lines
/// count nothing, nor does a first line that is a heading: "name" or "student" in any spelling. what: the
/// flag, for errors. Throws UsageError: no name, too many, a name of more than 100 letters, with control
/// characters or marks that turn the direction of text (but for those that join letters or keep them apart),
/// no UTF-8.
std::vector<Student> students_in(std::string_view text, std::string_view what);

}  // namespace gradus::cli
