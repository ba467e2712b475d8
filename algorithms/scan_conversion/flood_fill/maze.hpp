#pragma once
// Mazes as text: a picture for a fill that fits into a source file or a terminal.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/raster.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"

namespace gradus::flood_fill {

/// One character per cell: `#` wall, `.` free, a letter (A-Z, a-z) is a colour. Row 0 is the first line.
using Maze = Raster<char>;

inline constexpr char wall = '#';
inline constexpr char free_cell = '.';

constexpr bool is_color(char cell) { return ('A' <= cell && cell <= 'Z') || ('a' <= cell && cell <= 'z'); }
constexpr bool is_maze_cell(char cell) { return cell == wall || cell == free_cell || is_color(cell); }

/// What is wrong with a maze's text.
struct MazeError {
  int line;          ///< from 1
  std::string what;  ///< "name:line: what was found, what was expected"
};

/// How any character is shown in a message.
inline std::string shown(char cell) {
  const auto code = static_cast<unsigned char>(cell);
  if (code > ' ' && code < 127) return {'\'', cell, '\''};
  if (cell == ' ') return "a space";
  if (cell == '\t') return "a tab";
  return "the byte " + std::to_string(code);
}

/// Reads a maze: one row per line, all lines equally long. `name` is how errors call the text; `quotable`:
/// whether they may show what stands in it.
///
/// Domain: any bytes. Lines end with LF or CRLF; the last one may lack its end.
/// Errors: gives a MazeError (throws nothing) for an empty text, an empty line, a line of another length
///   than the first, or a character that is no cell.
/// Cost: O(length).
inline std::variant<Maze, MazeError> parse_maze(std::string_view text, std::string_view name,
                                                bool quotable = true) {
  const auto error = [&](int line, const std::string& what) {
    return MazeError{line, std::string(name) + ":" + std::to_string(line) + ": " + what};
  };
  Maze maze;
  std::string cells;
  std::size_t width = 0;
  int rows = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++rows;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (is_maze_cell(line[i])) continue;
      const std::string found = quotable ? shown(line[i]) : "something else";
      return error(rows, "found " + found + " in column " + std::to_string(i) +
                             ", expected # (wall), . (free) or a letter (colour)");
    }
    if (line.empty()) return error(rows, "found an empty line, expected a row of # . and letters");
    if (rows == 1) width = line.size();
    if (line.size() != width) {
      return error(rows, "found " + std::to_string(line.size()) + " cells, expected " +
                             std::to_string(width) + " as in the first line");
    }
    cells += line;
  }
  if (rows == 0) return error(1, "found nothing, expected rows of # (wall), . (free) and letters (colours)");
  maze = Maze(static_cast<int>(width), rows);
  std::copy(cells.begin(), cells.end(), maze.cells().begin());
  return maze;
}

/// The maze as text, every row with its end of line: parse_maze's inverse.
inline std::string maze_text(const Maze& maze) {
  std::string text;
  for (int y = 0; y < maze.height(); ++y) {
    const auto row = maze.row(y);
    text.append(row.begin(), row.end());
    text += '\n';
  }
  return text;
}

/// Fills the region of the maze that a cell belongs to, free or of one colour, with a colour.
///
/// seed: column, row from the top left. color: a letter.
///
/// Domain: a seed on a wall, or of the colour already, paints nothing.
/// Steps: those of the method.
/// Accuracy, Cost: as fill_raster.
/// Errors: ContractViolation when the seed lies outside the maze or the colour is no letter.
template <FillObserver O = Unobserved>
Filled fill_maze(Maze& maze, ivec2 seed, char color, const Options& options = {}, O&& observer = {}) {
  expects(is_color(color), "a maze is filled with a letter, not {}", shown(color));
  expects(maze.contains(seed),
          "the seed {},{} lies outside the maze of {} x {} cells (columns 0 to {}, rows 0 to {})", seed.x,
          seed.y, maze.width(), maze.height(), maze.width() - 1, maze.height() - 1);
  const char value = maze[seed] == wall ? wall : color;
  return fill_raster(maze, seed, value, options.method, options.connectivity, observer);
}

}  // namespace gradus::flood_fill
