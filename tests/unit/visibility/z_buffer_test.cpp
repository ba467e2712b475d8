// The least (depth, key) of each pixel, in every order.

#include "visibility/z_buffer/z_buffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/record.hpp"

namespace gradus::z_buffer {
namespace {

using Buffer = Raster<Cell<double, int>>;

TEST(ZBuffer, AnyOrderGivesTheSamePicture) {
  // G001-78
  std::vector<int> order{0, 1, 2};
  const double depth[]{3, 1, 2};
  int orders = 0;
  do {
    Buffer buffer(1, 1);
    for (const int i : order) keep_nearest(buffer, {0, 0}, depth[i], i);
    EXPECT_EQ((buffer[{0, 0}].key), 1);
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 6);
}

TEST(ZBuffer, AtEqualDepthTheLowerKeyIsKept) {
  for (const auto& [first, second] : {std::pair{4, 7}, std::pair{7, 4}}) {
    Buffer buffer(1, 1);
    keep_nearest(buffer, {0, 0}, 0.5, first);
    EXPECT_EQ(keep_nearest(buffer, {0, 0}, 0.5, second), second < first);
    EXPECT_EQ((buffer[{0, 0}].key), 4);
  }
  Buffer buffer(1, 1);
  keep_nearest(buffer, {0, 0}, 0.0, 9);
  EXPECT_TRUE(keep_nearest(buffer, {0, 0}, -0.0, 8));  // the two zeros are the same depth
}

TEST(ZBuffer, WhatIsNoNumberIsNeverKept) {
  Buffer buffer(1, 1);
  EXPECT_FALSE(keep_nearest(buffer, {0, 0}, std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE((buffer[{0, 0}].taken));
  EXPECT_TRUE(keep_nearest(buffer, {0, 0}, std::numeric_limits<double>::infinity(), 0));
  EXPECT_TRUE(keep_nearest(buffer, {0, 0}, 1e300, 5));
}

TEST(ZBuffer, Steps) {
  Recorder<Compared<double, int>> seen;
  Buffer buffer(2, 1), plain(2, 1);
  for (const double depth : {0.5, 0.75, 0.25}) {
    EXPECT_EQ(keep_nearest(buffer, {1, 0}, depth, 3, seen), keep_nearest(plain, {1, 0}, depth, 3));
  }
  const auto steps = all<Compared<double, int>>(seen);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].before, std::nullopt);
  EXPECT_EQ(steps[1].before, 0.5);
  EXPECT_FALSE(steps[1].nearer);
  EXPECT_EQ(steps[2].before, 0.5);
  EXPECT_TRUE(steps[2].nearer);
}

}  // namespace
}  // namespace gradus::z_buffer
