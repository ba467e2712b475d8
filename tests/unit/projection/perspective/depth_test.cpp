// Depth: the frustum and its box, what the notes make of it, and how it is stored.

#include "projection/perspective/perspective.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/record.hpp"
#include "projection/perspective/perspective_notes.hpp"
#include "support/golden_projection.hpp"

namespace gradus::perspective {
namespace {

TEST(PerspectiveFrustum, CornersGoToTheCornersOfTheBox) {
  // R004-009, R004-010: with the angles 90 and 60 degrees, near 1, far 100
  const double h = 1, v = gradus::tan(radians_from_degrees(30));
  for (const double z : {1.0, 100.0}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        const dvec3 corner = ndc({x * h * z, y * v * z, z});
        EXPECT_NEAR(glm::distance(corner, dvec3{x, y, z == 1 ? 0 : 1}), 0, 1e-15);
      }
    }
  }
  // R004-012 to R004-014
  EXPECT_LT(ndc({0, 0, 2}).z, ndc({0, 0, 3}).z);
  EXPECT_LT(ndc({0, 0, 0.99}).z, 0);
  EXPECT_GT(ndc({0, 0, 101}).z, 1);
  EXPECT_NEAR(ndc({1, 1, 5}).x, 2 * ndc({1, 1, 10}).x, 1e-16);
}

TEST(PerspectiveFrustum, EightCornersFromBothAnglesOfView) {
  // R004-009, G001-94: angles of 90 and 60 degrees, near 1, far 100: A = tan 45, B = tan 30, times the depth
  const double across = gradus::tan(radians_from_degrees(45)), up = gradus::tan(radians_from_degrees(30));
  Recorder<CornerFound<double>> seen;
  const auto corners = frustum_corners(across, up, 1.0, 100.0, seen);
  EXPECT_NEAR(across, 1, 1e-15);
  EXPECT_NEAR(up, 0.5773502691896257, 1e-15);
  ASSERT_EQ(seen.events().size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    const double z = i < 4 ? 1 : 100, x = i % 2 == 0 ? -z : z, y = i % 4 < 2 ? -z * up : z * up;
    EXPECT_NEAR(glm::distance(corners[i], dvec3{x, y, z}), 0, 1e-13) << i;
    const auto& step = std::get<CornerFound<double>>(seen.events()[i].step);
    EXPECT_EQ(step.number, static_cast<int>(i));
    EXPECT_EQ(step.corner, corners[i]);
    EXPECT_EQ(dvec2(step.width, step.height), glm::abs(dvec2(corners[i])));
    // The frustum becomes a cuboid
    const dvec3 image = *divide_tested(projection_of(1 / across, 1 / up, 1.0, 100.0), corners[i]);
    const dvec3 box{i % 2 == 0 ? -1 : 1, i % 4 < 2 ? -1 : 1, i < 4 ? 0 : 1};
    EXPECT_NEAR(glm::distance(image, box), 0, 1e-14) << i;
  }
  EXPECT_EQ(frustum_corners(across, up, 1.0, 100.0), corners);  // observed == unobserved
  EXPECT_THROW(frustum_corners(1.0, 1.0, 2.0, 2.0), ContractViolation);
  EXPECT_THROW(frustum_corners(1.0, 1.0, 0.0, 2.0), ContractViolation);
  EXPECT_THROW(frustum_corners(0.0, 1.0, 1.0, 2.0), ContractViolation);
}

