// The promises of lines: the nearest pixel in every column, anywhere in the plane of 32-bit integers.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

__extension__ using Int128 = __int128;

constexpr std::int64_t lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();

int coordinate(Kind kind, Random& random) {
  switch (kind) {
    case Kind::huge:
      return static_cast<int>(random.uniform_int(lowest, highest));
    case Kind::extremes: {
      const std::int64_t some[] = {lowest, lowest + 1, highest, highest - 1, -1, 0, 1, 1'500'000'000};
      return static_cast<int>(some[random.uniform_int(0, 7)]);
    }
    case Kind::ties:
      return static_cast<int>(random.uniform_int(-4, 4));
    default:
      return static_cast<int>(random.uniform_int(-1000, 1000));
  }
}

/// The ends of a line, and which pixel of it: its number as a part of the line, 0 to 1.
Input generate(Kind kind, Random& random) {
  Input input;
  for (int i = 0; i < 4; ++i) input.push_back(coordinate(kind, random));
  if (kind == Kind::near_degenerate) {
    // Nearly level, upright or diagonal
    const auto nearly = [&](double x) { return x + static_cast<double>(random.uniform_int(-1, 1)); };
    const std::int64_t way = random.uniform_int(0, 2);
    if (way != 1) input[3] = nearly(way == 2 ? input[1] + (input[2] - input[0]) : input[1]);
    if (way == 1) input[2] = nearly(input[0]);
  }
  input.push_back(random.unit());
  return input;
}

bool fits(const Input& i) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (i[k] != std::floor(i[k]) || i[k] < static_cast<double>(lowest) || i[k] > static_cast<double>(highest))
      return false;
  }
  return i[4] >= 0 && i[4] <= 1;
}

struct Line {
  ivec2 from, to;
  std::int64_t k;  ///< the pixel's number
};
Line line_of(const Input& i) {
  Line line{
      {static_cast<int>(i[0]), static_cast<int>(i[1])}, {static_cast<int>(i[2]), static_cast<int>(i[3])}, 0};
  const std::int64_t last = bresenham_line::pixel_count(line.from, line.to) - 1;
  line.k = std::min(last, static_cast<std::int64_t>(std::llround(i[4] * static_cast<double>(last))));
  return line;
}

/// How far a pixel is from the line along the axis that the line crosses slowly; exact but for one division.
double off(const Line& line, ivec2 pixel) {
  const Int128 dx = Int128{line.to.x} - line.from.x, dy = Int128{line.to.y} - line.from.y;
  const Int128 x = Int128{pixel.x} - line.from.x, y = Int128{pixel.y} - line.from.y;
  const Int128 longer = std::max(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
  if (longer == 0) return x == 0 && y == 0 ? 0 : wrong;
  // The pixel's place along the line must be its number
  const Int128 along = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy) ? (dx < 0 ? -x : x) : (dy < 0 ? -y : y);
  if (along != line.k) return wrong;
  const Int128 cross = dx * y - dy * x, size = cross < 0 ? -cross : cross;
  // Above a half nothing may round to a half
  if (2 * size > longer)
    return std::max(std::nextafter(0.5, 1.0), static_cast<double>(size) / static_cast<double>(longer));
  return static_cast<double>(size) / static_cast<double>(longer);
}

double error_of_pixel(const Input& i) {
  if (!fits(i)) return 0;
  const Line line = line_of(i);
  return off(line, bresenham_line::pixel_at(line.from, line.to, line.k));
}

/// A window of 5 x 5 round the pixel holds the pixels of the whole line that lie there, and no others.
double error_in_window(const Input& i) {
  if (!fits(i)) return 0;
  const Line line = line_of(i);
  const ivec2 middle = bresenham_line::pixel_at(line.from, line.to, line.k);
  const auto within = [](std::int64_t x) { return static_cast<int>(std::clamp(x, lowest, highest)); };
  const Window window{{within(std::int64_t{middle.x} - 2), within(std::int64_t{middle.y} - 2)},
                      {within(std::int64_t{middle.x} + 2), within(std::int64_t{middle.y} + 2)}};
  std::vector<ivec2> found, expected;
  bresenham_line::in_window(line.from, line.to, window, [&](ivec2 p) { found.push_back(p); });
  const std::int64_t last = bresenham_line::pixel_count(line.from, line.to) - 1;
  for (std::int64_t k = std::max<std::int64_t>(0, line.k - 5); k <= std::min(last, line.k + 5); ++k) {
    const ivec2 p = bresenham_line::pixel_at(line.from, line.to, k);
    if (window.contains(p)) expected.push_back(p);
  }
  return found == expected ? 0 : wrong;
}

std::vector<std::pair<std::string, std::string>> arguments(const Input& i) {
  return {{"from", fmt::format("{},{}", i[0], i[1])}, {"to", fmt::format("{},{}", i[2], i[3])}};
}

std::vector<Trap> traps() {
  return {
      {"2 dy - 2 dx wraps", {0, 0, 1'500'000'000, 1'200'000'000, 0.7}},
      {"dy = 0 and the increment wraps", {0, 0, 1'500'000'000, 0, 0.9}},
      {"dx wraps", {-1'500'000'000, 0, 1'500'000'000, 1'000'000, 0.5}},
      {"p is 1", {0, 0, 2'147'483'647, 1'073'741'824, 1}},
      {"zero length", {3, 4, 3, 4, 0}},
      {"the most negative integer", {-2'147'483'648.0, -2'147'483'648.0, 2'147'483'647, 2'147'483'647, 0.5}},
      {"half way between two pixels", {0, 0, 2, 1, 0.5}}};
}

}  // namespace

Domain bresenham_line() {
  const std::vector<Kind> kinds{Kind::random, Kind::near_degenerate, Kind::ties, Kind::huge, Kind::extremes};
  return {"bresenham_line",
          {{.name = "pixel_at",
            .states = "the pixel of each column is the nearest to the line",
            .unit = "pixels",
            .bound = 0.5,
            .numbers = 5,
            .kinds = kinds,
            .generate = generate,
            .error = error_of_pixel,
            .arguments = arguments,
            .traps = traps()},
           {.name = "in_window",
            .states = "the pixels of the whole line that lie in the window, in their order",
            .unit = "pixels",
            .bound = 0,
            .numbers = 5,
            .kinds = kinds,
            .generate = generate,
            .error = error_in_window,
            .traps = traps()}}};
}

}  // namespace gradus::stress
