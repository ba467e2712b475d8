// Known pixels, masks against each sub-sample alone, the step grammar, opacity, merging, memory, refusals.

#include "antialiasing/a_buffer/a_buffer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "antialiasing/a_buffer/a_buffer_notes.hpp"
#include "antialiasing/a_buffer/a_buffer_picture.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "support/random_edges.hpp"

namespace gradus::a_buffer {
namespace {

using triangle_coverage::snap;
using triangle_coverage::Triangle;

constexpr dvec3 red{1, 0, 0}, blue{0, 0, 1};

/// A pixel over black, by any of the methods; `source` numbers the colours.
dvec3 mixed(std::vector<Fragment> list, const std::vector<dvec3>& colours, auto method) {
  dvec3 sum{0};
  method(list, [&](const Fragment& f, double w) { sum += w * colours[static_cast<std::size_t>(f.source)]; });
  return sum;
}
constexpr auto by_masks = [](auto& list, auto take) { resolve(list, take); };
constexpr auto by_areas = [](auto& list, auto take) { sum_of_areas(list, take); };
constexpr auto by_division = [](auto& list, auto take) { divided_by_covered(list, take); };

Fragment fragment(Mask mask, double z, int source, double opacity = 1) {
  return {mask, z, z, opacity, source, source};
}

// --- Masks

TEST(ABufferMasks, AreReadRowByRow) {
  const auto box = [](double left, double top, double right, double bottom) {
    const std::vector<ivec2> ring{snap({left, top}), snap({right, top}), snap({right, bottom}),
                                  snap({left, bottom})};
    return mask_of(ring, {2, 3});
  };
  EXPECT_EQ(box(2, 3, 3, 4), full);
  EXPECT_EQ(box(2, 3, 2.5, 4), 0xf0f0f0f0);
  EXPECT_EQ(box(2, 3, 3, 3.25), 0xff000000);
  EXPECT_EQ(box(2, 3.75, 2.125, 4), 0x00000080);
  EXPECT_EQ(box(3, 3, 4, 4), 0u);
  EXPECT_EQ(place_of({2, 3}, 0), (ivec2{528, 800}));
  EXPECT_EQ(place_of({2, 3}, 31), (ivec2{752, 992}));
}

/// By each edge's function at each sub-sample.
Mask one_by_one(const Triangle& triangle, ivec2 pixel) {
  Mask mask = 0;
  const Edges edges = edges_of(triangle);
  for (int i = 0; i < samples; ++i) {
    if (holds(edges, weights_at_place(edges, place_of(pixel, i)))) mask |= bit_of(i);
  }
  return mask;
}

TEST(ABufferMasks, AreWhatEachSubSampleSays) {
  constexpr std::uint64_t seed = 20260117;
  RecordProperty("seed", static_cast<std::int64_t>(seed));
  Random random(seed);
  int partial = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Half of the corners on the sub-samples' own grid, where edges run through them
    const auto corner = [&] {
      const auto at = [&] {
        const auto k = random.uniform_int(-300, 600);
        return static_cast<int>(i % 2 == 0 ? k : (k / 16) * 16);
      };
      const int x = at();
      return ivec2{x, at()};
    };
    const ivec2 a = corner(), b = corner(), c = corner();
    const Mask mask = mask_of(edges_of({a, b, c}), {0, 0});
    ASSERT_EQ(mask, one_by_one({a, b, c}, {0, 0}));
    ASSERT_EQ(mask, mask_of(edges_of({a, c, b}), {0, 0}));
    ASSERT_EQ(area_of(mask), std::popcount(mask) / 32.0);
    partial += mask != 0 && mask != full;
  }
  EXPECT_GT(partial, 5000);
}

TEST(ABufferMasks, StepsAreTheHalfPlanes) {
  const Edges edges = edges_of({snap({0.1, 0.2}), snap({0.9, 0.3}), snap({0.4, 1.4})});
  Recorder<HalfPlane> seen;
  const Mask mask = mask_of(edges, {0, 0}, seen);
  EXPECT_EQ(mask, mask_of(edges, {0, 0}));
  const auto steps = all<HalfPlane>(seen);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].inside & steps[1].inside & steps[2].inside, mask);
  EXPECT_EQ(steps[2].left, mask);
  EXPECT_EQ(mask_of(edges_of({ivec2{0, 0}, {128, 128}, {256, 256}}), {0, 0}), 0u);
}

