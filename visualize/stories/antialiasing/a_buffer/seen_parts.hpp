#pragma once
// What of the polygons in a pixel is really seen, by geometry rather than by masks: the areas to hold the
// shares against, the sides to draw, a place for each name.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "stories/antialiasing/a_buffer/drawing.hpp"
#include "stories/rings.hpp"

namespace gradus::a_buffer {

inline double area_of(const Ring2& ring) {
  double doubled = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) doubled += side_of(ring[0], ring[i - 1], ring[i]);
  return doubled / 2;
}
/// How far a place is from the sides of a ring, where a text is twice as wide as high.
inline double distance_to(const Ring2& ring, dvec2 p, double most) {
  const dvec2 narrow{0.5, 1};
  for (const auto& [a, b] : sides_of(ring)) {
    const dvec2 way = (b - a) * narrow, to = (p - a) * narrow;
    const double length = glm::dot(way, way);
    const double t = length > 0 ? std::clamp(glm::dot(to, way) / length, 0.0, 1.0) : 0;
    most = std::min(most, length_of(to - t * way));
  }
  return most;
}

/// The convex polygons of a pixel, each with what lies in front of it.
class SeenParts {
 public:
  explicit SeenParts(const std::vector<Piece>& pieces) : pieces_(pieces) {
    for (const Piece& piece : pieces) {
      Ring2 ring = ring_within(piece.ring, dvec2(0), dvec2(1));
      if (area_of(ring) < 0) std::ranges::reverse(ring);
      rings_.push_back(ring.size() > 2 ? ring : Ring2{});
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) parts_.push_back(parts_of(i));
  }

  /// Its share of the pixel, by area and opacity.
  double share(std::size_t i) const {
    double sum = 0;
    for (const auto& [ring, light] : parts_[i]) sum += light * area_of(ring);
    return sum * pieces_[i].fragment.opacity;
  }
  /// The polygons' numbers by their nearest depths.
  std::vector<std::size_t> front_to_back() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pieces_.size(); ++i) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return pieces_[i].fragment.z_near; });
    return order;
  }

  /// Its sides without what opaque polygons hide.
  Ways sides(std::size_t i) const {
    Ways seen = sides_of(rings_[i]);
    for (std::size_t g = 0; g < pieces_.size(); ++g) {
      if (pieces_[g].fragment.opacity == 1) seen = outside_of(in_front(g, i), seen);
    }
    return seen;
  }

  /// Above or below a sub-sample, where its name is on it and far from all sides; nothing where it is hidden.
  std::optional<dvec2> name_place(std::size_t i) const {
    std::optional<dvec2> best;
    double farthest = 0.02;
    for (int k = 0; k < 2 * samples; ++k) {
      const int half_row = k / mask_columns, row = half_row / 2;
      const dvec2 p{(k % mask_columns + 0.5) / mask_columns,
                    (row + (half_row % 2 == 0 ? 0.21 : 0.79)) / mask_rows};
      const auto holds_it = [&](const auto& part) { return holds(part.first, p); };
      if (std::ranges::none_of(parts_[i], holds_it)) continue;
      double off = 1;
      for (const Ring2& ring : rings_) off = distance_to(ring, p, off);
      if (off > farthest + 1e-9) farthest = off, best = p;
    }
    return best;
  }

 private:
  using Part = std::pair<Ring2, double>;  ///< and how much of the light gets there

  static bool holds(const Ring2& ring, dvec2 p) {
    return !ring.empty() && std::ranges::none_of(sides_of(ring), [&](const auto& side) {
      return side_of(side.first, side.second, p) < 0;
    });
  }
  /// What of polygon g lies in front of polygon i: depths change across the pixel only, so an upright line
  /// parts it.
  Ring2 in_front(std::size_t g, std::size_t i) const {
    const double left = pieces_[g].left - pieces_[i].left, right = pieces_[g].right - pieces_[i].right;
    if (g == i || (left >= 0 && right >= 0 && (left > 0 || right > 0 || g > i))) return {};
    if (left <= 0 && right <= 0) return rings_[g];
    return ring_cut(rings_[g], 0, left / (left - right), left < 0 ? -1 : 1);
  }
  std::vector<Part> parts_of(std::size_t i) const {
    std::vector<Part> parts{{rings_[i], 1}};
    for (std::size_t g = 0; g < pieces_.size(); ++g) {
      const Ring2 front = in_front(g, i);
      std::vector<Part> next;
      for (Part& part : parts) {
        for (const auto& [a, b] : sides_of(front)) {
          next.emplace_back(half(part.first, b, a), part.second);
          part.first = half(part.first, a, b);
        }
        if (!front.empty()) part.second *= 1 - pieces_[g].fragment.opacity;
        next.push_back(part);
      }
      std::erase_if(next, [](const Part& part) { return part.second == 0 || area_of(part.first) < 1e-9; });
      parts = next;
    }
    return parts;
  }
  /// The part of a convex ring on the left of the way from a to b.
  static Ring2 half(const Ring2& ring, dvec2 a, dvec2 b) {
    Ring2 kept;
    for (const auto& [p, q] : sides_of(ring)) {
      const double from = side_of(a, b, p), to = side_of(a, b, q);
      if (from >= 0) kept.push_back(p);
      if ((from < 0) != (to < 0)) kept.push_back(p + from / (from - to) * (q - p));
    }
    return kept;
  }

  const std::vector<Piece>& pieces_;
  std::vector<Ring2> rings_;
  std::vector<std::vector<Part>> parts_;
};

}  // namespace gradus::a_buffer
