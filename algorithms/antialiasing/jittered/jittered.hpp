#pragma once
// Where a pixel's samples lie: on a grid, anywhere, one somewhere in each cell of a grid, one in each row and
// each column, both at once, or so that every box of one sample's area has one.
//
// A pixel is [0, 1) x [0, 1), x to the right, y down. A pattern is a pure function of its count and of the
// random numbers it is given; those of a pixel are `numbers_of(seed, pixel)`, so that pixels can be asked for
// in any order and neighbours have other patterns. Regular samples turn detail that is too fine into false
// waves; random ones turn it into noise.

#include <bit>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <type_traits>
#include <utility>

#include "antialiasing/jittered/shuffles.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"
#include "core/observe.hpp"
#include "core/pixels.hpp"
#include "core/random.hpp"

namespace gradus::jittered {

/// More samples than this no pattern has: what is computed of their places stays exact until one division.
inline constexpr int most_samples = 65536;

// --- Steps -------------------------------------------------------

/// The pixel is cut into cells, `grid.x` of them across and `grid.y` down.
struct Cut {
  ivec2 grid;
};

/// Two rooks have changed their rows; here they stand now, as column and row.
struct Swapped {
  ivec2 rook, other;
};

/// A point of the sequence: its column and row of `samples` before and after coins have turned them.
struct Scrambled {
  int index;
  ivec2 plain, turned;
};

/// Sample `index` lies u.x of the way across and u.y of the way down a cell of a grid.
struct Placed {
  int index;
  ivec2 cell, grid;
  dvec2 u, place;
};

/// All samples lie in the pixel.
struct Finished {
  int samples;
};

/// A sample has been looked at; the mean is that of all so far.
template <class Colour>
struct Looked {
  int index;
  dvec2 place;  ///< in the picture
  Colour colour, mean;
};

// --- Random numbers ----------------------------------------------

/// The random numbers of one pixel, a stream of its own for each: no two pixels' patterns are the same.
constexpr Random numbers_of(std::uint64_t seed = 1, ivec2 pixel = {0, 0}) {
  const auto bits = [](int x) { return std::uint64_t{static_cast<std::uint32_t>(x)}; };
  return Random(seed, bits(pixel.y) << 32 | bits(pixel.x));
}

/// How far through its cell a sample lies, from one random number: two odd multiples of 2^-33, so that it is
/// never on a border, nor rounded onto one.
constexpr dvec2 offsets(Random& random) {
  const std::uint64_t bits = random();
  const auto offset = [](std::uint32_t half) { return (half + 0.5) * 0x1p-32; };
  return {offset(static_cast<std::uint32_t>(bits)), offset(static_cast<std::uint32_t>(bits >> 32))};
}

/// One of the samples, each equally likely.
constexpr dvec2& any(std::span<dvec2> samples, Random& random) {
  const std::int64_t last = static_cast<std::int64_t>(samples.size()) - 1;
  return samples[static_cast<std::size_t>(random.uniform_int(0, last))];
}
constexpr std::span<dvec2> all_but_last(std::span<dvec2> samples) {
  return samples.first(samples.size() - 1);
}

// --- Grids -------------------------------------------------------

constexpr void expect_count(std::span<dvec2> samples) {
  expects(0 < samples.size() && samples.size() <= most_samples, "a pattern has 1 to {} samples, not {}",
          most_samples, samples.size());
}
/// How many samples the caller wants. Errors: none, or more than most_samples.
constexpr int count_of(std::span<dvec2> samples) {
  expect_count(samples);
  return static_cast<int>(samples.size());
}

/// Which of them this is.
constexpr int index_of(std::span<dvec2> samples, const dvec2& sample) {
  return static_cast<int>(&sample - samples.data());
}

/// The largest whole number whose square is not above `count`.
constexpr int root_of(int count) {
  int root = 1;
  while ((root + 1) * (root + 1) <= count) ++root;
  return root;
}

/// The grid of exactly `count` cells that is nearest to a square one, at least as wide as high; of a prime
/// number it has one row.
constexpr ivec2 grid_of(int count) {
  int rows = root_of(count);
  while (count % rows != 0) --rows;
  return {count / rows, rows};
}

/// Column and row of cell `number`, counted row by row.
constexpr ivec2 cell_of(int number, ivec2 grid) { return {number % grid.x, number / grid.x}; }

/// A place in a cell. Accuracy: rounded once; never on the cell's border.
constexpr dvec2 in_cell(ivec2 cell, dvec2 u, ivec2 grid) { return (dvec2(cell) + u) / dvec2(grid); }

// --- The patterns ------------------------------------------------

/// A sample in the middle of each cell of a grid, the same in every pixel.
///
/// samples: 1 to most_samples, are written row by row; `grid_of` says how many a row has.
///
/// Domain: every count. Steps: Cut Placed* Finished, a Placed each sample.
/// Accuracy: each is the nearest double to the cell's middle.
/// Cost: two divisions per sample; no memory. Errors: expects 1 to most_samples.
template <Observer<Cut, Placed, Finished> O = Unobserved>
constexpr void regular(std::span<dvec2> samples, O&& observer = {}) {
  const int n = count_of(samples);
  const ivec2 grid = grid_of(n);
  if constexpr (observed<O>) observer(Cut{grid});
  int i = 0;
  for (dvec2& sample : samples) {
    // One cell after the other
    auto cell = cell_of(i, grid);
    // Its middle
    const dvec2 u(0.5);
    sample = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{i, cell, grid, u, sample});
    ++i;
  }
  if constexpr (observed<O>) observer(Finished{n});
}

