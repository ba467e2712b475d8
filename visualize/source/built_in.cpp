// The sources that the build embedded.

#include "source/plain_header.hpp"
#include "stories/topic.hpp"

namespace gradus {

// Made by the build
std::string_view inlined_text(std::string_view path);
std::span<const std::string_view> topic_headers();

namespace source {
namespace {

std::string_view text_of(std::string_view path) {
  const std::string_view text = source_text(path);
  return text.empty() ? inlined_text(path) : text;
}

}  // namespace

const Files& built_in_files() {
  static const Files files{
      {topic_headers().begin(), topic_headers().end()}, text_of, inlined_text("LICENSE")};
  return files;
}

}  // namespace source
}  // namespace gradus
