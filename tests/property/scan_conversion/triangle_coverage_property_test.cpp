// Coverage against a brute-force test of every pixel in 128-bit integers, against winding numbers, and
// attributes against long double.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "support/coverage_oracle.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::triangle_coverage {
namespace {

constexpr int columns = 24, rows = 16;
constexpr Window sheet{{0, 0}, {columns - 1, rows - 1}};

using test::side;

/// A corner, of all the kinds that make trouble.
ivec2 any_corner(Random& random, std::int64_t kind) {
  const auto between = [&](int low, int high) { return static_cast<int>(random.uniform_int(low, high)); };
  switch (kind) {
    case 0:  // anywhere in and around the window
      return {between(-1000, columns * 256 + 1000), between(-1000, rows * 256 + 1000)};
    case 1:  // on centres and pixel corners: ties
      return {between(-2, 2 * columns + 2) * 128, between(-2, 2 * rows + 2) * 128};
    case 2:  // far off
      return {between(-farthest * 256, farthest * 256), between(-farthest * 256, farthest * 256)};
    default:  // at the ends of the range, on half pixels
      return {between(0, 1) ? farthest * 256 : -farthest * 256 + between(0, 8) * 128,
              between(0, rows * 2) * 128};
  }
}

Triangle any_triangle(Random& random) {
  const auto kind = [&] { return random.uniform_int(0, 3); };
  const std::int64_t one = kind();
  Triangle t{any_corner(random, one), any_corner(random, one), any_corner(random, one)};
  switch (random.uniform_int(0, 3)) {
    case 0:  // mixed
      t[2] = any_corner(random, kind());
      break;
    case 1: {  // a sliver: the third corner next to the line of the first two
      const double s = random.uniform(-0.5, 1.5);
      const dvec2 on = dvec2(t[0]) + s * (dvec2(t[1]) - dvec2(t[0]));
      const double limit = farthest * 256.0;
      t[2] = {static_cast<int>(std::clamp(on.x, -limit, limit)),
              static_cast<int>(std::clamp(on.y, -limit, limit))};
      break;
    }
    default:
      break;
  }
  return t;
}

TEST(TriangleCoverageProperty, EqualsBruteForceOverEveryPixel) {
  Random random(test::seed());
  const std::int64_t wanted = test::cases(100'000, 1'000'000);
  std::int64_t run = 0, hits = 0, ties = 0, slivers = 0, flat = 0, far = 0, different = 0;
  for (; run < wanted; ++run) {
    const Triangle t = any_triangle(random);
    std::array<std::int8_t, columns * rows> hit{};
    cover(t, sheet, [&](ivec2 p, const Weights& w) {
      ++hit[static_cast<std::size_t>(p.y * columns + p.x)];
      different += w[0] + w[1] + w[2] != std::abs(doubled_area(t)) || std::min({w[0], w[1], w[2]}) < 0;
    });
    const std::int64_t area = doubled_area(t);
    flat += area == 0;
    slivers += area != 0 && std::abs(area) < 65536;
    far += std::ranges::any_of(t, [](ivec2 p) { return std::abs(p.x) > 100'000 * 256; });
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const ivec2 centre{256 * x + 128, 256 * y + 128};
        const int a = side(t[0], t[1], centre, ties), b = side(t[1], t[2], centre, ties),
                  c = side(t[2], t[0], centre, ties);
        const bool inside = area != 0 && a == b && b == c;
        hits += inside;
        different += hit[static_cast<std::size_t>(y * columns + x)] != inside;
      }
    }
    ASSERT_EQ(different, 0) << "case " << run << ", seed " << test::seed() << ": (" << t[0].x << ',' << t[0].y
                            << ") (" << t[1].x << ',' << t[1].y << ") (" << t[2].x << ',' << t[2].y << ')';
  }
  std::printf("%lld triangles, %lld pixels, %lld ties, %lld slivers, %lld flat, %lld far\n",
              static_cast<long long>(run), static_cast<long long>(hits), static_cast<long long>(ties),
              static_cast<long long>(slivers), static_cast<long long>(flat), static_cast<long long>(far));
  EXPECT_EQ(run, wanted);
  EXPECT_GT(hits, run * 10);
  EXPECT_GT(ties, run);
  EXPECT_GT(slivers, run / 100);
  EXPECT_GT(far, run / 4);
}

/// How often the closed polygon winds round the centre, moved as above; the crossings of a ray to the left.
int winding(const std::vector<ivec2>& polygon, ivec2 centre) {
  int number = 0;
  std::int64_t ties = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ivec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const bool a_below = a.y > centre.y, b_below = b.y > centre.y;  // at the same height: the centre is lower
    if (a_below == b_below) continue;
    const int s = side(a, b, centre, ties);
    if (b_below && s < 0) --number;  // the edge goes down, to the left of the centre
    if (a_below && s > 0) ++number;
  }
  return number;
}

TEST(TriangleCoverageProperty, NoGapAndNoDoubleHitAtSharedEdges) {
  // Triangles from a centre to the edges of a closed polygon share an edge each with the next. Counted with
  // their orientation they cover every pixel as often as the polygon winds round it, whatever the polygon.
  Random random(test::seed() + 1);
  const std::int64_t wanted = test::cases(100'000, 1'000'000);
  std::int64_t edges = 0, hits = 0, once = 0;
  while (edges < wanted) {
    const std::int64_t kind = random.uniform_int(0, 2);
    const ivec2 hub = any_corner(random, std::min<std::int64_t>(kind, 1));
    std::vector<ivec2> rim;
    const std::int64_t n = random.uniform_int(3, 9);
    const bool star = random.uniform_int(0, 1) == 1;
    for (std::int64_t i = 0; i < n; ++i) rim.push_back(any_corner(random, kind));
    if (star) {  // round the hub in order: nothing overlaps, as in a mesh
      std::ranges::sort(rim, {},
                        [&](ivec2 p) { return std::atan2(p.y - double(hub.y), p.x - double(hub.x)); });
    }
    std::array<int, columns * rows> sum{}, count{};
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Triangle t{hub, rim[i], rim[(i + 1) % rim.size()]};
      const int way = doubled_area(t) > 0 ? 1 : -1;
      cover(t, sheet, [&](ivec2 p, const Weights&) {
        sum[static_cast<std::size_t>(p.y * columns + p.x)] += way;
        ++count[static_cast<std::size_t>(p.y * columns + p.x)];
        ++hits;
      });
    }
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const auto i = static_cast<std::size_t>(y * columns + x);
        const int expected = winding(rim, {256 * x + 128, 256 * y + 128});
        ASSERT_EQ(sum[i], expected) << "after " << edges << " edges, seed " << test::seed() << ", pixel " << x
                                    << ' ' << y;
        once += count[i] == 1 && expected != 0;
      }
    }
    edges += n;
  }
  std::printf("%lld shared edges, %lld hits, %lld pixels hit once\n", static_cast<long long>(edges),
              static_cast<long long>(hits), static_cast<long long>(once));
  EXPECT_GE(edges, wanted);
  EXPECT_GT(once, wanted);
}