TEST(ABufferMasks, ErrorOnRandomStraightEdges) {
  // R. Cook's measure: the root of the mean square of (area by the mask - area); known: .0202
  constexpr std::uint64_t seed = 1984;
  constexpr int edges = 200'000;
  RecordProperty("seed", static_cast<std::int64_t>(seed));
  Random random(seed);
  double squares = 0, sum = 0;
  for (int i = 0; i < edges; ++i) {
    const test::StraightEdge line = test::random_edge(random);
    // The same line by two places 2000 pixels away, so that snapping turns it by 1e-6 at most
    const dvec2 foot = line.reach * line.normal, along{-line.normal.y, line.normal.x};
    const Edge edge{snap(foot + 2000.0 * along), snap(foot - 2000.0 * along), true};
    const Mask mask = half_plane(edge, {0, 0});
    const Mask other = half_plane({edge.to, edge.from, false}, {0, 0});
    ASSERT_EQ(mask ^ other, full);
    const double inner = area_of(line.holds({0.5, 0.5}) == (edge.at({128, 128}) >= 0) ? mask : other);
    squares += (inner - line.area()) * (inner - line.area());
    sum += inner - line.area();
  }
  const double rms = std::sqrt(squares / edges);
  RecordProperty("rms", std::to_string(rms));
  EXPECT_NEAR(rms, 0.0202, 0.00005);
  EXPECT_LT(std::abs(sum / edges), 4 * rms / std::sqrt(edges));
}

// --- One pixel

TEST(ABuffer, TheNearerFragmentHides) {
  // G001-114, E001-57: opaque red in front of opaque blue, both over the whole pixel
  const std::vector<Fragment> list{fragment(full, 2, 1), fragment(full, 1, 0)};
  EXPECT_EQ(mixed(list, {red, blue}, by_masks), (dvec3{1, 0, 0}));
  EXPECT_EQ(mixed(list, {red, blue}, by_areas), (dvec3{0.5, 0, 0.5}));
}

TEST(ABuffer, TheBackgroundGetsTheRest) {
  // G001-115, E001-58: red over a quarter of a black pixel
  const std::vector<Fragment> list{fragment(0xff000000, 1, 0)};
  EXPECT_EQ(mixed(list, {red}, by_masks), (dvec3{0.25, 0, 0}));
  EXPECT_EQ(mixed(list, {red}, by_division), (dvec3{1, 0, 0}));
  EXPECT_EQ(mixed(list, {red}, by_areas), (dvec3{1, 0, 0}));
}

TEST(ABuffer, WeightsAreTheBitsThatRemain) {
  // G001-116: the nearer one covers the left half, the other the whole pixel
  std::vector<Fragment> list{fragment(full, 2, 1), fragment(0xf0f0f0f0, 1, 0)};
  EXPECT_EQ(mixed(list, {red, blue}, by_masks), (dvec3{0.5, 0, 0.5}));
  std::vector<std::pair<int, double>> weights;
  EXPECT_EQ(resolve(list, [&](const Fragment& f, double w) { weights.push_back({f.source, w}); }), 1);
  EXPECT_THAT(weights, testing::ElementsAre(std::pair{0, 0.5}, std::pair{1, 0.5}));
  std::vector<Fragment> nothing;
  EXPECT_EQ(resolve(nothing, [](const Fragment&, double) { FAIL(); }), 0);
}

TEST(ABuffer, StepsFollowTheGrammarAndStopWhenFull) {
  std::vector<Fragment> list{fragment(full, 3, 3), fragment(0x0000ffff, 2, 2), fragment(full, 4, 4),
                             fragment(0xffff0000, 1, 1)};
  Recorder<Sorted, Ordered, Merged, Masked, Weighed, Finished> seen;
  std::vector<int> taken, unobserved;
  std::vector<Fragment> again = list;
  resolve(list, [&](const Fragment& f, double) { taken.push_back(f.source); }, ByRange{}, seen);
  resolve(again, [&](const Fragment& f, double) { unobserved.push_back(f.source); });
  EXPECT_EQ(taken, unobserved);
  EXPECT_THAT(taken, testing::ElementsAre(1, 2));
  ASSERT_EQ(seen.events().size(), 3u + 2 * 2 + 1);
  const auto masked = all<Masked>(seen);
  EXPECT_EQ(masked[1].covered, 0xffff0000);
  EXPECT_EQ(masked[1].visible, 0x0000ffffu);
  double sum = 0;
  EXPECT_TRUE(every<Weighed>(seen, [&](const Weighed& s) {
    sum += s.weight;
    return s.weight == area_of(s.visible) && s.left == 1 - sum;
  }));
  const auto finished = all<Finished>(seen);
  EXPECT_EQ(finished[0].used, 2u);
  EXPECT_EQ(finished[0].listed, 4u);
  EXPECT_EQ(finished[0].left, 0);
}

