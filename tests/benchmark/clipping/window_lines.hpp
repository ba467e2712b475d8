#pragma once
// Segments against a window of whole numbers, in mixes and in numbers of segments, with what exact arithmetic
// says of each: what the benchmarks of the clippers of segments share.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "benchmark/clipping/segments.hpp"
#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

namespace gradus::bench::window_lines {

using Line = Segment<2, double>;

// A window of 2^20 by 2^20 pixels, corners included: OpenCV knows whole numbers only
inline constexpr std::int64_t side = 1 << 20;
inline const AxisBox<2, double> window{{0, 0}, {side - 1, side - 1}};

using Lines = segments::Set<2>;
using Clipped = segments::Clipped<2>;
using segments::each;

enum class Mix : std::uint8_t { inside, crossing, outside, crossing_reals };

inline std::string name_of(Mix mix) {
  const char* const names[] = {"inside", "crossing", "outside", "crossing, not whole"};
  return names[static_cast<std::size_t>(mix)];
}

inline bool fits(const Line& line, Mix mix) {
  const int a = cohen_sutherland_2d::region_code(line.a, window);
  const int b = cohen_sutherland_2d::region_code(line.b, window);
  if (mix == Mix::inside) return (a | b) == 0;
  if (mix == Mix::outside) return (a & b) != 0;
  return (a & b) == 0 && (a | b) != 0;
}

/// So many lines of a mix, always the same.
inline const Lines& lines_of(Mix mix, std::size_t count) {
  static std::map<std::pair<Mix, std::size_t>, Lines> made;
  const auto [at, added] = made.try_emplace({mix, count});
  Lines& set = at->second;
  if (!added) return set;
  std::mt19937_64 random(1);
  const auto coordinate = [&] {
    const double whole = static_cast<double>(random() % (3 * side)) - static_cast<double>(side);
    return mix == Mix::crossing_reals ? whole + static_cast<double>(random() >> 11) * 0x1p-53 : whole;
  };
  while (set.lines.size() < count) {
    Line line;
    for (double* x : {&line.a.x, &line.a.y, &line.b.x, &line.b.y}) *x = coordinate();
    if (fits(line, mix)) set.lines.push_back(line);
  }
  for (const Line& line : set.lines) set.right.push_back(test::exact_clip(line, window));
  return set;
}

/// Clips all lines of a set.
using Clip = std::function<void(const std::vector<Line>&, Clipped&)>;

/// A method and what it is.
struct Method {
  std::string name;
  Standing standing;
  Clip clip;
};

/// The methods on every mix, and on a growing number of crossing segments.
std::vector<Case> cases_of(const std::vector<Method>& methods);

/// Boost.Geometry's clip_segment, and where they are there, OpenCV's clipLine and AGG's clip_line_segment.
std::vector<Method> peers();

}  // namespace gradus::bench::window_lines
