// AreaScan against areas in rationals: every byte of every pixel.

#include "antialiasing/area_sampling/area_sampling_batch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/contract.hpp"
#include "core/random.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

namespace gradus::area_sampling {
namespace {

using Bytes = Raster<std::uint8_t>;
using Ring = std::vector<ivec2>;
using ExactPoint = std::array<Exact, 2>;

/// The part of a ring on one side of an upright or level line: bit by bit as Sutherland and Hodgman cut it.
std::vector<ExactPoint> cut(const std::vector<ExactPoint>& ring, std::size_t axis, const Exact& limit,
                            int side) {
  std::vector<ExactPoint> kept;
  const auto inside = [&](const ExactPoint& p) { return side > 0 ? p[axis] >= limit : p[axis] <= limit; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint& from = ring[i];
    const ExactPoint& to = ring[(i + 1) % ring.size()];
    if (inside(from)) kept.push_back(from);
    if (inside(from) != inside(to)) {
      const Exact t = (limit - from[axis]) / (to[axis] - from[axis]);
      kept.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
  }
  return kept;
}

/// The signed area of a ring within a pixel, in pixels.
Exact area_in(const Ring& ring, ivec2 pixel) {
  std::vector<ExactPoint> left;
  for (const ivec2 p : ring) left.push_back({Exact(p.x) / Exact(256), Exact(p.y) / Exact(256)});
  left = cut(left, 0, Exact(pixel.x), +1);
  left = cut(left, 0, Exact(pixel.x + 1), -1);
  left = cut(left, 1, Exact(pixel.y), +1);
  left = cut(left, 1, Exact(pixel.y + 1), -1);
  Exact area(0);
  for (std::size_t i = 0; i < left.size(); ++i) {
    const ExactPoint& from = left[i];
    const ExactPoint& to = left[(i + 1) % left.size()];
    area += from[0] * to[1] - from[1] * to[0];
  }
  return area / Exact(2);
}

int byte_of(const Exact& area) { return static_cast<int>(floor(Exact(255) * area + Exact(1) / Exact(2))); }

/// The right bytes of rings that run the same way round, holes the other way.
Bytes right_bytes(const std::vector<Ring>& rings, int width, int height) {
  Bytes bytes(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const ExactScope scope;
      Exact area(0);
      for (const Ring& ring : rings) area += area_in(ring, {x, y});
      bytes[{x, y}] = static_cast<std::uint8_t>(byte_of(area < Exact(0) ? -area : area));
    }
  }
  return bytes;
}

Bytes scanned(AreaScan& scan, const std::vector<Ring>& rings, int width, int height) {
  Bytes bytes(width, height);
  const std::vector<AreaScan::Ring> spans(rings.begin(), rings.end());
  scan.draw(bytes, spans);
  return bytes;
}

void expect_right(AreaScan& scan, const std::vector<Ring>& rings, int width, int height) {
  const Bytes right = right_bytes(rings, width, height), found = scanned(scan, rings, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      ASSERT_EQ(int{found[ivec2(x, y)]}, int{right[ivec2(x, y)]}) << "pixel " << x << ", " << y;
    }
  }
}

/// A ring round a middle, whose corners go round once.
Ring star(Random& random, dvec2 middle, double least, double most, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.8 * random.unit()) / corners;
    const double radius = random.uniform(least, most);
    ring.push_back(triangle_coverage::snap(middle + radius * dvec2(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

TEST(AreaScan, TheNotesTriangleHasItsNineBytes) {
  AreaScan scan;
  const std::vector<Ring> triangle{{{256, 768}, {1024, 256}, {512, 1280}}};  // (1, 3), (4, 1), (2, 5)
  expect_right(scan, triangle, 6, 6);
  const Bytes bytes = scanned(scan, triangle, 6, 6);
  EXPECT_EQ(int{bytes[ivec2(2, 1)]}, 21);   // 255 / 12 = 21.25
  EXPECT_EQ(int{bytes[ivec2(2, 2)]}, 234);  // 255 * 11 / 12 = 233.75
  EXPECT_EQ(int{bytes[ivec2(1, 3)]}, 191);  // 255 * 3 / 4 = 191.25
}

TEST(AreaScan, BytesAreThoseOfRationals) {
  constexpr std::uint64_t seed = 17;
  SCOPED_TRACE(seed);
  AreaScan scan;
  for (int i = 0; i < 160; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const int corners = static_cast<int>(random.uniform_int(3, 12));
    const double reach = i % 4 == 0 ? 40 : 8;  // every fourth reaches out of the picture
    ASSERT_NO_FATAL_FAILURE(
        expect_right(scan, {star(random, {8, 7}, i % 3 == 0 ? 0.1 : 3, reach, corners)}, 17, 15))
        << "case " << i;
  }
}

TEST(AreaScan, CornersOnAGridOfHalvesGiveTies) {
  constexpr std::uint64_t seed = 18;
  SCOPED_TRACE(seed);
  AreaScan scan;
  for (int i = 0; i < 200; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Ring triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.push_back({static_cast<int>(random.uniform_int(-4, 24)) * 128,
                          static_cast<int>(random.uniform_int(-4, 24)) * 128});
    }
    ASSERT_NO_FATAL_FAILURE(expect_right(scan, {triangle}, 10, 10)) << "case " << i;
  }
  EXPECT_GT(scan.decided_exactly(), 100);
}

TEST(AreaScan, ATieOfTwoSlantedEdgesIsDecidedInWholeNumbers) {
  // A band of slope 1/12, half a pixel high, in one row
  AreaScan scan;
  const std::vector<Ring> band{{{0, 40}, {768, 104}, {768, 232}, {0, 168}}};
  expect_right(scan, band, 3, 2);
  EXPECT_EQ(int{scanned(scan, band, 3, 2)[ivec2(1, 0)]}, 128);
  EXPECT_GT(scan.decided_exactly(), 0);
}

TEST(AreaScan, HolesAreLeftOut) {
  constexpr std::uint64_t seed = 19;
  SCOPED_TRACE(seed);
  AreaScan scan;
  for (int i = 0; i < 40; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    Ring outer = star(random, {8, 8}, 6, 9, 9), hole = star(random, {8, 8}, 0.5, 4, 7);
    std::ranges::reverse(hole);
    if (i % 2 == 0) std::ranges::reverse(outer), std::ranges::reverse(hole);
    ASSERT_NO_FATAL_FAILURE(expect_right(scan, {outer, hole}, 17, 17)) << "case " << i;
  }
}

TEST(AreaScan, SliversAndSpikesAreRight) {
  AreaScan scan;
  expect_right(scan, {{{0, 0}, {2560, 1}, {2560, 2}}}, 11, 2);                  // nearly level
  expect_right(scan, {{{5, 0}, {6, 2560}, {4, 2560}}}, 2, 11);                  // nearly upright
  expect_right(scan, {{{128, 128}, {2432, 2431}, {2432, 2432}}}, 10, 10);       // along the diagonal
  expect_right(scan, {{{256, 0}, {512, 0}, {512, 2560}, {256, 2560}}}, 4, 10);  // a column
  expect_right(scan, {{{300, 0}, {301, 0}, {301, 2560}, {300, 2560}}}, 4, 10);  // 1/256 wide: byte 1
  expect_right(scan, {{{-268000000, -900}, {268000000, 1100}, {268000000, 1900}}}, 9, 6);  // far out
  expect_right(scan, {{{7, 7}, {7, 7}, {9, 9}}}, 2, 2);                                    // no area
}

TEST(AreaScan, BytesOfTwoPolygonsThatShareAPixelAddTo255Or256) {
  constexpr std::uint64_t seed = 20;
  SCOPED_TRACE(seed);
  AreaScan scan;
  int ties = 0, shared = 0;
  for (int i = 0; i < 400; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const int snap = i % 2 == 0 ? 1 : 128;
    const auto at = [&] { return static_cast<int>(random.uniform_int(0, 4096 / snap)) * snap; };
    const ivec2 from{at(), -64}, to{i % 3 == 0 ? from.x : at(), 4200};  // a third of them upright
    const std::vector<Ring> left{{{-64, -64}, from, to, {-64, 4200}}},
        right{{from, {4200, -64}, {4200, 4200}, to}};
    const Bytes a = scanned(scan, left, 16, 16), b = scanned(scan, right, 16, 16);
    for (std::size_t k = 0; k < a.cells().size(); ++k) {
      const int sum = a.cells()[k] + b.cells()[k];
      ASSERT_TRUE(sum == 255 || sum == 256) << sum << " in case " << i;
      ties += sum == 256;
      shared += a.cells()[k] != 0 && b.cells()[k] != 0;
    }
  }
  EXPECT_GT(ties, 100);
  EXPECT_GT(shared, 6000);
}

TEST(AreaScan, BoxesAreRight) {
  constexpr std::uint64_t seed = 22;
  SCOPED_TRACE(seed);
  AreaScan scan;
  for (int i = 0; i < 60; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const auto at = [&] { return static_cast<int>(random.uniform_int(-1000, 2600)); };
    const ivec2 a{at(), at()}, b = i % 3 == 0 ? a + ivec2(40, 300) : ivec2(at(), at());
    ASSERT_NO_FATAL_FAILURE(expect_right(scan, {{a, {b.x, a.y}, b, {a.x, b.y}}}, 7, 8)) << "case " << i;
    ASSERT_NO_FATAL_FAILURE(expect_right(scan, {{a, {a.x, b.y}, b, {b.x, a.y}}}, 7, 8)) << "case " << i;
  }
}

TEST(AreaScan, LargePicturesAgreeWithTheirParts) {
  // The same polygon in a wide picture and moved into a small one: clipping at the sides changes nothing
  constexpr std::uint64_t seed = 21;
  SCOPED_TRACE(seed);
  AreaScan scan;
  Random random(seed);
  const Ring ring = star(random, {500, 300}, 50, 290, 40);
  const Bytes whole = scanned(scan, {ring}, 1000, 600);
  for (const ivec2 corner : {ivec2(210, 100), ivec2(480, 310), ivec2(700, 500), ivec2(0, 0)}) {
    Ring moved = ring;
    for (ivec2& p : moved) p -= 256 * corner;
    const Bytes part = scanned(scan, {moved}, 64, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) ASSERT_EQ(int{part[ivec2(x, y)]}, int{whole[ivec2(x, y) + corner]});
    }
  }
}

TEST(AreaScan, PolygonsOfAFewPixelsAreRight) {
  // Wholly in the picture, of each size up to what is drawn at once and a little more
  constexpr std::uint64_t seed = 24;
  SCOPED_TRACE(seed);
  AreaScan scan;
  for (int i = 0; i < 60; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const double most = i < 34 ? 0.5 + 0.5 * i : random.uniform(0.5, 8);
    const int corners = static_cast<int>(random.uniform_int(3, 12)), side = static_cast<int>(2 * most) + 6;
    const dvec2 middle = dvec2{side / 2.0} + dvec2{random.uniform(-2, 2), random.uniform(-2, 2)};
    Ring ring = star(random, middle, i % 3 == 0 ? 0.1 : most / 2, most, corners);
    if (i % 2 == 0) std::ranges::reverse(ring);
    ASSERT_NO_FATAL_FAILURE(expect_right(scan, {ring}, side, side)) << "case " << i;
  }
}

TEST(SmallPolygonScan, NothingIsLeftOfThePolygonBefore) {
  // Four and eight columns wide, and touching the right side of its box in many ways; then a wider one
  SmallPolygonScan scan;
  const Ring wide{{3, 5}, {4000, 300}, {4090, 4000}, {17, 3001}};
  const Bytes right = right_bytes({wide}, 16, 16);
  const auto expect_wide_right = [&] {
    Bytes bytes(16, 16);
    ASSERT_TRUE(scan.draw(bytes, std::array{AreaScan::Ring(wide)}));
    EXPECT_EQ(bytes, right);
  };
  for (const int columns : {1, 3, 4, 8, 12, 16}) {
    for (const int off : {0, 1, 200}) {
      const int x = columns * 256 - off;
      const Ring ring{{9, 7}, {x, 130}, {x, 900}, {x - 8, 1500}, {x, 1501}, {x, 1700}, {40, 1801}};
      Bytes bytes(columns, 8);
      ASSERT_TRUE(scan.draw(bytes, std::array{AreaScan::Ring(ring)}));
      EXPECT_EQ(bytes, right_bytes({ring}, columns, 8)) << columns << " " << off;
      ASSERT_NO_FATAL_FAILURE(expect_wide_right()) << columns << " " << off;
    }
  }
  // A tie is left to others, and leaves nothing behind, either
  Bytes bytes(3, 2);
  const Ring tie{{0, 40}, {768, 104}, {768, 232}, {0, 168}};
  EXPECT_FALSE(scan.draw(bytes, std::array{AreaScan::Ring(tie)}));
  EXPECT_EQ(bytes, Bytes(3, 2));
  expect_wide_right();
}

TEST(SmallPolygonScan, WhatIsNotCoveredKeepsWhatItHas) {
  SmallPolygonScan scan;
  for (int columns = 1; columns <= 20; ++columns) {
    const int x = 512 + columns * 256 - 3;
    const Ring ring{{515, 600}, {x, 900}, {520, 1500}};
    const Bytes right = right_bytes({ring}, 24, 8);
    Bytes bytes(24, 8, 7);
    ASSERT_TRUE(scan.draw(bytes, std::array{AreaScan::Ring(ring)}));
    for (std::size_t k = 0; k < bytes.cells().size(); ++k) {
      ASSERT_EQ(int{bytes.cells()[k]}, right.cells()[k] != 0 ? int{right.cells()[k]} : 7) << columns;
    }
  }
}

TEST(SmallPolygonScan, OthersAreLeftAlone) {
  SmallPolygonScan scan;
  const auto taken = [&](const Ring& ring, int side) {
    Bytes bytes(side, side);
    const bool drawn = scan.draw(bytes, std::array{AreaScan::Ring(ring)});
    if (!drawn) EXPECT_EQ(bytes, Bytes(side, side));
    return drawn;
  };
  constexpr int reach = SmallPolygonScan::most * 256;
  EXPECT_TRUE(taken({{0, 3}, {reach, 70}, {5, reach}}, 40));
  EXPECT_FALSE(taken({{0, 3}, {reach + 1, 70}, {5, reach}}, 40));  // one column more
  EXPECT_FALSE(taken({{0, 3}, {reach, 70}, {5, reach + 1}}, 40));  // one row more
  EXPECT_FALSE(taken({{-1, 3}, {700, 70}, {5, 900}}, 40));         // left of the picture
  EXPECT_FALSE(taken({{0, 3}, {700, -1}, {5, 900}}, 40));          // above it
  EXPECT_FALSE(taken({{0, 3}, {1025, 70}, {5, 900}}, 4));          // right of it
  EXPECT_FALSE(taken({{0, 3}, {700, 70}, {5, 1025}}, 4));          // below it
  EXPECT_FALSE(taken({{7, 7}, {7, 7}, {9, 9}}, 4));                // no area
  EXPECT_FALSE(taken({}, 4));
  constexpr int far = std::numeric_limits<int>::max();
  EXPECT_FALSE(taken({{-far, -far}, {far, 3}, {far, far}, {1, far}}, 4));
  EXPECT_FALSE(taken(Ring(257, ivec2(3, 3)), 4));
}

TEST(AreaScan, CornersTooFarOutAreRefused) {
  AreaScan scan;
  Bytes bytes(4, 4);
  const Ring ring{{0, 0}, {300000000, 0}, {0, 256}};
  EXPECT_THROW(scan.draw(bytes, AreaScan::Ring(ring)), ContractViolation);
}

}  // namespace
}  // namespace gradus::area_sampling
