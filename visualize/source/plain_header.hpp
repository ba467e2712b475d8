#pragma once
// A topic as one header for somebody's own program: its algorithms and what they stand on, without observers.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gradus::source {

/// The catalogue's source files: paths from the project's root, and their texts. A path that is not among
/// them has an empty text.
struct Files {
  std::vector<std::string_view> topic_headers;
  std::function<std::string_view(std::string_view path)> text;
  std::string_view licence;
};

/// The files that the program was built from.
const Files& built_in_files();

/// The header of a topic, with its observers, as it stands in algorithms/. Empty when the topic lacks one
/// there. `topic`: its path, "clipping/liang_barsky".
std::string_view watched_header(const Files& files, std::string_view topic);

/// One header with all methods of a topic that are no exhibits and need nothing but GLM and the standard
/// library: the topic's headers and those that they include, in order of inclusion, each once, within guards
/// of its own, so that one program can include the headers of several topics. What .cpp files of core hold is
/// inline.
///
/// Domain: a topic of the catalogue that watched_header knows.
/// Errors: UsageError where observers can't be taken out of it.
/// Cost: all headers are read, some 100 ms.
std::string plain_header(const Files& files, std::string_view topic);

}  // namespace gradus::source
