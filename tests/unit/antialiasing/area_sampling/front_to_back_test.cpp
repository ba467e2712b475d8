// What is seen of many polygons in a pixel, front to back: against the taught method and against samples, in
// rationals; and how much work it is.

#include "antialiasing/area_sampling/front_to_back.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/area_sampling/visible_picture.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::area_sampling {
namespace {

/// Triangles that reach into the pixel (0, 0), at depths from 0 to 1: each over `thick` of them. Thin ones
/// are a tenth of a pixel wide.
template <class T>
std::vector<Fragment<T>> random_fragments(Random& random, int count, int thick, bool thin) {
  std::vector<Fragment<T>> fragments;
  while (std::ssize(fragments) < count) {
    const auto place = [&](int from, int to) {
      return ivec2{static_cast<int>(random.uniform_int(from, to)),
                   static_cast<int>(random.uniform_int(from, to))};
    };
    ScreenTriangle t{{place(-64, 320), place(-64, 320), place(-64, 320)}, {}};
    if (thin) t.corners[2] = t.corners[1] + place(-26, 26);
    const auto least = random.uniform_int(0, 64 - thick);
    for (int k = 0; k < 3; ++k) t.depth[k] = static_cast<double>(least + random.uniform_int(0, thick)) / 64;
    if (auto f = fragment_in<T>(t, {0, 0}, static_cast<int>(fragments.size()))) fragments.push_back(*f);
  }
  return fragments;
}

/// What is seen: whose, and how much of it, in the order in which it is told.
template <class T>
using Told = std::vector<std::pair<int, T>>;
template <class T>
Told<T> told_front_to_back(std::vector<Fragment<T>> fragments) {
  Told<T> told;
  areas_front_to_back(std::span(fragments),
                      [&](const auto& f, const auto&, T area) { told.push_back({f.key, area}); });
  return told;
}
template <class T>
Told<T> told_by_pairs(std::vector<Fragment<T>> fragments) {
  Told<T> told;
  visible_areas(std::span(fragments),
                [&](const auto& f, const auto&, T area) { told.push_back({f.key, area}); });
  return told;
}

TEST(AreasFrontToBack, AreThoseOfEachPairInRationals) {
  std::size_t hidden = 0, seen = 0;
  for (std::uint64_t round = 0; round < 40; ++round) {
    const ExactScope scope;
    Random random(test::seed(), round);
    const int count = static_cast<int>(random.uniform_int(1, 12));
    const int thick = round % 3 == 0 ? 0 : round % 3 == 1 ? 8 : 64;
    auto fragments = random_fragments<Exact>(random, count, thick, round % 2 == 1);
    // Some before, some behind, some through it
    const Exact none(0), one(1), middle(1, 2);
    if (round % 4 == 0)
      fragments.push_back(
          {{{none, none}, {one, none}, {one, one}, {none, one}}, {middle, none, none}, count});
    const auto told = told_front_to_back(fragments);
    ASSERT_EQ(told, told_by_pairs(fragments)) << "seed " << test::seed() << ", round " << round;
    seen += told.size();
    hidden += fragments.size() - told.size();
  }
  EXPECT_GT(seen, 100u);
  EXPECT_GT(hidden, 10u);
}

/// Whether a place lies within a clockwise outline, not on its border.
bool holds(const Outline<Exact>& outline, const glm::vec<2, Exact>& p) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((b.x - a.x) * (p.y - a.y) <= (b.y - a.y) * (p.x - a.x)) return false;
  }
  return true;
}

TEST(AreasFrontToBack, ShowTheNearestAtEachSample) {
  int samples = 0;
  for (std::uint64_t round = 0; round < 12; ++round) {
    const ExactScope scope;
    Random random(test::seed(), round);
    const auto given = random_fragments<Exact>(random, 8, round % 2 == 0 ? 8 : 48, false);
    auto fragments = given;
    std::vector<std::pair<int, Outline<Exact>>> pieces;
    areas_front_to_back(std::span(fragments), [&](const auto& f, const Pieces<Exact>& all, Exact) {
      for (const auto& piece : all) pieces.push_back({f.key, piece});
    });
    for (int k = 0; k < 49; ++k) {
      // Off the grid of the corners, so that few lie on a border
      const glm::vec<2, Exact> p{Exact(k % 7 * 143 + 7, 1021), Exact(k / 7 * 143 + 11, 1019)};
      const Fragment<Exact>* nearest = nullptr;
      for (const auto& f : given)
        if (holds(f.outline, p) && (!nearest || f.depth.at(p) < nearest->depth.at(p))) nearest = &f;
      const auto holds_it = [&](const auto& piece) { return holds(piece.second, p); };
      const auto times = std::ranges::count_if(pieces, holds_it);
      if (times == 0 && nearest) continue;  // on a border between pieces: counted below
      ASSERT_EQ(times, nearest ? 1 : 0);
      if (nearest) {
        ASSERT_EQ(std::ranges::find_if(pieces, holds_it)->first, nearest->key);
      }
      ++samples;
    }
  }
  EXPECT_GT(samples, 12 * 49 - 12);
}

TEST(AreasFrontToBack, AreThoseOfEachPairInDouble) {
  double worst = 0;
  for (std::uint64_t round = 0; round < (test::sanitized ? 8 : 40); ++round) {
    Random random(test::seed(), round);
    const auto fragments = random_fragments<double>(random, 60, round % 4 < 2 ? 1 : 16, round % 2 == 1);
    std::map<int, double> off;
    for (const auto& [key, area] : told_front_to_back(fragments)) off[key] += area;
    for (const auto& [key, area] : told_by_pairs(fragments)) off[key] -= area;
    for (const auto& [key, difference] : off) worst = std::max(worst, std::abs(difference));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-12) << "seed " << test::seed();
}

/// Counts the pieces that are cut.
struct Counting {
  std::size_t& all;
  void operator()(const auto&, const auto&, double) {}
  void cuts(std::size_t pieces) { all += pieces; }
};
std::size_t cuts_of(std::vector<Fragment<double>> fragments) {
  std::size_t all = 0;
  areas_front_to_back(std::span(fragments), Counting{all});
  return all;
}

TEST(AreasFrontToBack, WhatIsHiddenTakesNoCuts) {
  // A wall of two parts, and behind it more and more that cross one another
  const auto cuts_with = [](int count) {
    Random random(test::seed());
    auto fragments = random_fragments<double>(random, count, 60, true);
    fragments.push_back({{{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}, {-2, 0, 0}, count});
    fragments.push_back({{{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}}, {-1, 0, 0}, count + 1});
    return cuts_of(std::move(fragments));
  };
  EXPECT_EQ(cuts_with(2000), cuts_with(20)) << "seed " << test::seed();
}

TEST(AreasFrontToBack, OfLayersEachIsCutOnce) {
  // No two overlap in depth, and none hides another: by pairs these are the square of the layers
  constexpr int count = 300;
  std::vector<Fragment<double>> stripes;
  for (int i = 0; i < count; ++i) {
    const double left = i / double{count}, right = (i + 1) / double{count};
    stripes.push_back({{{left, 0}, {right, 0}, {right, 1}, {left, 1}}, {double(i % 17), 0, 0}, i});
  }
  double sum = 0;
  for (const auto& [key, area] : told_front_to_back(stripes)) sum += area;
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_LT(cuts_of(stripes), 60u * count);
}

}  // namespace
}  // namespace gradus::area_sampling
