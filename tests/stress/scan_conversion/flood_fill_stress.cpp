// The promises of fills: exactly the cells that hang together with the seed, by every method, in a window, by
// tolerance, and without more questions than a fill pixel by pixel.
//
// A picture is a few numbers: its size, a pattern, how much of the pattern is kept, and the number of the
// noise. Whether a cell is free depends on these and on its place alone, so that a smaller picture is a
// corner of the larger one.

#include "scan_conversion/flood_fill/flood_fill.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/contract.hpp"
#include "scan_conversion/flood_fill/flood_fill_batch.hpp"
#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

using flood_fill::Connectivity;
using flood_fill::Filled;
using flood_fill::Method;

constexpr std::array methods{Method::depth_first, Method::breadth_first, Method::span};
constexpr std::int64_t lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();

// --- Pictures ---

/// What a picture is made of where nothing is left to chance.
enum Pattern { full, checkerboard, upright_comb, level_comb, rings, maze, patterns };

/// What is drawn, wherever it is looked at.
struct Picture {
  int pattern = full;
  double kept = 1;  ///< the share of cells that are as the pattern says
  std::uint64_t noise = 0;

  bool free(ivec2 p) const {
    const auto bits = static_cast<std::uint64_t>(p.y) << 32 ^ static_cast<std::uint32_t>(p.x);
    return of_pattern(p) == (Random(noise).unit_at(bits) < kept);
  }

 private:
  bool of_pattern(ivec2 p) const {
    // The lowest bit, of negative numbers too
    const int x = p.x & 1, y = p.y & 1;
    switch (pattern) {
      case checkerboard:
        return x == y;
      case upright_comb:
        return x == 0 || p.y % 16 == 0;
      case level_comb:
        return y == 0 || p.x % 64 == 0;
      case rings:
        return (std::max(std::abs(p.x % 32 - 16), std::abs(p.y % 32 - 16)) & 1) == 0;
      case maze: {
        // From each room a door to the right or down
        if (x == y) return x == 1;
        const ivec2 room = p - (x == 0 ? ivec2(1, 0) : ivec2(0, 1));
        const auto bits = static_cast<std::uint64_t>(room.y) << 32 ^ static_cast<std::uint32_t>(room.x);
        return (Random(noise, 1).unit_at(bits) < 0.5) == (x == 0);
      }
      default:
        return true;
    }
  }
};

bool is_whole(double x, double least, double most) { return x == std::floor(x) && least <= x && x <= most; }

/// The three numbers from `first` on, if they are a picture's.
std::optional<Picture> picture_of(const Input& i, std::size_t first) {
  if (!is_whole(i[first], 0, patterns - 1) || !(0 <= i[first + 1] && i[first + 1] <= 1) ||
      !is_whole(i[first + 2], 0, 1e9)) {
    return std::nullopt;
  }
  return Picture{static_cast<int>(i[first]), i[first + 1], static_cast<std::uint64_t>(i[first + 2])};
}
void add_picture(Input& input, Kind kind, Random& random) {
  input.push_back(kind == Kind::random ? 0 : static_cast<double>(random.uniform_int(0, patterns - 1)));
  const double all = kind == Kind::ties || random.unit() < 0.2 ? 1 : random.unit();
  input.push_back(kind == Kind::near_degenerate ? 1 - 0.02 * random.unit() : all);
  input.push_back(static_cast<double>(random.uniform_int(0, 1'000'000)));
}

/// Cells next to each other.
std::vector<ivec2> around(ivec2 p, Connectivity connectivity) {
  std::vector<ivec2> all;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const bool beside = (x == 0) != (y == 0), corner = x != 0 && y != 0;
      if (beside || (corner && connectivity == Connectivity::eight)) all.push_back(p + ivec2(x, y));
    }
  }
  return all;
}

