#pragma once
// The line itself, as the stories of lines draw it behind all steps.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stories/telling.hpp"

namespace gradus::bresenham_line {

/// Up to this many pixels a run is watched from its start; the exact methods jump into longer ones.
constexpr std::int64_t longest_watched = 1'000'000;

struct Line {
  ivec2 from, to;
  Extent size;
  Moves go;
  std::optional<Window> window;  ///< only what lies in it is drawn
  Stretch shown;                 ///< the pixels to draw: all, or those in the window
};
inline Line line_of(const Arguments& arguments) {
  const ivec2 from = arguments.cell("from"), to = arguments.cell("to");
  const Extent size = extent(from, to);
  const std::optional<Window> window = arguments.window("window");
  return {from, to, size, moves(from, to), window, window ? visible(from, to, *window) : Stretch{0, size.dx}};
}

/// Whether the exact method starts in the middle.
inline bool jumps(const Line& line) { return line.window.has_value() || line.size.dx > longest_watched; }

/// The number of the step that reaches pixel k: k itself, or, in a window, counted from the first visible
/// pixel, which step 1 jumps to.
inline std::int64_t step_of(const Line& line, std::int64_t k) {
  return line.shown.first > 0 ? k - line.shown.first + 1 : k;
}

/// The exact line's point at the k-th pixel's place along the leading axis.
inline dvec2 ideal_at(const Line& line, std::int64_t k) {
  const double along = line.size.dx == 0 ? 0 : static_cast<double>(k) / static_cast<double>(line.size.dx);
  return dvec2(line.from) + along * (dvec2(line.to) - dvec2(line.from));
}

/// |ideal line - pixel| along the axis that does not lead, times dx: exact.
inline std::int64_t miss_times_dx(const Line& line, ivec2 p, std::int64_t k) {
  const std::int64_t row = steep(line.from, line.to) ? distance_x(line.from, p) : distance_y(line.from, p);
  const int128_t miss = int128_t{k} * line.size.dy - int128_t{row} * line.size.dx;
  return static_cast<std::int64_t>(miss < 0 ? -miss : miss);
}

/// The cells of the line, and one row more for the diagonal neighbour that is turned down at the end.
inline Window cells_of(const Line& line) {
  Window cells = window_around(line.from, line.to);
  const ivec2 aside = line.go.diagonal - line.go.straight;
  for (const int axis : {0, 1}) {
    if (aside[axis] > 0 && cells.upper[axis] < INT32_MAX) ++cells.upper[axis];
    if (aside[axis] < 0 && cells.lower[axis] > INT32_MIN) --cells.lower[axis];
  }
  return cells;
}

inline std::string ideal_name(const Words& words, const Line& line) {
  if (line.from.x == line.to.x) return words.say("ideal.vertical", {{"x", line.from.x}});
  if (line.from.y == line.to.y) return words.say("ideal.horizontal", {{"y", line.from.y}});
  const std::int64_t dy = std::int64_t{line.to.y} - line.from.y, dx = std::int64_t{line.to.x} - line.from.x;
  const std::string sign = (dy < 0) != (dx < 0) ? "−" : "";
  const std::int64_t common = std::gcd(dy, dx), a = std::abs(dy / common), b = std::abs(dx / common);
  if (line.from == ivec2{0, 0}) {
    const std::string x = a == 1 ? words.symbol("x") : fmt::format("{}{}", a, words.symbol("x"));
    return words.say("ideal.through_origin", {{"slope", sign + (b == 1 ? x : fmt::format("{}/{}", x, b))}});
  }
  return words.say("ideal.sloped", {{"slope", sign + figure_fraction(a, b)}});
}

/// What stands unchanged behind all steps.
inline void draw_line(Narrator& narrator, const Line& line) {
  narrator.grid(line.window ? *line.window : cells_of(line));
  narrator.subtitle("subtitle", {{"from", line.from}, {"to", line.to}});
  const bool point = line.size.dx == 0;
  if (!point) narrator.backdrop("ideal line", Role::boundary, Stroke{dvec2(line.from), dvec2(line.to)});
  narrator.backdrop("from", Role::input, Dot{dvec2(line.from)});
  narrator.backdrop("to", Role::input, Dot{dvec2(line.to)});
  for (const std::string_view end : {"from", "to"}) narrator.handles(end, as_it_is);
  if (!point) {
    narrator.backdrop("ideal line name", Role::boundary,
                      Label{ideal_at(line, line.size.dx * 5 / 6), ideal_name(narrator.words(), line)});
  }
  // The code has the names of the first octant
  const Words& words = narrator.words();
  const auto& [straight, diagonal, tie] = line.go;
  if (!point && straight != ivec2{1, 0}) narrator.named_in_the_code(words.move(straight), "E");
  if (!point && diagonal != ivec2{1, 1}) narrator.named_in_the_code(words.move(diagonal), "NE");
  narrator.legend(
      {Role::past, Role::current, Role::candidate, Role::rejected, Role::result, {Role::measure, "error"}});
}

}  // namespace gradus::bresenham_line
