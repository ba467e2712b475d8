// Who is in front in a pixel: planes that overlap in depth without meeting, that cross, and that cross in a
// ring, against depths at sub-samples in rationals and against a pixel of 64 x 64 samples.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/a_buffer/a_buffer_notes.hpp"
#include "antialiasing/a_buffer/a_buffer_picture.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::a_buffer {
namespace {

using triangle_coverage::snap;
__extension__ using Wide = __int128;

// --- The oracle: whole numbers alone

/// Depths count in 2^-20.
constexpr double depth_unit = 0x1p-20;

/// Twice the area of a, b, c; places in 1/1024 pixel.
Wide doubled(ivec2 a, ivec2 b, ivec2 c) {
  return (Wide{b.x} - a.x) * (Wide{c.y} - a.y) - (Wide{b.y} - a.y) * (Wide{c.x} - a.x);
}

/// A depth as a quotient.
struct Quotient {
  Wide above, below;  ///< below > 0
  friend bool operator<(const Quotient& a, const Quotient& b) {
    return a.above * b.below < b.above * a.below;  // below 2^100
  }
};

/// On which side of the way from a to b a place lies that is moved to the right by something infinitely small
/// and down by something infinitely smaller: the top-left rule.
int side_of(ivec2 a, ivec2 b, ivec2 place) {
  const Wide on = doubled(a, b, place);
  if (on != 0) return on > 0 ? 1 : -1;
  if (a.y != b.y) return a.y > b.y ? 1 : -1;
  return b.x > a.x ? 1 : -1;
}

/// The depth of a triangle at a place in 1/1024 pixel; nothing where it does not cover that.
std::optional<Quotient> depth_at(const ScreenTriangle& t, ivec2 place) {
  const ivec2 a = 4 * t.corners[0], b = 4 * t.corners[1], c = 4 * t.corners[2];
  const Wide all = doubled(a, b, c), sign = all < 0 ? -1 : 1;
  if (all == 0) return std::nullopt;
  for (const int side : {side_of(a, b, place), side_of(b, c, place), side_of(c, a, place)})
    if (side != sign) return std::nullopt;
  const auto whole = [&](int i) { return Wide{std::llround(t.depth[i] / depth_unit)}; };
  const Wide depth =
      doubled(place, b, c) * whole(0) + doubled(a, place, c) * whole(1) + doubled(a, b, place) * whole(2);
  return Quotient{sign * depth, sign * all};
}

/// The numbers of the triangles at a place, from the eye on; of equal depths the lower number first.
std::vector<int> front_to_back(std::span<const ScreenTriangle> triangles, ivec2 place) {
  std::vector<std::pair<Quotient, int>> found;
  for (int i = 0; i < std::ssize(triangles); ++i) {
    if (const auto depth = depth_at(triangles[static_cast<std::size_t>(i)], place))
      found.push_back({*depth, i});
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<int> numbers;
  for (const auto& [depth, number] : found) numbers.push_back(number);
  return numbers;
}

/// What each triangle has of a pixel, by its number.
using Shares = std::map<int, double>;

/// By side x side samples, light going through each for itself. side: that of the cells' middles, or the
/// A-buffer's 32 sub-samples where it is 0.
Shares shares_by_samples(std::span<const ScreenTriangle> triangles, ivec2 pixel, int side, auto&& opacity) {
  Shares shares;
  const int columns = side == 0 ? 8 : side, rows = side == 0 ? 4 : side;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const ivec2 place = 1024 * pixel + ivec2{(2 * x + 1) * 512 / columns, (2 * y + 1) * 512 / rows};
      double light = 1.0 / (columns * rows);
      for (const int number : front_to_back(triangles, place)) {
        shares[number] += light * opacity(number);
        light *= 1 - opacity(number);
      }
    }
  }
  return shares;
}
constexpr auto opaque = [](int) { return 1.0; };