/// What hangs together with a cell, by the definition: sweeps over all cells until none is added.
template <class Alike>
Raster<std::uint8_t> connected(int width, int height, ivec2 seed, Connectivity connectivity, Alike alike) {
  Raster<std::uint8_t> reached(width, height);
  if (!reached.contains(seed) || !alike(seed)) return reached;
  reached[seed] = 1;
  const auto reach = [&](ivec2 p) {
    if (reached[p] || !alike(p)) return false;
    for (const ivec2 q : around(p, connectivity)) {
      if (reached.contains(q) && reached[q]) {
        reached[p] = 1;
        return true;
      }
    }
    return false;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) changed |= reach({x, y});
    }
    for (int y = height - 1; y >= 0; --y) {
      for (int x = width - 1; x >= 0; --x) changed |= reach({x, y});
    }
  }
  return reached;
}

std::int64_t count(const Raster<std::uint8_t>& cells) {
  return std::count(cells.cells().begin(), cells.cells().end(), 1);
}

// --- Rasters ---

/// Width, height, seed, connectivity, picture, new value.
constexpr std::size_t raster_numbers = 9;

Input raster_input(Kind kind, Random& random) {
  const auto whole = [&](std::int64_t least, std::int64_t most) {
    return static_cast<double>(random.uniform_int(least, most));
  };
  double width = whole(1, 24), height = whole(1, 24);
  if (kind == Kind::grazing) {
    // Round whole words
    width = 64 * whole(1, 3) + whole(-2, 2);
    height = whole(1, 6);
  } else if (kind == Kind::extremes) {
    (random.unit() < 0.5 ? width : height) = 1;
    if (random.unit() < 0.5) (width == 1 ? height : width) = whole(1, 300);
  } else if (kind == Kind::refused && random.unit() < 0.3) {
    (random.unit() < 0.5 ? width : height) = 0;
  }
  const auto place = [&](double size) { return whole(0, std::max<std::int64_t>(1, std::llround(size)) - 1); };
  Input input{width, height, place(width), place(height), random.unit() < 0.5 ? 4.0 : 8.0};
  const auto side = static_cast<std::size_t>(random.uniform_int(0, 1));
  if (kind == Kind::grazing) input[2 + side] = random.unit() < 0.5 ? 0 : std::max(0.0, input[side] - 1);
  if (kind == Kind::refused && width > 0 && height > 0) {
    const double outside[] = {-1, input[side], static_cast<double>(lowest), static_cast<double>(highest)};
    input[2 + side] = outside[random.uniform_int(0, 3)];
  }
  add_picture(input, kind, random);
  input.push_back(whole(0, 2));
  return input;
}

struct RasterCase {
  Raster<std::uint8_t> cells;
  ivec2 seed;
  Connectivity connectivity;
  std::uint8_t value;
};
std::optional<RasterCase> raster_case(const Input& i) {
  const auto picture = picture_of(i, 5);
  if (!picture || !is_whole(i[0], 0, 4096) || !is_whole(i[1], 0, 4096) || i[0] * i[1] > 8192 ||
      !is_whole(i[2], static_cast<double>(lowest), static_cast<double>(highest)) ||
      !is_whole(i[3], static_cast<double>(lowest), static_cast<double>(highest)) ||
      (i[4] != 4 && i[4] != 8) || !is_whole(i[8], 0, 2)) {
    return std::nullopt;
  }
  RasterCase c{Raster<std::uint8_t>(static_cast<int>(i[0]), static_cast<int>(i[1])),
               {static_cast<int>(i[2]), static_cast<int>(i[3])},
               i[4] == 4 ? Connectivity::four : Connectivity::eight,
               static_cast<std::uint8_t>(i[8])};
  for (int y = 0; y < c.cells.height(); ++y) {
    for (int x = 0; x < c.cells.width(); ++x) c.cells[{x, y}] = picture->free({x, y});
  }
  return c;
}

