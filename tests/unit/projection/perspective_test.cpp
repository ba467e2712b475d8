// Goldens of the projection, its laws in exact arithmetic, refusals.

#include "projection/perspective/perspective.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/exact_scalar.hpp"
#include "core/record.hpp"

namespace gradus::perspective {
namespace {

/// Both angles given: 90 degrees across, 60 upright, near 1, far 100 (G004-04 to G004-11).
Projection<double> golden() {
  return projection_of(1.0, 1 / gradus::tan(radians_from_degrees(30)), 1.0, 100.0);
}

dvec3 ndc(dvec3 view) { return divide(transform(golden(), view)); }

TEST(Perspective, Goldens) {
  EXPECT_EQ(ndc({0, 0, 1}), (dvec3{0, 0, 0}));
  EXPECT_NEAR(ndc({0, 0, 2}).z, 50.0 / 99, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 10}).z, 0.9090909090909091, 1e-15);
  EXPECT_NEAR(ndc({0, 0, 100}).z, 1, 1e-15);
  EXPECT_NEAR(ndc({10, 0, 10}).x, 1, 1e-15);
  EXPECT_NEAR(glm::distance(ndc({2, 1, 4}), dvec3{0.5, 0.4330127018922193, 0.7575757575757576}), 0, 1e-15);
}

TEST(Perspective, MultipliesWhatMayNotBeDivided) {
  // G004-10, G004-11: behind the eye w is negative, before the near plane z is
  const glm::dvec4 behind = transform(golden(), dvec3{1, 1, -1});
  EXPECT_EQ(behind.w, -1);
  EXPECT_THROW(divide(behind), ContractViolation);
  EXPECT_THROW(divide(glm::dvec4{1, 1, 1, 0}), ContractViolation);
  EXPECT_THROW(divide(glm::dvec4{1, 1, 1, std::numeric_limits<double>::quiet_NaN()}), ContractViolation);
  EXPECT_LT(transform(golden(), dvec3{1, 1, 0.5}).z, 0);
}

TEST(Perspective, TheLensSaysTheSame) {
  Lens lens;
  lens.vertical_radians = radians_from_degrees(60);
  lens.near = 1;
  lens.far = 100;
  const Projection<double> p = projection_of(lens, 4.0 / 3);
  EXPECT_DOUBLE_EQ(p.y_scale, golden().y_scale);
  EXPECT_DOUBLE_EQ(p.x_scale, p.y_scale * 3 / 4);
  const glm::dvec4 by_matrix = projection_matrix(p) * glm::dvec4{2, 1, 4, 1};
  EXPECT_EQ(by_matrix, transform(p, dvec3{2, 1, 4}));
  for (const double near : {0.0, -1.0, 100.0, 200.0, std::numeric_limits<double>::quiet_NaN()}) {
    Lens wrong = lens;
    wrong.near = near;
    EXPECT_THROW(projection_of(wrong, 1), ContractViolation) << near;
  }
  for (const double angle : {0.0, 3.15, -1.0}) {
    Lens wrong = lens;
    wrong.vertical_radians = angle;
    EXPECT_THROW(projection_of(wrong, 1), ContractViolation) << angle;
  }
  EXPECT_THROW(projection_of(lens, 0), ContractViolation);
}

TEST(Perspective, LinesStayLines) {
  // E001-38: with z' = z the line from (0,0,1) to (2,0,3) bends; the middle in the picture is not where depth
  // says
  const ExactScope scope;
  const auto p = projection_of(Exact(1), Exact(1), Exact(1, 2), Exact(50));
  const auto at = [&](int x, int z) { return divide(transform(p, ExactVec3{Exact(x), Exact(0), Exact(z)})); };
  const ExactVec3 a = at(0, 1), m = at(1, 2), b = at(2, 3);
  EXPECT_EQ((m.z - a.z) * (b.x - a.x), (b.z - a.z) * (m.x - a.x));
  // and depth is a function of 1/z
  EXPECT_EQ(m.z, Exact(50) / (Exact(50) - Exact(1, 2)) * (Exact(1) - Exact(1, 2) / Exact(2)));
}

TEST(Perspective, DepthsThatTwentyFourBitsCannotTellApart) {
  // G001-79: near 1, far 1e6
  const auto p = projection_of(1.0, 1.0, 1.0, 1e6);
  const auto code = [&](double z) { return std::lround(divide(transform(p, dvec3{0, 0, z})).z * 0xffffff); };
  EXPECT_EQ(code(1000), 16760455);
  EXPECT_EQ(code(1000.05), 16760455);
  EXPECT_EQ(code(1000.07), 16760456);
  EXPECT_EQ(code(500000), code(500100));
  EXPECT_LT(divide(transform(p, dvec3{0, 0, 900000})).z,
            divide(transform(p, dvec3{0, 0, 900000.01})).z);  // double can
}

TEST(Perspective, StepsAndScalars) {
  Recorder<Multiplied<double>, Divided<double>> seen;
  const glm::dvec4 clip = transform(golden(), dvec3{2, 1, 4}, seen);
  EXPECT_EQ(divide(clip, seen), ndc({2, 1, 4}));
  ASSERT_EQ(seen.events().size(), 2u);
  EXPECT_EQ(std::get<Multiplied<double>>(seen.events()[0].step).clip, clip);
  const glm::vec3 f = divide(transform(projection_of(1.0f, 1.0f, 1.0f, 100.0f), glm::vec3{2, 1, 4}));
  EXPECT_NEAR(f.z, 0.75757575f, 1e-6f);
}

}  // namespace
}  // namespace gradus::perspective