/// By the A-buffer: the colour of a triangle is its number's place in a vector.
struct Weighed64 {
  std::array<double, 16> of{};
  friend Weighed64 operator*(double w, const Weighed64& a) {
    Weighed64 b = a;
    for (double& x : b.of) x *= w;
    return b;
  }
  Weighed64& operator+=(const Weighed64& a) {
    for (std::size_t i = 0; i < of.size(); ++i) of[i] += a.of[i];
    return *this;
  }
};
std::vector<Shares> shares_by_masks(std::span<const ScreenTriangle> triangles, const Window& window,
                                    auto&& opacity) {
  std::vector<Shares> all(static_cast<std::size_t>(window.width() * window.height()));
  const auto colour = [](int number, ivec2, const Weights&) {
    Weighed64 one;
    one.of[static_cast<std::size_t>(number)] = 1;
    return one;
  };
  const auto plot = [&](ivec2 p, const Weighed64& sum, double) {
    const auto i = static_cast<std::size_t>((p.y - window.lower.y) * window.width() + p.x - window.lower.x);
    for (std::size_t k = 0; k < sum.of.size(); ++k)
      if (sum.of[k] > 0) all[i][static_cast<int>(k)] = sum.of[k];
  };
  a_buffer(triangles, window, colour, plot, OwnSurface{}, opacity);
  return all;
}

/// How far two pixels are from each other: the greatest difference of a share.
double distance(const Shares& a, const Shares& b) {
  double most = 0;
  for (const Shares* shares : {&a, &b}) {
    for (const auto& [number, share] : *shares) {
      const auto of = [number](const Shares& s) { return s.contains(number) ? s.at(number) : 0.0; };
      most = std::max(most, std::abs(of(a) - of(b)));
    }
  }
  return most;
}

constexpr int side = 12;
constexpr Window window{{0, 0}, {side - 1, side - 1}};
ivec2 pixel_of(std::size_t i) { return {static_cast<int>(i) % side, static_cast<int>(i) / side}; }

/// A depth that the oracle takes.
double rounded(double depth) { return std::round(depth / depth_unit) * depth_unit; }

/// A triangle over all of the window, in the plane z = at + x * right + y * down; x, y in pixels.
ScreenTriangle plane(double at, double right, double down) {
  constexpr int far = 3 * side;
  const ivec2 a{-far, -far}, b{3 * far, -far}, c{-far, 3 * far};
  const auto depth = [&](ivec2 p) { return rounded(at + p.x * right + p.y * down); };
  return {{256 * a, 256 * b, 256 * c}, {depth(a), depth(b), depth(c)}};
}

// --- What is seen

TEST(ABufferOrder, ParallelSheetsDoNotShineThrough) {
  // Both reach over 0.02 of depth in a pixel, and lie 0.002 apart
  const double slope = rounded(0.02), gap = rounded(0.002);
  for (const bool front_first : {true, false}) {
    const ScreenTriangle front = plane(0.3, slope, slope), back = plane(0.3 + gap, slope, slope);
    const std::vector<ScreenTriangle> sheets =
        front_first ? std::vector{front, back} : std::vector{back, front};
    const Shares whole{{front_first ? 0 : 1, 1.0}};
    for (const Shares& found : shares_by_masks(sheets, window, opaque)) EXPECT_EQ(found, whole);
  }
}

TEST(ABufferOrder, NearSheetsOfPartsOfAPixelDoNotShineThrough) {
  // The nearer one covers only what of the pixel lies deep: it begins behind, and is in front
  const double slope = rounded(0.02);
  const ScreenTriangle back = plane(0.302, slope, 0);
  ScreenTriangle front = plane(0.3, slope, 0);
  front.corners = {snap({5.5, -20}), snap({40, 6}), snap({5.5, 40})};
  for (int i = 0; i < 3; ++i)
    front.depth[i] = rounded(0.3 + slope * front.corners[static_cast<std::size_t>(i)].x / 256.0);
  for (const auto& sheets : {std::vector{front, back}, std::vector{back, front}}) {
    const int number = sheets[0].corners == front.corners ? 0 : 1;
    const Shares found = shares_by_masks(sheets, {{5, 6}, {5, 6}}, opaque)[0];
    EXPECT_EQ(found, (Shares{{number, 0.5}, {1 - number, 0.5}}));
  }
}