/// The weights of the sources, sub-sample by sub-sample, as rationals.
std::vector<Exact> rational_weights(std::vector<Fragment> list) {
  std::ranges::sort(list, nearer);
  std::vector<Exact> weights(list.size(), Exact(0));
  for (int i = 0; i < samples; ++i) {
    Exact seen(1);
    for (const Fragment& f : list) {
      if ((f.mask & bit_of(i)) == 0) continue;
      weights[static_cast<std::size_t>(f.source)] += seen * Exact(f.opacity) / Exact(samples);
      seen *= Exact(1) - Exact(f.opacity);
    }
  }
  return weights;
}

TEST(ABuffer, OpacityIsThatOfEachSubSample) {
  const ExactScope scope;
  constexpr std::uint64_t seed = 104;
  RecordProperty("seed", static_cast<std::int64_t>(seed));
  Random random(seed);
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<Fragment> list;
    const int count = static_cast<int>(random.uniform_int(1, 8));
    for (int k = 0; k < count; ++k) {
      const auto mask = static_cast<Mask>(random() & random());
      const double z = random.unit();
      list.push_back(fragment(mask, z, k, random.unit() < 0.3 ? 1 : random.unit()));
    }
    const std::vector<Exact> right = rational_weights(list);
    std::vector<double> found(list.size());
    const double covered =
        resolve(list, [&](const Fragment& f, double w) { found[static_cast<std::size_t>(f.source)] = w; });
    double sum = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      worst = std::max(worst, std::abs(static_cast<double>(right[k] - Exact(found[k]))));
      sum += found[k];
    }
    worst = std::max(worst, std::abs(sum - covered));
  }
  EXPECT_LT(worst, 1e-13);
}

TEST(ABuffer, WhatAbutsOnOneSurfaceIsMerged) {
  const Fragment left{0xf0f0f0f0, 1, 2, 1, 7, 0}, right{0x0c0c0c0c, 1.5, 3, 1, 7, 1};
  std::vector<Fragment> list{left, right};
  merge(list);
  EXPECT_EQ(list, (std::vector<Fragment>{{0xfcfcfcfc, 1, 3, 1, 7, 0}}));
  // Not what lies apart, or overlaps, or is another surface's
  for (const Fragment& other : {Fragment{0x03030303, 1, 1, 1, 7, 1}, Fragment{0x18181818, 1, 1, 1, 7, 1},
                                Fragment{0x0c0c0c0c, 1, 1, 1, 8, 1}, Fragment{0x0c0c0c0c, 1, 1, 0.5, 7, 1}})
    EXPECT_FALSE(are_one(left, other));
  EXPECT_EQ(grown(0x00100000), 0x10381000u);
  EXPECT_EQ(grown(0x80000001), 0xc0800103u);
  std::vector<Fragment> nothing;
  merge(nothing);
  EXPECT_TRUE(nothing.empty());
}

TEST(ABuffer, RefusesOpacitiesThatAreNoShares) {
  for (const double opacity : {-0.1, 1.5, std::nan("")}) {
    std::vector<Fragment> list{fragment(full, 1, 0, opacity)};
    EXPECT_THROW(resolve(list, [](const Fragment&, double) {}), ContractViolation);
  }
}

// --- Pictures

/// A square as two triangles.
std::vector<ScreenTriangle> square(dvec2 lower, dvec2 upper, double depth) {
  const ivec2 a = snap(lower), b = snap({upper.x, lower.y}), c = snap(upper), d = snap({lower.x, upper.y});
  return {{{a, b, c}, dvec3{depth}}, {{a, c, d}, dvec3{depth}}};
}

TEST(ABufferPicture, ASquareHasItsAreaInEachPixel) {
  const auto triangles = square({0.5, 0.25}, {2, 2}, 0.5);
  std::vector<std::pair<double, double>> found;
  int asked = 0;
  const Window window{{0, 0}, {2, 1}};
  const auto white = [&](int, ivec2, const Weights&) { return ++asked, 1.0; };
  const auto keep = [&](ivec2, double sum, double covered) { found.push_back({sum, covered}); };
  const Memory memory = a_buffer(triangles, window, white, keep);
  EXPECT_THAT(found, testing::ElementsAre(std::pair{0.375, 0.375}, std::pair{0.75, 0.75}, std::pair{0.5, 0.5},
                                          std::pair{1.0, 1.0}));
  EXPECT_EQ(memory.pixels, 4);
  EXPECT_EQ(memory.mask_bytes, 4 * memory.fragments);
  EXPECT_GT(memory.bytes, memory.mask_bytes + 4 * 6);
  EXPECT_EQ(asked, memory.fragments);
  // As one surface, each pixel is asked for once
  asked = 0;
  found.clear();
  const Memory merged = a_buffer(triangles, window, white, keep, [](int) { return 0; });
  EXPECT_EQ(merged, memory);
  EXPECT_EQ(asked, 4);
  EXPECT_EQ(found.size(), 4u);
}

