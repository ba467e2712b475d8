#pragma once
// Clipping many polygons at one rectangle: those wholly inside are copied and those wholly on one outer side
// dropped by their bounds, and only the rest is clipped, at the borders that it crosses.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"

namespace gradus::sutherland_hodgman {

/// Polygons one after the other in one array.
struct Polygons {
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> ends;  ///< of each polygon: how many points it and those before it have

  std::size_t size() const { return ends.size(); }
  std::span<const glm::dvec2> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(begin, ends[i] - begin);
  }
  void add(std::span<const glm::dvec2> polygon) {
    points.insert(points.end(), polygon.begin(), polygon.end());
    ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
};

/// What became of a batch.
struct BatchCount {
  std::size_t copied = 0, dropped = 0, clipped = 0;
};

/// The parts of polygons that lie in a rectangle, polygon by polygon, some of them empty: the vertices of
/// clip_to_window in the order left, right, bottom, top, bit for bit. Memory is kept from call to call.
///
/// Domain: finite coordinates of any size; at most 2^32 - 1 points.
/// Accuracy: that of clip_to_window.
/// Cost: two comparisons per coordinate for what isn't clipped.
/// Errors: ContractViolation for coordinates that are not finite and a window that is inside out.
class BatchClipper {
 public:
  BatchCount operator()(const Polygons& polygons, const Rectangle<double>& window, Polygons& result);

 private:
  std::vector<Vertex<double>> polygon_;
  Kept<double> kept_;
};

}  // namespace gradus::sutherland_hodgman
