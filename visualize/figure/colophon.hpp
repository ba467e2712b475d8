#pragma once
// What a figure says of itself in its file's metadata, so that it can be made again.

#include <optional>
#include <string>

namespace gradus {

inline constexpr std::string_view release_version = "0.1.0";
inline constexpr std::string_view figure_licence = "CC0-1.0";

struct Colophon {
  std::string title;        ///< "Bresenham line, step 4 of 7"
  std::string description;  ///< the caption: alt text for who can't see it
  std::string
      command;  ///< the canonical command, without output path: "gradus figure bresenham_line --from 0,0 …"
  std::string input_hash;  ///< of input files, or empty
};

}  // namespace gradus
