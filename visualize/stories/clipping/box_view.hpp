#pragma once
// Boxes and segments in space on the paper: what the stories of clipping in space share.

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/axis_cut.hpp"
#include "stories/space_drawing.hpp"

namespace gradus {

/// A part of the paper that shows space obliquely, z away from the reader. Axes keep one scale unless one is
/// less than a third as long as the longest: then it is stretched to a third.
class SpaceView {
 public:
  /// place: in paper units. shown: the points that must be seen; at least one.
  SpaceView(Extent place, const std::vector<dvec3>& shown) : panel_(place, {}) {
    dvec3 lower = shown.front(), upper = lower;
    for (const dvec3 p : shown) {
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
    // Halves, since differences of the largest numbers overflow
    middle_ = 0.5 * lower + 0.5 * upper;
    half_ = 0.5 * upper - 0.5 * lower;
    const double longest = std::max({half_.x, half_.y, half_.z});
    Extent extent;
    for (int i = 0; i < 3; ++i) {
      size_[i] = half_[i] > 0 ? std::max(half_[i] / longest, 1.0 / 3) : 0;
    }
    for (const dvec3 p : shown) extent.add(oblique(turned(p)));
    panel_ = Panel(place, extent);
  }

  /// A point in directions as the reader has them: right, up, towards him.
  dvec3 turned(dvec3 p) const {
    dvec3 scaled(0);
    for (int i = 0; i < 3; ++i) {
      if (half_[i] > 0) scaled[i] = (p[i] - middle_[i]) / half_[i] * size_[i];
    }
    return {scaled.x, scaled.y, -scaled.z};
  }
  dvec2 on_paper(dvec3 turned) const { return panel_.at(oblique(turned)); }
  dvec2 at(dvec3 p) const { return on_paper(turned(p)); }
  /// A drawing of what has been turned.
  SpaceDrawing drawing() const {
    return SpaceDrawing({.viewer = distant_viewer(towards_oblique),
                         .at = [this](dvec3 p) { return std::optional(on_paper(p)); }});
  }

 private:
  dvec3 middle_{0}, half_{0}, size_{0};
  Panel panel_;
};

/// Corner 0 … 7 of a box: bit 0 x, bit 1 y, bit 2 z, set for the upper one.
inline dvec3 box_corner(const AxisBox<3, double>& box, int corner) {
  return {(corner & 1) != 0 ? box.upper.x : box.lower.x, (corner & 2) != 0 ? box.upper.y : box.lower.y,
          (corner & 4) != 0 ? box.upper.z : box.lower.z};
}

/// The corners of a face, in the order of its outline.
inline std::vector<dvec3> box_face(const AxisBox<3, double>& box, Border face) {
  const int axis = axis_of(face), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const int base = is_upper(face) ? 1 << axis : 0;
  std::vector<dvec3> outline;
  for (const int corner : {base, base | 1 << u, base | 1 << u | 1 << v, base | 1 << v}) {
    outline.push_back(box_corner(box, corner));
  }
  return outline;
}

/// A convex solid as glass. faces: their corners may run either way.
inline void add_glass(SpaceDrawing& drawing, const SpaceView& space, const std::vector<dvec3>& corners,
                      const std::vector<Corners>& faces) {
  dvec3 middle{0};
  for (const dvec3 p : corners) middle += space.turned(p) / static_cast<double>(corners.size());
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    SpaceFace face{.id = fmt::format("{}", i), .role = Role::boundary, .ring = {}, .glass = true};
    for (std::size_t k = 0; k < faces[i].size(); ++k) {
      const std::size_t a = faces[i][k], b = faces[i][(k + 1) % faces[i].size()];
      face.ring.push_back(space.turned(corners[a]));
      if (!known.insert(std::minmax(a, b)).second) continue;
      drawing.add(SpaceEdge{.id = fmt::format("box edge {:02}", known.size()),
                            .role = Role::boundary,
                            .a = space.turned(corners[a]),
                            .b = space.turned(corners[b]),
                            .of_glass = true});
    }
    if (glm::dot(area_vector(face.ring), face.ring[0] - middle) < 0) std::ranges::reverse(face.ring);
    drawing.add(std::move(face));
  }
}

inline std::vector<dvec3> corners_of(const AxisBox<3, double>& box) {
  std::vector<dvec3> corners;
  for (int corner = 0; corner < 8; ++corner) corners.push_back(box_corner(box, corner));
  return corners;
}

/// A box of glass alone.
inline void add_box(View& view, const SpaceView& space, const AxisBox<3, double>& box) {
  SpaceDrawing drawing = space.drawing();
  add_glass(drawing, space, corners_of(box), faces_of_box());
  drawing.add_to(view, "box");
}

/// A part of a plane of space, as the one that a step is about.
inline void add_face(View& view, const SpaceView& space, const std::vector<dvec3>& corners) {
  std::vector<dvec2> outline;
  for (const dvec3 p : corners) outline.push_back(space.at(p));
  view.add({"face area", Role::current, Area{{outline}}});
  view.add({"face outline", Role::current, Path{outline, true}});
}

/// Three short arrows that say which way the axes go: right, up, and away from the reader or towards him.
/// at: their foot on the paper.
inline void add_directions(View& view, dvec2 at, const std::array<std::string, 3>& names,
                           bool towards = false) {
  const std::array<dvec3, 3> ways{dvec3{1, 0, 0}, dvec3{0, 1, 0}, dvec3{0, 0, towards ? 1.4 : -1.4}};
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 to = at + 2.4 * oblique(ways[i]);
    const dvec2 name = at + (i == 2 ? 3.9 : 3.2) * oblique(ways[i]);
    view.add({"direction " + std::to_string(i), Role::guide, Stroke{at, to, true}});
    view.add({"direction name " + std::to_string(i), Role::guide, Text{name, names[i]}});
  }
}

}  // namespace gradus
