#include "visibility/octree_order/octree_order.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <vector>

#include "core/record.hpp"

namespace gradus::octree_order {
namespace {

std::vector<ivec2> walked(ivec2 from, ivec2 to) {
  std::vector<ivec2> pixels;
  walk(from, to, [&](ivec2 p) { pixels.push_back(p); });
  return pixels;
}

TEST(OctreeOrder, IsToBeFilledIn) {
  FAIL()
      << "This topic is still the skeleton that ./bootstrap new has written. Put the algorithm in the "
         "place of its walk, then remove this test; docs/adding_a_topic.md goes through the files in order.";
}

// FILL IN: known results, with the source that they are from.
TEST(OctreeOrder, GoesToTheColumnThenToTheRow) {
  EXPECT_EQ(walked({0, 0}, {2, 1}), (std::vector<ivec2>{{0, 0}, {1, 0}, {2, 0}, {2, 1}}));
  EXPECT_EQ(walked({1, 1}, {0, -1}), (std::vector<ivec2>{{1, 1}, {0, 1}, {0, 0}, {0, -1}}));
  EXPECT_EQ(walked({3, 4}, {3, 4}), (std::vector<ivec2>{{3, 4}}));
  EXPECT_EQ(walked({INT_MAX - 1, 0}, {INT_MAX, 0}).size(), 2u);
}

TEST(OctreeOrder, StepsFollowTheGrammar) {
  Recorder<Started, Stepped, Finished> seen;
  walk({0, 0}, {2, 1}, [](ivec2) {}, seen);
  ASSERT_EQ(seen.events().size(), 5u);
  EXPECT_EQ(std::get<Started>(seen.events().front().step).to, (ivec2{2, 1}));
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).pixels, 4);
  ivec2 last{0, 0};
  EXPECT_TRUE(every<Stepped>(seen, [&](const Stepped& s) {
    const bool follows = s.column_reached == (last.x == 2);
    last = s.pixel;
    return follows;
  }));
}

TEST(OctreeOrder, ObservedEqualsUnobserved) {
  std::vector<ivec2> pixels;
  int steps = 0;
  walk({-3, 2}, {4, -1}, [&](ivec2 p) { pixels.push_back(p); }, [&](const auto&) { ++steps; });
  EXPECT_EQ(pixels, walked({-3, 2}, {4, -1}));
  EXPECT_EQ(steps, 2 + 7 + 3);
}

// FILL IN: for each mistake that `expects` refuses an EXPECT_THROW with ContractViolation.

}  // namespace
}  // namespace gradus::octree_order