/// How many cells are wrong after a fill, and by how many its count is.
template <class Fill>
double raster_error(const Input& input, Fill fill) {
  const std::optional<RasterCase> given = raster_case(input);
  if (!given) return 0;
  auto [cells, seed, connectivity, value] = *given;
  const bool taken = cells.contains(seed);
  Filled filled;
  try {
    filled = fill(cells, seed, value, connectivity);
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken) return wrong;
  const Raster<std::uint8_t>& before = given->cells;
  const std::uint8_t old = before[seed];
  const auto right =
      connected(cells.width(), cells.height(), seed, connectivity, [&](ivec2 p) { return before[p] == old; });
  const std::int64_t painted = old == value ? 0 : count(right);
  auto error = static_cast<double>(std::abs(filled.painted - painted));
  for (std::size_t i = 0; i < right.cells().size(); ++i) {
    error += cells.cells()[i] != (right.cells()[i] ? value : before.cells()[i]);
  }
  return error;
}

/// The questions that `span` asks, in parts of those that depth_first asks, 1 + 4 (8) a painted cell; wrong
/// where a method asks or paints what it must not. Beyond the raster nothing is free.
double questions_error(const Input& input) {
  const std::optional<RasterCase> given = raster_case(input);
  if (!given) return 0;
  const auto& [cells, seed, connectivity, value] = *given;
  const auto is_free = [&](ivec2 p) { return cells.contains(p) && cells[p] == 1; };
  const auto right = connected(cells.width(), cells.height(), seed, connectivity, is_free);
  const auto is_right = [&](ivec2 p) { return right.contains(p) && right[p]; };
  double ratio = 0;
  for (const Method method : methods) {
    Raster<std::uint8_t> painted(cells.width(), cells.height());
    std::int64_t asked = 0;
    bool allowed = true;
    const auto inside = [&](ivec2 p) {
      ++asked;
      const auto near = around(p, connectivity);
      allowed &= p == seed || is_right(p) || std::any_of(near.begin(), near.end(), is_right);
      return is_free(p) && !painted[p];
    };
    const auto paint = [&](ivec2 p) {
      allowed &= is_right(p) && !painted[p];
      painted[p] = 1;
    };
    const Filled filled = flood_fill::fill(method, seed, inside, paint, connectivity);
    if (!allowed || painted != right || filled.painted != count(right)) return wrong;
    const std::int64_t by_pixels = 1 + static_cast<int>(connectivity) * filled.painted;
    if (method != Method::span && asked != by_pixels) return wrong;
    if (method == Method::span) ratio = static_cast<double>(asked) / static_cast<double>(by_pixels);
  }
  return is_right(seed) ? ratio : 0;
}

std::vector<Trap> raster_traps() {
  return {{"the seed outside", {4, 4, 4, 0, 4, full, 1, 0, 2}},
          {"the seed before the first cell", {4, 4, -1, 0, 4, full, 1, 0, 2}},
          {"no cells", {0, 0, 0, 0, 4, full, 1, 0, 2}},
          {"one cell", {1, 1, 0, 0, 4, full, 1, 0, 2}},
          {"the new value is the old one", {5, 4, 2, 2, 4, full, 1, 0, 1}},
          {"a path through every cell", {90, 90, 0, 0, 4, full, 1, 0, 2}},
          {"corners alone connect", {9, 7, 4, 2, 8, checkerboard, 1, 0, 2}},
          {"corners do not connect", {9, 7, 4, 2, 4, checkerboard, 1, 0, 2}},
          {"a run ends with a word", {128, 3, 63, 1, 4, full, 1, 0, 2}},
          {"corners across two words", {130, 40, 64, 20, 8, checkerboard, 1, 0, 2}}};
}

// --- Windows ---

