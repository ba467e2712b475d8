#pragma once
// What runs on fractal curves are about, and what all their stories say alike.

#include <numeric>

#include "modeling/fractal_curve/fractal_curve.hpp"
#include "modeling/fractal_curve/fractal_curve_notes.hpp"
#include "modeling/fractal_curve/l_system.hpp"
#include "stories/past.hpp"
#include "stories/telling.hpp"

namespace gradus::fractal_curve {

constexpr int paper_width = 36, paper_height = 27;

using Way = std::vector<dvec2>;

struct Subject {
  Shape shape;
  int level;
  Segment<2, double> base;
  bool inward = false;  ///< as the exhibit has it

  bool closed() const { return shape == Shape::snowflake; }
  /// The segments of a level.
  std::int64_t segments(int at_level) const { return (closed() ? 3 : 1) * power(4, at_level); }
  Corners corners(int at_level) const {
    return inward ? inside(base_of(shape), at_level) : koch(base_of(shape), at_level);
  }
  dvec2 at(Corner c, int at_level) const { return in_plane(c, at_level, base); }
  Way way(int at_level) const { return in_plane(corners(at_level), at_level, base); }
  /// As it would be without the fault.
  Way right_way() const { return in_plane(koch(base_of(shape), level), level, base); }

  /// More segments of a level than these are not told one by one.
  static constexpr std::int64_t most_told = 48;
  bool tells_segments(int of_level) const { return segments(of_level - 1) <= most_told; }
  /// The last level whose segments are told.
  int last_told() const {
    int last = 1;
    while (last < level && tells_segments(last + 1)) ++last;
    return last;
  }
};

inline Subject subject_of(const Arguments& arguments, bool inward = false) {
  const std::vector<dvec2> base = arguments.points("base");
  if (base[0] == base[1]) refuse("base", "expected two different points");
  // Inside is where a triangle is
  const bool curve = !inward && arguments.text("shape") == "curve";
  return {curve ? Shape::curve : Shape::snowflake,
          static_cast<int>(arguments.integer("level")),
          {base[0], base[1]},
          inward};
}

inline Extent extent_of(const Way& way) {
  Extent extent;
  for (const dvec2 p : way) extent.add(p);
  return extent;
}

/// "16/9", "3".
inline std::string fraction_of(std::int64_t above, std::int64_t below) {
  const std::int64_t common = std::gcd(above, below);
  const std::string whole = figure_number(above / common);
  return below == common ? whole : fmt::format("{}/{}", whole, figure_number(below / common));
}

/// As figures have texts of an L-system.
inline std::string shown(std::string_view text) {
  std::string with_minus;
  for (const char s : text) with_minus += s == '-' ? "−" : std::string(1, s);
  return with_minus;
}

}  // namespace gradus::fractal_curve
