#include "core/merge_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

#include "core/random.hpp"

namespace gradus {
namespace {

/// A key, and where it stood.
using Item = std::pair<int, std::size_t>;

std::size_t sort_by_key(std::vector<Item>& items) {
  return merge_sort(items, [](const Item& a, const Item& b) { return a.first < b.first; });
}

std::vector<Item> items_of(const std::vector<int>& keys) {
  std::vector<Item> items;
  for (const int key : keys) items.emplace_back(key, items.size());
  return items;
}

TEST(MergeSort, IsThatOfTheLibraryForAllSizesAndTies) {
  Random random(1);
  for (std::size_t size = 0; size < 130; ++size) {
    for (const int keys : {1, 3, 1000}) {
      std::vector<Item> items;
      while (items.size() < size)
        items.emplace_back(static_cast<int>(random.uniform_int(0, keys - 1)), items.size());
      std::vector<Item> expected = items;
      std::ranges::stable_sort(expected, {}, &Item::first);
      const std::size_t comparisons = sort_by_key(items);
      EXPECT_EQ(items, expected) << size << " of " << keys;
      EXPECT_LE(comparisons, size * static_cast<std::size_t>(std::bit_width(size)));
    }
  }
}

TEST(MergeSort, ComparesTheSameEverywhere) {
  const auto comparisons = [](std::vector<int> keys) {
    std::vector<Item> items = items_of(keys);
    return sort_by_key(items);
  };
  EXPECT_EQ(comparisons({}), 0u);
  EXPECT_EQ(comparisons({7}), 0u);
  EXPECT_EQ(comparisons({1, 2, 3, 4}), 1u + 1 + 2);
  EXPECT_EQ(comparisons({4, 3, 2, 1}), 1u + 1 + 2);
  EXPECT_EQ(comparisons({1, 3, 2, 4}), 1u + 1 + 3);
  EXPECT_EQ(comparisons({2, 1, 3}), 1u + 2);
  EXPECT_EQ(comparisons({1, 2, 3, 4, 5, 6, 7, 8}), 4u + 4 + 4);
}

TEST(MergeSort, MovesWhatCannotBeCopied) {
  std::vector<std::unique_ptr<int>> items;
  for (const int key : {3, 1, 2}) items.push_back(std::make_unique<int>(key));
  merge_sort(items, [](const auto& a, const auto& b) { return *a < *b; });
  for (std::size_t i = 0; i < items.size(); ++i) EXPECT_EQ(*items[i], static_cast<int>(i + 1));
}

}  // namespace
}  // namespace gradus
