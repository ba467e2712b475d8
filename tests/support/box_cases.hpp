#pragma once
// Segments in space and homogeneous ones, made to be hard to clip.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limits>

#include "core/axis_cut.hpp"
#include "core/random.hpp"

namespace gradus::test {

/// Random doubles for such segments.
class HardNumbers {
 public:
  explicit HardNumbers(std::uint64_t seed) : random(seed) {}

  Random random;

 protected:
  double number(std::int64_t lowest, std::int64_t highest) {
    const int exponent = static_cast<int>(random.uniform_int(lowest, highest));
    const double size = std::ldexp(random.uniform(1, 2), exponent);
    return random.unit() < 0.5 ? -size : size;
  }
  double number_or_zero(std::int64_t lowest, std::int64_t highest) {
    const bool zero = random.unit() < 0.1;
    return zero ? 0.0 : number(lowest, highest);
  }
  double nudged(double x, std::int64_t most = 2) {
    const std::int64_t steps = random.uniform_int(-most, most);
    const double infinity = std::numeric_limits<double>::infinity();
    for (std::int64_t i = 0; i < std::abs(steps); ++i)
      x = std::nextafter(x, steps < 0 ? -infinity : infinity);
    return x;
  }
  double integer(std::int64_t lowest, std::int64_t highest) {
    return static_cast<double>(random.uniform_int(lowest, highest));
  }
  glm::dvec3 point(double lowest, double highest) {
    const double x = random.uniform(lowest, highest), y = random.uniform(lowest, highest);
    return {x, y, random.uniform(lowest, highest)};
  }
};

/// A segment and the box to clip it to.
struct BoxCase {
  Segment<3, double> line;
  AxisBox<3, double> box;
};

/// Cases of all kinds: ordinary ones, segments through edges and corners or a few steps beside them, on a
/// grid, ties, numbers of mixed sizes over the whole range, and what has no extent.
class BoxCases : public HardNumbers {
 public:
  static constexpr int kinds = 8;
  using HardNumbers::HardNumbers;

  BoxCase operator()(int kind) {
    switch (kind % kinds) {
      case 0:
        return ordinary();
      case 1:
        return through_edge(3);
      case 2:
        return on_grid();
      case 3:
        return through_edge(random.uniform_int(-290, 290));
      case 4:
        return mixed(-299, 299);
      case 5:
        return mixed(-1074, 1023);
      case 6:
        return tied();
      default:
        return thin();
    }
  }

  /// Coordinates within ±1000, a box in the middle of them.
  BoxCase ordinary() {
    BoxCase k{};
    k.line.a = point(-1000, 1000);
    k.line.b = point(-1000, 1000);
    k.box.lower = point(-700, 0);
    k.box.upper = k.box.lower + point(0, 1000);
    return k;
  }

 private:
  static AxisBox<3, double> box(glm::dvec3 p, glm::dvec3 q) {
    return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
            {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
  }
  glm::dvec3 numbers(std::int64_t lowest, std::int64_t highest) {
    const double x = number(lowest, highest), y = number(lowest, highest);
    return {x, y, number(lowest, highest)};
  }

  /// Through an edge of the box (sometimes a corner), or a few steps beside it
  BoxCase through_edge(std::int64_t size) {
    BoxCase k{};
    k.line.a = numbers(size - 3, size);
    k.line.b = numbers(size - 3, size);
    const bool halfway = random.unit() < 0.5;
    const double t = halfway ? 0.5 : random.unit();
    const glm::dvec3 at = k.line.a * (1 - t) + k.line.b * t;
    glm::dvec3 corner = at;
    for (int i = 0; i < 3; ++i) corner[i] = nudged(at[i]);
    if (halfway) k.line.b = 2.0 * corner - k.line.a;
    if (random.unit() < 0.7)
      corner[static_cast<int>(random.uniform_int(0, 2))] -= std::ldexp(1.0, static_cast<int>(size) - 3);
    k.box = box(corner, corner + numbers(size - 4, size));
    return k;
  }
  BoxCase on_grid() {
    const auto at = [&] {
      const double x = integer(-4, 14), y = integer(-4, 14);
      return glm::dvec3(x, y, integer(-4, 14));
    };
    BoxCase k{};
    k.line.a = at();
    k.line.b = at();
    k.box = {glm::dvec3(0), glm::dvec3(10)};
    return k;
  }
  BoxCase mixed(std::int64_t lowest, std::int64_t highest) {
    const auto at = [&] {
      const double x = number_or_zero(lowest, highest), y = number_or_zero(lowest, highest);
      return glm::dvec3(x, y, number_or_zero(lowest, highest));
    };
    BoxCase k{};
    k.line.a = at();
    k.line.b = at();
    const glm::dvec3 p = at(), q = at();
    k.box = box(p, q);
    // Often across the box
    for (int i = 0; i < 3; ++i) {
      if (random.unit() < 0.3) continue;
      k.box.lower[i] = -std::abs(k.box.lower[i]);
      k.box.upper[i] = std::abs(k.box.upper[i]);
      if (random.unit() < 0.5) k.line.b[i] = -k.line.a[i];
    }
    return k;
  }
  /// A face halfway along the segment, where another coordinate lies midway between two doubles, or a hair
  /// off
  BoxCase tied() {
    const std::int64_t high = std::int64_t{1} << 53, low = std::int64_t{1} << 52;
    const std::int64_t first = random.uniform_int(low, high - 1), second = random.uniform_int(low, high - 1);
    const double from = static_cast<double>(first);
    const double to = static_cast<double>(second - (first + second + 1) % 2);
    const double x = random.uniform(1, 8), hair = random.unit() < 0.5 ? 0 : number(-200, -90);
    BoxCase k{};
    const int i = static_cast<int>(random.uniform_int(0, 2)), j = (i + 1) % 3, l = (i + 2) % 3;
    k.box = {glm::dvec3(-1e17), glm::dvec3(1e17)};
    k.line.a[i] = -x, k.line.b[i] = x;
    k.line.a[j] = from, k.line.b[j] = to;
    k.line.a[l] = random.uniform(-9, 9), k.line.b[l] = random.uniform(-9, 9);
    k.box.lower[i] = random.unit() < 0.5 ? hair : -10;
    k.box.upper[i] = k.box.lower[i] == hair ? 10 : hair;
    return k;
  }
  /// Without extent in some axis
  BoxCase thin() {
    BoxCase k = on_grid();
    const int which = static_cast<int>(random.uniform_int(0, 4)),
              i = static_cast<int>(random.uniform_int(0, 2));
    if (which == 0) k.line.b = k.line.a;
    if (which == 1) k.line.b[i] = k.line.a[i];
    if (which == 2) k.line.b[i] = k.line.a[i], k.line.b[(i + 1) % 3] = k.line.a[(i + 1) % 3];
    if (which == 3) k.box.lower[i] = k.box.upper[i] = integer(-1, 11);
    if (which == 4) k.box.upper = k.box.lower = glm::dvec3(integer(2, 8));
    return k;
  }
};

/// Homogeneous segments for the view volume -w <= x, y <= w, 0 <= z <= w: before the eye, behind it, past it,
/// through edges of the volume or a few steps beside them.
class VolumeCases : public HardNumbers {
 public:
  static constexpr int kinds = 8;
  using HardNumbers::HardNumbers;

