#pragma once
// What clipped polygons are measured against: exact areas in rationals, found without clipping as the topics
// do it.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/random.hpp"

namespace gradus::test {

using Rational = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Rational x, y;
  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};
inline ExactPoint exact_point(glm::dvec2 p) { return {Rational(p.x), Rational(p.y)}; }

/// det(b - a, c - a).
inline Rational turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
/// Where the lines a b and c d cross. Domain: not parallel.
inline ExactPoint exact_crossing(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                 const ExactPoint& d) {
  const Rational from = turn(c, d, a), t = from / (from - turn(c, d, b));
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// With its sign: positive counter-clockwise.
inline Rational exact_area(const std::vector<ExactPoint>& ring) {
  Rational doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}
inline Rational exact_area(const std::vector<glm::dvec2>& ring) {
  std::vector<ExactPoint> points;
  for (const glm::dvec2& p : ring) points.push_back(exact_point(p));
  return exact_area(points);
}

/// The area that a ring has in a rectangle, points counted as often as it goes round them: edge by edge, the
/// signed area between the edge, held between the lower and the upper border, and the lower border.
inline Rational area_in_rectangle(const std::vector<glm::dvec2>& ring, glm::dvec2 lower, glm::dvec2 upper) {
  Rational area = 0;
  const ExactPoint low = exact_point(lower), high = exact_point(upper);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint p = exact_point(ring[i]), q = exact_point(ring[(i + 1) % ring.size()]);
    if (p.x == q.x) continue;
    const Rational slope = (q.y - p.y) / (q.x - p.x);
    const auto inside = [&](const Rational& x) -> Rational { return std::clamp(x, low.x, high.x); };
    // Between these places the edge stays below, in or above the rectangle
    std::vector<Rational> places{inside(p.x), inside(q.x)};
    const auto [first, last] = std::minmax(places[0], places[1]);
    const Rational begin = first, end = last;
    if (slope != 0) {
      for (const Rational& y : {low.y, high.y}) {
        const Rational x = p.x + (y - p.y) / slope;
        if (begin < x && x < end) places.push_back(x);
      }
    }
    std::sort(places.begin(), places.end());
    Rational below = 0;
    const auto height = [&](const Rational& x) -> Rational {
      return std::clamp<Rational>(p.y + (x - p.x) * slope, low.y, high.y) - low.y;
    };
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      below += (places[k + 1] - places[k]) * (height(places[k]) + height(places[k + 1])) / 2;
    }
    area += p.x < q.x ? -below : below;
  }
  return area;
}

/// The part of a triangle inside of a half-plane, in rationals.
inline std::vector<ExactPoint> half(const std::vector<ExactPoint>& convex, const ExactPoint& a,
                                    const ExactPoint& b) {
  std::vector<ExactPoint> kept;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const ExactPoint &p = convex[i], &q = convex[(i + 1) % convex.size()];
    const Rational f = turn(a, b, p), g = turn(a, b, q);
    if (f >= 0) kept.push_back(p);
    if ((f > 0 && g < 0) || (f < 0 && g > 0)) kept.push_back(exact_crossing(p, q, a, b));
  }
  return kept;
}

/// The same in any convex window, counter-clockwise: the ring is a sum of signed triangles from one point,
/// and a triangle's part in the window is a convex polygon.
inline Rational area_in_convex(const std::vector<glm::dvec2>& ring, const std::vector<glm::dvec2>& window) {
  Rational area = 0;
  if (ring.empty()) return area;
  const ExactPoint origin = exact_point(ring[0]);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const ExactPoint p = exact_point(ring[i]), q = exact_point(ring[i + 1]);
    const Rational doubled = turn(origin, p, q);
    if (doubled == 0) continue;
    std::vector<ExactPoint> part{origin, p, q};
    if (doubled < 0) std::swap(part[1], part[2]);
    for (std::size_t k = 0; k < window.size(); ++k) {
      part = half(part, exact_point(window[k]), exact_point(window[(k + 1) % window.size()]));
    }
    area += doubled < 0 ? -exact_area(part) : exact_area(part);
  }
  return area;
}

/// A region made of unit cells, some of them there: its rings, area left, and what is connected in it.
struct Cells {
  int width, height;
  std::vector<bool> there;

  bool at(int x, int y) const {
    return 0 <= x && x < width && 0 <= y && y < height && there[static_cast<std::size_t>(y * width + x)];
  }
  void set(int x, int y, bool value) { there[static_cast<std::size_t>(y * width + x)] = value; }
};

/// The number of the connected part that every cell belongs to, by common sides; -1 where there is none.
inline std::vector<int> parts_of(const Cells& cells) {
  std::vector<int> part(cells.there.size(), -1);
  int parts = 0;
  for (int start = 0; start < cells.width * cells.height; ++start) {
    if (!cells.there[static_cast<std::size_t>(start)] || part[static_cast<std::size_t>(start)] >= 0) continue;
    std::vector<int> open{start};
    part[static_cast<std::size_t>(start)] = parts;
    while (!open.empty()) {
      const int cell = open.back(), x = cell % cells.width, y = cell / cells.width;
      open.pop_back();
      for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
        const std::size_t next = static_cast<std::size_t>((y + dy) * cells.width + x + dx);
        if (!cells.at(x + dx, y + dy) || part[next] >= 0) continue;
        part[next] = parts;
        open.push_back(static_cast<int>(next));
      }
    }
    ++parts;
  }
  return part;
}

/// The rings round the cells, area on the left, corners only. Where two cells touch at a corner, the ring
/// turns left, round its own cell: so parts that only touch have rings of their own.
inline std::vector<std::vector<glm::dvec2>> rings_of(const Cells& cells) {
  // An edge runs from its corner to the right (0), up (1), left (2) or down (3), with a cell on its left only
  const std::array<glm::ivec2, 4> step{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const std::array<glm::ivec2, 4> left{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  const std::array<glm::ivec2, 4> right{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
  const auto is_edge = [&](glm::ivec2 p, std::size_t d) {
    const glm::ivec2 l = p + left[d], r = p + right[d];
    return cells.at(l.x, l.y) && !cells.at(r.x, r.y);
  };
  std::vector<std::array<bool, 4>> used(static_cast<std::size_t>((cells.width + 1) * (cells.height + 1)));
  const auto mark = [&](glm::ivec2 p) -> std::array<bool, 4>& {
    return used[static_cast<std::size_t>(p.y * (cells.width + 1) + p.x)];
  };
  std::vector<std::vector<glm::dvec2>> rings;
  for (int y = 0; y <= cells.height; ++y) {
    for (int x = 0; x <= cells.width; ++x) {
      for (std::size_t d = 0; d < 4; ++d) {
        glm::ivec2 p{x, y};
        if (!is_edge(p, d) || mark(p)[d]) continue;
        std::vector<glm::dvec2> ring;
        std::size_t way = d;
        while (!mark(p)[way]) {
          mark(p)[way] = true;
          const std::size_t before = way;
          p += step[way];
          for (const std::size_t turned : {std::size_t{1}, std::size_t{0}, std::size_t{3}}) {
            const std::size_t next = (before + turned) % 4;
            if (!is_edge(p, next)) continue;
            way = next;
            break;
          }
          if (way != before) ring.push_back(glm::dvec2(p));
        }
        rings.push_back(ring);
      }
    }
  }
  return rings;
}

}  // namespace gradus::test
