#pragma once
// What is accumulated: a triangle on a small picture, a disc that flies past, three lamps before a lens.

#include <fmt/format.h>

#include <numeric>

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"
#include "core/arithmetic/exact.hpp"
#include "core/colour.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/ring_cut.hpp"
#include "stories/telling.hpp"
#include "stories/topic.hpp"

namespace gradus::accumulation_buffer {

/// A picture's grey values, row by row, and where a pass writes them.
struct Picture {
  ivec2 size;
  std::vector<double> values = std::vector<double>(static_cast<std::size_t>(size.x * size.y), 0.0);

  double at(ivec2 p) const { return values[static_cast<std::size_t>(p.y * size.x + p.x)]; }
  Sums<double> sums() { return {values, size}; }
};

/// Draws a picture by what its colour is at one place of every pixel.
template <class Colour, class Plot>
void draw(ivec2 size, dvec2 place, const Colour& colour, const Plot& plot) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) plot({x, y}, colour(dvec2(x, y) + place));
  }
}

/// The same as a picture of its own.
template <class Colour>
Picture picture_at(ivec2 size, dvec2 place, const Colour& colour) {
  Picture picture{size};
  draw(size, place, colour, picture.sums());
  return picture;
}

// --- Triangles

using Corners = std::array<dvec2, 3>;

/// Whether a place lies in the triangle, its edges included, however its corners run; never without an area.
inline bool holds(const Corners& t, dvec2 place) {
  if (orient2d(t[0], t[1], t[2]) == 0) return false;
  const int a = orient2d(t[0], t[1], place), b = orient2d(t[1], t[2], place), c = orient2d(t[2], t[0], place);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

inline double area_of(const std::vector<dvec2>& polygon) {
  double doubled = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const dvec2 p = polygon[k] - polygon[0], q = polygon[(k + 1) % polygon.size()] - polygon[0];
    doubled += p.x * q.y - p.y * q.x;
  }
  return std::abs(doubled) / 2;
}
inline std::vector<dvec2> part_in(const Corners& t, ivec2 pixel) {
  return ring_within({t.begin(), t.end()}, dvec2(pixel), dvec2(pixel) + 1.0);
}

/// One pixel of a small picture with a triangle.
struct Subject {
  static constexpr ivec2 size{7, 7};

  Corners triangle{};
  ivec2 grid{1, 1};  ///< places in a pixel
  ivec2 pixel{};     ///< the one that is shown large

  std::int64_t passes() const { return std::int64_t{grid.x} * grid.y; }
  double area() const { return area_of(part_in(triangle, pixel)); }
  auto colour() const {
    return [this](dvec2 place) { return holds(triangle, place) ? 1.0 : 0.0; };
  }
};

inline ivec2 grid_of(const Arguments& arguments) {
  return {static_cast<int>(arguments.integer("a")), static_cast<int>(arguments.integer("b"))};
}
inline Subject subject_of(const Arguments& arguments) {
  Subject subject{.grid = grid_of(arguments), .pixel = arguments.cell("pixel")};
  const std::vector<dvec2> corners = arguments.points("triangle");
  std::ranges::copy(corners, subject.triangle.begin());
  const ivec2 p = subject.pixel;
  if (!Window{{0, 0}, Subject::size - 1}.contains(p))
    refuse("pixel", "expected a pixel from (0, 0) to (6, 6), found ({}, {})", p.x, p.y);
  return subject;
}

// --- Drawings

inline Path rectangle(dvec2 corner, dvec2 size) {
  return {{corner, corner + dvec2{size.x, 0}, corner + size, corner + dvec2{0, size.y}}, true};
}

/// A picture on cells of the drawing, from `corner` on, with a frame and a heading.
struct Frame {
  ivec2 corner, size;

  dvec2 on_paper(dvec2 place) const { return dvec2(corner) + place - 0.5; }
  /// above: how far over it the heading stands.
  void put(View& view, const std::string& id, std::string heading, double above = 0.8) const {
    view.add({id + " frame", Role::guide, rectangle(on_paper({0, 0}), dvec2(size))});
    view.add({id + " heading", Role::guide, Text{on_paper({0.5 * size.x, -above}), std::move(heading)}});
  }
  /// 0 is not quite black, so that dark marks are seen on it.
  static double shade(double value) { return 0.05 + 0.95 * value; }
  void put_pixel(View& view, ivec2 p, double grey, std::string text = "") const {
    view.cells.insert_or_assign({p.y + corner.y, p.x + corner.x},
                                CellLook{Role::result, std::move(text), tone_of(grey)});
  }
  /// With every value divided by `by`.
  void put_picture(View& view, const Picture& picture, double by = 1) const {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) put_pixel(view, {x, y}, shade(picture.at({x, y}) / by));
    }
  }
  void mark(View& view, const std::string& id, ivec2 p, Role role = Role::current) const {
    view.add({id, role, rectangle(on_paper(dvec2(p)), dvec2(1))});
  }
};

/// A drawing of so many cells, row 0 at the top.
inline void set_paper(Narrator& narrator, ivec2 size) {
  narrator.grid({{0, 0}, size - 1});
  Grid& grid = narrator.trace().grid;
  grid.whole = true;
  grid.axes = grid.y_up = false;
}

}  // namespace gradus::accumulation_buffer
