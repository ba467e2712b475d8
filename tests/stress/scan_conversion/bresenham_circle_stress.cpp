// The promises of circles: the nearest pixel in every column of an octant, for every radius there is, and the
// same pixels in windows and on rasters.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include <vector>

#include "core/contract.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_batch.hpp"
#include "scan_conversion/bresenham_circle/bresenham_circle_window.hpp"
#include "stress/scan_conversion/nearest_pixels.hpp"
#include "stress/scan_conversion/whole_numbers.hpp"

namespace gradus::stress {
namespace {

using namespace bresenham_circle;

double radius_of(Kind kind, Random& random) {
  switch (kind) {
    case Kind::huge:
      return whole(random, 0, (std::int64_t{1} << random.uniform_int(1, 31)) - 1);
    case Kind::extremes: {
      const double some[] = {0, 1, 2, INT_MAX, INT_MAX - 1, 536'894'085, 1'073'741'826};
      return some[random.uniform_int(0, 6)];
    }
    case Kind::ties:
      return whole(random, 0, 16);
    case Kind::refused:
      return random.unit() < 0.5 ? -1 : INT_MIN;
    default:
      return whole(random, 0, 700);
  }
}
double coordinate(Kind kind, Random& random) {
  const bool at_end = kind == Kind::extremes || (kind == Kind::huge && random.unit() < 0.5);
  if (at_end) return random.unit() < 0.5 ? whole(random, INT_MIN, INT_MIN + 50) : INT_MAX - 3;
  const std::int64_t reach = kind == Kind::huge ? INT_MAX : 40;
  return whole(random, -reach, reach);
}
/// Centre and radius.
Input circle(Kind kind, Random& random) {
  Input input{coordinate(kind, random), coordinate(kind, random)};
  input.push_back(radius_of(kind, random));
  return input;
}

// --- Columns ---

/// A radius, and which column: its number as a part of the octant, 0 to 1.
Input column(Kind kind, Random& random) { return {radius_of(kind, random), random.unit()}; }

/// How far the pixel of the column is from the circle along the column; wrong where what leads there and back
/// is not as it is defined.
double column_error(const Input& i) {
  if (!is_whole(i[0], 0) || !(0 <= i[1] && i[1] <= 1)) return 0;
  const int radius = static_cast<int>(i[0]);
  const std::int64_t last = last_column(radius);
  const auto x = static_cast<std::int64_t>(i[1] * static_cast<double>(last));
  const std::int64_t y = height_at(radius, x);
  if (y < 0 || !is_height(radius, x, y)) return wrong;
  // The last column: x <= y there, and not in the next
  const bool ends =
      last <= height_at(radius, last) && (radius == 0 || last + 1 > height_at(radius, last + 1));
  // The first that is as low: no column before is
  bool inverse = true;
  for (const std::int64_t height : {y, y - 3, y + 3}) {
    const std::int64_t first = first_at_most(radius, height);
    if (height >= 0 && first <= radius) inverse = inverse && height_at(radius, first) <= height;
    if (first > 0) inverse = inverse && height_at(radius, std::min<std::int64_t>(first - 1, radius)) > height;
  }
  const Wide n = Wide{radius} * x, root = square_root(radius * x);
  const bool is_root = root * root <= n && n < (root + 1) * (root + 1);
  const Wide east = Wide{x + 1} * (x + 1) + Wide{y} * y - Wide{radius} * radius;
  const bool decides = decision_at(radius, x, y) == 2 * east - 2 * y + 1;
  if (!ends || !inverse || !is_root || !decides) return wrong;
  const double height = std::sqrt(static_cast<double>(Wide{radius} * radius - Wide{x} * x));
  return std::min(0.5, std::abs(static_cast<double>(y) - height));
}

// --- Windows ---

/// A circle, an octant and a part of it, and how far a window reaches from the pixel there to the left, down,
/// right and up. Many lie where octants meet.
Input circle_and_window(Kind kind, Random& random) {
  Input input = circle(kind, random);
  input.push_back(whole(random, 0, 7));
  const double ends[] = {0, 1, random.unit()};
  input.push_back(ends[random.uniform_int(0, 2)]);
  for (int i = 0; i < 4; ++i) input.push_back(whole(random, -3, 12));
  return input;
}
bool has_window(const Input& i) {
  return are_whole(i, 3) && is_whole(i[3], 0, 7) && 0 <= i[4] && i[4] <= 1 &&
         std::all_of(i.begin() + 5, i.end(), [](double x) { return is_whole(x, -20, 20); });
}
Window window_of(const Input& i) {
  const int radius = static_cast<int>(i[2]);
  const Octant octant = octants[static_cast<std::size_t>(i[3])];
  const auto x = static_cast<std::int64_t>(i[4] * static_cast<double>(last_column(radius)));
  const std::int64_t y = height_at(radius, x);
  const std::int64_t at_x = std::llround(i[0]) + x * octant.right.x + y * octant.up.x;
  const std::int64_t at_y = std::llround(i[1]) + x * octant.right.y + y * octant.up.y;
  const auto beside = [](std::int64_t at, double by) { return bounded(at + std::llround(by)); };
  return {{beside(at_x, -i[5]), beside(at_y, -i[6])}, {beside(at_x, i[7]), beside(at_y, i[8])}};
}

double window_error(const Input& i) {
  if (!has_window(i)) return 0;
  const ivec2 center = pixel(i, 0);
  const int radius = static_cast<int>(i[2]);
  const Window window = radius < 0 ? Window{{0, 0}, {9, 9}} : window_of(i);
  std::vector<ivec2> shown;
  bool right = true;
  std::int64_t reported = -1;
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Finished>) reported = step.pixels;
    if constexpr (std::same_as<Step, Started>) right = right && step.p == 3 - 2 * std::int64_t{radius};
    if constexpr (std::same_as<Step, Compared> || std::same_as<Step, Jumped>) {
      right = right && step.p == decision_at(radius, step.at.x, step.at.y) &&
              is_height(radius, step.at.x, step.at.y);
    }
    if constexpr (std::same_as<Step, Jumped>) right = right && step.at.x == step.shown.first;
  };
  try {
    in_window(center, radius, window, [&](ivec2 p) { shown.push_back(p); }, watch);
  } catch (const ContractViolation&) {
    return radius < 0 ? 0 : wrong;
  }
  if (radius < 0 || !right || reported != static_cast<std::int64_t>(shown.size())) return wrong;
  // Every pixel of the window that belongs to the circle is shown, and none twice
  const auto before = [](ivec2 p, ivec2 q) { return p.y != q.y ? p.y < q.y : p.x < q.x; };
  std::ranges::sort(shown, before);
  auto next = shown.begin();
  for (std::int64_t y = window.lower.y; y <= window.upper.y; ++y) {
    for (std::int64_t x = window.lower.x; x <= window.upper.x; ++x) {
      const ivec2 p{static_cast<int>(x), static_cast<int>(y)};
      if (!on_circle(center, radius, p)) continue;
      if (next == shown.end() || *next++ != p) return wrong;
    }
  }
  return next == shown.end() ? 0 : wrong;
}

// --- Whole circles ---

/// Watches a circle: its grammar; p is d(E) + d(SE), on whichever side of the circle they are; the other
/// textbook's form, d at the midpoint, decides the same.
struct Watch {
  std::int64_t radius;
  std::int64_t midpoint = 1 - radius;  ///< d(x + 1, y - 1/2) - 1/4
  ivec2 at{0, static_cast<int>(radius)};
  enum { before, between, in_step, after } phase = before;
  bool right = true;