TEST(ABufferPicture, ColourIsAskedWhereTheTriangleIs) {
  // A sliver at the right border of the pixel: its centre is not covered
  const std::vector<ScreenTriangle> sliver{{{snap({0.9, 0}), snap({1, 0}), snap({1, 1})}, dvec3{0}}};
  const Edges edges = edges_of(sliver[0].corners);
  int asked = 0;
  a_buffer(
      sliver, {{0, 0}, {0, 0}},
      [&](int, ivec2, const Weights& w) {
        ++asked;
        EXPECT_TRUE(holds(edges, w));
        return 1.0;
      },
      [&](ivec2, double, double covered) { EXPECT_EQ(covered, 2 / 32.0); });
  EXPECT_EQ(asked, 1);
}

TEST(ABufferPicture, OrderOfTheTrianglesDoesNotMatter) {
  constexpr std::uint64_t seed = 77;
  RecordProperty("seed", static_cast<std::int64_t>(seed));
  Random random(seed);
  std::vector<ScreenTriangle> triangles;
  const auto corner = [&] {
    const double x = random.uniform(-1, 9);
    return snap({x, random.uniform(-1, 9)});
  };
  for (int i = 0; i < 30; ++i) {
    const ivec2 a = corner(), b = corner(), c = corner();
    triangles.push_back({{a, b, c}, {random.unit(), random.unit(), random.unit()}});
  }
  std::vector<int> numbers(30);
  for (int i = 0; i < 30; ++i) numbers[static_cast<std::size_t>(i)] = i;
  const auto draw = [&] {
    std::vector<ScreenTriangle> shuffled;
    for (const int i : numbers) shuffled.push_back(triangles[static_cast<std::size_t>(i)]);
    const auto name = [&](int t) { return numbers[static_cast<std::size_t>(t)]; };
    std::vector<double> values;
    a_buffer(
        shuffled, {{0, 0}, {7, 7}}, [&](int t, ivec2, const Weights&) { return name(t) / 32.0; },
        [&](ivec2, double sum, double covered) { values.insert(values.end(), {sum, covered}); }, name,
        [&](int t) { return name(t) % 3 == 0 ? 0.5 : 1; });
    return values;
  };
  const std::vector<double> first = draw();
  EXPECT_EQ(first.size(), 128u);
  for (int i = 0; i < 10; ++i) {
    random.shuffle(numbers);
    EXPECT_EQ(draw(), first);
  }
}

TEST(ABufferPicture, RefusesWhatLiesTooFarOut) {
  const std::vector<ScreenTriangle> far{{{ivec2{1 << 30, 0}, {0, 0}, {0, 256}}, dvec3{0}}};
  const auto white = [](int, ivec2, const Weights&) { return 1.0; };
  const auto drop = [](ivec2, double, double) {};
  EXPECT_THROW(a_buffer(far, {{0, 0}, {1, 1}}, white, drop), ContractViolation);
  EXPECT_EQ(a_buffer({}, {{0, 0}, {1, 1}}, white, drop).fragments, 0);
}

// --- The notes' forms

TEST(ABufferNotes, StepsTellWhatIsCounted) {
  std::vector<Fragment> list{fragment(full, 2, 1), fragment(0xf0f0f0f0, 1, 0)};
  Recorder<Sorted, Summed, Divided> areas;
  const auto nothing = [](const Fragment&, double) {};
  EXPECT_EQ(sum_of_areas(list, nothing, areas), 1);
  EXPECT_EQ(all<Summed>(areas)[1].total, 1.5);
  EXPECT_EQ(all<Divided>(areas)[0].total, 1.5);
  Recorder<Sorted, Masked, Summed, Divided> masks;
  EXPECT_EQ(divided_by_covered(list, nothing, masks), 1);
  EXPECT_EQ(all<Summed>(masks)[1].total, 1);
  EXPECT_EQ(all<Masked>(masks)[1].visible, 0x0f0f0f0fu);
  std::vector<Fragment> none;
  EXPECT_EQ(sum_of_areas(none, nothing), 0);
  EXPECT_EQ(divided_by_covered(none, nothing), 0);
}

}  // namespace
}  // namespace gradus::a_buffer