/// Lower and upper corner, seed, connectivity, picture.
Input window_input(Kind kind, Random& random) {
  const auto whole = [&](std::int64_t least, std::int64_t most) {
    return static_cast<double>(random.uniform_int(least, most));
  };
  Input input(7);
  for (std::size_t k = 0; k < 2; ++k) {
    const double ends[] = {static_cast<double>(lowest), static_cast<double>(lowest) + 2, -8,
                           static_cast<double>(highest) - 20, static_cast<double>(highest) - 2};
    input[k] =
        kind == Kind::extremes || kind == Kind::refused ? ends[random.uniform_int(0, 4)] : whole(-30, 30);
    if (kind == Kind::extremes && input[k] < -100) input[k] = ends[1];
    const double most = static_cast<double>(highest) - (kind == Kind::refused ? 0 : 2);
    input[2 + k] = std::min(input[k] + whole(kind == Kind::near_degenerate ? -1 : 0, 20), most);
    input[4 + k] = std::clamp(input[k] + whole(kind == Kind::near_degenerate ? -1 : 0, 12),
                              static_cast<double>(lowest), static_cast<double>(highest));
  }
  input[6] = random.unit() < 0.5 ? 4 : 8;
  add_picture(input, kind, random);
  return input;
}

double window_error(const Input& i) {
  const auto picture = picture_of(i, 7);
  const auto fits = [](double x) {
    return is_whole(x, static_cast<double>(lowest), static_cast<double>(highest));
  };
  if (!picture || !std::all_of(i.begin(), i.begin() + 6, fits) || (i[6] != 4 && i[6] != 8)) return 0;
  const Window window{{static_cast<int>(i[0]), static_cast<int>(i[1])},
                      {static_cast<int>(i[2]), static_cast<int>(i[3])}};
  const ivec2 seed{static_cast<int>(i[4]), static_cast<int>(i[5])};
  const Connectivity connectivity = i[6] == 4 ? Connectivity::four : Connectivity::eight;
  const double width = std::max(0.0, i[2] - i[0] + 1), height = std::max(0.0, i[3] - i[1] + 1);
  if (width > 100 || height > 100) return 0;
  const bool empty = width == 0 || height == 0;
  const double first = static_cast<double>(lowest) + 2, last = static_cast<double>(highest) - 2;
  const bool taken = empty || (i[0] >= first && i[1] >= first && i[2] <= last && i[3] <= last);
  // The picture cut to the window, as a raster of its own
  const auto column = static_cast<int>(empty ? 0 : width), row = static_cast<int>(empty ? 0 : height);
  Raster<std::uint8_t> painted(column, row);
  const auto at = [&](ivec2 p) {
    return ivec2{static_cast<int>(std::int64_t{p.x} - window.lower.x),
                 static_cast<int>(std::int64_t{p.y} - window.lower.y)};
  };
  const bool hit = window.contains(seed);
  const auto right = connected(column, row, hit && taken ? at(seed) : ivec2(-1), connectivity,
                               [&](ivec2 p) { return picture->free(window.lower + p); });
  double error = 0;
  for (const Method method : methods) {
    painted = Raster<std::uint8_t>(column, row);
    bool allowed = true;
    const auto inside = [&](ivec2 p) {
      allowed &= window.contains(p);
      return window.contains(p) && picture->free(p) && !painted[at(p)];
    };
    const auto paint = [&](ivec2 p) {
      allowed &= window.contains(p);
      if (window.contains(p)) painted[at(p)] = 1;
    };
    try {
      const Filled filled = flood_fill::in_window(method, seed, window, inside, paint, connectivity);
      if (!taken || !allowed || filled.painted != count(right)) return wrong;
    } catch (const ContractViolation&) {
      if (taken) return wrong;
      continue;
    }
    for (std::size_t k = 0; k < right.cells().size(); ++k) error += right.cells()[k] != painted.cells()[k];
  }
  return error;
}

// --- Images ---

