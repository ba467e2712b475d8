// Fills: all methods against each other and a union-find, in mazes and in images with a tolerance.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/image.hpp"
#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using namespace gradus::flood_fill;
using gradus::test::require;

namespace {

constexpr Method methods[]{Method::depth_first, Method::breadth_first, Method::span};

/// Every cell's component is named by its smallest index; cells are joined when they are equal.
std::vector<int> components(const Maze& maze, Connectivity connectivity) {
  std::vector<int> parent(maze.cells().size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  const auto index = [&](ivec2 p) { return p.y * maze.width() + p.x; };
  for (int y = 0; y < maze.height(); ++y) {
    for (int x = 0; x < maze.width(); ++x) {
      const ivec2 p{x, y};
      for (const ivec2 way : {ivec2{-1, 0}, ivec2{0, -1}, ivec2{-1, -1}, ivec2{1, -1}}) {
        if (way.x != 0 && way.y != 0 && connectivity == Connectivity::four) continue;
        const ivec2 q = p + way;
        if (!maze.contains(q) || maze[p] != maze[q]) continue;
        const int a = find(index(p)), b = find(index(q));
        parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = find(static_cast<int>(i));
  return parent;
}

/// Cells round `from` of which `alike` says yes, as a maze of x.
void in_maze(const Maze& maze, ivec2 from, Connectivity connectivity) {
  Maze expected = maze;
  const auto label = components(maze, connectivity);
  const int wanted = label[static_cast<std::size_t>(from.y * maze.width() + from.x)];
  std::int64_t count = 0;
  const bool paints = maze[from] != wall && maze[from] != 'x';
  for (std::size_t i = 0; i < label.size() && paints; ++i) {
    if (label[i] == wanted) expected.cells()[i] = 'x', ++count;
  }
  for (const Method method : methods) {
    Maze filled = maze;
    const Filled done = fill_maze(filled, from, 'x', {.connectivity = connectivity, .method = method});
    require(filled == expected && done.painted == count, "a fill paints the component");
  }
  Maze fast = maze;
  if (maze[from] == wall) return;
  require(fill_rows(fast, from, 'x', connectivity).painted == count && fast == expected,
          "the fast fill paints the component");
  Maze labelled = maze;
  require(fill_by_labels(labelled, from, 'x', connectivity).painted == count && labelled == expected,
          "the fill by labels paints the component");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const int width = 1 + input.below(40), height = 1 + input.below(24);
  const ivec2 from{input.below(width), input.below(height)};
  const Connectivity connectivity = input.coin() ? Connectivity::four : Connectivity::eight;
  const int tolerance = input.below(12);
  const int kind = input.below(3);
  const ivec2 low{input.below(width), input.below(height)}, high{input.below(width), input.below(height)};
  Maze maze(width, height, wall);
  Image image(width, height);
  int bits = 0, byte = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (bits == 0) byte = input.byte(), bits = 8;
      --bits;
      const bool set = (byte >> bits) & 1;
      maze[{x, y}] = set ? free_cell : kind == 1 && (x + y) % 3 == 0 ? 'q' : wall;
      image[{x, y}] = {static_cast<std::uint8_t>(100 + (set ? (byte & 7) : 0)), 100,
                       static_cast<std::uint8_t>(kind == 2 ? 100 + bits : 100), 255};
    }
  }
  in_maze(maze, from, connectivity);

  // Images: each method gives the same, and it is what the tolerance says
  Maze alike_cells(width, height, wall);
  for (std::size_t i = 0; i < image.cells().size(); ++i) {
    if (alike(image.cells()[i], image[from], tolerance)) alike_cells.cells()[i] = free_cell;
  }
  const Rgba8 ink{103, 100, 100, 255};
  const bool nothing = tolerance == 0 && image[from] == ink;
  const std::int64_t count =
      nothing ? 0 : fill_maze(alike_cells, from, 'x', {.connectivity = connectivity}).painted;
  for (const Method method : methods) {
    Image filled = image;
    require(fill_image(filled, from, ink, {tolerance, connectivity, method}).painted == count,
            "an image's fill counts");
    for (std::size_t i = 0; i < image.cells().size(); ++i) {
      const bool in = !nothing && alike_cells.cells()[i] == 'x';
      require(filled.cells()[i] == (in ? ink : image.cells()[i]), "an image's fill paints what is alike");
    }
  }
  // A window is the fill of the cut picture
  const Window window = window_around(low, high);
  if (!window.contains(from) || maze[from] != free_cell) return 0;
  Maze cut(static_cast<int>(window.width()), static_cast<int>(window.height()), wall);
  for (int y = 0; y < cut.height(); ++y) {
    for (int x = 0; x < cut.width(); ++x) cut[{x, y}] = maze[window.lower + ivec2{x, y}];
  }
  Maze filled = maze;
  const auto inside = [&](ivec2 p) {
    require(window.contains(p), "nothing is asked outside of the window");
    return filled[p] == free_cell;
  };
  const Method method = methods[tolerance % 3];
  const Filled wanted =
      fill_maze(cut, from - window.lower, 'x', {.connectivity = connectivity, .method = method});
  const Filled done =
      in_window(method, from, window, inside, [&](ivec2 p) { filled[p] = 'x'; }, connectivity);
  require(done == wanted, "a window is the fill of the cut picture");
  return 0;
}