TEST(ABufferOrder, PlanesThatCrossShareByWhereTheyDo) {
  // They meet in the column x = 4.625, of which the first is in front on the left
  const double slope = rounded(0.0625);
  const std::vector<ScreenTriangle> planes{plane(0.25, slope, 0), plane(0.25 + 4.625 * 2 * slope, -slope, 0)};
  const auto found = shares_by_masks(planes, window, opaque);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int x = pixel_of(i).x;
    EXPECT_EQ(found[i], x < 4   ? (Shares{{0, 1.0}})
                        : x > 4 ? (Shares{{1, 1.0}})
                                : (Shares{{0, 0.625}, {1, 0.375}}))
        << x;
  }
}

TEST(ABufferOrder, SlopesAlongDifferentDirectionsShareAlongTheirLine) {
  // They cross in the diagonal x = y + 1/2: in a pixel on the other diagonal the first has 7/8. The ranges of
  // their depths say 5/8
  const double slope = rounded(0.0625);
  const std::vector<ScreenTriangle> planes{plane(0.25, 2 * slope, 0), plane(0.25 + slope / 2, slope, slope)};
  const auto found = shares_by_masks(planes, window, opaque);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ivec2 p = pixel_of(i);
    const bool crossed = p.x == p.y || p.x == p.y + 1;
    EXPECT_LT(distance(found[i], shares_by_samples(planes, p, 64, opaque)), crossed ? 0.04 : 1e-12);
  }
  EXPECT_NEAR(found[0].at(0), 7 / 8.0, 0.04);
}

/// Triangles anywhere, at depths anywhere from 0 to 1: every few of them cross.
std::vector<ScreenTriangle> random_scene(Random& random) {
  std::vector<ScreenTriangle> triangles;
  const auto count = random.uniform_int(2, 12);
  const bool near = random.unit() < 0.5;  // sheets at about one depth
  for (int i = 0; i < count; ++i) {
    ScreenTriangle t;
    for (int k = 0; k < 3; ++k) {
      const int x = static_cast<int>(random.uniform_int(-4 * 256, (side + 4) * 256));
      const int y = static_cast<int>(random.uniform_int(-4 * 256, (side + 4) * 256));
      t.corners[static_cast<std::size_t>(k)] = {x, y};
      t.depth[k] = rounded(near ? 0.5 + 0.1 * random.unit() : random.unit());
    }
    triangles.push_back(t);
  }
  return triangles;
}

TEST(ABufferOrder, RandomScenesShowWhatEachSubSampleShows) {
  int mixed = 0;
  double worst = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", case " << i);
    Random random(test::seed(), i);
    const auto triangles = random_scene(random);
    // Glass in every other scene
    const auto opacity = [&](int number) { return i % 2 == 0 || number % 3 == 0 ? 1.0 : 0.25; };
    const auto found = shares_by_masks(triangles, window, opacity);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const Shares right = shares_by_samples(triangles, pixel_of(k), 0, opacity);
      worst = std::max(worst, distance(found[k], right));
      mixed += right.size() > 1;
    }
  }
  EXPECT_LT(worst, 1e-13);
  EXPECT_GT(mixed, 2000);
}

