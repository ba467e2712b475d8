#pragma once
// Letters of keywords and endings, which some programs write large.

#include <string>
#include <string_view>

namespace gradus::pipeline {

/// The text with the letters A to Z small.
inline std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

}  // namespace gradus::pipeline
