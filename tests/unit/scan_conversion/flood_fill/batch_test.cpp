// The fills on plain memory against a fill that keeps a queue of cells, and their parts bit by bit.

#include "scan_conversion/flood_fill/flood_fill_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "support/fill_pictures.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::flood_fill {
namespace {

constexpr Connectivity connectivities[] = {Connectivity::four, Connectivity::eight};

/// The cells as a fill of the queue leaves them; how many it painted.
template <class Cell>
std::int64_t fill_by_queue(Raster<Cell>& raster, ivec2 seed, Cell ink, Connectivity connectivity) {
  const Cell old = raster[seed];
  if (old == ink) return 0;
  std::int64_t painted = 0;
  std::deque<ivec2> queue;
  const auto enter = [&](ivec2 p) {
    if (!raster.contains(p) || raster[p] != old) return;
    raster[p] = ink;
    ++painted;
    queue.push_back(p);
  };
  for (enter(seed); !queue.empty(); queue.pop_front()) {
    const ivec2 at = queue.front();
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        if (connectivity == Connectivity::eight || x == 0 || y == 0) enter(at + ivec2(x, y));
      }
    }
  }
  return painted;
}

/// Whether each way of filling gives those cells and that count.
template <class Cell>
void expect_right(const Raster<Cell>& before, ivec2 seed, Cell ink) {
  for (const Connectivity connectivity : connectivities) {
    Raster<Cell> right = before;
    const std::int64_t painted = fill_by_queue(right, seed, ink, connectivity);
    const auto judge = [&](const char* name, auto fill) {
      Raster<Cell> cells = before;
      EXPECT_EQ(fill(cells).painted, painted) << name;
      EXPECT_TRUE(cells == right) << name << " from " << seed.x << "," << seed.y << ", connectivity "
                                  << static_cast<int>(connectivity);
    };
    judge("rows", [&](auto& cells) { return fill_rows(cells, seed, ink, connectivity); });
    judge("labels", [&](auto& cells) { return fill_by_labels(cells, seed, ink, connectivity); });
    judge("area", [&](auto& cells) { return fill_area(cells, seed, ink, connectivity); });
  }
}

/// A random picture of three values, 0 in so many of its cells. `upright`: a part of its rows are the row
/// above again, but for a cell.
template <class Cell>
Raster<Cell> random_raster(ivec2 size, double free, bool upright, Random& random) {
  Raster<Cell> raster(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    const bool again = upright && y > 0 && random.unit() < 0.7;
    for (int x = 0; x < size.x; ++x) {
      const auto other = static_cast<Cell>(random.uniform_int(1, 2));
      raster[{x, y}] = again ? raster[{x, y - 1}] : random.unit() < free ? Cell{0} : other;
    }
    if (again) raster[{static_cast<int>(random.uniform_int(0, size.x - 1)), y}] = 0;
  }
  return raster;
}

template <class Cell>
void expect_right_at_random(ivec2 size, Random& random) {
  const double free = random.unit() < 0.2 ? 1 - 2.0 / size.x : random.uniform(0.3, 0.9);
  const auto raster = random_raster<Cell>(size, free, random.unit() < 0.5, random);
  const ivec2 seed(static_cast<int>(random.uniform_int(0, size.x - 1)),
                   static_cast<int>(random.uniform_int(0, size.y - 1)));
  expect_right<Cell>(raster, seed, 2);
}

class FloodFillBatch : public testing::Test {
 protected:
  Random random_{test::seed()};
  testing::ScopedTrace trace_{__FILE__, __LINE__, testing::Message() << "GRADUS_SEED=" << test::seed()};
};

TEST_F(FloodFillBatch, AllSmallSizes) {
  for (int width = 1; width <= 20; ++width) {
    for (int height = 1; height <= 6; ++height) {
      for (int k = 0; k < 6; ++k) {
        expect_right_at_random<std::uint8_t>({width, height}, random_);
        expect_right_at_random<int>({width, height}, random_);
      }
    }
  }
}

TEST_F(FloodFillBatch, WidthsAroundWholeWords) {
  for (const int whole : {16, 32, 48, 64, 128, 192, 256}) {
    for (int width = whole - 2; width <= whole + 2; ++width) {
      for (const int height : {1, 2, 3, 9, 40}) {
        for (int k = 0; k < (test::sanitized ? 1 : 3); ++k) {
          expect_right_at_random<std::uint8_t>({width, height}, random_);
          expect_right_at_random<char>({width, height}, random_);
          expect_right_at_random<std::int64_t>({width, height}, random_);
        }
      }
    }
  }
}

TEST_F(FloodFillBatch, PicturesOfTheBenchmark) {
  for (const test::Canvas& canvas : {test::noise(300), test::maze(258), test::comb(259)}) {
    int free = 0;
    for (int k = 0; free < 4 && k < 1000; ++k) {
      const ivec2 seed(static_cast<int>(random_.uniform_int(0, canvas.width() - 1)),
                       static_cast<int>(random_.uniform_int(0, canvas.height() - 1)));
      if (canvas[seed] != 0) continue;
      expect_right<std::uint8_t>(canvas, seed, 2);
      ++free;
    }
    EXPECT_EQ(free, 4);
  }
}

TEST_F(FloodFillBatch, LongRunsFirstThenShortOnes) {
  // By rows through the hall at the top, cleared again when the noise below it shortens the runs
  Raster<std::uint8_t> canvas(400, 400);
  const auto noise = test::noise(400);
  for (int y = 40; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) canvas[{x, y}] = noise[{x, y}];
  }
  expect_right<std::uint8_t>(canvas, {200, 3}, 2);
  const Filled filled = fill_area(canvas, {200, 3}, std::uint8_t{2});
  EXPECT_GT(filled.peak_bytes, 400u * 400 / 8);  // a bit per cell: by labels in the end
}

