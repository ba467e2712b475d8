// The scenes of supersampling's pictures, sampled as their figures show them.

#include "stories/antialiasing/supersampling/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "antialiasing/supersampling/supersampling.hpp"

namespace gradus::supersampling {
namespace {

// A thin triangle: with one sample per pixel most of it is lost or torn, with more its area comes closer.
TEST(SupersamplingStory, AThinTrianglesAreaIsFound) {
  const Polygon sliver{{0.3, 0.4}, {15.6, 5.2}, {15.7, 5.6}};
  const double area = area_of(sliver);
  double before = 1;
  for (const int n : {1, 4, 16, 64}) {
    double sum = 0;
    const auto in = [&](dvec2 p) { return holds(sliver, p) ? 1.0 : 0.0; };
    supersample({{-1, -1}, {16, 6}}, n, Filter::box, in, [&](ivec2, double share) { sum += share; });
    const double off = std::abs(sum - area) / area;
    EXPECT_LT(off, before) << n;
    before = std::max(off, 0.01);
  }
  EXPECT_LE(before, 0.01);
}

// R001-161: what a pixel shows of a ray-traced scene is the mean of its four sub-rays.
TEST(SupersamplingStory, FourSubRaysAverageToThePixel) {
  int mixed = 0;
  const Window window{{0, 0}, {23, 17}};
  supersample(window, 2, Filter::box, SphereScene{{24, 18}}, [&](ivec2 p, const dvec3& shown) {
    const dvec2 at(p);
    const SphereScene scene{{24, 18}};
    const dvec3 a = scene(at + dvec2{0.25, 0.25}), b = scene(at + dvec2{0.75, 0.25}),
                c = scene(at + dvec2{0.25, 0.75}), d = scene(at + dvec2{0.75, 0.75});
    EXPECT_EQ(shown, (a + b + c + d) / 4.0);
    if (a != b || a != c || a != d) ++mixed;
  });
  EXPECT_GT(mixed, 50);
}

}  // namespace
}  // namespace gradus::supersampling
