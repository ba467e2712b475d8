// In homogeneous coordinates: known polygons, the step grammar, what neighbours share.

#include <gtest/gtest.h>

#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "core/record.hpp"

namespace gradus::sutherland_hodgman {
namespace {

using P = Point<double>;
using Polygon = std::vector<P>;
using Planes = std::span<const Plane<double>>;

/// The window [0, 10]^2 of the plane w = 1, as planes: x >= 0 and x <= 10 w.
const std::vector<Plane<double>> window{{0, 1, 0}, {0, -1, 10}, {1, 1, 0}, {1, -1, 10}};

Polygon flat(std::initializer_list<std::pair<double, double>> corners) {
  Polygon polygon;
  for (const auto& [x, y] : corners) polygon.push_back({{x, y, 0, 1}});
  return polygon;
}

/// Of the points x/w, y/w.
double area(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto a = polygon[i].at, b = polygon[(i + 1) % polygon.size()].at;
    doubled += (a.x * b.y - a.y * b.x) / (a.w * b.w);
  }
  return doubled / 2;
}

TEST(SutherlandHodgman, GoldenAreas) {
  // G001-54: a triangle that contains the window gives the window
  EXPECT_DOUBLE_EQ(area(clip(flat({{-10, -10}, {30, -10}, {10, 40}}), Planes(window))), 100);
  // G001-55
  const Polygon cut = clip(flat({{-5, 2}, {5, 2}, {5, 8}}), Planes(window));
  EXPECT_DOUBLE_EQ(area(cut), 22.5);
  ASSERT_EQ(cut.size(), 4u);
  // A diamond that touches the window's corners from outside it: no corner comes twice
  const Polygon diamond = clip(flat({{5, -5}, {15, 5}, {5, 15}, {-5, 5}}), Planes(window));
  EXPECT_EQ(diamond.size(), 4u);
  EXPECT_DOUBLE_EQ(area(diamond), 100);
}

TEST(SutherlandHodgman, InsideStaysAndOutsideGoes) {
  const Polygon inside = flat({{1, 1}, {9, 1}, {5, 9}});
  const Polygon kept = clip(inside, Planes(window));
  ASSERT_EQ(kept.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(kept[i].at, inside[i].at);
  EXPECT_TRUE(clip(flat({{11, 1}, {19, 1}, {15, 9}}), Planes(window)).empty());
  EXPECT_TRUE(clip(Polygon{}, Planes(window)).empty());
  // On the border is inside
  EXPECT_EQ(clip(flat({{0, 0}, {10, 0}, {10, 10}}), Planes(window)).size(), 3u);
}

TEST(SutherlandHodgman, CutsBehindTheEyeBeforeTheDivision) {
  // One corner behind the eye leaves two before it; two leave one
  const auto near = view_volume(1.0, 1.0)[5];
  const auto kept = [&](double za, double zb, double zc) {
    const auto at = [](double x, double z) { return P{{x, x, z - 1, z}}; };  // near plane at depth 1
    const Polygon polygon{at(0, za), at(1, zb), at(2, zc)};
    return clip(std::span<const P>(polygon), near);
  };
  EXPECT_EQ(kept(5, 5, -3).size(), 4u);
  EXPECT_EQ(kept(5, -3, -3).size(), 3u);
  EXPECT_EQ(kept(-3, -3, -3).size(), 0u);
  for (const P& p : kept(5, 5, -3)) {
    EXPECT_GE(p.at.z, 0);
    EXPECT_GT(p.at.w, 0.999999);
  }
}

TEST(SutherlandHodgman, CutsLieOnThePlaneAndNeighboursShareThem) {
  const auto planes = view_volume(1.0, 64.0);
  const P a{{0.1, 0.2, 0.3, 0.7}}, b{{3.3, 400, 5, 1.9}};
  int cuts = 0;
  for (const Plane<double>& plane : planes) {
    const Polygon one{a, b, {{-7, 1, 1, 2}}}, other{b, a, {{2, -9, 1, 3}}};
    Recorder<Tested<double>, Cut<double>, CornerKept<double>, Passed<double>> first, second;
    clip(std::span<const P>(one), plane, first);
    clip(std::span<const P>(other), plane, second);
    for (const auto& x : all<Cut<double>>(first)) {
      EXPECT_EQ(distance(plane, x.at), 0);
      EXPECT_GT(x.t, 0);
      EXPECT_LT(x.t, 1);
      for (const auto& y : all<Cut<double>>(second)) {
        if (x.inside != y.inside || x.outside != y.outside) continue;
        EXPECT_EQ(x.at, y.at);
        ++cuts;
      }
    }
  }
  EXPECT_GE(cuts, 2);
}

TEST(SutherlandHodgman, StepsFollowTheGrammar) {
  Recorder<Tested<double>, Cut<double>, CornerKept<double>, Passed<double>> seen;
  const Polygon polygon = flat({{-5, 2}, {5, 2}, {5, 8}});
  const Polygon kept = clip(polygon, Planes(window), seen);
  const Polygon plain = clip(polygon, Planes(window));
  ASSERT_EQ(kept.size(), plain.size());
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].at, plain[i].at);
  EXPECT_EQ(all<Passed<double>>(seen).size(), 4u);
  EXPECT_EQ(all<Passed<double>>(seen).back().corners, 4u);
  EXPECT_EQ(all<Cut<double>>(seen).size(), 2u);
  EXPECT_EQ(all<Tested<double>>(seen).size(), 3u + 4u + 4u + 4u);
  std::size_t expected = 0;
  for (const auto& event : seen.events()) {
    if (const auto* tested = std::get_if<Tested<double>>(&event.step)) EXPECT_EQ(tested->corner, expected++);
    if (std::holds_alternative<Passed<double>>(event.step)) expected = 0;
  }
}

TEST(SutherlandHodgman, FloatsAndRefusals) {
  const std::vector<Point<float>> floats{{{-5, 2, 0, 1}}, {{5, 2, 0, 1}}, {{5, 8, 0, 1}}};
  EXPECT_EQ(clip(std::span<const Point<float>>(floats), Plane<float>{0, 1, 0}).size(), 4u);
  EXPECT_THROW(view_volume(0.5, 1.0), ContractViolation);
}

TEST(SutherlandHodgman, TakesCornersAsProgramsHaveThem) {
  const Polygon corners = flat({{-5, 2}, {5, 2}, {5, 8}});
  EXPECT_EQ(clip(corners, window).size(), 4u);
  EXPECT_EQ(clip(corners, window[0]).size(), 4u);
  EXPECT_TRUE(clip(corners, view_volume(1.0, 1.0)).empty());
}

}  // namespace
}  // namespace gradus::sutherland_hodgman