  Segment<4, double> operator()(int kind) {
    switch (kind % kinds) {
      case 0:
        return ordinary();
      case 1:
        return seen();
      case 2:
        return through_edge(0);
      case 3:
        return through_edge(static_cast<int>(random.uniform_int(-290, 290)));
      case 4:
        return mixed(-20, 20);
      case 5:
        return mixed(-1070, 1020);
      case 6:
        return on_grid();
      default:
        return past_nothing(-1074);
    }
  }

  Segment<4, double> ordinary() {
    const auto at = [&] { return glm::dvec4(point(-2, 2), random.uniform(-0.7, 2)); };
    const glm::dvec4 a = at();
    return {a, at()};
  }
  /// From a few of the smallest numbers, 2^smallest, past (0, 0, 0, 0) nearly to the opposite
  Segment<4, double> past_nothing(int smallest) {
    const auto at = [&] {
      const double x = integer(-3, 3), y = integer(-3, 3), z = integer(-1, 3);
      return glm::dvec4(x, y, z, integer(0, 3));
    };
    const glm::dvec4 a = at(), aside = at();
    const double back = std::ldexp(1.0, static_cast<int>(random.uniform_int(0, std::min(-smallest, 1000))));
    glm::dvec4 b(0);
    for (int i = 0; i < 4; ++i) b[i] = random.unit() < 0.5 ? aside[i] - back * a[i] : -back * nudged(a[i]);
    const double scale = std::ldexp(1.0, smallest);
    return {scale * a, scale * b};
  }

 private:
  /// A segment of space under a perspective matrix with its near plane at 1, its far plane at 100
  Segment<4, double> seen() {
    const auto at = [&] {
      const glm::dvec3 p = point(-60, 60);
      const double z = p.z + 50;
      return glm::dvec4(1.5 * p.x, 2 * p.y, (100 * z - 100) / 99, z);
    };
    const glm::dvec4 a = at();
    return {a, at()};
  }
  /// Through a point of an edge of the volume, where two faces meet, or some steps beside it
  Segment<4, double> through_edge(int exponent) {
    const double w = random.uniform(1, 2), side = random.unit() < 0.5 ? -w : w;
    glm::dvec4 on{side, random.uniform(-w, w), random.uniform(0, w), w};
    const int which = static_cast<int>(random.uniform_int(0, 3));
    if (which == 0) on.y = side;
    if (which == 1) on.y = -side;
    if (which == 2) on.z = 0;
    if (which == 3) on.z = w;
    glm::dvec4 way(point(-1, 1), random.uniform(-1, 1));
    // Away from the volume along one of the two faces: touches the edge
    way.x = way.w = std::ldexp(std::round(std::ldexp(way.w, 20)), -20);
    Segment<4, double> line{on - way, on + way};
    const int coordinate = static_cast<int>(random.uniform_int(0, 3));
    line.b[coordinate] = nudged(line.b[coordinate]);
    const double scale = std::ldexp(1.0, exponent);
    return {scale * line.a, scale * line.b};
  }
  Segment<4, double> mixed(std::int64_t lowest, std::int64_t highest) {
    const auto at = [&] {
      const double x = number_or_zero(lowest, highest), y = number_or_zero(lowest, highest);
      const double z = number_or_zero(lowest, highest);
      glm::dvec4 p(x, y, z, number(lowest, highest));
      // Often before the eye, often not far outside
      if (random.unit() < 0.8) p.w = std::abs(p.w);
      if (random.unit() < 0.5) p.x = p.w * random.uniform(-2, 2);
      if (random.unit() < 0.5) p.y = p.w * random.uniform(-2, 2);
      if (random.unit() < 0.6) p.z = p.w * random.uniform(-1, 2);
      return p;
    };
    const glm::dvec4 a = at();
    return {a, at()};
  }
  Segment<4, double> on_grid() {
    const auto at = [&] {
      const double x = integer(-4, 4), y = integer(-4, 4), z = integer(-1, 4);
      return glm::dvec4(x, y, z, integer(-2, 5));
    };
    const glm::dvec4 a = at();
    return {a, at()};
  }
};

}  // namespace gradus::test