  void want(bool holds) { right = right && holds; }
  std::int64_t outside(std::int64_t x, std::int64_t y) const { return x * x + y * y - radius * radius; }

  void operator()(const Started& s) {
    want(phase == before && s.radius == radius && s.p == 3 - 2 * radius);
    phase = between;
  }
  void operator()(const Compared& c) {
    want(phase == between && c.at == at && at.x < at.y);
    phase = in_step;
    // Odd, so there is no tie
    const std::int64_t e = outside(at.x + 1, at.y), se = outside(at.x + 1, at.y - 1);
    want(c.p == e + se && c.p % 2 != 0 && std::abs(c.p) <= 4 * radius + 3);
    want(c.east == (std::abs(e) < std::abs(se)));
    want(c.p == decision_at(static_cast<int>(radius), at.x, at.y));
    want(c.p == 2 * midpoint + 1 && c.east == (midpoint < 0));
    midpoint += c.east ? 2 * at.x + 3 : 2 * (at.x - at.y) + 5;
  }
  void operator()(const Stepped& s) {
    want(phase == in_step && s.from() == at && s.at == at + (s.east ? ivec2{1, 0} : ivec2{1, -1}));
    phase = between;
    // Past the diagonal: the mirror image of the place before
    want(s.at.x > s.at.y ? s.at == ivec2{at.y, at.x} : is_height(radius, s.at.x, s.at.y));
    at = s.at;
  }
  void operator()(const Finished& f) {
    want(phase == between && at.x >= at.y && f.pixels == pixel_count(static_cast<int>(radius)));
    phase = after;
  }
};

/// All steps of a circle that is not too large, and of a smaller one all pixels, watched and not.
double steps_error(const Input& i) {
  if (!are_whole(i, 3)) return 0;
  const ivec2 center = pixel(i, 0);
  const int radius = static_cast<int>(i[2]);
  const bool taken = radius >= 0 && fits_plane(center, radius);
  if (taken && radius > 1'000'000) return 0;
  std::vector<std::pair<int, int>> pixels, unobserved;
  Watch watch{radius};
  try {
    const auto plot = [&](ivec2 p) {
      if (radius <= 2000) pixels.emplace_back(p.x, p.y);
    };
    decision_parameter(center, radius, plot, watch);
    if (radius <= 2000) {
      decision_parameter(center, radius, [&](ivec2 p) { unobserved.emplace_back(p.x, p.y); });
    }
  } catch (const ContractViolation&) {
    return taken ? wrong : 0;
  }
  if (!taken || !watch.right || watch.phase != Watch::after || pixels != unobserved) return wrong;
  if (radius > 2000) return 0;
  for (const auto& [x, y] : pixels) {
    if (!on_circle(center, radius, {x, y})) return wrong;
  }
  std::ranges::sort(pixels);
  const bool once = std::ranges::adjacent_find(pixels) == pixels.end();
  return once && static_cast<std::int64_t>(pixels.size()) == pixel_count(radius) ? 0 : wrong;
}

// --- Rasters ---

/// A circle and the size of a raster; most pass through it.
Input circle_and_raster(Kind kind, Random& random) {
  Input input = circle(kind, random);
  if (kind == Kind::random || kind == Kind::ties) {
    input[0] = whole(random, -10, 50);
    input[1] = whole(random, -10, 40);
  }
  if (kind == Kind::random) input[2] = whole(random, 0, random.unit() < 0.5 ? 25 : 150);
  if (kind == Kind::ties) input[2] = std::trunc(input[2] / 3);
  if (kind == Kind::huge && random.unit() < 0.5) {
    input[0] = whole(random, 0, 40) - input[2];
    input[1] = whole(random, -20, 20);
  }
  input.push_back(whole(random, 0, 40));
  input.push_back(whole(random, 1, 30));
  return input;
}
double drawing_error(const Input& i) {
  if (!are_whole(i, 3) || !is_whole(i[3], 0, 64) || !is_whole(i[4], 0, 64)) return 0;
  const ivec2 center = pixel(i, 0), size = pixel(i, 3);
  const int radius = static_cast<int>(i[2]);
  Raster<std::uint8_t> raster(size.x, size.y);
  try {
    draw(raster, center, radius, std::uint8_t{1});
  } catch (const ContractViolation&) {
    return radius < 0 ? 0 : wrong;
  }
  if (radius < 0) return wrong;
  double error = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) error += (raster[{x, y}] == 1) != on_circle(center, radius, {x, y});
  }
  return error;
}
std::int64_t cells_drawn(const Input& i) {
  Raster<std::uint8_t> raster(static_cast<int>(i[3]), static_cast<int>(i[4]));
  if (i[2] >= 0) draw(raster, pixel(i, 0), static_cast<int>(i[2]), std::uint8_t{1});
  return std::ranges::count(raster.cells(), 1);
}