/// Each sample anywhere in the pixel, independent of the others: they form clumps and gaps.
///
/// samples: as for `regular`. random: see numbers_of.
///
/// Domain: every count. Steps: Cut Placed* Finished; the one cell is the pixel.
/// Accuracy: strictly inside the pixel; each mean over the pixel has the expected value of a single sample,
///   and an error that shrinks as 1/sqrt(count).
/// Cost: one random number per sample. Errors: expects 1 to most_samples.
template <Observer<Cut, Placed, Finished> O = Unobserved>
constexpr void uniform(std::span<dvec2> samples, Random random, O&& observer = {}) {
  expect_count(samples);
  if constexpr (observed<O>) observer(Cut{ivec2(1)});
  // None minds the others: they
  // form clumps and leave gaps
  for (dvec2& sample : samples) {
    // Anywhere in the pixel
    const dvec2 u = offsets(random);
    sample = u;
    if constexpr (observed<O>) observer(Placed{index_of(samples, sample), ivec2(0), ivec2(1), u, sample});
  }
  if constexpr (observed<O>) observer(Finished{count_of(samples)});
}

/// One sample in each cell of a grid, anywhere in it.
/// Source: R. Cook, "Stochastic sampling in computer graphics", ACM TOG 5 (1986), 51-72, section 3.
///
/// samples, random: as for `uniform`. They come row by row; `grid_of` says how many a row has.
///
/// Domain: every count; a prime one gives a single row of tall cells.
/// Steps: Cut Placed* Finished, a Placed each cell.
/// Accuracy: cell (i, j) of a x b has exactly one sample, and i < a·x < i + 1, j < b·y < j + 1 in exact
///   arithmetic. Straight edges, RMSE: .0453, .0160, .0057 with 16, 64, 256 samples, as count^-0.75.
/// Cost: one random number and two divisions per sample; no memory. Errors: expects 1 to most_samples.
template <Observer<Cut, Placed, Finished> O = Unobserved>
constexpr void jittered(std::span<dvec2> samples, Random random, O&& observer = {}) {
  const int n = count_of(samples);
  const ivec2 grid = grid_of(n);
  if constexpr (observed<O>) observer(Cut{grid});
  int i = 0;
  for (dvec2& sample : samples) {
    // One cell after the other
    auto cell = cell_of(i, grid);
    // Anywhere in it
    const dvec2 u = offsets(random);
    sample = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{i, cell, grid, u, sample});
    ++i;
  }
  if constexpr (observed<O>) observer(Finished{n});
}

/// n samples, one in each of n columns and one in each of n rows, as rooks that don't attack each other.
/// Source: P. Shirley, "Discrepancy as a quality measure for sample distributions", Eurographics 1991,
///   183-194, section 4.
///
/// samples, random: as for `uniform`. They come column by column.
///
/// Domain: every count. Steps: Cut Swapped* Placed* Finished; one Swapped less than samples.
/// Accuracy: each column and each row has exactly one sample, strictly inside. All orders are equally likely.
/// Cost: two random numbers and two divisions per sample; no memory. Errors: expects 1 to most_samples.
template <Observer<Cut, Swapped, Placed, Finished> O = Unobserved>
constexpr void n_rooks(std::span<dvec2> samples, Random random, O&& observer = {}) {
  const int n = count_of(samples);
  const ivec2 grid(n);
  if constexpr (observed<O>) observer(Cut{grid});
  // Rooks along the diagonal
  int i = 0;
  for (dvec2& rook : samples) {
    rook = dvec2(i);
    ++i;
  }
  // Shuffle their rows
  auto rest = samples;
  while (rest.size() > 1) {
    dvec2& rook = rest.back();
    auto& other = any(rest, random);
    std::swap(rook.y, other.y);
    if constexpr (observed<O>) observer(Swapped{ivec2(rook), ivec2(other)});
    rest = all_but_last(rest);
  }
  // Each anywhere in its square
  for (dvec2& sample : samples) {
    const ivec2 cell(sample);
    const dvec2 u = offsets(random);
    sample = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{index_of(samples, sample), cell, grid, u, sample});
  }
  if constexpr (observed<O>) observer(Finished{n});
}

