// Known areas, the step grammar, bytes against rationals, what is seen in a pixel, refusals.

#include "antialiasing/area_sampling/area_sampling.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "support/screen_triangles.hpp"

namespace gradus::area_sampling {
namespace {

using triangle_coverage::snap;
using Corners = std::vector<ivec2>;
template <class T>
using Areas = std::map<std::pair<int, int>, T>;

constexpr Window sheet{{-2, -2}, {15, 15}};
const Corners notes{snap({1, 3}), snap({4, 1}), snap({2, 5})};

template <class T>
Areas<T> areas_of(const Corners& corners, const Window& window = sheet) {
  Areas<T> found;
  pixel_areas<T>(corners, window, [&](ivec2 p, T area) { found.emplace(std::pair(p.x, p.y), area); });
  return found;
}
Corners random_triangle(Random& random, int size) {
  Corners corners;
  for (int i = 0; i < 3; ++i) {
    const auto x = static_cast<int>(random.uniform_int(0, size)),
               y = static_cast<int>(random.uniform_int(0, size));
    corners.push_back({x, y});
  }
  return corners;
}
Exact exact_area(const Corners& corners) {
  const auto doubled = static_cast<std::int64_t>(doubled_area(corners));
  return Exact(doubled < 0 ? -doubled : doubled, 2 * 65536);
}

TEST(AreaSampling, NotesTriangleHasNineAreas) {
  // G001-99: (1,3), (4,1), (2,5)
  const ExactScope scope;
  const Areas<Exact> found = areas_of<Exact>(notes);
  const Areas<Exact> expected{{{2, 1}, Exact(1, 12)},  {{3, 1}, Exact(5, 12)}, {{1, 2}, Exact(1, 3)},
                              {{2, 2}, Exact(11, 12)}, {{3, 2}, Exact(1, 4)},  {{1, 3}, Exact(3, 4)},
                              {{2, 3}, Exact(3, 4)},   {{1, 4}, Exact(1, 4)},  {{2, 4}, Exact(1, 4)}};
  EXPECT_EQ(found.size(), 9u);
  EXPECT_EQ(found, expected);
  Exact sum = 0;
  for (const auto& [pixel, area] : found) sum += area;
  EXPECT_EQ(sum, Exact(4));
  for (const auto& [pixel, area] : areas_of<double>(notes))
    EXPECT_NEAR(area, to_double(expected.at(pixel)), 0x1p-50);
  EXPECT_EQ(areas_of<Exact>({notes[2], notes[1], notes[0]}), expected);
}

TEST(AreaSampling, AConcavePolygonHasAllItsParts) {
  const ExactScope scope;
  // A comb of two teeth, in one row of pixels each
  const Corners comb{{0, 0}, {1024, 0}, {1024, 256}, {0, 256}, {0, 192}, {896, 192}, {896, 64}, {0, 64}};
  const Areas<Exact> found = areas_of<Exact>(comb);
  EXPECT_EQ(found.at({0, 0}), Exact(1, 2));
  EXPECT_EQ(found.at({3, 0}), Exact(3, 4));
  Exact sum = 0;
  for (const auto& [pixel, area] : found) sum += area;
  EXPECT_EQ(sum, exact_area(comb));
}

TEST(AreaSampling, ThePixelsOfAConvexPolygonAreClippedOnce) {
  // R001-169: clips = polygons x pixels touched
  Random random(5);
  std::int64_t clips = 0, touched = 0;
  int polygons = 0;
  for (int i = 0; i < 200; ++i) {
    const Corners t = random_triangle(random, 3000);
    if (doubled_area(t) == 0) continue;
    ++polygons;
    Recorder<Started, BorderCut, AreaTaken<double>, Finished> seen;
    pixel_areas(t, sheet, [&](ivec2, double) { ++touched; }, seen);
    const auto done = all<Finished>(seen);
    ASSERT_EQ(done.size(), 1u);
    clips += done[0].clipped;
    EXPECT_EQ(done[0].clipped, static_cast<std::int64_t>(all<AreaTaken<double>>(seen).size()));
  }
  EXPECT_GE(polygons, 190);
  EXPECT_EQ(clips, touched);
  EXPECT_GT(touched, 3000);
}

TEST(AreaSampling, APolygonOutsideTheWindowIsClippedToNoPixel) {
  const Corners triangle{{2560, 2560}, {2816, 2560}, {2560, 2816}};  // in pixel (10, 10)
  const Window above{{8, 0}, {12, 3}}, below{{8, 20}, {12, 23}}, left{{0, 8}, {3, 12}},
      right{{20, 8}, {23, 12}};
  for (const Window& window : {above, below, left, right, Window{}}) {
    Recorder<Started, BorderCut, AreaTaken<double>, Finished> seen;
    pixel_areas(triangle, window, [](ivec2, double) { FAIL(); }, seen);
    const auto done = all<Finished>(seen);
    ASSERT_EQ(done.size(), 1u);
    EXPECT_EQ(done[0].clipped, 0);
  }
}

TEST(AreaSampling, StepsFollowTheGrammar) {
  Recorder<Started, BorderCut, AreaTaken<double>, Finished> seen;
  Areas<double> found;
  pixel_areas(notes, sheet, [&](ivec2 p, double a) { found[{p.x, p.y}] = a; }, seen);
  EXPECT_EQ(found, areas_of<double>(notes));  // observed == unobserved
  ASSERT_FALSE(seen.events().empty());
  EXPECT_EQ(std::get<Started>(seen.events().front().step).box, (Window{{1, 1}, {3, 4}}));
  EXPECT_EQ(std::get<Finished>(seen.events().back().step).covered, 9);
  // Two cuts per row, and two per pixel
  EXPECT_EQ(all<BorderCut>(seen).size(), 2u * 4 + 2 * 9);
  EXPECT_EQ(all<AreaTaken<double>>(seen).size(), 9u);
}

TEST(AreaSampling, WholeNumbersDecideTies) {
  // Every level of every piece: at least where the rational says so, and exactly at ties
  Random random(12);
  int asked = 0, ties = 0;
  for (int i = 0; i < 60; ++i) {
    const ExactScope scope;
    Corners t = random_triangle(random, 512);
    if (i % 2 == 0) {
      for (ivec2& p : t) p = p / 64 * 64;
    }
    const auto watch = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, AreaTaken<Exact>>) {
        for (int levels = 1; levels <= 12; ++levels) {
          for (int number = 1; number <= levels; ++number) {
            const Exact scaled = Exact(levels) * step.area + Exact(1, 2);
            EXPECT_EQ(rounds_to_at_least(step.piece, step.pixel, levels, number), scaled >= Exact(number));
            ++asked;
            ties += scaled == Exact(number);
          }
        }
      }
    };
    pixel_areas<Exact>(t, sheet, [](ivec2, Exact) {}, watch);
  }
  EXPECT_GT(asked, 3000);
  EXPECT_GT(ties, 10);
}

