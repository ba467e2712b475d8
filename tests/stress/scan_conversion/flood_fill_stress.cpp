// The promises of fills: exactly the cells that are connected with the seed, by every method, in a window, by
// tolerance, and without more questions than a fill pixel by pixel.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/contract.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "scan_conversion/flood_fill/maze.hpp"
#include "stress/scan_conversion/areas.hpp"
#include "stress/scan_conversion/pictures.hpp"
#include "stress/scan_conversion/watched_fill.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace flood_fill;

constexpr std::array methods{Method::depth_first, Method::breadth_first, Method::span};

bool is_connectivity(double x) { return x == 4 || x == 8; }
Connectivity connectivity_of(double x) { return x == 4 ? Connectivity::four : Connectivity::eight; }

/// How many cells a fill gets wrong, and by how many its count is off; wrong where it does not refuse what
/// isn't `taken`, or refuses what is.
template <class Cells, class Value, class Fill>
double fill_error(const Cells& before, bool taken, const Mask& area, std::int64_t painted, const Value& value,
                  const Fill& fill) {
  Cells cells = before;
  try {
    const Filled filled = fill(cells);
    if (!taken) return wrong;
    return static_cast<double>(std::abs(filled.painted - painted) + wrong_cells(cells, before, area, value));
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
}

// --- Rasters ---

/// Width, height, seed, connectivity, picture, new value.
constexpr std::size_t raster_numbers = 9;

Input raster_input(Kind kind, Random& random) {
  double width = whole(random, 1, 24), height = whole(random, 1, 24);
  if (kind == Kind::grazing) {
    // Round whole words
    width = 64 * whole(random, 1, 3) + whole(random, -2, 2);
    height = whole(random, 1, 6);
  } else if (kind == Kind::extremes) {
    (random.unit() < 0.5 ? width : height) = 1;
    if (random.unit() < 0.5) (width == 1 ? height : width) = whole(random, 1, 300);
  } else if (kind == Kind::refused && random.unit() < 0.3) {
    (random.unit() < 0.5 ? width : height) = 0;
  }
  const auto place = [&](double size) {
    return whole(random, 0, std::max<std::int64_t>(1, std::llround(size)) - 1);
  };
  Input input{width, height, place(width), place(height), random.unit() < 0.5 ? 4.0 : 8.0};
  const auto side = static_cast<std::size_t>(random.uniform_int(0, 1));
  if (kind == Kind::grazing) input[2 + side] = random.unit() < 0.5 ? 0 : std::max(0.0, input[side] - 1);
  if (kind == Kind::refused && width > 0 && height > 0) {
    const double outside[] = {-1, input[side], INT_MIN, INT_MAX};
    input[2 + side] = outside[random.uniform_int(0, 3)];
  }
  add_picture(input, kind, random);
  input.push_back(whole(random, 0, 2));
  return input;
}

struct RasterCase {
  Mask cells;  ///< 1 where the picture is free
  ivec2 seed;
  Connectivity connectivity;
  std::uint8_t value;
  std::uint8_t least;  ///< what is added to cells and value: bytes of any size

  /// The cells of the seed's value that are connected with it.
  Mask area() const {
    return area_of(cells.width(), cells.height(), seed, connectivity,
                   [&](ivec2 p) { return cells[p] == cells[seed]; });
  }
};
std::optional<RasterCase> raster_case(const Input& i) {
  const auto picture = picture_of(i, 5);
  if (!picture || !are_whole(i, 2, 0, 4096) || i[0] * i[1] > 8192 || !are_whole(i, 4) ||
      !is_connectivity(i[4]) || !is_whole(i[8], 0, 2)) {
    return std::nullopt;
  }
  const ivec2 size = pixel(i, 0);
  RasterCase c{{size.x, size.y},
               pixel(i, 2),
               connectivity_of(i[4]),
               static_cast<std::uint8_t>(i[8]),
               static_cast<std::uint8_t>(picture->noise % 254)};
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) c.cells[{x, y}] = picture->free({x, y});
  }
  return c;
}

