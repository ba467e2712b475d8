#pragma once
// Which pixels a face covers, as the z-buffer asks for them: as a range, whole or row by row.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <iterator>
#include <vector>

#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "visibility/z_buffer/face_plane.hpp"

namespace gradus::z_buffer {

/// How far a corner may lie from the picture's first one, in pixels.
inline constexpr int farthest = 1 << 15;

/// The pixels whose centres a convex polygon holds. Corners are snapped to 1/256 pixel, as those of
/// triangle_coverage are, and centres on an edge belong to the face right of it or below. Snapping may bend
/// the ring inwards at a short edge, so that its turns about a centre are counted, not its edges' sides.
class Outline {
 public:
  explicit Outline(const Face& face, const Window& picture) {
    const auto& c = face.corners;
    expects(c.size() >= 3, "a face has at least three corners, not {}", c.size());
    std::vector<ivec2> at;
    for (const dvec3& corner : c) {
      expects(near_enough(corner), "a corner lies at ({}, {}, {}), farther than {} pixels out or nowhere",
              corner.x, corner.y, corner.z, farthest);
      at.push_back(triangle_coverage::snap(dvec2(corner)));
    }
    std::int64_t area = 0;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      area += triangle_coverage::doubled_area({at[0], at[i], at[i + 1]});
    }
    if (area == 0) return;
    for (std::size_t i = 0; i < at.size(); ++i) add_edge(at[i], at[i + 1 < at.size() ? i + 1 : 0]);
    box_ = intersection(box_of(at), picture);
  }

  /// The pixels that are worth asking; empty for a face without area.
  const Window& box() const { return box_; }
  bool holds(ivec2 pixel) const {
    const ivec2 centre = triangle_coverage::centre_of(pixel);
    int turns = 0;
    for (const auto& edge : edges_) turns += turn(edge, centre);
    return turns != 0;
  }
  /// The pixels that are held, row by row from the top, each row from the left.
  auto pixels() const { return Held(*this, box_); }
  /// Those of row y alone.
  auto row(int y) const { return Held(*this, {{box_.lower.x, y}, {box_.upper.x, y}}); }

 private:
  /// The pixels of a rectangle that an outline holds, as a range.
  class Held {
   public:
    Held(const Outline& outline, const Window& window)
        : outline_(outline), window_(intersection(window, outline.box_)) {}
    Held begin() const {
      Held first = *this;
      first.at_ = window_.lower;
      if (window_.width() <= 0) first.at_.y = window_.upper.y + 1;
      first.find();
      return first;
    }
    std::default_sentinel_t end() const { return {}; }
    ivec2 operator*() const { return at_; }
    Held& operator++() {
      step();
      find();
      return *this;
    }
    bool operator==(std::default_sentinel_t) const { return at_.y > window_.upper.y; }

   private:
    void find() {
      while (*this != end() && !outline_.holds(at_)) step();
    }
    void step() {
      if (++at_.x <= window_.upper.x) return;
      at_ = {window_.lower.x, at_.y + 1};
    }

    const Outline& outline_;
    const Window window_;
    ivec2 at_{};
  };
  static bool near_enough(const dvec3& c) {
    return std::abs(c.x) <= farthest && std::abs(c.y) <= farthest && std::isfinite(c.z);
  }
  /// What an edge adds to the turns: one way or the other where it crosses the row at the place or left of
  /// it.
  static int turn(const triangle_coverage::Edge& edge, ivec2 place) {
    const bool up = edge.to.y <= place.y, down = edge.from.y <= place.y;
    if (up == down) return 0;
    const std::int64_t side = edge.at(place);
    return up ? side >= 0 : -(side <= 0);
  }
  void add_edge(ivec2 from, ivec2 to) {
    if (from != to) edges_.push_back({from, to, triangle_coverage::top_or_left(from, to)});
  }
  static Window box_of(const std::vector<ivec2>& at) {
    ivec2 lower = at[0], upper = at[0];
    for (const ivec2 p : at) lower = glm::min(lower, p), upper = glm::max(upper, p);
    return {{lower.x >> 8, lower.y >> 8}, {upper.x >> 8, upper.y >> 8}};
  }

  std::vector<triangle_coverage::Edge> edges_;
  Window box_{{0, 0}, {-1, -1}};
};

}  // namespace gradus::z_buffer
