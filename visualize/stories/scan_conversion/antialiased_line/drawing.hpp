#pragma once
// What the stories of antialiased lines draw alike: pixels in their intensities, and the line over them.

#include "core/arithmetic/elementary.hpp"
#include "figure/tone_of.hpp"
#include "scan_conversion/antialiased_line/antialiased_line.hpp"
#include "stories/casing.hpp"

namespace gradus::antialiased_line {

/// So many columns a line may have: each pixel about it is drawn.
constexpr std::int64_t longest_shown = 200;

/// Ink on white paper: a pixel that the line has all of is black. An intensity is the ink's share of the
/// pixel, in 255ths.
inline Rgba8 paint_of(int intensity) { return tone_on_paper({0, 0, 0, 255}, double{1} * intensity / full); }

/// The line of a story, and the cells about it.
struct Subject {
  ivec2 from, to;
  Extent size;
  Moves go;
  Window cells;

  bool point() const { return size.dx == 0; }
  dvec2 straight() const { return dvec2(go.straight); }
  dvec2 aside() const { return dvec2(go.diagonal - go.straight); }
  /// One pixel's length along the line, and at right angles to it, on the side of `aside`.
  dvec2 along() const { return turned(size.dx, size.dy); }
  dvec2 across() const { return turned(-size.dy, size.dx); }
  /// The four corners of the line as a rectangle 1 wide.
  std::vector<dvec2> rectangle() const {
    const dvec2 half = 0.5 * across();
    return {dvec2(from) - half, dvec2(to) - half, dvec2(to) + half, dvec2(from) + half};
  }

 private:
  dvec2 turned(Whole x, Whole y) const {
    if (point()) return x < 0 || y > 0 ? aside() : straight();
    return (static_cast<double>(x) * straight() + static_cast<double>(y) * aside()) / length_of(size);
  }
};

/// The line that was asked for, and the pixels that it may have a part of; one that is wide reaches aside.
/// Refuses what can't be drawn.
inline Subject subject_of(const Arguments& arguments, bool wide) {
  const ivec2 from = arguments.cell("from"), to = arguments.cell("to");
  const Extent size = extent(from, to);
  if (size.dx >= longest_shown) {
    refuse(arguments, {"to", "from"},
           fmt::format("every pixel about the line is drawn, so at most {} columns: this line has {}",
                       longest_shown, size.dx + 1));
  }
  if (!has_room(from, to)) {
    refuse(arguments, {"to", "from"}, fmt::format("at least {} pixels to the ends of int32", margin));
  }
  const Moves go = moves(from, to);
  const bool steep = bresenham_line::steep(from, to);
  const bool lone = size.dx > 0 && size.dy == 0;  // a single row: its numbers need room aside
  const ivec2 about = !wide && !lone ? ivec2{0} : steep ? ivec2{1, 0} : ivec2{0, 1};
  const Window line = window_around(from, to);
  return {from, to, size, go, {line.lower - about, line.upper + about}};
}

/// Cells, axes, title, and the line itself: its axis, and its outline where it has a width.
inline void set_scene(Narrator& narrator, const Subject& subject, bool wide) {
  narrator.grid(subject.cells);
  narrator.subtitle("subtitle", {{"from", subject.from}, {"to", subject.to}});
  for (const std::string_view end : {"from", "to"}) narrator.handles(end, as_it_is);
  if (subject.point()) return;
  const Stroke axis{dvec2(subject.from), dvec2(subject.to), false, wide, wide};
  auto lines = wide ? sides_of(subject.rectangle()) : std::vector<std::pair<dvec2, dvec2>>{};
  lines.emplace_back(axis.a, axis.b);
  add_casing(narrator, lines);
  narrator.backdrop("axis", Role::boundary, axis);
  if (wide) narrator.backdrop("line", Role::boundary, Path{subject.rectangle(), true});
}

/// White paper.
inline void put_paper(Board& board, const Window& cells) {
  for (int y = cells.lower.y; y <= cells.upper.y; ++y) {
    for (int x = cells.lower.x; x <= cells.upper.x; ++x) board.put({x, y}, Role::guide, "", paint_of(none));
  }
}
inline void put_pixel(Board& board, ivec2 pixel, int intensity) {
  board.put(pixel, Role::result, figure_number(intensity), paint_of(intensity));
}
/// Pixels below the outline of a line, which would strike numbers out: only the last has its number.
class NumberedPixel {
 public:
  void put(Board& board, ivec2 pixel, int intensity) {
    if (last_) board.put(last_->first, Role::result, "", paint_of(last_->second));
    put_pixel(board, pixel, intensity);
    last_ = {pixel, intensity};
  }

 private:
  std::optional<std::pair<ivec2, int>> last_;
};
inline Path outline_of(ivec2 pixel) {
  const dvec2 p(pixel);
  return {{p + dvec2{-0.5, -0.5}, p + dvec2{0.5, -0.5}, p + dvec2{0.5, 0.5}, p + dvec2{-0.5, 0.5}}, true};
}

/// Of the circle of radius 1 about a centre the part whose distance from it in direction `across` is from
/// `least` to `most`.
inline std::vector<dvec2> disc_between(dvec2 centre, dvec2 across, double least, double most) {
  constexpr int chords = 96;
  constexpr double pi = 3.14159265358979323846;
  const dvec2 along{across.y, -across.x};
  std::vector<dvec2> ring;
  for (int i = 0; i < chords; ++i) {
    const double angle = 2 * pi * i / chords, u = gradus::cos(angle);
    const double height = std::clamp(gradus::sin(angle), least, most);
    // Where the circle is cut off, its chord
    const double half = gradus::sqrt(1 - height * height), way = std::clamp(u, -half, half);
    ring.push_back(centre + way * along + height * across);
  }
  return ring;
}

}  // namespace gradus::antialiased_line
