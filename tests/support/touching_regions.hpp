#pragma once
// Regions of the plane made of triangles, whose rings touch themselves and each other as much as rings can:
// in corners, and with a corner in the middle of an edge. Area and parts are counted, so that both are exact.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "core/random.hpp"

namespace gradus::test {

/// Squares of side 1, each cut by the diagonal that runs through a corner where both coordinates are even or
/// both odd: edges go in eight directions.
class Triangles {
 public:
  using Corners = std::array<glm::ivec2, 3>;  // counter-clockwise

  explicit Triangles(int side) : side_(side) {}
  int side() const { return side_; }
  std::size_t size() const { return static_cast<std::size_t>(2 * side_ * side_); }
  Corners operator[](std::size_t number) const {
    const int square = static_cast<int>(number / 2);
    const glm::ivec2 a{square % side_, square / side_}, b = a + glm::ivec2(1, 0), c = a + glm::ivec2(1, 1),
                                                        d = a + glm::ivec2(0, 1);
    const bool upper = number % 2 == 1;
    if ((a.x + a.y) % 2 == 0) return upper ? Corners{a, c, d} : Corners{a, b, c};
    return upper ? Corners{b, c, d} : Corners{a, b, d};
  }

 private:
  int side_;
};

/// Some of the triangles.
struct TriangleRegion {
  Triangles all;
  std::vector<bool> there;

  explicit TriangleRegion(int side) : all(side), there(all.size()) {}

  /// The number of the part that every triangle belongs to, -1 where there is none. Triangles of one part
  /// hang together by edges, or by corners if asked for.
  std::vector<int> parts(bool by_corners = false) const {
    std::vector<int> part(there.size(), -1);
    std::map<std::pair<int, int>, std::vector<std::size_t>> at_corner;
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (!there[i]) continue;
      for (const glm::ivec2 p : all[i]) at_corner[{p.x, p.y}].push_back(i);
    }
    int parts = 0;
    for (std::size_t start = 0; start < there.size(); ++start) {
      if (!there[start] || part[start] >= 0) continue;
      std::vector<std::size_t> open{start};
      part[start] = parts;
      while (!open.empty()) {
        const std::size_t now = open.back();
        open.pop_back();
        for (const glm::ivec2 p : all[now]) {
          for (const std::size_t next : at_corner[{p.x, p.y}]) {
            if (part[next] >= 0 || (!by_corners && common_corners(now, next) < 2)) continue;
            part[next] = parts;
            open.push_back(next);
          }
        }
      }
      ++parts;
    }
    return part;
  }

  /// The triangles in a rectangle; none may reach across its border.
  TriangleRegion within(glm::ivec2 lower, glm::ivec2 upper) const {
    TriangleRegion inside = *this;
    for (std::size_t i = 0; i < there.size(); ++i) {
      for (const glm::ivec2 p : all[i]) {
        if (p.x < lower.x || p.y < lower.y || p.x > upper.x || p.y > upper.y) inside.there[i] = false;
      }
    }
    return inside;
  }

  /// The parts that hang together by edges, as regions of their own.
  std::vector<TriangleRegion> apart() const {
    std::vector<TriangleRegion> regions;
    const auto part = parts();
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (part[i] < 0) continue;
      const auto number = static_cast<std::size_t>(part[i]);
      if (regions.size() <= number) regions.resize(number + 1, TriangleRegion(all.side()));
      regions[number].there[i] = true;
    }
    return regions;
  }
  /// The largest part, by edges or by corners.
  TriangleRegion largest_part() const {
    const auto part = parts(true);
    std::map<int, int> count;
    for (const int p : part) ++count[p];
    count.erase(-1);
    TriangleRegion largest(all.side());
    if (count.empty()) return largest;
    const int number = std::ranges::max_element(count, {}, [](const auto& c) { return c.second; })->first;
    for (std::size_t i = 0; i < part.size(); ++i) largest.there[i] = part[i] == number;
    return largest;
  }
  /// The same in squares of half the side, counted as 1: every triangle becomes four.
  TriangleRegion refined() const {
    TriangleRegion fine(2 * all.side());
    for (std::size_t i = 0; i < fine.there.size(); ++i) {
      const auto [a, b, c] = fine.all[i];
      fine.there[i] = at(a + b + c);
    }
    return fine;
  }
  /// How many triangles there are, each of area 1/2.
  int count() const { return static_cast<int>(std::count(there.begin(), there.end(), true)); }

  /// Whether the triangle with this point is there. Sixths of the grid, inside a triangle.
  bool at(glm::ivec2 sixth) const {
    const auto square = static_cast<std::size_t>(sixth.y / 6 * all.side() + sixth.x / 6);
    const glm::ivec2 inside{sixth.x % 6, sixth.y % 6};
    const bool rising = (sixth.x / 6 + sixth.y / 6) % 2 == 0;
    const bool upper = rising ? inside.y > inside.x : inside.x + inside.y > 6;
    return there[2 * square + (upper ? 1 : 0)];
  }
  int common_corners(std::size_t a, std::size_t b) const {
    int common = 0;
    for (const glm::ivec2 p : all[a]) {
      for (const glm::ivec2 q : all[b]) common += p == q;
    }
    return common;
  }
};

/// A region in one part, by edges or by corners.
inline TriangleRegion random_region(int side, Random& random) {
  TriangleRegion region(side);
  const double density = random.uniform(0.45, 0.9);
  for (std::size_t i = 0; i < region.there.size(); ++i) region.there[i] = random.unit() < density;
  return region.largest_part();
}

