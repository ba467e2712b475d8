// What is told of a piece whose ends rounding has moved.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "clipping/liang_barsky/liang_barsky.hpp"
#include "stories/clipping/window_view.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(WindowStory, DoublesAreCountedAcrossZeroAndFarApart) {
  using window_view::doubles_between;
  constexpr double least = std::numeric_limits<double>::denorm_min(), most = 1.7976931348623157e308;
  double x = 10;
  for (int steps = 0; steps < 100; ++steps) {
    EXPECT_EQ(doubles_between(10, x), steps);
    EXPECT_EQ(doubles_between(-x, -10), steps);
    x = std::nextafter(x, 0);
  }
  EXPECT_EQ(doubles_between(0.0, -0.0), 0);
  EXPECT_EQ(doubles_between(-least, least), 2);
  EXPECT_EQ(doubles_between(1, 2), std::int64_t{1} << 52);
  EXPECT_EQ(doubles_between(2, 1), std::int64_t{1} << 52);
  EXPECT_EQ(doubles_between(0, 1), std::int64_t{1023} << 52);
  EXPECT_EQ(doubles_between(-most, most), std::numeric_limits<std::int64_t>::max());
}

TEST(WindowStory, MovedEndsAreToldByDoublesOrByDistance) {
  // A cut of a cut, one double off
  const Trace near =
      test::trace_of("cohen_sutherland_2d", {{"line", "-7,3,14.1,12.7"}, {"window", "0,0,10,10"}});
  EXPECT_THAT(near.steps.back().sentence, HasSubstr("rounding has left an end off by 1 in its last digit"));
  // Through a corner: right is x = 0, from which nobody counts doubles
  const Trace far = test::trace_of("liang_barsky", {{"line", "-2,7.5,6.4,18"}, {"window", "0,0,10,10"}});
  EXPECT_THAT(far.steps.back().sentence, HasSubstr("rounding has moved an end by "));
  EXPECT_THAT(far.steps.back().sentence, Not(HasSubstr("double")));
  const auto right = liang_barsky::correctly_rounded(window_view::Line{{-2, 7.5}, {6.4, 18}},
                                                     window_view::Rectangle{{0, 0}, {10, 10}});
  ASSERT_TRUE(right.has_value());
  const double ends[] = {right->a.x, right->a.y, right->b.x, right->b.y};
  const char* const names[] = {"x0", "y0", "x1", "y1"};
  std::int64_t most = 0;
  for (int i = 0; i < 4; ++i) {
    const auto field = std::ranges::find(far.steps.back().fields, names[i], &Field::name);
    ASSERT_NE(field, far.steps.back().fields.end());
    most = std::max(most, window_view::doubles_between(std::get<double>(field->value), ends[i]));
  }
  EXPECT_GT(most, 1'000'000);
  const auto told = std::ranges::find(far.result, "off_by", &Field::name);
  ASSERT_NE(told, far.result.end());
  EXPECT_EQ(std::get<std::int64_t>(told->value), most);
}

}  // namespace
}  // namespace gradus