/// How many cells the methods get wrong, and by how many their counts are off, on cells of one type.
template <class Cell>
double fills_error(const RasterCase& given) {
  const auto& [bytes, seed, connectivity, byte, least] = given;
  Raster<Cell> before(bytes.width(), bytes.height());
  std::ranges::transform(bytes.cells(), before.cells().begin(),
                         [&](int x) { return static_cast<Cell>(least + x); });
  const bool taken = before.contains(seed);
  const Mask area = taken ? given.area() : Mask();
  const auto value = static_cast<Cell>(least + byte);
  const std::int64_t painted = taken && before[seed] != value ? count(area) : 0;
  const auto judged = [&](auto fill) { return fill_error(before, taken, area, painted, value, fill); };
  double error = judged([&](auto& cells) { return fill_rows(cells, seed, value, connectivity); }) +
                 judged([&](auto& cells) { return fill_by_labels(cells, seed, value, connectivity); }) +
                 judged([&](auto& cells) { return fill_area(cells, seed, value, connectivity); });
  for (const Method method : methods) {
    error += judged([&](auto& cells) { return fill_raster(cells, seed, value, method, connectivity); });
  }
  return error;
}

/// Whether the stack or queue of a fill stays as small as is promised.
bool is_small(const Filled& filled, Method method, const RasterCase& c) {
  if (filled.peak_waiting > static_cast<std::size_t>(2 * filled.painted + 2)) return false;
  const auto sides = static_cast<std::size_t>(c.cells.width() + c.cells.height());
  const bool empty_canvas = filled.painted == std::int64_t{c.cells.width()} * c.cells.height();
  if (!empty_canvas || method == Method::depth_first) return true;
  if (method == Method::span) return filled.peak_waiting <= 2;
  return filled.peak_waiting <= (c.connectivity == Connectivity::four ? sides : 3 * sides);
}

/// The questions that `span` asks, in parts of those that depth_first asks, 1 + 4 (8) a painted cell; wrong
/// where a method asks or paints what it must not, or a step does not hold. What is not free is wall, or,
/// with another new value than 2, of colour q.
double steps_error(const Input& input) {
  const std::optional<RasterCase> given = raster_case(input);
  if (!given || !given->cells.contains(given->seed)) return 0;
  const auto& [cells, seed, connectivity, value, least] = *given;
  Maze maze(cells.width(), cells.height());
  const char blocked = value == 2 ? wall : 'q', ink = value == 1 ? 'q' : 'x';
  std::ranges::transform(cells.cells(), maze.cells().begin(), [&](int c) { return c ? free_cell : blocked; });
  const bool paints = maze[seed] != wall && maze[seed] != ink;
  const Mask area = paints ? given->area() : Mask(cells.width(), cells.height());
  double ratio = 0;
  for (const Method method : methods) {
    Watch watch{area, seed, connectivity};
    Mask painted(cells.width(), cells.height());
    std::int64_t asked = 0;
    const auto inside = [&](ivec2 p) {
      ++asked;
      watch.want(p == seed || has(area, p) ||
                 std::ranges::any_of(ways(connectivity), [&](ivec2 way) { return has(area, p + way); }));
      return has(area, p) && !painted[p];
    };
    const auto paint = [&](ivec2 p) {
      watch.want(has(area, p) && !painted[p]);
      painted[p] = 1;
    };
    const Filled filled = fill(method, seed, inside, paint, connectivity, watch);
    Maze after = maze;
    const bool same = fill_maze(after, seed, ink, {0, connectivity, method}) == filled;
    if (!watch.right || !watch.finished || !same || wrong_cells(after, maze, area, ink) > 0 ||
        !is_small(filled, method, *given)) {
      return wrong;
    }
    const std::int64_t by_pixels = 1 + static_cast<int>(connectivity) * filled.painted;
    if (method != Method::span && asked != by_pixels) return wrong;
    if (method == Method::span) ratio = static_cast<double>(asked) / static_cast<double>(by_pixels);
  }
  return paints ? ratio : 0;
}

/// The questions per cell that `span` asks for an area of more than 1000 cells, in parts of what is promised.
double noise_error(const Input& input) {
  const std::optional<RasterCase> given = raster_case(input);
  if (!given || !given->cells.contains(given->seed) || count(given->area()) <= 1000) return 0;
  return steps_error(input) * (given->connectivity == Connectivity::four ? 4 / 3.5 : 8 / 4.5);
}