// --- What is seen

Fragment<Exact> square(double x, double y, double size, double depth, int key) {
  const Exact a = x, b = y, c = x + size, d = y + size;
  return {{{a, b}, {c, b}, {c, d}, {a, d}}, {depth, 0, 0}, key};
}
std::map<int, Exact> seen_of(std::vector<Fragment<Exact>> fragments) {
  std::map<int, Exact> seen;
  visible_areas(std::span(fragments),
                [&](const auto& f, const auto&, Exact area) { seen.emplace(f.key, area); });
  return seen;
}

TEST(AreaSampling, TheNearerOneIsSubtracted) {
  const ExactScope scope;
  const std::map<int, Exact> seen = seen_of({square(0, 0, 1, 2, 7), square(0.5, 0.25, 0.5, 1, 3)});
  EXPECT_EQ(seen, (std::map<int, Exact>{{3, Exact(1, 4)}, {7, Exact(3, 4)}}));
  // All of it, and nothing left of the other one
  EXPECT_EQ(seen_of({square(0, 0, 1, 1, 1), square(0.25, 0.25, 0.5, 2, 2)}),
            (std::map<int, Exact>{{1, Exact(1)}}));
  // As deep: the smaller key
  EXPECT_EQ(seen_of({square(0, 0, 1, 1, 2), square(0, 0, 1, 1, 1)}), (std::map<int, Exact>{{1, Exact(1)}}));
}

TEST(AreaSampling, PlanesThatCrossAreSplitThere) {
  const ExactScope scope;
  // Depths x and 1/4: left of x = 1/4 the first is nearer
  Fragment<Exact> slope = square(0, 0, 1, 0, 1);
  slope.depth = {Exact(0), Exact(1), Exact(0)};
  EXPECT_EQ(seen_of({slope, square(0, 0, 1, 0.25, 2)}),
            (std::map<int, Exact>{{1, Exact(1, 4)}, {2, Exact(3, 4)}}));
}

/// Convex outlines in the pixel with corners on a grid, each with a plane.
std::vector<Fragment<Exact>> random_fragments(Random& random, int count) {
  std::vector<Fragment<Exact>> fragments;
  while (std::ssize(fragments) < count) {
    ScreenTriangle t;
    for (ivec2& p : t.corners)
      p = {static_cast<int>(random.uniform_int(-64, 320)), static_cast<int>(random.uniform_int(-64, 320))};
    for (int k = 0; k < 3; ++k) t.depth[k] = static_cast<double>(random.uniform_int(0, 8)) / 8;
    if (auto f = fragment_in<Exact>(t, {0, 0}, static_cast<int>(fragments.size()))) fragments.push_back(*f);
  }
  return fragments;
}

