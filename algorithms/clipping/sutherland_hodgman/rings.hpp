#pragma once
// The rings of a polygon, its outline and its holes: turned so that the inside lies left, and joined where
// they touch.

#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "clipping/sutherland_hodgman/touching_rings.hpp"

namespace gradus::sutherland_hodgman {

/// A point, and the place of a vertex.
template <class T>
const glm::vec<2, T>& place_of(const glm::vec<2, T>& point) {
  return point;
}
template <class T>
const glm::vec<2, T>& place_of(const Vertex<T>& vertex) {
  return vertex.at;
}

/// The sign of twice the area of a ring of points or vertices. Exact. Domain: finite. Cost: a few ns per
/// vertex, in doubt 60.
template <class P>
int area_sign(std::span<const P> ring) {
  using T = std::remove_cvref_t<decltype(place_of(ring[0]).x)>;
  const std::size_t n = ring.size();
  const auto at = [ring, n](std::size_t i) -> const glm::vec<2, T>& { return place_of(ring[i < n ? i : 0]); };
  if constexpr (std::floating_point<T>) {
    // In plain arithmetic, wrong by less than 2^-50 of the sizes added up for each vertex
    double estimate = 0, sizes = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 a(at(i)), b(at(i + 1));
      estimate += a.x * b.y - a.y * b.x;
      sizes += std::abs(a.x * b.y) + std::abs(a.y * b.x);
    }
    const double bound = 0x1p-50 * static_cast<double>(n + 1) * sizes + 0x1p-1000;
    if (std::abs(estimate) > bound) return sign_of(estimate);
    SumOfProducts<2> doubled;
    for (std::size_t i = 0; i < n; ++i) {
      const glm::dvec2 a(at(i)), b(at(i + 1));
      doubled.add(a.x, b.y);
      doubled.subtract(a.y, b.x);
    }
    return doubled.sign();
  } else {
    T doubled(0);
    for (std::size_t i = 0; i < n; ++i) {
      const auto &a = at(i), &b = at(i + 1);
      doubled += a.x * b.y - a.y * b.x;
    }
    return sign_of(doubled);
  }
}

/// Rings in a vector, an array or braces, each a row of points itself.
template <class Row>
concept RowOfRings = ContiguousRow<Row> && PointRow<ItemOf<Row>, 2>;
using RingsInBraces = std::initializer_list<std::vector<glm::dvec2>>;

/// The rings of a polygon: the first one its outline, the others holes, which lie in it.
template <class T>
struct Rings {
  std::vector<glm::vec<2, T>> points;  ///< as they are given, one ring after the other
  std::vector<int> next;               ///< of each vertex, so that the area lies left
  std::vector<Ring<T>> rings;  ///< joined where they touch: each round one connected part of the inside
  bool touch = false;          ///< whether they do

  /// Outline counter-clockwise, holes clockwise, whichever way they come; a ring of area 0 stays as it is.
  template <RowOfRings Given = RingsInBraces>
    requires std::same_as<ScalarOf<ItemOf<Given>>, T>
  explicit Rings(const Given& given) {
    for (const auto& ring : given) add(span_of(ring));
    join_touching();
  }
  /// An outline without holes.
  template <PointRow<2> Points = PointsInBraces<2>>
    requires std::same_as<ScalarOf<Points>, T>
  explicit Rings(const Points& outline) {
    add(span_of(outline));
    join_touching();
  }

 private:
  void add(std::span<const glm::vec<2, T>> ring) {
    expect_finite(ring);
    const bool reverse = area_sign(ring) == (rings.empty() ? -1 : 1);
    const int first = static_cast<int>(points.size()), n = static_cast<int>(ring.size());
    points.insert(points.end(), ring.begin(), ring.end());
    for (int i = 0; i < n; ++i) next.push_back(first + (reverse ? i + n - 1 : i + 1) % n);
    rings.push_back(ring_from(first, n));
  }
  void join_touching() {
    const Outline<T> outline{points, next};
    if (surely_apart(outline)) return;
    TouchingRings<T> touching(outline);
    touch = touching.touch();
    if (touch) rings = touching.joined();
  }
  bool surely_apart(const Outline<T>& outline) const {
    if constexpr (std::floating_point<T>) {
      if (rings.size() == 1 && goes_round_a_point(outline)) return true;
    }
    return TouchSearch<T>(outline).answer() == false;
  }
  Ring<T> ring_from(int first, int n) const {
    Ring<T> ring;
    ring.reserve(static_cast<std::size_t>(n));
    for (int i = first; std::ssize(ring) < n; i = next[static_cast<std::size_t>(i)]) {
      ring.push_back({points[static_cast<std::size_t>(i)], i, {}, {}, EdgeName::polygon(i)});
    }
    return ring;
  }
};
template <RowOfRings Given>
Rings(const Given&) -> Rings<ScalarOf<ItemOf<Given>>>;
template <PointRow<2> Points>
Rings(const Points&) -> Rings<ScalarOf<Points>>;
Rings(RingsInBraces) -> Rings<double>;
Rings(PointsInBraces<2>) -> Rings<double>;

}  // namespace gradus::sutherland_hodgman