std::vector<Trap> raster_traps() {
  return {{"the seed outside", {4, 4, 4, 0, 4, full, 1, 0, 2}},
          {"the seed before the first cell", {4, 4, -1, 0, 4, full, 1, 0, 2}},
          {"no cells", {0, 0, 0, 0, 4, full, 1, 0, 2}},
          {"one cell", {1, 1, 0, 0, 4, full, 1, 0, 2}},
          {"the new value is the old one", {5, 4, 2, 2, 4, full, 1, 0, 1}},
          {"a path through every cell", {90, 90, 0, 0, 4, full, 1, 0, 2}},
          {"one path that winds inwards", {90, 90, 0, 0, 4, spiral, 1, 0, 2}},
          {"corners alone connect", {9, 7, 4, 2, 8, checkerboard, 1, 0, 2}},
          {"corners do not connect", {9, 7, 4, 2, 4, checkerboard, 1, 0, 2}},
          {"a run ends with a word", {128, 3, 63, 1, 4, full, 1, 0, 2}},
          {"corners across two words", {130, 40, 64, 20, 8, checkerboard, 1, 0, 2}}};
}

// --- Windows ---

/// Lower and upper corner, seed, connectivity, picture.
Input window_input(Kind kind, Random& random) {
  Input input(7);
  const bool at_ends = kind == Kind::extremes || kind == Kind::refused;
  const double most = kind == Kind::refused ? INT_MAX : INT_MAX - 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const double ends[] = {INT_MIN, INT_MIN + 2.0, -8, INT_MAX - 20, INT_MAX - 2};
    input[k] = at_ends ? ends[random.uniform_int(kind == Kind::extremes ? 1 : 0, 4)] : whole(random, -30, 30);
    const std::int64_t least = kind == Kind::near_degenerate ? -1 : 0;
    input[2 + k] = std::min(input[k] + whole(random, least, 30), most);
    input[4 + k] = std::min(input[k] + whole(random, least, 12), double{INT_MAX});
  }
  input[6] = random.unit() < 0.5 ? 4 : 8;
  add_picture(input, kind, random);
  return input;
}

struct WindowCase {
  Window window;
  ivec2 seed;
  Connectivity connectivity;
  Picture picture;

  /// As in a picture cut to the window. Domain: p lies in it.
  ivec2 cut(ivec2 p) const { return p - window.lower; }
  Mask area() const {
    if (window.empty()) return {};
    return area_of(static_cast<int>(window.width()), static_cast<int>(window.height()),
                   window.contains(seed) ? cut(seed) : ivec2(-1), connectivity,
                   [&](ivec2 p) { return picture.free(window.lower + p); });
  }
};
std::optional<WindowCase> window_case(const Input& i) {
  const auto picture = picture_of(i, 7);
  if (!picture || !are_whole(i, 6) || !is_connectivity(i[6])) return std::nullopt;
  const WindowCase c{{pixel(i, 0), pixel(i, 2)}, pixel(i, 4), connectivity_of(i[6]), *picture};
  return std::max(c.window.width(), c.window.height()) > 100 ? std::nullopt : std::optional(c);
}

double window_error(const Input& input) {
  const std::optional<WindowCase> given = window_case(input);
  if (!given) return 0;
  const auto& [window, seed, connectivity, picture] = *given;
  const bool taken = window.empty() || (room.contains(window.lower) && room.contains(window.upper));
  const Mask area = taken ? given->area() : Mask();
  for (const Method method : methods) {
    Mask painted(area.width(), area.height());
    bool allowed = true;
    const auto inside = [&](ivec2 p) {
      allowed &= window.contains(p);
      return window.contains(p) && picture.free(p) && !painted[given->cut(p)];
    };
    const auto paint = [&](ivec2 p) {
      allowed &= window.contains(p);
      if (window.contains(p)) painted[given->cut(p)] = 1;
    };
    Filled filled;
    try {
      filled = in_window(method, seed, window, inside, paint, connectivity);
    } catch (const ContractViolation&) {
      if (taken) return wrong;
      continue;
    }
    if (!taken || !allowed || painted != area) return wrong;
    // The fill of the cut picture, step by step
    if (!window.contains(seed)) continue;
    Mask cut = area;
    const auto in_cut = [&](ivec2 p) { return has(cut, p); };
    if (fill(method, given->cut(seed), in_cut, [&](ivec2 p) { cut[p] = 0; }, connectivity) != filled) {
      return wrong;
    }
  }
  return 0;
}

/// Whether the seed's area goes on beyond the window.
bool is_cut(const Input& input) {
  std::optional<WindowCase> given = window_case(input);
  if (!given || given->window.empty() || !are_whole(input, 4, -100, 100)) return false;
  const std::int64_t shown = count(given->area());
  given->window = {given->window.lower - 1, given->window.upper + 1};
  return shown < count(given->area());
}

