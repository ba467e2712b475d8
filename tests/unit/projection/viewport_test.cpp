// Corners, goldens, scalars, refusals.

#include "projection/viewport/viewport.hpp"

#include <gtest/gtest.h>

#include "core/exact_scalar.hpp"
#include "core/geometry.hpp"
#include "core/record.hpp"

namespace gradus::viewport {
namespace {

TEST(Viewport, CornersAndMiddle) {
  EXPECT_EQ(to_pixel(dvec2{-1, 1}, 640, 480), (dvec2{0, 0}));
  EXPECT_EQ(to_pixel(dvec2{1, -1}, 640, 480), (dvec2{640, 480}));
  EXPECT_EQ(to_pixel(dvec2{0, 0}, 641, 481), (dvec2{320.5, 240.5}));
}

TEST(Viewport, RowZeroIsTheTop) {
  // G000-11: a plane of 2 x 1.5; (0.5, 0.3) is in row 144
  EXPECT_NEAR(glm::distance(to_pixel(dvec2{0.5, 0.3 / 0.75}, 640, 480), dvec2{480, 144}), 0, 1e-13);
  const dvec2 p = to_pixel(dvec2{-0.5, -0.2 / 0.75}, 640, 480);
  EXPECT_DOUBLE_EQ(p.x, 160);
  EXPECT_DOUBLE_EQ(p.y, 304);
  // G000-12: nothing is moved to the border
  EXPECT_EQ(to_pixel(dvec2{5, 0}, 640, 480), (dvec2{1920, 240}));
}

TEST(Viewport, StepsScalarsAndMistakes) {
  Recorder<Mapped<double>> seen;
  EXPECT_EQ(to_pixel(dvec2{0.25, 0.5}, 8, 4, seen), (dvec2{5, 1}));
  ASSERT_EQ(seen.seen(), 1u);
  EXPECT_EQ(all<Mapped<double>>(seen)[0].pixel, (dvec2{5, 1}));
  EXPECT_EQ(to_pixel(glm::vec2{0.25f, 0.5f}, 8, 4), (glm::vec2{5, 1}));
  const ExactScope scope;
  EXPECT_EQ(to_pixel(ExactVec2{Exact(1, 3), Exact(1, 7)}, 3, 7), (ExactVec2{Exact(2), Exact(3)}));
  EXPECT_THROW(to_pixel(dvec2{0, 0}, 0, 4), ContractViolation);
}

}  // namespace
}  // namespace gradus::viewport