/// Width, height, seed, connectivity, tolerance, how many shades a channel has, noise, shade of the ink.
Input image_input(Kind kind, Random& random) {
  const auto whole = [&](std::int64_t least, std::int64_t most) {
    return static_cast<double>(random.uniform_int(least, most));
  };
  const double width = kind == Kind::extremes ? 1 : whole(1, 14), height = whole(1, 14);
  Input input{width,
              height,
              whole(0, static_cast<std::int64_t>(width) - 1),
              whole(0, static_cast<std::int64_t>(height) - 1),
              random.unit() < 0.5 ? 4.0 : 8.0,
              whole(0, 12),
              whole(1, 12),
              whole(0, 1'000'000),
              whole(0, 255)};
  if (kind == Kind::ties) input[8] = whole(0, static_cast<std::int64_t>(input[6]));
  if (kind == Kind::extremes) {
    input[5] = random.unit() < 0.5 ? 255 : whole(0, 255);
    input[6] = 256;
  }
  if (kind == Kind::refused) {
    const double far[] = {-1, 256, -2'000'000'000, 2'000'000'000};
    if (random.unit() < 0.5)
      input[5] = far[random.uniform_int(0, 3)];
    else
      input[2] = random.unit() < 0.5 ? -1 : width;
  }
  return input;
}

double image_error(const Input& i) {
  if (!is_whole(i[0], 0, 64) || !is_whole(i[1], 0, 64) || !is_whole(i[2], -1000, 1000) ||
      !is_whole(i[3], -1000, 1000) || (i[4] != 4 && i[4] != 8) ||
      !is_whole(i[5], static_cast<double>(lowest), static_cast<double>(highest)) || !is_whole(i[6], 1, 256) ||
      !is_whole(i[7], 0, 1e9) || !is_whole(i[8], 0, 255)) {
    return 0;
  }
  Image before(static_cast<int>(i[0]), static_cast<int>(i[1]));
  Random random(static_cast<std::uint64_t>(i[7]));
  const auto shades = static_cast<std::int64_t>(i[6]);
  for (Rgba8& pixel : before.cells()) {
    const auto shade = [&] { return static_cast<std::uint8_t>(random.uniform_int(0, shades - 1)); };
    pixel = {shade(), shade(), shade(), shade()};
  }
  const auto ink_shade = static_cast<std::uint8_t>(i[8]);
  const Rgba8 ink{ink_shade, ink_shade, ink_shade, ink_shade};
  const ivec2 seed{static_cast<int>(i[2]), static_cast<int>(i[3])};
  const Connectivity connectivity = i[4] == 4 ? Connectivity::four : Connectivity::eight;
  const int tolerance = static_cast<int>(i[5]);
  const bool taken = before.contains(seed) && 0 <= tolerance && tolerance <= 255;
  Raster<std::uint8_t> right;
  if (taken) {
    const Rgba8 old = before[seed];
    const auto near = [&](std::uint8_t a, std::uint8_t b) {
      return std::max(a, b) - std::min(a, b) <= tolerance;
    };
    right = connected(before.width(), before.height(), seed, connectivity, [&](ivec2 p) {
      const Rgba8 c = before[p];
      return near(c.r, old.r) && near(c.g, old.g) && near(c.b, old.b) && near(c.a, old.a);
    });
    if (tolerance == 0 && old == ink) right = Raster<std::uint8_t>(before.width(), before.height());
  }
  double error = 0;
  for (const Method method : methods) {
    Image image = before;
    try {
      const Filled filled = flood_fill::fill_image(image, seed, ink, {tolerance, connectivity, method});
      if (!taken || filled.painted != count(right)) return wrong;
    } catch (const ContractViolation&) {
      if (taken) return wrong;
      continue;
    }
    for (std::size_t k = 0; k < image.cells().size(); ++k) {
      error += image.cells()[k] != (right.cells()[k] ? ink : before.cells()[k]);
    }
  }
  return error;
}

}  // namespace