using Arguments = std::vector<std::pair<std::string, std::string>>;
Arguments radius_argument(double radius) { return {{"radius", std::to_string(static_cast<int>(radius))}}; }

}  // namespace

Domain bresenham_circle() {
  const std::vector<Kind> kinds{Kind::random, Kind::ties, Kind::huge, Kind::extremes};
  std::vector<Kind> with_refused = kinds;
  with_refused.push_back(Kind::refused);
  const auto leaves_plane = [](const Input& i) { return !fits_plane(pixel(i, 0), static_cast<int>(i[2])); };
  return {
      "bresenham_circle",
      {{.name = "height_at",
        .states = "the pixel of each column is the nearest to the circle, and is found from its height",
        .unit = "pixels",
        .bound = 0.5,
        .numbers = 2,
        .kinds = kinds,
        .generate = column,
        .error = column_error,
        .arguments = [](const Input& i) { return radius_argument(i[0]); },
        .traps = {{"one pixel", {0, 0}},
                  {"four pixels", {1, 1}},
                  {"the increment wraps", {536'894'085, 0.9}},
                  {"3 - 2r wraps", {1'073'741'826, 0.5}}},
        .shares = {{"ends on the diagonal", 0.2,
                    [](const Input& i) {
                      const int radius = static_cast<int>(i[0]);
                      return height_at(radius, last_column(radius)) == last_column(radius);
                    }}},
        .cases = 20'000},
       {.name = "in_window",
        .states = "exactly the circle's pixels that lie in the window, each once, wherever the centre",
        .unit = "pixels",
        .bound = 0,
        .numbers = 9,
        .kinds = with_refused,
        .generate = circle_and_window,
        .error = window_error,
        .traps = {{"the left end of the largest circle", {INT_MAX - 1, 7, INT_MAX, 6, 0, 3, 3, 3, 3}},
                  {"the middle of the least corner", {INT_MIN, INT_MIN, INT_MAX, 0, 0, 0, 9, 0, 9}},
                  {"octants of the largest circle meet", {0, 0, INT_MAX, 0, 1, 2, 2, 2, 2}}},
        .shares = {{"leaves the plane", 0.2, leaves_plane}},
        .cases = 40'000},
       {.name = "steps",
        .states =
            "every step holds, and decides as 1 - r at the midpoint does; each pixel once, watched or not",
        .unit = "circles",
        .bound = 0,
        .numbers = 3,
        .kinds = {Kind::random, Kind::ties, Kind::refused},
        .generate = circle,
        .error = steps_error,
        .arguments = [](const Input& i) { return radius_argument(i[2]); },
        .traps = {{"radius 99,991", {0, 0, 99'991}},
                  {"radius 1,000,000", {0, 0, 1'000'000}},
                  {"beyond the largest integer", {INT_MAX - 4, 0, 5}},
                  {"as far as may be", {INT_MAX - 5, INT_MIN + 5.0, 5}}}},
       {.name = "drawing",
        .states = "the cells of a raster that are pixels of the circle",
        .unit = "cells",
        .bound = 0,
        .numbers = 5,
        .kinds = with_refused,
        .generate = circle_and_raster,
        .error = drawing_error,
        .shares = {{"the raster's border cuts the circle", 0.1,
                    [](const Input& i) {
                      return 0 < cells_drawn(i) && cells_drawn(i) < pixel_count(static_cast<int>(i[2]));
                    }},
                   {"is drawn whole", 0.015,
                    [](const Input& i) {
                      return i[2] >= 0 && cells_drawn(i) == pixel_count(static_cast<int>(i[2]));
                    }}},
        .cases = 22'000}}};
}

}  // namespace gradus::stress
