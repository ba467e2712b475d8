// The promises of circles: the nearest pixel in every column of an octant, for every radius there is.

#include "scan_conversion/bresenham_circle/bresenham_circle.hpp"

#include <cmath>

#include "stress/numbers.hpp"

namespace gradus::stress {
namespace {

__extension__ using Int128 = __int128;

/// A radius, and which column: its number as a part of the octant, 0 to 1.
Input generate(Kind kind, Random& random) {
  constexpr double largest = std::numeric_limits<int>::max();
  const double part = random.unit();
  switch (kind) {
    case Kind::huge:
      return {std::floor(random.uniform(1e8, largest)), part};
    case Kind::extremes: {
      const double some[] = {0, 1, 2, largest, largest - 1, 536'894'085, 1'073'741'826};
      return {some[random.uniform_int(0, 6)], part};
    }
    case Kind::ties:
      return {std::floor(random.uniform(0, 16)), part};
    default:
      return {std::floor(random.uniform(0, 4000)), part};
  }
}

/// How far the pixel of the column is from the circle along the column; at most a half is asked for.
double error(const Input& i) {
  if (i[0] != std::floor(i[0]) || i[0] < 0 || i[0] > std::numeric_limits<int>::max() ||
      !(i[1] >= 0 && i[1] <= 1))
    return 0;
  const int radius = static_cast<int>(i[0]);
  const auto last = bresenham_circle::last_column(radius);
  const auto x = static_cast<std::int64_t>(i[1] * static_cast<double>(last));
  const std::int64_t y = bresenham_circle::height_at(radius, x);
  // |y - h| <= 1/2 with h^2 = r^2 - x^2: (2y - 1)^2 <= 4 h^2 <= (2y + 1)^2, in whole numbers
  const Int128 square = 4 * (Int128{radius} * radius - Int128{x} * x);
  const Int128 below = 2 * Int128{y} - 1, above = 2 * Int128{y} + 1;
  const bool nearest = y >= 0 && square <= above * above && (y == 0 || square >= below * below);
  const double height = std::sqrt(static_cast<double>(square)) / 2;
  return nearest ? std::min(0.5, std::abs(static_cast<double>(y) - height)) : wrong;
}

}  // namespace

Domain bresenham_circle() {
  return {"bresenham_circle",
          {{.name = "height_at",
            .states = "the pixel of each column is the nearest to the circle",
            .unit = "pixels",
            .bound = 0.5,
            .numbers = 2,
            .kinds = {Kind::random, Kind::ties, Kind::huge, Kind::extremes},
            .generate = generate,
            .error = error,
            .arguments = [](const Input& i) -> std::vector<std::pair<std::string, std::string>> {
              return {{"radius", std::to_string(static_cast<int>(i[0]))}};
            },
            .traps = {{"one pixel", {0, 0}},
                      {"four pixels", {1, 1}},
                      {"the increment wraps", {536'894'085, 0.9}},
                      {"3 - 2r wraps", {1'073'741'826, 0.5}}}}}};
}

}  // namespace gradus::stress