/// The edges round a region, area on the left, joined to rings.
class RegionRings {
 public:
  using Ring = std::vector<glm::ivec2>;

  explicit RegionRings(const TriangleRegion& region) {
    std::map<Key, int> run;
    for (std::size_t i = 0; i < region.there.size(); ++i) {
      if (!region.there[i]) continue;
      const auto corners = region.all[i];
      for (std::size_t k = 0; k < 3; ++k) run[key(corners[k], corners[(k + 1) % 3])] = 1;
    }
    for (const auto& [edge, one] : run) {
      if (!run.contains({edge[2], edge[3], edge[0], edge[1]})) {
        edges_.push_back({{edge[0], edge[1]}, {edge[2], edge[3]}});
      }
    }
  }

  /// At every corner where more than two edges meet they are joined so that no two ways cross: at random, or
  /// so that the ring turns as far right as it can. Then the ring of the outer border comes as one.
  std::vector<Ring> joined(bool at_random, Random& random) const {
    std::map<std::pair<int, int>, std::vector<End>> meeting;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto [p, q] = edges_[i];
      meeting[{p.x, p.y}].push_back({direction(q - p), true, i});
      meeting[{q.x, q.y}].push_back({direction(p - q), false, i});
    }
    std::vector<std::size_t> next(edges_.size());
    for (auto& [corner, ends] : meeting) {
      std::sort(ends.begin(), ends.end(),
                [](const End& a, const End& b) { return a.direction < b.direction; });
      if (!at_random) {
        // From where it comes counter-clockwise to the first one that goes
        while (ends[0].goes) std::rotate(ends.begin(), ends.begin() + 1, ends.end());
      } else {
        const auto turned = random.uniform_int(0, static_cast<std::int64_t>(ends.size()) - 1);
        std::rotate(ends.begin(), ends.begin() + turned, ends.end());
      }
      std::vector<End> open;
      const auto join_last = [&](const End& with) {
        (with.goes ? next[open.back().edge] : next[with.edge]) = with.goes ? with.edge : open.back().edge;
        open.pop_back();
      };
      for (const End& end : ends) {
        const bool fits = !open.empty() && open.back().goes != end.goes;
        if (fits && (!at_random || random.unit() < 0.6)) {
          join_last(end);
        } else {
          open.push_back(end);
        }
      }
      while (!open.empty()) {
        const End last = open.back();
        open.pop_back();
        join_last(last);
      }
    }
    std::vector<bool> used(edges_.size());
    std::vector<Ring> rings;
    for (std::size_t first = 0; first < edges_.size(); ++first) {
      Ring ring;
      for (std::size_t i = first; !used[i]; i = next[i]) {
        used[i] = true;
        ring.push_back(edges_[i].first);
      }
      if (!ring.empty()) rings.push_back(ring);
    }
    return rings;
  }

  /// Of a region in one part the outline and the holes that touch it or one another; joined at random, if
  /// that leaves one outline.
  std::vector<Ring> polygon(Random& random) const {
    for (const bool at_random : {true, false}) {
      std::vector<Ring> rings = joined(at_random, random);
      const auto outline =
          std::partition(rings.begin(), rings.end(), [](const Ring& r) { return turn(r) > 0; });
      if (outline - rings.begin() == 1) return rings;
    }
    return {};
  }

  /// How many simple rings bound a region that is one part by edges: edges - corners + connected parts of its
  /// border, for no two of the rings have more than a corner in common.
  int simple_rings() const {
    std::map<std::pair<int, int>, std::pair<int, int>> leader;
    const auto corner = [](glm::ivec2 p) { return std::pair(p.x, p.y); };
    const auto find = [&](std::pair<int, int> p) {
      while (leader[p] != p) p = leader[p];
      return p;
    };
    for (const auto& [p, q] : edges_) leader[corner(p)] = corner(p);
    const int corners = static_cast<int>(leader.size());
    int parts = corners;
    for (const auto& [p, q] : edges_) {
      const auto a = find(corner(p)), b = find(corner(q));
      if (a == b) continue;
      leader[a] = b;
      --parts;
    }
    return static_cast<int>(edges_.size()) - corners + parts;
  }

  /// Twice the area.
  static int turn(const Ring& ring) {
    int doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::ivec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      doubled += a.x * b.y - a.y * b.x;
    }
    return doubled;
  }

 private:
  using Key = std::array<int, 4>;
  struct End {
    int direction;  // as seen from the corner, counter-clockwise
    bool goes;
    std::size_t edge;
  };
  static Key key(glm::ivec2 p, glm::ivec2 q) { return {p.x, p.y, q.x, q.y}; }
  static int direction(glm::ivec2 d) {
    const int around[3][3] = {{5, 6, 7}, {4, -1, 0}, {3, 2, 1}};
    return around[d.y + 1][d.x + 1];
  }

  std::vector<std::pair<glm::ivec2, glm::ivec2>> edges_;
};

/// The ring from another vertex on, the other way round or not, and with only some of the vertices at which
/// it goes straight on.
inline std::vector<glm::dvec2> told_otherwise(RegionRings::Ring ring, Random& random) {
  std::vector<glm::dvec2> points;
  const double kept = random.unit();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::ivec2 a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i],
                     c = ring[(i + 1) % ring.size()];
    const glm::ivec2 u = b - a, v = c - b;
    if (u.x * v.y != u.y * v.x || random.unit() < kept) points.emplace_back(b);
  }
  std::rotate(points.begin(),
              points.begin() + random.uniform_int(0, static_cast<std::int64_t>(points.size()) - 1),
              points.end());
  if (random.uniform_int(0, 1)) std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace gradus::test