TEST(ABufferOrder, RandomScenesAreNearTo64TimesAsManySamples) {
  double squares = 0, plainly_wrong = 0, pixels = 0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", case " << i);
    Random random(test::seed(), i);
    const auto triangles = random_scene(random);
    const auto found = shares_by_masks(triangles, window, opaque);
    for (std::size_t k = 0; k < found.size(); k += 5) {
      const double off = distance(found[k], shares_by_samples(triangles, pixel_of(k), 64, opaque));
      squares += off * off;
      plainly_wrong += off > 0.15;
      ++pixels;
    }
  }
  RecordProperty("rms", std::to_string(std::sqrt(squares / pixels)));
  EXPECT_LT(std::sqrt(squares / pixels), 0.03);
  EXPECT_EQ(plainly_wrong, 0);
}

// --- The order of a list

TEST(ABufferOrder, WhatCrossesIsParted) {
  // A ring: A before B in the upper half, B before C in the left one, C before A in the lower one
  std::vector<Fragment> list{{full, 1, 2, 1, 0, 0}, {full, 1, 2, 1, 1, 1}, {full, 1, 2, 1, 2, 2}};
  constexpr Mask upper = 0xffff0000, left = 0xf0f0f0f0;
  const auto rank = [&](int source, Mask bit) {
    const bool up = (bit & upper) != 0, west = (bit & left) != 0;
    // One order for each quarter
    const std::array<int, 3> order = up ? (west ? std::array{0, 1, 2} : std::array{2, 0, 1})
                                        : (west ? std::array{1, 2, 0} : std::array{2, 1, 0});
    return std::ranges::find(order, source) - order.begin();
  };
  const auto ranks = [&](const Fragment& f) {
    return [&rank, source = f.source](int sample) { return rank(source, bit_of(sample)); };
  };
  std::map<int, double> weights;
  const double covered = resolve(list, [&](const Fragment& f, double w) { weights[f.source] += w; }, ranks);
  EXPECT_EQ(covered, 1);
  EXPECT_THAT(weights, testing::ElementsAre(std::pair{0, 0.25}, std::pair{1, 0.25}, std::pair{2, 0.5}));
  // All bits of each are there, once, in the order of each sub-sample
  std::map<int, Mask> masks;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(masks[list[i].source] & list[i].mask, 0u);
    masks[list[i].source] |= list[i].mask;
    for (std::size_t k = i + 1; k < list.size(); ++k) {
      for (Mask common = list[i].mask & list[k].mask; common != 0; common &= common - 1)
        EXPECT_LT(rank(list[i].source, common & -common), rank(list[k].source, common & -common));
    }
  }
  EXPECT_THAT(masks, testing::ElementsAre(std::pair{0, full}, std::pair{1, full}, std::pair{2, full}));
}

TEST(ABufferOrder, WhatIsInOrderStaysWhole) {
  // Front to back is the other way round at every common sub-sample
  std::vector<Fragment> list{{0xf0f0f0f0, 1, 3, 1, 0, 0}, {full, 2, 4, 1, 1, 1}};
  auto last_first = [](const Fragment& f) { return [source = f.source](int) { return -source; }; };
  put_in_order(list, last_first);
  EXPECT_THAT(list, testing::ElementsAre(Fragment{full, 2, 4, 1, 1, 1}, Fragment{0xf0f0f0f0, 1, 3, 1, 0, 0}));
}

/// Lists whose depths at the sub-samples are whole numbers, so that many cross and many are alike.
struct Depths {
  std::vector<std::array<int, samples>> of;

  auto operator()(const Fragment& f) const {
    return [this, &f](int sample) { return at(f, sample); };
  }
  int at(const Fragment& f, int sample) const {
    return of[static_cast<std::size_t>(f.source)][static_cast<std::size_t>(sample)];
  }
  /// The common sub-samples at which a lies before b.
  Mask before(const Fragment& a, const Fragment& b) const {
    Mask ahead = 0;
    for (int i = 0; i < samples; ++i)
      if (std::pair(at(a, i), a.source) < std::pair(at(b, i), b.source)) ahead |= bit_of(i);
    return ahead & a.mask & b.mask;
  }
};

