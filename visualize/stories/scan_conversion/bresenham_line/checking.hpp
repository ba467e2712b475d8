#pragma once
// What is right of a line besides our own pixels: ties, and what follows from a wrong step.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stories/checking.hpp"

namespace gradus::bresenham_line {

/// A line as arguments say it, and the axis that does not lead.
struct AskedLine {
  explicit AskedLine(const Arguments& arguments)
      : from(arguments.cell("from")), to(arguments.cell("to")), aside(steep(from, to) ? 0 : 1) {}
  ivec2 from, to;
  int aside;
};

/// Both in one column (of a steep line: row) as neighbours, and the line, which is no point, passes midway.
inline bool as_near(const Arguments& arguments, ivec2 one, ivec2 other) {
  const AskedLine line(arguments);
  const glm::i64vec2 apart = glm::i64vec2(one) - glm::i64vec2(other);
  if (apart[1 - line.aside] != 0 || std::abs(apart[line.aside]) != 1) return false;
  if (line.from == line.to) return false;
  const glm::i64vec2 way = glm::i64vec2(line.to) - glm::i64vec2(line.from);
  const glm::i64vec2 twice = glm::i64vec2(one) + glm::i64vec2(other) - Whole{2} * glm::i64vec2(line.from);
  return int128_t{way.x} * twice.y == int128_t{way.y} * twice.x;
}

/// The pixel that a step of theirs stands on.
inline std::optional<ivec2> pixel_in(const Values& values) {
  if (const auto pixel = value_as<ivec2>(values, "pixel")) return pixel;
  const auto x = value_as<Whole>(values, "x"), y = value_as<Whole>(values, "y");
  return x && y ? std::optional(ivec2(static_cast<int>(*x), static_cast<int>(*y))) : std::nullopt;
}

/// One move by the sign of their own p, and p moved on by the same rule; at 0 either.
inline Follows follows(const OwnSteps& steps, std::size_t i) {
  const Values &before = steps.theirs[i - 1], &now = steps.theirs[i];
  const auto p = value_as<Whole>(before, "p");
  const auto stood = pixel_in(before), stands = pixel_in(now);
  if (!p || !stood || !stands) return Follows::untold;
  const ivec2 from = steps.arguments.cell("from"), to = steps.arguments.cell("to");
  const auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  const auto moved_on = value_as<Whole>(now, "p");
  const auto is = [&](ivec2 move, Whole change) {
    return *stood + move == *stands && (!moved_on || *moved_on == *p + change);
  };
  const bool straight = *p <= 0 && is(go.straight, 2 * dy);
  const bool diagonal = *p >= 0 && is(go.diagonal, 2 * (dy - dx));
  return straight || diagonal ? Follows::yes : Follows::no;
}

/// Each move bounds the value that p must have had at the first of these pixels: they follow as long as there
/// is such a value.
inline std::size_t goes_on(const Arguments& arguments, std::span<const ivec2> pixels) {
  const ivec2 from = arguments.cell("from"), to = arguments.cell("to");
  const auto [dx, dy] = extent(from, to);
  const Moves go = moves(from, to);
  int128_t least = -(int128_t{1} << 80), most = int128_t{1} << 80, change = 0;
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const ivec2 move = pixels[i] - pixels[i - 1];
    if (move != go.straight && move != go.diagonal) return i;
    if (move == go.straight)
      most = std::min(most, -change);
    else
      least = std::max(least, -change);
    if (least > most) return i;
    change += move == go.straight ? 2 * dy : 2 * (dy - dx);
  }
  return pixels.size();
}

/// A pixel's coordinate along the axis that does not lead.
inline Whole aside_of(ivec2 pixel, const Arguments& arguments) { return pixel[AskedLine(arguments).aside]; }

inline const Checking& checking() {
  static const Checking known{
      .asked = {pixels_that_are(SameList::set)},
      .is_tie =
          [](const TraceStep& step) {
            return step.type == "Compared" && value_as<Whole>(step.fields, "p") == 0;
          },
      .as_near = as_near,
      .tie_rules = {{"smaller", [](const Arguments& a, ivec2 one,
                                   ivec2 other) { return aside_of(one, a) < aside_of(other, a); }},
                    {"larger", [](const Arguments& a, ivec2 one,
                                  ivec2 other) { return aside_of(one, a) > aside_of(other, a); }},
                    {"straight",
                     [](const Arguments& a, ivec2 one, ivec2 other) {
                       const Whole from = aside_of(a.cell("from"), a);
                       return std::abs(aside_of(one, a) - from) < std::abs(aside_of(other, a) - from);
                     }},
                    {"diagonal",
                     [](const Arguments& a, ivec2 one, ivec2 other) {
                       const Whole from = aside_of(a.cell("from"), a);
                       return std::abs(aside_of(one, a) - from) > std::abs(aside_of(other, a) - from);
                     }},
                    {"even", [](const Arguments& a, ivec2 one, ivec2) { return aside_of(one, a) % 2 == 0; }},
                    {"away_from_zero",
                     [](const Arguments& a, ivec2 one, ivec2 other) {
                       return std::abs(aside_of(one, a)) > std::abs(aside_of(other, a));
                     }}},
      .follows = follows,
      .goes_on = goes_on};
  return known;
}

}  // namespace gradus::bresenham_line