/// One sample in each cell of a coarse grid, and yet one in each column and each row of the fine one: inside
/// the cells of one column the samples stand in the order of one shuffle, which all columns share.
/// Source: A. Kensler, "Correlated multi-jittered sampling", Pixar Technical Memo 13-01, 2013, listing 5,
///   with his hashed permutation; in place of its hashed numbers those of the house.
///
/// samples, random: as for `uniform`. They come row by row of the fine grid.
///
/// Domain: every count N. The coarse grid has m = floor(sqrt N) columns and n = ceil(N / m) strips of m rows;
///   where m·n > N the last strip is not full.
/// Steps: Cut Placed* Finished; Cut has the coarse grid, Placed the fine one of m·n columns and N rows.
/// Accuracy: exactly one sample in each of N rows, at most one in each of m·n columns, at most one in each
///   of the coarse cells; exactly one each where m·n = N. All strictly inside. Straight edges, RMSE: .0368,
///   .0129, .0045 with 16, 64, 256 samples.
/// Cost: one random number, two permutations and two divisions per sample; no memory.
/// Errors: expects 1 to most_samples.
template <Observer<Cut, Placed, Finished> O = Unobserved>
constexpr void correlated_multi_jittered(std::span<dvec2> samples, Random random, O&& observer = {}) {
  const int N = count_of(samples);
  const int m = root_of(N);
  const int n = (N + m - 1) / m;
  const ivec2 fine{m * n, N};
  const Shuffle columns(m, random);
  const Shuffle slots(n, random);
  if constexpr (observed<O>) observer(Cut{{m, n}});
  int row = 0;
  for (dvec2& sample : samples) {
    // m rows per strip: any column
    const int i = columns(row % m);
    // One of its n slots per strip
    const int j = slots(row / m);
    ivec2 cell{i * n + j, row};
    const dvec2 u = offsets(random);
    sample = in_cell(cell, u, fine);
    if constexpr (observed<O>) observer(Placed{row, cell, fine, u, sample});
    ++row;
  }
  if constexpr (observed<O>) observer(Finished{N});
}

/// m of a power of two 2^m.
constexpr int levels_of(int count) { return std::countr_zero(static_cast<std::uint32_t>(count)); }

/// Column and row of point `number` of Sobol's sequence, its first two coordinates, among 2^levels each.
/// Source: I. Sobol, "On the distribution of points in a cube …", USSR Comput. Math. Math. Phys. 7 (1967),
///   86-112. The first coordinate is the number's bits in reverse; the second one's direction numbers are
///   Pascal's triangle modulo 2, of the polynomial 1 + x.
/// Domain: 0 <= number < 2^levels, levels up to 16.
constexpr ivec2 sobol_cell(int number, int levels) {
  std::uint32_t column = 0, row = 0, digit = 1u << levels >> 1, direction = digit;
  for (; number != 0; number >>= 1) {
    if ((number & 1) != 0) column ^= digit, row ^= direction;
    digit >>= 1;
    direction ^= direction >> 1;
  }
  return {static_cast<int>(column), static_cast<int>(row)};
}

/// Turns a whole number of `levels` bits: each bit by the coin of the node that the bits before it lead to.
/// Source: A. Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", MCQMC 1995, 299-317.
/// Cost: a coin per bit.
constexpr int turned(int number, int levels, Coins& coins) {
  std::uint32_t node = 1;
  int result = 0;
  for (int level = levels - 1; level >= 0; --level) {
    // The coin at this node changes both halves, or leaves them
    const int bit = number >> level & 1;
    result = 2 * result + (bit ^ int{coins(node)});
    node = 2 * node + static_cast<std::uint32_t>(bit);
  }
  return result;
}

