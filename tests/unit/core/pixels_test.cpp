// The pixels of a window, one after the other.

#include "core/pixels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace gradus {
namespace {

std::vector<ivec2> gone_through(const Window& window) {
  std::vector<ivec2> all;
  for (const ivec2 p : pixels(window)) all.push_back(p);
  return all;
}

TEST(Pixels, ComeRowByRow) {
  EXPECT_THAT(gone_through({{-1, 4}, {1, 5}}), testing::ElementsAre(ivec2(-1, 4), ivec2(0, 4), ivec2(1, 4),
                                                                    ivec2(-1, 5), ivec2(0, 5), ivec2(1, 5)));
  EXPECT_THAT(gone_through({{3, 3}, {3, 3}}), testing::ElementsAre(ivec2(3)));
}

TEST(Pixels, OfAnEmptyWindowAreNone) {
  EXPECT_TRUE(gone_through({}).empty());
  EXPECT_TRUE(gone_through({{0, 0}, {-1, 5}}).empty());
  EXPECT_TRUE(gone_through({{0, 0}, {5, -1}}).empty());
  EXPECT_TRUE(gone_through({{9, 9}, {5, 5}}).empty());
}

TEST(Pixels, EndAtTheLastRowAndColumnOfAll) {
  constexpr int last = std::numeric_limits<int>::max(), first = std::numeric_limits<int>::min();
  EXPECT_THAT(gone_through({{last - 1, last}, {last, last}}),
              testing::ElementsAre(ivec2(last - 1, last), ivec2(last, last)));
  EXPECT_THAT(gone_through({{first, first}, {first, first + 1}}),
              testing::ElementsAre(ivec2(first, first), ivec2(first, first + 1)));
}

}  // namespace
}  // namespace gradus