TEST(PerspectiveFrustum, WhatTheNotesCallNearIsNear) {
  // E004-02: z = n gives 0 and z = f gives 1; E004-05: tan(a)^-1 is the reciprocal of a tangent, no arc
  // tangent
  EXPECT_EQ(ndc({0, 0, 1}).z, 0);
  EXPECT_NEAR(ndc({0, 0, 100}).z, 1, 1e-15);
  EXPECT_NEAR(golden().y_scale, std::sqrt(3.0), 1e-15);
  EXPECT_GT(std::abs(golden().y_scale - gradus::atan(0.5)), 1);
  // E004-03: one lens, 16:9: the angles across and upright are tied by the picture's sides
  Lens lens;
  lens.vertical_radians = radians_from_degrees(60);
  const Projection<double> wide = projection_of(lens, 16.0 / 9);
  EXPECT_NEAR(wide.y_scale / wide.x_scale, 16.0 / 9, 1e-15);
  // E004-04: degenerate planes; as a lens: Perspective.TheLensSaysTheSame
  for (const auto& [near, far] : {std::pair{0.0, 100.0}, {1.0, 1.0}, {2.0, 1.0}, {1.0, infinity}}) {
    EXPECT_THROW(depth_of(DepthCurve::inverse, near, far, 1.0), ContractViolation);
    EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, near, far, 1.0),
                 ContractViolation);
  }
}

TEST(PerspectiveNotes, KeepingZBendsLines) {
  // G001-89, E001-38
  const dvec3 a = *keep_z(1.0, dvec3{0, 0, 1}), m = *keep_z(1.0, dvec3{1, 0, 2}),
              b = *keep_z(1.0, dvec3{2, 0, 3});
  EXPECT_EQ(a, (dvec3{0, 0, 1}));
  EXPECT_NEAR(b.x, 2.0 / 3, 1e-15);
  EXPECT_EQ(b.z, 3);
  EXPECT_EQ(m, (dvec3{0.5, 0, 2}));
  EXPECT_NEAR(interpolated_depth(a, b, m.x), 2.5, 1e-12);
  // With interpolation a wall at 2.2 hides the line's middle, though the line is nearer
  EXPECT_LT(m.z, 2.2);
  EXPECT_GT(interpolated_depth(a, b, m.x), 2.2);
  // Right: the same with a + b / z
  const auto p = projection_of(1.0, 1.0, 0.5, 50.0);
  const auto at = [&](dvec3 v) { return divide(transform(p, v)); };
  const double right = interpolated_depth(at({0, 0, 1}), at({2, 0, 3}), at({1, 0, 2}).x);
  EXPECT_NEAR(right, at({1, 0, 2}).z, 1e-15);
  EXPECT_LT(right, at({0, 0, 2.2}).z);
}

TEST(PerspectiveNotes, HowFarDepthIsOff) {
  // Half-way (z1 - z0)^2 / (2 (z0 + z1)), at worst (sqrt z1 - sqrt z0)^2
  const dvec3 a = *keep_z(1.0, dvec3{0, 0, 1}), b = *keep_z(1.0, dvec3{2, 0, 3});
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double z = 1 + 2 * i / 1000.0;
    const dvec3 m = *keep_z(1.0, dvec3{z - 1, 0, z});
    worst = std::max(worst, interpolated_depth(a, b, m.x) - m.z);
  }
  EXPECT_NEAR(worst, std::pow(std::sqrt(3.0) - 1, 2), 1e-6);
  const dvec3 middle = *keep_z(1.0, dvec3{0.5, 0, 1.5});
  EXPECT_NEAR(middle.x, b.x / 2, 1e-16);
  EXPECT_NEAR(interpolated_depth(a, b, middle.x) - middle.z, 0.5, 1e-15);
}