/// 2^m samples, one in each box of 2^-m of the pixel's area, of any shape: 1 x 2^m cells, 2 x 2^(m-1),
/// … 2^m x 1. Sobol's first two coordinates, scrambled by Owen's nested coins.
/// Source: as sobol_cell and turned; the scrambling is exact, not hashed: below the 2^m columns and rows what
///   the coins would say is a uniform offset.
///
/// samples, random: as for `uniform`. They come in the sequence's order.
///
/// Domain: counts that are powers of two. Steps: Cut (Scrambled Placed)* Finished.
/// Accuracy: exactly one sample in each of those boxes, strictly inside.
/// Cost: 2 m coins and two divisions per sample, one random number and up to 2 m more where 2^m > 64; no
/// memory. Errors: expects a power of two, at most most_samples.
template <Observer<Cut, Scrambled, Placed, Finished> O = Unobserved>
constexpr void sobol(std::span<dvec2> samples, Random random, O&& observer = {}) {
  expects(std::has_single_bit(samples.size()), "Sobol patterns have 2^m samples, not {}", samples.size());
  const int n = count_of(samples);
  const int m = levels_of(n);
  const ivec2 grid(n);
  Coins across(random.split(0));
  Coins down(random.split(1));
  if constexpr (observed<O>) observer(Cut{grid});
  int i = 0;
  for (dvec2& sample : samples) {
    // Point i of the sequence
    const auto p = sobol_cell(i, m);
    // Coins turn halves of halves
    auto x = turned(p.x, m, across);
    auto y = turned(p.y, m, down);
    const ivec2 cell{x, y};
    if constexpr (observed<O>) observer(Scrambled{i, p, cell});
    const dvec2 u = offsets(random);
    sample = in_cell(cell, u, grid);
    if constexpr (observed<O>) observer(Placed{i, cell, grid, u, sample});
    ++i;
  }
  if constexpr (observed<O>) observer(Finished{n});
}

/// All of them, for a choice at run time.
enum class Pattern : std::uint8_t { regular, uniform, jittered, n_rooks, correlated_multi_jittered, sobol };

/// The samples of one pixel by any pattern. Domain, Accuracy, Cost, Errors: the pattern's.
constexpr void put(Pattern pattern, std::span<dvec2> samples, const Random& random) {
  switch (pattern) {
    case Pattern::regular:
      return regular(samples);
    case Pattern::uniform:
      return uniform(samples, random);
    case Pattern::jittered:
      return jittered(samples, random);
    case Pattern::n_rooks:
      return n_rooks(samples, random);
    case Pattern::correlated_multi_jittered:
      return correlated_multi_jittered(samples, random);
    case Pattern::sobol:
      return sobol(samples, random);
  }
}

// --- What they are for -------------------------------------------

/// What a callable returns, of itself.
template <class ColourAt, class Place>
using ColourOf = std::remove_cvref_t<std::invoke_result_t<ColourAt&, Place>>;

/// The colour of a pixel: the mean of what is seen at its samples.
///
/// samples: places in [0, 1) x [0, 1), at least one. colour_at(dvec2): what the scene has at that place of
///   the picture; what it returns starts at 0 as Colour{}, can be added and divided by a double.
///
/// Domain: any pixel; a place is rounded once, in very wide pictures even to the pixel's far border.
/// Steps: Looked*, one each sample.
/// Accuracy: that of the sum: count·2^-53 of the largest colour; exact for colours 0 and 1.
/// Cost: one call of colour_at per sample. Errors: expects a sample.
template <class ColourAt, class Colour = ColourOf<ColourAt, dvec2>, class O = Unobserved>
constexpr Colour sample_pixel(ivec2 p, std::span<const dvec2> samples, ColourAt&& colour_at,
                              O&& observer = {}) {
  expects(!samples.empty(), "a pixel without samples has no colour");
  Colour sum{};
  int taken = 0;
  for (dvec2 sample : samples) {
    // What the scene has there
    auto place = dvec2(p) + sample;
    auto colour = colour_at(place);
    sum += colour;
    ++taken;
    if constexpr (observed<O>) observer(Looked<Colour>{taken - 1, place, colour, sum / double(taken)});
  }
  // By as many as were taken
  return sum / double(taken);
}

/// A picture: every pixel by a pattern of its own.
///
/// picture: which pixels. samples: room for those of one pixel; its size is their count. seed: of all
///   patterns. colour_at: as for sample_pixel. plot(ivec2, colour) is called once per pixel, row by row.
///
/// Domain: any window, an empty one plots nothing. Accuracy, Errors: those of the pattern and sample_pixel.
/// Cost: theirs a pixel; no memory.
template <class ColourAt, class Plot, class Colour = ColourOf<ColourAt, dvec2>>
constexpr void sample_picture(const Window& picture, Pattern pattern, std::span<dvec2> samples,
                              std::uint64_t seed, ColourAt&& colour_at, Plot&& plot) {
  for (ivec2 p : pixels(picture)) {
    // Another pattern in each pixel
    auto own = numbers_of(seed, p);
    put(pattern, samples, own);
    // The mean of what they see
    Colour sum{};
    for (dvec2 sample : samples) {
      auto at = dvec2(p) + sample;
      sum += colour_at(at);
    }
    auto n = double(samples.size());
    plot(p, sum / n);
  }
}

}  // namespace gradus::jittered
