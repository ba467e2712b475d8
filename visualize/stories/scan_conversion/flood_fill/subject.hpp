#pragma once
// What the stories of fills fill: a picture, or the letters of a maze.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "core/shown.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "stories/topic.hpp"

namespace gradus::flood_fill {

struct Subject {
  std::shared_ptr<const Image> picture{};  ///< for a maze: one colour per kind of cell
  bool is_maze = false;
  Maze maze{};
  ivec2 seed;
  int tolerance;
  Connectivity connectivity;
  std::optional<Window> window;  ///< only what lies in it is filled

  const Image& image() const { return *picture; }
};

inline Rgba8 maze_color(char cell) {
  // Only equality matters to the fill: every kind of cell gets a colour of its own
  const auto code = static_cast<std::uint8_t>(cell);
  return {code, code, code, 255};
}

inline Image image_of(const Maze& maze) {
  Image image(maze.width(), maze.height());
  std::ranges::transform(maze.cells(), image.cells().begin(), maze_color);
  return image;
}

/// The maze after the fill, its rows joined by "/".
inline std::string filled_maze(const Image& image) {
  std::string rows;
  for (int y = 0; y < image.height(); ++y) {
    if (y > 0) rows += '/';
    for (const Rgba8& cell : image.row(y)) rows += static_cast<char>(cell.r);
  }
  return rows;
}

inline Maze maze_of(const Arguments::Entry& entry) {
  const std::string name = entry.hash.empty() ? "--maze" : shown_name(entry.text);
  auto parsed = parse_maze(entry.content, name, entry.quotable);
  if (const MazeError* error = std::get_if<MazeError>(&parsed)) refuse_input(error->what);
  return std::get<Maze>(std::move(parsed));
}

inline Subject subject_of(const Arguments& arguments) {
  Subject subject{
      .seed = arguments.cell("at"),
      .tolerance = static_cast<int>(arguments.integer("tolerance")),
      .connectivity = arguments.text("connectivity") == "8" ? Connectivity::eight : Connectivity::four,
      .window = arguments.window("window")};
  if (arguments.has("image") && !arguments.text("image").empty()) {
    subject.picture = arguments.entry("image").image;
    return subject;
  }
  subject.is_maze = true;
  subject.tolerance = 0;
  subject.maze = maze_of(arguments.entry("maze"));
  subject.picture = std::make_shared<const Image>(image_of(subject.maze));
  return subject;
}

inline void require_inside(const Subject& subject) {
  const Image& image = subject.image();
  if (image.contains(subject.seed)) return;
  refuse("at", "expected a pixel inside the {} × {} picture (columns 0 to {}, rows 0 to {}), found {},{}",
         image.width(), image.height(), image.width() - 1, image.height() - 1, subject.seed.x,
         subject.seed.y);
}

constexpr Rgba8 default_color{0, 0x72, 0xb2, 255};
constexpr char default_letter = 'x';

/// What pixels are painted with. A maze's walls stay; its other cells become a letter.
inline Rgba8 paint_of(const Subject& subject, const Arguments& arguments, ivec2 seed) {
  const std::string given = arguments.has("paint") ? arguments.text("paint") : "";
  const bool letter = given.size() == 1;
  if (!subject.is_maze) {
    if (letter) refuse("paint", "expected a colour for an image, found '{}'", given);
    return given.empty() ? default_color : arguments.color("paint");
  }
  if (!given.empty() && !letter) refuse("paint", "expected a letter for a maze, found a colour");
  if (subject.maze[seed] == wall) return maze_color(wall);
  return maze_color(letter ? given[0] : default_letter);
}

/// Whether the seed has its colour already.
inline bool nothing_to_do(const Subject& subject, Rgba8 color) {
  return subject.tolerance == 0 && color == subject.image()[subject.seed];
}

/// The window as far as cells can be numbered; the picture ends long before.
inline Window within_room(const Window& window) {
  return {glm::clamp(window.lower, room.lower, room.upper), glm::clamp(window.upper, room.lower, room.upper)};
}

/// The picture's fill cut to a window, by fill(inside, paint); a mask keeps what is
/// painted, with any new colour.
template <class Fill>
auto fill_masked(Image& image, const Subject& subject, Rgba8 color, const Window& window, Fill fill) {
  const Rgba8 old = image[subject.seed];
  Raster<std::uint8_t> visited(image.width(), image.height());
  const auto inside = [&](ivec2 p) {
    return window.contains(p) && image.contains(p) && !visited[p] && alike(image[p], old, subject.tolerance);
  };
  const auto paint = [&](ivec2 p) {
    visited[p] = 1;
    image[p] = color;
  };
  return fill(inside, paint);
}

}  // namespace gradus::flood_fill
