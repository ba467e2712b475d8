#pragma once
// How much of a line each pixel has, by other ways than the methods': the oracles of antialiased lines.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/geometry.hpp"

namespace gradus::stress {

/// The part of the cone of radius 1 and volume 1 about a pixel's centre within a line of width 1 whose axis
/// is so far away: by rings, of each of which the line has some angle. Accuracy: 2e-6 with 4000 rings.
inline double cone_by_rings(double distance, int rings = 4000) {
  constexpr double pi = 3.14159265358979323846;
  const auto angle = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double r = (i + 0.5) / rings;
    sum += (1 - r) * r * 2 * (angle((distance - 0.5) / r) - angle((distance + 0.5) / r));
  }
  return 3 / pi * sum / rings;
}

/// The same from a table of its values: for many pixels. Accuracy: 5e-6.
inline double cone_looked_up(double distance) {
  constexpr int steps = 1024;
  static const std::vector<double> values = [] {
    std::vector<double> all;
    for (int i = 0; i <= 3 * steps / 2 + 1; ++i)
      all.push_back(cone_by_rings(static_cast<double>(i) / steps, 2000));
    return all;
  }();
  if (distance >= 1.5) return 0;
  const double place = distance * steps;
  const auto i = static_cast<std::size_t>(place);
  return std::lerp(values[i], values[i + 1], place - static_cast<double>(i));
}

/// Numbers a + b sqrt(n), exactly: the corners of a rectangle about a line with whole ends are such.
struct Surd {
  Exact a{}, b{};
  Exact n{};  ///< no square unless b is 0 wherever it occurs

  friend Surd operator+(const Surd& x, const Surd& y) { return {x.a + y.a, x.b + y.b, x.n}; }
  friend Surd operator-(const Surd& x, const Surd& y) { return {x.a - y.a, x.b - y.b, x.n}; }
  friend Surd operator*(const Surd& x, const Surd& y) {
    return {x.a * y.a + x.b * y.b * x.n, x.a * y.b + x.b * y.a, x.n};
  }
  friend Surd operator/(const Surd& x, const Surd& y) {
    const Exact norm = y.a * y.a - y.b * y.b * x.n;
    return x * Surd{y.a / norm, -y.b / norm, x.n};
  }
  int sign() const {
    const int one = gradus::sign(a), other = gradus::sign(b);
    if (one * other >= 0) return one != 0 ? one : other;
    return one * gradus::sign(a * a - b * b * n);
  }
  double value() const { return to_double(a) + to_double(b) * std::sqrt(to_double(n)); }
};

/// The rectangle 1 wide about the line from (0, 0) to `way`, cut out of one pixel after the other.
/// Domain: way not (0, 0), up to some thousands.
class ExactLine {
 public:
  explicit ExactLine(ivec2 way) : way_(way), square_(0) {
    const std::int64_t n = std::int64_t{way.x} * way.x + std::int64_t{way.y} * way.y;
    const auto root = std::llround(std::sqrt(static_cast<double>(n)));
    is_square_ = root * root == n;
    square_ = n;
    length_ = is_square_ ? Surd{Exact(root), Exact{}, Exact(n)} : Surd{Exact{}, Exact(1), Exact(n)};
  }
  /// The area in the pixel: the square about it, less what lies beyond each side.
  Surd area(ivec2 pixel) const {
    std::vector<Point> corners;
    const Exact half(1, 2);
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      corners.push_back({number(Exact(pixel.x) + Exact(x) * half), number(Exact(pixel.y) + Exact(y) * half)});
    const Surd x = number(Exact(way_.x)), y = number(Exact(way_.y)), zero = number(Exact{});
    const Surd reach = number(half) * length_, whole = number(Exact(square_));
    corners = cut(corners, zero - y, x, reach);        // on the left
    corners = cut(corners, y, zero - x, reach);        // on the right
    corners = cut(corners, zero - x, zero - y, zero);  // behind the start
    corners = cut(corners, x, y, whole);               // past the end
    Surd doubled = zero;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
      doubled = doubled + (p.x * q.y - p.y * q.x);
    }
    return doubled * number(half);
  }
  Surd number(Exact x) const { return {x, Exact{}, Exact(square_)}; }

 private:
  struct Point {
    Surd x, y;
  };
  /// The part where a x + b y <= reach.
  static std::vector<Point> cut(const std::vector<Point>& corners, const Surd& a, const Surd& b,
                                const Surd& reach) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point &p = corners[i], &q = corners[(i + 1) % corners.size()];
      const Surd at_p = reach - a * p.x - b * p.y, at_q = reach - a * q.x - b * q.y;
      if (at_p.sign() >= 0) kept.push_back(p);
      if (at_p.sign() * at_q.sign() < 0) {
        const Surd part = at_p / (at_p - at_q);
        kept.push_back({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)});
      }
    }
    return kept;
  }

  ivec2 way_;
  std::int64_t square_;
  bool is_square_ = false;
  Surd length_;
};

}  // namespace gradus::stress
