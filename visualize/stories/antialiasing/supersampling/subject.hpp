#pragma once
// What supersampling is shown on: a triangle across some pixels, and what the pictures have in common.

#include <algorithm>
#include <cmath>
#include <string>

#include "antialiasing/supersampling/supersampling.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/supersampling/scenes.hpp"
#include "stories/telling.hpp"

namespace gradus::supersampling {

struct Subject {
  int n = 4;
  Filter filter = Filter::box;
  Polygon corners;
  ivec2 pixel{}, size{};
  bool red = false;

  Window picture() const { return {{0, 0}, size - 1}; }
  double share_at(dvec2 place) const { return holds(corners, place) ? 1 : 0; }
  /// The triangle on black.
  dvec3 light_at(dvec2 place) const { return share_at(place) * (red ? dvec3(1, 0, 0) : dvec3(1)); }
};

inline Subject subject_of(const Arguments& given) {
  Subject subject;
  subject.n = static_cast<int>(given.integer("samples"));
  const std::string& filter = given.text("filter");
  subject.filter = filter == "box" ? Filter::box : filter == "tent" ? Filter::tent : Filter::gaussian;
  subject.corners = given.points("corners");
  subject.pixel = given.cell("pixel");
  subject.size = {given.integer("columns"), given.integer("rows")};
  subject.red = given.text("light") == "red";
  const ivec2 p = subject.pixel;
  if (std::min(p.x, p.y) < 0 || std::max(p.x, p.y) > 999)
    refuse("pixel", "expected a column and a row from 0 to 999, found {},{}", p.x, p.y);
  return subject;
}

inline std::string filter_name(const Words& words, Filter filter) {
  return words.say(filter == Filter::box    ? "filter.box"
                   : filter == Filter::tent ? "filter.tent"
                                            : "filter.gaussian");
}

inline Path rectangle(dvec2 corner, dvec2 size) {
  return {{corner, corner + dvec2{size.x, 0}, corner + size, corner + dvec2{0, size.y}}, true};
}
/// Round cells of a grid.
inline Path round_cells(ivec2 corner, ivec2 size) { return rectangle(dvec2(corner) - 0.5, dvec2(size)); }

/// A picture on a grid: each of its values `scale` cells wide and high.
template <class ValueAt>
void put_values(View& view, ivec2 corner, ivec2 size, int scale, const ValueAt& value_at) {
  for (int y = 0; y < size.y * scale; ++y) {
    for (int x = 0; x < size.x * scale; ++x) {
      const Rgba8 color = tone_of(value_at(ivec2(x / scale, y / scale)));
      view.cells.insert_or_assign({corner.y + y, corner.x + x}, CellLook{Role::result, "", color});
    }
  }
}

/// A grid without axes whose cells are all shown.
inline void set_cells(Narrator& narrator, ivec2 size) { narrator.whole_grid({{0, 0}, size - 1}); }

}  // namespace gradus::supersampling