Domain flood_fill() {
  // Sizes, not magnitudes, make a picture hard
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::grazing,
                                Kind::ties,   Kind::extremes,        Kind::refused};
  const auto fills = [&](const char* name, const char* states, auto fill) {
    return Property{.name = name,
                    .states = states,
                    .unit = "cells",
                    .bound = 0,
                    .numbers = raster_numbers,
                    .kinds = kinds,
                    .generate = raster_input,
                    .error = [fill](const Input& i) { return raster_error(i, fill); },
                    .traps = raster_traps()};
  };
  std::vector<Property> properties;
  for (const auto& [name, method] :
       {std::pair("depth_first", Method::depth_first), std::pair("breadth_first", Method::breadth_first),
        std::pair("span", Method::span)}) {
    properties.push_back(
        fills(name, "paints the cells that hang together with the seed, no others, and counts them",
              [method](auto& cells, ivec2 seed, std::uint8_t value, Connectivity connectivity) {
                return flood_fill::fill_raster(cells, seed, value, method, connectivity);
              }));
  }
  properties.push_back(fills("fill_rows", "the same, by rows in memory",
                             [](auto& cells, ivec2 seed, std::uint8_t value, Connectivity connectivity) {
                               return flood_fill::fill_rows(cells, seed, value, connectivity);
                             }));
  properties.push_back(fills("fill_by_labels", "the same, by labels of runs, 64 cells at a time",
                             [](auto& cells, ivec2 seed, std::uint8_t value, Connectivity connectivity) {
                               return flood_fill::fill_by_labels(cells, seed, value, connectivity);
                             }));
  properties.push_back({.name = "questions",
                        .states = "cells are painted once; only they and their neighbours are asked for, "
                                  "by span no more often than by depth_first",
                        .unit = "of depth_first's",
                        .bound = 1,
                        .numbers = raster_numbers,
                        .kinds = kinds,
                        .generate = raster_input,
                        .error = questions_error,
                        .traps = raster_traps()});
  properties.push_back(
      {.name = "in_window",
       .states = "the fill of the picture cut to the window, which may lie anywhere",
       .unit = "cells",
       .bound = 0,
       .numbers = 10,
       .kinds = kinds,
       .generate = window_input,
       .error = window_error,
       .traps = {
           {"an empty window", {0, 0, -1, 5, 0, 0, 4, full, 1, 0}},
           {"the seed beside the window", {0, 0, 5, 5, 6, 0, 4, full, 1, 0}},
           {"a region that leaves the window and comes back", {0, 1, 9, 3, 0, 1, 4, upright_comb, 1, 0}},
           {"two cells from the largest integer",
            {2'147'483'640, 2'147'483'640, 2'147'483'645, 2'147'483'645, 2'147'483'645, 2'147'483'645, 8,
             full, 1, 0}},
           {"one cell from the least integer",
            {-2'147'483'647, 0, -2'147'483'640, 5, -2'147'483'640, 0, 4, full, 1, 0}}}});
  properties.push_back({.name = "fill_image",
                        .states = "the pixels like the seed's within the tolerance, whatever the new colour",
                        .unit = "pixels",
                        .bound = 0,
                        .numbers = 9,
                        .kinds = {Kind::random, Kind::ties, Kind::extremes, Kind::refused},
                        .generate = image_input,
                        .error = image_error,
                        .traps = {{"the new colour is like the old one", {8, 8, 3, 3, 4, 4, 6, 1, 2}},
                                  {"everything is alike", {9, 9, 0, 0, 8, 255, 256, 1, 77}},
                                  {"a tolerance below 0", {4, 4, 0, 0, 4, -1, 6, 1, 2}},
                                  {"a tolerance above 255", {4, 4, 0, 0, 4, 256, 6, 1, 2}},
                                  {"a click beside the picture", {4, 4, -1, 0, 4, 3, 6, 1, 2}}}});
  return {"flood_fill", properties};
}

}  // namespace gradus::stress