TEST(TriangleCoverageProperty, AttributesArePerspectiveCorrect) {
  Random random(test::seed() + 2);
  const std::int64_t wanted = test::cases(20'000, 200'000);
  std::int64_t pixels = 0;
  long double worst = 0, worst_depth = 0;
  for (std::int64_t run = 0; run < wanted; ++run) {
    const Triangle t = any_triangle(random);
    const dvec3 w{random.uniform(0.1, 4), random.uniform(0.1, 4), random.uniform(0.1, 4)};
    const dvec3 a{random.unit(), random.unit(), random.unit()},
        z{random.unit(), random.unit(), random.unit()};
    const Linear depth(t, z);
    cover(t, sheet, [&](ivec2 p, const Weights& weights) {
      // From the snapped corners alone
      const auto area = [](dvec2 u, dvec2 v, dvec2 q) {
        return (static_cast<long double>(v.x) - u.x) * (static_cast<long double>(q.y) - u.y) -
               (static_cast<long double>(v.y) - u.y) * (static_cast<long double>(q.x) - u.x);
      };
      const dvec2 c(256 * p.x + 128, 256 * p.y + 128), p0(t[0]), p1(t[1]), p2(t[2]);
      const long double all = area(p0, p1, p2);
      const long double l0 = area(p1, p2, c) / all, l1 = area(p2, p0, c) / all, l2 = area(p0, p1, c) / all;
      const long double over = l0 / w.x + l1 / w.y + l2 / w.z;
      const long double exact = (l0 / w.x * a.x + l1 / w.y * a.y + l2 / w.z * a.z) / over;
      const dvec3 shares = perspective_correct(weights, 1.0 / w);
      worst = std::max(worst, std::abs(glm::dot(shares, a) - exact));
      worst_depth = std::max(worst_depth, std::abs(depth.at(weights) - (l0 * z.x + l1 * z.y + l2 * z.z)));
      ++pixels;
    });
  }
  std::printf("%lld pixels, attributes within %.3Lg, depths within %.3Lg\n", static_cast<long long>(pixels),
              worst, worst_depth);
  EXPECT_GT(pixels, wanted * 10);
  EXPECT_LT(worst, 0.005L / 255);  // what is asked for
  EXPECT_LT(worst, 1e-15L);        // what it does
  EXPECT_LT(worst_depth, 1e-15L);
}

}  // namespace
}  // namespace gradus::triangle_coverage