/// Whether a place lies within a clockwise outline, not on its border.
bool holds(const Outline<Exact>& outline, const glm::vec<2, Exact>& p) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (doubled_area(outline[i], outline[(i + 1) % outline.size()], p) <= Exact(0)) return false;
  }
  return true;
}

TEST(AreaSampling, PiecesShareNothingAndShowTheNearest) {
  // Brute force: at every sample the piece that holds it is of the fragment that is nearest there
  Random random(21);
  int samples = 0, crossing = 0;
  for (int i = 0; i < 40; ++i) {
    const ExactScope scope;
    std::vector<Fragment<Exact>> fragments = random_fragments(random, 2 + i % 4);
    const std::vector<Fragment<Exact>> given = fragments;
    std::vector<std::pair<int, Outline<Exact>>> pieces;
    const auto keep = [&](const auto& f, const Pieces<Exact>& all, Exact area) {
      EXPECT_EQ(area, area_of(all));
      for (const auto& piece : all) pieces.push_back({f.key, piece});
    };
    const auto watch = [&]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Compared<Exact>>)
        crossing += !step.before.empty() && !step.behind.empty();
    };
    visible_areas(std::span(fragments), keep, watch);
    for (int k = 0; k < 81; ++k) {
      // Off the grid of the corners, so that few samples lie on a border
      const glm::vec<2, Exact> p{Exact(k % 9 * 113 + 7, 1021), Exact(k / 9 * 113 + 11, 1019)};
      const Fragment<Exact>* nearest = nullptr;
      for (const auto& f : given) {
        if (!holds(f.outline, p)) continue;
        if (!nearest || f.depth.at(p) < nearest->depth.at(p)) nearest = &f;
      }
      int found = -1, times = 0;
      for (const auto& [key, piece] : pieces) {
        if (holds(piece, p)) found = key, ++times;
      }
      EXPECT_LE(times, 1);
      if (times == 0 && nearest) continue;  // on a border between pieces: counted below
      EXPECT_EQ(found, nearest ? nearest->key : -1);
      ++samples;
    }
  }
  EXPECT_GT(samples, 40 * 81 - 40);
  EXPECT_GT(crossing, 50);
}

TEST(AreaSampling, VisibleAreasAddUpToTheUnion) {
  // The union, by adding outlines one after the other, each without those before it
  Random random(22);
  for (int i = 0; i < 40; ++i) {
    const ExactScope scope;
    std::vector<Fragment<Exact>> fragments = random_fragments(random, 1 + i % 6);
    Exact whole = 0;
    for (std::size_t a = 0; a < fragments.size(); ++a) {
      Pieces<Exact> own{fragments[a].outline};
      for (std::size_t b = 0; b < a; ++b) subtract(own, fragments[b].outline);
      whole += area_of(own);
    }
    Exact sum = 0;
    visible_areas(std::span(fragments), [&](const auto&, const auto&, Exact area) { sum += area; });
    EXPECT_EQ(sum, whole) << i;
  }
}

TEST(AreaSampling, ThreeThatHideOneAnotherInARing) {
  const ExactScope scope;
  // Each bar lies before the next where they meet, and behind the one before it
  std::vector<Fragment<Exact>> ring;
  const double w = 0.25;
  const auto bar = [&](dvec2 a, dvec2 b, dvec2 c, dvec2 d, Plane<Exact> depth) {
    const auto at = [](dvec2 p) { return glm::vec<2, Exact>(Exact(p.x), Exact(p.y)); };
    ring.push_back({{at(a), at(b), at(c), at(d)}, depth, static_cast<int>(ring.size())});
  };
  bar({0, 0}, {1, 0}, {1, w}, {0, w}, {0, 1, 0});               // top: near at the left
  bar({1 - w, 0}, {1, 0}, {1, 1}, {1 - w, 1}, {0.25, 0, 1});    // right: near at the top
  bar({0, 0}, {w, 0}, {1, 1}, {1 - w, 1}, {Exact(0.5), 0, 0});  // across
  const std::map<int, Exact> seen = seen_of(ring);
  Exact sum = 0;
  for (const auto& [key, area] : seen) sum += area;
  Pieces<Exact> second{ring[1].outline}, third{ring[2].outline};
  subtract(second, ring[0].outline);
  subtract(third, ring[0].outline);
  subtract(third, ring[1].outline);
  EXPECT_EQ(sum, area_of(ring[0].outline) + area_of(second) + area_of(third));
  EXPECT_EQ(seen.size(), 3u);
}