// E000-07, E001-22, E004-04: what the division makes of points behind the eye
TEST(PerspectiveNotes, WhatLiesBehindTheEyeIsMirrored) {
  const auto straight = projection_of(1.0, 1.0, 1.0, 100.0);
  EXPECT_EQ(dvec2(divide_untested(straight, dvec3{1, 1, -1})), (dvec2{-1, -1}));
  EXPECT_EQ(divide_untested(straight, dvec3{1, 0, 2}).x, 0.5);
  EXPECT_EQ(divide_untested(straight, dvec3{1, 0, -2}).x, -0.5);
  // 90 degrees across, 60 upright
  const dvec3 mirrored = divide_untested(golden(), dvec3{1, 1, -1});
  EXPECT_NEAR(glm::distance(mirrored, dvec3{-1, -std::sqrt(3.0), 200.0 / 99}), 0, 1e-15);
  EXPECT_TRUE(std::isinf(divide_untested(straight, dvec3{1, 1, 0}).x));
  EXPECT_TRUE(std::isnan(divide_untested(straight, dvec3{0, 1, 0}).x));
  for (const double z : {-1.0, -2.0, 0.0, -0.0, -infinity, not_a_number}) {
    EXPECT_EQ(divide_tested(straight, dvec3{1, 1, z}), std::nullopt) << z;
  }
  // Of the segment (1,0,2)-(1,0,-2) the part in front of the eye runs from 0.5 to infinity
  double last = 0;
  for (double z = 2; z > 1e-300; z /= 16) {
    const double x = divide_tested(straight, dvec3{1, 0, z})->x;
    EXPECT_EQ(x, 1 / z);
    EXPECT_GT(x, last);
    last = x;
  }
  EXPECT_GT(last, 1e299);
}

// E004-04: the matrix alone refuses no planes and no angle
TEST(PerspectiveNotes, AnyPlanesAndAngles) {
  for (const double z : {0.5, 1.0, 7.0, 100.0}) {
    EXPECT_EQ(divide_untested(projection_of(1.0, 1.0, 0.0, 100.0), dvec3{0, 0, z}).z, 1) << z;
    EXPECT_FALSE(std::isfinite(divide_untested(projection_of(1.0, 1.0, 2.0, 2.0), dvec3{0, 0, z}).z)) << z;
  }
  // 180 degrees: half of it has no tangent, in doubles a huge one, and everything lands in the middle
  const double cotangent = 1 / std::tan(radians_from_degrees(90.0));
  EXPECT_LT(cotangent, 1e-15);
  EXPECT_LT(divide_untested(projection_of(cotangent, cotangent, 1.0, 100.0), dvec3{1000, 0, 1}).x, 1e-12);
}

// E002-03, E002-04, E002-05: G002-04 to G002-06
TEST(PerspectiveNotes, ZoomMinusZ) {
  const WireScreen<double> screen{{400, 300}, 500, 1000};
  const auto x = [&](double z) { return zoom_minus_z(screen, dvec3{600, 300, z}).x; };
  // The larger z, the larger
  EXPECT_EQ(x(-1000), 450);
  EXPECT_EQ(x(500), 600);
  EXPECT_EQ(x(900), 1400);
  // A plane tears at z = 0
  EXPECT_EQ(x(0), 600);
  EXPECT_NEAR(x(1e-9), 500, 1e-9);
  EXPECT_NEAR(x(-1e-9), 500, 1e-9);
  // And flies apart at z = zoom
  EXPECT_EQ(x(999), 100400);
  EXPECT_EQ(x(1001), -99600);
  EXPECT_TRUE(std::isinf(x(1000)));
  EXPECT_EQ(x(2000), 300);  // mirrored
  EXPECT_EQ(zoom_minus_z(screen, dvec3{400, 400, 500}), (dvec2{400, 400}));
  // zoom + z: the larger z, the smaller, without a jump
  double last = infinity;
  for (const double z : {-999.0, -500.0, -1e-9, 0.0, 1e-9, 500.0, 900.0, 999.0, 1000.0, 1001.0, 2000.0}) {
    const dvec3 image = *divide_tested(projection_of(500.0, 500.0, 1.0, 1e6), dvec3{200, 0, 1000 + z});
    EXPECT_LT(image.x, last) << z;
    EXPECT_NEAR(image.x, 100000 / (1000 + z), 1e-9) << z;
    last = image.x;
  }
}