TEST_F(FloodFillBatch, BitsOfCells) {
  for (int size = 1; size <= 200; ++size) {
    Raster<std::uint8_t> bytes(size, 1);
    Raster<int> numbers(size, 1);
    for (int x = 0; x < size; ++x) {
      bytes[{x, 0}] = static_cast<std::uint8_t>(random_.uniform_int(253, 255));
      numbers[{x, 0}] = bytes[{x, 0}];
    }
    Bitmap of_bytes(size, 1), of_numbers(size, 1);
    of_bytes.read(0, std::span<const std::uint8_t>(bytes.row(0)), std::uint8_t{254});
    of_numbers.read(0, std::span<const int>(numbers.row(0)), 254);
    ASSERT_EQ(of_bytes.words(), static_cast<std::size_t>(size + 63) / 64);
    for (int x = -64; x < 64 * (size / 64 + 1); ++x) {
      const bool set = 0 <= x && x < size && numbers[{x, 0}] == 254;
      const auto bit = [&](const Bitmap& bitmap) {
        return (bitmap.row(0)[(x + 64) / 64 - 1] >> ((x + 64) % 64) & 1) != 0;
      };
      EXPECT_EQ(bit(of_bytes), set) << x << " of " << size;
      EXPECT_EQ(bit(of_numbers), set) << x << " of " << size;
    }
    EXPECT_EQ(of_bytes.row(0)[of_bytes.words()], 0u);
    EXPECT_EQ(std::count(of_bytes.row(-1) - 1, of_bytes.row(0), Word{0}),
              of_bytes.row(0) - of_bytes.row(-1) + 1);
    // And back: they get another value
    const std::span<const Word> words(of_bytes.row(0), of_bytes.words());
    const auto wanted = std::ranges::count(bytes.cells(), 254);
    auto right = numbers;
    std::ranges::replace(right.cells(), 254, 7);
    EXPECT_EQ(paint_bits(bytes.row(0), words, std::uint8_t{7}), wanted);
    EXPECT_EQ(paint_bits(numbers.row(0), words, 7), wanted);
    EXPECT_EQ(numbers, right);
    EXPECT_TRUE(std::ranges::equal(bytes.cells(), right.cells()));
  }
}

TEST_F(FloodFillBatch, EndsOfRuns) {
  for (int round = 0; round < 2000; ++round) {
    const int width = static_cast<int>(random_.uniform_int(1, 100));
    const double equal = random_.uniform(0.3, 1);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width));
    for (auto& byte : bytes) byte = random_.unit() < equal ? 200 : 201;
    const auto at = [&](int x) { return bytes[static_cast<std::size_t>(x)]; };
    const int x = static_cast<int>(random_.uniform_int(0, width - 1));
    const int end = static_cast<int>(random_.uniform_int(x, width));
    int found = x, other = x, start = x;
    while (found < end && at(found) != 200) ++found;
    while (other < width && at(other) == 200) ++other;
    while (start > 0 && at(start - 1) == 200) --start;
    EXPECT_EQ(first_equal(bytes.data(), x, end, std::uint8_t{200}), found);
    EXPECT_EQ(first_other(bytes.data(), x, width, std::uint8_t{200}), other);
    EXPECT_EQ(run_start(bytes.data(), x, std::uint8_t{200}), start);
  }
}

TEST_F(FloodFillBatch, BitsBesideMarks) {
  for (int round = 0; round < 2000; ++round) {
    const auto draw = [&] { return random_() | (round % 2 == 0 ? random_() : 0); };
    const Word bits = draw(), marks = bits & random_() & random_(), carry = random_() & 1;
    Word right = 0, left = 0;
    bool marked = carry != 0;
    for (int i = 0; i < 64; ++i) {
      marked = (bits >> i & 1) != 0 && (marked || (marks >> i & 1) != 0);
      right |= Word{marked} << i;
    }
    marked = false;
    for (int i = 63; i >= 0; --i) {
      marked = (bits >> i & 1) != 0 && (marked || (marks >> i & 1) != 0);
      left |= Word{marked} << i;
    }
    EXPECT_EQ(right_of_marks(bits, marks, carry), right);
    EXPECT_EQ(left_of_marks(bits, marks), left);
  }
}

TEST_F(FloodFillBatch, LabelSetsAreThoseOfTheirJoins) {
  constexpr Label count = 500;
  LabelSets sets;
  sets.make_room(count);
  std::vector<Label> names(count);  // of each label's set, kept up by hand
  for (Label i = 0; i < count; ++i) {
    EXPECT_EQ(sets.next(), i);
    sets.make(false);
    sets.make(true);
    names[i] = i;
  }
  for (int round = 0; round < 400; ++round) {
    const auto a = static_cast<Label>(random_.uniform_int(0, count - 1));
    const auto b = static_cast<Label>(random_.uniform_int(0, count - 1));
    EXPECT_LE(sets.join(a, b), std::min(a, b));
    const Label kept = std::min(names[a], names[b]), gone = std::max(names[a], names[b]);
    std::ranges::replace(names, gone, kept);
  }
  sets.settle();
  for (Label i = 0; i < count; ++i) EXPECT_EQ(sets.name_of(i), names[i]);
  EXPECT_EQ(sets.bytes(), count * sizeof(Label));
}

}  // namespace
}  // namespace gradus::flood_fill