// --- Images ---

/// Width, height, seed, connectivity, tolerance, how many shades a channel has, noise, shade of the ink.
Input image_input(Kind kind, Random& random) {
  const std::int64_t width = kind == Kind::extremes ? 1 : random.uniform_int(1, 14);
  const std::int64_t height = random.uniform_int(1, 14);
  Input input{static_cast<double>(width),   static_cast<double>(height),     whole(random, 0, width - 1),
              whole(random, 0, height - 1), random.unit() < 0.5 ? 4.0 : 8.0, whole(random, 0, 12),
              whole(random, 1, 12),         whole(random, 0, 1'000'000),     whole(random, 0, 255)};
  if (kind == Kind::ties) input[8] = whole(random, 0, static_cast<std::int64_t>(input[6]));
  if (kind == Kind::near_degenerate) input[5] = 0, input[6] = whole(random, 1, 2);
  if (kind == Kind::extremes) {
    input[5] = random.unit() < 0.5 ? 255 : whole(random, 0, 255);
    input[6] = 256;
  }
  if (kind == Kind::refused) {
    const double far[] = {-1, 256, -2'000'000'000, 2'000'000'000};
    if (random.unit() < 0.5)
      input[5] = far[random.uniform_int(0, 3)];
    else
      input[2] = random.unit() < 0.5 ? -1 : static_cast<double>(width);
  }
  return input;
}

struct ImageCase {
  Image image;
  ivec2 seed;
  Connectivity connectivity;
  int tolerance;
  Rgba8 ink;

  bool taken() const { return image.contains(seed) && 0 <= tolerance && tolerance <= 255; }
  bool near_seed(Rgba8 a) const {
    const Rgba8 b = image[seed];
    const auto near = [&](int x, int y) { return std::abs(x - y) <= tolerance; };
    return near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b) && near(a.a, b.a);
  }
  bool needs_mask() const { return taken() && tolerance > 0 && near_seed(ink); }
};
std::optional<ImageCase> image_case(const Input& i) {
  if (!are_whole(i, 2, 0, 64) || !are_whole(i, 4) || !is_connectivity(i[4]) || !is_whole(i[5]) ||
      !is_whole(i[6], 1, 256) || !is_whole(i[7], 0, 1e9) || !is_whole(i[8], 0, 255)) {
    return std::nullopt;
  }
  const ivec2 size = pixel(i, 0);
  const auto ink = static_cast<std::uint8_t>(i[8]);
  ImageCase c{
      {size.x, size.y}, pixel(i, 2), connectivity_of(i[4]), static_cast<int>(i[5]), {ink, ink, ink, ink}};
  Random random(static_cast<std::uint64_t>(i[7]));
  const auto shade = [&] { return static_cast<std::uint8_t>(whole(random, 0, std::llround(i[6]) - 1)); };
  for (Rgba8& pixel : c.image.cells()) pixel = {shade(), shade(), shade(), shade()};
  return c;
}

double image_error(const Input& input) {
  const std::optional<ImageCase> given = image_case(input);
  if (!given) return 0;
  const auto& [before, seed, connectivity, tolerance, ink] = *given;
  const bool taken = given->taken();
  const Mask area = !taken ? Mask()
                           : area_of(before.width(), before.height(), seed, connectivity,
                                     [&](ivec2 p) { return given->near_seed(given->image[p]); });
  const std::int64_t painted = taken && (tolerance > 0 || before[seed] != ink) ? count(area) : 0;
  double error = 0;
  const auto judge = [&](auto fill) { error += fill_error(before, taken, area, painted, ink, fill); };
  for (const Method method : methods) {
    judge([&](Image& image) {
      const Filled filled = fill_image(image, seed, ink, {tolerance, connectivity, method});
      if ((filled.mask_bytes > 0) != given->needs_mask()) error = wrong;
      return filled;
    });
  }
  if (!taken || tolerance > 0) return error;
  judge([&](Image& image) { return fill_rows(image, seed, ink, connectivity); });
  judge([&](Image& image) { return fill_by_labels(image, seed, ink, connectivity); });
  judge([&](Image& image) { return fill_area(image, seed, ink, connectivity); });
  return error;
}

}  // namespace

