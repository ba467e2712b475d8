#pragma once
// One pixel drawn large with its 32 sub-samples, the fragments' polygons over it; and masks as squares.

#include <array>
#include <string>
#include <vector>

#include "antialiasing/a_buffer/a_buffer.hpp"
#include "stories/antialiasing/ring_cut.hpp"
#include "stories/paper.hpp"
#include "stories/telling.hpp"

namespace gradus::a_buffer {

inline constexpr int paper_width = 38, paper_height = 24;

/// What lies in the pixel: a convex polygon and its place in depth.
struct Piece {
  std::string name;
  std::vector<dvec2> ring;     ///< in the pixel, from 0 to 1, y down
  std::vector<ivec2> snapped;  ///< on the grid of 1/256 pixel
  Fragment fragment;
  double left = 0, right = 0;  ///< its depths at the sides of the pixel
};

/// "f0f0f0f0", two digits per row.
inline std::string hex_of(Mask mask) { return fmt::format("{:08x}", mask); }

/// The pixel, its rows downwards.
struct LargePixel {
  static constexpr double side = 17.6;
  static constexpr dvec2 corner{0.8, 23.3};

  static dvec2 at(dvec2 p) { return {corner.x + side * p.x, corner.y - side * p.y}; }
  static dvec2 place(int sample) {
    return at({(sample % mask_columns + 0.5) / mask_columns, (sample / mask_columns + 0.5) / mask_rows});
  }
  static std::vector<dvec2> on_paper(const std::vector<dvec2>& ring) {
    std::vector<dvec2> places;
    for (const dvec2 p : ring) places.push_back(at(p));
    return places;
  }

  static void add_grid(View& view) {
    view.add({"a pixel", Role::boundary, Path{{at({0, 0}), at({1, 0}), at({1, 1}), at({0, 1})}, true}});
    for (int i = 1; i < mask_columns; ++i) {
      const double x = double{1} * i / mask_columns;
      view.add({fmt::format("a x {}", i), Role::guide, Stroke{at({x, 0}), at({x, 1}), false, false, true}});
    }
    for (int i = 1; i < mask_rows; ++i) {
      const double y = double{1} * i / mask_rows;
      view.add({fmt::format("a y {}", i), Role::guide, Stroke{at({0, y}), at({1, y}), false, false, true}});
    }
  }
  /// As much of a polygon as lies in the pixel.
  static void add_polygon(View& view, const Piece& piece, Role role, bool filled) {
    const std::vector<dvec2> ring = on_paper(ring_within(piece.ring, dvec2(0), dvec2(1)));
    if (ring.size() < 3) return;
    const std::string id = "b " + piece.name;
    if (filled) view.add({id + " inside", role, Area{{ring}, 1}});
    view.add({id, role, Path{ring, true}});
  }
  /// The first polygon's corners, or the ends of its sides, as far as they are in the pixel.
  static void let_drag(Narrator& narrator, const Piece& first) {
    narrator.handles("polygons", [&](dvec2 corner) -> std::optional<dvec2> {
      const std::optional<dvec2> place = grip({{0, 0}, {1, 1}}, first.ring, corner);
      return place ? std::optional(at(*place)) : std::nullopt;
    });
    const int numbers = 2 * static_cast<int>(first.ring.size());
    std::erase_if(narrator.trace().handles,
                  [&](const Handle& handle) { return handle.numbers[0] >= numbers; });
  }
  static void add_samples(View& view, Mask of_these, Role role, bool ring) {
    for (int i = 0; i < samples; ++i) {
      if ((of_these & bit_of(i)) != 0)
        view.add({fmt::format("d sample {:02}", i), role, Dot{place(i), ring}});
    }
  }
};

/// A mask as squares in a frame: those that are left, and those that were taken away. corner: its upper left
/// one.
struct Pattern {
  dvec2 corner;
  double square;

  double width() const { return mask_columns * square; }
  double height() const { return mask_rows * square; }
  void add_frame(View& view, const std::string& id, Role role) const {
    view.add({id + " frame", role, Path{part({0, 0}, {mask_columns, mask_rows}), true}});
  }
  /// Squares that lines fill, as tints alone are lost on a projector and dots, which keep their size, touch
  /// in small masks; hatched with a rim what is hidden.
  void add_bits(View& view, const std::string& id, Mask mask, Role role) const {
    const bool solid = role != Role::rejected && role != Role::candidate;  // those have dashed rims
    const double gap = solid ? 0.3 : 0.2;
    gradus::Area bits;
    for (int i = 0; i < samples; ++i) {
      if ((mask & bit_of(i)) == 0) continue;
      const dvec2 at{i % mask_columns, i / mask_columns};
      bits.rings.push_back(part(at + gap, at + 1.0 - gap));
      Path path{bits.rings.back(), true};
      if (solid) path.points = filled(std::move(path.points));
      view.add({fmt::format("{} bit {:02}", id, i), role, std::move(path)});
    }
    bits.shade = role == Role::rejected ? 0 : 3;
    if (!bits.rings.empty()) view.add({id + " bits", role, bits});
  }

 private:
  dvec2 at(double x, double y) const { return corner + square * dvec2(x, -y); }
  std::vector<dvec2> part(dvec2 a, dvec2 b) const {
    return {at(a.x, a.y), at(b.x, a.y), at(b.x, b.y), at(a.x, b.y)};
  }
  /// A square's rim with lines across it.
  static std::vector<dvec2> filled(std::vector<dvec2> rim) {
    const dvec2 left = rim[3] - rim[0], right = rim[2] - rim[1];
    for (const double part : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      const dvec2 a = rim[0] + part * left, b = rim[1] + part * right;
      rim.insert(rim.end(), {a, b, a});
    }
    return rim;
  }
};

}  // namespace gradus::a_buffer