/// What put_in_order promises, said without its queues: again and again the first that none lies before, or
/// the part of the first that is open in part.
std::vector<Fragment> in_plain_order(std::vector<Fragment> rest, const Depths& depths) {
  std::vector<Fragment> order;
  while (!rest.empty()) {
    std::vector<Mask> open;
    for (const Fragment& f : rest) {
      open.push_back(f.mask);
      for (const Fragment& other : rest)
        if (&other != &f) open.back() &= ~depths.before(other, f);
    }
    std::size_t next = 0;
    while (next < rest.size() && open[next] != rest[next].mask) ++next;
    if (next == rest.size())
      next = static_cast<std::size_t>(std::ranges::find_if(open, std::identity{}) - open.begin());
    order.push_back(rest[next]);
    order.back().mask = open[next];
    rest[next].mask &= ~open[next];
    if (rest[next].mask == 0) rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return order;
}

TEST(ABufferOrder, IsThatOfTheDefinition) {
  int parted = 0, moved = 0;
  for (std::uint64_t round = 0; round < 600; ++round) {
    SCOPED_TRACE(testing::Message() << "seed " << test::seed() << ", round " << round);
    Random random(test::seed(), round);
    const int count = static_cast<int>(random.uniform_int(1, 9));
    const int slope = round % 3 == 0 ? 0 : 3;
    Depths depths;
    std::vector<Fragment> list;
    for (int source = 0; source < count; ++source) {
      const auto middle = random.uniform_int(0, 12), across = random.uniform_int(-slope, slope),
                 down = random.uniform_int(-slope, slope);
      std::array<int, samples> depth{};
      for (int i = 0; i < samples; ++i)
        depth[static_cast<std::size_t>(i)] =
            static_cast<int>(2 * middle + across * (i % mask_columns - 3) + down * (i / mask_columns - 1));
      const auto [least, most] = std::ranges::minmax(depth);
      const bool nowhere = random.uniform_int(0, 9) == 0;
      const Mask mask = nowhere ? 0 : round % 2 == 0 ? full : static_cast<Mask>(random.uniform_int(1, full));
      list.push_back({mask, double(least), double(most), 1, source, source});
      depths.of.push_back(depth);
    }
    std::ranges::sort(list, nearer);
    const auto right = in_plain_order(list, depths);
    const auto given = list;
    put_in_order(list, depths);
    EXPECT_EQ(list, right);
    parted += right.size() > given.size();
    moved += right != given;
  }
  EXPECT_GT(parted, 50);
  EXPECT_GT(moved, 150);
}

TEST(ABufferOrder, OfLongListsAsksForEachDepthOnce) {
  // All cross one another in the pixel, and nearest depths tell the very opposite of most of their order
  constexpr int count = 20'000;
  std::vector<Fragment> list;
  for (int i = 0; i < count; ++i) list.push_back({full, double(i), 1e6, 1, i, i});
  std::int64_t asked = 0;
  auto crossing = [&](const Fragment& f) {
    return [&asked, i = f.source](int sample) {
      ++asked;
      return sample == 0 ? i : -i;
    };
  };
  // The upper left sub-sample of all but the last is seen in an order of its own
  put_in_order(list, crossing);
  EXPECT_EQ(list.size(), std::size_t{2 * count - 1});
  EXPECT_EQ(asked, std::int64_t{samples} * count);
  std::array<std::vector<int>, 2> orders;
  for (const Fragment& f : list)
    for (const int sample : {0, 1})
      if ((f.mask & bit_of(sample)) != 0) orders[static_cast<std::size_t>(sample)].push_back(f.source);
  EXPECT_EQ(std::ssize(orders[0]), count);
  EXPECT_TRUE(std::ranges::is_sorted(orders[0]));
  EXPECT_EQ(std::ssize(orders[1]), count);
  EXPECT_TRUE(std::ranges::is_sorted(orders[1], std::greater{}));
}

// --- The source's estimate

// --- What is hidden

/// What each of a list takes of the pixel.
std::map<int, double> shares_of(std::vector<Fragment> list) {
  std::map<int, double> shares;
  resolve(list, [&](const Fragment& f, double weight) { shares[f.source] += weight; });
  return shares;
}

TEST(ABufferOrder, WhatIsHiddenAtEachSubSampleIsLeftOutAndNothingElse) {
  std::size_t left_out = 0;
  for (std::uint64_t round = 0; round < 400; ++round) {
    Random random(test::seed(), round);
    std::vector<Fragment> list;
    const auto count = random.uniform_int(1, 20);
    for (int i = 0; i < count; ++i) {
      // Few depths, so that some are equal
      const auto near = static_cast<double>(random.uniform_int(0, 9)),
                 thick = static_cast<double>(random.uniform_int(0, 2));
      const auto one = static_cast<Mask>(random()), two = static_cast<Mask>(random());
      const Mask mask = random.uniform_int(0, 2) == 0 ? full : one | two | 1;
      const double opacity = random.uniform_int(0, 3) == 0 ? 0.5 : 1;
      list.push_back({.mask = mask,
                      .z_near = near,
                      .z_far = near + thick,
                      .opacity = opacity,
                      .surface = i,
                      .source = i});
    }
    std::vector<Fragment> kept = list;
    leave_out_hidden(kept);
    left_out += list.size() - kept.size();
    const auto all = shares_of(list), of_kept = shares_of(kept);
    for (const Fragment& f : list) {
      const auto share = [&](const auto& shares) {
        const auto found = shares.find(f.source);
        return found == shares.end() ? 0.0 : found->second;
      };
      ASSERT_NEAR(share(of_kept), share(all), 1e-13) << "round " << round << ", fragment " << f.source;
    }
    // By the definition: at each sub-sample something opaque ends before it begins
    for (const Fragment& f : list) {
      Mask behind = 0;
      for (const Fragment& g : list)
        if (g.opacity == 1 && g.z_far < f.z_near) behind |= g.mask;
      ASSERT_EQ(std::ranges::find(kept, f) == kept.end(), (f.mask & ~behind) == 0);
    }
  }
  EXPECT_GT(left_out, 1000U);
}

TEST(ABufferNotes, RangesOfDepthAreNoCrossing) {
  const auto weights_of = [](std::vector<Fragment> list, auto method) {
    std::vector<double> weights;
    method(list, [&](const Fragment&, double w) { weights.push_back(w); });
    return weights;
  };
  const auto estimate = [](auto& list, auto take) { by_ranges(list, take); };
  const auto taught = [](auto& list, auto take) { resolve(list, take); };
  // From 1 to 3 and from 2 to 4: (4 - 1) / (2 + 2), right for opposite slopes; parallel sheets have the same
  const std::vector<Fragment> list{{full, 1, 3, 1, 0, 0}, {full, 2, 4, 1, 1, 1}};
  EXPECT_THAT(weights_of(list, estimate), testing::ElementsAre(0.75, 0.25));
  EXPECT_THAT(weights_of(list, taught), testing::ElementsAre(1));
  // Two that overlap altogether, and one that only touches
  const auto of_first = [](const std::vector<Fragment>& sorted) { return crossing(sorted, sorted[0]); };
  EXPECT_EQ(of_first({{full, 0, 1, 1, 0, 0}, {full, 0, 1, 1, 1, 1}}).front, 0.5);
  EXPECT_EQ(of_first({{full, 0, 1, 1, 0, 0}, {full, 1, 2, 1, 1, 1}}).mask, 0u);
  EXPECT_EQ(of_first({{full, 0, 1, 1, 0, 0}, {full, 0, 1, 1, 0, 1}}).mask, 0u);
}

}  // namespace
}  // namespace gradus::a_buffer
