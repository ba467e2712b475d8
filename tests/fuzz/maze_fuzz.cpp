// Mazes as text: what is read is written back as it was, what is not is told with its line.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "scan_conversion/flood_fill/maze.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = flood_fill::parse_maze(text, "maze");
  if (const auto* error = std::get_if<flood_fill::MazeError>(&read)) {
    require(error->what.starts_with("maze:" + std::to_string(error->line) + ": "), "an error names its line");
    for (const char c : error->what) require(c >= ' ' && c < 127, "an error shows no control character");
    return 0;
  }
  const flood_fill::Maze& maze = std::get<flood_fill::Maze>(read);
  std::string plain;
  for (const char c : text) {
    if (c != '\r') plain += c;
  }
  if (!plain.ends_with('\n')) plain += '\n';
  require(flood_fill::maze_text(maze) == plain, "a maze is written as it was read");
  return 0;
}
