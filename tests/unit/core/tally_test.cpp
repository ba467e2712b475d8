// Counting for reports: steps arrive with what was counted, from the lines that told them; unobserved there
// is nothing.

#include "core/tally.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

namespace gradus {
namespace {

struct Took {
  int value;
};
struct Done {
  int count, sum;
};

struct Sums {
  int count = 0, sum = 0;

  Took operator()(Took step) {
    ++count;
    sum += step.value;
    return step;
  }
  Done operator()(Done) const { return {count, sum}; }
};

/// Adds its numbers up to their product with 2, as a method that only reports how many there were.
template <class O = Unobserved>
int doubled_sum(const std::vector<int>& numbers, O&& observer = {}) {
  Tally<O, Sums> tally(observer);
  int sum = 0;
  for (const int n : numbers) {
    sum += 2 * n;
    if constexpr (observed<O>) observer(tally.count(Took{n}));
  }
  if constexpr (observed<O>) observer(tally.count(Done{0, 0}));
  return sum;
}

template <class O>
int told_inside(O&& observer) {
  if constexpr (observed<O>) observer(Took{7});
  return __LINE__ - 1;
}

TEST(Tally, FillsInWhatWasCounted) {
  std::vector<Done> done;
  const auto watch = [&](const auto& step) {
    if constexpr (std::same_as<std::remove_cvref_t<decltype(step)>, Done>) done.push_back(step);
  };
  EXPECT_EQ(doubled_sum({3, 4, 5}, watch), 24);
  ASSERT_EQ(done.size(), 1u);
  EXPECT_EQ(done[0].count, 3);
  EXPECT_EQ(done[0].sum, 12);
}

TEST(Tally, PassesOnStepsWithTheLineThatToldThem) {
  int line = 0, value = 0;
  auto watch = [&](const Took& step, int at, const char*) { line = at, value = step.value; };
  Tally<decltype(watch)&, Sums> tally(watch);
  EXPECT_EQ(told_inside(tally), line);
  EXPECT_EQ(value, 7);
  EXPECT_EQ(tally.count(Done{0, 0}).sum, 7);
}

TEST(Tally, IsNothingWithoutAnObserver) {
  static_assert(std::same_as<Tally<Unobserved, Sums>, Unobserved>);
  static_assert(std::same_as<Tally<Unobserved&, Sums>, Unobserved>);
  EXPECT_EQ(doubled_sum({3, 4, 5}), 24);
}

}  // namespace
}  // namespace gradus