// --- The picture

ScreenTriangle triangle(dvec2 a, dvec2 b, dvec2 c, dvec3 depth) {
  return {{snap(a), snap(b), snap(c)}, depth};
}

TEST(AreaSampling, ThePictureIsTheSumOfAreaTimesColour) {
  const std::vector<ScreenTriangle> triangles{triangle({0, 0}, {8, 0}, {0, 8}, dvec3(1)),
                                              triangle({2.5, 1}, {6, 1}, {2.5, 6}, dvec3(0.5))};
  Areas<double> covered;
  std::map<std::pair<int, int>, double> sums;
  std::map<std::tuple<int, int, int>, int> asked;
  const auto colour = [&](int k, ivec2 pixel, const Weights& at) {
    ++asked[{k, pixel.x, pixel.y}];
    EXPECT_GE(std::min({at[0], at[1], at[2]}), 0);
    return k == 0 ? 0.25 : 1.0;
  };
  visible_areas(triangles, {{0, 0}, {9, 9}}, colour, [&](ivec2 p, double sum, double area) {
    covered[{p.x, p.y}] = area;
    sums[{p.x, p.y}] = sum;
  });
  // The nearer one lies all before the other, which shows the rest
  const Areas<double> behind = areas_of<double>({triangles[0].corners.begin(), triangles[0].corners.end()});
  const Areas<double> before = areas_of<double>({triangles[1].corners.begin(), triangles[1].corners.end()});
  double front = 0;
  for (const auto& [pixel, area] : before) front += area;
  EXPECT_GT(covered.size(), 30u);
  EXPECT_GT(front, 8);
  for (const auto& [pixel, area] : covered) {
    const double near = before.contains(pixel) ? before.at(pixel) : 0;
    EXPECT_NEAR(sums.at(pixel), 0.25 * (area - near) + near, 1e-12);
    EXPECT_LE(area, 1 + 1e-12);
  }
  for (const auto& [pixel, area] : behind) EXPECT_GE(covered.at(pixel), area - 1e-12);
  for (const auto& [what, times] : asked) EXPECT_EQ(times, 1);
}

TEST(AreaSampling, APictureOfRandomTrianglesEqualsRationals) {
  Random random(31);
  const auto triangles = test::triangles_anywhere(random, 30);
  Areas<double> found;
  const Window window{{0, 0}, {5, 5}};
  const auto value = [](int k, ivec2, const Weights&) { return 1.0 + k; };
  visible_areas(triangles, window, value, [&](ivec2 p, double sum, double) { found[{p.x, p.y}] = sum; });
  EXPECT_EQ(found.size(), 36u);
  double worst = 0;
  for (int i = 0; i < 36; ++i) {
    const ExactScope scope;
    const ivec2 pixel{i % 6, i / 6};
    std::vector<Fragment<Exact>> fragments;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (auto f = fragment_in<Exact>(triangles[k], pixel, static_cast<int>(k))) fragments.push_back(*f);
    }
    Exact sum = 0;
    visible_areas(std::span(fragments),
                  [&](const auto& f, const auto&, Exact area) { sum += Exact(1 + f.key) * area; });
    worst = std::max(worst, std::abs(found[{pixel.x, pixel.y}] - to_double(sum)));
  }
  EXPECT_LT(worst, 1e-12);
  RecordProperty("worst", std::to_string(worst));
}

TEST(AreaSampling, WhatLiesTooFarOutIsRefused) {
  const auto drop = [](ivec2, double) {};
  const int out = farthest * subpixels + 1;
  EXPECT_THROW(pixel_areas(Corners{{0, 0}, {out, 0}, {0, 1}}, sheet, drop), ContractViolation);
  EXPECT_THROW(pixel_areas(notes, {{0, 0}, {farthest, 0}}, drop), ContractViolation);
  const std::vector<ScreenTriangle> far{{{ivec2{0, 0}, ivec2{out, 0}, ivec2{0, 1}}, dvec3(0)}};
  const auto white = [](int, ivec2, const Weights&) { return 1.0; };
  EXPECT_THROW(visible_areas(far, sheet, white, [](ivec2, double, double) {}), ContractViolation);
  std::vector<Fragment<double>> bad{{{{0, 0}, {1, 1}}, {0, 0, 0}, 0}};
  EXPECT_THROW(visible_areas(std::span(bad), [](const auto&, const auto&, double) {}), ContractViolation);
}

}  // namespace
}  // namespace gradus::area_sampling