// E001-21: G001-41, G001-42
TEST(PerspectiveNotes, TheRuleOfThePlaneIsTooWide) {
  const double r = std::sqrt(0.5);
  const glm::dmat4 seen =
      matrix_onto(1.0) * view_matrix(Frame<double>{{0, 0, 0}, {r, 0, -r}, {0, 1, 0}, {r, 0, r}});
  for (const dvec3 direction : {dvec3{1, 0, 0}, {0, 0, 1}, {1, 0, 1}}) {
    EXPECT_EQ(parallel_by_plane(seen, direction), std::nullopt);
    EXPECT_NE(vanishing_point(seen, direction), std::nullopt);
  }
  EXPECT_NEAR(glm::length(*vanishing_point(seen, dvec3{1, 0, 1})), 0, 1e-12);
  // It is right along the picture plane, for the y-axis, and for all that leaves the plane
  for (const dvec3 direction : {dvec3{1, 0, -1}, {0, 1, 0}, {1, 1, 0}, {1, -2, 3}}) {
    EXPECT_EQ(parallel_by_plane(seen, direction), vanishing_point(seen, direction));
  }
  EXPECT_THROW(parallel_by_plane(seen, dvec3{0}), ContractViolation);
}

TEST(PerspectiveNotes, Steps) {
  const auto lens = projection_of(1.0, 1.0, 1.0, 100.0);
  Recorder<Multiplied<double>, Divided<double>, LeftUndivided<double>> tested;
  EXPECT_EQ(divide_tested(lens, dvec3{2, 1, 4}, tested), divide_tested(lens, dvec3{2, 1, 4}));
  EXPECT_EQ(divide_tested(lens, dvec3{2, 1, -4}, tested), std::nullopt);
  ASSERT_EQ(tested.events().size(), 4u);
  EXPECT_EQ(std::get<Divided<double>>(tested.events()[1].step).ndc.x, 0.5);
  EXPECT_EQ(std::get<LeftUndivided<double>>(tested.events()[3].step).clip.w, -4);
  Recorder<Multiplied<double>, Divided<double>> untested;
  EXPECT_EQ(divide_untested(lens, dvec3{2, 1, -4}, untested), divide_untested(lens, dvec3{2, 1, -4}));
  ASSERT_EQ(untested.events().size(), 2u);
  EXPECT_EQ(std::get<Divided<double>>(untested.events()[1].step).clip.w, -4);
  const WireScreen<double> screen{{400, 300}, 500, 1000};
  Recorder<LeftAlone<double>, Divided<double>> wire;
  EXPECT_EQ(zoom_minus_z(screen, dvec3{600, 300, 500}, wire), zoom_minus_z(screen, dvec3{600, 300, 500}));
  zoom_minus_z(screen, dvec3{600, 300, 0}, wire);
  ASSERT_EQ(wire.events().size(), 2u);
  EXPECT_EQ(std::get<Divided<double>>(wire.events()[0].step).clip.w, 500);
  EXPECT_EQ(std::get<LeftAlone<double>>(wire.events()[1].step).node.x, 600);
  Recorder<TakenToInfinity<double>, Vanished<double>, StaysParallel<double>> rule;
  parallel_by_plane(matrix_onto(1.0), dvec3{1, 0, 1}, rule);
  parallel_by_plane(matrix_onto(1.0), dvec3{1, 1, 1}, rule);
  ASSERT_EQ(rule.events().size(), 3u);
  EXPECT_EQ(std::get<StaysParallel<double>>(rule.events()[0].step).direction, (dvec3{1, 0, 1}));
  EXPECT_EQ(std::get<Vanished<double>>(rule.events()[2].step).point, (dvec2{1, 1}));
  EXPECT_EQ(divide_tested(projection_of(1.0f, 1.0f, 1.0f, 100.0f), glm::vec3{2, 1, 4})->x, 0.5f);
}

TEST(StoredDepth, CurvesRunBetweenNearAndFar) {
  for (const auto& [curve, at_near, at_far] : {std::tuple{DepthCurve::linear, 0.0, 1.0},
                                               {DepthCurve::inverse, 0.0, 1.0},
                                               {DepthCurve::reversed, 1.0, 0.0}}) {
    EXPECT_EQ(depth_of(curve, 1.0, 1e6, 1.0), at_near);
    EXPECT_EQ(depth_of(curve, 1.0, 1e6, 1e6), at_far);
  }
}

