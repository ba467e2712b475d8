// The numbers that the pages of antialiasing claim, measured again.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"
#include "antialiasing/adaptive/adaptive.hpp"
#include "antialiasing/area_sampling/area_sampling.hpp"
#include "antialiasing/area_sampling/visible_picture.hpp"
#include "antialiasing/jittered/jittered.hpp"
#include "antialiasing/poisson_disc/poisson_disc.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/raster.hpp"
#include "support/documented.hpp"
#include "support/example_traces.hpp"
#include "support/random_edges.hpp"
#include "support/screen_triangles.hpp"

namespace gradus {
namespace {

using test::states;
using triangle_coverage::ScreenTriangle;
using triangle_coverage::snap;

constexpr std::uint64_t seed = 20240611;

/// The root of the mean square of (share of the samples on one side of an edge - area there).
template <class Samples>
double error_on_edges(Samples samples, int edges) {
  Random random(seed);
  double squares = 0;
  for (int e = 0; e < edges; ++e) {
    const test::StraightEdge edge = test::random_edge(random);
    const std::vector<dvec2> places = samples(random.split(static_cast<std::uint64_t>(e)));
    const auto inside = std::ranges::count_if(places, [&](dvec2 p) { return edge.holds(p); });
    const double off = static_cast<double>(inside) / static_cast<double>(places.size()) - edge.area();
    squares += off * off;
  }
  return std::sqrt(squares / edges);
}

TEST(DocumentedAntialiasing, PassesOfARegularGrid) {
  constexpr const char* page = "docs/topics/antialiasing/accumulation_buffer.md";
  const auto error = [](int n) {
    std::vector<dvec2> grid;
    for (int i = 0; i < n * n; ++i) grid.push_back({(i % n + 0.5) / n, (i / n + 0.5) / n});
    return error_on_edges([&](const Random&) { return grid; }, 100'000);
  };
  EXPECT_TRUE(states(page, "have the RMS errors {}, {}, {}, {} and {}:",
                     {error(1), error(2), error(4), error(8), error(16)}));
  const double passes = 0x1p20;
  EXPECT_TRUE(states(page, "For 2^20 passes that is {} · 10^-10.", {(passes + 1) * 0x1p-53 * 1e10}));
}

TEST(DocumentedAntialiasing, IndependentSamples) {
  const auto error = [](int count) {
    return error_on_edges(
        [&](Random random) {
          std::vector<dvec2> places;
          for (int i = 0; i < count; ++i) places.push_back({random.unit(), random.unit()});
          return places;
        },
        10'000);
  };
  const double of_16 = error(16);
  EXPECT_TRUE(states("docs/topics/antialiasing/jittered.md", "independent {}, {}, {}.",
                     {of_16, error(64), error(256)}));
  const double candidates = error_on_edges(
      [](const Random& random) {
        std::vector<dvec2> places(16);
        poisson_disc::best_candidate(places, 4, random);
        return places;
      },
      10'000);
  constexpr const char* page = "docs/topics/antialiasing/poisson_disc.md";
  EXPECT_TRUE(states(page, "its 16 samples are off by {} (RMS), as many independent ones by {},",
                     {candidates, of_16}));
}

TEST(DocumentedAntialiasing, SamplesThatBridsonFinds) {
  const double radius = 0.01;
  int samples = 0;
  poisson_disc::bridson({dvec2(1)}, radius, 30, Random(seed), [&](dvec2) { ++samples; });
  // On a large area, so that its sides don't count
  EXPECT_TRUE(states("docs/topics/antialiasing/poisson_disc.md",
                     "Of about {} / r² samples per unit of area with 30 tries.",
                     {samples * radius * radius}));
}

TEST(DocumentedAntialiasing, ANeedle) {
  const ScreenTriangle needle{{snap({1.4, 0.6}), snap({1.7, 0.6}), snap({7.3, 15.5})}, {}};
  const dvec2 a(needle.corners[0]), b(needle.corners[1]), c(needle.corners[2]);
  const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2 / 65536;
  const auto found = [&](int count) {
    double sum = 0;
    adaptive::adaptive(
        std::vector{needle}, {{0, 0}, {15, 15}}, adaptive::n_rooks(count),
        [](int, ivec2, const auto&) { return dvec3(1); }, [&](ivec2, dvec3, double share) { sum += share; });
    return sum;
  };
  EXPECT_TRUE(
      states("docs/topics/antialiasing/adaptive.md",
             "the needle above, of area {}, is found as {}, {}, {} and {} with 1, 4, 16 and 64 samples.",
             {area, found(1), found(4), found(16), found(64)}));
}

constexpr int width = test::pierced_width;
/// A colour that changes across each triangle.
dvec3 colour_at(int triangle, double first, double last) {
  return 0.2 + 0.6 * dvec3(first, 0.15 * (triangle % 6), last);
}

/// The mean of the colours at 16 x 16 places of each pixel, by plain geometry.
std::vector<dvec3> looked_at_closely(const std::vector<ScreenTriangle>& triangles) {
  std::vector<dvec3> picture(width * width, dvec3(0));
  struct Nearest {
    double depth = 2;
    dvec3 colour{0};
  };
  std::vector<Nearest> fine(std::size_t{16 * width} * 16 * width);
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    std::array<dvec2, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = dvec2(triangles[n].corners[k]) / 256.0;
    const auto cross = [](dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; };
    const double doubled = cross(p[1] - p[0], p[2] - p[0]);
    const auto range = [&](int axis) {
      const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return std::pair(std::max(0, static_cast<int>(16 * low)),
                       std::min(16 * width - 1, static_cast<int>(16 * high) + 1));
    };
    const auto [left, right] = range(0);
    const auto [top, bottom] = range(1);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const dvec2 at{(x + 0.5) / 16, (y + 0.5) / 16};
        const double w[] = {cross(p[1] - at, p[2] - at) / doubled, cross(p[2] - at, p[0] - at) / doubled,
                            cross(p[0] - at, p[1] - at) / doubled};
        if (std::min({w[0], w[1], w[2]}) < 0) continue;
        const dvec3 z = triangles[n].depth;
        Nearest& best = fine[static_cast<std::size_t>(y * 16 * width + x)];
        const double depth = w[0] * z.x + w[1] * z.y + w[2] * z.z;
        if (depth < best.depth) best = {depth, colour_at(static_cast<int>(n), w[0], w[2])};
      }
    }
  }
  for (int y = 0; y < 16 * width; ++y) {
    for (int x = 0; x < 16 * width; ++x) {
      picture[static_cast<std::size_t>(y / 16 * width + x / 16)] +=
          fine[static_cast<std::size_t>(y * 16 * width + x)].colour / 256.0;
    }
  }
  return picture;
}

TEST(DocumentedAntialiasing, PicturesOfRandomTriangles) {
  const std::vector<ScreenTriangle> triangles = test::pierced_triangles();
  const std::vector<dvec3> right = looked_at_closely(triangles);
  const auto error = [&](int count) {
    std::vector<dvec3> picture(right.size(), dvec3(0));
    const auto colour = [](int n, ivec2, const auto& weights) {
      const dvec3 shares = triangle_coverage::barycentric(weights);
      return colour_at(n, shares.x, shares.z);
    };
    adaptive::adaptive(
        triangles, {{0, 0}, {width - 1, width - 1}}, adaptive::n_rooks(count), colour,
        [&](ivec2 p, dvec3 sum, double) { picture[static_cast<std::size_t>(p.y * width + p.x)] = sum; });
    double squares = 0;
    for (std::size_t i = 0; i < right.size(); ++i)
      squares += glm::dot(picture[i] - right[i], picture[i] - right[i]) / 3;
    return std::sqrt(squares / static_cast<double>(right.size()));
  };
  EXPECT_TRUE(
      states("docs/topics/antialiasing/adaptive.md",
             "are off by {} without antialiasing, and by {}, {}, {} and {} with 4, 8, 16 and 64 samples",
             {error(1), error(4), error(8), error(16), error(64)}));
}

TEST(DocumentedAntialiasing, AreasOfTriangles) {
  constexpr const char* page = "docs/topics/antialiasing/area_sampling.md";
  Random random(seed);
  double worst = 0;
  for (int n = 0; n < 1000; ++n) {
    const ExactScope scope;
    std::array<ivec2, 3> corners;
    for (ivec2& p : corners)
      p = {static_cast<int>(random.uniform_int(-300, 900)), static_cast<int>(random.uniform_int(-300, 900))};
    std::vector<double> rounded;
    const Window window{{0, 0}, {2, 2}};
    area_sampling::pixel_areas(corners, window, [&](ivec2, double area) { rounded.push_back(area); });
    std::size_t k = 0;
    area_sampling::pixel_areas<Exact>(corners, window, [&](ivec2, const Exact& area) {
      ASSERT_LT(k, rounded.size());
      worst = std::max(worst, std::abs(to_double(area - Exact(rounded[k++]))));
    });
  }
  EXPECT_LE(worst, 0x1p-50);
  EXPECT_TRUE(states(page, "Areas are within 2^-50 (found: {}) of the rational ones;", {worst}));
}

TEST(DocumentedAntialiasing, AreasOfWhatIsSeen) {
  using namespace area_sampling;
  Random random(seed);
  const auto triangles = test::triangles_anywhere(random, 20);
  double worst = 0;
  for (int i = 0; i < 36; ++i) {
    const ivec2 pixel{i % 6, i / 6};
    const ExactScope scope;
    std::vector<Fragment<Exact>> exact;
    std::vector<Fragment<double>> rounded;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (auto f = fragment_in<Exact>(triangles[k], pixel, static_cast<int>(k))) exact.push_back(*f);
      if (auto f = fragment_in<double>(triangles[k], pixel, static_cast<int>(k))) rounded.push_back(*f);
    }
    std::vector<Exact> right(triangles.size(), Exact(0));
    visible_areas(std::span(exact), [&](const auto& f, const auto&, Exact area) {
      right[static_cast<std::size_t>(f.key)] += area;
    });
    std::vector<double> found(triangles.size(), 0);
    visible_areas(std::span(rounded), [&](const auto& f, const auto&, double area) {
      found[static_cast<std::size_t>(f.key)] += area;
    });
    for (std::size_t k = 0; k < found.size(); ++k)
      worst = std::max(worst, std::abs(to_double(right[k] - Exact(found[k]))));
  }
  EXPECT_LE(worst, 1e-12);
  EXPECT_TRUE(states("docs/topics/antialiasing/area_sampling.md",
                     "in double the promise is 1e-12 (found: {}),", {worst}));
}

TEST(DocumentedAntialiasing, AreasWithoutVisibilityAndTones) {
  constexpr const char* page = "docs/topics/antialiasing/area_sampling.md";
  const Trace trace = test::trace_of("area_sampling", {{"method", "areas_without_visibility"}});
  const auto covered = std::ranges::find(trace.result, "covered", &Field::name);
  ASSERT_NE(covered, trace.result.end());
  EXPECT_TRUE(states(page, "the three triangles above have areas of {} in one pixel",
                     {std::get<double>(covered->value)}));
  // sRGB's definition
  EXPECT_TRUE(
      states(page, "255 times 1/2 is 128, a tone that shows {} of the light; half is {}.",
             {std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 255 * (1.055 * std::pow(0.5, 1 / 2.4) - 0.055)}));
}

TEST(DocumentedAntialiasing, OnesInAFloat) {
  float sum = 0;
  for (int i = 0; i < 20'000'000; ++i) sum += 1;
  EXPECT_TRUE(states("docs/topics/antialiasing/accumulation_buffer.md", "a sum of ones stays at 2^24 = {},",
                     {double(sum)}));
}

}  // namespace
}  // namespace gradus
