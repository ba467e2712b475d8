// Cutting in doubles against cutting in rationals, and what must hold of every part.

#include <gtest/gtest.h>

#include <cmath>

#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "core/exact_scalar.hpp"
#include "core/random.hpp"
#include "support/seed.hpp"

namespace gradus::sutherland_hodgman {
namespace {

TEST(SutherlandHodgmanProperty, DoublesAgreeWithRationals) {
  Random random(test::seed());
  int cases = 0, compared = 0, cut = 0, gone = 0;
  double worst = 0;
  for (; cases < 4000; ++cases) {
    const ExactScope scope;
    const double guard = random.uniform_int(0, 1) ? 1 : 2000;
    const auto planes = view_volume(guard, guard);
    std::vector<Plane<Exact>> exact_planes;
    for (const auto& p : planes) exact_planes.push_back({p.axis, Exact(p.sign), Exact(p.bound)});
    std::vector<Point<double>> polygon;
    std::vector<Point<Exact>> exact;
    for (int i = 0; i < 3; ++i) {
      const double depth = random.uniform(-2, 4), spread = random.uniform_int(0, 3) ? 4 : 9000;
      const glm::dvec4 p{random.uniform(-spread, spread), random.uniform(-spread, spread), 1.1 * depth - 0.5,
                         depth};
      polygon.push_back({p});
      exact.push_back({{Exact(p.x), Exact(p.y), Exact(p.z), Exact(p.w)}});
    }
    const auto part = clip(polygon, std::span<const Plane<double>>(planes));
    exact = clip(exact, std::span<const Plane<Exact>>(exact_planes));
    for (const auto& p : part) {
      for (const auto& plane : planes) ASSERT_GE(distance(plane, p.at), -1e-11 * (1 + guard));
      ASSERT_GT(p.at.w, 0);
    }
    cut += part.size() > 3;
    gone += part.empty();
    // Rounding may lose or add a corner where one nearly touches a plane
    if (part.size() != exact.size()) continue;
    ++compared;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (int axis = 0; axis < 4; ++axis) {
        worst = std::max(worst, std::abs(part[i].at[axis] - to_double(exact[i].at[axis])) / 9000);
      }
    }
  }
  std::printf("%d cases, %d with new corners, %d gone, worst %.3g of the extent\n", cases, cut, gone, worst);
  EXPECT_EQ(cases, 4000);
  EXPECT_GT(compared, 3990);
  EXPECT_GT(cut, 500);
  EXPECT_GT(gone, 100);
  EXPECT_LT(worst, 1e-14);
}

}  // namespace
}  // namespace gradus::sutherland_hodgman