TEST(StoredDepth, TheSmallestStepGrowsWithTheSquareOfTheDistance) {
  // n = 1, f = 1e6, 24 bits
  const auto step = [](double z) {
    return separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, z);
  };
  EXPECT_NEAR(step(100), 6e-4, 0.1e-4);
  EXPECT_NEAR(step(1000), 0.0596, 0.00005);
  EXPECT_NEAR(step(1e5), 596, 0.5);
  EXPECT_NEAR(step(1e6), 59604.58872345619, 1e-6);  // G001-79
  // Linear 24 bits: the same everywhere; reversed 24 bits: as the inverse curve
  for (const double z : {1.0, 1000.0, 1e6}) {
    EXPECT_NEAR(separable_step(DepthCurve::linear, DepthFormat::fixed24, 1, 1e6, z), 999999.0 / 0xffffff,
                1e-12);
    EXPECT_EQ(separable_step(DepthCurve::reversed, DepthFormat::fixed24, 1, 1e6, z), step(z));
  }
  // Reversed floats: about 2^-23 z at most, at any distance up to where far itself is near
  for (double z = 1; z < 1e5; z *= 3) {
    EXPECT_LT(separable_step(DepthCurve::reversed, DepthFormat::float32, 1, 1e6, z), z * 0x1p-23 * 1.2) << z;
  }
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, 0.5), ContractViolation);
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, 2e6), ContractViolation);
  EXPECT_THROW(separable_step(DepthCurve::inverse, DepthFormat::fixed24, 1, 1e6, not_a_number),
               ContractViolation);
}

TEST(StoredDepth, WhatFloatsTellApart) {
  const auto bits = [](DepthCurve curve, double z) {
    return stored(DepthFormat::float32, depth_of(curve, 1.0, 1e6, z));
  };
  EXPECT_EQ(bits(DepthCurve::inverse, 999'000), std::bit_cast<std::uint32_t>(1.0f));
  EXPECT_EQ(bits(DepthCurve::inverse, 999'900), std::bit_cast<std::uint32_t>(1.0f));
  EXPECT_NE(bits(DepthCurve::reversed, 999'000), bits(DepthCurve::reversed, 999'900));
  EXPECT_NE(bits(DepthCurve::reversed, 500'000), bits(DepthCurve::reversed, 500'000.01));
  // … of which the last is luck: there a step is 0.028
  EXPECT_NEAR(separable_step(DepthCurve::reversed, DepthFormat::float32, 1, 1e6, 500'000), 0.0284217, 1e-7);
  EXPECT_EQ(bits(DepthCurve::reversed, 500'000), bits(DepthCurve::reversed, 499'999.99));
}

TEST(StoredDepth, Spacing) {
  EXPECT_EQ(spacing(DepthFormat::float32, 1), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.75), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.5), 0x1p-24);
  EXPECT_EQ(spacing(DepthFormat::float32, 0.49), 0x1p-25);
  EXPECT_EQ(spacing(DepthFormat::float32, 0), 0x1p-149);
  EXPECT_EQ(spacing(DepthFormat::fixed24, 0.3), 1.0 / 16777215);
  EXPECT_EQ(stored(DepthFormat::fixed24, 1), 16777215u);
  Recorder<Resolved> seen;
  EXPECT_EQ(separable_step(DepthCurve::linear, DepthFormat::fixed24, 1, 3, 2, seen), 2.0 / 16777215);
  ASSERT_EQ(seen.events().size(), 1u);
  const Resolved& r = std::get<Resolved>(seen.events()[0].step);
  EXPECT_EQ(r.depth, 0.5);
  EXPECT_EQ(r.slope, 0.5);
  EXPECT_EQ(r.step, 2.0 / 16777215);
}

}  // namespace
}  // namespace gradus::perspective
