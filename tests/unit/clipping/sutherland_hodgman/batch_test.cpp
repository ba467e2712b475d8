// Many polygons at a rectangle: known ones, long ones beside one at a time, memory that is used again,
// refusals.

#include "clipping/sutherland_hodgman/sutherland_hodgman_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "core/arithmetic/elementary.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::sutherland_hodgman {
namespace {

template <class T>
using Ring = std::vector<glm::vec<2, T>>;

template <class T>
Ring<T> ring_of(std::span<const glm::vec<2, T>> points) {
  return {points.begin(), points.end()};
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

template <class T>
class SutherlandHodgmanBatch : public testing::Test {
 protected:
  using P = glm::vec<2, T>;

  Rectangle<T> square{{0, 0}, {10, 10}};
  Polygons<T> given, clipped;
  BatchClipper<T> clip;

  /// Clips what is given, and compares each polygon with what clip_to_window makes of it.
  BatchCount expect_the_same(const Rectangle<T>& window) {
    const BatchCount count = clip(given, window, clipped);
    EXPECT_EQ(clipped.size(), given.size());
    EXPECT_EQ(clipped.points.size(), clipped.ends.empty() ? 0 : clipped.ends.back());
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto right = clip_to_window(given[i], window);
      const auto found = clipped[i];
      EXPECT_EQ(found.size(), right.size()) << "polygon " << i;
      for (std::size_t k = 0; k < std::min(found.size(), right.size()); ++k) {
        for (int axis = 0; axis < 2; ++axis) {
          EXPECT_EQ(bits(found[k][axis]), bits(right[k].at[axis])) << "polygon " << i << ", vertex " << k;
        }
      }
    }
    return count;
  }
};

using Scalars = testing::Types<float, double>;
struct NameOfScalar {
  template <class T>
  static std::string GetName(int) {
    return std::is_same_v<T, float> ? "Float" : "Double";
  }
};
TYPED_TEST_SUITE(SutherlandHodgmanBatch, Scalars, NameOfScalar);

TYPED_TEST(SutherlandHodgmanBatch, KnownPolygons) {
  using R = Ring<TypeParam>;
  // Round the window, across a border, inside, outside, one that touches, one of two points, none
  this->given.add(R{{-10, -10}, {30, -10}, {10, 40}});
  this->given.add(R{{-5, 2}, {5, 2}, {5, 8}});
  this->given.add(R{{1, 1}, {9, 1}, {5, 9}});
  this->given.add(R{{11, 1}, {19, 1}, {15, 9}});
  this->given.add(R{{10, 1}, {19, 1}, {15, 9}});
  this->given.add(R{{1, 1}, {9, 9}});
  this->given.add(R{});
  const BatchCount count = this->expect_the_same(this->square);
  EXPECT_EQ(count.copied, 1u);
  EXPECT_EQ(count.dropped, 3u);
  EXPECT_EQ(count.clipped, 3u);
  EXPECT_EQ(ring_of(this->clipped[0]), (R{{0, 10}, {0, 0}, {10, 0}, {10, 10}}));
  EXPECT_EQ(ring_of(this->clipped[1]), (R{{0, 5}, {0, 2}, {5, 2}, {5, 8}}));
  EXPECT_EQ(ring_of(this->clipped[2]), (R{{1, 1}, {9, 1}, {5, 9}}));
  for (const std::size_t nothing : {3u, 4u, 5u, 6u}) EXPECT_TRUE(this->clipped[nothing].empty());
}

TYPED_TEST(SutherlandHodgmanBatch, CornersOfTheWindowAndZeros) {
  using T = TypeParam;
  using R = Ring<T>;
  const T above = std::nextafter(T(1), T(2)), below = std::nextafter(T(1), T(0));
  // Through the corner (0, 0), and past it by as little as numbers allow, on either side
  for (const T end : {T(1), above, below}) {
    this->given.add(R{{-1, end}, {1, -1}, {5, 5}});
    this->given.add(R{{-1, 1}, {end, -1}, {5, 5}});
    this->given.add(R{{9, 11}, {10 + end, 9}, {5, 5}});
  }
  // Along a border, there and back, and with -0
  this->given.add(R{{0, -5}, {0, 15}, {5, 15}, {5, -5}});
  this->given.add(R{{-T(0), -5}, {-T(0), 15}, {5, 15}, {-5, 3}});
  this->given.add(R{{2, -4}, {8, -4}, {8, 4}, {6, 4}, {6, -2}, {4, -2}, {4, 4}, {2, 4}});
  // Points twice, and cuts that round to one place
  this->given.add(R{{-5, 2}, {-5, 2}, {5, 2}, {5, 2}, {5, 8}});
  this->given.add(R{{5, 1}, {5, -1}, {5, -1}, {5, 1}, {2, 8}});
  this->expect_the_same(this->square);
  this->expect_the_same({{0, 0}, {0, 10}});
  this->expect_the_same({{3, 3}, {3, 3}});
}

TYPED_TEST(SutherlandHodgmanBatch, EdgesPastCornersByLessThanAPlace) {
  using T = TypeParam;
  Random random(test::seed());
  const auto number = [&](double least, double most) { return static_cast<T>(random.uniform(least, most)); };
  for (int i = 0; i < 2000; ++i) {
    // Where the first edge crosses the left or the right border rounds to a corner, mostly beside it
    const Rectangle<T> window{{number(-1, 0), number(1, 2)}, {number(1, 2), number(3, 4)}};
    const bool right = random.unit() < 0.5, upper = random.unit() < 0.5;
    const glm::vec<2, T> corner{right ? window.upper.x : window.lower.x,
                                upper ? window.upper.y : window.lower.y};
    const glm::vec<2, T> way{right ? number(0.1, 1) : number(-1, -0.1), number(-1, 1)};
    const glm::vec<2, T> a = corner + way, b = corner - number(0.1, 2) * way;
    this->given = {};
    this->given.add(Ring<T>{a, b, {number(-2, 3), number(0, 5)}});
    this->given.add(Ring<T>{b, a, {number(-2, 3), number(0, 5)}});
    this->expect_the_same(window);
  }
}

TYPED_TEST(SutherlandHodgmanBatch, LongPolygonsOfAllSizes) {
  using T = TypeParam;
  Random random(test::seed());
  // From numbers that nearly vanish to nearly the largest
  const int last = std::numeric_limits<T>::max_exponent - 3,
            first = std::numeric_limits<T>::min_exponent - 10;
  for (const int exponent : {0, first, -30, 40, last}) {
    this->given = {};
    const auto place = [&](double x) { return static_cast<T>(std::ldexp(x, exponent)); };
    for (const int corners : {3, 4, 17, 200, 3000}) {
      for (const bool round : {true, false}) {
        Ring<T> ring;
        for (int i = 0; i < corners; ++i) {
          const SinCos way = sin_cos(0x1.921fb54442d18p2 * i / corners);
          const double far = random.uniform(0.5, 1.5);
          const double x = round ? far * way.cos : random.uniform(-2, 2);
          ring.emplace_back(place(x), place(round ? far * way.sin : random.uniform(-2, 2)));
        }
        this->given.add(ring);
      }
    }
    const T one = place(0.75);
    // Short ones may lie on one side
    EXPECT_GE(this->expect_the_same({{-one, -one}, {one, one}}).clipped, 6u);
    this->expect_the_same({{0, -one}, {place(1.25), one / 3}});
  }
}

TYPED_TEST(SutherlandHodgmanBatch, ManyOnAGrid) {
  using T = TypeParam;
  using Place = glm::vec<2, T>;
  Random random(test::seed());
  // Corners on borders and on corners of the window, edges through these, repeated corners, long rows of
  // corners on one side, and few between many
  for (int round = 0; round < 8; ++round) {
    this->given = {};
    for (int i = 0; i < 1000; ++i) {
      const auto corners = random.uniform_int(0, i % 10 == 0 ? 90 : 12), far = random.uniform_int(2, 8);
      Ring<T> ring;
      Place at(0);
      for (std::int64_t k = 0; k < corners; ++k) {
        const auto step = [&] { return static_cast<T>(random.uniform_int(-1, 1)); };
        const auto anywhere = [&] { return static_cast<T>(random.uniform_int(-far, far)); };
        at = i % 3 == 0 ? at + Place{step(), step()} : Place{anywhere(), anywhere()};
        ring.push_back(at);
      }
      this->given.add(ring);
    }
    const BatchCount count = this->expect_the_same({{-3, -2}, {3, 2}});
    EXPECT_GT(count.clipped, 400u);
    EXPECT_GT(count.dropped, 0u);
    EXPECT_GT(count.copied, 0u);
    this->expect_the_same({{0, 0}, {1, 3}});
    // A line and a point
    this->expect_the_same({{-2, 1}, {2, 1}});
    this->expect_the_same({{1, -2}, {1, 2}});
    this->expect_the_same({{1, 1}, {1, 1}});
  }
}

TYPED_TEST(SutherlandHodgmanBatch, MemoryIsUsedAgain) {
  using R = Ring<TypeParam>;
  for (int i = 0; i < 50; ++i) this->given.add(R{{-10, -10}, {30, -10}, {10, 40}});
  this->expect_the_same(this->square);
  const auto* const points = this->clipped.points.data();
  this->expect_the_same(this->square);
  EXPECT_EQ(this->clipped.points.data(), points);
  // Less, then nothing
  this->given = {};
  this->given.add(R{{-5, 2}, {5, 2}, {5, 8}});
  this->expect_the_same(this->square);
  EXPECT_EQ(this->clipped.points.data(), points);
  this->given = {};
  this->expect_the_same(this->square);
  EXPECT_TRUE(this->clipped.points.empty());
}

TYPED_TEST(SutherlandHodgmanBatch, Refusals) {
  using T = TypeParam;
  using R = Ring<T>;
  constexpr T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
  for (const T wrong : {nan, infinity, -infinity}) {
    for (std::size_t at = 0; at < 5; ++at) {
      for (const int axis : {0, 1}) {
        R bad{{1, 1}, {2, 1}, {3, 2}, {2, 3}, {1, 2}};
        bad[at][axis] = wrong;
        EXPECT_THROW(clip_to_window(bad, this->square), ContractViolation);
        this->given = {};
        this->given.add(R{{-5, 2}, {5, 2}, {5, 8}});
        this->given.add(bad);
        EXPECT_THROW(this->clip(this->given, this->square, this->clipped), ContractViolation);
        // What came before it is there
        EXPECT_EQ(this->clipped.size(), 1u);
        EXPECT_EQ(this->clipped.points.size(), 4u);
      }
    }
  }
  this->given = {};
  const Rectangle<T> windows[] = {
      {{1, 0}, {0, 1}}, {{0, 1}, {1, 0}}, {{nan, 0}, {1, 1}}, {{0, 0}, {1, infinity}}};
  for (const Rectangle<T>& window : windows) {
    EXPECT_THROW(this->clip(this->given, window, this->clipped), ContractViolation);
  }
}

}  // namespace
}  // namespace gradus::sutherland_hodgman