Domain flood_fill() {
  // Sizes, not magnitudes, make a picture hard
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing,
                                Kind::ties,   Kind::extremes,        Kind::refused};
  Property fills{
      .name = "fills",
      .states =
          "every method paints the cells that are connected with the seed, no others, and "
          "counts them; a seed outside is refused",
      .unit = "cells",
      .bound = 0,
      .numbers = raster_numbers,
      .kinds = kinds,
      .generate = raster_input,
      .error =
          [](const Input& input) {
            const std::optional<RasterCase> given = raster_case(input);
            return given ? fills_error<std::uint8_t>(*given) + fills_error<int>(*given) : 0;
          },
      .traps = raster_traps(),
      .shares = {
          {.of = "neither one cell nor all cells are painted", .least = 0.3, .holds = [](const Input& input) {
             const std::optional<RasterCase> given = raster_case(input);
             if (!given || !given->cells.contains(given->seed)) return false;
             const std::int64_t cells = count(given->area());
             return 1 < cells && cells < std::llround(input[0] * input[1]);
           }}}};
  Property steps{.name = "steps",
                 .states =
                     "each step holds, and watching changes nothing; cells are painted once; only they "
                     "and their neighbours are asked for, by span no more often than by depth_first",
                 .unit = "of depth_first's questions",
                 .bound = 1,
                 .numbers = raster_numbers,
                 .kinds = kinds,
                 .generate = raster_input,
                 .error = steps_error,
                 .traps = raster_traps()};
  Property noise{.name = "questions_on_noise",
                 .states = "span asks at most 3.5 questions per cell, 4.5 where corners connect",
                 .unit = "of that",
                 .bound = 1,
                 .numbers = raster_numbers,
                 .kinds = {Kind::random},
                 .generate =
                     [](Kind, Random& random) {
                       const double free = random.uniform(0.55, 0.85);
                       return Input{90,
                                    90,
                                    whole(random, 30, 60),
                                    whole(random, 30, 60),
                                    random.unit() < 0.5 ? 4.0 : 8.0,
                                    full,
                                    free,
                                    whole(random, 0, 1'000'000),
                                    2};
                     },
                 .error = noise_error,
                 .cases = 100};  // of some milliseconds each
  Property windows{
      .name = "in_window",
      .states = "the fill of the picture cut to the window, which may lie anywhere",
      .unit = "cells",
      .bound = 0,
      .numbers = 10,
      .kinds = kinds,
      .generate = window_input,
      .error = window_error,
      .traps = {{"an empty window", {0, 0, -1, 5, 0, 0, 4, full, 1, 0}},
                {"the seed beside the window", {0, 0, 5, 5, 6, 0, 4, full, 1, 0}},
                {"a region that leaves the window and comes back", {0, 1, 9, 3, 0, 1, 4, upright_comb, 1, 0}},
                {"two cells from the largest integer",
                 {INT_MAX - 7, INT_MAX - 7, INT_MAX - 2, INT_MAX - 2, INT_MAX - 2, INT_MAX - 2, 8, full, 1,
                  0}},
                {"one cell from the least integer",
                 {INT_MIN + 1, 0, INT_MIN + 8, 5, INT_MIN + 8, 0, 4, full, 1, 0}}},
      .shares = {{"the window cuts the area", 0.15, is_cut}}};
  Property images{.name = "fill_image",
                  .states = "the pixels like the seed's within the tolerance, whatever the new colour",
                  .unit = "pixels",
                  .bound = 0,
                  .numbers = 9,
                  .kinds = {Kind::random, Kind::near_degenerate, Kind::ties, Kind::extremes, Kind::refused},
                  .generate = image_input,
                  .error = image_error,
                  .traps = {{"the new colour is like the old one", {8, 8, 3, 3, 4, 4, 6, 1, 2}},
                            {"everything is alike", {9, 9, 0, 0, 8, 255, 256, 1, 77}},
                            {"a tolerance below 0", {4, 4, 0, 0, 4, -1, 6, 1, 2}},
                            {"a tolerance above 255", {4, 4, 0, 0, 4, 256, 6, 1, 2}},
                            {"a click beside the picture", {4, 4, -1, 0, 4, 3, 6, 1, 2}}},
                  .shares = {{.of = "needs a mask", .least = 0.1, .holds = [](const Input& input) {
                                const std::optional<ImageCase> given = image_case(input);
                                return given && given->needs_mask();
                              }}}};
  return {"flood_fill", {fills, steps, noise, windows, images}};
}

}  // namespace gradus::stress
