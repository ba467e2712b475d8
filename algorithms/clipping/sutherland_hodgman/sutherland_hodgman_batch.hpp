#pragma once
// Clipping many polygons at one rectangle: those wholly inside are copied and those wholly on one outer side
// dropped by their bounds, and only the rest is clipped, at the borders that it crosses.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "clipping/sutherland_hodgman/batch_passes.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

namespace gradus::sutherland_hodgman {

/// What became of a batch.
struct BatchCount {
  std::size_t copied = 0, dropped = 0, clipped = 0;
};

/// The parts of polygons that lie in a rectangle, polygon by polygon, some of them empty: the vertices of
/// clip_to_window in the order left, right, bottom, top, bit for bit. Memory is kept from call to call, that
/// of the result, too.
///
/// polygons: any number. result: not `polygons` itself; what stood there is gone.
///
/// Returns how many were copied as they are, dropped by their bounds, and clipped.
///
/// Domain: finite coordinates of any size; at most 2^32 - 1 points, 2^27 in one polygon.
/// Accuracy: that of clip_to_window: exact decisions, and a made vertex the nearest to the exact one. Of
///   floats nearly all come from one division of doubles with a bound of its error, of doubles from sums of
///   two doubles; where the bound leaves the last bit open, cut_coordinate has the word.
/// Cost: 3 to 4 ns per vertex of what isn't clipped; else 4 to 25 ns in float, 8 to 45 ns in double, the more
///   the more edges are cut. A window without width or height takes as long as clip_to_window.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out; the result
///   has the polygons before that one then.
template <std::floating_point T = double>
class BatchClipper {
 public:
  BatchCount operator()(const Polygons<T>& polygons, const Rectangle<T>& window, Polygons<T>& result) {
    expect_window(window);
    BatchCount count;
    result.points.clear();
    result.ends.clear();
    result.ends.reserve(polygons.size());
    part_.start(window);
    for (std::size_t i = 0; i < polygons.size(); ++i) ++(count.*add(polygons[i], window, result));
    part_.finish(result);
    return count;
  }

 private:
  /// Adds what is left of a polygon, or has it added with others, and says what becomes of it.
  std::size_t BatchCount::* add(std::span<const glm::vec<2, T>> points, const Rectangle<T>& window,
                                Polygons<T>& result) {
    if (points.size() < 3) return add_checked(points, &BatchCount::dropped, result);
    const detail::Reach<T> reach = detail::reach_of(points, part_.room_for(points.size()));
    const bool crosses_x = (reach.lower.x < window.lower.x) | (reach.upper.x > window.upper.x);
    const bool crosses_y = (reach.lower.y < window.lower.y) | (reach.upper.y > window.upper.y);
    // Wholly on the outer side of one border, or on the inner side of all?
    if ((reach.upper.x < window.lower.x) | (reach.lower.x > window.upper.x) |
        (reach.upper.y < window.lower.y) | (reach.lower.y > window.upper.y) | !reach.finite) {
      return add_checked(points, &BatchCount::dropped, result);
    }
    if (!(crosses_x | crosses_y)) return add_checked(points, &BatchCount::copied, result);
    if (window.lower.x < window.upper.x && window.lower.y < window.upper.y) {
      part_.add(points.size(), crosses_x, crosses_y);
      if (part_.full()) part_.finish(result);
    } else {
      for (const Vertex<T>& vertex : clip_to_window(points, window)) result.points.push_back(vertex.at);
      result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    }
    return &BatchCount::clipped;
  }
  /// After those that wait.
  std::size_t BatchCount::* add_checked(std::span<const glm::vec<2, T>> points,
                                        std::size_t BatchCount::* what, Polygons<T>& result) {
    part_.finish(result);
    expect_finite(points);
    if (what == &BatchCount::copied) {
      result.points.insert(result.points.end(), points.begin(), points.end());
    }
    result.ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    return what;
  }

  detail::Part<T> part_;
};

}  // namespace gradus::sutherland_hodgman
